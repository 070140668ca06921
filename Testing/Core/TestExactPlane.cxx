// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances in the plane: convex domains, and domains with obstacles.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggSurfacePath.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dggtest
{
namespace
{
/// Distances in a union of unit cells, from the visibility of its corners: a shortest path bends
/// only where the domain has an inner angle above pi.
class VisibilityGraph
{
public:
  VisibilityGraph(Id nx, Id ny, std::function<bool(Id, Id)> keep)
    : Nx(nx)
    , Ny(ny)
    , Keep(std::move(keep))
  {
    for (Id j = 0; j <= ny; ++j)
    {
      for (Id i = 0; i <= nx; ++i)
      {
        const int cells =
          this->Has(i - 1, j - 1) + this->Has(i, j - 1) + this->Has(i - 1, j) + this->Has(i, j);
        const bool touching = cells == 2 && this->Has(i, j) == this->Has(i - 1, j - 1);
        if (cells == 3 || touching)
        {
          this->Corners.push_back({ { static_cast<double>(i), static_cast<double>(j) } });
        }
      }
    }
    const std::size_t n = this->Corners.size();
    this->Between.assign(n * n, dgg::Infinity);
    for (std::size_t a = 0; a < n; ++a)
    {
      for (std::size_t b = 0; b < n; ++b)
      {
        this->Between[a * n + b] = this->Straight(this->Corners[a], this->Corners[b]);
      }
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      for (std::size_t a = 0; a < n; ++a)
      {
        for (std::size_t b = 0; b < n; ++b)
        {
          this->Between[a * n + b] =
            std::min(this->Between[a * n + b], this->Between[a * n + k] + this->Between[k * n + b]);
        }
      }
    }
  }

  using Point = std::array<double, 2>;
  double Distance(const Point& p, const Point& q) const
  {
    double best = this->Straight(p, q);
    const std::size_t n = this->Corners.size();
    for (std::size_t a = 0; a < n; ++a)
    {
      const double first = this->Straight(p, this->Corners[a]);
      for (std::size_t b = 0; b < n && first < best; ++b)
      {
        best =
          std::min(best, first + this->Between[a * n + b] + this->Straight(this->Corners[b], q));
      }
    }
    return best;
  }

private:
  bool Has(Id i, Id j) const
  {
    return i >= 0 && j >= 0 && i < this->Nx && j < this->Ny && this->Keep(i, j);
  }
  /// Whether the point lies in a kept cell or on the rim of one.
  bool IsInside(double x, double y) const
  {
    constexpr double tolerance = 1e-11;
    for (Id j = static_cast<Id>(y - 1.5); j <= static_cast<Id>(y) + 1; ++j)
    {
      for (Id i = static_cast<Id>(x - 1.5); i <= static_cast<Id>(x) + 1; ++i)
      {
        if (this->Has(i, j) && x >= i - tolerance && x <= i + 1 + tolerance && y >= j - tolerance &&
          y <= j + 1 + tolerance)
        {
          return true;
        }
      }
    }
    return false;
  }
  /// Euclid when the segment stays inside, else infinity. Between two crossings of grid lines it
  /// stays in one cell, so its middle shows.
  double Straight(const Point& p, const Point& q) const
  {
    std::vector<double> cuts{ 0.0, 1.0 };
    for (int axis = 0; axis < 2; ++axis)
    {
      const double low = std::min(p[axis], q[axis]);
      const double high = std::max(p[axis], q[axis]);
      for (double line = std::ceil(low); line <= high; line += 1.0)
      {
        if (high > low)
        {
          cuts.push_back((line - p[axis]) / (q[axis] - p[axis]));
        }
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    {
      const double t = 0.5 * (cuts[i] + cuts[i + 1]);
      if (cuts[i + 1] - cuts[i] > 1e-12 &&
        !this->IsInside(p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])))
      {
        return dgg::Infinity;
      }
    }
    return std::hypot(p[0] - q[0], p[1] - q[1]);
  }

  Id Nx;
  Id Ny;
  std::function<bool(Id, Id)> Keep;
  std::vector<Point> Corners;
  std::vector<double> Between;
};

void ExpectVisibility(
  Id nx, Id ny, const std::function<bool(Id, Id)>& keep, dgg::ExactEngine engine)
{
  const VisibilityGraph graph(nx, ny, keep);
  for (const double jitter : { 0.0, 0.25 })
  {
    SCOPED_TRACE(jitter);
    const TestMesh input = Plate(nx, ny, keep, jitter, 5);
    ExpectAllPairs(Build(input), engine, [&](Id a, Id b) {
      const double* p = input.Point(a);
      const double* q = input.Point(b);
      return graph.Distance({ { p[0], p[1] } }, { { q[0], q[1] } });
    });
  }
}
}

class ExactPlane : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactPlane);

