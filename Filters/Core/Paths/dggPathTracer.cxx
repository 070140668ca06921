// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathTracer.h"

#include "dggStripUnfolding.h"
#include "dggSurfacePath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
/// Half the opening angle of a cone, radians. Floats below 8 have a rounding error of 2.4e-7,
/// floats below 32 (saddles of five turns) of 1e-6.
constexpr double HalfWidths[] = { 1.5e-6, 1e-4 };
constexpr double RefinedHalfWidth = 1e-12;
/// Tolerances of lengths, which are floats as well: relative to the length, and relative to the
/// longest edge, because tiny edges next to long ones have the rounding errors of the long edges.
constexpr double RelativeLength = 1e-6;
constexpr double RelativeRounding = 1e-14;
/// Maximum number of windows before the next face of the tail is tried; growth factor of that limit
/// if the head was found in no face; and its upper bounds, per face of the mesh and absolute. A
/// shortest path crosses no face twice: beyond this limit the cone circulates, or is split
/// repeatedly, among nearly degenerate triangles.
constexpr std::size_t FewBeams = 4096;
constexpr std::size_t Growth = 8;
constexpr std::size_t BeamsPerFace = 4;
constexpr std::size_t MostBeams = 1000000;
}

double GraphEdgeTracer::GetTolerance(double length) const
{
  return RelativeLength * length + RelativeRounding * this->Mesh.GetMaximumEdgeLength();
}

bool GraphEdgeTracer::Trace(
  const GraphEdge& edge, Id& firstFace, std::vector<EdgeCrossing>& crossings)
{
  this->NumberOfBeams = 0;
  for (const double halfWidth : HalfWidths)
  {
    if (this->TraceBeam(edge, halfWidth, firstFace, crossings))
    {
      if (this->IsSplit)
      {
        this->Refine(edge, firstFace, crossings);
      }
      return true;
    }
  }
  return false;
}

/// Traces the edge again, now that the direction is known exactly: a cone that contains vertices
/// before the head may have passed a vertex close to the line on the wrong side.
void GraphEdgeTracer::Refine(
  const GraphEdge& edge, Id& firstFace, std::vector<EdgeCrossing>& crossings)
{
  GraphEdge exact = edge;
  exact.Angle = this->Arrival;
  Id face = NoId;
  std::vector<EdgeCrossing> refined;
  if (this->TraceBeam(exact, RefinedHalfWidth, face, refined))
  {
    firstFace = face;
    crossings.swap(refined);
  }
}

bool GraphEdgeTracer::TraceBeam(
  const GraphEdge& edge, double halfWidth, Id& firstFace, std::vector<EdgeCrossing>& crossings)
{
  crossings.clear();
  const std::size_t faces = static_cast<std::size_t>(this->Mesh.GetNumberOfFaces());
  const std::size_t most = std::min(MostBeams, std::max(FewBeams, BeamsPerFace * faces));
  for (this->Limit = FewBeams;; this->Limit = std::min(most, Growth * this->Limit))
  {
    bool isCut = false;
    for (const Id* g = this->Mesh.FanBegin(edge.Tail); g != this->Mesh.FanEnd(edge.Tail); ++g)
    {
      const double angle = this->AngleFrom(edge, *g, halfWidth);
      if (std::isnan(angle))
      {
        continue;
      }
      if (this->TraceFrom(edge, *g, angle, halfWidth))
      {
        firstFace = SurfaceMesh::Face(*g);
        for (Id i = this->Found; i != NoId; i = this->Beams[i].Before)
        {
          crossings.push_back(this->Beams[i].Crossing);
        }
        std::reverse(crossings.begin(), crossings.end());
        return true;
      }
      isCut = isCut || this->Beams.size() >= this->Limit;
    }
    if (!isCut || this->Limit == most)
    {
      return false;
    }
  }
}

