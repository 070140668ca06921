// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The published isolines: the diagram of a face, the cubics of its edges, and the pieces.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggApolloniusDiagram.h"
#include "dggApolloniusParts.h"
#include "dggEdges.h"
#include "dggExactSources.h"
#include "dggFaceProfile.h"
#include "dggHermiteEdge.h"
#include "dggSourceFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

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

/// Everything that belongs to a field of exact distances.
struct FieldCase
{
  FieldCase(const TestMesh& test, const std::vector<GeodesicSource>& sources)
    : Mesh(Build(test))
    , Result(Solve(this->Mesh, ExactEngine::Triangle, sources,
        [](ExactOptions& options) { options.KeepWindows = true; }))
  {
    FindVirtualSources(this->Mesh, sources, this->Result, this->Virtual);
    const double* d = this->Result.Distances.data();
    this->Exact = { &this->Mesh, d, &this->Result.Windows, nullptr };
    this->ExactWithSources = { &this->Mesh, d, &this->Result.Windows, &this->Virtual };
    this->Local = { &this->Mesh, d, nullptr, &this->Virtual };
    this->Plain = { &this->Mesh, d, nullptr, nullptr };
  }
  FieldCase(const FieldCase&) = delete;
  FieldCase& operator=(const FieldCase&) = delete;

  std::vector<double> Levels(int count) const
  {
    const double farthest = LargestFinite(this->Result.Distances);
    std::vector<double> levels;
    for (int i = 1; i <= count; ++i)
    {
      levels.push_back(farthest * i / (count + 1));
    }
    return levels;
  }

  SurfaceMesh Mesh;
  ExactResult Result;
  VirtualSources Virtual;
  DistanceField Exact;
  DistanceField ExactWithSources;
  DistanceField Local;
  DistanceField Plain;
};

struct Parts
{
  Parts(const DistanceField& field, int steinerPoints, const std::vector<double>& levels,
    const ParallelFor& parallel = {})
  {
    const Status status = FindApolloniusParts(
      field, steinerPoints, levels, parallel, {}, this->Crossings, this->Curves);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  }

  std::vector<LevelCrossing> Crossings;
  std::vector<FaceCurve> Curves;
};

/// Coordinates of a crossing in a face.
std::array<double, 3> PlaceIn(const SurfaceMesh& mesh, Id f, const LevelCrossing& crossing)
{
  std::array<double, 3> place{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * f + k;
    if (FindEdge(mesh, h) == crossing.HalfEdge)
    {
      const double t = crossing.X / mesh.Length(h);
      const bool isSame = mesh.Origin(h) == mesh.Origin(crossing.HalfEdge);
      place[k] = isSame ? 1.0 - t : t;
      place[(k + 1) % 3] = isSame ? t : 1.0 - t;
    }
  }
  EXPECT_GT(place[0] + place[1] + place[2], 0.5) << "not on the rim";
  return place;
}

std::vector<std::array<double, 3>> PointsOf(
  const SurfaceMesh& mesh, const Parts& parts, const FaceCurve& curve)
{
  std::vector<std::array<double, 3>> points = curve.Points;
  if (curve.First == NoId)
  {
    points.push_back(points.front());
  }
  else
  {
    points.insert(points.begin(), PlaceIn(mesh, curve.Face, parts.Crossings[curve.First]));
    points.push_back(PlaceIn(mesh, curve.Face, parts.Crossings[curve.Last]));
  }
  return points;
}

/// The measure of the thesis: how far the distance at the middles of segments is from the level,
/// relative to it.
struct MidpointError
{
  explicit MidpointError(const DistanceField& exact)
    : Profile(exact)
  {
  }
  void Add(Id f, const std::array<double, 3>& a, const std::array<double, 3>& b, double level)
  {
    this->Profile.Enter(f);
    const std::array<double, 3> middle{ { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]),
      0.5 * (a[2] + b[2]) } };
    this->Sum += std::abs(this->Profile.At(this->Profile.PlaceOf(middle)) - level) / level;
    ++this->Count;
  }
  double Mean() const { return this->Sum / static_cast<double>(this->Count); }

  FaceProfile Profile;
  double Sum = 0.0;
  std::size_t Count = 0;
};

