// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distance around a vertex as the distance from its virtual source. Internal.
#ifndef dggCornerModel_h
#define dggCornerModel_h

#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <algorithm> // for std::min
#include <cmath>     // for std::sin

namespace dgg
{
/// Field of a virtual source, in polar coordinates around its vertex. The surface around the vertex
/// is a cone. The straight line to the source passes the tip of the cone on the side with the
/// smaller angle, or leads through the tip if the angle is at least pi on both sides. The field is
/// therefore continuous across the faces of the vertex.
struct CornerModel : VirtualSource
{
  double Total = 0.0;   ///< total angle of the vertex
  bool IsOpen = false;  ///< boundary vertex: no line passes it outside the surface
  bool IsKnown = false; ///< false at Irregular vertices, whose angles must not be used

  CornerModel() = default;
  CornerModel(const SurfaceMesh& mesh, Id v, const VirtualSource& source)
    : VirtualSource(source)
    , Total(mesh.TotalAngle(v))
    , IsOpen(mesh.Kind(v) == VertexKind::Boundary)
    , IsKnown(mesh.Kind(v) != VertexKind::Irregular && mesh.Kind(v) != VertexKind::Isolated)
  {
  }

  /// Constructs the model of a virtual source, shifted to have the given distance at the vertex.
  CornerModel(const SurfaceMesh& mesh, Id v, const VirtualSource& source, double distance)
    : CornerModel(mesh, v, { distance - source.Length, source.Length, source.Angle })
  {
  }

  /// Returns the signed angle from the direction at polar angle `phi` to the direction of the
  /// source, radians, on the side with the smaller angle.
  double AngleFrom(double phi) const
  {
    const double angle = this->Angle - phi;
    if (this->IsOpen || 2.0 * std::abs(angle) <= this->Total)
    {
      return angle;
    }
    // Within one turn, the exact sum is bitwise equal to std::remainder and faster.
    return 2.0 * std::abs(angle) < 3.0 * this->Total ? angle - std::copysign(this->Total, angle)
                                                     : std::remainder(angle, this->Total);
  }

  /// The field along one direction.
  struct Ray
  {
    double Offset;
    double Length;
    double Bend; ///< 4 sin^2 of half the angle between this and the source direction

    double At(double rho) const
    {
      // Law of cosines, in a form that is accurate for small angles.
      const double difference = this->Length - rho;
      return this->Offset + std::sqrt(difference * difference + this->Length * rho * this->Bend);
    }
  };
  Ray Along(double phi) const
  {
    const double angle = (std::min)(Pi, std::abs(this->AngleFrom(phi))); // pi: through the vertex
    const double sine = std::sin(0.5 * angle);
    return { this->Offset, this->Length, 4.0 * sine * sine };
  }

  /// Returns the distance at polar coordinates (rho, phi).
  double At(double rho, double phi) const { return this->Along(phi).At(rho); }
};
}

#endif
