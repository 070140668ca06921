// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance around one vertex as that from its virtual source. Internal.
#ifndef dggCornerModel_h
#define dggCornerModel_h

#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <algorithm> // for std::min
#include <cmath>     // for std::sin

namespace dgg
{
/// The field of one source, in polar coordinates around a vertex. On its star the function is
/// continuous whichever face it is evaluated in: the surface around the vertex is a cone, and the
/// way to the source leads around its tip on the side where the angle is smaller, or through the
/// tip where it is pi and more on both.
struct CornerModel
{
  double Offset = 0.0; ///< distance at the virtual source
  double Length = 0.0; ///< straight distance from it
  double Angle = 0.0;  ///< polar angle towards it
  double Total = 0.0;  ///< total angle of the vertex
  bool IsOpen = false; ///< on the boundary: there is no way around the outside
  bool IsKnown = false;

  CornerModel() = default;
  /// The angles of an Irregular vertex mean nothing, so it has no model.
  CornerModel(const SurfaceMesh& mesh, Id v, double offset, double length, double angle)
    : Offset(offset)
    , Length(length)
    , Angle(angle)
    , Total(mesh.TotalAngle(v))
    , IsOpen(mesh.Kind(v) == VertexKind::Boundary)
    , IsKnown(mesh.Kind(v) != VertexKind::Irregular && mesh.Kind(v) != VertexKind::Isolated)
  {
  }

  /// The model of the virtual source, with the distance that is given at the vertex.
  CornerModel(const SurfaceMesh& mesh, Id v, const VirtualSources& sources, double distance)
    : CornerModel(mesh, v, distance - sources.Lengths[v], sources.Lengths[v], sources.Angles[v])
  {
  }

  double AtVertex() const { return this->Offset + this->Length; }

  /// Angle from the direction to a point at polar angle `phi` to that of the source, on the side
  /// where it is smaller.
  double AngleFrom(double phi) const
  {
    const double angle = this->Angle - phi;
    if (this->IsOpen || 2.0 * std::abs(angle) <= this->Total)
    {
      return angle;
    }
    // Within one turn, what std::remainder gives, bit for bit, but faster: the sum is exact.
    return 2.0 * std::abs(angle) < 3.0 * this->Total ? angle - std::copysign(this->Total, angle)
                                                     : std::remainder(angle, this->Total);
  }

  /// What it says along one direction.
  struct Ray
  {
    double Offset;
    double Length;
    double Bend; // 4 sin^2 of half the angle between the direction and that of the source

    double At(double rho) const
    {
      // The law of cosines, accurate for small angles.
      const double difference = this->Length - rho;
      return this->Offset + std::sqrt(difference * difference + this->Length * rho * this->Bend);
    }
  };
  Ray Along(double phi) const
  {
    const double angle = std::min(Pi, std::abs(this->AngleFrom(phi))); // pi: through the vertex
    const double sine = std::sin(0.5 * angle);
    return { this->Offset, this->Length, 4.0 * sine * sine };
  }

  /// The distance at polar coordinates (rho, phi).
  double At(double rho, double phi) const { return this->Along(phi).At(rho); }
};
}

#endif
