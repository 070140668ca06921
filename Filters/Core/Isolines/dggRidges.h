// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ridges of distances on a surface.
#ifndef dggRidges_h
#define dggRidges_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggEdges.h"         // for LengthSum
#include "dggParallel.h"      // for ParallelFor
#include "dggSurfacePath.h"   // for SurfacePath

#include <algorithm> // for std::max
#include <array>     // for the ends of parts
#include <vector>    // for the lines

namespace dgg
{
struct FieldPieces;

struct RidgeOptions
{
  /// Minimum angle between the directions to the source on both sides of a ridge, radians. On a
  /// polyhedron, a ridge of small angle starts at every convex vertex, and would clutter the
  /// result. Values below a tenth of a degree are raised to a tenth of a degree. With virtual
  /// sources, values below ten degrees are raised to ten degrees, because smaller angles are
  /// transitions between models.
  double MinimumAngle = 20.0 * Pi / 180.0;
  /// Largest distance of a line from the ridge, model units, at least 0; 0 means a thousandth of
  /// the mean edge length.
  double ChordTolerance = 0.0;
  /// If true, find the lines between points with different nearest sources instead, at any angle.
  /// Needs windows and DistanceField::NearestSource. Lines along edges are not found.
  bool BetweenSources = false;
};

/// Mean angle of the segments of a ridge, weighted by length. Does not depend on their order.
class RidgeAngleSum
{
public:
  /// `longest` is at least as long as each segment, and the same for sums that are added.
  explicit RidgeAngleSum(double longest = 0.0)
    : Lengths(Pi * longest)
    , Angles(Pi * longest)
    , Least(1e-15 * longest)
  {
  }

  void Add(double length, double angle)
  {
    const double weight = std::max(this->Least, length);
    this->Lengths.Add(weight);
    this->Angles.Add(weight * angle);
  }
  void Add(const RidgeAngleSum& other)
  {
    this->Lengths.Add(other.Lengths);
    this->Angles.Add(other.Angles);
  }
  double GetMean() const { return this->Angles.GetMean() / this->Lengths.GetMean(); }

private:
  LengthSum Lengths;
  LengthSum Angles; // times lengths
  double Least;     // smallest weight; does not round to zero
};

/// A ridge line that ends where pieces of the surface meet and continues on another process, or in
/// another part on the same process.
struct RidgePart
{
  /// A point at which exactly two parts meet: the two vertices of an edge, and the index among the
  /// ridge points of the edge. At a vertex, the same vertex twice. NoId at an end of the ridge.
  using Joint = std::array<Offset, 3>;

  std::array<Joint, 2> Ends;
  RidgeAngleSum Angle;
  Id Line = NoId; ///< index into Ridges::Lines; NoId if the part has no length
};

/// Polylines on a surface that meet only at their ends.
struct Ridges
{
  std::vector<SurfacePath> Lines;
  std::vector<double> Angles; ///< per line, the mean angle between the two directions, radians
  /// Number of pieces within a face that may exceed the tolerance, for example where the field is
  /// discontinuous.
  Id Fallbacks = 0;
  std::vector<RidgePart> Parts; ///< without the angles of other processes
};

/// Finds the ridges (the cut locus) of a distance: the points with at least two shortest paths.
/// Ridges meet in points with three shortest paths, and end at convex vertices and at points where
/// the angle falls below the minimum; mesh vertices on a ridge are points of the lines. Inside
/// faces, and where a ridge crosses an edge, the two distances of a point are equal up to rounding
/// (Mitchell, Mount and Papadimitriou, "The discrete geodesic problem", 1987).
///
/// The field must have windows or virtual sources: values at vertices do not determine ridges. With
/// virtual sources, only ridges of large angles are found, with gaps.
///
/// The result does not depend on `parallel`. After a failure, `ridges` must not be used.
///
/// If several processes have pieces of the surface, all of them must call the function. They need
/// two layers of cells around their pieces. Lines then end where pieces meet, and their angles are
/// those of the entire ridges.
DGG_CORE_EXPORT Status FindRidges(const DistanceField& field, const RidgeOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, Ridges& ridges,
  FieldPieces* pieces = nullptr);
}

#endif