TEST_P(ExactPlane, Grids)
{
  ExpectEuclid(Plane(12, 9), this->Engine());
  ExpectEuclid(Plane(12, 9, 0.29, 3), this->Engine());
}

TEST_P(ExactPlane, RefinedAtRandom)
{
  // Splits upon splits leave slivers, and vertices at a distance of a thousandth of an edge: there
  // rounding counts against the size of the faces.
  ExpectEuclid(RandomlyRefined(Plane(4, 4, 0.2, 3), 120, 4), this->Engine(), 1e-12, 1e-13);
}

TEST_P(ExactPlane, Slivers)
{
  for (const double height : { 1e-3, 1e-6, 1e-9 })
  {
    SCOPED_TRACE(height);
    ExpectEuclid(SliverPlane(6, height), this->Engine());
    // Two lengths that differ by 1e-12 count as equal, and needles are passed one after the other.
    ExpectEuclid(NeedlePlane(5, height), this->Engine(), 1e-11);
  }
}

TEST_P(ExactPlane, NeedlesInGeneralPosition)
{
  // Lengths that differ in the last digit make angles of needles differ by 1e-7.
  for (const double width : { 1e-6, 1e-9, 1e-11 })
  {
    SCOPED_TRACE(width);
    ExpectEuclid(
      MovedRigidly(NeedlePlane(4, width), 0.7, { { 0.1, 0.2, 0.3 } }), this->Engine(), 0.0, 1e-8);
  }
}

TEST_P(ExactPlane, Caps)
{
  // The height of a cap is known to about eps / height from its lengths.
  ExpectEuclid(CapPlane(6, 1e-2), this->Engine(), 1e-12);
  ExpectEuclid(CapPlane(6, 1e-4), this->Engine(), 1e-10);
}

TEST_P(ExactPlane, AroundCorners)
{
  struct Domain
  {
    const char* Name;
    Id Nx;
    Id Ny;
    bool (*Keep)(Id i, Id j);
  };
  for (const Domain& domain :
    { Domain{ "L shape", 8, 8, [](Id i, Id j) { return i < 3 || j < 3; } },
      Domain{ "slot", 9, 7, [](Id i, Id j) { return i != 4 || j == 0; } },
      Domain{ "annulus", 9, 9, [](Id i, Id j) { return i < 3 || i > 5 || j < 3 || j > 5; } },
      Domain{
        "maze", 11, 9, [](Id i, Id j) { return i % 4 != 2 || (i % 8 == 2 ? j == 0 : j == 8); } },
      Domain{ "many holes", 9, 9, [](Id i, Id j) { return i % 3 != 1 || j % 3 != 1; } },
      Domain{ "cells touching at corners", 8, 8, [](Id i, Id j) { return i / 2 == j / 2; } } })
  {
    SCOPED_TRACE(domain.Name);
    ExpectVisibility(domain.Nx, domain.Ny, domain.Keep, this->Engine());
  }
}

TEST_P(ExactPlane, Slit)
{
  for (const double jitter : { 0.0, 0.25 })
  {
    std::vector<bool> isLower;
    const TestMesh input = SlitPlane(5, isLower, jitter, 2);
    ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
      const double* p = input.Point(a);
      const double* q = input.Point(b);
      const double direct = EuclideanDistance(input, a, b);
      if (isLower[a] == isLower[b])
      {
        return direct;
      }
      // Points of the slit count as above or below it; so does the line to its left, harmlessly.
      const double x =
        p[1] == q[1] ? std::max(p[0], q[0]) : p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1]);
      return x <= 0.0 ? direct : std::hypot(p[0], p[1]) + std::hypot(q[0], q[1]);
    });
  }
}

