// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsBand.h"

#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggSubMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dgg
{
namespace
{
/// Sources per edge, including its start.
constexpr int SourcesPerEdge = 4;
/// Progress after the distances.
constexpr double MeasuredAt = 0.8;

/// Distances of vertices from one side of a curve, and the nearest curve point.
struct SideDistances
{
  std::vector<GeodesicSource> Sources;
  std::vector<double> Parameters; // per source, its parameter among the given points
  ExactResult Result;

  bool IsReached(std::size_t v) const
  {
    return !this->Sources.empty() && this->Result.NearestSource[v] != NoId;
  }
  double GetDistance(std::size_t v) const
  {
    return this->Sources.empty() ? Infinity : this->Result.Distances[v];
  }
  double GetParameter(std::size_t v) const
  {
    return this->Parameters[this->Result.NearestSource[v]];
  }
};

/// Returns the half-edge of a face between two of its corners; `isBackward` is true if it runs in
/// the opposite direction.
Id FindHalfEdge(const SurfaceMesh& mesh, const EdgeSide& side, bool& isBackward)
{
  for (Id h = 3 * side.Face; h < 3 * side.Face + 3; ++h)
  {
    isBackward = mesh.Origin(h) == side.To && mesh.Destination(h) == side.From;
    if (isBackward || (mesh.Origin(h) == side.From && mesh.Destination(h) == side.To))
    {
      return h;
    }
  }
  return NoId;
}

void AddSource(const SurfacePoint& point, double parameter, SideDistances& distances)
{
  distances.Sources.push_back({ point, 0.0 });
  distances.Parameters.push_back(parameter);
}

void AddSources(const SurfaceMesh& mesh, const std::vector<EdgeSide>& edges,
  const CurveChain& chain, SideDistances& distances)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const EdgeSide& edge = edges[i];
    bool isBackward = false;
    const Id h = edge.Face == NoId ? NoId : FindHalfEdge(mesh, edge, isBackward);
    if (h == NoId)
    {
      continue;
    }
    const double begin = chain.Parameters[i];
    const double end = chain.Parameters[i + 1];
    AddSource(SurfacePoint::AtVertex(edge.From), begin, distances);
    for (int k = 1; k < SourcesPerEdge; ++k)
    {
      const double t = static_cast<double>(k) / SourcesPerEdge;
      AddSource(SurfacePoint::OnEdge(mesh, h, isBackward ? 1.0 - t : t), begin + t * (end - begin),
        distances);
    }
    if (i + 1 == edges.size() || edges[i + 1].From != edge.To)
    {
      AddSource(SurfacePoint::AtVertex(edge.To), end, distances);
    }
  }
}

/// Returns b(d) = (1 - (d / width)^2)^2, 0 from the width on: flat at the curve, smooth at the end.
double FadeWithDistance(double distance, double width)
{
  const double t = distance / width;
  return t < 1.0 ? (1.0 - t * t) * (1.0 - t * t) : 0.0;
}

bool IsSameAllAlong(const std::vector<double>& values, std::size_t channels)
{
  for (std::size_t i = channels; i < values.size(); ++i)
  {
    if (values[i] != values[i - channels])
    {
      return false;
    }
  }
  return true;
}

bool IsFaceInBand(const SurfaceMesh& mesh, Id face, const std::vector<char>& isInBand)
{
  const std::array<Id, 3> corners = mesh.GetTriangle(face);
  return !mesh.IsDropped(face) &&
    (isInBand[corners[0]] || isInBand[corners[1]] || isInBand[corners[2]]);
}

/// The strengths on the left and right of a Poisson curve as continuous functions in its band: each
/// is harmonic in the band and equals the strength of the curve on both sides of it. The strengths
/// of the nearest curve point would jump where two curve points are equally near.
class StrengthBlend
{
public:
  /// Solves for the strengths on the faces with a vertex in the band, on their intrinsic Delaunay
  /// triangulation, so that no strength lies outside the range of the strengths of the curve. If
  /// the triangles are too thin, no strengths are stored, see Get().
  Status Spread(const SurfaceMesh& mesh, const std::vector<char>& isInBand, const CurveSides& sides,
    const CurveChain& chain, const GraphicsCurve& curve, int channels,
    const ProgressCallback& progress)
  {
    std::vector<Id> faces;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      if (IsFaceInBand(mesh, f, isInBand))
      {
        faces.push_back(f);
      }
    }
    const SubMesh part = FaceSelector(mesh).Select(faces);
    SurfaceMesh band;
    DGG_RETURN_IF_ERROR(part.Build(mesh, band));
    this->Places.assign(isInBand.size(), NoId);
    for (Id v = 0; v < part.GetNumberOfVertices(); ++v)
    {
      this->Places[part.Points[v].Vertex] = v;
    }
    const auto n = static_cast<std::size_t>(band.GetNumberOfVertices());
    const auto count = static_cast<std::size_t>(channels);
    std::vector<double> given(n, 0.0); // number of given values per vertex
    PoissonOptions options;
    options.IntrinsicDelaunay = true;
    ForEachEnd(sides, chain, [&](Id v, bool, double) {
      options.DirichletVertices.push_back(this->Places[v]);
      given[this->Places[v]] += 1.0;
    });
    PoissonSolver solver(band);
    Status status = solver.Prepare(options, progress);
    if (!status.IsOk())
    {
      this->Places.clear();
      return !status.IsAborted() && solver.GetSystem().HasThin() ? Status::Success() : status;
    }
    this->Columns.assign(2 * count, std::vector<double>(n, 0.0));
    std::vector<double> strength(count);
    for (const std::size_t side : { 0, 1 })
    {
      ForEachEnd(sides, chain, [&](Id v, bool, double parameter) {
        InterpolateOnCurve(side == 0 ? curve.Left : curve.Right, channels, curve.IsClosed,
          parameter, strength.data());
        for (std::size_t c = 0; c < count; ++c)
        {
          this->Columns[side * count + c][this->Places[v]] += strength[c] / given[this->Places[v]];
        }
      });
    }
    status = solver.Solve(this->Columns);
    const PoissonSystem& system = solver.GetSystem();
    for (Id& place : this->Places)
    {
      place = place != NoId && system.IsFree(system.GetComponent(place)) ? NoId : place;
    }
    return status;
  }

  /// Returns the strengths at a vertex, one per channel. Returns false and nothing if faces of the
  /// band are not connected to the curve, or are too thin.
  bool Get(Id vertex, std::vector<double>& left, std::vector<double>& right) const
  {
    const Id place = this->Places.empty() ? NoId : this->Places[vertex];
    for (std::size_t c = 0; c < left.size() && place != NoId; ++c)
    {
      left[c] = this->Columns[c][place];
      right[c] = this->Columns[left.size() + c][place];
    }
    return place != NoId;
  }

