// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggOffsetCurves.h"

#include "dggEdgeSplitting.h"
#include "dggEdges.h"
#include "dggExactGeodesics.h"
#include "dggProgressPart.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace dgg
{
namespace
{
/// Points on the path are this close to each other, as a fraction of half of the width: their
/// distance differs from that of the path by up to its square, by 8.
constexpr double Spacing = 9e-3;
/// Points on a path, at most.
constexpr double MostSources = 1e5;
/// Edges that a rim may cross are no longer than this, as a fraction of half of the width: the
/// pieces of an arc then are shorter than it by up to the square of this, by 24. Those beside a
/// corner of a rim, which it may cut off, are shorter by far.
constexpr double LongestEdge = 0.2;
constexpr double LongestEdgeAtCorner = 0.003;
/// Turns of a rim beyond that of an arc, in radians, that count as corners.
constexpr double CornerTurn = 0.25;
/// Corners are looked for no more often, as each step may find others where edges of different
/// lengths meet.
constexpr int MostCornerSteps = 7;
/// Closed rims shorter than this, as a fraction of half of the width, are left out: edges may cut
/// the tip of a corner off.
constexpr double ShortestRim = 0.5;
/// While edges are split the path may be sampled more coarsely: as fractions of the edges and of
/// half of the width.
constexpr double CoarseSpacing = 0.25;
constexpr double CoarsestSpacing = 0.1;
/// Each step halves the longest edges; many more would be needed for lengths that doubles can't
/// distinguish from zero.
constexpr int MostSteps = 100;
/// Places on each edge where the distance is measured, step by step closer to where a rim crosses
/// it. The distance along an edge may have kinks, so that the first step is to find out roughly.
constexpr int Samples[] = { 15, 1, 1 };

/// The curve at one distance from points on a mesh.
class Isoline
{
public:
  /// `longest`: as long as edges that the curve may cross. It may be behind their ends.
  Isoline(
    const SurfaceMesh& mesh, std::vector<GeodesicSource> sources, double distance, double longest)
    : Mesh(mesh)
    , Sources(std::move(sources))
    , Distance(distance)
    , Reach(distance + longest)
    , Crossings(mesh.GetNumberOfHalfEdges())
  {
  }

  /// Distances of the vertices, Infinity where the curve is not close.
  Status Measure(const ProgressCallback& progress)
  {
    ExactOptions options;
    options.MaximumDistance = this->Reach;
    options.Progress = progress;
    ExactResult result;
    Status status = this->Solver.Run(this->Sources, options, result);
    this->Distances = std::move(result.Distances);
    return status;
  }

  const std::vector<double>& GetDistances() const { return this->Distances; }

  /// The curves as the distances of the vertices alone have it.
  void FindRoughly(std::vector<SurfacePath>& curves)
  {
    this->FindCrossings();
    this->Connect(curves);
  }

  Status Find(const ProgressCallback& progress, std::vector<SurfacePath>& curves)
  {
    this->FindCrossings();
    Status status;
    double done = 0.0;
    for (const int samples : Samples)
    {
      const ProgressCallback part = ProgressPart(progress, done, done + 1.0 / 3.0);
      status = status.IsOk() ? this->Refine(samples, part) : status;
      done += 1.0 / 3.0;
    }
    if (status.IsOk())
    {
      this->Connect(curves);
    }
    return status;
  }

private:
  /// Where the distance is reached on an edge, between two places on either side.
  struct EdgeCrossing
  {
    double Near = 0.0; ///< from the origin; nearer than the distance there
    double Far = 1.0;
    double AtNear = 0.0; ///< distances
    double AtFar = 0.0;
    bool IsCrossed = false;
    std::vector<Id> Faces; ///< not yet passed by a curve

    double Place(double distance) const
    {
      return this->Near +
        (this->Far - this->Near) * (distance - this->AtNear) / (this->AtFar - this->AtNear);
    }
  };

  bool IsNear(Id v) const { return this->Distances[v] < this->Distance; }

  void FindCrossings()
  {
    for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id a = this->Mesh.Origin(h);
      const Id b = this->Mesh.Destination(h);
      if (this->Mesh.IsDropped(SurfaceMesh::Face(h)) || this->IsNear(a) == this->IsNear(b) ||
        !std::isfinite(this->Distances[a] + this->Distances[b]))
      {
        continue;
      }
      const Id edge = FindEdge(this->Mesh, h);
      EdgeCrossing& crossing = this->Crossings[edge];
      crossing.Faces.push_back(SurfaceMesh::Face(h));
      if (edge == h)
      {
        crossing.IsCrossed = true;
        crossing.Near = this->IsNear(a) ? 0.0 : 1.0;
        crossing.Far = 1.0 - crossing.Near;
        crossing.AtNear = std::min(this->Distances[a], this->Distances[b]);
        crossing.AtFar = std::max(this->Distances[a], this->Distances[b]);
        this->Edges.push_back(edge);
      }
    }
  }

  SurfacePoint PointOn(Id edge) const
  {
    return SurfacePoint::OnEdge(this->Mesh, edge, this->Crossings[edge].Place(this->Distance));
  }

  /// Measure the distance at places between those known, or, at a single one, where it should be
  /// reached.
  Status Refine(int samples, const ProgressCallback& progress)
  {
    if (this->Edges.empty())
    {
      return Status::Success();
    }
    ExactOptions options;
    options.MaximumDistance = this->Reach;
    options.Progress = progress;
    std::vector<double> places;
    for (const Id edge : this->Edges)
    {
      const EdgeCrossing& crossing = this->Crossings[edge];
      for (int k = 1; k <= samples; ++k)
      {
        places.push_back(samples == 1
            ? crossing.Place(this->Distance)
            : crossing.Near + (crossing.Far - crossing.Near) * k / (samples + 1.0));
        options.Targets.push_back(SurfacePoint::OnEdge(this->Mesh, edge, places.back()));
      }
    }
    ExactResult result;
    Status status = this->Solver.Run(this->Sources, options, result);
    for (std::size_t i = 0; i < places.size() && status.IsOk(); ++i)
    {
      EdgeCrossing& crossing = this->Crossings[this->Edges[i / samples]];
      const double distance = result.TargetDistances[i];
      const bool isBeyond =
        std::abs(places[i] - crossing.Near) >= std::abs(crossing.Far - crossing.Near);
      if (isBeyond || !std::isfinite(distance))
      {
        continue; // behind the first place that is too far
      }
      if (distance < this->Distance)
      {
        crossing.Near = places[i];
        crossing.AtNear = distance;
      }
      else
      {
        crossing.Far = places[i];
        crossing.AtFar = distance;
      }
    }
    return status;
  }

  /// Leave the edge through one of its faces that no curve has passed. NoId when there is none.
  Id Pass(Id edge, Id& face)
  {
    EdgeCrossing& crossing = this->Crossings[edge];
    if (crossing.Faces.empty())
    {
      return NoId;
    }
    face = crossing.Faces.back();
    crossing.Faces.pop_back();
    for (Id h = 3 * face; h < 3 * face + 3; ++h)
    {
      const Id other = FindEdge(this->Mesh, h);
      if (other != edge && this->Crossings[other].IsCrossed)
      {
        std::vector<Id>& faces = this->Crossings[other].Faces;
        faces.erase(std::remove(faces.begin(), faces.end(), face), faces.end());
        return other;
      }
    }
    return NoId;
  }

  /// From a crossing on, until a curve closes or ends.
  void Follow(Id start, SurfacePath& curve)
  {
    curve.Points.push_back(this->PointOn(start));
    Id face = NoId;
    for (Id edge = this->Pass(start, face); edge != NoId; edge = this->Pass(edge, face))
    {
      curve.Points.push_back(this->PointOn(edge));
      curve.Faces.push_back(face);
      curve.Length += MeasurePiece(this->Mesh, curve, curve.Faces.size() - 1);
      if (edge == start)
      {
        return;
      }
    }
  }

  /// Open curves first, from their ends; what is left is closed.
  void Connect(std::vector<SurfacePath>& curves)
  {
    for (const bool isOpen : { true, false })
    {
      for (const Id edge : this->Edges)
      {
        while (!this->Crossings[edge].Faces.empty() &&
          (!isOpen || this->Crossings[edge].Faces.size() % 2 == 1))
        {
          SurfacePath curve;
          this->Follow(edge, curve);
          if (!curve.Faces.empty())
          {
            curves.push_back(std::move(curve));
          }
        }
      }
    }
  }

  const SurfaceMesh& Mesh;
  std::vector<GeodesicSource> Sources;
  double Distance;
  double Reach;
  ExactGeodesics Solver{ this->Mesh };
  std::vector<double> Distances;
  std::vector<EdgeCrossing> Crossings; // per half-edge that stands for its edge
  std::vector<Id> Edges;               // those that are crossed
};

/// Points along a chain of vertices, no farther from each other than `spacing`.
std::vector<GeodesicSource> SampleChain(
  const SurfaceMesh& mesh, const std::vector<Id>& chain, double spacing)
{
  std::vector<GeodesicSource> sources;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    sources.push_back({ SurfacePoint::AtVertex(chain[i]), 0.0 });
    for (const Id* g = mesh.FanBegin(chain[i]); i + 1 < chain.size() && g != mesh.FanEnd(chain[i]);
         ++g)
    {
      const Id back = SurfaceMesh::Previous(*g);
      const bool isForward = mesh.Destination(*g) == chain[i + 1];
      if (!isForward && mesh.Origin(back) != chain[i + 1])
      {
        continue;
      }
      const Id h = isForward ? *g : back;
      const auto pieces = static_cast<int>(std::ceil(mesh.Length(h) / spacing));
      for (int k = 1; k < pieces; ++k)
      {
        sources.push_back({ SurfacePoint::OnEdge(mesh, h, static_cast<double>(k) / pieces), 0.0 });
      }
      break;
    }
  }
  return sources;
}
}

