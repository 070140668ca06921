// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances against closed forms: planes with obstacles, polyhedra, cones and flat surfaces.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggSurfacePath.h"

namespace dggtest
{
class ExactPlane : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactPlane);

TEST_P(ExactPlane, IsEuclidean)
{
  struct Case
  {
    const char* Name;
    TestMesh Input;
    double Tolerance;
    double Absolute;
  };
  const std::array<double, 3> shift{ { 0.1, 0.2, 0.3 } };
  for (const Case& c : {
         Case{ "grid", Plane(12, 9), 1e-13, 0.0 },
         Case{ "jittered", Plane(12, 9, 0.29, 3), 1e-12, 0.0 },
         Case{ "one triangle", SingleTriangle(), 1e-12, 0.0 },
         // Repeated splits create slivers and vertices at a distance of a thousandth of an edge,
         // where rounding errors are relative to the size of the faces.
         Case{ "refined", RandomlyRefined(Plane(4, 4, 0.2, 3), 120, 4), 1e-12, 1e-13 },
         Case{ "slivers 1e-3", SliverPlane(6, 1e-3), 1e-12, 0.0 },
         Case{ "slivers 1e-6", SliverPlane(6, 1e-6), 1e-12, 0.0 },
         Case{ "slivers 1e-9", SliverPlane(6, 1e-9), 1e-12, 0.0 },
         // Two lengths that differ by 1e-12 are treated as equal, and errors accumulate from needle
         // to needle.
         Case{ "needles 1e-3", NeedlePlane(5, 1e-3), 1e-11, 0.0 },
         Case{ "needles 1e-6", NeedlePlane(5, 1e-6), 1e-11, 0.0 },
         Case{ "needles 1e-9", NeedlePlane(5, 1e-9), 1e-11, 0.0 },
         // Differences in the last digit of lengths change the angles of needles by 1e-7.
         Case{ "turned 1e-6", MovedRigidly(NeedlePlane(4, 1e-6), 0.7, shift), 0.0, 1e-8 },
         Case{ "turned 1e-9", MovedRigidly(NeedlePlane(4, 1e-9), 0.7, shift), 0.0, 1e-8 },
         Case{ "turned 1e-11", MovedRigidly(NeedlePlane(4, 1e-11), 0.7, shift), 0.0, 1e-8 },
         // The lengths determine the height of a cap up to about eps / height.
         Case{ "caps 1e-2", CapPlane(6, 1e-2), 1e-12, 0.0 },
         Case{ "caps 1e-4", CapPlane(6, 1e-4), 1e-10, 0.0 },
         // Faces of zero area across a seam close the plane again, up to the mollification.
         Case{ "zipped", ZippedPlane(6), 0.0, 1e-11 },
       })
  {
    SCOPED_TRACE(c.Name);
    ExpectEuclid(c.Input, this->Engine(), c.Tolerance, c.Absolute);
  }
}

TEST_P(ExactPlane, PointsAnywhere)
{
  for (const TestMesh& input : { Plane(7, 6, 0.25, 9), SingleTriangle() })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    auto points = RandomSurfacePoints(mesh, 40, 3);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      points.push_back(dgg::SurfacePoint::AtVertex(v));
    }
    std::vector<std::array<double, 3>> places;
    for (const dgg::SurfacePoint& point : points)
    {
      places.push_back(dgg::PositionOf(mesh, point, input.Points.data()));
    }
    for (std::size_t i = 0; i < 40; ++i)
    {
      const auto distances = DistancesTo(mesh, this->Engine(), points[i], points);
      for (std::size_t j = 0; j < points.size(); ++j)
      {
        const double truth = std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
        EXPECT_NEAR(distances[j], truth, 1e-12 * (truth + 1e-3)) << i << " " << j;
      }
    }
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
      // Vertices on the slit belong to its upper or lower side. The line to the left of the slit is
      // split as well, which does not change distances.
      const double x =
        p[1] == q[1] ? std::max(p[0], q[0]) : p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1]);
      return x <= 0.0 ? direct : std::hypot(p[0], p[1]) + std::hypot(q[0], q[1]);
    });
  }
}

// Features many orders of magnitude smaller than the edges next to them: a window that is narrow
// relative to its edge may still illuminate half of the surface.