TEST_P(ExactPlane, PointsAnywhere)
{
  const TestMesh input = Plane(7, 6, 0.25, 9);
  const dgg::SurfaceMesh mesh = Build(input);
  const auto points = RandomSurfacePoints(mesh, 40, 3);
  std::vector<std::array<double, 3>> places;
  for (const dgg::SurfacePoint& point : points)
  {
    places.push_back(dgg::PositionOf(mesh, point, input.Points.data()));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const dgg::ExactResult result = Solve(mesh, this->Engine(), { { points[i], 0.0 } },
      [&](dgg::ExactOptions& options) { options.Targets = points; });
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      const double truth = std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
      EXPECT_NEAR(result.TargetDistances[j], truth, 1e-12 * (truth + 1e-3)) << i << " " << j;
    }
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double truth =
        std::hypot(places[i][0] - input.Point(v)[0], places[i][1] - input.Point(v)[1]);
      EXPECT_NEAR(result.Distances[v], truth, 1e-12 * truth) << i << " " << v;
    }
  }
}

TEST_P(ExactPlane, OneTriangle)
{
  const TestMesh input = SingleTriangle();
  ExpectEuclid(input, this->Engine());
  const dgg::SurfaceMesh mesh = Build(input);
  // From the vertex (1,3), the edge point (2,0), the inner point (2.25, 0.75) to all of them.
  const std::vector<dgg::SurfacePoint> points{ dgg::SurfacePoint::AtVertex(2),
    dgg::SurfacePoint::OnEdge(mesh, 0, 0.5),
    dgg::SurfacePoint::InFace(mesh, 0, { { 0.25, 0.5, 0.25 } }) };
  const double xs[3] = { 1.0, 2.0, 2.25 };
  const double ys[3] = { 3.0, 0.0, 0.75 };
  for (int i = 0; i < 3; ++i)
  {
    const auto distances = DistancesTo(mesh, this->Engine(), points[i], points);
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(distances[j], std::hypot(xs[i] - xs[j], ys[i] - ys[j]), 1e-15);
    }
  }
}

TEST_P(ExactPlane, TwoTriangles)
{
  // Folding changes nothing; the lines between the far corners and between inner points cross the
  // fold.
  for (const double fold : { 0.0, 0.5, 3.0 })
  {
    const dgg::SurfaceMesh mesh = Build(TwoTriangles(fold));
    EXPECT_NEAR(DistancesFrom(mesh, this->Engine(), 2)[3], std::hypot(3.5, 0.75), 1e-14);
    const auto left = dgg::SurfacePoint::InFace(mesh, 0, { { 0.25, 0.25, 0.5 } });
    const auto right = dgg::SurfacePoint::InFace(mesh, 1, { { 0.25, 0.25, 0.5 } });
    const auto fromLeft = DistancesTo(mesh, this->Engine(), left, { right });
    EXPECT_NEAR(fromLeft[0], std::hypot(1.75, 0.375), 1e-14);
    const auto middle = dgg::SurfacePoint::OnEdge(mesh, 0, 0.25); // (0, 0.5)
    EXPECT_NEAR(
      DistancesTo(mesh, this->Engine(), middle, { right })[0], std::hypot(1.0, 0.625), 1e-14);
    EXPECT_NEAR(
      DistancesTo(mesh, this->Engine(), right, { middle })[0], std::hypot(1.0, 0.625), 1e-14);
  }
}

// Features many orders of magnitude smaller than the edges next to them: a window that is narrow
// for its edge may still light half of the surface.

namespace
{
const double Sizes[] = { 1e-3, 1e-5, 1e-6, 1e-7, 3e-8, 1e-8, 1e-9, 1e-10 };

/// Insert a vertex into about half of the faces, at a distance of about `size` edges from a corner,
/// and lift each by up to `lift` times that.
TestMesh WithTinyFeatures(TestMesh mesh, double size, double lift, Random& random)
{
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; ++f)
  {
    if (random.Uniform() < 0.5)
    {
      const double a = size * random.Uniform(0.2, 1.2);
      const double b = size * random.Uniform(0.2, 1.2);
      const Id v = SplitFace(mesh, f, { { 1.0 - a - b, a, b } });
      mesh.Points[3 * v + 2] += size * lift * random.Uniform(-1.0, 1.0);
    }
  }
  return mesh;
}

