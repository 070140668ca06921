// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Published isoline method: Apollonius diagram of a face, and errors.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "IsolineChecks.h"
#include "TestMeshes.h"

#include "dggApolloniusDiagram.h"
#include "dggIsolines.h"

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

/// Returns the delay of each site at a point relative to the first arrival.
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

/// Returns the points at which three sites tie and no other site is nearer, from the equations of
/// all triples (thesis, section on the additively weighted diagram).
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
        // With p - q = x and |x| = r: u.x = (|u|^2 - s^2) / 2 - s r for s = w_b - w; the equation
        // of v is analogous.
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

/// Returns the sites of a field: corners and Steiner points with the distances as weights.
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
  for (int i = 0; i < 153; ++i)
  {
    const bool isLarge = i >= 150;
    const Corners corners = isLarge ? Scalene
                                    : Corners{ { { 0.0, 0.0 }, { random.Uniform(0.5, 2.0), 0.0 },
                                        { random.Uniform(-0.5, 2.5), random.Uniform(0.2, 2.0) } } };
    // Weights from a smooth field, a field with a ridge, and random weights.
    const Point2 one{ random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
    const Point2 two{ random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
    const std::vector<WeightedSite> sites =
      SitesOf(corners, isLarge ? 20 : i % 5, [&](const Point2& p) {
        return i % 3 == 0 ? Distance(p, one)
          : i % 3 == 1    ? std::min(Distance(p, one), Distance(p, two))
                          : random.Uniform(0.0, 0.5);
      });
    diagram.Build(corners, sites);
    for (const ApolloniusNode& node : diagram.GetNodes())
    {
      double first = 0.0;
      std::vector<double> delays = Delays(corners, sites, node.Place, first);
      std::sort(delays.begin(), delays.end());
      EXPECT_LT(delays[node.Side < 0 ? 2 : 1], 1e-7) << i;
      EXPECT_NEAR(node.Distance, first, 1e-7);
    }
    const std::vector<ApolloniusNode> inside = NodesInside(diagram);
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

TEST(ApolloniusDiagram, TiesAndNeedles)
{
  ApolloniusDiagram diagram;
  // All weights are equal or zero on a regular triangle, so that all sites tie.
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
      // The center has the same distance from the nearest sites of all three sides.
      const double toSide = std::sqrt(0.75) / 3.0;
      const double toSite = k % 2 == 1 ? 0.0 : 0.5 / (k + 1);
      EXPECT_NEAR(farthest, Norm(toSide, toSite), 1e-9) << k;
    }
  }
  // Needle triangles.
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

namespace
{
Isolines TracePublished(
  const DistanceField& field, const std::vector<double>& levels, int steinerPoints)
{
  IsolineOptions options;
  options.Method = IsolineMethod::Apollonius;
  options.SteinerPoints = steinerPoints;
  Isolines lines;
  EXPECT_TRUE(Ok(TraceIsolines(field, levels, options, nullptr, nullptr, lines)));
  return lines;
}

/// Mean errors of linear and of published isolines.
struct TraceErrors
{
  TraceErrors(const TestMesh& test, const std::vector<GeodesicSource>& sources)
    : Case(test, sources)
    , Sources(sources)
    , Levels(EvenLevels(Case.Exact, 15))
    , Linear(ErrorOf(Trace(Case.Linear, Levels)))
  {
  }
  double ErrorOf(const Isolines& lines) const
  {
    return MeanErrorOfPieces(this->Case.Mesh, this->Sources, this->Levels, lines);
  }
  double Published(const DistanceField& field, int steinerPoints) const
  {
    return this->ErrorOf(TracePublished(field, this->Levels, steinerPoints));
  }

  FieldCase Case;
  std::vector<GeodesicSource> Sources;
  std::vector<double> Levels;
  double Linear;
};
}

TEST(ApolloniusIsolines, ConvergeInThePlane)
{
  for (const std::vector<GeodesicSource>& sources :
    { std::vector<GeodesicSource>{ VertexSource(48) },
      std::vector<GeodesicSource>{ VertexSource(27), VertexSource(93, 0.2) } })
  {
    const TraceErrors errors(Plane(10, 10, 0.2), sources);
    double last = errors.Linear;
    for (const int k : { 0, 1, 2, 5, 11 })
    {
      const double error = errors.Published(errors.Case.Local, k);
      EXPECT_LT(error, last) << k;
      last = error;
    }
    EXPECT_LT(10.0 * last, errors.Linear);
  }
}

TEST(ApolloniusIsolines, BeatLinearInterpolation)
{
  const std::pair<TestMesh, double> cases[] = { { Icosphere(3), 2.5 }, { Ellipsoid(3, 0.4), 2.5 },
    { Torus(24, 14), 1.5 } };
  for (const auto& [test, factor] : cases)
  {
    const TraceErrors errors(test, { VertexSource(3) });
    EXPECT_LT(factor * errors.Published(errors.Case.Local, 2), errors.Linear);
    EXPECT_LT(factor * errors.Published(errors.Case.ExactWithSources, 2), errors.Linear);
    EXPECT_LT(1.5 * errors.Published(errors.Case.Linear, 2), errors.Linear); // with fitted sources
  }
}

TEST(ApolloniusIsolines, LoopsWithinAFaceAreFound)
{
  const TestMesh test = SingleTriangle();
  const FieldCase c(test, { FaceSourceAt(Build(test), 0, { { 0.3, 0.3, 0.4 } }) });
  const std::vector<double> levels = { 0.9 };
  const Isolines lines = TracePublished(c.ExactWithSources, levels, 5);
  ASSERT_EQ(lines.Lines.size(), 1u);
  EXPECT_TRUE(AllClosed(lines));
  ExpectSound(c.ExactWithSources, levels, lines, "loop");
}