namespace
{
/// A curve on the refined surface as one on the mesh, with all its points.
SurfacePath ToMesh(const SurfaceMesh& mesh, const RefinedSurface& refined, const SurfaceMesh& part,
  const SurfacePath& curve)
{
  SurfacePath path;
  for (std::size_t i = 0; i < curve.Points.size(); ++i)
  {
    const Id face = curve.Faces[i > 0 ? i - 1 : 0];
    const bool isClosing = i + 1 == curve.Points.size() && i > 0 &&
      curve.Points[i].On == SurfacePoint::Support::Edge &&
      curve.Points[i].HalfEdge == curve.Points[0].HalfEdge;
    path.Points.push_back(
      isClosing ? path.Points.front() : refined.ToOldMesh(mesh, part, face, curve.Points[i]));
    if (i > 0)
    {
      path.Faces.push_back(refined.Faces[face]);
      path.Length += MeasurePiece(mesh, path, i - 1);
    }
  }
  return path;
}

/// A surface that is split along a path, and the rims beside it. Faces are split further until what
/// a rim may cross is small: a rim that lies within a face crosses none of its sides, and it is
/// straight from one side to the next. Besides, many points on the path that all see the same large
/// faces would cost far more.
class OffsetCurveMaker
{
public:
  OffsetCurveMaker(const SurfaceMesh& mesh, double distance, const ProgressCallback& progress)
    : Mesh(mesh)
    , Distance(distance)
    , Progress(progress)
  {
  }

