// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggTape.h"

#include "dggExactGeodesics.h"
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
/// Points on a path, at most: what they take grows faster than their number.
constexpr double MostSources = 1e5;
/// Places on each edge where the distance is measured, step by step closer to where a rim crosses
/// it. The distance along an edge may have kinks, so that the first step is to find out roughly.
constexpr int Samples[] = { 15, 1, 1 };

/// The curve at one distance from points on a mesh.
class Isoline
{
public:
  Isoline(const SurfaceMesh& mesh, std::vector<GeodesicSource> sources, double distance)
    : Mesh(mesh)
    , Sources(std::move(sources))
    , Distance(distance)
    , Crossings(mesh.GetNumberOfHalfEdges())
  {
  }

  Status Run(const ProgressCallback& progress, std::vector<SurfacePath>& curves)
  {
    ExactOptions options;
    options.MaximumDistance = this->Distance + 2.0 * this->Mesh.GetMaximumEdgeLength();
    options.Progress = progress;
    ExactResult result;
    Status status = this->Solver.Run(this->Sources, options, result);
    if (!status.IsOk())
    {
      return status;
    }
    this->Distances = std::move(result.Distances);
    this->FindCrossings();
    for (const int samples : Samples)
    {
      status = status.IsOk() ? this->Refine(samples, progress) : status;
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

  /// The half-edge that stands for its edge.
  Id Representative(Id h) const
  {
    Id smallest = h;
    for (Id e = this->Mesh.Twin(h); e != NoId && e != h; e = this->Mesh.Twin(e))
    {
      smallest = std::min(smallest, e);
    }
    return smallest;
  }

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
      const Id edge = this->Representative(h);
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
    options.MaximumDistance = this->Distance + 2.0 * this->Mesh.GetMaximumEdgeLength();
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
      const Id other = this->Representative(h);
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
    std::array<double, 3> barycentric{};
    FindInFace(part, curve.Points[i], face, barycentric);
    if (part.IsFlipped(face))
    {
      std::swap(barycentric[1], barycentric[2]);
    }
    const bool isClosing = i + 1 == curve.Points.size() && i > 0 &&
      curve.Points[i].On == SurfacePoint::Support::Edge &&
      curve.Points[i].HalfEdge == curve.Points[0].HalfEdge;
    path.Points.push_back(
      isClosing ? path.Points.front() : refined.ToOldMesh(mesh, face, barycentric));
    if (i > 0)
    {
      path.Faces.push_back(refined.Faces[face]);
      path.Length += MeasurePiece(mesh, path, i - 1);
    }
  }
  return path;
}
}

Status MakeTape(const SurfaceMesh& mesh, const SurfacePath& path, double width,
  const ProgressCallback& progress, std::vector<SurfacePath>& rims)
{
  rims.clear();
  if (!(width > 0.0 && std::isfinite(width)))
  {
    std::ostringstream message;
    message << "the width of the tape is " << width << ": a positive number is needed";
    return Status::Invalid(message.str());
  }
  RefinedSurface refined;
  RefinementOptions options;
  options.InsertCrossings = true; // of the path with itself
  Status status = RefineAlongPaths(mesh, { path }, options, refined);
  SurfaceMesh part;
  if (status.IsOk())
  {
    status = refined.Build(mesh, part);
  }
  if (!status.IsOk())
  {
    return status;
  }
  const double distance = 0.5 * width;
  if (path.Length > MostSources * Spacing * distance)
  {
    std::ostringstream message;
    message << "the width of the tape is " << width << ", too small for the length " << path.Length
            << " of the curve: at least " << 2.0 * path.Length / (MostSources * Spacing)
            << " is needed";
    return Status::Invalid(message.str());
  }
  std::vector<SurfacePath> curves;
  status = Isoline(part, SampleChain(part, refined.Paths.front(), Spacing * distance), distance)
             .Run(progress, curves);
  for (const SurfacePath& curve : curves)
  {
    rims.push_back(ToMesh(mesh, refined, part, curve));
  }
  return status;
}
}