double ErrorOf(
  const FieldCase& c, const DistanceField& field, int k, const std::vector<double>& levels)
{
  const Parts parts(field, k, levels);
  MidpointError error(c.Exact);
  for (const FaceCurve& curve : parts.Curves)
  {
    const std::vector<std::array<double, 3>> points = PointsOf(c.Mesh, parts, curve);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      error.Add(curve.Face, points[i], points[i + 1], levels[curve.Level]);
    }
  }
  return error.Mean();
}

double LinearError(const FieldCase& c, const std::vector<double>& levels)
{
  MidpointError error(c.Exact);
  for (Id f = 0; f < c.Mesh.GetNumberOfFaces(); ++f)
  {
    for (const double level : levels)
    {
      std::vector<std::array<double, 3>> ends;
      for (int k = 0; k < 3; ++k)
      {
        const double a = c.Result.Distances[c.Mesh.Origin(3 * f + k)];
        const double b = c.Result.Distances[c.Mesh.Destination(3 * f + k)];
        if ((a < level) != (b < level))
        {
          std::array<double, 3> place{ { 0.0, 0.0, 0.0 } };
          place[(k + 1) % 3] = (level - a) / (b - a);
          place[k] = 1.0 - place[(k + 1) % 3];
          ends.push_back(place);
        }
      }
      if (ends.size() == 2)
      {
        error.Add(f, ends[0], ends[1], level);
      }
    }
  }
  return error.Mean();
}

/// Every crossing is an end of one curve in each face that is reached; curves run with the lower
/// side on their left; all points lie in their faces.
void ExpectSound(const DistanceField& field, int k, const std::vector<double>& levels,
  const Parts& parts, const std::string& what)
{
  const SurfaceMesh& mesh = *field.Mesh;
  std::map<std::pair<Id, Id>, int> ends; // face, crossing
  for (const FaceCurve& curve : parts.Curves)
  {
    ASSERT_TRUE(field.IsReached(curve.Face)) << what;
    ASSERT_EQ(curve.First == NoId, curve.Last == NoId) << what;
    if (curve.First == NoId)
    {
      ASSERT_GE(curve.Points.size(), 3u) << what;
    }
    else
    {
      for (const Id end : { curve.First, curve.Last })
      {
        ASSERT_EQ(parts.Crossings[end].Level, curve.Level) << what;
        ++ends[{ curve.Face, end }];
      }
    }
    for (const std::array<double, 3>& p : curve.Points)
    {
      ASSERT_NEAR(p[0] + p[1] + p[2], 1.0, 1e-12) << what;
      ASSERT_GE(std::min(p[0], std::min(p[1], p[2])), -1e-12) << what;
    }
  }
  HermiteEdge edge(field, k);
  for (std::size_t c = 0; c < parts.Crossings.size(); ++c)
  {
    const LevelCrossing& crossing = parts.Crossings[c];
    edge.Enter(crossing.HalfEdge);
    ASSERT_EQ(edge.GetHalfEdge(), crossing.HalfEdge) << what;
    ASSERT_GE(crossing.X, 0.0);
    ASSERT_LE(crossing.X, edge.GetLength());
    Id h = crossing.HalfEdge;
    int faces = 0;
    do
    {
      if (field.IsReached(SurfaceMesh::Face(h)))
      {
        ++faces;
        ASSERT_EQ((ends[{ SurfaceMesh::Face(h), static_cast<Id>(c) }]), 1) << what;
      }
      h = mesh.Twin(h);
    } while (h != NoId && h != crossing.HalfEdge);
    ASSERT_GT(faces, 0) << what;
    // On the interpolant.
    const std::vector<RimNode>& nodes = edge.GetNodes();
    double smallest = Infinity;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const double t = (crossing.X - nodes[i].X) / (nodes[i + 1].X - nodes[i].X);
      if (t > -1e-9 && t < 1.0 + 1e-9)
      {
        smallest = std::min(smallest,
          std::abs((1.0 - t) * nodes[i].Value + t * nodes[i + 1].Value - levels[crossing.Level]));
      }
    }
    ASSERT_LT(smallest, 1e-8 * edge.GetLength()) << what;
  }
  // As many as the signs of the ends say, modulo two.
  std::map<std::pair<Id, Id>, int> counts;
  for (const LevelCrossing& crossing : parts.Crossings)
  {
    ++counts[{ crossing.HalfEdge, crossing.Level }];
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    for (Id h = 3 * f; h < 3 * f + 3 && field.IsReached(f); ++h)
    {
      for (std::size_t l = 0; l < levels.size(); ++l)
      {
        const auto count = counts.find({ FindEdge(mesh, h), static_cast<Id>(l) });
        const bool isOdd = count != counts.end() && count->second % 2 == 1;
        ASSERT_EQ(isOdd,
          (field.Distances[mesh.Origin(h)] < levels[l]) !=
            (field.Distances[mesh.Destination(h)] < levels[l]))
          << what;
      }
    }
  }
}

