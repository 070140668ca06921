// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between two sets of surface points. Internal.
#ifndef dggMatrixSearch_h
#define dggMatrixSearch_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggDistanceRows.h"   // for DistanceRows
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggGraphBuilder.h"   // for GraphLink
#include "dggGraphSearch.h"    // for GraphSearch
#include "dggSurfacePoint.h"   // for SurfacePoint

#include <cstddef> // for std::size_t
#include <vector>  // for the points

namespace dgg
{
class GraphSession;
struct TaskContext;

/// Entries of a matrix that is stored row by row.
struct MatrixEntries
{
  double* Values;
  std::size_t NumberOfColumns;
  bool SourcesAreRows;

  double& operator()(std::size_t source, std::size_t target) const
  {
    return this->SourcesAreRows ? this->Values[source * this->NumberOfColumns + target]
                                : this->Values[target * this->NumberOfColumns + source];
  }
};

/// Finds the distances of all points of one set from all points of another set in a graph.
///
/// A point that is not a vertex has links to vertices. A path between two such points uses a link
/// of each point, or is a straight path outside the graph.
class DGG_CORE_EXPORT MatrixSearch
{
public:
  using Points = std::vector<SurfacePoint>;
  using Links = std::vector<std::vector<GraphLink>>; // per point

  /// `graph` must be up to date, and all entries must be Infinity. distances(i, j) becomes the
  /// distance of sources[i] from targets[j].
  MatrixSearch(const TaskContext& context, GraphSession& graph, const Points& sources,
    const Points& targets, const MatrixEntries& distances);

  /// Finds all distances. With `symmetric`, targets and sources are the same points: one half is
  /// searched and mirrored. Entries without a path or above `radius` become `unreachedValue`.
  Status Run(bool symmetric, double radius, double unreachedValue);

private:
  template <typename EntryType>
  Status LinkPoints(
    const Points& points, const Points& others, double end, Links& links, EntryType entry);
  Status Search(double radius);
  void EnterDistances(std::size_t source, const double* field) const;
  void Mirror() const;

  const TaskContext& Context;
  GraphSession& Graph;
  const Points& Sources;
  const Points& Targets;
  const MatrixEntries& Distances;
  bool IsSymmetric = false;
  Links SourceLinks;
  Links TargetLinks;
  const ProgressCallback Progress;
  double Done = 0.0; // progress so far
};

/// Returns entries that are Infinity. Writing them commits the memory.
DGG_CORE_EXPORT Buffer<double> MakeUnreached(std::size_t size);

/// Copies a matrix that is stored row by row to one array per column.
DGG_CORE_EXPORT void CopyColumns(const double* matrix, std::size_t numberOfRows,
  const std::vector<double*>& columns, const ParallelFor& parallel);

/// Finds the distances up to `radius` from each source, corrected if requested and not on a cloud,
/// as compressed rows. `graph` must be up to date.
DGG_CORE_EXPORT Status FindDistanceRows(const TaskContext& context, GraphSession& graph,
  const std::vector<GeodesicSource>& sources, double radius, bool correct, DistanceRows& rows);
}

#endif
