// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The logarithm of Green's functions and its integrals.
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggSingularPart.h"

#include <cmath>
#include <numeric>

namespace dggtest
{
namespace
{
/// Of the second kind: Simpson's rule after a substitution that is flat at both ends, for what is
/// singular there.
double Integrate(const std::function<double(double)>& f, double begin, double end)
{
  const int steps = 4000;
  double sum = 0.0;
  for (int k = 1; k < steps; ++k)
  {
    const double t = static_cast<double>(k) / steps;
    const double x = begin + (end - begin) * t * t * t * (10.0 - t * (15.0 - 6.0 * t));
    const double slope = 30.0 * t * t * (1.0 - t) * (1.0 - t);
    sum += (k % 2 ? 4.0 : 2.0) * f(x) * slope;
  }
  return sum * (end - begin) / (3.0 * steps);
}
}

TEST(Logarithm, IsSmoothAtItsEndAndLogarithmicAtThePole)
{
  const double radius = 0.7;
  const double angle = 5.0;
  const dgg::Logarithm s(radius, angle);
  EXPECT_EQ(s.At(radius), 0.0);
  EXPECT_EQ(s.At(2.0 * radius), 0.0);
  EXPECT_EQ(s.At(0.0), dgg::Infinity);
  // Value and three derivatives are 0: it goes down like the fourth power.
  const double h = 1e-2;
  EXPECT_NEAR(s.At(radius - 2.0 * h) / s.At(radius - h), 16.0, 0.5);
  // One unit flows out of every small circle.
  const double d = 1e-4;
  EXPECT_NEAR(-(s.At(d * 1.001) - s.At(d * 0.999)) / (0.002 * d) * angle * d, 1.0, 1e-5);
  // Mean over a disk.
  for (const double r : { 0.1, 0.5, 0.7 })
  {
    const double mean = Integrate([&](double t) { return s.At(t) * t; }, 0.0, r) * 2.0 / (r * r);
    EXPECT_NEAR(s.MeanOverDisk(r), mean, 1e-9);
  }
}

TEST(Logarithm, IntegralsAlongSegments)
{
  const dgg::Logarithm s(1.0, 2.0 * dgg::Pi);
  Random random(2);
  for (int k = 0; k < 200; ++k)
  {
    // On the x axis, seen from (px, py): now and then through the pole, or beyond the disk.
    const double length = random.Uniform(0.05, 1.5);
    const double px = random.Uniform(-1.0, 2.0);
    const double py = k % 10 == 0 ? 0.0 : random.Uniform(0.0, 1.3);
    const auto at = [&](double t) { return std::hypot(t - px, py); };
    const double half = py < 1.0 ? std::sqrt(1.0 - py * py) : 0.0;
    // In parts, so that what is not smooth is at ends of them.
    double expected = 0.0;
    std::vector<double> ends{ 0.0, length, px, px - half, px + half };
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const double begin = std::max(0.0, ends[i]);
      const double end = std::min(length, ends[i + 1]);
      if (begin < end)
      {
        expected += Integrate([&](double t) { return s.At(at(t)); }, begin, end);
      }
    }
    EXPECT_NEAR(s.IntegrateAlong(length, at(0.0), at(length)), expected, 1e-8) << k;
    if (py > 0.0)
    {
      // Over the triangle with the pole: by the angle, of what is up to each distance.
      const double moment = 1.0 / (32.0 * dgg::Pi); // of s(t) t up to the radius
      double sector = 0.0;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      {
        const double begin = std::max(0.0, ends[i]);
        const double end = std::min(length, ends[i + 1]);
        if (begin < end)
        {
          sector += Integrate(
            [&](double t) {
              const double r = at(t);
              const double up = r < 1.0 ? s.MeanOverDisk(r) * r * r / 2.0 : moment;
              return up * py / (r * r);
            },
            begin, end);
        }
      }
      EXPECT_NEAR(s.IntegrateSector(length, at(0.0), at(length)), sector, 1e-8) << k;
    }
  }
}

TEST(SingularPart, SumsAreThoseOfTheDisk)
{
  // On flat surfaces: loads sum to 0, integrals to R^2 / 16, whatever the triangles.
  const TestMesh plane = Plane(16, 16, 0.25);
  const dgg::SurfaceMesh mesh = Build(plane);
  dgg::PoissonSystem system(mesh);
  ASSERT_TRUE(system.Analyze({}, nullptr).IsOk());
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 270, { { 0.2, 0.5, 0.3 } });
  dgg::ExactOptions options;
  dgg::ExactResult exact;
  ASSERT_TRUE(dgg::ExactGeodesics(mesh).Run({ { pole, 0.0 } }, options, exact).IsOk());
  dgg::PoleFace face{ 270, pole.Barycentric, {} };
  for (int k = 0; k < 3; ++k)
  {
    face.Distances[k] = dgg::DistanceToCorner(mesh, 270, pole.Barycentric, k);
  }
  for (const double radius : { 3.0, 5.5 })
  {
    dgg::SingularPart part(system);
    part.Assemble(dgg::Logarithm(radius, 2.0 * dgg::Pi), exact.Distances, { face });
    const auto& loads = part.GetLoads();
    const auto& integrals = part.GetIntegrals();
    EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 0.0, 1e-13);
    // Closed forms near the pole, three nodes per face away from it.
    EXPECT_NEAR(std::accumulate(integrals.begin(), integrals.end(), 0.0) / (radius * radius / 16.0),
      1.0, 2e-3);
    // Against a function that is linear: the integral of grad s is 0, as s is even.
    double first = 0.0;
    double second = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      first += loads[v] * plane.Point(v)[0];
      second += loads[v] * plane.Point(v)[1];
    }
    EXPECT_NEAR(first, 0.0, 1e-12);
    EXPECT_NEAR(second, 0.0, 1e-12);
  }
}
}
