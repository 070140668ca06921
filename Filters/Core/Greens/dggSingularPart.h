// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the logarithm of a Green's function does to finite elements. Internal.
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
/// where Theta is the angle around the pole: 2 pi inside of the surface, the total angle at a
/// vertex. One unit flows out of a small circle. Value and first three derivatives are 0 at R, and
/// s + log(d) / Theta is smooth at 0.
class Logarithm
{
public:
  Logarithm(double radius, double angle);

  double GetRadius() const { return this->Radius; }
  double GetAngle() const { return this->Angle; }

  /// Infinity at 0.
  double At(double distance) const;
  /// Mean over the disk of the given radius, at most R.
  double MeanOverDisk(double radius) const;
  /// S(d) = R^2 / (8 Theta) [u log u - (u - 1) - (u - 1)^2 / 2 + (u - 1)^3 / 6], 0 from R on: what
  /// s is minus the Laplacian of, but for what is smooth. Value and three derivatives are 0 at R.
  double PotentialAt(double distance) const;

  /// Integrals that belong to a segment whose ends have the given distances from the pole, in the
  /// plane.
  /// @{
  /// Of s along the segment.
  double IntegrateAlong(double length, double fromOrigin, double fromEnd) const;
  /// Of S along the segment.
  double IntegratePotentialAlong(double length, double fromOrigin, double fromEnd) const;
  /// Of s over the triangle that the pole and the segment span; not negative.
  double IntegrateSector(double length, double fromOrigin, double fromEnd) const;
  /// @}

private:
  double Radius;
  double Angle;
};

/// A face of the triangulation that the pole lies in, or on the rim of.
struct PoleFace
{
  Id Face = NoId;
  std::array<double, 3> Barycentric{ { 0.0, 0.0, 0.0 } };
  /// Straight, to the corners.
  std::array<double, 3> Distances{ { 0.0, 0.0, 0.0 } };
};

/// Integrals of s(d) and S(d), d the distance from the pole, against hat functions. On every edge d
/// is taken to be the distance from one point in the plane, given by its values at the ends; then
/// the integral over a triangle of grad s . grad phi, which is that of s along its sides times the
/// constant grad phi . n, has a closed form.
class SingularPart
{
public:
  explicit SingularPart(const PoissonSystem& system)
    : System(system)
  {
  }

  /// `distances` per vertex, those of all corners of faces that have one
  /// within R; may be Infinity elsewhere. Faces that reach into the disk with their insides alone
  /// do not count when a corner is not reached: s is next to nothing there.
  /// `hasPotential`: loads of S as well, and integrals of s against hat functions.
  void Assemble(const Logarithm& logarithm, const std::vector<double>& distances,
    const std::vector<PoleFace>& poleFaces, bool hasPotential = false);

  /// Per vertex, minus the integral of grad s . grad phi. They sum to 0.
  const std::vector<double>& GetLoads() const { return this->Loads; }
  /// The same of S; empty where they were not asked for.
  const std::vector<double>& GetPotentialLoads() const { return this->PotentialLoads; }
  /// Per vertex, its part of the integral of s: a third of that over each of its faces, or
  /// the integral of s phi.
  const std::vector<double>& GetIntegrals() const { return this->Integrals; }

private:
  const PoissonSystem& System;
  std::vector<double> Loads;
  std::vector<double> PotentialLoads;
  std::vector<double> Integrals;
  // Per half-edge, means of s and S on the edge; where it is the first one of that.
  std::vector<std::array<double, 2>> Means;
  std::vector<std::uint8_t> IsDone; // likewise
};
}

#endif