private:
  std::vector<Id> Places;                   // per vertex, its id in the band, or NoId
  std::vector<std::vector<double>> Columns; // channels of the left, then of the right
};

/// Returns true for an open curve that has no point as far as its width from both ends.
bool IsShort(const SurfaceMesh& mesh, const CurveSides& sides, const GraphicsCurve& curve)
{
  if (curve.IsClosed)
  {
    return false;
  }
  double length = 0.0;
  bool isBackward = false;
  for (std::size_t i = 0; i < sides.Left.size(); ++i)
  {
    const EdgeSide& side = sides.Left[i].Face != NoId ? sides.Left[i] : sides.Right[i];
    length += mesh.Length(FindHalfEdge(mesh, side, isBackward));
  }
  return length < 2.0 * curve.Width;
}
}

bool IsBlended(const GraphicsCurve& curve, int channels)
{
  const auto count = static_cast<std::size_t>(channels);
  return !IsSameAllAlong(curve.Left, count) || !IsSameAllAlong(curve.Right, count);
}

Status AddBand(const SurfaceMesh& mesh, const CurveSides& sides, const CurveChain& chain,
  const GraphicsCurve& curve, int channels, ExactGeodesics& exact, const ProgressCallback& progress,
  std::vector<double>& values, double& contrast)
{
  SideDistances distances[2];
  for (int k = 0; k < 2; ++k)
  {
    AddSources(mesh, k == 0 ? sides.Left : sides.Right, chain, distances[k]);
    if (distances[k].Sources.empty())
    {
      continue; // along the boundary
    }
    ExactOptions options;
    options.MaximumDistance = curve.Width;
    options.Progress = ProgressPart(progress, 0.5 * MeasuredAt * k, 0.5 * MeasuredAt * (k + 1));
    DGG_RETURN_IF_ERROR(exact.Run(distances[k].Sources, options, distances[k].Result));
  }
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  StrengthBlend blend;
  if (IsBlended(curve, channels))
  {
    std::vector<char> isInBand(n);
    for (std::size_t v = 0; v < n; ++v)
    {
      isInBand[v] = distances[0].IsReached(v) || distances[1].IsReached(v) ? 1 : 0;
    }
    DGG_RETURN_IF_ERROR(blend.Spread(
      mesh, isInBand, sides, chain, curve, channels, ProgressPart(progress, MeasuredAt, 1.0)));
  }
  std::vector<double> left(channels);
  std::vector<double> right(channels);
  const auto findStrengths = [&](std::size_t v, double parameter) {
    if (!blend.Get(static_cast<Id>(v), left, right))
    {
      InterpolateOnCurve(curve.Left, channels, curve.IsClosed, parameter, left.data());
      InterpolateOnCurve(curve.Right, channels, curve.IsClosed, parameter, right.data());
    }
  };
  contrast = 0.0;
  for (std::size_t v = 0; v < n; ++v)
  {
    double difference = 0.0;
    const bool isNearestLeft = distances[0].GetDistance(v) <= distances[1].GetDistance(v);
    for (int k = 0; k < 2; ++k)
    {
      if (!distances[k].IsReached(v))
      {
        continue;
      }
      findStrengths(v, distances[k].GetParameter(v));
      const double fade = FadeWithDistance(distances[k].GetDistance(v), curve.Width);
      const double even = (k == 0) == isNearestLeft ? 0.5 * fade : 0.0;
      const double odd = k == 0 ? 0.5 * fade : -0.5 * fade;
      difference += 2.0 * odd;
      for (int c = 0; c < channels; ++c)
      {
        values[v * channels + c] += even * (left[c] + right[c]) + odd * (left[c] - right[c]);
      }
    }
    contrast = std::max(contrast, std::abs(difference));
  }
  contrast = IsShort(mesh, sides, curve) ? contrast : 1.0;
  return Status::Success();
}
}
