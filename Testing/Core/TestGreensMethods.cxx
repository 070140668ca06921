// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// How the ways to find a Green's function compare, and where each is left for another one.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace dggtest
{
TEST(GreensFunction, MethodsInTheirOrder)
{
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  double errors[4] = { 0.0, 0.0, 0.0, 0.0 };
  Random random(11);
  const int poles = 10;
  for (int k = 0; k < poles; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    for (int m = 0; m < 4; ++m)
    {
      const dgg::GreensResult result = greens.Run(pole, Methods[m]);
      EXPECT_EQ(result.Method, Methods[m]);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      errors[m] += CompareOnSphere(sphere, greens, pole, result.Values, 0.3).Near / poles;
    }
  }
  for (int m = 0; m < 4; ++m)
  {
    RecordProperty("method" + std::to_string(m), std::to_string(errors[m]));
  }
  EXPECT_LT(20.0 * errors[0], errors[2]);
  EXPECT_LT(errors[2], 0.5 * errors[3]);
}

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
  // Nothing far away has changed but for the mean.
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
  // At a vertex there is nothing to correct.
  EXPECT_EQ(greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Localized).Values,
    greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Interpolated).Values);
}

TEST(GreensFunction, LocalizedNeedsFewNeighbours)
{
  // A fan of thousands of triangles: neither is it looked at, nor does it take long.
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
      b[(largest + 1) % 3] += 1e-3; // of the others, this one is next
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
  // Behind the corners of a cube shortest ways meet from two sides. The truth is from a finer mesh.
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
  // Within a radius that is given.
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

TEST(GreensFunction, FlippedMeshes)
{
  // Obtuse triangles: with flips the result is better, and the pole is found among them.
  // The domain is a square, the triangles are five times as wide as high.
  TestMesh fine = Plane(20, 100, 0.28, 6);
  for (std::size_t k = 0; k < fine.Points.size(); k += 3)
  {
    fine.Points[k] /= 20.0;
    fine.Points[k + 1] /= 100.0;
  }
  const dgg::SurfaceMesh mesh = Build(fine);
  double errors[2] = { 0.0, 0.0 };
  for (const bool delaunay : { false, true })
  {
    const Greens greens(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
    Random random(13);
    Comparison all;
    for (int k = 0; k < 30; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      const std::array<double, 3> x = dgg::PositionOf(mesh, pole, fine.Points.data());
      if (std::abs(x[0] - 0.5) > 0.25 || std::abs(x[1] - 0.5) > 0.25)
      {
        continue;
      }
      const dgg::GreensResult result = greens.Run(pole);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        all.Add(greens.Solver.GetAreas()[v], result.Values[v], SquareGreens(x, fine.Point(v)));
      }
    }
    errors[delaunay] = all.Relative();
  }
  RecordProperty("direct", std::to_string(errors[0]));
  RecordProperty("flipped", std::to_string(errors[1]));
  EXPECT_LT(errors[0], 2e-2);
  EXPECT_LT(errors[1], 0.2 * errors[0]);
}

}
