// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsBand.h"

#include "dggGraphicsBlend.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Sources per edge, its start included.
constexpr int SourcesPerEdge = 4;
/// Part of the progress when distances are known.
constexpr double MeasuredAt = 0.8;

/// How far vertices are from one side of a curve, and from which place of it.
struct SideDistances
{
  std::vector<GeodesicSource> Sources;
  std::vector<double> Parameters; // per source, its place among the given points
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

/// The half-edge of a face between two of its corners, and whether it runs backwards.
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
  GeodesicSource source;
  source.Point = point;
  distances.Sources.push_back(source);
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
}

double FadeWithDistance(double distance, double width)
{
  const double t = distance / width;
  return t < 1.0 ? (1.0 - t * t) * (1.0 - t * t) : 0.0;
}

Status AddBand(const SurfaceMesh& mesh, const CurveSides& sides, const CurveChain& chain,
  const GraphicsCurve& curve, int channels, ExactGeodesics& exact, const ProgressCallback& progress,
  std::vector<double>& values)
{
  SideDistances distances[2];
  Status status;
  for (int k = 0; k < 2 && status.IsOk(); ++k)
  {
    AddSources(mesh, k == 0 ? sides.Left : sides.Right, chain, distances[k]);
    if (distances[k].Sources.empty())
    {
      continue; // along the boundary
    }
    ExactOptions options;
    options.MaximumDistance = curve.Width;
    options.Progress = ProgressPart(progress, 0.5 * MeasuredAt * k, 0.5 * MeasuredAt * (k + 1));
    status = exact.Run(distances[k].Sources, options, distances[k].Result);
  }
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  StrengthBlend blend;
  if (status.IsOk() && StrengthBlend::IsNeeded(curve, channels))
  {
    std::vector<char> isInBand(n);
    for (std::size_t v = 0; v < n; ++v)
    {
      isInBand[v] = distances[0].IsReached(v) || distances[1].IsReached(v) ? 1 : 0;
    }
    status = blend.Spread(
      mesh, isInBand, sides, chain, curve, channels, ProgressPart(progress, MeasuredAt, 1.0));
  }
  if (!status.IsOk())
  {
    return status;
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
  for (std::size_t v = 0; v < n; ++v)
  {
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
      for (int c = 0; c < channels; ++c)
      {
        values[v * channels + c] += even * (left[c] + right[c]) + odd * (left[c] - right[c]);
      }
    }
  }
  return status;
}
}
