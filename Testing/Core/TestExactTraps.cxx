// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The ways in which window propagation goes wrong, one test each. Each was seen to fail with the
// rule in question taken out.
#include "BruteForceGeodesics.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggSurfacePath.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
class ExactTraps : public EngineTest
{
protected:
  void ExpectBruteForce(const TestMesh& input)
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const std::vector<double> truth = BruteForceDistances(mesh);
    const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
    ExpectAllPairs(
      mesh, this->Engine(), [&](Id a, Id b) { return truth[a * n + b]; }, 1e-10);
  }
};
DGG_WITH_BOTH_ENGINES(ExactTraps);

// A ray that hits a flat vertex exactly lights neither child, and what lies behind the vertex on
// that ray stays dark unless flat vertices emit again.
TEST_P(ExactTraps, FlatVerticesEmitAgain)
{
  // In the plane, (0,0) and (3,6), say, have (1,2) and (2,4) between them.
  ExpectEuclid(Plane(9, 9), this->Engine(), 1e-13);
  this->ExpectBruteForce(Cube(4));
}

// Two windows may light an apex by the very same ray, the root of one lying on the ray of the
// other; then both children of both are needed.
TEST_P(ExactTraps, CoincidentRaysKeepBothChildren)
{
  this->ExpectBruteForce(Cube(5));
  this->ExpectBruteForce(Subdivided(Octahedron(), 4));
  this->ExpectBruteForce(Subdivided(TwoHoledBlock(), 2));
}

// A regular mesh, full of ties and collinearities, and a jittered one of the same surface agree.
TEST_P(ExactTraps, RegularAgreesWithJittered)
{
  const Id k = 6;
  const TestMesh regular = Cube(k);
  const TestMesh jittered = Cube(k, 0.25, 7);
  const dgg::SurfaceMesh one = Build(regular);
  const dgg::SurfaceMesh other = Build(jittered);
  for (Id a = 0; a < one.GetNumberOfVertices(); ++a)
  {
    if (EuclideanDistance(regular, 0, a) == 0.0 ||
      std::equal(regular.Point(a), regular.Point(a) + 3, jittered.Point(a)))
    {
      const auto expected = DistancesFrom(one, this->Engine(), a);
      const auto distances = DistancesFrom(other, this->Engine(), a);
      for (Id b = 0; b < one.GetNumberOfVertices(); ++b)
      {
        if (std::equal(regular.Point(b), regular.Point(b) + 3, jittered.Point(b)))
        {
          EXPECT_NEAR(distances[b], expected[b], 1e-12) << a << " " << b;
        }
      }
    }
  }
}

// Of the windows that light an apex only the nearest needs both children, but not when the nearest
// comes from a source inside a face, which may lie within the cone of the other.
TEST_P(ExactTraps, OneChildRuleNeedsAVertexAsRoot)
{
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const TestMesh input = Plane(7, 7, 0.29, seed);
    const dgg::SurfaceMesh mesh = Build(input);
    const auto points = RandomSurfacePoints(mesh, 2, seed);
    const std::array<double, 3> places[] = { dgg::PositionOf(mesh, points[0], input.Points.data()),
      dgg::PositionOf(mesh, points[1], input.Points.data()) };
    // The second source starts a little earlier than the first one arrives: it wins in a narrow
    // strip behind itself, the first one on both sides of it.
    const double between = std::hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]);
    for (const double lead : { 0.3, 0.1, 0.03, 0.01 })
    {
      const double offset = (1.0 - lead) * between;
      const auto distances =
        Solve(mesh, this->Engine(), { { points[0], 0.0 }, { points[1], offset } }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double* p = input.Point(v);
        const double truth = std::min(std::hypot(p[0] - places[0][0], p[1] - places[0][1]),
          offset + std::hypot(p[0] - places[1][0], p[1] - places[1][1]));
        worst = std::max(worst, std::abs(distances[v] - truth) / truth);
      }
    }
  }
  EXPECT_LE(worst, 1e-12);
}

// On an edge with three faces the windows come from different sides: one table of winners for all
// of them is wrong. Any two sheets of a book are a plane.
TEST_P(ExactTraps, SheetsOfABookArePlanes)
{
  for (const Id sheets : { 3, 5 })
  {
    for (const double jitter : { 0.0, 0.25 })
    {
      std::vector<Id> sheetOf;
      const TestMesh input = Book(sheets, 5, sheetOf, jitter, 3);
      auto place = [&](Id v) { // distance from the spine, and position along it
        return std::array<double, 2>{ { std::hypot(input.Point(v)[0], input.Point(v)[2]),
          input.Point(v)[1] } };
      };
      ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
        const auto p = place(a);
        const auto q = place(b);
        const bool same = sheetOf[a] == sheetOf[b];
        return std::hypot(same ? p[0] - q[0] : p[0] + q[0], p[1] - q[1]);
      });
    }
  }
}

