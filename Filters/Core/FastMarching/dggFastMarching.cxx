// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFastMarching.h"

#include "dggEdges.h"
#include "dggHeap.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dgg
{
namespace
{
/// Maximum number of faces in a strip. Longer strips are needed only among many slivers.
constexpr int LongestStrip = 100;

/// The current edge of a strip that starts at a corner, the origin of the plane.
struct StripEdge
{
  Point2 Right;
  Point2 Left;
  Id RightVertex;
  Id LeftVertex;
};
}

/// A triangle through which a front may reach its apex: a face, or an unfolded triangle across
/// several faces. Seen from the apex, `Left` follows `Right` counter-clockwise.
struct MarchingTriangle
{
  Id Apex;
  Id Right;
  Id Left;
  double Base;      ///< from Right to Left
  double ToRight;   ///< from the apex to Right
  double ToLeft;    ///< from the apex to Left
  double Direction; ///< polar angle at the apex towards Right
};

/// For every obtuse corner of a mesh, the triangles between the corner and a vertex beyond the
/// opposite edge, in the plane of the face, chosen so that they are not obtuse at the corner
/// (Kimmel and Sethian 1998, section 4). Each triangle is found by unfolding a strip of faces,
/// which fails at the boundary and if no vertex splits the angle. Across a non-manifold edge there
/// is one strip per face.
class UnfoldedTriangles
{
public:
  explicit UnfoldedTriangles(const SurfaceMesh& mesh);

  /// Returns the triangle of the corner at the origin of a half-edge.
  static MarchingTriangle FromFace(const SurfaceMesh& mesh, Id h);

  /// Returns the range of the triangles that have the vertex at one end of the base.
  const Id* Begin(Id vertex) const { return this->ByVertex.data() + this->Offsets[vertex]; }
  const Id* End(Id vertex) const { return this->ByVertex.data() + this->Offsets[vertex + 1]; }
  const MarchingTriangle& Get(Id i) const { return this->Triangles[i]; }

private:
  void Split(const SurfaceMesh& mesh, Id h);

  std::vector<MarchingTriangle> Triangles;
  std::vector<Offset> Offsets;
  std::vector<Id> ByVertex;
};

MarchingTriangle UnfoldedTriangles::FromFace(const SurfaceMesh& mesh, Id h)
{
  const Id next = SurfaceMesh::Next(h);
  const Id previous = SurfaceMesh::Previous(h);
  return { mesh.Origin(h), mesh.Origin(next), mesh.Origin(previous), mesh.Length(next),
    mesh.Length(h), mesh.Length(previous), mesh.PolarAngle(h) };
}

UnfoldedTriangles::UnfoldedTriangles(const SurfaceMesh& mesh)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && mesh.ApexX(h) < 0.0)
    {
      this->Split(mesh, h);
    }
  }
  this->Offsets.assign(static_cast<std::size_t>(mesh.GetNumberOfVertices()) + 1, 0);
  for (const MarchingTriangle& triangle : this->Triangles)
  {
    ++this->Offsets[triangle.Right + 1];
    ++this->Offsets[triangle.Left + 1];
  }
  for (std::size_t v = 1; v < this->Offsets.size(); ++v)
  {
    this->Offsets[v] += this->Offsets[v - 1];
  }
  this->ByVertex.resize(static_cast<std::size_t>(this->Offsets.back()));
  std::vector<Offset> fill(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    this->ByVertex[fill[this->Triangles[i].Right]++] = static_cast<Id>(i);
    this->ByVertex[fill[this->Triangles[i].Left]++] = static_cast<Id>(i);
  }
}

