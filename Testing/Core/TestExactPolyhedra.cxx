// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances on boxes, regular polyhedra and doubly covered polygons.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
/// Distance of two points of a polygon and its copy, glued along the rim: reflect the second point
/// in each side; where the line misses the side, go through the nearer end of it.
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
    for (const Id k : { 2, 4, 6 })
    {
      // The centres must be vertices: only the others are moved.
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

TEST_P(ExactPolyhedra, CubeOfTwelveFaces)
{
  const TestMesh cube = Cube(1);
  ExpectClose(std::sqrt(5.0), this->Between(cube, { { 0, 0, 0 } }, { { 1, 1, 1 } }), 1e-12, "far");
  // Between points inside faces: the centres of opposite faces.
  const dgg::SurfaceMesh mesh = Build(cube);
  auto centre = [&](double x, double y, double z) {
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const double* p = cube.Point(mesh.Origin(h));
      const double* q = cube.Point(mesh.Destination(h));
      if (std::hypot(p[0] + q[0] - 2 * x, p[1] + q[1] - 2 * y, p[2] + q[2] - 2 * z) < 1e-12)
      {
        return dgg::SurfacePoint::OnEdge(mesh, h, 0.5);
      }
    }
    return dgg::SurfacePoint();
  };
  const auto distances = DistancesTo(mesh, this->Engine(), centre(0.5, 0.5, 0.0),
    { centre(0.5, 0.5, 1.0), centre(0.0, 0.5, 0.5), centre(1.0, 0.5, 0.5) });
  ExpectClose(2.0, distances[0], 1e-12, "opposite centres");
  ExpectClose(1.0, distances[1], 1e-12, "neighbouring centres");
  ExpectClose(1.0, distances[2], 1e-12, "neighbouring centres");
}

TEST_P(ExactPolyhedra, LongBoxHasItsFarthestPointInAFace)
{
  // From the corner (0,0,0) of the box 1 x 1 x 2: not the opposite corner is farthest, but the
  // point a quarter of the way along the diagonal of the far square.
  const TestMesh box = Box(4, 4, 8, 0.25, 0.25, 0.25);
  const dgg::SurfaceMesh mesh = Build(box);
  const auto distances = DistancesFrom(mesh, this->Engine(), VertexAt(box, 0.0, 0.0, 0.0));
  const Id opposite = VertexAt(box, 1.0, 1.0, 2.0);
  const Id farthest = VertexAt(box, 0.75, 0.75, 2.0);
  ExpectClose(std::sqrt(8.0), distances[opposite], 1e-12, "opposite corner");
  ExpectClose(std::sqrt(130.0) / 4.0, distances[farthest], 1e-12, "farthest point");
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_LE(distances[v], distances[farthest]) << v;
  }
  // The same from the twelve faces, as a target.
  const TestMesh coarse = Box(1, 1, 1, 1.0, 1.0, 2.0);
  const dgg::SurfaceMesh plain = Build(coarse);
  dgg::SurfacePoint target;
  for (Id f = 0; f < plain.GetNumberOfFaces(); ++f)
  {
    // The far square is cut from (0,0) to (1,1) or across; take the face with both ends.
    const auto t = plain.GetTriangle(f);
    std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
    int found = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double* p = coarse.Point(t[k]);
      const bool isFar = p[2] == 2.0;
      b[k] = isFar && p[0] == p[1] ? (p[0] == 1.0 ? 0.75 : 0.25) : 0.0;
      found += b[k] > 0.0 ? 1 : 0;
      found -= isFar ? 0 : 1;
    }
    if (found == 2)
    {
      target = dgg::SurfacePoint::InFace(plain, f, b);
    }
  }
  const auto found = DistancesTo(plain, this->Engine(),
    dgg::SurfacePoint::AtVertex(VertexAt(coarse, 0.0, 0.0, 0.0)), { target });
  ExpectClose(std::sqrt(130.0) / 4.0, found[0], 1e-12, "as a target");
}

