// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGCloudLocator.h"

#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// The nearest points around a point: as many as a triangle mesh has.
constexpr int NeighborCount = 6;

/// What is looked at again around the distance of the point that was found: rounding of it.
constexpr double Slack = 1.0 + 1e-12;

bool IsFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

double Distance(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
}

//------------------------------------------------------------------------------
vtkDGGCloudLocator::vtkDGGCloudLocator(const double* positions, dgg::Id numberOfPoints)
  : Positions(positions)
{
  std::array<double, 3> low;
  std::array<double, 3> high;
  low.fill(dgg::Infinity);
  high.fill(-dgg::Infinity);
  for (dgg::Id v = 0; v < numberOfPoints; ++v)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(v);
    if (IsFinite(p))
    {
      this->Ids.push_back(v);
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  if (this->Ids.empty())
  {
    return;
  }
  this->Diagonal = Distance(low.data(), high.data());
  for (int c = 0; c < 3; ++c)
  {
    this->Middle[c] = 0.5 * low[c] + 0.5 * high[c];
  }
  this->Scale = this->Diagonal > 0.0 ? std::ldexp(1.0, -std::ilogb(this->Diagonal)) : 1.0;

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Ids.size()));
  for (std::size_t i = 0; i < this->Ids.size(); ++i)
  {
    double local[3];
    this->ToLocal(positions + 3 * static_cast<std::size_t>(this->Ids[i]), local);
    points->SetPoint(static_cast<vtkIdType>(i), local);
  }
  this->Points->SetPoints(points);
  this->Locator->SetDataSet(this->Points);
  this->Locator->BuildLocator();
}

//------------------------------------------------------------------------------
void vtkDGGCloudLocator::ToLocal(const double position[3], double local[3]) const
{
  for (int c = 0; c < 3; ++c)
  {
    local[c] = this->Scale * (position[c] - this->Middle[c]);
  }
}

//------------------------------------------------------------------------------
bool vtkDGGCloudLocator::FindClosestPoint(
  const double position[3], dgg::SurfacePoint& place, double& distance)
{
  if (this->Ids.empty())
  {
    return false;
  }
  double local[3];
  this->ToLocal(position, local);
  const vtkIdType first = this->Locator->FindClosestPoint(local);
  if (first < 0)
  {
    return false;
  }
  double found[3];
  this->Points->GetPoint(first, found);
  this->Locator->FindPointsWithinRadius(Slack * Distance(local, found), local, this->Close);
  this->Close->InsertUniqueId(first);

  // By the coordinates as they are: those of the search have been rounded.
  dgg::Id closest = dgg::NoId;
  distance = dgg::Infinity;
  for (vtkIdType i = 0; i < this->Close->GetNumberOfIds(); ++i)
  {
    const dgg::Id candidate = this->Ids[this->Close->GetId(i)];
    const double d = Distance(position, this->Positions + 3 * static_cast<std::size_t>(candidate));
    if (d < distance || (d == distance && candidate < closest))
    {
      closest = candidate;
      distance = d;
    }
  }
  const double* p = this->Positions + 3 * static_cast<std::size_t>(closest);
  place = dgg::SurfacePoint::NearVertex(
    closest, { { position[0] - p[0], position[1] - p[1], position[2] - p[2] } });
  return true;
}

//------------------------------------------------------------------------------
double vtkDGGCloudLocator::GetReach(const dgg::SurfacePoint& place)
{
  const double* p = this->Positions + 3 * static_cast<std::size_t>(place.Vertex);
  double local[3];
  this->ToLocal(p, local);
  this->Locator->FindClosestNPoints(NeighborCount + 1, local, this->Close); // with itself
  double reach = 0.0;
  for (vtkIdType i = 0; i < this->Close->GetNumberOfIds(); ++i)
  {
    const dgg::Id neighbor = this->Ids[this->Close->GetId(i)];
    reach = std::max(reach, Distance(p, this->Positions + 3 * static_cast<std::size_t>(neighbor)));
  }
  return this->Close->GetNumberOfIds() > NeighborCount ? reach : 0.0;
}
