// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Earth mover's distance on surfaces.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggEarthMovers.h"

namespace dggtest
{
namespace
{
std::vector<double> PointMass(const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& point)
{
  std::vector<double> masses(mesh.GetNumberOfVertices(), 0.0);
  EXPECT_TRUE(dgg::AddPointMass(mesh, point, 1.0, masses).IsOk());
  return masses;
}

dgg::EarthMoversResult Move(const dgg::PoissonSolver& solver, const std::vector<double>& from,
  const std::vector<double>& to, const dgg::EarthMoversOptions& options = {})
{
  dgg::EarthMoversResult result;
  EXPECT_TRUE(Ok(dgg::EarthMovers(solver).Run(from, to, options, result)));
  EXPECT_LE(result.LowerBound, result.Distance * (1.0 + 1e-9));
  return result;
}
}

TEST(EarthMovers, PointMassesAreTheirGeodesicDistanceApart)
{
  dgg::EarthMoversOptions options;
  options.MostIterations = 2000;
  options.Tolerance = 5e-3;
  // On a torus the flow has a harmonic component, which is neither a gradient nor the rotated
  // gradient of a function.
  for (const bool isTorus : { false, true })
  {
    double previous = 0.0;
    for (const int level : { 2, 3, 4 })
    {
      const dgg::SurfaceMesh mesh =
        Build(isTorus ? Torus(6 << level, 3 << level) : Icosphere(level));
      const auto solver = Ready(mesh);
      const Id target = isTorus ? (6 << level) / 3 : 7;
      const double expected = DistancesFrom(mesh, dgg::ExactEngine::Triangle, 0)[target];
      const dgg::EarthMoversResult result =
        Move(*solver, PointMass(mesh, dgg::SurfacePoint::AtVertex(0)),
          PointMass(mesh, dgg::SurfacePoint::AtVertex(target)), options);
      EXPECT_LE(result.LowerBound, expected * (1.0 + 1e-9));
      const double error = std::abs(result.Distance / expected - 1.0);
      if (level > 2)
      {
        EXPECT_LT(error, previous) << level;
      }
      previous = error;
      if (level == 4)
      {
        EXPECT_LT(error, 0.06) << isTorus << " " << result.Iterations;
      }
    }
  }
}

TEST(EarthMovers, TheGapIsClosedOnAnyTriangles)
{
  // Planes of needles, a tape of long triangles, strips, blocks without points inside their sides,
  // and a rough sphere.
  TestMesh tape = Plane(30, 4);
  for (std::size_t i = 1; i < tape.Points.size(); i += 3)
  {
    tape.Points[i] *= 2e-5;
  }
  const NamedMesh meshes[] = { { "tape", tape }, { "needles", NeedlePlane(20, 0.01) },
    { "box", Box(30, 2, 1, 3.0, 20.0, 0.5) }, { "block", Box(12, 1, 12, 6.0, 5.0, 6.0, 0.2) },
    { "rough", NoisySphere(3, 0.2, 4) }, { "collinear", CollinearPlane(12) } };
  for (const NamedMesh& named : meshes)
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto solver = Ready(mesh);
    const std::vector<dgg::SurfacePoint> points = RandomSurfacePoints(mesh, 4, 8);
    for (int k = 0; k < 4; k += 2)
    {
      const dgg::EarthMoversResult result =
        Move(*solver, PointMass(mesh, points[k]), PointMass(mesh, points[k + 1]));
      EXPECT_LE(result.Distance - result.LowerBound, 0.01 * result.Distance) << named.Name;
      EXPECT_LE(result.Iterations, 200) << named.Name;
    }
    const Id last = mesh.GetNumberOfVertices() - 1;
    const double expected = DistancesFrom(mesh, dgg::ExactEngine::Triangle, 0)[last];
    const dgg::EarthMoversResult result =
      Move(*solver, PointMass(mesh, dgg::SurfacePoint::AtVertex(0)),
        PointMass(mesh, dgg::SurfacePoint::AtVertex(last)));
    EXPECT_LE(result.LowerBound, expected * (1.0 + 1e-6)) << named.Name;
    EXPECT_LE(result.Distance, expected * 1.0102) << named.Name;
  }
}

TEST(EarthMovers, FlowBringsEveryMassThereAndCostsTheDistance)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.2, 4));
  const auto solver = Ready(mesh);
  const auto from = PointMass(mesh, dgg::SurfacePoint::InFace(mesh, 5, { { 0.3, 0.3, 0.4 } }));
  const auto to = PointMass(mesh, dgg::SurfacePoint::AtVertex(40));
  for (const int iterations : { 0, 95 })
  {
    dgg::EarthMoversOptions options;
    options.MostIterations = iterations;
    options.Tolerance = 0.0;
    const dgg::EarthMoversResult result = Move(*solver, from, to, options);
    ASSERT_EQ(result.Flow.size(), static_cast<std::size_t>(mesh.GetNumberOfFaces()));
    // Flow into the corners of a face, by the gradients of their hat functions.
    std::vector<double> arrived(from);
    double cost = 0.0;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      const dgg::Point2 flow = result.Flow[f];
      const double length = mesh.Length(3 * f);
      const double x = mesh.ApexX(3 * f);
      const double y = mesh.ApexY(3 * f);
      const double area = 0.5 * length * y;
      const double third = area * flow.Y / y;
      const double second = (area * flow.X - third * x) / length;
      arrived[mesh.GetTriangle(f)[0]] -= second + third;
      arrived[mesh.GetTriangle(f)[1]] += second;
      arrived[mesh.GetTriangle(f)[2]] += third;
      cost += area * dgg::Norm(flow.X, flow.Y);
    }
    EXPECT_NEAR(cost, result.Distance, 1e-9);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_NEAR(arrived[v], to[v], 1e-8) << v;
    }
  }
  dgg::PoissonOptions delaunay;
  delaunay.IntrinsicDelaunay = true;
  EXPECT_TRUE(Move(*Ready(mesh, delaunay), from, to).Flow.empty());
}

TEST(EarthMovers, AnyTriangles)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto solver = Ready(mesh);
    Id count = 0;
    const std::vector<Id> components = mesh.ComputeComponents(count);
    // The mass moves from the first vertex of a component with several vertices to the last vertex
    // of that component.
    Id first = 0;
    Id last = 0;
    for (Id v = mesh.GetNumberOfVertices() - 1; v >= 0; --v)
    {
      const Id w = static_cast<Id>(
        std::find(components.begin(), components.end(), components[v]) - components.begin());
      if (w != v)
      {
        first = w;
        last = v;
        break;
      }
    }
    dgg::EarthMoversOptions options;
    options.MostIterations = 60;
    const dgg::EarthMoversResult result =
      Move(*solver, PointMass(mesh, dgg::SurfacePoint::AtVertex(first)),
        PointMass(mesh, dgg::SurfacePoint::AtVertex(last)), options);
    EXPECT_TRUE(std::isfinite(result.Distance)) << named.Name;
    EXPECT_TRUE(std::isfinite(result.LowerBound)) << named.Name;
    for (const double value : result.Potential)
    {
      ASSERT_TRUE(std::isfinite(value)) << named.Name;
    }
  }
}

}
