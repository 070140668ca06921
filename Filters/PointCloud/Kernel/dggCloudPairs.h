// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which pairs of points of a cloud are connected directly, and how far apart they are. Internal.
#ifndef dggCloudPairs_h
#define dggCloudPairs_h

#include "dggArcLength.h" // for arcs over chords
#include "dggPoint3.h"    // for Point3
#include "dggTypes.h"     // for Id
#include "dggVoxelBand.h" // for VoxelBand

#include <functional> // for FindNearestPoint
#include <vector>     // for what is known of points

namespace dgg
{
/// What is known of the points of a cloud. All answers are the same for (p, q) and (q, p).
///
/// Two points are connected directly when the segment between them stays in the band, and close to
/// the points that it passes: nearer than balls are large, measured along their normals. So sheets
/// stay apart that are closer to each other than two balls. Points whose normals are oriented, and
/// opposite, are on sheets back to back, however far from each other.
struct CloudPairs
{
  /// Radius of a ball by the size of voxels: those of smaller ones are looked at themselves.
  static constexpr double LeastRadiusInVoxels = 0.5;

  std::vector<Point3> Points;
  std::vector<Point3> Normals; ///< of length 1, or 0 where unknown
  std::vector<double> Radii;   ///< of the balls of the band
  std::vector<float> Reaches;  ///< how long edges of a point may be
  std::vector<float> Spacings; ///< local distance between points: the root of the area of each
  /// Whether neighbours lie on the surface that was fitted to them: then an arc says all about the
  /// way between two points.
  std::vector<unsigned char> IsSmooth;
  VoxelBand Band;
  /// Per voxel (VoxelBand::PlaceOf()), the point that is nearest to its centre, NoId if it is not
  /// marked.
  std::vector<Id> Nearest;
  /// Asks for the nearest point to any place. Voxels say nothing of balls that are much smaller
  /// than they are: between the points of these, it takes the place of Band and Nearest.
  std::function<Id(const Point3&)> FindNearestPoint;
  /// Whether a way is as long as the surface rather than the chord.
  bool UsesArcs = true;
  /// Whether a normal is known to point to the same side of the surface as those of others; empty
  /// when none is.
  std::vector<unsigned char> IsOriented;

  double Chord(Id p, Id q) const { return Norm(this->Points[q] - this->Points[p]); }

  bool IsInReach(Id p, Id q, double chord) const
  {
    return chord <= this->Reaches[p] || chord <= this->Reaches[q];
  }

  /// Length of the way between two points along the segment between them; Infinity when it does not
  /// look like a way on the surface.
  double Length(Id p, Id q, double chord) const;
  double Length(Id p, Id q) const { return this->Length(p, q, this->Chord(p, q)); }

  /// Whether points of finite Length() are connected directly.
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