  Status Run(const SurfacePath& path, std::vector<SurfacePath>& rims)
  {
    RefinementOptions options;
    options.InsertCrossings = true; // of the path with itself
    Status status = RefineAlongPaths(this->Mesh, { path }, options, this->Refined);
    this->Longest = this->Refined.Lengths.empty()
      ? 0.0
      : *std::max_element(this->Refined.Lengths.begin(), this->Refined.Lengths.end());
    bool isDone = false;
    for (int step = 0; step < MostSteps && status.IsOk() && !isDone; ++step)
    {
      status = this->Step(isDone);
    }
    if (status.IsOk() && !isDone)
    {
      status = this->Refined.Build(this->Mesh, this->Part); // after the last split
    }
    if (!status.IsOk())
    {
      return status;
    }
    Isoline isoline(
      this->Part, this->Sample(Spacing * this->Distance), this->Distance, this->Longest);
    status = isoline.Measure(ProgressPart(this->Progress, 0.6, 0.7));
    std::vector<SurfacePath> curves;
    if (status.IsOk())
    {
      status = isoline.Find(ProgressPart(this->Progress, 0.7, 1.0), curves);
    }
    for (const SurfacePath& curve : curves)
    {
      const bool isClosed = IsSamePoint(curve.Points.front(), curve.Points.back());
      if (!isClosed || curve.Length >= ShortestRim * this->Distance)
      {
        rims.push_back(ToMesh(this->Mesh, this->Refined, this->Part, curve));
      }
    }
    return status;
  }

private:
  /// Halve the longest edges; when they are short enough, those at corners.
  Status Step(bool& isDone)
  {
    Status status = this->Refined.Build(this->Mesh, this->Part);
    if (status.IsOk() && !this->Report())
    {
      status = Status::Abort();
    }
    if (!status.IsOk())
    {
      return status;
    }
    const double spacing = std::max(Spacing * this->Distance,
      std::min(CoarseSpacing * this->Longest, CoarsestSpacing * this->Distance));
    Isoline isoline(this->Part, this->Sample(spacing), this->Distance, this->Longest + spacing);
    const double left = 0.6 - this->Done;
    status = isoline.Measure(ProgressPart(this->Progress, this->Done, this->Done + 0.2 * left));
    this->Done += 0.2 * left;
    if (!status.IsOk())
    {
      return status;
    }
    std::vector<char> isSplit(this->Refined.Triangles.size(), 0);
    isDone = !this->MarkLongEdges(isoline.GetDistances(), spacing, isSplit) &&
      !this->MarkCorners(isoline, isSplit);
    if (!isDone)
    {
      status = this->Report() ? status : Status::Abort();
      SplitEdges(this->Mesh, isSplit, this->Refined);
    }
    return this->Report() ? status : Status::Abort();
  }

