// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths for many pairs of points. Internal.
#ifndef vtkDGGPathSearch_h
#define vtkDGGPathSearch_h

#include "dggPathFinder.h"   // for FoundPath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the pairs

class vtkDGGGraphUser;
class vtkDGGPreparedMesh;
struct vtkDGGContext;

/// Points between which a path is wanted.
struct vtkDGGPointPair
{
  dgg::SurfacePoint From;
  dgg::SurfacePoint To;
};

/// Find paths, one for each pair, on all threads.
class vtkDGGPathSearch
{
public:
  using Pairs = std::vector<vtkDGGPointPair>;
  using Paths = std::vector<dgg::FoundPath>;

  vtkDGGPathSearch(const vtkDGGContext& context, const Pairs& pairs);

  /// In a graph that is up to date, of a surface whose positions have been made.
  dgg::Status RunInGraph(vtkDGGGraphUser& graph, dgg::PathOptions options, Paths& paths) const;
  /// The same in the graph of a cloud, without faces: from point to point of the cloud, or with
  /// `smooth` not, unless that is longer than the way in the graph. The length is that of the
  /// polyline, which is shorter than that in the graph where the surface is curved.
  dgg::Status RunOnCloud(vtkDGGGraphUser& graph, bool smooth, Paths& paths) const;
  /// Exact ones. Their lengths in the graph are NaN.
  dgg::Status RunExact(Paths& paths) const;

private:
  dgg::Status FindOnCloud(const vtkDGGGraphUser& graph, const vtkDGGPointPair& pair, bool smooth,
    const dgg::ProgressCallback& progress, dgg::FoundPath& found) const;

  const vtkDGGContext& Context;
  const vtkDGGPreparedMesh& Mesh;
  const Pairs& PointPairs;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGPathSearch.h
