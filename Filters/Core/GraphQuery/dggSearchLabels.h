// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The labels that a search works on. Internal.
#ifndef dggSearchLabels_h
#define dggSearchLabels_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphSearch.h"   // for GraphSeed

#include <cmath>   // for std::nextafter
#include <cstddef> // for std::size_t
#include <vector>  // for the labels

namespace dgg
{
/// How a vertex got its label.
struct LabelOrigin
{
  Offset Edge = -1;          ///< from the tail; -1 for a seed
  Id Tail = NoId;            ///< for a seed, the index of the seed
  float ArrivalAngle = -1.0; ///< polar angle pointing back; negative when there is none

  bool IsSeed() const { return this->Edge < 0; }
};

/// Distance and origin of every vertex. Unreached vertices have Limit, the smallest number above
/// the radius of the search: so "lower than the label" says "within the radius" too.
struct SearchLabels
{
  std::vector<double>& Distances;
  std::vector<LabelOrigin>& Origins;
  double Limit;

  SearchLabels(std::vector<double>& distances, std::vector<LabelOrigin>& origins, double radius)
    : Distances(distances)
    , Origins(origins)
    , Limit(std::nextafter(radius, Infinity))
  {
  }

  bool IsReached(Id v) const { return this->Distances[v] < this->Limit; }

  /// All vertices unreached but the seeds, of which each vertex keeps the nearest.
  void Start(Id numberOfVertices, const std::vector<GraphSeed>& seeds)
  {
    this->Distances.assign(numberOfVertices, this->Limit);
    this->Origins.resize(numberOfVertices);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      this->Lower(seeds[i], i);
    }
  }

  /// Enter a seed, the i-th; false when the vertex is no farther without it.
  bool Lower(const GraphSeed& seed, std::size_t i)
  {
    if (!(seed.Distance < this->Distances[seed.Vertex]))
    {
      return false;
    }
    this->Distances[seed.Vertex] = seed.Distance;
    this->Origins[seed.Vertex] = { -1, static_cast<Id>(i), static_cast<float>(seed.ArrivalAngle) };
    return true;
  }
};

/// A reached vertex and how it was reached.
struct TreeStep
{
  Offset Edge; ///< from the tail; -1 for a seed
  Id Vertex;
  Id Tail; ///< NoId for a seed
};

/// What a search did.
struct SearchEffort
{
  std::size_t Pops = 0;
  std::size_t Relaxations = 0;
};

/// Call `use` with the lengths of the graph, float or double.
template <typename Use>
auto WithLengths(const GraphView& graph, Use&& use)
{
  return graph.Lengths ? use(graph.Lengths) : use(graph.WideLengths);
}
}

#endif
