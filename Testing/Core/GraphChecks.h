// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of the graph builder. Distances in a graph come from an independent
/// Dijkstra, so that tests of the builder do not depend on the searches of the kernel.
#ifndef GraphChecks_h
#define GraphChecks_h

#include "TestMeshes.h"

#include "dggGraphBuilder.h"
#include "dggVirtualSources.h"

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
/// Builds a graph. Throws std::runtime_error with the kernel's message on an error; a graph that is
/// not well formed fails the test. `change` may adjust the options.
dgg::GeodesicGraph BuildGraph(const dgg::SurfaceMesh& mesh, double accuracy,
  const std::function<void(dgg::GraphOptions&)>& change = nullptr,
  dgg::GraphStatistics* statistics = nullptr);
/// Builds a graph with any construction and without a callback.
dgg::GeodesicGraph BuildGraph(
  const dgg::SurfaceMesh& mesh, double accuracy, dgg::GraphConstruction construction);

std::vector<dgg::GraphConstruction> AllConstructions();

/// Returns a loop over threads that take ranges of `size` from a common counter; 0 selects the size
/// that the kernel requests.
dgg::ParallelFor WithThreads(int count, dgg::Offset size = 0);

/// Returns the distances of all vertices from sources with initial distances.
std::vector<double> GraphDistances(
  const dgg::GraphView& graph, const std::vector<std::pair<Id, double>>& sources);
std::vector<double> GraphDistances(const dgg::GraphView& graph, Id source);

/// Matrix of distances, row by row.
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

/// Returns the length that the lengthening of degenerate faces adds to exact distances.
double SlackOf(const dgg::SurfaceMesh& mesh);
/// Expects exact (1 - 1e-9) <= approximate <= (1 + accuracy) exact (1 + 1e-6) for all pairs, and
/// both distances to be infinite for the same pairs. `slack` is the absolute error of the exact
/// distances; it is 0 except for meshes with degenerate faces.
void ExpectWithin(
  const DistanceTable& exact, const DistanceTable& approximate, double accuracy, double slack);
/// Largest and mean value of approximate / exact - 1.
struct RelativeError
{
  double Largest = 0.0;
  double Mean = 0.0;
};
RelativeError MeasureError(const DistanceTable& exact, const DistanceTable& approximate);

/// Expects a graph to be well formed: valid arrays, every edge in both directions with equal
/// lengths and exchanged angles, at most one edge to a vertex, rows sorted by angle, angles within
/// their range.
void ExpectWellFormed(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph);
/// Expects two graphs to be equal byte by byte, and to have equal checksums.
void ExpectSameGraph(const dgg::GeodesicGraph& expected, const dgg::GeodesicGraph& actual);
/// Returns the index of the edge between two vertices; -1 if there is none.
dgg::Offset FindEdge(const dgg::GraphView& graph, Id from, Id to);
}

#endif
