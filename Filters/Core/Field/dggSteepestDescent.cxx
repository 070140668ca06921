// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSteepestDescent.h"

#include "dggUnfolding.h"

#include <cmath>

namespace dgg
{
SteepestDescent FindSteepestDescent(const SurfaceMesh& mesh, const double* values, Id v)
{
  SteepestDescent best;
  if (!std::isfinite(values[v]))
  {
    return best;
  }
  auto take = [&](double slope, double angle) {
    best.IsKnown = true;
    if (slope > best.Slope)
    {
      best.Slope = slope;
      best.Angle = angle;
    }
  };
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const Id before = SurfaceMesh::Previous(*g);
    const double corner = mesh.CornerAngle(*g);
    const double first = (values[mesh.Destination(*g)] - values[v]) / mesh.Length(*g);
    const double second = (values[mesh.Origin(before)] - values[v]) / mesh.Length(before);
    if (std::isfinite(first))
    {
      take(-first, mesh.PolarAngle(*g));
    }
    if (std::isfinite(second))
    {
      take(-second, mesh.PolarAngle(*g) + corner);
    }
    if (std::isfinite(first) && std::isfinite(second) && !mesh.IsMollified(SurfaceMesh::Face(*g)))
    {
      const Point2 fall{ -first, (first * std::cos(corner) - second) / std::sin(corner) };
      const double direction = std::atan2(fall.Y, fall.X);
      if (direction > 0.0 && direction < corner)
      {
        take(Norm(fall.X, fall.Y), mesh.PolarAngle(*g) + direction);
      }
    }
  }
  return best;
}
}