/// Returns the direction of an edge, measured from an outgoing half-edge of its tail; NaN if the
/// cone misses the face of the half-edge.
double GraphEdgeTracer::AngleFrom(const GraphEdge& edge, Id g, double halfWidth) const
{
  const double turn =
    this->Mesh.Kind(edge.Tail) == VertexKind::Boundary ? 0.0 : this->Mesh.TotalAngle(edge.Tail);
  const double angle = edge.Angle - this->Mesh.PolarAngle(g);
  const double corner = this->Mesh.CornerAngle(g);
  for (const double candidate : { angle, angle - turn, angle + turn })
  {
    if (candidate >= -halfWidth && candidate <= corner + halfWidth)
    {
      return candidate;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Traces through the face of the outgoing half-edge g, whose frame becomes the frame of the plane.
bool GraphEdgeTracer::TraceFrom(const GraphEdge& edge, Id g, double angle, double halfWidth)
{
  this->Beams.clear();
  this->Found = NoId;
  // Close to an edge of the tail, the line may also start on the other side of the edge.
  this->IsSplit = angle < halfWidth || angle > this->Mesh.CornerAngle(g) - halfWidth;
  this->Rays[0] = { std::cos(angle + halfWidth), std::sin(angle + halfWidth) };
  this->Rays[1] = { std::cos(angle - halfWidth), std::sin(angle - halfWidth) };
  std::array<double, 3> barycentric{};
  if (FindInFace(this->Mesh, edge.Head, SurfaceMesh::Face(g), barycentric))
  {
    const Point2 head = PlaceInFrame(this->Mesh, g, barycentric);
    if (std::abs(Norm(head.X, head.Y) - edge.Length) <= this->GetTolerance(edge.Length))
    {
      this->IsSplit = false;
      return true;
    }
  }
  const FaceUnfolding face = EnteredFace(this->Mesh, g).Plane;
  this->Cross(SurfaceMesh::Next(g), false, face.GetApex(),
    { face.GetRightCosine(), -face.GetRightSine() }, NoId);
  // Breadth-first, so that a circulating window does not block others.
  for (Id index = 0; static_cast<std::size_t>(index) < std::min(this->Beams.size(), this->Limit);
       ++index)
  {
    ++this->NumberOfBeams;
    Point2 arrival;
    if (this->Reaches(edge, this->Beams[index], arrival))
    {
      this->Arrival = this->Mesh.PolarAngle(g) + std::atan2(arrival.Y, arrival.X);
      this->Found = index;
      return true;
    }
    this->Continue(edge, index);
  }
  return false;
}

/// Enters all faces behind an edge.
void GraphEdgeTracer::Cross(
  Id exit, bool mirrored, const Point2& left, const Point2& axis, Id before)
{
  ForEachFaceBehind(this->Mesh, exit, mirrored, [&](Id e, bool isMirrored) {
    this->Beams.push_back({ { exit, e }, isMirrored, left, axis, before });
  });
}

/// Returns true if the head lies in the face that is entered, in the cone and at the right
/// distance.
bool GraphEdgeTracer::Reaches(const GraphEdge& edge, const Beam& beam, Point2& arrival) const
{
  const Id h = beam.Crossing.Entry;
  std::array<double, 3> barycentric{};
  if (!FindInFace(this->Mesh, edge.Head, SurfaceMesh::Face(h), barycentric))
  {
    return false;
  }
  const Point2 place =
    PlaceInEntered(this->Mesh, h, beam.IsMirrored, PlaceInFrame(this->Mesh, h, barycentric));
  const Point2 p = arrival = FromFrame(beam.Left, beam.Axis, place);
  return std::abs(Norm(p.X, p.Y) - edge.Length) <= this->GetTolerance(edge.Length) &&
    dgg::Cross(p, this->Rays[0]) >= 0.0 && dgg::Cross(this->Rays[1], p) >= 0.0;
}

void GraphEdgeTracer::Continue(const GraphEdge& edge, Id index)
{
  const Beam beam = this->Beams[index];
  const Id h = beam.Crossing.Entry;
  const EnteredFace entered(this->Mesh, h, beam.IsMirrored);
  const FaceUnfolding& face = entered.Plane;
  const Point2 apex = FromFrame(beam.Left, beam.Axis, face.GetApex());
  const double farEnough = edge.Length + this->GetTolerance(edge.Length);
  const auto isNear = [&](const Point2& start, const Point2& axis, double length) {
    // Distance from the tail to the edge.
    const double t = std::min(length, std::max(0.0, -Dot(start, axis)));
    return Norm(start.X + t * axis.X, start.Y + t * axis.Y) <= farEnough;
  };
  const bool goesLeft =
    dgg::Cross(apex, this->Rays[0]) > 0.0; // the left ray passes left of the apex
  const bool goesRight = dgg::Cross(this->Rays[1], apex) > 0.0;
  this->IsSplit = this->IsSplit || (goesLeft && goesRight);
  if (goesLeft)
  {
    const Point2 axis = Turned(beam.Axis, { face.GetLeftCosine(), face.GetLeftSine() });
    if (isNear(beam.Left, axis, face.GetLeft()))
    {
      this->Cross(entered.LeftEdge, beam.IsMirrored, beam.Left, axis, index);
    }
  }
  if (goesRight)
  {
    const Point2 axis = Turned(beam.Axis, { face.GetRightCosine(), -face.GetRightSine() });
    if (isNear(apex, axis, face.GetRight()))
    {
      this->Cross(entered.RightEdge, beam.IsMirrored, apex, axis, index);
    }
  }
}

Status PathTracer::Append(const GraphEdge& edge, bool isBackwards)
{
  Strip strip;
  strip.Start = SurfacePoint::AtVertex(edge.Tail);
  strip.End = edge.Head;
  if (!this->Tracer.Trace(edge, strip.FirstFace, strip.Crossings))
  {
    ++this->NumberOfFallbacks;
    SurfacePath path;
    if (!this->FindExactly(isBackwards ? strip.End : strip.Start,
          isBackwards ? strip.Start : strip.End, edge.Length, path))
    {
      return Status(Status::Code::DamagedGraph,
        JoinText(
          "An edge of the graph, from vertex ", edge.Tail, ", cannot be traced on the surface"))
        .Fix("Build the graph again for this mesh");
    }
    this->Chain.Append(path);
    return Status::Success();
  }
  if (isBackwards)
  {
    strip.FirstFace = strip.LastFace();
    std::swap(strip.Start, strip.End);
    Reverse(strip.Crossings);
  }
  this->Chain.Append(strip);
  return Status::Success();
}

Status PathTracer::Append(const SurfacePoint& from, const SurfacePoint& to, double length)
{
  SurfacePath path;
  Id shared = NoId;
  ForEachFaceAround(this->Mesh, from, [&](Id f, const std::array<double, 3>& p) {
    std::array<double, 3> q{};
    if (FindInFace(this->Mesh, to, f, q) && DistanceInFace(this->Mesh, f, p, q) <= length)
    {
      shared = f;
    }
  });
  if (shared != NoId)
  {
    path.Points = { from, to };
    path.Faces = { shared };
  }
  else if (!this->FindExactly(from, to, length, path))
  {
    return InvalidInput(
      "The straight line of length ", length, " between two surface points cannot be traced")
      .Fix("Build the graph again for this mesh");
  }
  this->Chain.Append(path);
  return Status::Success();
}

/// Finds the exact path. Returns false if there is none within the length.
bool PathTracer::FindExactly(
  const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path)
{
  if (!this->Exact)
  {
    this->Exact = std::make_unique<ExactPathFinder>(this->Mesh);
  }
  std::vector<SurfacePath> found;
  const Status status = this->Exact->Find(
    from, { to }, ProgressCallback(), found, length + this->Tracer.GetTolerance(length));
  if (!status.IsOk() || found.front().IsEmpty())
  {
    return false;
  }
  path = std::move(found.front());
  return true;
}
}
