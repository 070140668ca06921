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

#include <cstdint> // for flags
#include <vector>  // for what is known of points

namespace dgg
{
/// What is known of the points of a cloud. Everything is the same for (p, q) and (q, p).
struct CloudPairs
{
  std::vector<Point3> Points;
  std::vector<Point3> Normals; ///< of length 1, or 0 where unknown
  std::vector<float> Radii;    ///< of the balls of the band
  std::vector<float> Reaches;  ///< how long edges of a point may be
  std::vector<float> Spacings; ///< local distance between points: the root of the area of each
  std::vector<float> Noise;    ///< variance of the direction of normals, radians squared
  VoxelBand Band;
  bool UsesArcs = true;
  bool HasOrientedNormals = false;

  double Chord(Id p, Id q) const { return Norm(this->Points[q] - this->Points[p]); }

  /// Length of the way between two points that are connected directly.
  double Length(Id p, Id q, double chord) const;
  double Length(Id p, Id q) const { return this->Length(p, q, this->Chord(p, q)); }

  bool IsInReach(Id p, Id q, double chord) const
  {
    return chord <= this->Reaches[p] || chord <= this->Reaches[q];
  }

  /// Whether the segment stays in the band and looks like a way on the surface.
  bool IsDirect(Id p, Id q, double chord) const;
};
}

#endif
