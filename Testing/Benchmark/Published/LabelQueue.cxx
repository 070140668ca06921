// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelQueue.h"

#include "dggGraphFans.h"

#include <algorithm>
#include <deque>

namespace
{
/// Relative tolerance: rounding affects even a mean of equal labels.
constexpr double Rounding = 1e-9;

/// Queue of vertices without duplicates, and the sum of their labels.
class LabelQueue
{
public:
  LabelQueue(QueueRule rule, LabelResult& result)
    : SmallFirst(rule == QueueRule::SmallLabelFirst || rule == QueueRule::SmallAndLarge)
    , LargeLast(rule == QueueRule::LargeLabelLast || rule == QueueRule::SmallAndLarge)
    , Result(result)
    , IsWaiting(result.Distances.size(), 0)
  {
  }

  bool IsEmpty() const { return this->Waiting.empty(); }

  /// Lowers a label and adds the vertex to the queue.
  void Lower(dgg::Id v, double label)
  {
    double& old = this->Result.Distances[v];
    if (this->IsWaiting[v])
    {
      this->Sum += label - old;
      old = label;
      return;
    }
    old = label;
    this->Sum += label;
    this->IsWaiting[v] = 1;
    const bool goesFirst = this->SmallFirst && !this->Waiting.empty() &&
      label <= this->Result.Distances[this->Waiting.front()];
    goesFirst ? this->Waiting.push_front(v) : this->Waiting.push_back(v);
  }

  dgg::Id Pop()
  {
    if (this->LargeLast)
    {
      // At most one rotation per vertex of the queue, because rounding errors may raise all labels
      // above the mean.
      const double mean = this->Sum / static_cast<double>(this->Waiting.size());
      for (std::size_t i = this->Waiting.size();
           i > 1 && this->Result.Distances[this->Waiting.front()] > mean * (1.0 + Rounding); --i)
      {
        this->Waiting.push_back(this->Waiting.front());
        this->Waiting.pop_front();
        ++this->Result.Rotations;
      }
    }
    const dgg::Id v = this->Waiting.front();
    this->Waiting.pop_front();
    this->IsWaiting[v] = 0;
    this->Sum -= this->Result.Distances[v];
    ++this->Result.Pops;
    return v;
  }

private:
  bool SmallFirst;
  bool LargeLast;
  LabelResult& Result;
  std::vector<char> IsWaiting;
  std::deque<dgg::Id> Waiting;
  double Sum = 0.0;
};

/// Returns, per vertex, the smallest angle between arrival and departure that fans of this
/// tolerance allow; 0 allows all edges.
std::vector<float> LeadsOf(const dgg::SurfaceMesh& mesh, double tolerance)
{
  std::vector<float> leads(static_cast<std::size_t>(mesh.GetNumberOfVertices()), 0.0f);
  for (dgg::Id v = 0; tolerance > 0.0 && v < mesh.GetNumberOfVertices(); ++v)
  {
    const dgg::VertexKind kind = mesh.Kind(v);
    if (kind != dgg::VertexKind::Irregular && kind != dgg::VertexKind::Isolated)
    {
      const double total = mesh.TotalAngle(v);
      const double straight =
        std::min(dgg::Pi, kind == dgg::VertexKind::Boundary ? total : 0.5 * total);
      leads[v] = static_cast<float>(std::max(0.0, straight - tolerance));
    }
  }
  return leads;
}
}

LabelResult SearchByLabels(const dgg::GraphView& graph, const dgg::SurfaceMesh& mesh,
  dgg::Id source, QueueRule rule, double fanTolerance)
{
  const dgg::GraphFans fans(graph, mesh);
  const std::vector<float> leads = LeadsOf(mesh, fanTolerance);
  LabelResult result;
  result.Distances.assign(static_cast<std::size_t>(graph.NumberOfVertices), dgg::Infinity);
  std::vector<float> arrivals(result.Distances.size(), -1.0f);
  LabelQueue queue(rule, result);
  queue.Lower(source, 0.0);
  while (!queue.IsEmpty())
  {
    const dgg::Id v = queue.Pop();
    const double label = result.Distances[v];
    fans.ForEachBeyond(v, arrivals[v], leads[v], [&](dgg::Offset e) {
      ++result.Relaxations;
      const dgg::Id target = graph.Targets[e];
      const double reached = label + graph.Length(e);
      if (reached < result.Distances[target])
      {
        arrivals[target] = graph.ArrivalAngles[e];
        queue.Lower(target, reached);
      }
    });
  }
  return result;
}
