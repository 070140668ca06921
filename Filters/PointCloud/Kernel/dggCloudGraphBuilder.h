// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builds the discrete geodesic graph of a point cloud.
#ifndef dggCloudGraphBuilder_h
#define dggCloudGraphBuilder_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggStatus.h"        // for Status

#include <cstddef> // for std::size_t
#include <cstdint> // for std::uint8_t
#include <vector>  // for per-point arrays

namespace dgg
{
/// Scheme for the reach, the maximum length of the edges of a point. Fang, "Discrete Geodesic
/// Graphs", 2019, chapter 5.
enum class CloudScheme : std::uint8_t
{
  Curvature = 0, ///< A: mean length of the direct pairs of the point, divided by alpha
  Constant = 1,  ///< B: h + alpha voxels for all points
  Spacing = 2    ///< C: alpha times the local point spacing
};

struct CloudGraphOptions
{
  CloudScheme Scheme = CloudScheme::Spacing;
  /// Radius h of the balls that form the band, in voxels: at least 0.5 and at most 1000. 0: derived
  /// from the local point spacing, so that the radius may vary between points.
  double OffsetInVoxels = 0.0;
  /// Number of voxels along the longest side of the bounding box of the points without outliers, at
  /// most LargestResolution. Voxels outside the box that intersect balls are not counted. 0:
  /// derived from the point spacing.
  Id Resolution = 0;
  /// Parameter of the scheme, see CloudScheme: at least 1e-3 and at most 1e6. 0: default of the
  /// scheme.
  double Alpha = 0.0;
  /// Relative error of the sparsification: an edge is removed if other edges replace it within this
  /// error. At least 1e-6 and at most 0.5. 0: all edges are kept.
  double Accuracy = 0.001;
  /// True if the length of an edge is an arc length estimated from the normals at its ends, false
  /// if it is the chord length.
  bool ArcLengthWeights = true;
  /// Normals, x y z per point, not necessarily of unit length. Null: normals are fitted to the
  /// neighbors of each point. Zero or non-finite normals are replaced by fitted ones.
  const double* Normals = nullptr;
  /// True if all Normals point to the same side of the surface. Orientation separates layers that
  /// lie back to back. Points without a given normal are treated as if the value were false.
  bool HasOrientedNormals = false;
  /// Maximum memory of the build in bytes, including Normals, which the caller already holds. 0: no
  /// limit. The number of threads is reduced if their working memory would exceed the limit. The
  /// build fails only if a single thread would exceed the limit, so that failure does not depend on
  /// the number of threads.
  std::size_t MemoryLimit = 0;
  ParallelFor Parallel;      ///< may be empty
  int NumberOfThreads = 1;   ///< maximum number of threads of Parallel, for the memory estimate
  ProgressCallback Progress; ///< may be empty; called from the thread that called Build()
};

/// Graph of a cloud, with the data needed to rebuild its band (VoxelBand).
struct CloudGraph
{
  /// Rows are sorted by target and have no angles. Non-finite points have empty rows.
  GeodesicGraph Graph;
  /// Component of each point, NoId for non-finite points. Components are numbered by decreasing
  /// size.
  std::vector<Id> Components;
  /// Number of points per component.
  std::vector<Id> ComponentSizes;
  /// Ball radius of each point, in units of the points; 0 for non-finite points and outliers.
  std::vector<double> Radii;
  double VoxelSize = 0.0; ///< in units of the points
};

/// Properties of the cloud found while building a graph, and parameters used. Lengths are in units
/// of the points.
struct CloudGraphStatistics
{
  Id UnusedPoints = 0; ///< number of non-finite points
  /// Number of points far from all others, connected only to points at the same position.
  Id Outliers = 0;
  /// Number of points at the position of another point, connected to that point by a tiny edge.
  Id CoincidentPoints = 0;
  double Spacing = 0.0; ///< median of the square root of the area per point
  double Noise = 0.0;   ///< median distance of points from surfaces fitted to neighbors
  /// Ratio of Noise to the median radius of curvature of the surface. Fits to noisy points flatten
  /// a curved surface: on spheres of at least 4000 points, distances are too short by a relative
  /// error of about twice the square of this ratio (measured for ratios from 0.06 to 0.1).
  double NoiseByRadius = 0.0;
  double OffSurface = 0.0; ///< fraction of points whose neighbors lie on no surface
  /// If OffSurface exceeds 0.1: typical distance of points from a surface, in spacings. Such noise
  /// is not removed, and the graph is of little use. Otherwise 0.
  double Scatter = 0.0;
  double VoxelSize = 0.0;
  double OffsetInVoxels = 0.0; ///< median ratio of ball radius to voxel size
  Id Resolution = 0;           ///< voxels along the longest side of the points
  double Alpha = 0.0;          ///< value used
  double Reach = 0.0;          ///< median reach
  std::size_t BandMemory = 0;  ///< memory of the band in bytes
};

/// Predicted size of a graph, extrapolated from the rows of a sample of nodes.
struct CloudGraphEstimate
{
  double Edges = 0.0;  ///< number of directed edges
  double Memory = 0.0; ///< memory of the graph in bytes
  /// Peak memory of the build in bytes, overestimated by at most a factor of two.
  double Peak = 0.0;
};

/// Builds graphs of one cloud. `points`, x y z per point, must outlive the builder.
///
/// Two points are connected directly if the segment between them stays in the band, the union of
/// balls around all points. The direct pairs within reach form the full graph. The progress rule
/// keeps the edges of this graph that are needed for the accuracy. Outliers (see dggOutliers.h) are
/// connected only to points at the same position, and do not affect the graph of the other points.
class CloudGraphBuilder
{
public:
  CloudGraphBuilder(const double* points, Id numberOfPoints);

  /// Fails with a message if an option is out of range.
  static Status Check(const CloudGraphOptions& options);

  /// Predicts the size of the graph and the memory of Build(): prepares the build and builds the
  /// rows of a sample of nodes. Progress refers to this work.
  Status Estimate(const CloudGraphOptions& options, CloudGraphEstimate& estimate) const;

  /// Builds the graph. The result is bitwise identical for any Parallel, and empty on failure. The
  /// signature is not set; callers must set it. May throw std::bad_alloc.
  Status Build(const CloudGraphOptions& options, CloudGraph& result,
    CloudGraphStatistics* statistics = nullptr) const;

private:
  const double* Points;
  Id NumberOfPoints;
};
}

#endif
