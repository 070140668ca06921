// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The logarithm of a Green's function, cut off smoothly. Internal.
#ifndef dggLogarithm_h
#define dggLogarithm_h

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

  /// Integrals that belong to a segment whose ends have the given distances from the pole, in the
  /// plane.
  /// @{
  /// Of s along the segment.
  double IntegrateAlong(double length, double fromOrigin, double fromEnd) const;
  /// Of s over the triangle that the pole and the segment span; not negative.
  double IntegrateSector(double length, double fromOrigin, double fromEnd) const;
  /// @}

private:
  double Radius;
  double Angle;
};
}

#endif
