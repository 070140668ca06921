// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGCloudLocator.h"

#include "dggStrayPoints.h"

#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The nearest points around a point: as many as a triangle mesh has.
constexpr int NeighborCount = 6;

/// What is looked at again around the distance of the point that was found: rounding of it.
constexpr double Slack = 1.0 + 1e-12;

double Distance(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double MeasureDiagonal(const double* positions, dgg::Id numberOfPoints)
{
  const dgg::StrayPoints stray(positions, numberOfPoints);
  const auto isStray = [&](const dgg::Point3& p) { return stray.IsStray(p); };
  return dgg::CloudFrame(positions, numberOfPoints, isStray).GetDiagonal();
}
}

//------------------------------------------------------------------------------
vtkDGGCloudLocator::vtkDGGCloudLocator(const double* positions, dgg::Id numberOfPoints)
  : Positions(positions)
  , Frame(positions, numberOfPoints)
  , Diagonal(MeasureDiagonal(positions, numberOfPoints))
{
  for (dgg::Id v = 0; v < numberOfPoints; ++v)
  {
    if (dgg::IsFinite(dgg::PointAt(positions, v)))
    {
      this->Ids.push_back(v);
    }
  }
  if (this->Ids.empty())
  {
    return;
  }
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
  const dgg::Point3 p = this->Frame.ToLocal({ position[0], position[1], position[2] });
  local[0] = p.X;
  local[1] = p.Y;
  local[2] = p.Z;
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
