// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DivisionReplay.h"

#include <vtkMath.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

double MeasureReach(const MeshArrays& mesh, const dgg::GeodesicGraph& graph)
{
  constexpr int directions = 16;
  std::vector<double> areas(mesh.GetNumberOfVertices(), 0.0);
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    const auto at = [&](std::size_t k) {
      return mesh.Points.data() + 3 * mesh.Triangles[corner / 3 * 3 + k];
    };
    areas[mesh.Triangles[corner]] += vtkTriangle::TriangleArea(at(0), at(1), at(2)) / 3.0;
  }
  double sum = 0.0;
  double spacing = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    std::array<double, directions> reach{};
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      for (int k = 0; k < directions; ++k)
      {
        const double angle = graph.Angles[e] - 2.0 * vtkMath::Pi() * k / directions;
        reach[k] = std::max(reach[k], graph.View().Length(e) * std::cos(angle));
      }
    }
    sum += std::accumulate(reach.begin(), reach.end(), 0.0) / directions;
    spacing += std::sqrt(areas[v]);
  }
  return sum / spacing;
}

DivisionReplay::DivisionReplay(const MeshArrays& mesh, const std::vector<int>& labels,
  const dgg::GeodesicGraph& graph, const std::vector<dgg::SearchResult>& results)
  : Layers(1 + static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())), 0.0)
  , Holders(mesh.GetNumberOfVertices())
{
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    this->Holders[mesh.Triangles[corner]].insert(labels[corner / 3]);
  }
  for (const std::set<int>& of : this->Holders)
  {
    const std::size_t id = this->Owners.size();
    this->Owners.push_back(
      of.empty() ? 0 : *std::next(of.begin(), static_cast<std::ptrdiff_t>(id % of.size())));
  }
  this->FindGhosts(graph);
  this->FindLayers(mesh, graph);
  for (const dgg::SearchResult& result : results)
  {
    this->AddRounds(result, static_cast<double>(results.size()));
  }
}

void DivisionReplay::FindGhosts(const dgg::GeodesicGraph& graph)
{
  for (std::size_t v = 0; v < this->Owners.size(); ++v)
  {
    std::set<int> readers;
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      readers.insert(this->Owners[graph.Targets[e]]);
    }
    this->Ghosts += static_cast<double>(std::count_if(readers.begin(), readers.end(),
      [&](int reader) { return this->Holders[v].count(reader) == 0; }));
  }
}

void DivisionReplay::FindLayers(const MeshArrays& mesh, const dgg::GeodesicGraph& graph)
{
  std::vector<std::vector<dgg::Id>> neighbors(this->Owners.size());
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
    neighbors[mesh.Triangles[corner]].push_back(mesh.Triangles[next]);
    neighbors[mesh.Triangles[next]].push_back(mesh.Triangles[corner]);
  }
  for (int piece = 0; piece < static_cast<int>(this->Layers.size()); ++piece)
  {
    std::vector<int> layers(this->Owners.size(), -1); // -1: not reached yet
    std::vector<dgg::Id> reached;
    for (std::size_t v = 0; v < this->Owners.size(); ++v)
    {
      if (this->Holders[v].count(piece) > 0)
      {
        layers[v] = 0;
        reached.push_back(static_cast<dgg::Id>(v));
      }
    }
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      for (const dgg::Id v : neighbors[reached[next]])
      {
        if (layers[v] < 0)
        {
          layers[v] = layers[reached[next]] + 1;
          reached.push_back(v);
        }
      }
    }
    this->Depth =
      std::max(this->Depth, static_cast<double>(*std::max_element(layers.begin(), layers.end())));
    for (std::size_t v = 0; v < this->Owners.size(); ++v)
    {
      for (dgg::Offset e = graph.Offsets[v]; this->Owners[v] == piece && e < graph.Offsets[v + 1];
           ++e)
      {
        const double layer = layers[graph.Targets[e]];
        this->Layers[piece] = std::max(this->Layers[piece], layer);
      }
    }
  }
}

/// Labels and arrivals are sent where a path passes from one process to another, unless the path
/// returns with the next edge, since both processes have this edge. All processes have the labels
/// of sources. Shared points need arrivals on all processes that have them.
void DivisionReplay::AddRounds(const dgg::SearchResult& result, double queries)
{
  std::vector<dgg::Id> order(result.Reached);
  std::sort(order.begin(), order.end(),
    [&](dgg::Id a, dgg::Id b) { return result.Distances[a] < result.Distances[b]; });
  std::vector<int> labels(this->Owners.size(), 0); // number of messages before
  std::vector<int> arrivals(this->Owners.size(), 0);
  int treeRounds = 0;
  for (const dgg::Id v : order)
  {
    const dgg::Id tail = result.Tails[v];
    if (tail == dgg::NoId)
    {
      continue;
    }
    const dgg::Id before = result.Tails[tail];
    const bool isSent = this->Owners[tail] != this->Owners[v];
    arrivals[v] = arrivals[tail] + (isSent ? 1 : 0);
    labels[v] = labels[tail] + (isSent && before != dgg::NoId ? 1 : 0);
    if (isSent && before != dgg::NoId && this->Owners[before] == this->Owners[v])
    {
      arrivals[v] = std::min(arrivals[v], arrivals[before]);
      labels[v] = std::min(labels[v], labels[before]);
    }
    for (const int holder : this->Holders[v])
    {
      const bool isFollowed = holder == this->Owners[v] || holder == this->Owners[tail];
      treeRounds = std::max(treeRounds, arrivals[v] + (isFollowed ? 0 : 1));
    }
  }
  this->LabelRounds += (2 + *std::max_element(labels.begin(), labels.end())) / queries;
  this->TreeRounds += (1 + treeRounds) / queries;
}