// The same with sources on two sheets that compete on the third: the one may lie within the cone of
// the other when the sheets are folded together, although its light never was in that cone.
TEST_P(ExactTraps, SheetsOfABookCompete)
{
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    std::vector<Id> sheetOf;
    const TestMesh input = Book(3, 6, sheetOf, 0.25, seed);
    const dgg::SurfaceMesh mesh = Build(input);
    auto away = [&](Id v) { return std::hypot(input.Point(v)[0], input.Point(v)[2]); };
    auto between = [&](Id a, Id b) {
      const double x = sheetOf[a] == sheetOf[b] ? away(a) - away(b) : away(a) + away(b);
      return std::hypot(x, input.Point(a)[1] - input.Point(b)[1]);
    };
    std::array<std::vector<Id>, 3> sheets;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      // On the third sheet only what lies next to the spine.
      if (sheetOf[v] >= 0 && (sheetOf[v] < 2 || away(v) < 1.5))
      {
        sheets[sheetOf[v]].push_back(v);
      }
    }
    Random random(seed);
    auto pick = [&](const std::vector<Id>& ids) {
      return ids[random.Index(static_cast<Id>(ids.size()))];
    };
    for (int trial = 0; trial < 4000; ++trial)
    {
      const Id far = pick(sheets[0]);
      const Id near = pick(sheets[1]);
      const Id prize = pick(sheets[2]);
      // The near source wins the prize by little, and a narrow strip about it: with the sheets
      // folded together it lies almost on the way of the far source.
      const double offset =
        between(far, prize) - between(near, prize) - random.Uniform(0.0001, 0.02);
      const double folded =
        std::hypot(away(far) - away(near), input.Point(far)[1] - input.Point(near)[1]);
      if (away(near) > 0.8 * away(far) || offset < 0.9 * folded)
      {
        continue;
      }
      const auto distances =
        Solve(mesh, this->Engine(), { VertexSource(far), VertexSource(near, offset) }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double truth = std::min(between(far, v), offset + between(near, v));
        worst = std::max(worst, std::abs(distances[v] - truth)); // distances of a few edges
      }
    }
  }
  EXPECT_LE(worst, 1e-12);
}

// A plane cut and glued again with one more sheet on the cut: nothing changes in the plane. Between
// the plane and the fin the sum of the distances from the cut counts, whichever way they unfold.
TEST_P(ExactTraps, PlaneGluedWithAFinStaysAPlane)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    Id count = 0;
    const TestMesh input = PlaneWithFin(5, count, 0.2, seed);
    const auto away = [&](Id v) { return std::abs(input.Point(v)[0] - 5.0) + input.Point(v)[2]; };
    ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
      return (a < count) == (b < count)
        ? EuclideanDistance(input, a, b)
        : std::hypot(away(a) + away(b), input.Point(a)[1] - input.Point(b)[1]);
    });
  }
}

// Sources in faces and on edges beside a non-manifold edge, and on it.
TEST_P(ExactTraps, SourcesNearASpine)
{
  std::vector<Id> sheetOf;
  const TestMesh input = Book(3, 5, sheetOf, 0.2, 9);
  const dgg::SurfaceMesh mesh = Build(input);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = mesh.Twin(h);
    const bool onSpine = twin != dgg::NoId && mesh.Twin(twin) != h;
    if (!onSpine)
    {
      continue;
    }
    const double* a = input.Point(mesh.Origin(h));
    const double* b = input.Point(mesh.Destination(h));
    const double y = 0.7 * a[1] + 0.3 * b[1];
    const auto distances =
      Solve(mesh, this->Engine(), { { dgg::SurfacePoint::OnEdge(mesh, h, 0.3), 0.0 } }).Distances;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double* p = input.Point(v);
      const double truth = std::hypot(std::hypot(p[0], p[2]), p[1] - y);
      EXPECT_NEAR(distances[v], truth, 1e-12 * truth);
    }
    // In the face beside the spine.
    const Id f = h / 3;
    const auto inFace = dgg::SurfacePoint::InFace(mesh, f, { { 0.2, 0.3, 0.5 } });
    const auto p = dgg::PositionOf(mesh, inFace, input.Points.data());
    const Id sheet = sheetOf[mesh.Apex(h)];
    const double x = std::hypot(p[0], p[2]);
    const auto fromFace = Solve(mesh, this->Engine(), { { inFace, 0.0 } }).Distances;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double* q = input.Point(v);
      const double away = std::hypot(q[0], q[2]);
      const double truth = std::hypot(sheetOf[v] == sheet ? x - away : x + away, p[1] - q[1]);
      EXPECT_NEAR(fromFace[v], truth, 1e-12 * truth);
    }
  }
}

// A contact in one point conducts.
TEST_P(ExactTraps, PointContactsConduct)
{
  const TestMesh input = TouchingSpheres(1);
  const dgg::SurfaceMesh mesh = Build(input);
  const Id half = mesh.GetNumberOfVertices() / 2;
  const auto fromContact = DistancesFrom(mesh, this->Engine(), 0);
  const auto distances = DistancesFrom(mesh, this->Engine(), half);
  for (Id v = half + 1; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(distances[v], fromContact[half] + fromContact[v], 1e-13);
  }
}

// The whole cube twice, either way round, changes neither distances nor work.
TEST_P(ExactTraps, DuplicateFacesTakeNoPart)
{
  const TestMesh cube = Cube(3, 0.2, 4);
  const dgg::SurfaceMesh one = Build(cube);
  for (const bool turned : { false, true })
  {
    TestMesh twice = cube;
    for (Id f = 0; f < cube.GetNumberOfFaces(); ++f)
    {
      const Id* t = &cube.Triangles[3 * f];
      twice.AddTriangle(t[0], t[turned ? 2 : 1], t[turned ? 1 : 2]);
    }
    const dgg::SurfaceMesh two = Build(twice);
    EXPECT_TRUE(two.IsDuplicate(cube.GetNumberOfFaces()));
    EXPECT_FALSE(two.IsDuplicate(0));
    for (const Id source : SomeVertices(one, 6, 5))
    {
      const dgg::ExactResult expected = Solve(one, this->Engine(), { VertexSource(source) });
      const dgg::ExactResult result = Solve(two, this->Engine(), { VertexSource(source) });
      EXPECT_EQ(result.Distances, expected.Distances);
      EXPECT_EQ(result.NumberOfWindows, expected.NumberOfWindows);
    }
  }
}

}