/// Insert a vertex into edges of the plane, at a distance of `size` from an end: rows, columns and
/// diagonals get needles, whose vertices lie in line with each other up to rounding.
TestMesh PlaneWithNeedles(Id n, double size, Random& random)
{
  const TestMesh plane = Plane(n, n);
  TestMesh mesh = plane;
  std::vector<bool> isTaken(plane.GetNumberOfFaces(), false);
  for (Id f = 0; f < plane.GetNumberOfFaces(); ++f)
  {
    const Id k = random.Index(3);
    const Id a = plane.Triangles[3 * f + k];
    const Id b = plane.Triangles[3 * f + (k + 1) % 3];
    bool isFree = true;
    std::vector<Id> faces;
    for (Id g = 0; g < plane.GetNumberOfFaces(); ++g)
    {
      const auto corners = plane.Triangles.begin() + 3 * g;
      if (std::count(corners, corners + 3, a) + std::count(corners, corners + 3, b) == 2)
      {
        faces.push_back(g);
        isFree = isFree && !isTaken[g];
      }
    }
    if (isFree)
    {
      SplitEdge(mesh, a, b, size * random.Uniform(0.5, 1.0));
      for (const Id g : faces)
      {
        isTaken[g] = true;
      }
    }
  }
  return mesh;
}
}

class ExactSmallFeatures : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactSmallFeatures);

TEST_P(ExactSmallFeatures, InThePlane)
{
  for (const double size : Sizes)
  {
    SCOPED_TRACE(size);
    Random random(3);
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const TestMesh input = WithTinyFeatures(Plane(6, 6, 0.25, seed), size, 0.0, random);
      const dgg::SurfaceMesh mesh = Build(input);
      const Id source = random.Index(mesh.GetNumberOfVertices());
      const auto distances = DistancesFrom(mesh, this->Engine(), source);
      double worst = 0.0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        worst = std::max(worst, std::abs(distances[v] - EuclideanDistance(input, source, v)));
      }
      // Mollification changes the smallest faces themselves. A window that grazes a row of features
      // of 1e-8 may have to go around them, a few times their size.
      EXPECT_LE(worst, mesh.GetMollification() > 0.0 ? 1e-6 : 1e-7) << "seed " << seed;
    }
  }
}

/// The light that passes between the two ends of a needle is not trimmed by a label that is too
/// short, nor lost to a window that is wide for the needle, nor in the rounding of a position on a
/// long edge. Around 1e-8, the root of rounding, the seams between windows are known to their
/// width.
TEST_P(ExactSmallFeatures, NeedlesInThePlane)
{
  // The seeds 63, 11, 14 and 26 have windows on whose seams everything depends.
  const std::pair<double, std::vector<std::uint64_t>> cases[] = { { 1e-4, { 1, 2, 3 } },
    { 1e-7, { 1, 2, 3, 4 } }, { 2e-8, { 63 } }, { 7e-9, { 11 } }, { 5e-9, { 63 } },
    { 3e-9, { 14 } }, { 2e-9, { 26 } }, { 1e-9, { 1, 2, 3, 4 } }, { 1e-11, { 1, 2 } } };
  for (const auto& [size, seeds] : cases)
  {
    SCOPED_TRACE(size);
    for (const std::uint64_t seed : seeds)
    {
      Random random(seed);
      const TestMesh input = PlaneWithNeedles(6, size, random);
      const dgg::SurfaceMesh mesh = Build(input);
      double worst = 0.0;
      for (Id source = 0; source < mesh.GetNumberOfVertices(); source += 3)
      {
        const auto distances = DistancesFrom(mesh, this->Engine(), source);
        for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
        {
          worst = std::max(worst, std::abs(distances[v] - EuclideanDistance(input, source, v)));
        }
      }
      EXPECT_LE(worst, size > 1e-5 ? 1e-11 : 5.0 * size) << "seed " << seed;
    }
  }
}

TEST(ExactSmallFeaturesOfATerrain, EnginesAgree)
{
  for (const double size : Sizes)
  {
    SCOPED_TRACE(size);
    Random random(7);
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
    {
      const TestMesh input = WithTinyFeatures(WithNoise(Plane(6, 6), 0.3, seed), size, 2.0, random);
      const dgg::SurfaceMesh mesh = Build(input);
      const Id source = random.Index(mesh.GetNumberOfVertices());
      const auto expected = DistancesFrom(mesh, dgg::ExactEngine::Reference, source);
      const auto distances = DistancesFrom(mesh, dgg::ExactEngine::Triangle, source);
      double worst = 0.0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        worst = std::max(worst, std::abs(distances[v] - expected[v]));
      }
      EXPECT_LE(worst, 1e-8) << "seed " << seed;
    }
  }
}
}
