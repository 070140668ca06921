// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Direct connections between points of a cloud, and their lengths. Internal.
#ifndef dggCloudPairs_h
#define dggCloudPairs_h

#include "dggArcLength.h" // for arc lengths
#include "dggPoint3.h"    // for Point3
#include "dggTypes.h"     // for Id
#include "dggVoxelBand.h" // for VoxelBand

#include <functional> // for FindNearestPoint
#include <vector>     // for per-point arrays

namespace dgg
{
/// Per-point data of a cloud, and queries for pairs of points. All queries are symmetric in p and
/// q.
///
/// Two points are connected directly if the segment between them stays in the band and the points
/// near the segment lie close to the expected surface: their offset along their normals is smaller
/// than a ball radius. Layers therefore remain separate even if their distance is less than two
/// ball radii. Points with oriented normals in opposite directions are on layers that lie back to
/// back, at any distance, and are not connected.
struct CloudPairs
{
  /// Minimum ratio of ball radius to voxel size for tests with voxels. Smaller balls are tested
  /// directly.
  static constexpr double LeastRadiusInVoxels = 0.5;

  std::vector<Point3> Points;
  std::vector<Point3> Normals; ///< unit vectors, or 0 if unknown
  std::vector<double> Radii;   ///< ball radii of the band
  std::vector<float> Reaches;  ///< maximum edge length per point
  /// Local spacing: square root of the area per point.
  std::vector<float> Spacings;
  /// 1 for points whose neighbors lie on the surface fitted to them. Between two such points, an
  /// arc describes the path sufficiently.
  std::vector<unsigned char> IsSmooth;
  VoxelBand Band;
  /// Per voxel (VoxelBand::PlaceOf()), the point nearest to the voxel center; NoId if the voxel is
  /// not marked.
  std::vector<Id> Nearest;
  /// Returns the point nearest to any position. Replaces Band and Nearest for points whose balls
  /// are much smaller than a voxel, since voxels do not resolve such balls.
  std::function<Id(const Point3&)> FindNearestPoint;
  /// True if path lengths are arc lengths along the surface, false if they are chord lengths.
  bool UsesArcs = true;
  /// 1 for points whose normal is known to point to the same side of the surface as normals of
  /// other points; empty without such points.
  std::vector<unsigned char> IsOriented;

  /// Returns the Euclidean distance between two points.
  double Chord(Id p, Id q) const { return Norm(this->Points[q] - this->Points[p]); }

  /// Returns true if the chord length is within the reach of at least one of the points.
  bool IsInReach(Id p, Id q, double chord) const
  {
    return chord <= this->Reaches[p] || chord <= this->Reaches[q];
  }

  /// Returns the length of the path between two points along the segment between them; Infinity if
  /// the segment is unlikely to follow the surface.
  double Length(Id p, Id q, double chord) const;
  double Length(Id p, Id q) const { return this->Length(p, q, this->Chord(p, q)); }

  /// Returns true if two points are connected directly. Their Length() must be finite.
  bool IsDirect(Id p, Id q, double chord) const;

private:
  struct Seen;
  bool IsLikely(const Seen& seen) const;
  bool IsInBand(const Seen& seen) const;
  bool IsInBalls(const Seen& seen) const;
  bool IsFine(Id p) const
  {
    return this->Radii[p] < LeastRadiusInVoxels * this->Band.GetVoxelSize();
  }
  bool IsFarFrom(Id nearest, const Point3& place, const Point3& up, double height) const;
  Id FindNearest(const Seen& seen, const Point3& place) const;
  double FollowPoints(Seen& seen) const;
};
}

#endif
