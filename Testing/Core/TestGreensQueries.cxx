// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparison of the methods for Green's functions, and queries: points, integrals, signs, any
// triangles.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"

namespace dggtest
{
TEST(GreensFunction, LocalizedReproducesDistances)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.1, 2));
  const Greens greens(mesh);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 77, { { 0.3, 0.25, 0.45 } });
  // The sixty vertices nearest to the pole.
  std::vector<dgg::SurfacePoint> everywhere;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    everywhere.push_back(dgg::SurfacePoint::AtVertex(v));
  }
  const auto distances = DistancesTo(mesh, dgg::ExactEngine::Triangle, pole, everywhere);
  std::vector<Id> near(distances.size());
  std::iota(near.begin(), near.end(), 0);
  std::sort(near.begin(), near.end(), [&](Id a, Id b) { return distances[a] < distances[b]; });
  near.resize(60);
  double misfits[2] = { 0.0, 0.0 };
  std::vector<double> values[2];
  for (const bool isLocalized : { false, true })
  {
    const auto method =
      isLocalized ? dgg::GreensMethod::Localized : dgg::GreensMethod::Interpolated;
    values[isLocalized] = greens.Run(pole, method).Values;
    const std::vector<double> product = greens.Solver.GetSystem().Multiply(values[isLocalized]);
    for (const Id s : near)
    {
      const auto d = DistancesFrom(mesh, dgg::ExactEngine::Triangle, s);
      const double expected =
        DistancesTo(mesh, dgg::ExactEngine::Triangle, dgg::SurfacePoint::AtVertex(s), { pole })[0];
      double sum = 0.0;
      for (const Id i : near)
      {
        sum += d[i] * (greens.Solver.GetWeight(i) + product[i]);
      }
      misfits[isLocalized] += (sum - expected) * (sum - expected);
    }
  }
  EXPECT_LT(std::sqrt(misfits[1]), 0.1 * std::sqrt(misfits[0]));
  // Far from the pole the values differ only by a constant.
  double shift = dgg::Infinity;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (distances[v] > 1.5)
    {
      const double change = values[1][v] - values[0][v];
      shift = shift < dgg::Infinity ? shift : change;
      EXPECT_NEAR(change, shift, 1e-12);
    }
  }
  EXPECT_LT(std::abs(shift), 1e-3);
  // At a vertex no correction is needed.
  EXPECT_EQ(greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Localized).Values,
    greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Interpolated).Values);
}

TEST(GreensFunction, LocalizedNeedsFewNeighbors)
{
  // A fan of thousands of triangles is not searched, so the query is fast.
  for (const Id wedges : { 300, 5000 })
  {
    std::vector<ConePoint> points;
    const dgg::SurfaceMesh mesh = Build(Cone(2.0 * dgg::Pi, wedges, 3, points));
    const Greens greens(mesh);
    const auto pole = dgg::SurfacePoint::InFace(mesh, 0, { { 0.5, 0.25, 0.25 } });
    const dgg::GreensResult result = greens.Run(pole, dgg::GreensMethod::Localized);
    EXPECT_EQ(result.Remark, dgg::GreensRemark::NotLocalized) << wedges;
    EXPECT_EQ(result.Values, greens.Run(pole, dgg::GreensMethod::Interpolated).Values) << wedges;
  }
}

TEST(GreensFunction, CornersWithGivenValuesAreNoPoles)
{
  const dgg::SurfaceMesh mesh = Build(Plane(6, 6));
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  int onRim = 0;
  int allGiven = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    for (int largest = 0; largest < 3; ++largest)
    {
      std::array<double, 3> b{ { 0.2, 0.2, 0.2 } };
      b[largest] = 0.6;
      Id free = dgg::NoId;
      double weight = 0.0;
      b[(largest + 1) % 3] += 1e-3; // the second largest coordinate
      b[largest] -= 1e-3;
      for (int k = 0; k < 3; ++k)
      {
        const Id v = mesh.Origin(3 * f + k);
        if (!greens.Solver.IsFixed(v) && b[k] > weight)
        {
          free = v;
          weight = b[k];
        }
      }
      const auto pole = dgg::SurfacePoint::InFace(mesh, f, b);
      const dgg::GreensResult result = greens.Run(pole, dgg::GreensMethod::Vertex);
      if (free == dgg::NoId)
      {
        ++allGiven;
        EXPECT_EQ(result.Method, dgg::GreensMethod::Interpolated);
        EXPECT_EQ(result.Remark, dgg::GreensRemark::TooCoarse);
        continue;
      }
      onRim += greens.Solver.IsFixed(mesh.Origin(3 * f + largest)) ? 1 : 0;
      EXPECT_EQ(result.Method, dgg::GreensMethod::Vertex);
      EXPECT_EQ(result.Values,
        greens.Run(dgg::SurfacePoint::AtVertex(free), dgg::GreensMethod::Vertex).Values);
    }
  }
  EXPECT_GT(onRim, 10);
  EXPECT_GT(allGiven, 0);
}

