// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The diagram of a face that the published isolines follow.
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggApolloniusDiagram.h"

#include <algorithm>
#include <cmath>

using namespace dgg;
using namespace dggtest;

namespace
{
using Corners = std::array<Point2, 3>;

Point2 PlaceOn(const Corners& corners, int side, double x)
{
  const Point2 way = Difference(corners[(side + 1) % 3], corners[side]);
  const double length = Norm(way.X, way.Y);
  return { corners[side].X + x / length * way.X, corners[side].Y + x / length * way.Y };
}

Point2 PlaceOf(const Corners& corners, const WeightedSite& site)
{
  return PlaceOn(corners, site.Side, site.X);
}

std::vector<ApolloniusNode> NodesInside(const ApolloniusDiagram& diagram)
{
  std::vector<ApolloniusNode> inside;
  for (const ApolloniusNode& node : diagram.GetNodes())
  {
    if (node.Side < 0)
    {
      inside.push_back(node);
    }
  }
  return inside;
}

/// How much a site is later at a point than the first one.
std::vector<double> Delays(
  const Corners& corners, const std::vector<WeightedSite>& sites, const Point2& p, double& first)
{
  std::vector<double> delays;
  for (const WeightedSite& site : sites)
  {
    delays.push_back(site.Weight + Distance(p, PlaceOf(corners, site)));
  }
  first = *std::min_element(delays.begin(), delays.end());
  for (double& delay : delays)
  {
    delay -= first;
  }
  return delays;
}

/// The points at which three sites tie and no other one is nearer, from the equations of all
/// triples (thesis, section on the additively weighted diagram).
std::vector<Point2> BruteForceNodes(
  const Corners& corners, const std::vector<WeightedSite>& sites, double margin)
{
  std::vector<Point2> nodes;
  const std::size_t n = sites.size();
  for (std::size_t a = 0; a < n; ++a)
  {
    for (std::size_t b = a + 1; b < n; ++b)
    {
      for (std::size_t c = b + 1; c < n; ++c)
      {
        const Point2 q = PlaceOf(corners, sites[a]);
        const double w = sites[a].Weight;
        const Point2 u = Difference(PlaceOf(corners, sites[b]), q);
        const Point2 v = Difference(PlaceOf(corners, sites[c]), q);
        // With p - q = x and |x| = r: u.x = (|u|^2 - s^2) / 2 - s r for s = w_b - w, and so for v.
        const double s = sites[b].Weight - w;
        const double t = sites[c].Weight - w;
        const double determinant = Cross(u, v);
        if (std::abs(determinant) < 1e-9)
        {
          continue;
        }
        auto solve = [&](double first, double second) {
          return Point2{ (first * v.Y - second * u.Y) / determinant,
            (second * u.X - first * v.X) / determinant };
        };
        const Point2 p0 = solve(0.5 * (Dot(u, u) - s * s), 0.5 * (Dot(v, v) - t * t));
        const Point2 p1 = solve(-s, -t);
        const double qa = Dot(p1, p1) - 1.0;
        const double qb = Dot(p0, p1);
        const double qc = Dot(p0, p0);
        const double root = qb * qb - qa * qc;
        if (root < 0.0)
        {
          continue;
        }
        for (const double sign : { -1.0, 1.0 })
        {
          const double r = (-qb + sign * std::sqrt(root)) / qa;
          const Point2 p{ q.X + p0.X + r * p1.X, q.Y + p0.Y + r * p1.Y };
          bool isInside = std::isfinite(p.X) && std::isfinite(p.Y);
          for (int k = 0; k < 3 && isInside; ++k)
          {
            isInside = Cross(Difference(corners[(k + 1) % 3], corners[k]),
                         Difference(p, corners[k])) > margin;
          }
          double first = 0.0;
          const std::vector<double> delays = Delays(corners, sites, p, first);
          if (isInside && std::max(delays[a], std::max(delays[b], delays[c])) < 1e-9)
          {
            nodes.push_back(p);
          }
        }
      }
    }
  }
  return nodes;
}

const Corners Scalene = { { { 0.0, 0.0 }, { 4.0, 0.0 }, { 1.0, 3.0 } } };

/// Sites as a field makes them: corners and Steiner points, weights of a distance.
template <typename Field>
std::vector<WeightedSite> SitesOf(const Corners& corners, int steinerPoints, Field&& field)
{
  std::vector<WeightedSite> sites;
  for (int side = 0; side < 3; ++side)
  {
    const double length = Distance(corners[side], corners[(side + 1) % 3]);
    for (int i = 0; i <= steinerPoints; ++i)
    {
      const double x = length * i / (steinerPoints + 1);
      sites.push_back({ side, x, field(PlaceOn(corners, side, x)) });
    }
  }
  return sites;
}
}

