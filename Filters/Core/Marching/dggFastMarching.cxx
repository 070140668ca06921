// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFastMarching.h"

#include "dggDistanceHeap.h"
#include "dggMarchingTriangles.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dgg
{
namespace
{
/// How far beyond the end of a base a front may cross it, relative to the base: rounding, and what
/// it does to distances is of second order.
constexpr double CrossingSlack = 1e-9;
/// Vertices between two reports of progress.
constexpr Id VerticesPerReport = 1024;

/// How a vertex was reached.
struct Front
{
  double Distance = Infinity;
  double Offset = 0.0; ///< distance at the centre of the front
  double Angle = 0.0;  ///< polar angle towards it
  /// Which centre: a vertex where the front bent, or ~k for the k-th source.
  Id Centre = NoId;
  Id Source = NoId;
};

/// Where a front meets a triangle with its base on the axis, from the right end, and the apex
/// above.
struct Arrival
{
  double Distance = Infinity;
  Point2 From; ///< the direction from the apex towards the centre, of any length
};

/// From a centre at the distances a and b from the ends of the base.
bool MeetSpherical(double base, const Point2& apex, double a, double b, Arrival& arrival)
{
  if (!(base <= a + b) || std::abs(a - b) > base)
  {
    return false;
  }
  const Point2 above = LayOut(base, a, b);
  const Point2 centre{ above.X, -above.Y };
  const double slack = CrossingSlack * base;
  const double x = centre.Y < 0.0 ? Crossing(centre, apex) : centre.X;
  if (x < -slack || x > base + slack)
  {
    return false;
  }
  arrival.From = { centre.X - apex.X, centre.Y - apex.Y };
  arrival.Distance = Norm(arrival.From.X, arrival.From.Y);
  return true;
}

/// With a straight front that passes the ends of the base at the distances a and b.
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
  March(const SurfaceMesh& mesh, const MarchingTriangles& unfolded, MarchingUpdate update)
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
      front.Centre = ~source;
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

  /// False when stopped.
  bool Run(double radius, const ProgressCallback& progress)
  {
    Id finished = 0;
    const double count = std::max<Id>(1, this->Mesh.GetNumberOfVertices());
    while (!this->Heap.IsEmpty() && this->Heap.Top().Distance <= radius)
    {
      const DistanceHeap::Key top = this->Heap.Pop();
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
      this->WalkFrom(v, top.Distance);
      this->CrossFaces(v, top.Distance);
      for (const Id* i = this->Unfolded.Begin(v); i != this->Unfolded.End(v); ++i)
      {
        this->Cross(this->Unfolded.Get(*i), top.Distance);
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
      // Distances that are smaller than what is final already do not turn time back.
      this->Heap.Push(std::max(front.Distance, now), v);
    }
  }

  /// From a source in the face of h straight to the corners of the faces behind that edge: where it
  /// is close to the edge these are nearer than the ends of the edge.
  void LookAcross(Id h, const Point2& place, Front front)
  {
    for (Id t = this->Mesh.Twin(h); t != NoId && t != h; t = this->Mesh.Twin(t))
    {
      const bool isOpposed = this->Mesh.Origin(t) == this->Mesh.Destination(h);
      const Point2 image{ isOpposed ? this->Mesh.Length(h) - place.X : place.X, -place.Y };
      const Point2 apex{ this->Mesh.ApexX(t), this->Mesh.ApexY(t) };
      const double x = image.Y < 0.0 ? Crossing(image, apex) : image.X;
      if (x >= 0.0 && x <= this->Mesh.Length(h))
      {
        const Point2 toOrigin{ -apex.X, -apex.Y };
        const Point2 toImage{ image.X - apex.X, image.Y - apex.Y };
        front.Distance = front.Offset + Norm(toImage.X, toImage.Y);
        front.Angle = this->Mesh.PolarAngle(SurfaceMesh::Previous(t)) +
          std::atan2(dgg::Cross(toOrigin, toImage), Dot(toOrigin, toImage));
        this->Offer(this->Mesh.Apex(t), front, 0.0);
      }
    }
  }

  /// Whether a front that comes through the vertex starts anew from there.
  bool Bends(Id v) const
  {
    const VertexKind kind = this->Mesh.Kind(v);
    return kind == VertexKind::Saddle || kind == VertexKind::Boundary ||
      kind == VertexKind::Irregular;
  }

  /// Along the mesh edges of v.
  void WalkFrom(Id v, double now)
  {
    Front front = this->Fronts[v];
    const double distance = front.Distance;
    // A source at the vertex is the centre already.
    if (this->Bends(v) && distance > front.Offset)
    {
      front.Offset = distance;
      front.Centre = v;
    }
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      // Both edges of the face that meet at v, as their other ends see them.
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

  /// Through the faces of v to their third corners.
  void CrossFaces(Id v, double now)
  {
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      this->Cross(MarchingTriangles::FromFace(this->Mesh, SurfaceMesh::Next(*g)), now);
      this->Cross(MarchingTriangles::FromFace(this->Mesh, SurfaceMesh::Previous(*g)), now);
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
      return; // two fronts that have nothing to do with each other
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
      return; // walks along the edges take its place
    }
    Front front = older;
    front.Source = right.Distance <= left.Distance ? right.Source : left.Source;
    front.Distance = older.Offset + arrival.Distance;
    if (!(front.Distance < this->Fronts[triangle.Apex].Distance))
    {
      return;
    }
    // From the direction of the right end counter-clockwise to that of the centre.
    const Point2 toRight{ -apex.X, -apex.Y };
    front.Angle = triangle.Direction +
      std::atan2(dgg::Cross(toRight, arrival.From), Dot(toRight, arrival.From));
    this->Offer(triangle.Apex, front, now);
  }

  const SurfaceMesh& Mesh;
  const MarchingTriangles& Unfolded;
  MarchingUpdate Update;
  std::vector<Front> Fronts;
  std::vector<std::uint8_t> IsFinal;
  DistanceHeap Heap;
};
}

FastMarching::FastMarching(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Unfolded(std::make_unique<MarchingTriangles>(mesh))
{
}

FastMarching::~FastMarching() = default;

Status FastMarching::Run(const std::vector<GeodesicSource>& sources, const MarchingOptions& options,
  MarchingResult& result) const
{
  result = MarchingResult();
  Status status = CheckSources(this->Mesh, sources);
  if (!status.IsOk())
  {
    return status;
  }
  if (std::isnan(options.MaximumDistance))
  {
    return Status::Invalid("the maximum distance is not a number");
  }
  // Distances are measured from the least initial one, so that the largest ones do not decide on
  // rounding.
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
    result.Virtual.Offsets.assign(n, Infinity);
    result.Virtual.Lengths.assign(n, Infinity);
    result.Virtual.Angles.assign(n, 0.0);
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
      result.Virtual.Offsets[v] = front.Offset + shift;
      result.Virtual.Lengths[v] = front.Distance - front.Offset;
      result.Virtual.Angles[v] = front.Angle;
    }
  }
  return Status::Success();
}

std::size_t FastMarching::GetMemorySize() const
{
  return this->Unfolded->GetMemorySize();
}
}