TEST(GreensFunction, RidgesNearThePole)
{
  // Behind the corners of a cube, shortest paths arrive from two sides. The truth is computed on a
  // finer mesh.
  const TestMesh cube = Cube(10);
  const TestMesh fineCube = Subdivided(cube, 4);
  const dgg::SurfaceMesh mesh = Build(cube);
  const dgg::SurfaceMesh fine = Build(fineCube);
  const Greens greens(mesh);
  const Greens onFine(fine);
  Random random(3);
  int remarks = 0;
  for (int k = 0; k < 8; ++k)
  {
    const Id face = random.Index(mesh.GetNumberOfFaces());
    const std::array<double, 3> b{ { 0.25, 0.25, 0.5 } };
    const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, face, b);
    const std::array<double, 3> x = dgg::PositionOf(mesh, pole, cube.Points.data());
    dgg::GreensQuery query;
    query.Radius = 0.3;
    const auto truth =
      onFine.Run(dgg::SurfacePoint::AtVertex(VertexAt(fineCube, x[0], x[1], x[2])), query).Values;
    const dgg::GreensResult result = greens.Run(pole);
    remarks += result.Remark == dgg::GreensRemark::NearRidge ? 1 : 0;
    EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
    const auto simple = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
    Comparison good;
    Comparison plain;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      good.Add(greens.Solver.GetAreas()[v], result.Values[v], truth[v]);
      plain.Add(greens.Solver.GetAreas()[v], simple[v], truth[v]);
    }
    EXPECT_LT(good.Relative(), 5e-3) << k;
    EXPECT_LT(good.Relative(), 0.3 * plain.Relative()) << k;
  }
  EXPECT_GT(remarks, 0);
  // With a given radius.
  const dgg::SurfaceMesh other = Build(Cube(12));
  const Greens onOther(other);
  const auto inside = dgg::SurfacePoint::InFace(other, 60, { { 0.3, 0.3, 0.4 } });
  for (const double radius : { 0.4, 1.2 })
  {
    dgg::GreensQuery query;
    query.Radius = radius;
    const dgg::GreensResult result = onOther.Run(inside, query);
    EXPECT_EQ(result.Radius, radius);
    EXPECT_EQ(result.Remark, radius > 1.0 ? dgg::GreensRemark::NearRidge : dgg::GreensRemark::None)
      << radius;
  }
}

TEST(GreensFunction, AnyPointSeesAnyOther)
{
  // Both arguments are arbitrary points: compare with the truth, and check symmetry.
  const TestMesh sphere = Icosphere(5);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  Random random(9);
  std::vector<dgg::SurfacePoint> points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  // Two points in the same face, and one on an edge of the face.
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.6, 0.2, 0.2 } }));
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.2, 0.2, 0.6 } }));
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 15, 0.3));
  points.push_back(dgg::SurfacePoint::AtVertex(40));
  dgg::GreensQuery query;
  query.Targets = points;
  std::vector<dgg::GreensResult> results;
  ASSERT_TRUE(greens.Function.Run(points, query, results).IsOk());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::array<double, 3> x = dgg::PositionOf(mesh, points[i], sphere.Points.data());
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (i == j)
      {
        EXPECT_TRUE(std::isfinite(results[i].TargetValues[j]));
        EXPECT_GT(results[i].TargetValues[j], 0.5);
        continue;
      }
      const std::array<double, 3> y = dgg::PositionOf(mesh, points[j], sphere.Points.data());
      double chord = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        chord += (x[k] - y[k]) * (x[k] - y[k]);
      }
      // The truth uses the chord, because the points lie slightly inside the sphere.
      EXPECT_NEAR(results[i].TargetValues[j], SphereGreens(1.0 - 0.5 * chord), 2e-3)
        << i << " " << j;
      EXPECT_NEAR(results[i].TargetValues[j], results[j].TargetValues[i], 3e-4) << i << " " << j;
    }
  }
  // Single queries give the same values.
  for (const std::size_t i : { std::size_t(0), std::size_t(9) })
  {
    const dgg::GreensResult one = greens.Run(points[i], query);
    ExpectSameField(one.Values, results[i].Values, 1e-12, "block");
    ExpectSameField(one.TargetValues, results[i].TargetValues, 1e-12, "block");
  }
}