void UnfoldedTriangles::Split(const SurfaceMesh& mesh, Id h)
{
  const Id next = SurfaceMesh::Next(h);
  const Point2 right{ mesh.Length(h), 0.0 };
  const Point2 left{ mesh.ApexX(h), mesh.ApexY(h) };
  // Returns true if a direction leaves no obtuse angle: at most pi/2 from both sides.
  const auto splits = [&](const Point2& p) {
    return Dot(p, right) >= 0.0 && Dot(p, left) >= 0.0 && Cross(right, p) > 0.0 &&
      Cross(p, left) > 0.0;
  };
  const StripEdge start{ right, left, mesh.Origin(next), mesh.Destination(next) };
  ForEachTwin(mesh, next, [&](Id first) {
    StripEdge edge = start;
    Id entered = first;
    for (int step = 0; step < LongestStrip && entered != NoId; ++step)
    {
      // The frame of the strip edge is directed from Right to Left.
      const bool isMirrored =
        mesh.Origin(entered) == edge.LeftVertex && mesh.Destination(entered) == edge.RightVertex;
      const EnteredFace face(mesh, entered, isMirrored);
      const double length = mesh.Length(entered);
      const Point2 axis{ (edge.Left.X - edge.Right.X) / length,
        (edge.Left.Y - edge.Right.Y) / length };
      // The apex lies on the right side of the axis, away from the corner.
      const Point2& above = face.Plane.GetApex();
      const Point2 apex = FromFrame(edge.Right, axis, { above.X, -above.Y });
      const Id vertex = mesh.Apex(entered);
      if (splits(apex))
      {
        const double distance = Norm(apex.X, apex.Y);
        const double direction = mesh.PolarAngle(h);
        this->Triangles.push_back({ mesh.Origin(h), start.RightVertex, vertex,
          Distance(apex, right), Norm(right.X, right.Y), distance, direction });
        this->Triangles.push_back({ mesh.Origin(h), vertex, start.LeftVertex, Distance(apex, left),
          distance, Norm(left.X, left.Y), direction + std::atan2(apex.Y, apex.X) });
        break;
      }
      // Leave the face through the edge that the allowed directions cross.
      const bool isLeft =
        Dot(apex, left) < 0.0 || Cross(right, apex) <= 0.0; // passes left of the apex
      const Id exit = isLeft ? face.RightEdge : face.LeftEdge;
      if (isLeft)
      {
        edge.Right = apex;
        edge.RightVertex = vertex;
      }
      else
      {
        edge.Left = apex;
        edge.LeftVertex = vertex;
      }
      const Id twin = mesh.Twin(exit);
      // Strips cross manifold edges only.
      entered = twin != NoId && mesh.Twin(twin) == exit ? twin : NoId;
    }
  });
}

namespace
{
/// Tolerance by which a front may cross beyond the end of a base, relative to the base; covers
/// rounding, with an effect of second order on distances.
constexpr double CrossingSlack = 1e-9;
/// Vertices between two progress reports.
constexpr Id VerticesPerReport = 1024;

/// The front that reached a vertex.
struct Front
{
  double Distance = Infinity;
  double Offset = 0.0; ///< distance at the center of the front
  double Angle = 0.0;  ///< polar angle towards the center
  /// Center: a vertex where the front bent, or ~k for the k-th source.
  Id Center = NoId;
  Id Source = NoId;
};

/// Arrival of a front at the apex of a triangle. The base lies on the x axis and starts at its
/// right end; the apex lies above.
struct Arrival
{
  double Distance = Infinity;
  Point2 From; ///< direction from the apex towards the center, not normalized
};

/// Computes the arrival from a center at the distances a and b from the ends of the base. Returns
/// false if the front does not reach the apex through the base.
bool MeetSpherical(double base, const Point2& apex, double a, double b, Arrival& arrival)
{
  if (!(base <= a + b) || std::abs(a - b) > base)
  {
    return false;
  }
  const Point2 above = LayOut(base, a, b);
  const Point2 center{ above.X, -above.Y };
  const double slack = CrossingSlack * base;
  const double x = center.Y < 0.0 ? Crossing(center, apex) : center.X;
  if (x < -slack || x > base + slack)
  {
    return false;
  }
  arrival.From = { center.X - apex.X, center.Y - apex.Y };
  arrival.Distance = Norm(arrival.From.X, arrival.From.Y);
  return true;
}

/// Computes the arrival of a planar front with the distances a and b at the ends of the base.
/// Returns false if the front does not reach the apex through the base.
bool MeetPlanar(double base, const Point2& apex, double a, double b, Arrival& arrival)
{
  const double slope = (b - a) / base;
  if (!(std::abs(slope) < 1.0))
  {
    return false;
  }
  const double rise = std::sqrt((1.0 - slope) * (1.0 + slope));
  const double x = apex.X - apex.Y * slope / rise;
  const double slack = CrossingSlack * base;
  if (x < -slack || x > base + slack)
  {
    return false;
  }
  arrival.From = { -slope, -rise };
  arrival.Distance = a + slope * apex.X + rise * apex.Y;
  return true;
}

/// One march.
class March
{
public:
  March(const SurfaceMesh& mesh, const UnfoldedTriangles& unfolded, MarchingUpdate update)
    : Mesh(mesh)
    , Unfolded(unfolded)
    , Update(update)
    , Fronts(mesh.GetNumberOfVertices())
    , IsFinal(mesh.GetNumberOfVertices(), 0)
  {
  }

