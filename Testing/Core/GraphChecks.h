// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of the graph builder share. Distances in a graph come from a plain Dijkstra of
/// their own, so that the tests of the builder do not depend on the kernel's searches.
#ifndef GraphChecks_h
#define GraphChecks_h

#include "TestMeshes.h"

#include "dggGraphBuilder.h"
#include "dggVirtualSources.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace dgg
{
/// Compares arrays of virtual sources in expectations.
inline bool operator==(const VirtualSource& a, const VirtualSource& b)
{
  return a.Offset == b.Offset && a.Length == b.Length && a.Angle == b.Angle;
}
}

namespace dggtest
{
/// One build. Throws std::runtime_error with the kernel's message when it refuses; a graph that is
/// not well formed fails the test. `change` may adjust the options.
dgg::GeodesicGraph BuildGraph(const dgg::SurfaceMesh& mesh, double accuracy,
  const std::function<void(dgg::GraphOptions&)>& change = nullptr,
  dgg::GraphStatistics* statistics = nullptr);
/// The same for any construction and without a callback.
dgg::GeodesicGraph BuildGraph(
  const dgg::SurfaceMesh& mesh, double accuracy, dgg::GraphConstruction construction);

std::vector<dgg::GraphConstruction> AllConstructions();

/// Threads that take ranges of a size of their own from a common counter; of the size that the
/// kernel asks for when it is 0.
dgg::ParallelFor WithThreads(int count, dgg::Offset size = 0);

/// Distances of all vertices from some that start with distances of their own.
std::vector<double> GraphDistances(
  const dgg::GraphView& graph, const std::vector<std::pair<Id, double>>& sources);
std::vector<double> GraphDistances(const dgg::GraphView& graph, Id source);

/// A matrix of distances, row by row.
class DistanceTable
{
public:
  explicit DistanceTable(Id size)
    : Size(size)
    , Values(static_cast<std::size_t>(size) * size)
  {
  }
  Id GetSize() const { return this->Size; }
  double operator()(Id a, Id b) const
  {
    return this->Values[static_cast<std::size_t>(a) * this->Size + b];
  }
  void SetRow(Id a, const std::vector<double>& row);

private:
  Id Size;
  std::vector<double> Values;
};
DistanceTable ExactTable(const dgg::SurfaceMesh& mesh);
DistanceTable GraphTable(const dgg::GraphView& graph);

/// What faces without area, which are lengthened by a little, add to exact distances.
double SlackOf(const dgg::SurfaceMesh& mesh);
/// Expect exact (1 - 1e-9) <= approximate <= (1 + accuracy) exact (1 + 1e-6) for all pairs, and
/// infinite distances to be infinite in both. `slack` is what the exact distances may be off, an
/// absolute length: 0 but for meshes with faces of no area.
void ExpectWithin(
  const DistanceTable& exact, const DistanceTable& approximate, double accuracy, double slack);
/// Largest and mean of approximate / exact - 1.
struct RelativeError
{
  double Largest = 0.0;
  double Mean = 0.0;
};
RelativeError MeasureError(const DistanceTable& exact, const DistanceTable& approximate);

/// Expect a graph to be one: arrays valid, every edge in both directions with equal lengths and
/// exchanged angles, at most one edge to a vertex, rows sorted by angle, angles in their range.
void ExpectWellFormed(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph);
/// Expect the same bytes, and that the checksum says so.
void ExpectSameGraph(const dgg::GeodesicGraph& expected, const dgg::GeodesicGraph& actual);
/// Index of the edge between two vertices, -1 when there is none.
dgg::Offset FindEdge(const dgg::GraphView& graph, Id from, Id to);
}

#endif
