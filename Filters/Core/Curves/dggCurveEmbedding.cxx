// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCurveEmbedding.h"

#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dgg
{
namespace
{
/// The parameter at a place of the path of a curve.
double ParameterAt(const SurfaceCurve& curve, double place)
{
  const auto piece = static_cast<std::size_t>(place);
  if (piece + 1 >= curve.Parameters.size())
  {
    return curve.Parameters.back();
  }
  const double from = curve.Parameters[piece];
  return from + (curve.Parameters[piece + 1] - from) * (place - std::floor(place));
}
}

Status EmbedCurves(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves,
  const ProgressCallback& progress, RefinedSurface& surface)
{
  surface = RefinedSurface();
  std::vector<SurfacePath> paths;
  paths.reserve(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].Parameters.size() != curves[c].Path.Points.size())
    {
      std::ostringstream message;
      message << "curve " << c << " has " << curves[c].Path.Points.size() << " points, but "
              << curves[c].Parameters.size() << " parameters";
      return Status::Invalid(message.str());
    }
    paths.push_back(curves[c].Path);
  }
  RefinementOptions options;
  options.InsertCrossings = true;
  options.Progress = progress;
  return RefineAlongPaths(mesh, paths, options, surface);
}

CurveChain FollowCurve(
  const RefinedSurface& surface, const std::vector<SurfaceCurve>& curves, std::size_t number)
{
  const SurfaceCurve& curve = curves[number];
  const std::vector<double>& places = surface.Places[number];
  CurveChain chain;
  chain.Vertices = surface.Paths[number];
  chain.Parameters.reserve(places.size());
  for (const double place : places)
  {
    chain.Parameters.push_back(ParameterAt(curve, place));
  }
  for (const Offset point : curve.GivenPoints)
  {
    // Points of the path that became one vertex have the place of the first of them.
    const auto beyond = std::upper_bound(places.begin(), places.end(), static_cast<double>(point));
    chain.GivenPoints.push_back(static_cast<Offset>(beyond - places.begin()) - 1);
  }
  return chain;
}
}
