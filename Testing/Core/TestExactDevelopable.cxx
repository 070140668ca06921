// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances on cylinders, cones, flat tori and the one-sided flat surfaces.
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
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
  for (const double total : { 0.5, 1.5, 3.0, 5.0, 6.2, 2.0 * dgg::Pi, 6.4, 8.0, 10.0, 14.0 })
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
  for (const auto& n : { std::array<Id, 2>{ { 1, 1 } }, std::array<Id, 2>{ { 2, 1 } },
         std::array<Id, 2>{ { 1, 2 } }, std::array<Id, 2>{ { 2, 2 } } })
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
  for (const auto& n :
    { std::array<Id, 2>{ { 3, 2 } }, std::array<Id, 2>{ { 9, 4 } }, std::array<Id, 2>{ { 5, 8 } } })
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
