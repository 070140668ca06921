// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Contribution of the logarithm of a Green's function to finite elements. Internal.
#ifndef dggSingularPart_h
#define dggSingularPart_h

#include "dggPoissonSystem.h" // for the elements

#include <array>   // for distances in a face
#include <cstdint> // for flags
#include <vector>  // for the results

namespace dgg
{
/// Around a pole, at distance d and with u = d^2 / R^2,
///
///     s(d) = -1 / (2 Theta) [log u - (u - 1) + (u - 1)^2 / 2 - (u - 1)^3 / 3],  0 from d = R on,
///
/// where Theta is the angle around the pole: 2 pi in the interior of the surface, the total angle
/// at a vertex. The flux out of a small circle is 1. Value and first three derivatives are 0 at R,
/// and s + log(d) / Theta is smooth at 0.
class Logarithm
{
public:
  Logarithm(double radius, double angle);

  double GetRadius() const { return this->Radius; }
  double GetAngle() const { return this->Angle; }

  /// Returns s(distance); Infinity at 0.
  double At(double distance) const;
  /// Returns the mean over the disk of the given radius, at most R.
  double MeanOverDisk(double radius) const;
  /// Returns S(d) = R^2 / (8 Theta) [u log u - (u - 1) - (u - 1)^2 / 2 + (u - 1)^3 / 6], 0 from R
  /// on. The negative Laplacian of S equals s up to a smooth function. Value and first three
  /// derivatives are 0 at R.
  double PotentialAt(double distance) const;

  /// Functions that integrate over a segment in the plane, or the triangle behind it. The ends of
  /// the segment have the given distances from the pole.
  /// @{
  /// Returns the integral of s along the segment.
  double IntegrateAlong(double length, double fromOrigin, double fromEnd) const;
  /// Returns the integral of S along the segment.
  double IntegratePotentialAlong(double length, double fromOrigin, double fromEnd) const;
  /// Returns the integral of s over the triangle spanned by the pole and the segment; non-negative.
  double IntegrateSector(double length, double fromOrigin, double fromEnd) const;
  /// @}

private:
  double Radius;
  double Angle;
};

/// A face of the triangulation that contains the pole in its interior or on its boundary.
struct PoleFace
{
  Id Face = NoId;
  std::array<double, 3> Barycentric{ { 0.0, 0.0, 0.0 } };
  /// Straight distances to the corners.
  std::array<double, 3> Distances{ { 0.0, 0.0, 0.0 } };
};

/// Integrals of s(d) and S(d), with d the distance from the pole, against hat functions. On every
/// edge, d is modeled as the distance from a point in the plane that matches the values at the
/// ends. With this model, the integral of grad s . grad phi over a triangle has a closed form: it
/// equals the integral of s along the sides times the constant grad phi . n.
class SingularPart
{
public:
  explicit SingularPart(const PoissonSystem& system)
    : System(system)
  {
  }

  /// Computes the integrals. `distances` per vertex must be set at all corners of faces that have a
  /// corner within R; other distances may be Infinity. Faces with an unreached corner that
  /// intersect the disk only in their interior are ignored, since s is negligible in these faces.
  /// If `hasPotential` is true, the loads of S and the integrals of s against hat functions are
  /// computed as well.
  void Assemble(const Logarithm& logarithm, const std::vector<double>& distances,
    const std::vector<PoleFace>& poleFaces, bool hasPotential = false);

  /// Returns, per vertex, minus the integral of grad s . grad phi. The loads sum to 0.
  const std::vector<double>& GetLoads() const { return this->Loads; }
  /// Returns the corresponding loads of S; empty unless requested.
  const std::vector<double>& GetPotentialLoads() const { return this->PotentialLoads; }
  /// Returns, per vertex, its share of the integral of s. The share is a third of the integral over
  /// each of its faces, or the integral of s phi.
  const std::vector<double>& GetIntegrals() const { return this->Integrals; }

private:
  const PoissonSystem& System;
  std::vector<double> Loads;
  std::vector<double> PotentialLoads;
  std::vector<double> Integrals;
  // Means of s and S on an edge, per half-edge; only set at the first half-edge of each edge.
  std::vector<std::array<double, 2>> Means;
  std::vector<std::uint8_t> IsDone; // per half-edge, true if Means is set
};
}

#endif
