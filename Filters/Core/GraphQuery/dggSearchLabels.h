// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Working labels of a search. Internal.
#ifndef dggSearchLabels_h
#define dggSearchLabels_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphSearch.h"   // for GraphSeed
#include "dggLargePages.h"    // for AssignInLargePages

#include <algorithm> // for std::for_each, std::min
#include <cmath>     // for std::nextafter
#include <cstddef>   // for std::size_t
#include <vector>    // for the labels

namespace dgg
{
/// Origin of a vertex label.
struct LabelOrigin
{
  Offset Edge = -1;          ///< from the tail; -1 for a seed
  Id Tail = NoId;            ///< for a seed, the index of the seed
  float ArrivalAngle = -1.0; ///< polar angle pointing back; negative if undefined

  bool IsSeed() const { return this->Edge < 0; }
};

/// Returns true if visiting the listed vertices is cheaper than visiting all vertices in order.
inline bool AreFew(const std::vector<Id>& vertices, std::size_t numberOfVertices)
{
  return vertices.size() < numberOfVertices / 8;
}

/// Sets all entries of an array to the initial value. `touched` lists the entries that differ from
/// the initial value, unless the size of the array changes.
template <typename Value>
void ResetTouched(std::vector<Value>& values, std::size_t numberOfVertices,
  const std::vector<Id>& touched, const Value& initial)
{
  if (values.size() != numberOfVertices || !AreFew(touched, numberOfVertices))
  {
    AssignInLargePages(values, numberOfVertices, initial);
    return;
  }
  for (const Id v : touched)
  {
    values[v] = initial;
  }
}

/// Calls `use(v)` for the touched vertices if they are few, otherwise for all vertices in order.
template <typename Use>
void ForEachTouched(const std::vector<Id>& touched, std::size_t numberOfVertices, const Use& use)
{
  if (AreFew(touched, numberOfVertices))
  {
    std::for_each(touched.begin(), touched.end(), use);
    return;
  }
  for (std::size_t v = 0; v < numberOfVertices; ++v)
  {
    use(static_cast<Id>(v));
  }
}

/// Distance and origin of every vertex. Vertices without a label have the distance Infinity and an
/// undefined origin.
struct SearchLabels
{
  std::vector<double>& Distances;
  std::vector<LabelOrigin>& Origins;
  /// Vertices that have received a label since Start(), each once. The next Start() resets only
  /// these vertices.
  std::vector<Id>& Touched;
  double Limit; ///< smallest number above the radius of the search
  /// Ids that decide between paths of equal length. Null: the vertices.
  const Offset* Ids = nullptr;
  /// Targets. The search may stop when the labels of these vertices are final, and leave all
  /// farther vertices unreached. Null: all vertices are searched.
  const std::vector<Id>* Targets = nullptr;

  SearchLabels(std::vector<double>& distances, std::vector<LabelOrigin>& origins,
    std::vector<Id>& touched, double radius)
    : Distances(distances)
    , Origins(origins)
    , Touched(touched)
    , Limit(std::nextafter(radius, Infinity))
  {
  }

  bool IsReached(Id v) const { return this->Distances[v] < this->Limit; }

  /// Removes all labels and enters the seeds; each vertex keeps its nearest seed. Returns the
  /// number of labels that were removed.
  std::size_t Start(Id numberOfVertices, const std::vector<GraphSeed>& seeds)
  {
    const auto n = static_cast<std::size_t>(numberOfVertices);
    const bool isLocal = this->Distances.size() == n && AreFew(this->Touched, n);
    const std::size_t removed = isLocal ? this->Touched.size() : n;
    ResetTouched(this->Distances, n, this->Touched, Infinity);
    if (this->Origins.size() != n)
    {
      AssignInLargePages(this->Origins, n, LabelOrigin());
    }
    this->Touched.clear();
    this->Touched.reserve(n);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      this->Lower(seeds[i], i);
    }
    return removed;
  }

  /// Stores the distance of a vertex. The distance must be lower than the present one.
  void SetDistance(Id v, double distance)
  {
    if (this->Distances[v] == Infinity)
    {
      this->Touched.push_back(v);
    }
    this->Distances[v] = distance;
  }

  /// Returns true if a path of the length of the label of v, over this tail, replaces the present
  /// path. Among equally long paths to a vertex, a seed comes first, then the path with the
  /// smallest tail. The tree then depends neither on the order of a search from seeds nor on its
  /// method.
  bool IsPreferred(Id v, Id tail) const
  {
    const LabelOrigin& present = this->Origins[v];
    return !present.IsSeed() && this->Distances[tail] < this->Distances[v] &&
      (this->Ids ? this->Ids[tail] < this->Ids[present.Tail] : tail < present.Tail);
  }

  /// Enters the i-th seed. Returns false if the label of the vertex is not lowered.
  bool Lower(const GraphSeed& seed, std::size_t i)
  {
    if (!(seed.Distance < std::min(this->Distances[seed.Vertex], this->Limit)))
    {
      return false;
    }
    this->SetDistance(seed.Vertex, seed.Distance);
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

/// Work of a search.
struct SearchEffort
{
  std::size_t Pops = 0;
  std::size_t Relaxations = 0;
  std::size_t Labels = 0; ///< initialized or given to a vertex for the first time
};

/// Calls `use` with the lengths of the graph, float or double.
template <typename Use>
auto WithLengths(const GraphView& graph, Use&& use)
{
  return graph.Lengths ? use(graph.Lengths) : use(graph.WideLengths);
}
}

#endif
