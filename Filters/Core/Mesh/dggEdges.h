// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edges, for which a mesh stores half-edges only: the faces behind an edge, and neighbors along
/// edges.
#ifndef dggEdges_h
#define dggEdges_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <algorithm> // for std::min
#include <array>     // for corners
#include <cmath>     // for std::atan2
#include <cstdint>   // for sums

namespace dgg
{
/// Calls `visit(e)` for the other half-edges of the edge of h: none on the boundary, one on a
/// manifold edge. `surface` is a SurfaceMesh or has half-edges like one.
template <typename Surface, typename Visitor>
void ForEachTwin(const Surface& surface, Id h, Visitor&& visit)
{
  for (Id e = surface.Twin(h); e != NoId && e != h; e = surface.Twin(e))
  {
    visit(e);
  }
}

/// Calls `visit(e)` for h and the other half-edges of its edge.
template <typename Surface, typename Visitor>
void ForEachHalfEdge(const Surface& surface, Id h, Visitor&& visit)
{
  visit(h);
  ForEachTwin(surface, h, visit);
}

/// Returns the smallest half-edge of the edge of h, which represents the edge.
template <typename Surface>
Id FindEdge(const Surface& surface, Id h)
{
  Id smallest = h;
  ForEachTwin(surface, h, [&](Id e) { smallest = (std::min)(smallest, e); });
  return smallest;
}

/// Sum of lengths of edges that does not depend on their order: lengths are rounded to multiples of
/// the last bit of the longest one.
class LengthSum
{
public:
  /// `longest` must be the same for sums that are added.
  explicit LengthSum(double longest = 0.0)
    : UnitsPerLength(longest > 0.0 ? std::exp2(51 - std::ilogb(longest)) : 0.0)
  {
  }

  /// Adds a length if it counts.
  void Add(double length, bool counts = true)
  {
    const auto units =
      counts ? static_cast<std::int64_t>(length * this->UnitsPerLength + 0.5) : std::int64_t(0);
    this->High += units >> LowBits;
    this->Low += units & ((std::int64_t(1) << LowBits) - 1);
    this->Count += counts ? 1 : 0;
  }
  void Add(const LengthSum& other)
  {
    this->High += other.High;
    this->Low += other.Low;
    this->Count += other.Count;
  }
  /// Returns the mean; 0 without edges.
  double GetMean() const
  {
    const double units =
      std::ldexp(static_cast<double>(this->High), LowBits) + static_cast<double>(this->Low);
    return this->Count > 0 && this->UnitsPerLength > 0.0
      ? units / this->UnitsPerLength / static_cast<double>(this->Count)
      : 0.0;
  }

private:
  static constexpr int LowBits = 26;

  double UnitsPerLength;
  std::int64_t High = 0;
  std::int64_t Low = 0;
  Offset Count = 0;
};

/// Calls `visit(e, isMirrored)` for the half-edges through which the faces behind half-edge `exit`
/// are entered. All faces are laid out in one plane. A face is mirrored if its orientation differs
/// from that of the plane, in which the face of `exit` itself may be mirrored.
template <typename Visitor>
void ForEachFaceBehind(const SurfaceMesh& mesh, Id exit, bool isExitMirrored, Visitor&& visit)
{
  ForEachTwin(mesh, exit,
    [&](Id e) { visit(e, (mesh.Origin(e) == mesh.Destination(exit)) == isExitMirrored); });
}

/// Returns a position in the frame of the face that is entered through h, given in the frame of h.
inline Point2 PlaceInEntered(const SurfaceMesh& mesh, Id h, bool isMirrored, const Point2& place)
{
  return { isMirrored ? mesh.Length(h) - place.X : place.X, place.Y };
}

/// A face laid out above half-edge h, through which the face is entered, or the mirror image of the
/// face.
struct EnteredFace
{
  EnteredFace(const SurfaceMesh& mesh, Id h, bool isMirrored = false)
    : LeftEdge(isMirrored ? SurfaceMesh::Next(h) : SurfaceMesh::Previous(h))
    , RightEdge(isMirrored ? SurfaceMesh::Previous(h) : SurfaceMesh::Next(h))
    , Plane(mesh.Length(h),
        // Length - ApexX would be inaccurate for needles.
        { isMirrored ? FootOnEdge(mesh.Length(h), mesh.Length(LeftEdge), mesh.Length(RightEdge))
                     : mesh.ApexX(h),
          mesh.ApexY(h) },
        mesh.Length(LeftEdge), mesh.Length(RightEdge))
  {
  }

  Id LeftEdge;
  Id RightEdge;
  FaceUnfolding Plane;
};

/// Returns the apex of the face of h in the frame of h.
inline Point2 ApexOf(const SurfaceMesh& mesh, Id h)
{
  return { mesh.ApexX(h), mesh.ApexY(h) };
}

/// Returns the corners of the face of h in the frame of h, from the origin of h on.
inline std::array<Point2, 3> CornersInFrame(const SurfaceMesh& mesh, Id h)
{
  return { { { 0.0, 0.0 }, { mesh.Length(h), 0.0 }, ApexOf(mesh, h) } };
}

/// Returns the polar angle, at the apex of the face of h, of a direction given in the frame of h,
/// radians.
inline double PolarAngleAtApex(const SurfaceMesh& mesh, Id h, const Point2& direction)
{
  // The reference direction of the corner is the edge from the apex to the origin of h.
  const Point2 reference{ -mesh.ApexX(h), -mesh.ApexY(h) };
  return mesh.PolarAngle(SurfaceMesh::Previous(h)) +
    std::atan2(Cross(reference, direction), Dot(reference, direction));
}

/// Calls `visit(neighbor, length, angle)` for the edges of a vertex (once each for a regular
/// vertex): the other end, the length, and the polar angle of the edge at the vertex.
template <typename Visitor>
void ForEachNeighbor(const SurfaceMesh& mesh, Id v, Visitor&& visit)
{
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    visit(mesh.Destination(*g), mesh.Length(*g), mesh.PolarAngle(*g));
    const Id incoming = SurfaceMesh::Previous(*g);
    if (mesh.Twin(incoming) == NoId)
    {
      visit(
        mesh.Origin(incoming), mesh.Length(incoming), mesh.PolarAngle(*g) + mesh.CornerAngle(*g));
    }
  }
}
}

#endif