namespace
{
const double Sizes[] = { 1e-3, 1e-5, 1e-6, 1e-7, 3e-8, 1e-8, 1e-9, 1e-10 };

/// Inserts a vertex into about half of the faces, at a distance of about `size` edges from a
/// corner.
TestMesh WithTinyFeatures(TestMesh mesh, double size, Random& random)
{
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; ++f)
  {
    if (random.Uniform() < 0.5)
    {
      const double a = size * random.Uniform(0.2, 1.2);
      const double b = size * random.Uniform(0.2, 1.2);
      SplitFace(mesh, f, { { 1.0 - a - b, a, b } });
    }
  }
  return mesh;
}

/// Inserts a vertex into edges of the plane, at a distance of `size` from an end: rows, columns and
/// diagonals get needles, whose vertices are collinear up to rounding.
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
protected:
  double LargestError(const TestMesh& plane, const dgg::SurfaceMesh& mesh, Id source)
  {
    std::size_t where = 0;
    return LargestDifference(
      EuclideanDistances(plane, source), DistancesFrom(mesh, this->Engine(), source), where);
  }
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
      const TestMesh input = WithTinyFeatures(Plane(6, 6, 0.25, seed), size, random);
      const dgg::SurfaceMesh mesh = Build(input);
      // Mollification changes the smallest faces themselves. A window that grazes a row of features
      // of 1e-8 may have to pass around the features, a few times their size.
      EXPECT_LE(this->LargestError(input, mesh, random.Index(mesh.GetNumberOfVertices())),
        mesh.GetMollification() > 0.0 ? 1e-6 : 1e-7)
        << "seed " << seed;
    }
  }
}

/// Windows that pass between the two ends of a needle are not trimmed by labels that are too short,
/// not hidden by windows that are wide relative to the needle, and not lost in the rounding of a
/// position on a long edge. Around 1e-8, the square root of the rounding error, the position of
/// seams between windows is uncertain by their width.
TEST_P(ExactSmallFeatures, NeedlesInThePlane)
{
  // With the seeds 63, 11, 14 and 26 the result depends on windows at seams.
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
      for (Id source = 0; source < mesh.GetNumberOfVertices(); source += 3)
      {
        ASSERT_LE(this->LargestError(input, mesh, source), size > 1e-5 ? 1e-11 : 5.0 * size)
          << "seed " << seed;
      }
    }
  }
}

namespace
{
/// Returns the distance between points of a polygon and of its copy, glued along the rim: the
/// second point is reflected in each side. If the line misses the side, the path passes through the
/// nearer end of the side.
double ThroughTheRim(Id sides, const double* p, const double* q)
{
  double best = dgg::Infinity;
  for (Id i = 0; i < sides; ++i)
  {
    const double a0 = 2.0 * dgg::Pi * i / sides;
    const double a1 = 2.0 * dgg::Pi * (i + 1) / sides;
    const double ax = std::cos(a0);
    const double ay = std::sin(a0);
    const double ux = std::cos(a1) - ax;
    const double uy = std::sin(a1) - ay;
    const double length = std::hypot(ux, uy);
    auto along = [&](const double* r) { return ((r[0] - ax) * ux + (r[1] - ay) * uy) / length; };
    auto away = [&](const double* r) {
      return std::abs((r[0] - ax) * uy - (r[1] - ay) * ux) / length;
    };
    const double hp = away(p);
    const double hq = away(q);
    double x = hp + hq > 0.0 ? (along(p) * hq + along(q) * hp) / (hp + hq) : along(p);
    x = std::min(length, std::max(0.0, x));
    best = std::min(best, std::hypot(along(p) - x, hp) + std::hypot(along(q) - x, hq));
  }
  return best;
}
}

class ExactPolyhedra : public EngineTest
{
protected:
  double Between(const TestMesh& input, Id a, Id b)
  {
    return DistancesFrom(Build(input), this->Engine(), a)[b];
  }
  double Between(
    const TestMesh& input, const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return this->Between(
      input, VertexAt(input, p[0], p[1], p[2]), VertexAt(input, q[0], q[1], q[2]));
  }
};
DGG_WITH_BOTH_ENGINES(ExactPolyhedra);