  void Start(const std::vector<GeodesicSource>& sources, double shift)
  {
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      const auto source = static_cast<Id>(k);
      const SurfacePoint& point = sources[k].Point;
      Front front;
      front.Offset = sources[k].InitialDistance - shift;
      front.Center = ~source;
      front.Source = source;
      if (point.On == SurfacePoint::Support::Vertex)
      {
        front.Distance = front.Offset;
        this->Offer(point.Vertex, front, 0.0);
        continue;
      }
      ForEachFaceAround(this->Mesh, point, [&](Id f, const std::array<double, 3>& b) {
        for (Id h = 3 * f; h < 3 * f + 3; ++h)
        {
          const Point2 place = PlaceInFrame(this->Mesh, h, b);
          front.Distance = front.Offset + DistanceToCorner(this->Mesh, f, b, h % 3);
          front.Angle = this->Mesh.PolarAngle(h) + std::atan2(place.Y, place.X);
          this->Offer(this->Mesh.Origin(h), front, 0.0);
          this->LookAcross(h, place, front);
        }
      });
    }
  }

  /// Marches up to a radius. Returns false if stopped.
  bool Run(double radius, const ProgressCallback& progress)
  {
    Id finished = 0;
    const double count = std::max<Id>(1, this->Mesh.GetNumberOfVertices());
    while (!this->Heap.IsEmpty() && this->Heap.Top().Key <= radius)
    {
      const DistanceHeap::Entry top = this->Heap.Pop();
      const Id v = top.Index;
      if (this->IsFinal[v])
      {
        continue;
      }
      if (progress && finished % VerticesPerReport == 0 && !progress(finished / count))
      {
        return false;
      }
      ++finished;
      this->IsFinal[v] = 1;
      this->WalkFrom(v, top.Key);
      this->CrossFaces(v, top.Key);
      for (const Id* i = this->Unfolded.Begin(v); i != this->Unfolded.End(v); ++i)
      {
        this->Cross(this->Unfolded.Get(*i), top.Key);
      }
    }
    return true;
  }

  bool IsReached(Id v, double radius) const
  {
    return this->IsFinal[v] && this->Fronts[v].Distance <= radius;
  }
  const Front& Get(Id v) const { return this->Fronts[v]; }

private:
  void Offer(Id v, const Front& front, double now)
  {
    if (!this->IsFinal[v] && front.Distance < this->Fronts[v].Distance)
    {
      this->Fronts[v] = front;
      // The key is at least the current distance, so that the order of the queue is kept.
      this->Heap.Push(std::max(front.Distance, now), v);
    }
  }

  /// Updates the corners of the faces behind edge h from a source in the face of h, by straight
  /// lines. For a source close to the edge, these corners may be nearer than the ends of the edge.
  void LookAcross(Id h, const Point2& place, Front front)
  {
    ForEachFaceBehind(this->Mesh, h, false, [&](Id t, bool isMirrored) {
      const Point2 image{ isMirrored ? place.X : this->Mesh.Length(h) - place.X, -place.Y };
      const Point2 apex = ApexOf(this->Mesh, t);
      const double x = image.Y < 0.0 ? Crossing(image, apex) : image.X;
      if (x >= 0.0 && x <= this->Mesh.Length(h))
      {
        const Point2 toImage = Difference(image, apex);
        front.Distance = front.Offset + Norm(toImage.X, toImage.Y);
        front.Angle = PolarAngleAtApex(this->Mesh, t, toImage);
        this->Offer(this->Mesh.Apex(t), front, 0.0);
      }
    });
  }

  /// Returns true if a front that passes the vertex restarts at the vertex.
  bool Bends(Id v) const
  {
    const VertexKind kind = this->Mesh.Kind(v);
    return kind == VertexKind::Saddle || kind == VertexKind::Boundary ||
      kind == VertexKind::Irregular;
  }

