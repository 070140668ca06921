// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between two sets of surface points. Internal.
#ifndef DGGMatrixSearch_h
#define DGGMatrixSearch_h

#include "dggGraphBuilder.h" // for GraphLink
#include "dggGraphSearch.h"  // for GraphSearch
#include "dggSurfacePoint.h" // for SurfacePoint

#include <cstddef> // for std::size_t
#include <vector>  // for the points

class DGGGraphUser;
struct DGGContext;

/// The entries of a matrix whose rows lie one behind the other.
struct DGGMatrixEntries
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

/// Searches a graph from every point of one set, and looks at the points of another one.
///
/// A point that is not a vertex is linked to the graph as a vertex would be. A way between two such
/// points leads over a link of each, or is a straight one that leaves out the graph.
class DGGMatrixSearch
{
public:
  using Points = std::vector<dgg::SurfacePoint>;
  using Links = std::vector<std::vector<dgg::GraphLink>>; // per point

  /// `graph` is up to date. distances(i, j) becomes the distance of sources[i] from
  /// targets[j]; where there is no way it stays dgg::Infinity, which all of them must be before.
  DGGMatrixSearch(const DGGContext& context, DGGGraphUser& graph, const Points& sources,
    const Points& targets, const DGGMatrixEntries& distances);

  /// With `symmetric`, the targets are the sources: then one half is searched, and mirrored.
  /// Distances above `radius` may stay dgg::Infinity.
  dgg::Status Run(bool symmetric, double radius);

private:
  template <typename EntryType>
  dgg::Status LinkPoints(
    const Points& points, const Points& others, double end, Links& links, EntryType entry);
  dgg::Status Search(double radius);
  void LookAtTargets(std::size_t source, const double* field) const;
  void Mirror() const;

  const DGGContext& Context;
  DGGGraphUser& Graph;
  const Points& Sources;
  const Points& Targets;
  const DGGMatrixEntries& Distances;
  bool IsSymmetric = false;
  Links SourceLinks;
  Links TargetLinks;
  const dgg::ProgressCallback Progress;
  double Done = 0.0; // share of the progress
};

#endif