TEST_P(ExactPolyhedra, UnitCube)
{
  for (const double jitter : { 0.0, 0.25 })
  {
    for (const Id k : { 2, 6 })
    {
      // The centers must be vertices, so only the other vertices are moved.
      TestMesh cube = Cube(k, jitter, 5);
      if (jitter > 0.0)
      {
        const TestMesh regular = Cube(k);
        for (Id v = 0; v < cube.GetNumberOfVertices(); ++v)
        {
          const double* p = regular.Point(v);
          if ((p[0] == 0.5) + (p[1] == 0.5) + (p[2] == 0.5) == 2)
          {
            std::copy_n(p, 3, cube.Points.begin() + 3 * v);
          }
        }
      }
      SCOPED_TRACE(k);
      auto expect = [&](double truth, const std::array<double, 3>& p,
                      const std::array<double, 3>& q) {
        ExpectClose(truth, this->Between(cube, p, q), 1e-12, "there");
        ExpectClose(truth, this->Between(cube, q, p), 1e-12, "back");
      };
      expect(std::sqrt(5.0), { { 0, 0, 0 } }, { { 1, 1, 1 } });
      expect(2.0, { { 0.5, 0.5, 0 } }, { { 0.5, 0.5, 1 } });
      expect(std::sqrt(2.5), { { 0.5, 0.5, 0 } }, { { 0, 0, 1 } });
      expect(std::sqrt(2.5), { { 0.5, 0.5, 0 } }, { { 1, 0, 1 } });
      expect(0.5 * std::sqrt(13.0), { { 0, 0, 0 } }, { { 1, 1, 0.5 } });
      expect(std::sqrt(2.0), { { 0, 0, 0 } }, { { 1, 1, 0 } });
    }
  }
}

TEST_P(ExactPolyhedra, LongBoxHasItsFarthestPointInAFace)
{
  // From the corner (0,0,0) of the box 1 x 1 x 2, the farthest point is not the opposite corner but
  // the point a quarter of the way along the diagonal of the far square.
  const TestMesh box = Box(4, 4, 8, 0.25, 0.25, 0.25);
  const auto distances = DistancesFrom(Build(box), this->Engine(), VertexAt(box, 0.0, 0.0, 0.0));
  const Id farthest = VertexAt(box, 0.75, 0.75, 2.0);
  ExpectClose(std::sqrt(8.0), distances[VertexAt(box, 1.0, 1.0, 2.0)], 1e-12, "opposite corner");
  ExpectClose(std::sqrt(130.0) / 4.0, distances[farthest], 1e-12, "farthest point");
  EXPECT_EQ(LargestFinite(distances), distances[farthest]);
}

TEST_P(ExactPolyhedra, TetrahedronAndIcosahedron)
{
  // The tetrahedron unfolds to the triangular lattice. In the strip of two triangles between the
  // caps of the icosahedron, the vector (1/2, 3 sqrt(3)/2) leads from a vertex to the opposite one.
  const TestMesh tetrahedron = Subdivided(Tetrahedron(), 6);
  const auto middle = [&](const std::vector<Id>& corners) {
    std::array<double, 3> p{};
    for (const Id v : corners)
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] += tetrahedron.Point(v)[i] / static_cast<double>(corners.size());
      }
    }
    return p;
  };
  const auto expect = [&](double truth, const std::vector<Id>& a, const std::vector<Id>& b) {
    ExpectClose(truth, this->Between(tetrahedron, middle(a), middle(b)), 1e-12, "tetrahedron");
  };
  expect(1.0, { 0 }, { 3 });
  expect(0.5 * std::sqrt(3.0), { 0 }, { 1, 2 });
  expect(1.0, { 0, 1 }, { 2, 3 });
  expect(2.0 / std::sqrt(3.0), { 0 }, { 1, 2, 3 });
  expect(0.5, { 0, 1 }, { 0, 2 });
  for (const Id k : { 1, 3, 4 })
  {
    const TestMesh input = Subdivided(Icosahedron(), k);
    const auto distances = DistancesFrom(Build(input), this->Engine(), 5);
    for (Id b = 0; b < 12; ++b)
    {
      const double chord = EuclideanDistance(input, 5, b);
      const double truth =
        b == 5 ? 0.0 : (chord < 1.1 ? 1.0 : (chord < 1.8 ? std::sqrt(3.0) : std::sqrt(7.0)));
      ExpectClose(truth, distances[b], 1e-12, "icosahedron, to " + std::to_string(b));
    }
  }
}

TEST_P(ExactPolyhedra, DoublyCoveredPolygon)
{
  for (const Id sides : { 3, 4, 5, 8 })
  {
    std::vector<bool> isBack;
    const TestMesh input = DoublyCoveredPolygon(sides, 3, isBack);
    ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
      const bool rim = a < sides || b < sides;
      return rim || isBack[a] == isBack[b] ? EuclideanDistance(input, a, b)
                                           : ThroughTheRim(sides, input.Point(a), input.Point(b));
    });
  }
}