  /// Propagates along the mesh edges of v.
  void WalkFrom(Id v, double now)
  {
    Front front = this->Fronts[v];
    const double distance = front.Distance;
    // A source at the vertex is already the center of the front.
    if (this->Bends(v) && distance > front.Offset)
    {
      front.Offset = distance;
      front.Center = v;
    }
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      // Both edges of the face at v are used, in the directions seen from their other ends.
      const Id next = SurfaceMesh::Next(*g);
      const Id previous = SurfaceMesh::Previous(*g);
      front.Distance = distance + this->Mesh.Length(*g);
      front.Angle = this->Mesh.PolarAngle(next) + this->Mesh.CornerAngle(next);
      this->Offer(this->Mesh.Origin(next), front, now);
      front.Distance = distance + this->Mesh.Length(previous);
      front.Angle = this->Mesh.PolarAngle(previous);
      this->Offer(this->Mesh.Origin(previous), front, now);
    }
  }

  /// Propagates through the faces of v to their third corners.
  void CrossFaces(Id v, double now)
  {
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      this->Cross(UnfoldedTriangles::FromFace(this->Mesh, SurfaceMesh::Next(*g)), now);
      this->Cross(UnfoldedTriangles::FromFace(this->Mesh, SurfaceMesh::Previous(*g)), now);
    }
  }

  void Cross(const MarchingTriangle& triangle, double now)
  {
    if (!this->IsFinal[triangle.Right] || !this->IsFinal[triangle.Left] ||
      this->IsFinal[triangle.Apex])
    {
      return;
    }
    const Front& right = this->Fronts[triangle.Right];
    const Front& left = this->Fronts[triangle.Left];
    if (right.Source != left.Source && right.Offset != left.Offset)
    {
      return; // two unrelated fronts
    }
    const Front& older = left.Offset < right.Offset ? left : right;
    const Point2 apex = LayOut(triangle.Base, triangle.ToRight, triangle.ToLeft);
    Arrival arrival;
    const double a = right.Distance - older.Offset;
    const double b = left.Distance - older.Offset;
    const bool meets = this->Update == MarchingUpdate::Spherical
      ? MeetSpherical(triangle.Base, apex, a, b, arrival)
      : MeetPlanar(triangle.Base, apex, a, b, arrival);
    if (!meets)
    {
      return; // replaced by propagation along the edges
    }
    Front front = older;
    front.Source = right.Distance <= left.Distance ? right.Source : left.Source;
    front.Distance = older.Offset + arrival.Distance;
    if (!(front.Distance < this->Fronts[triangle.Apex].Distance))
    {
      return;
    }
    // Angle from the direction of the right end counter-clockwise to the direction of the center.
    const Point2 toRight{ -apex.X, -apex.Y };
    front.Angle = triangle.Direction +
      std::atan2(dgg::Cross(toRight, arrival.From), Dot(toRight, arrival.From));
    this->Offer(triangle.Apex, front, now);
  }

  const SurfaceMesh& Mesh;
  const UnfoldedTriangles& Unfolded;
  MarchingUpdate Update;
  std::vector<Front> Fronts;
  std::vector<std::uint8_t> IsFinal;
  DistanceHeap Heap;
};
}

FastMarching::FastMarching(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Unfolded(std::make_unique<UnfoldedTriangles>(mesh))
{
}

FastMarching::~FastMarching() = default;

Status FastMarching::Run(const std::vector<GeodesicSource>& sources, const MarchingOptions& options,
  MarchingResult& result) const
{
  result = MarchingResult();
  DGG_RETURN_IF_ERROR(CheckSources(this->Mesh, sources));
  if (std::isnan(options.MaximumDistance))
  {
    return InvalidValue("MaximumDistance", options.MaximumDistance).Fix("Use a number or infinity");
  }
  // Distances are measured relative to the smallest initial one, so that large initial distances do
  // not cause rounding errors.
  double shift = Infinity;
  for (const GeodesicSource& source : sources)
  {
    shift = std::min(shift, source.InitialDistance);
  }
  const double radius = options.MaximumDistance - shift;
  March march(this->Mesh, *this->Unfolded, options.Update);
  march.Start(sources, shift);
  if (!march.Run(radius, options.Progress))
  {
    return Status::Abort();
  }
  const auto n = static_cast<std::size_t>(this->Mesh.GetNumberOfVertices());
  result.Distances.assign(n, Infinity);
  result.NearestSource.assign(n, NoId);
  if (options.WantVirtualSource)
  {
    result.Virtual.assign(n, {});
  }
  for (std::size_t v = 0; v < n; ++v)
  {
    if (!march.IsReached(static_cast<Id>(v), radius))
    {
      continue;
    }
    const Front& front = march.Get(static_cast<Id>(v));
    result.Distances[v] = front.Distance + shift;
    result.NearestSource[v] = front.Source;
    if (options.WantVirtualSource)
    {
      result.Virtual[v] = { front.Offset + shift, front.Distance - front.Offset, front.Angle };
    }
  }
  return Status::Success();
}
}