bool IsSame(const Parts& a, const Parts& b)
{
  return !a.Curves.empty() &&
    std::equal(a.Crossings.begin(), a.Crossings.end(), b.Crossings.begin(), b.Crossings.end(),
      [](const LevelCrossing& x, const LevelCrossing& y) {
        return x.HalfEdge == y.HalfEdge && x.X == y.X && x.Level == y.Level;
      }) &&
    std::equal(a.Curves.begin(), a.Curves.end(), b.Curves.begin(), b.Curves.end(),
      [](const FaceCurve& x, const FaceCurve& y) {
        return x.Face == y.Face && x.Level == y.Level && x.First == y.First && x.Last == y.Last &&
          x.Points == y.Points;
      });
}
}

TEST(ApolloniusDiagram, TwoSitesAreDividedByAHyperbola)
{
  ApolloniusDiagram diagram;
  for (const double later : { 0.0, 0.4, -0.7, 0.9 })
  {
    const std::vector<WeightedSite> sites = { { 0, 1.0, 2.0 }, { 0, 2.0, 2.0 + later } };
    diagram.Build(Scalene, sites);
    ASSERT_EQ(diagram.GetNodes().size(), 2u) << later;
    ASSERT_EQ(diagram.GetEdges().size(), 1u);
    const bool isFirst = diagram.GetNodes()[0].Side == 0;
    const ApolloniusNode& on = diagram.GetNodes()[isFirst ? 0 : 1];
    const ApolloniusNode& across = diagram.GetNodes()[isFirst ? 1 : 0];
    EXPECT_EQ(on.Side, 0);
    EXPECT_NEAR(on.X, 0.5 * (3.0 + later), 1e-13);
    EXPECT_NEAR(on.Distance, 2.0 + 0.5 * (1.0 + later), 1e-13);
    // (x - 3/2)^2 / a^2 - y^2 / b^2 = 1 with foci at the sites: a = later / 2, a^2 + b^2 = 1/4.
    const double a = 0.5 * later;
    const double b2 = 0.25 - a * a;
    const double x = across.Place.X - 1.5;
    const double y = across.Place.Y;
    EXPECT_NEAR(x * x * b2, a * a * (b2 + y * y), 1e-12) << later;
    EXPECT_GE(x * later, 0.0);
    EXPECT_NEAR(across.Distance, 2.0 + Norm(x + 0.5, y), 1e-12);
    ASSERT_TRUE(across.Side == 1 || across.Side == 2);
    const Point2 place = PlaceOn(Scalene, across.Side, across.X);
    EXPECT_NEAR(Distance(place, across.Place), 0.0, 1e-12);
  }
}

