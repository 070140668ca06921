// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the logarithm of a Green's function does to finite elements. Internal.
#ifndef dggSingularPart_h
#define dggSingularPart_h

#include "dggLogarithm.h"     // for Logarithm
#include "dggPoissonSystem.h" // for the elements

#include <array>   // for distances in a face
#include <cstdint> // for flags
#include <vector>  // for the results

namespace dgg
{
/// A face of the triangulation that the pole lies in, or on the rim of.
struct PoleFace
{
  Id Face = NoId;
  std::array<double, 3> Barycentric{ { 0.0, 0.0, 0.0 } };
  /// Straight, to the corners.
  std::array<double, 3> Distances{ { 0.0, 0.0, 0.0 } };
};

/// Integrals of s(d), d the distance from the pole, against hat functions. On every edge d is taken
/// to be the distance from one point in the plane, given by its values at the ends; then the
/// integral over a triangle of grad s . grad phi, which is that of s along its sides times the
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
  void Assemble(const Logarithm& logarithm, const std::vector<double>& distances,
    const std::vector<PoleFace>& poleFaces);

  /// Per vertex, minus the integral of grad s . grad phi. They sum to 0.
  const std::vector<double>& GetLoads() const { return this->Loads; }
  /// Per vertex, its part of the integral of s: a third of that over each of its faces.
  const std::vector<double>& GetIntegrals() const { return this->Integrals; }

private:
  const PoissonSystem& System;
  std::vector<double> Loads;
  std::vector<double> Integrals;
  std::vector<double> Means; // per half-edge, of s on the edge; where it is the first one of that
  std::vector<std::uint8_t> IsDone; // likewise
};
}

#endif