  bool Report() const { return !this->Progress || this->Progress(this->Done); }

  std::vector<GeodesicSource> Sample(double spacing) const
  {
    return SampleChain(this->Part, this->Refined.Paths.front(), spacing);
  }

  /// Edges on which the distance may be reached, by those of their ends.
  bool MarkLongEdges(
    const std::vector<double>& distances, double spacing, std::vector<char>& isSplit)
  {
    const auto size = static_cast<Id>(isSplit.size());
    std::vector<char> mayBeCrossed(size, 0);
    double longest = 0.0;
    for (Id h = 0; h < size; ++h)
    {
      const double length = this->Refined.Lengths[h];
      const double sum = distances[this->Refined.Triangles[h]] +
        distances[this->Refined.Triangles[SurfaceMesh::Next(h)]];
      mayBeCrossed[h] = 0.5 * (sum - length) - spacing <= this->Distance &&
        0.5 * (sum + length) + spacing >= this->Distance;
      longest = mayBeCrossed[h] ? std::max(longest, length) : longest;
    }
    const double target = std::max(LongestEdge * this->Distance, 0.5 * longest);
    bool isAny = false;
    for (Id h = 0; h < size; ++h)
    {
      if (mayBeCrossed[h] && this->Refined.Lengths[h] > target)
      {
        isSplit[h] = 1;
        isAny = true;
      }
    }
    this->Longest = std::min(this->Longest, longest);
    return isAny;
  }

