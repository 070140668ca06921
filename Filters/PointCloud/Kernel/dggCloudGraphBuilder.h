// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builds the discrete geodesic graph of a point cloud.
#ifndef dggCloudGraphBuilder_h
#define dggCloudGraphBuilder_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggTypes.h"         // for Id, Status

#include <cstddef> // for std::size_t
#include <cstdint> // for std::uint8_t
#include <vector>  // for what is known of points

namespace dgg
{
/// How far the edges of a point may reach. Fang, "Discrete Geodesic Graphs", 2019, chapter 5.
enum class CloudScheme : std::uint8_t
{
  Curvature = 0, ///< A: the mean length of the direct pairs of the point by alpha
  Constant = 1,  ///< B: h + alpha voxels for all points
  Spacing = 2    ///< C: alpha times the local spacing of points
};

struct CloudGraphOptions
{
  CloudScheme Scheme = CloudScheme::Spacing;
  /// Radius h of the balls that make the band, in voxels. 0: from the local spacing of the points,
  /// so that it may differ from point to point.
  double OffsetInVoxels = 0.0;
  /// Voxels along the longest side of the box of the points, outliers left out, without those
  /// around it that balls reach into. 0: from the spacing of the points.
  Id Resolution = 0;
  /// What it means depends on the scheme. 0: the default of the scheme.
  double Alpha = 0.0;
  /// Of sparsification: edges that others stand in for within that relative error are left out.
  /// 0: all are kept. At most 0.5.
  double Accuracy = 0.001;
  /// Whether the length of an edge is that of an arc, estimated from the normals at its ends,
  /// rather than of the chord.
  bool ArcLengthWeights = true;
  /// Normals, x y z per point, of any length; null: fitted to the neighbours of each point. Where
  /// they are not finite, or 0, they are fitted too.
  const double* Normals = nullptr;
  /// Whether Normals all point to the same side of the surface, which separates sheets that are
  /// back to back. Points without a normal are treated as if it were false.
  bool HasOrientedNormals = false;
  /// Bytes that building may take, with Normals, which are there already. 0: no limit. Fewer
  /// threads are used where what they need for themselves would be more: it fails only where one
  /// would need more, the same for any number of them.
  std::size_t MemoryLimit = 0;
  ParallelFor Parallel;      ///< may be empty
  int NumberOfThreads = 1;   ///< that Parallel may use, for the estimate of memory
  ProgressCallback Progress; ///< may be empty; called from the thread that called Build()
};

/// Graph of a cloud, and what is needed to rebuild the band (VoxelBand) around it.
struct CloudGraph
{
  /// Rows are sorted by target; no angles. Points that are not finite have empty rows.
  GeodesicGraph Graph;
  /// Per point, the component that it belongs to, NoId where it is not finite. Components are
  /// numbered from the largest on.
  std::vector<Id> Components;
  std::vector<Id> ComponentSizes;
  /// Per point, the radius of its ball; 0 where it is not finite, or an outlier.
  std::vector<double> Radii;
  double VoxelSize = 0.0;
};

/// What building a graph found, and took. Lengths are in the units of the points.
struct CloudGraphStatistics
{
  Id UnusedPoints = 0;     ///< not finite
  Id Outliers = 0;         ///< far off all others: connected to none but those in the same place
  Id CoincidentPoints = 0; ///< exactly where another point is: joined to it by a tiny edge
  double Spacing = 0.0;    ///< median of the roots of the area per point
  double Noise = 0.0;      ///< median distance of points from the surfaces fitted to neighbours
  /// That by the median radius of curvature of the surface. Fits to noise flatten what is curved:
  /// on spheres of 4000 points and more, distances come out shorter by about twice its square
  /// (measured, from 0.06 to 0.1).
  double NoiseByRadius = 0.0;
  double OffSurface = 0.0; ///< share of points whose neighbours lie on no surface
  /// When these are more than a tenth, how far points typically lie off a surface, in spacings.
  /// Such noise is left as it is, and the graph is of little use. Otherwise 0.
  double Scatter = 0.0;
  double VoxelSize = 0.0;
  double OffsetInVoxels = 0.0; ///< median radius of a ball by the size of a voxel
  Id Resolution = 0;           ///< voxels along the longest side of the points
  double Alpha = 0.0;          ///< as used
  double Reach = 0.0;          ///< median
  std::size_t BandMemory = 0;  ///< bytes
};

/// What a graph will take, from the rows of some points.
struct CloudGraphEstimate
{
  double Edges = 0.0;  ///< directed
  double Memory = 0.0; ///< bytes of the graph
  double Peak = 0.0;   ///< most bytes while it is built, at most twice too many
};

/// Builds graphs of one cloud: `points`, x y z per point, must outlive the builder.
///
/// Two points are connected directly when the segment between them stays in the band, the union of
/// balls around all points. Direct pairs within reach are the full graph, of which the progress
/// rule keeps what is needed for the accuracy. Outliers (dggOutliers.h says which these
/// are) are connected to none but those in the same place: the graph of the others is as if they
/// were not there.
class CloudGraphBuilder
{
public:
  CloudGraphBuilder(const double* points, Id numberOfPoints);

  /// Fails with a message when an option is out of range.
  static Status Check(const CloudGraphOptions& options);

  /// Predict what Build() will take: prepares it and builds the rows of some points. Reports
  /// the progress of that.
  Status Estimate(const CloudGraphOptions& options, CloudGraphEstimate& estimate) const;

  /// Build the graph: the same, bit by bit, for any Parallel. `result` is empty on failure. The
  /// signature is left to the caller. May throw std::bad_alloc.
  Status Build(const CloudGraphOptions& options, CloudGraph& result,
    CloudGraphStatistics* statistics = nullptr) const;

private:
  const double* Points;
  Id NumberOfPoints;
};
}

#endif