TEST(ApolloniusDiagram, ThreeSitesMeetWhereTheyTie)
{
  const std::vector<WeightedSite> corners = { { 0, 0.0, 5.0 }, { 1, 0.0, 5.0 }, { 2, 0.0, 5.0 } };
  ApolloniusDiagram diagram;
  diagram.Build(Scalene, corners);
  ASSERT_EQ(NodesInside(diagram).size(), 1u);
  const ApolloniusNode center = NodesInside(diagram).front();
  EXPECT_NEAR(center.Place.X, 2.0, 1e-12); // the circumcentre of (0,0), (4,0), (1,3)
  EXPECT_NEAR(center.Place.Y, 1.0, 1e-12);
  EXPECT_NEAR(center.Distance, 5.0 + std::sqrt(5.0), 1e-12);
  EXPECT_EQ(diagram.GetEdges().size(), 3u);

  Random random(4);
  for (int i = 0; i < 200; ++i)
  {
    // Any point is the one where three sites meet, with the right weights.
    double b[3] = { random.Uniform(0.1, 1.0), random.Uniform(0.1, 1.0), random.Uniform(0.1, 1.0) };
    const double sum = b[0] + b[1] + b[2];
    Point2 p;
    for (int k = 0; k < 3; ++k)
    {
      p.X += b[k] / sum * Scalene[k].X;
      p.Y += b[k] / sum * Scalene[k].Y;
    }
    std::vector<WeightedSite> sites;
    for (int side = 0; side < 3; ++side)
    {
      WeightedSite site{ side, random.Uniform(0.0, 3.0), 0.0 };
      site.Weight = 7.0 - Distance(p, PlaceOf(Scalene, site));
      sites.push_back(site);
    }
    diagram.Build(Scalene, sites);
    double closest = Infinity;
    for (const ApolloniusNode& node : NodesInside(diagram))
    {
      if (Distance(node.Place, p) < closest)
      {
        closest = Distance(node.Place, p);
        EXPECT_NEAR(node.Distance, 7.0, 1e-8);
      }
    }
    EXPECT_LT(closest, 1e-8) << i;
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

TEST(HermiteEdge, HasValuesAndSlopesOfItsEnds)
{
  const TestMesh test = Plane(8, 8, 0.2);
  const FieldCase c(test, { VertexSource(30) });
  HermiteEdge edge(c.Local, 3);
  const double* source = test.Point(30);
  int smooth = 0;
  for (Id h = 0; h < c.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    edge.Enter(h);
    const Id from = c.Mesh.Origin(edge.GetHalfEdge());
    const Id to = c.Mesh.Destination(edge.GetHalfEdge());
    EXPECT_FALSE(edge.HasRidge());
    const double length = edge.GetLength();
    EXPECT_EQ(edge.At(0.0), c.Result.Distances[from]);
    EXPECT_EQ(edge.At(length), c.Result.Distances[to]);
    auto slopeAt = [&](Id v) {
      const double* p = test.Point(v);
      const double d = c.Result.Distances[v];
      return ((p[0] - source[0]) * (test.Point(to)[0] - test.Point(from)[0]) +
               (p[1] - source[1]) * (test.Point(to)[1] - test.Point(from)[1])) /
        (d * length);
    };
    const double step = 1e-6 * length;
    if (from != 30 && to != 30)
    {
      EXPECT_NEAR((edge.At(step) - edge.At(0.0)) / step, slopeAt(from), 1e-4);
      EXPECT_NEAR((edge.At(length) - edge.At(length - step)) / step, slopeAt(to), 1e-4);
      ++smooth;
    }
    const std::vector<RimNode>& nodes = edge.GetNodes();
    EXPECT_EQ(
      std::count_if(nodes.begin(), nodes.end(), [](const RimNode& n) { return n.IsSite; }), 5);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      EXPECT_LT(nodes[i].X, nodes[i + 1].X);
    }
  }
  EXPECT_GT(smooth, 100);
}

TEST(HermiteEdge, KeepsRidgesSharp)
{
  const TestMesh test = Plane(10, 10, 0.2);
  const Id first = 27;
  const Id second = 93;
  const FieldCase c(test, { VertexSource(first), VertexSource(second, 0.2) });
  HermiteEdge edge(c.Local, 2);
  int ridges = 0;
  for (Id h = 0; h < c.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    edge.Enter(h);
    if (!edge.HasRidge())
    {
      continue;
    }
    ++ridges;
    const double* a = test.Point(c.Mesh.Origin(edge.GetHalfEdge()));
    const double* b = test.Point(c.Mesh.Destination(edge.GetHalfEdge()));
    for (const double t : { 0.1, 0.3, 0.5, 0.8 })
    {
      const double x = (1.0 - t) * a[0] + t * b[0];
      const double y = (1.0 - t) * a[1] + t * b[1];
      const double exact = std::min(std::hypot(x - test.Point(first)[0], y - test.Point(first)[1]),
        0.2 + std::hypot(x - test.Point(second)[0], y - test.Point(second)[1]));
      EXPECT_NEAR(edge.At(t * edge.GetLength()), exact, 1e-10);
    }
  }
  EXPECT_GT(ridges, 30);
}

TEST(ApolloniusParts, AreSoundOnAnySurface)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  for (const NamedMesh& named : SoundMeshes())
  {
    meshes.push_back(named);
  }
  std::size_t curves = 0;
  for (const NamedMesh& named : meshes)
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const FieldCase c(named.Mesh,
      { VertexSource(0),
        { RandomSurfacePoints(mesh, 3, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } });
    std::vector<double> levels = c.Levels(5);
    levels.push_back(0.01 * mesh.GetMeanEdgeLength());
    levels.push_back(c.Result.Distances[mesh.GetNumberOfVertices() / 2]); // through a vertex
    if (!(levels.back() < Infinity))
    {
      levels.pop_back();
    }
    for (const int k : { 0, 2 })
    {
      for (const DistanceField* field : { &c.Local, &c.ExactWithSources })
      {
        const Parts parts(*field, k, levels);
        ExpectSound(*field, k, levels, parts, named.Name);
        curves += parts.Curves.size();
      }
    }
  }
  EXPECT_GT(curves, 10000u);
}