  /// The edges of the faces beside corners of the rims.
  bool MarkCorners(Isoline& isoline, std::vector<char>& isSplit)
  {
    if (this->CornerSteps == MostCornerSteps)
    {
      return false;
    }
    ++this->CornerSteps;
    std::vector<SurfacePath> curves;
    isoline.FindRoughly(curves);
    std::vector<char> isAtCorner(this->Refined.Points.size(), 0); // vertices
    for (const SurfacePath& curve : curves)
    {
      const std::size_t pieces = curve.Faces.size();
      const bool isClosed = IsSamePoint(curve.Points.front(), curve.Points.back());
      for (std::size_t i = isClosed ? 0 : 1; i < pieces; ++i)
      {
        const std::size_t before = i > 0 ? i - 1 : pieces - 1;
        if (!this->IsCorner(curve.Points[before], curve.Points[i], curve.Points[i + 1],
              curve.Faces[before], curve.Faces[i]))
        {
          continue;
        }
        for (const Id face : { curve.Faces[before], curve.Faces[i] })
        {
          for (Id h = 3 * face; h < 3 * face + 3; ++h)
          {
            isAtCorner[this->Refined.Triangles[h]] = 1;
          }
        }
      }
    }
    // All faces around: an edge may have cut the tip off, so that it lies behind the next one.
    bool isAny = false;
    for (Id f = 0; f < this->Refined.GetNumberOfFaces(); ++f)
    {
      const Id* corners = this->Refined.Triangles.data() + 3 * static_cast<std::size_t>(f);
      const bool isClose =
        std::any_of(corners, corners + 3, [&](Id v) { return isAtCorner[v] != 0; });
      for (Id h = 3 * f; h < 3 * f + 3 && isClose; ++h)
      {
        const bool isLong = this->Refined.Lengths[h] > LongestEdgeAtCorner * this->Distance;
        isSplit[h] = isLong ? 1 : isSplit[h];
        isAny = isAny || isLong;
      }
    }
    return isAny;
  }

  /// Whether a curve that passes from one face into the next turns more than an arc does.
  bool IsCorner(const SurfacePoint& before, const SurfacePoint& at, const SurfacePoint& after,
    Id first, Id second) const
  {
    if (at.On != SurfacePoint::Support::Edge)
    {
      return false;
    }
    double angle = 0.0;
    double length = 0.0;
    for (const Id face : { first, second })
    {
      std::array<double, 3> from{};
      std::array<double, 3> to{};
      if (!FindInFace(this->Part, at, face, from) ||
        !FindInFace(this->Part, face == first ? before : after, face, to))
      {
        return false;
      }
      Id h = 3 * face; // the half-edge that the point is on
      while (from[(h + 2) % 3] != 0.0)
      {
        ++h;
      }
      const Point2 step =
        PlaceInFrame(this->Part, h, { { to[0] - from[0], to[1] - from[1], to[2] - from[2] } });
      const bool isForward = this->Part.Origin(h) == this->Part.Origin(at.HalfEdge);
      angle += std::atan2(step.Y, isForward ? step.X : -step.X);
      length += Norm(step.X, step.Y);
    }
    return std::abs(Pi - angle) > CornerTurn + 0.75 * length / this->Distance;
  }

  const SurfaceMesh& Mesh;
  const double Distance;
  const ProgressCallback& Progress;
  RefinedSurface Refined;
  SurfaceMesh Part;
  double Longest = 0.0; // edge that a rim may have crossed, before the last step
  int CornerSteps = 0;
  double Done = 0.0; // of the progress
};
}

Status MakeOffsetCurves(const SurfaceMesh& mesh, const SurfacePath& path, double width,
  const ProgressCallback& progress, std::vector<SurfacePath>& rims)
{
  rims.clear();
  std::ostringstream message;
  if (!(width > 0.0 && std::isfinite(width)))
  {
    message << "the width of the tape is " << width << ": a positive number is needed";
    return Status::Invalid(message.str());
  }
  if (width < GetSmallestOffsetWidth(path))
  {
    message << "the width of the tape is " << width << ", too small for the length " << path.Length
            << " of the curve: at least " << GetSmallestOffsetWidth(path) << " is needed";
    return Status::Invalid(message.str());
  }
  Status status = OffsetCurveMaker(mesh, 0.5 * width, progress).Run(path, rims);
  if (!status.IsOk())
  {
    rims.clear();
  }
  return status;
}

double GetSmallestOffsetWidth(const SurfacePath& path)
{
  return 2.0 * path.Length / (MostSources * Spacing);
}
}
