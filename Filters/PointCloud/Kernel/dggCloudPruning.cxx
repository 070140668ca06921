// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudPruning.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Limits for the number of sectors around a point in which relays are searched. The width of a
/// sector is the largest angle at the point between a path and a relay that covers its end. A
/// larger number would mostly give empty sectors.
constexpr int MostSectors = 720;
constexpr int LeastSectors = 8;

int NumberOfSectors(double kappa)
{
  const double widest = std::acos(kappa);
  return widest > 0.0 ? std::clamp(static_cast<int>(2.0 * Pi / widest), LeastSectors, MostSectors)
                      : MostSectors;
}
}

CloudPruning::CloudPruning(const CloudPairs& pairs, double accuracy)
  : Pairs(pairs)
  , Kappa(accuracy > 0.0 ? 1.0 / (1.0 + accuracy) : Infinity)
  , Sectors(accuracy > 0.0 ? NumberOfSectors(1.0 / (1.0 + accuracy)) : 1)
  , Last(this->Sectors, -1)
{
}

void CloudPruning::ChooseEdges(
  Id p, const std::vector<Id>& neighbors, const std::vector<double>& chords, std::vector<Id>& kept)
{
  this->Relays.clear();
  std::fill(this->Last.begin(), this->Last.end(), -1);
  this->ChooseFrame(this->Pairs.Normals[p]);
  for (std::size_t i = 0; i < neighbors.size(); ++i)
  {
    const Id q = neighbors[i];
    const double length = this->Pairs.Length(p, q, chords[i]);
    if (length == Infinity)
    {
      continue;
    }
    if (this->Kappa == Infinity)
    {
      if (this->Pairs.IsDirect(p, q, chords[i]))
      {
        kept.push_back(q);
      }
      continue;
    }
    const int sector = this->SectorOf(this->Pairs.Points[q] - this->Pairs.Points[p]);
    if (this->IsCovered(q, length, sector))
    {
      continue;
    }
    if (this->Pairs.IsDirect(p, q, chords[i]))
    {
      this->Relays.push_back({ q, this->Last[sector], length });
      this->Last[sector] = static_cast<std::int32_t>(this->Relays.size()) - 1;
      kept.push_back(q);
    }
  }
}

bool CloudPruning::IsCovered(Id q, double length, int sector)
{
  for (const int turn : { 0, 1, this->Sectors - 1 })
  {
    int s = sector + turn;
    s = s >= this->Sectors ? s - this->Sectors : s;
    for (std::int32_t i = this->Last[s]; i >= 0; i = this->Relays[i].Next)
    {
      const Relay& relay = this->Relays[i];
      const double rest = length - this->Kappa * relay.Length;
      // A path is not shorter than its chord, which excludes most relays.
      const Point3 d = this->Pairs.Points[q] - this->Pairs.Points[relay.Point];
      const double square = Dot(d, d);
      if (!(rest > 0.0) || square > rest * rest)
      {
        continue;
      }
      const double chord = std::sqrt(square);
      if (this->Pairs.IsInReach(relay.Point, q, chord) &&
        this->Pairs.Length(relay.Point, q, chord) <= rest)
      {
        if (this->Pairs.IsDirect(relay.Point, q, chord))
        {
          return true;
        }
      }
    }
  }
  return false;
}

int CloudPruning::SectorOf(const Point3& direction) const
{
  const double angle = std::atan2(Dot(this->AxisY, direction), Dot(this->AxisX, direction));
  const int sector = static_cast<int>((angle + Pi) / (2.0 * Pi) * this->Sectors);
  return std::clamp(sector, 0, this->Sectors - 1);
}

void CloudPruning::ChooseFrame(const Point3& normal)
{
  const double x = std::abs(normal.X);
  const double y = std::abs(normal.Y);
  const double z = std::abs(normal.Z);
  const Point3 other = x <= y && x <= z ? Point3{ 1.0, 0.0, 0.0 }
    : y <= z                            ? Point3{ 0.0, 1.0, 0.0 }
                                        : Point3{ 0.0, 0.0, 1.0 };
  const Point3 side = Cross(normal, other);
  const double length = Norm(side);
  if (!(length > 0.0))
  {
    this->AxisX = { 1.0, 0.0, 0.0 };
    this->AxisY = { 0.0, 1.0, 0.0 };
    return;
  }
  this->AxisX = (1.0 / length) * side;
  this->AxisY = Cross(normal, this->AxisX);
}
}
