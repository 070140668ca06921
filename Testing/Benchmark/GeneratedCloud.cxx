// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeneratedCloud.h"

#include "RandomNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace
{
constexpr unsigned int Seed = 20190523u;
constexpr double CylinderHeight = 3.0;

/// Numbers per point that show distances.
template <std::size_t N>
using Places = std::vector<std::array<double, N>>;

template <std::size_t N>
std::shared_ptr<Places<N>> MakePlaces(int count)
{
  auto places = std::make_shared<Places<N>>();
  places->reserve(static_cast<std::size_t>(count));
  return places;
}

void AddPoint(GeneratedCloud& cloud, double x, double y, double z)
{
  cloud.Points.insert(cloud.Points.end(), { x, y, z });
}
}

GeneratedCloud RandomSquare(int count)
{
  return RandomSheets(count, 0.0);
}

GeneratedCloud RandomCylinder(int count)
{
  RandomNumbers random(Seed);
  GeneratedCloud cloud;
  auto places = MakePlaces<2>(count);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * dgg::Pi * random();
    const double height = CylinderHeight * random();
    places->push_back({ angle, height });
    AddPoint(cloud, std::cos(angle), std::sin(angle), height);
  }
  cloud.Distance = [places](dgg::Id a, dgg::Id b) {
    const double turn = std::abs((*places)[a][0] - (*places)[b][0]);
    return std::hypot(std::min(turn, 2.0 * dgg::Pi - turn), (*places)[a][1] - (*places)[b][1]);
  };
  return cloud;
}

GeneratedCloud RandomSphere(int count, double noise, double density)
{
  RandomNumbers random(Seed);
  GeneratedCloud cloud;
  auto places = MakePlaces<3>(count);
  while (places->size() < static_cast<std::size_t>(count))
  {
    const double z = 2.0 * random() - 1.0;
    const double angle = 2.0 * dgg::Pi * random();
    if (density * random() > 1.0 + (density - 1.0) * 0.5 * (z + 1.0))
    {
      continue;
    }
    const double r = std::sqrt(1.0 - z * z);
    std::array<double, 3> p = { { r * std::cos(angle), r * std::sin(angle), z } };
    if (noise > 0.0)
    {
      for (double& x : p)
      {
        x += noise * random.GetNormal();
      }
    }
    AddPoint(cloud, p[0], p[1], p[2]);
    places->push_back(p);
  }
  cloud.Distance = [places](dgg::Id a, dgg::Id b) {
    const auto& p = (*places)[a];
    const auto& q = (*places)[b];
    const double cross =
      std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
    return std::atan2(cross, p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
  };
  return cloud;
}

GeneratedCloud RandomSheets(int count, double gap)
{
  RandomNumbers random(Seed);
  GeneratedCloud cloud;
  auto places = MakePlaces<3>(count);
  for (int i = 0; i < count; ++i)
  {
    const double x = random();
    const double y = random();
    const double z = 2 * i < count ? 0.0 : gap;
    places->push_back({ x, y, z });
    AddPoint(cloud, x, y, z);
  }
  cloud.Distance = [places](dgg::Id a, dgg::Id b) {
    const auto& p = (*places)[a];
    const auto& q = (*places)[b];
    return p[2] == q[2] ? std::hypot(p[0] - q[0], p[1] - q[1]) : dgg::Infinity;
  };
  return cloud;
}