TEST(GreensFunction, SolvesPoissonEquations)
{
  // u = mean(u) + sum of the integrals of g times f: compared with the sparse solution at vertices
  // and with the closed form inside faces.
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  const Id n = mesh.GetNumberOfVertices();
  const auto harmonic = [](const double* p) { return p[0] * p[1] - 0.5 * p[1] * p[2]; }; // l = 2
  std::vector<double> density(n);
  std::vector<double> u(n);
  for (Id v = 0; v < n; ++v)
  {
    density[v] = 6.0 * harmonic(sphere.Point(v));
    u[v] = density[v] * greens.Solver.GetAreas()[v];
  }
  ASSERT_TRUE(greens.Solver.Solve(u).IsOk());
  dgg::GreensQuery query;
  query.WantIntegrals = true;
  const auto at = [&](const dgg::SurfacePoint& pole, dgg::GreensMethod method) {
    query.Method = method;
    const dgg::GreensResult result = greens.Run(pole, query);
    double sum = 0.0;
    double total = 0.0;
    for (Id v = 0; v < n; ++v)
    {
      sum += result.Integrals[v] * density[v];
      total += result.Integrals[v];
    }
    EXPECT_NEAR(total, 0.0, 1e-12);
    return sum;
  };
  for (const Id v : SomeVertices(mesh, 6, 4))
  {
    EXPECT_NEAR(at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::Vertex), u[v], 1e-9);
    EXPECT_NEAR(
      at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::SingularitySubtraction), u[v], 2e-3);
  }
  Random random(8);
  for (int k = 0; k < 6; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    std::array<double, 3> x = dgg::PositionOf(mesh, pole, sphere.Points.data());
    EXPECT_NEAR(at(pole, dgg::GreensMethod::SingularitySubtraction), harmonic(x.data()), 4e-3);
  }
}

TEST(GreensFunction, ValueAtThePoleAndSigns)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  const Greens greens(mesh);
  dgg::GreensQuery query;
  query.Targets = { dgg::SurfacePoint::AtVertex(3) };
  const dgg::GreensResult average = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_TRUE(std::isfinite(average.Values[3]));
  EXPECT_EQ(average.TargetValues[0], average.Values[3]);
  // The mean of -log(r) over a disk is its value at the rim plus 1/2.
  const double radius = std::sqrt(2.0 * greens.Solver.GetAreas()[3] / mesh.TotalAngle(3));
  EXPECT_NEAR(average.Values[3], SphereGreens(std::cos(radius)) + 0.5 / mesh.TotalAngle(3), 0.01);
  query.Sign = dgg::GreensSign::Negative;
  const dgg::GreensResult negative = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  for (std::size_t v = 0; v < negative.Values.size(); ++v)
  {
    EXPECT_EQ(negative.Values[v], -average.Values[v]);
  }
  query.Pole = dgg::GreensPole::Infinite;
  const dgg::GreensResult infinite = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_EQ(infinite.Values[3], -dgg::Infinity);
  EXPECT_EQ(infinite.TargetValues[0], -dgg::Infinity);
  EXPECT_EQ(infinite.Values[4], negative.Values[4]);
}

TEST(GreensFunction, AnyTriangles)
{
  int thin = 0;
  for (const NamedMesh& named : DefectMeshesAndSoups(40))
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      const dgg::PoissonOptions options = With(dgg::PoissonBoundary::Neumann, delaunay);
      if (IsThinSoup(mesh, named.Name, options))
      {
        ++thin;
        continue;
      }
      const Greens greens(mesh, options);
      const std::vector<double>& areas = greens.Solver.GetAreas();
      if (!(*std::max_element(areas.begin(), areas.end()) > 0.0))
      {
        continue; // no point lies inside a face
      }
      for (const dgg::SurfacePoint& pole : RandomSurfacePoints(mesh, 3, 2))
      {
        if (!greens.Solver.CheckPole(pole).IsOk())
        {
          continue;
        }
        for (const dgg::GreensMethod method : Methods)
        {
          dgg::GreensQuery query;
          query.Method = method;
          query.Targets = RandomSurfacePoints(mesh, 4, 9);
          query.Targets.push_back(pole);
          query.WantIntegrals = true;
          query.Radius =
            method == dgg::GreensMethod::SingularitySubtraction && delaunay ? 0.0 : 3.0;
          const dgg::GreensResult result = greens.Run(pole, query);
          double largest = 1.0;
          for (const double value : result.Values)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            largest = std::max(largest, std::abs(value));
          }
          for (const double value : result.TargetValues)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
          }
          double sum = 0.0;
          double size = 0.0;
          for (const double value : result.Integrals)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            sum += value;
            size += std::abs(value);
          }
          EXPECT_NEAR(sum, 0.0, 1e-6 * size + 1e-9) << named.Name;
        }
      }
    }
  }
  EXPECT_LT(thin, 10);
}
}
