// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggConeMemory.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Relative; what is not longer than that counts as equally short.
constexpr double Tolerance = 1e-12;
}

bool ConeMemory::Admit(Id h, bool reversed, const Relay& left, const Relay& right, const Cone& cone)
{
  const double length = Distance(cone.Ends[0], cone.Ends[1]);
  const auto abscissa = [&](const Point2& p) {
    const double x = Dot({ p.X - cone.Ends[0].X, p.Y - cone.Ends[0].Y }, cone.Axis);
    return reversed ? length - x : x;
  };
  Light light;
  light.Begin = abscissa(MeetEdge(cone, (reversed ? right : left).Position));
  light.End = abscissa(MeetEdge(cone, (reversed ? left : right).Position));
  light.Foot = abscissa({ 0.0, 0.0 });
  light.Depth = Cross(cone.Ends[0], cone.Axis);
  light.AtBegin = light.DistanceAt(light.Begin);
  light.AtEnd = light.DistanceAt(light.End);

  // Two images are equally far from one point of the line of the edge at most (or from all of it):
  // whichever is nearer at both ends of an interval is so throughout.
  std::vector<Light>& before = this->Entered[h];
  const double slack = Tolerance * length;
  const bool isUseless = std::any_of(before.begin(), before.end(), [&](const Light& other) {
    return other.Begin <= light.Begin + slack && other.End >= light.End - slack &&
      other.DistanceAt(light.Begin) <= light.AtBegin * (1.0 + Tolerance) &&
      other.DistanceAt(light.End) <= light.AtEnd * (1.0 + Tolerance);
  });
  if (!isUseless)
  {
    before.push_back(light);
  }
  return !isUseless;
}

void ConeMemory::Clear()
{
  if (!this->Entered.empty())
  {
    this->LargestSize = this->GetMemorySize();
    this->Entered.clear();
  }
}

std::size_t ConeMemory::GetMemorySize() const
{
  return std::max(this->LargestSize, this->GetCurrentSize());
}

std::size_t ConeMemory::GetCurrentSize() const
{
  // A node has a pointer to the next one, and is in a table of pointers.
  std::size_t size = this->Entered.bucket_count() * sizeof(void*);
  for (const auto& entry : this->Entered)
  {
    size += sizeof(entry) + sizeof(void*) + entry.second.capacity() * sizeof(Light);
  }
  return size;
}
}