TEST(ApolloniusParts, AreSoundForFieldsThatAreNoDistances)
{
  const TestMesh test = Icosphere(2);
  const SurfaceMesh mesh = Build(test);
  Random random(3);
  std::vector<double> values;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    values.push_back(v % 11 == 0 ? Infinity : random.Uniform(0.0, 5.0));
  }
  values[7] = std::nan("");
  VirtualSources fitted;
  FitVirtualSources(mesh, values.data(), {}, fitted);
  const DistanceField field{ &mesh, values.data(), nullptr, &fitted };
  const DistanceField bare{ &mesh, values.data(), nullptr, nullptr };
  const std::vector<double> levels = { 3.0, 1.0, 2.0, 1.0, 2.5 };
  for (const int k : { 0, 1, 5 })
  {
    const Parts parts(field, k, levels);
    EXPECT_GT(parts.Curves.size(), 100u);
    ExpectSound(field, k, levels, parts, "random");
    // Without virtual sources they are fitted.
    EXPECT_TRUE(IsSame(parts, Parts(bare, k, levels)));
  }
}

TEST(ApolloniusParts, LoopsWithinAFaceAreFound)
{
  const TestMesh test = SingleTriangle();
  const SurfaceMesh mesh = Build(test);
  SurfacePoint inside;
  inside.On = SurfacePoint::Support::Face;
  inside.Face = 0;
  inside.Barycentric = { { 0.3, 0.3, 0.4 } };
  const FieldCase c(test, { { inside, 0.0 } });
  const std::vector<double> levels = { 0.9 };
  const Parts parts(c.ExactWithSources, 5, levels);
  ASSERT_EQ(parts.Curves.size(), 1u);
  EXPECT_EQ(parts.Curves[0].First, NoId);
  EXPECT_TRUE(parts.Crossings.empty());
  ExpectSound(c.ExactWithSources, 5, levels, parts, "loop");
}

TEST(ApolloniusParts, LowerSideIsOnTheLeft)
{
  const FieldCase c(Icosphere(3), { VertexSource(3) });
  const std::vector<double> levels = c.Levels(7);
  const Parts parts(c.ExactWithSources, 2, levels);
  FaceProfile profile(c.Exact);
  int right = 0;
  int wrong = 0;
  for (const FaceCurve& curve : parts.Curves)
  {
    profile.Enter(curve.Face);
    const std::vector<std::array<double, 3>> points = PointsOf(c.Mesh, parts, curve);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const Point2 a = profile.PlaceOf(points[i]);
      const Point2 b = profile.PlaceOf(points[i + 1]);
      const FieldSample sample = profile.SampleAt({ 0.5 * (a.X + b.X), 0.5 * (a.Y + b.Y) });
      ++(Cross(Difference(b, a), sample.Gradient) <= 0.0 ? right : wrong);
    }
  }
  EXPECT_GT(right, 1000);
  EXPECT_LT(100 * wrong, right); // on ridges the gradient may be that of the other side
}

TEST(ApolloniusParts, ConvergeInThePlane)
{
  const FieldCase one(Plane(10, 10, 0.2), { VertexSource(48) });
  const FieldCase two(Plane(10, 10, 0.2), { VertexSource(27), VertexSource(93, 0.2) });
  for (const FieldCase* c : { &one, &two })
  {
    const std::vector<double> levels = c->Levels(15);
    double last = LinearError(*c, levels);
    for (const int k : { 0, 1, 2, 5, 11 })
    {
      const double error = ErrorOf(*c, c->Local, k, levels);
      EXPECT_LT(error, last) << k;
      last = error;
    }
    EXPECT_LT(10.0 * last, LinearError(*c, levels));
  }
}