TEST_P(ExactPolyhedra, Tetrahedron)
{
  // It unfolds to the triangular lattice: vertex to the middle of the opposite face by one edge,
  // to the middle of a far edge by the height of a face; between the middles of opposite edges 1.
  const TestMesh input = Subdivided(Tetrahedron(), 6);
  auto mix = [&](double a, double b, double c, double d) {
    std::array<double, 3> p{};
    for (int i = 0; i < 3; ++i)
    {
      p[i] = a * input.Point(0)[i] + b * input.Point(1)[i] + c * input.Point(2)[i] +
        d * input.Point(3)[i];
    }
    return p;
  };
  ExpectClose(1.0, this->Between(input, 0, 3), 1e-12, "edge");
  ExpectClose(0.5 * std::sqrt(3.0), this->Between(input, mix(1, 0, 0, 0), mix(0, 0.5, 0.5, 0)),
    1e-12, "vertex to far edge");
  ExpectClose(
    1.0, this->Between(input, mix(0.5, 0.5, 0, 0), mix(0, 0, 0.5, 0.5)), 1e-12, "opposite edges");
  ExpectClose(2.0 / std::sqrt(3.0),
    this->Between(input, mix(1, 0, 0, 0), mix(0, 1.0 / 3, 1.0 / 3, 1.0 / 3)), 1e-12,
    "vertex to far face");
  ExpectClose(0.5, this->Between(input, mix(0.5, 0.5, 0, 0), mix(0.5, 0, 0.5, 0)), 1e-12,
    "neighbouring edges");
}

TEST_P(ExactPolyhedra, Icosahedron)
{
  // Opposite vertices: in the strip of two triangles between the caps, the vector
  // (1/2, 3 sqrt(3)/2) leads from one to the other: sqrt(7).
  for (const Id k : { 1, 3, 4 })
  {
    const TestMesh input = Subdivided(Icosahedron(), k);
    const dgg::SurfaceMesh mesh = Build(input);
    for (const Id a : { 0, 5, 11 })
    {
      const auto distances = DistancesFrom(mesh, this->Engine(), a);
      for (Id b = 0; b < 12; ++b)
      {
        const double chord = EuclideanDistance(input, a, b);
        const double truth =
          a == b ? 0.0 : (chord < 1.1 ? 1.0 : (chord < 1.8 ? std::sqrt(3.0) : std::sqrt(7.0)));
        ExpectClose(truth, distances[b], 1e-12, std::to_string(a) + " to " + std::to_string(b));
      }
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
  // One, two or four parallelograms, glued to themselves and each other.
  for (const auto& n : std::vector<std::array<Id, 2>>{ { 1, 1 }, { 2, 1 }, { 1, 2 }, { 2, 2 } })
  {
    SCOPED_TRACE(n[0] * 10 + n[1]);
    const double ux = 2.0;
    const double vx = 0.6;
    const double vy = 1.1;
    const dgg::SurfaceMesh mesh = Build(FlatTorus(ux, vx, vy, n[0], n[1], true));
    // Positions of the vertices of face f in the plane.
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

TEST_P(ExactDevelopable, MoebiusStripFromPointsAnywhere)
{
  const Id columns = 7;
  const Id rows = 4;
  const dgg::SurfaceMesh mesh = Build(MoebiusStrip(columns, rows));
  // Faces 2c and 2c+1 make the square of cell c; SurfacePoint::InFace takes the corners in the
  // order of the input.
  Random random(4);
  std::vector<dgg::SurfacePoint> points;
  std::vector<std::array<double, 2>> places;
  for (int i = 0; i < 30; ++i)
  {
    const Id face = random.Index(mesh.GetNumberOfFaces());
    const Id cell = face / 2;
    const double a = random.Uniform(0.1, 1.0);
    const double b = random.Uniform(0.1, 1.0);
    const double c = random.Uniform(0.1, 1.0);
    const double s = a + b + c;
    points.push_back(dgg::SurfacePoint::InFace(mesh, face, { { a / s, b / s, c / s } }));
    const double x = face % 2 == 0 ? (b + c) / s : b / s;
    const double y = face % 2 == 0 ? c / s : (b + c) / s;
    places.push_back({ { cell % columns + x, cell / columns + y - 0.5 * rows } });
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto distances = DistancesTo(mesh, this->Engine(), points[i], points);
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      const double truth =
        MoebiusDistance(columns, places[i][0], places[i][1], places[j][0], places[j][1]);
      EXPECT_NEAR(distances[j], truth, 1e-12 * (truth + 1e-3)) << i << " " << j;
    }
  }
}
}