// Exact distances on cylinders, cones, flat tori and the one-sided flat surfaces.

class ExactDevelopable : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactDevelopable);

TEST_P(ExactDevelopable, Prism)
{
  for (const double jitter : { 0.0, 0.25 })
  {
    for (const Id sides : { 3, 4, 7 })
    {
      const Id columns = 2;
      const TestMesh input = PrismSide(sides, columns, 5, jitter, 3);
      const Id around = sides * columns;
      ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
        const double along =
          std::abs(static_cast<double>(a % around - b % around)) / columns; // sides of width 1
        const double dz = input.Point(a)[2] - input.Point(b)[2];
        return std::hypot(std::min(along, sides - along), dz);
      });
    }
  }
}

TEST_P(ExactDevelopable, ConesBelowAndAboveTheFullAngle)
{
  for (const double total :
    { 0.5, 1.5, 3.0, 5.0, 6.2, 2.0 * dgg::Pi, 6.4, 8.0, 3.0 * dgg::Pi, 10.0, 14.0 })
  {
    for (const double jitter : { 0.0, 0.25 })
    {
      SCOPED_TRACE(total);
      SCOPED_TRACE(jitter);
      std::vector<ConePoint> polar;
      const TestMesh input = Cone(total, total > 7.0 ? 17 : 9, 4, polar, jitter, 6);
      ExpectAllPairs(Build(input), this->Engine(),
        [&](Id a, Id b) { return ConeDistance(total, polar[a], polar[b]); });
    }
  }
}

TEST_P(ExactDevelopable, FlatTorusOfFewTriangles)
{
  // One, two or four parallelograms, glued to themselves and to each other.
  for (const auto& n : std::vector<std::array<Id, 2>>{ { 1, 1 }, { 2, 1 }, { 1, 2 }, { 2, 2 } })
  {
    SCOPED_TRACE(n[0] * 10 + n[1]);
    const double ux = 2.0;
    const double vx = 0.6;
    const double vy = 1.1;
    const dgg::SurfaceMesh mesh = Build(FlatTorus(ux, vx, vy, n[0], n[1], true));
    // Returns the position in the plane of a point of a face.
    auto place = [&](Id face, const std::array<double, 3>& b) {
      const Id cell = face / 2;
      const double i = cell % n[0];
      const double j = cell / n[0];
      const double cu[4] = { 0.0, 1.0, 1.0, 0.0 };
      const double cv[4] = { 0.0, 0.0, 1.0, 1.0 };
      std::array<double, 2> p{};
      for (int k = 0; k < 3; ++k)
      {
        const int corner = face % 2 == 0 ? k : (k == 0 ? 0 : k + 1);
        const double u = (i + cu[corner]) / n[0];
        const double v = (j + cv[corner]) / n[1];
        p[0] += b[k] * (u * ux + v * vx);
        p[1] += b[k] * v * vy;
      }
      return p;
    };
    const auto points = RandomSurfacePoints(mesh, 12, 5);
    for (const dgg::SurfacePoint& source : points)
    {
      const auto distances = DistancesTo(mesh, this->Engine(), source, points);
      const auto p = place(source.Face, source.Barycentric);
      for (std::size_t t = 0; t < points.size(); ++t)
      {
        const auto q = place(points[t].Face, points[t].Barycentric);
        const double truth = FlatTorusDistance(ux, vx, vy, q[0] - p[0], q[1] - p[1]);
        EXPECT_NEAR(distances[t], truth, 1e-12 * (truth + 1e-3));
      }
    }
  }
}

TEST_P(ExactDevelopable, MoebiusStrip)
{
  for (const auto& n : std::vector<std::array<Id, 2>>{ { 3, 2 }, { 8, 6 }, { 9, 4 }, { 5, 8 } })
  {
    const dgg::SurfaceMesh mesh = Build(MoebiusStrip(n[0], n[1]));
    auto y = [&](Id v) { return v / n[0] - 0.5 * n[1]; };
    ExpectAllPairs(mesh, this->Engine(),
      [&](Id a, Id b) { return MoebiusDistance(n[0], a % n[0], y(a), b % n[0], y(b)); });
  }
}
}
