// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPolygonTriangulator.h"

#include "DGGCompatibility.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Vector = std::array<double, 3>;

Vector Between(const Vector& from, const Vector& to)
{
  return { { to[0] - from[0], to[1] - from[1], to[2] - from[2] } };
}

Vector Normal(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector ab = Between(a, b);
  const Vector ac = Between(a, c);
  Vector normal;
  vtkMath::Cross(ab.data(), ac.data(), normal.data());
  return normal;
}

double SquaredLength(const Vector& v)
{
  return vtkMath::Dot(v.data(), v.data());
}

/// Coordinates relative to the first corner and in units of the extent, so that no product
/// overflows or vanishes.
std::vector<Vector> Normalize(const double* points, const std::vector<dgg::Id>& corners)
{
  const double* origin = points + 3 * static_cast<std::size_t>(corners[0]);
  std::vector<Vector> local;
  double extent = 0.0;
  for (const dgg::Id corner : corners)
  {
    const double* p = points + 3 * static_cast<std::size_t>(corner);
    local.push_back({ { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] } });
    for (const double x : local.back())
    {
      extent = std::max(extent, std::abs(x));
    }
  }
  if (extent > 0.0)
  {
    for (Vector& v : local)
    {
      for (double& x : v)
      {
        x /= extent;
      }
    }
  }
  return local;
}

/// Append a triangle unless it names a point twice.
void Append(dgg::Id a, dgg::Id b, dgg::Id c, std::vector<dgg::Id>& triangles)
{
  if (a != b && b != c && c != a)
  {
    triangles.push_back(a);
    triangles.push_back(b);
    triangles.push_back(c);
  }
}
}

//------------------------------------------------------------------------------
dgg::Id DGGPolygonTriangulator::Triangulate(
  const double* points, const std::vector<dgg::Id>& corners, std::vector<dgg::Id>& triangles)
{
  const std::size_t before = triangles.size();
  if (corners.size() == 3)
  {
    Append(corners[0], corners[1], corners[2], triangles);
    return static_cast<dgg::Id>((triangles.size() - before) / 3);
  }
  this->Corners.clear();
  for (const dgg::Id corner : corners)
  {
    if (this->Corners.empty() || this->Corners.back() != corner)
    {
      this->Corners.push_back(corner);
    }
  }
  while (this->Corners.size() > 1 && this->Corners.back() == this->Corners.front())
  {
    this->Corners.pop_back();
  }

  const auto& c = this->Corners;
  if (c.size() == 3)
  {
    Append(c[0], c[1], c[2], triangles);
  }
  else if (c.size() == 4)
  {
    this->CutQuad(points, triangles);
  }
  else if (c.size() > 4)
  {
    this->CutEars(points, triangles);
  }
  return static_cast<dgg::Id>((triangles.size() - before) / 3);
}

//------------------------------------------------------------------------------
void DGGPolygonTriangulator::CutQuad(const double* points, std::vector<dgg::Id>& triangles)
{
  const auto& c = this->Corners;
  if (c[0] == c[2] || c[1] == c[3])
  {
    return; // folded onto itself: no area
  }
  // A diagonal lies inside when both triangles look the same way.
  const std::vector<Vector> p = Normalize(points, c);
  const Vector n012 = Normal(p[0], p[1], p[2]);
  const Vector n023 = Normal(p[0], p[2], p[3]);
  const Vector n013 = Normal(p[0], p[1], p[3]);
  const Vector n123 = Normal(p[1], p[2], p[3]);
  const bool inside02 = vtkMath::Dot(n012.data(), n023.data()) > 0.0;
  const bool inside13 = vtkMath::Dot(n013.data(), n123.data()) > 0.0;
  const bool shorter13 = SquaredLength(Between(p[1], p[3])) < SquaredLength(Between(p[0], p[2]));
  if (inside13 && (!inside02 || shorter13))
  {
    Append(c[0], c[1], c[3], triangles);
    Append(c[1], c[2], c[3], triangles);
  }
  else
  {
    Append(c[0], c[1], c[2], triangles);
    Append(c[0], c[2], c[3], triangles);
  }
}

//------------------------------------------------------------------------------
void DGGPolygonTriangulator::CutEars(const double* points, std::vector<dgg::Id>& triangles)
{
  const auto& c = this->Corners;
  const std::vector<Vector> local = Normalize(points, c);
  const auto n = static_cast<vtkIdType>(c.size());
  this->Polygon->PointIds->SetNumberOfIds(n);
  this->Polygon->Points->SetDataTypeToDouble();
  this->Polygon->Points->SetNumberOfPoints(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    this->Polygon->PointIds->SetId(i, i);
    this->Polygon->Points->SetPoint(i, local[i].data());
  }
  this->Ears->Reset();
  const bool cut = vtkDGGTriangulateMacro(this->Polygon, this->Ears);
  if (cut && this->Ears->GetNumberOfIds() == 3 * (n - 2))
  {
    for (vtkIdType i = 0; i < this->Ears->GetNumberOfIds(); i += 3)
    {
      Append(c[this->Ears->GetId(i)], c[this->Ears->GetId(i + 1)], c[this->Ears->GetId(i + 2)],
        triangles);
    }
    return;
  }
  ++this->NumberOfFans;
  for (vtkIdType i = 1; i + 1 < n; ++i)
  {
    Append(c[0], c[i], c[i + 1], triangles);
  }
}