TEST(ApolloniusParts, BeatLinearInterpolation)
{
  for (const TestMesh& test : { Icosphere(3), Ellipsoid(3, 0.4), Torus(24, 14) })
  {
    const FieldCase c(test, { VertexSource(3) });
    const std::vector<double> levels = c.Levels(15);
    const double linear = LinearError(c, levels);
    EXPECT_LT(3.0 * ErrorOf(c, c.Local, 2, levels), linear);
    EXPECT_LT(3.0 * ErrorOf(c, c.ExactWithSources, 2, levels), linear);
    EXPECT_LT(2.0 * ErrorOf(c, c.Plain, 2, levels), linear); // sources fitted
  }
}

TEST(ApolloniusParts, UnitsDoNotMatter)
{
  const TestMesh test = Torus(16, 10);
  const FieldCase c(test, { VertexSource(3) });
  const std::vector<double> levels = c.Levels(9);
  const Parts expected(c.Local, 2, levels);
  const Parts expectedFitted(c.Plain, 2, levels);
  for (const double factor : { 0x1p20, 0x1p-20 }) // powers of two: bit for bit
  {
    const FieldCase scaled(Scaled(test, factor), { VertexSource(3) });
    std::vector<double> scaledLevels = levels;
    for (double& level : scaledLevels)
    {
      level *= factor;
    }
    for (const bool isFitted : { false, true })
    {
      Parts parts(isFitted ? scaled.Plain : scaled.Local, 2, scaledLevels);
      for (LevelCrossing& crossing : parts.Crossings)
      {
        crossing.X /= factor;
      }
      EXPECT_TRUE(IsSame(isFitted ? expectedFitted : expected, parts)) << factor << isFitted;
    }
  }
}

TEST(ApolloniusParts, ThreadsDoNotMatter)
{
  const FieldCase c(Icosphere(4), { VertexSource(3) });
  const std::vector<double> levels = c.Levels(9);
  const Parts one(c.Local, 2, levels);
  EXPECT_GT(one.Curves.size(), 1000u);
  EXPECT_TRUE(IsSame(one, Parts(c.Local, 2, levels, WithThreads(3))));
  EXPECT_TRUE(IsSame(one, Parts(c.Local, 2, levels, WithThreads(4, 7))));
}

TEST(ApolloniusParts, BadInputAndStopping)
{
  const FieldCase c(Icosphere(3), { VertexSource(3) });
  std::vector<LevelCrossing> crossings(3);
  std::vector<FaceCurve> curves(3);
  auto run = [&](const DistanceField& field, int k, const std::vector<double>& levels,
               const ProgressCallback& progress) {
    return FindApolloniusParts(field, k, levels, {}, progress, crossings, curves);
  };
  EXPECT_FALSE(run(c.Local, -1, { 1.0 }, {}).IsOk());
  EXPECT_FALSE(run(c.Local, 51, { 1.0 }, {}).IsOk());
  EXPECT_FALSE(run(c.Local, 2, { 1.0, std::nan("") }, {}).IsOk());
  EXPECT_FALSE(run({}, 2, { 1.0 }, {}).IsOk());
  EXPECT_TRUE(crossings.empty() && curves.empty());
  EXPECT_TRUE(run(c.Local, 2, {}, {}).IsOk());
  EXPECT_TRUE(run(c.Local, 2, { 1e9, -1e9 }, {}).IsOk());
  EXPECT_TRUE(crossings.empty() && curves.empty());

  double last = -1.0;
  EXPECT_TRUE(run(c.Local, 2, { 1.0 }, [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  }).IsOk());
  EXPECT_GT(last, 0.05);
  EXPECT_FALSE(curves.empty());
  for (const double when : { 0.0, 0.15 })
  {
    EXPECT_TRUE(run(c.Local, 2, { 1.0 }, [=](double done) { return done < when; }).IsAborted());
    EXPECT_TRUE(crossings.empty() && curves.empty());
    EXPECT_TRUE(run(c.Plain, 2, { 1.0 }, [=](double done) { return done < when; }).IsAborted());
    EXPECT_TRUE(crossings.empty() && curves.empty());
  }
}
