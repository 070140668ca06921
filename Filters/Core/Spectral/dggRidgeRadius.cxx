// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRidgeRadius.h"

#include "dggCornerModel.h"
#include "dggExactSources.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
constexpr double VisibleAngle = Pi / 3.0;

/// Angle at one end of a segment in the plane, from the distances of its ends.
double PlaneAngle(double length, double fromHere, double fromThere)
{
  const Point2 source = LayOut(length, fromHere, fromThere);
  return std::atan2(source.Y, source.X);
}

/// How far the direction in which light arrives at the origin of an edge is from what the distances
/// of both ends say.
double Misdirection(const SurfaceMesh& mesh, Id v, double polarAngle, double length,
  double distance, double other, const VirtualSources& sources)
{
  const CornerModel model(mesh, v, 0.0, distance, sources.Angles[v]);
  if (!model.IsKnown || !(sources.Lengths[v] > 0.0))
  {
    return 0.0;
  }
  const double angle = std::min(Pi, std::abs(model.AngleFrom(polarAngle)));
  return std::abs(angle - PlaneAngle(length, distance, other));
}
}

double FindRidgeRadius(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& distances, double checked)
{
  VirtualSources found;
  FindVirtualSources(mesh, sources, distances, found);
  const std::vector<double>& d = distances.Distances;
  double radius = Infinity;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = mesh.Twin(h);
    if (mesh.IsDropped(SurfaceMesh::Face(h)) || t < h)
    {
      continue; // of an edge between two faces one half will do; boundaries bend light
    }
    const Id i = mesh.Origin(h);
    const Id j = mesh.Destination(h);
    const double here = d[i];
    const double there = d[j];
    // Edges that end at the source are left out as well.
    if (!(std::max(here, there) < Infinity) || !(std::min(here, there) < radius) ||
      !(std::min(here, there) > 0.0) || std::max(here, there) < checked || mesh.Origin(t) != j)
    {
      continue;
    }
    const double difference =
      Misdirection(mesh, i, mesh.PolarAngle(h), mesh.Length(h), here, there, found) +
      Misdirection(mesh, j, mesh.PolarAngle(t), mesh.Length(h), there, here, found);
    if (difference > VisibleAngle)
    {
      radius = std::min(here, there);
    }
  }
  return radius;
}
}
