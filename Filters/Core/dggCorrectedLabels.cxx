// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCorrectedLabels.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
class Straightener
{
public:
  Straightener(const GraphView& graph, const SurfaceMesh& mesh, const std::vector<GraphSeed>& seeds,
    SearchResult& result)
    : Graph(graph)
    , Mesh(mesh)
    , Seeds(seeds)
    , Result(result)
    , Shrink(graph.Info.IsGuaranteed() ? 1.0 / (1.0 + graph.Info.Accuracy) : 0.0)
  {
    const auto n = static_cast<std::size_t>(graph.NumberOfVertices);
    for (std::vector<double>* values :
      { &result.Corrected, &result.VirtualOffset, &result.VirtualLength })
    {
      values->assign(n, Infinity);
    }
    result.VirtualAngle.assign(n, 0.0);
    for (const GraphSeed& seed : seeds)
    {
      this->SmallestOffset = std::min(this->SmallestOffset, OffsetOf(seed));
    }
  }

  void Visit(Id v)
  {
    if (this->Result.Edges[v] < 0)
    {
      this->StartAt(v, this->Seeds[this->Result.Seeds[v]]);
      return;
    }
    this->StepTo(v);
  }

private:
  static double OffsetOf(const GraphSeed& seed)
  {
    return seed.ArrivalAngle < 0.0 ? seed.Distance : seed.InitialDistance;
  }

  void StartAt(Id v, const GraphSeed& seed)
  {
    this->Result.Corrected[v] = seed.Distance;
    this->Result.VirtualOffset[v] = OffsetOf(seed);
    this->Result.VirtualLength[v] = seed.Distance - OffsetOf(seed);
    this->Result.VirtualAngle[v] = std::max(0.0, seed.ArrivalAngle);
  }

  /// From the tail of the edge through which a vertex was reached to the vertex.
  void StepTo(Id v)
  {
    const Offset edge = this->Result.Edges[v];
    const Id u = this->Result.Tails[v];
    const double lever = this->Result.VirtualLength[u];
    const double hop = this->Graph.Length(edge);
    const double arrival = this->Graph.ArrivalAngles[edge];
    if (!(lever > 0.0) || this->Mesh.Kind(u) == VertexKind::Irregular)
    {
      this->Restart(v, u, hop, arrival);
      return;
    }
    double turn = this->Graph.Angles[edge] - this->Result.VirtualAngle[u];
    if (this->Mesh.Kind(u) != VertexKind::Boundary)
    {
      const double total = this->Mesh.TotalAngle(u);
      turn -= total * std::round(turn / total); // the smaller side
    }
    if (std::abs(turn) >= Pi) // the path bends at the tail
    {
      this->Restart(v, u, hop, arrival);
      return;
    }
    // The virtual source as seen from v, whose x axis points back to the tail.
    const double x = hop - lever * std::cos(turn);
    const double y = lever * std::sin(turn);
    const double angle = arrival + std::atan2(y, x);
    if (this->Mesh.Kind(v) == VertexKind::Boundary &&
      !(angle >= 0.0 && angle <= this->Mesh.TotalAngle(v))) // the straight way leaves the surface
    {
      this->Restart(v, u, hop, arrival);
      return;
    }
    this->Set(v, this->Result.VirtualOffset[u], std::sqrt(x * x + y * y), angle);
  }

  /// The tail becomes the virtual source.
  void Restart(Id v, Id u, double hop, double arrival)
  {
    this->Set(v, this->Result.Corrected[u], hop, arrival);
  }

  void Set(Id v, double offset, double length, double angle)
  {
    this->Result.VirtualOffset[v] = offset;
    this->Result.VirtualLength[v] = length;
    this->Result.VirtualAngle[v] = angle;
    // The label certifies an interval, in which the estimate has to be whatever the curvature did
    // to it.
    const double label = this->Result.Distances[v];
    const double lowest = this->Shrink > 0.0
      ? this->SmallestOffset + (label - this->SmallestOffset) * this->Shrink
      : -Infinity;
    this->Result.Corrected[v] = std::min(std::max(offset + length, lowest), label);
  }

  const GraphView& Graph;
  const SurfaceMesh& Mesh;
  const std::vector<GraphSeed>& Seeds;
  SearchResult& Result;
  double Shrink;
  double SmallestOffset = Infinity;
};
}

void CorrectLabels(const GraphView& graph, const SurfaceMesh& mesh,
  const std::vector<GraphSeed>& seeds, const std::vector<Id>& order, SearchResult& result)
{
  Straightener straightener(graph, mesh, seeds, result);
  for (Id v : order)
  {
    straightener.Visit(v);
  }
}
}
