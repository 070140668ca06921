// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGCloudLocator.h"

#include "dggOutliers.h"

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
}

//------------------------------------------------------------------------------
DGGCloudLocator::DGGCloudLocator(const double* positions, dgg::Id numberOfPoints)
  : Positions(positions)
{
  const dgg::Outliers far(positions, numberOfPoints, dgg::Outliers::RatioOfFar);
  this->Frame = dgg::CloudFrame(
    positions, numberOfPoints, [&](const dgg::Point3& p) { return far.IsOutlier(p); });
  for (dgg::Id v = 0; v < numberOfPoints; ++v)
  {
    const dgg::Point3 p = dgg::PointAt(positions, v);
    if (dgg::IsFinite(p))
    {
      if (!far.IsOutlier(p))
      {
        this->Ids.push_back(v);
      }
      else if (std::none_of(this->Far.begin(), this->Far.end(), [&](dgg::Id other) {
                 return this->GetDistance(other, positions + 3 * static_cast<std::size_t>(v)) ==
                   0.0;
               }))
      {
        this->Far.push_back(v); // the first in its place
      }
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
void DGGCloudLocator::ToLocal(const double position[3], double local[3]) const
{
  const dgg::Point3 p = this->Frame.ToLocal({ position[0], position[1], position[2] });
  local[0] = p.X;
  local[1] = p.Y;
  local[2] = p.Z;
}

//------------------------------------------------------------------------------
double DGGCloudLocator::GetDistance(dgg::Id point, const double position[3]) const
{
  return Distance(position, this->Positions + 3 * static_cast<std::size_t>(point));
}

//------------------------------------------------------------------------------
/// Points of the search that may be the closest one, all when that is not known: squares of
/// distances may be out of its range.
void DGGCloudLocator::FindCandidates(const double position[3])
{
  this->Candidates.clear();
  double local[3];
  this->ToLocal(position, local);
  const vtkIdType first = this->Locator->FindClosestPoint(local);
  if (first < 0)
  {
    this->Candidates = this->Ids;
    return;
  }
  double found[3];
  this->Points->GetPoint(first, found);
  this->Locator->FindPointsWithinRadius(Slack * Distance(local, found), local, this->Close);
  this->Close->InsertUniqueId(first);
  for (vtkIdType i = 0; i < this->Close->GetNumberOfIds(); ++i)
  {
    this->Candidates.push_back(this->Ids[this->Close->GetId(i)]);
  }
}

//------------------------------------------------------------------------------
bool DGGCloudLocator::FindClosestPoint(
  const double position[3], dgg::SurfacePoint& place, double& distance)
{
  if (this->Ids.empty())
  {
    return false;
  }
  this->FindCandidates(position);
  this->Candidates.insert(this->Candidates.end(), this->Far.begin(), this->Far.end());

  // By the coordinates as they are: those of the search have been rounded.
  dgg::Id closest = dgg::NoId;
  distance = dgg::Infinity;
  for (const dgg::Id candidate : this->Candidates)
  {
    const double d = this->GetDistance(candidate, position);
    if (d < distance || (d == distance && candidate < closest))
    {
      closest = candidate;
      distance = d;
    }
  }
  if (closest == dgg::NoId)
  {
    return false; // beyond the range of double
  }
  const double* p = this->Positions + 3 * static_cast<std::size_t>(closest);
  place = dgg::SurfacePoint::NearVertex(
    closest, { { position[0] - p[0], position[1] - p[1], position[2] - p[2] } });
  return true;
}

//------------------------------------------------------------------------------
double DGGCloudLocator::GetReach(const dgg::SurfacePoint& place)
{
  const double* p = this->Positions + 3 * static_cast<std::size_t>(place.Vertex);
  std::vector<double> distances;
  if (std::any_of(this->Far.begin(), this->Far.end(),
        [&](dgg::Id v) { return this->GetDistance(v, p) == 0.0; }))
  {
    // The others are no neighbours of it.
    for (const dgg::Id v : this->Far)
    {
      distances.push_back(this->GetDistance(v, p));
    }
  }
  else
  {
    double local[3];
    this->ToLocal(p, local);
    this->Locator->FindClosestNPoints(NeighborCount + 1, local, this->Close); // with itself
    for (vtkIdType i = 0; i < this->Close->GetNumberOfIds(); ++i)
    {
      distances.push_back(this->GetDistance(this->Ids[this->Close->GetId(i)], p));
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances.size() > NeighborCount ? distances[NeighborCount] : 0.0;
}