TEST(ApolloniusDiagram, IsThatOfAllTriples)
{
  Random random(9);
  ApolloniusDiagram diagram;
  int found = 0;
  for (int i = 0; i < 150; ++i)
  {
    const Corners corners = { { { 0.0, 0.0 }, { random.Uniform(0.5, 2.0), 0.0 },
      { random.Uniform(-0.5, 2.5), random.Uniform(0.2, 2.0) } } };
    // Smooth, with a ridge, and rough.
    const Point2 one{ random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
    const Point2 two{ random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
    const std::vector<WeightedSite> sites = SitesOf(corners, i % 5, [&](const Point2& p) {
      return i % 3 == 0 ? Distance(p, one)
        : i % 3 == 1    ? std::min(Distance(p, one), Distance(p, two))
                        : random.Uniform(0.0, 0.5);
    });
    diagram.Build(corners, sites);
    const std::vector<ApolloniusNode> inside = NodesInside(diagram);
    for (const ApolloniusNode& node : inside)
    {
      double first = 0.0;
      std::vector<double> delays = Delays(corners, sites, node.Place, first);
      std::sort(delays.begin(), delays.end());
      EXPECT_LT(delays[2], 1e-7) << i;
      EXPECT_NEAR(node.Distance, first, 1e-7);
    }
    for (const Point2& expected : BruteForceNodes(corners, sites, 1e-6))
    {
      const bool isThere = std::any_of(inside.begin(), inside.end(),
        [&](const ApolloniusNode& node) { return Distance(node.Place, expected) < 1e-5; });
      EXPECT_TRUE(isThere) << i << ": (" << expected.X << ", " << expected.Y << ')';
      ++found;
    }
  }
  EXPECT_GT(found, 300);
}

TEST(ApolloniusDiagram, ManySitesAreFeasible)
{
  ApolloniusDiagram diagram;
  Random random(3);
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<WeightedSite> sites = SitesOf(Scalene, 20, [&](const Point2& p) {
      return i == 0 ? std::min(Distance(p, { -1.0, -2.0 }), Distance(p, { 3.0, 5.0 }))
        : i == 1    ? 1.0
                    : random.Uniform(0.0, 0.3);
    });
    EXPECT_EQ(sites.size(), 63u);
    diagram.Build(Scalene, sites);
    const std::vector<ApolloniusNode> inside = NodesInside(diagram);
    EXPECT_GT(inside.size(), 10u) << i;
    for (const Point2& expected : BruteForceNodes(Scalene, sites, 1e-6))
    {
      EXPECT_TRUE(std::any_of(inside.begin(), inside.end(),
        [&](const ApolloniusNode& node) { return Distance(node.Place, expected) < 1e-5; }))
        << i;
    }
    for (const ApolloniusNode& node : diagram.GetNodes())
    {
      double first = 0.0;
      std::vector<double> delays = Delays(Scalene, sites, node.Place, first);
      std::sort(delays.begin(), delays.end());
      EXPECT_LT(delays[node.Side < 0 ? 2 : 1], 1e-7) << i;
    }
  }
}

TEST(ApolloniusDiagram, TiesAndDominatedSites)
{
  ApolloniusDiagram diagram;
  // A source in line with a side: each site is in the reach of the one before.
  diagram.Build(Scalene, SitesOf(Scalene, 3, [](const Point2& p) {
    return Distance(p, { -1.0, 0.0 });
  }));
  for (const ApolloniusNode& node : diagram.GetNodes())
  {
    EXPECT_TRUE(std::isfinite(node.Distance));
    EXPECT_TRUE(node.Side != 0 || node.X > 3.9 || node.X < 0.1 || node.Distance > 1.0);
  }
  // A source at a corner: that corner has all of it.
  diagram.Build(Scalene, SitesOf(Scalene, 4, [](const Point2& p) { return Norm(p.X, p.Y); }));
  for (const ApolloniusNode& node : NodesInside(diagram))
  {
    EXPECT_NEAR(node.Distance, Norm(node.Place.X, node.Place.Y), 2.0);
  }
  // All weights equal or zero, on a regular triangle: everything ties.
  const Corners regular = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.5, std::sqrt(0.75) } } };
  for (const double weight : { 0.0, 1.0 })
  {
    for (const int k : { 0, 1, 2, 5, 20 })
    {
      const std::vector<WeightedSite> sites =
        SitesOf(regular, k, [=](const Point2&) { return weight; });
      diagram.Build(regular, sites);
      const std::vector<ApolloniusNode> inside = NodesInside(diagram);
      ASSERT_GE(inside.size(), 1u);
      double farthest = 0.0;
      for (const ApolloniusNode& node : inside)
      {
        double first = 0.0;
        Delays(regular, sites, node.Place, first);
        EXPECT_NEAR(node.Distance, first, 1e-7);
        farthest = std::max(farthest, node.Distance - weight);
      }
      // The middle is as far from the nearest sites of the three sides.
      const double toSide = std::sqrt(0.75) / 3.0;
      const double toSite = k % 2 == 1 ? 0.0 : 0.5 / (k + 1);
      EXPECT_NEAR(farthest, Norm(toSide, toSite), 1e-9) << k;
    }
  }
  // Needles.
  for (const double height : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    const Corners needle = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.3, height } } };
    diagram.Build(needle, SitesOf(needle, 5, [](const Point2& p) {
      return Distance(p, { 0.4, -0.5 });
    }));
    for (const ApolloniusNode& node : diagram.GetNodes())
    {
      EXPECT_TRUE(std::isfinite(node.Place.X) && std::isfinite(node.Place.Y));
      EXPECT_LT(Norm(node.Place.X, node.Place.Y), 1.1);
    }
  }
}
