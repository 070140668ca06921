// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Virtual sources fitted to distances alone.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggFaceEnvelope.h"
#include "dggLocalFit.h"
#include "dggSourceFinding.h"
#include "dggSurfacePath.h"

using namespace dgg;
using namespace dggtest;

namespace
{
VirtualSources Fit(const SurfaceMesh& mesh, const std::vector<double>& distances)
{
  VirtualSources found;
  EXPECT_TRUE(Ok(FitVirtualSources(mesh, distances.data(), {}, found)));
  return found;
}

/// Returns the mean error at points inside faces.
template <typename Truth>
double MeanError(const DistanceField& field, const std::vector<SurfacePoint>& points, Truth&& truth)
{
  FaceEnvelope envelope(field);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    envelope.Enter(points[i].Face);
    sum += std::abs(envelope.At(envelope.PlaceOf(points[i].Barycentric)) - truth(i));
  }
  return sum / static_cast<double>(points.size());
}

struct FitErrors
{
  double Linear = 0.0;
  double True = 0.0;
  double Fitted = 0.0;
};

/// Returns the errors of fits to exact distances with added noise.
FitErrors CompareFits(
  const TestMesh& test, const std::vector<GeodesicSource>& sources, double noise)
{
  const SurfaceMesh mesh = Build(test);
  const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 2000, 5);
  ExactResult result = Solve(
    mesh, ExactEngine::Triangle, sources, [&](ExactOptions& options) { options.Targets = points; });
  VirtualSources exact;
  FindVirtualSources(mesh, sources, result, exact);
  Random random(11);
  for (double& d : result.Distances)
  {
    d += random.Uniform(-noise, noise) * mesh.GetMeanEdgeLength();
  }
  const VirtualSources fitted = Fit(mesh, result.Distances);
  auto error = [&](const VirtualSources* virtualSources) {
    const DistanceField field{ &mesh, result.Distances.data(), nullptr, virtualSources };
    return MeanError(field, points, [&](std::size_t i) { return result.TargetDistances[i]; });
  };
  return { error(nullptr), error(&exact), error(&fitted) };
}
}

TEST(SourceFit, OneSourceInThePlaneIsFound)
{
  const TestMesh test = Plane(9, 9, 0.2);
  const SurfaceMesh mesh = Build(test);
  for (const double offset : { 0.0, -0.4, 3.0 })
  {
    // The source is inside a face; the distances of its corners must come from the source as well.
    const double x = 4.37;
    const double y = 3.61;
    std::vector<double> distances;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      distances.push_back(offset + std::hypot(test.Point(v)[0] - x, test.Point(v)[1] - y));
    }
    const VirtualSources found = Fit(mesh, distances);
    int inside = 0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (mesh.Kind(v) != VertexKind::Boundary)
      {
        EXPECT_NEAR(found[v].Offset, offset, 1e-9) << v;
        EXPECT_NEAR(found[v].Length, distances[v] - offset, 1e-9) << v;
        ++inside;
      }
      EXPECT_NEAR(found[v].Offset + found[v].Length, distances[v], 1e-9);
    }
    EXPECT_EQ(inside, 64);
    const DistanceField field{ &mesh, distances.data(), nullptr, &found };
    const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 500, 5);
    EXPECT_LT(MeanError(field, points,
                [&](std::size_t i) {
                  const auto p = PositionOf(mesh, points[i], test.Points.data());
                  return offset + std::hypot(p[0] - x, p[1] - y);
                }),
      1e-9);
  }
}

TEST(SourceFit, PlaneWavesStayPlane)
{
  const TestMesh test = Plane(9, 9, 0.2);
  const SurfaceMesh mesh = Build(test);
  auto wave = [](double x, double y) { return 10.0 + 0.6 * x + 0.8 * y; };
  std::vector<double> distances;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    distances.push_back(wave(test.Point(v)[0], test.Point(v)[1]));
  }
  const VirtualSources found = Fit(mesh, distances);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.Kind(v) != VertexKind::Boundary)
    {
      EXPECT_GT(found[v].Length, 1e4) << v;
    }
  }
  const DistanceField field{ &mesh, distances.data(), nullptr, &found };
  std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 500, 5);
  // At a corner of the plane, two neighbors can be explained by other sources too.
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&](const SurfacePoint& p) {
                   const std::array<Id, 3> corners = mesh.GetTriangle(p.Face);
                   return std::any_of(corners.begin(), corners.end(), [&](Id v) {
                     return mesh.Kind(v) == VertexKind::Boundary && mesh.TotalAngle(v) < 2.0;
                   });
                 }),
    points.end());
  ASSERT_GT(points.size(), 400u);
  EXPECT_LT(MeanError(field, points,
              [&](std::size_t i) {
                const auto p = PositionOf(mesh, points[i], test.Points.data());
                return wave(p[0], p[1]);
              }),
    1e-5);
}

TEST(SourceFit, IsCloseToTheTruthOnCurvedSurfaces)
{
  for (const NamedMesh& named :
    { NamedMesh{ "sphere", Icosphere(3) }, NamedMesh{ "ellipsoid", Ellipsoid(3, 0.4) },
      NamedMesh{ "torus", Torus(24, 14) }, NamedMesh{ "box", Box(6, 6, 6, 1.0, 1.0, 1.0, 0.2) } })
  {
    const FitErrors one = CompareFits(named.Mesh, { VertexSource(3) }, 0.0);
    EXPECT_LT(3.0 * one.Fitted, one.Linear) << named.Name;
    EXPECT_LT(one.Fitted, std::max(4.0 * one.True, 0.25 * one.Linear)) << named.Name;
  }
  const FitErrors rough = CompareFits(Terrain(20, 0.4, 3), { VertexSource(3) }, 0.0);
  EXPECT_LT(1.5 * rough.Fitted, rough.Linear);
}

TEST(SourceFit, RidgesDoNotSpoilIt)
{
  const TestMesh plane = Plane(14, 14, 0.2);
  const FitErrors two = CompareFits(plane, { VertexSource(48), VertexSource(176, 0.3) }, 0.0);
  EXPECT_LT(10.0 * two.Fitted, two.Linear);
}

TEST(SourceFit, NoiseMakesItHardlyWorseThanLinear)
{
  for (const double noise : { 0.001, 0.01, 0.05, 0.2 })
  {
    for (const TestMesh& test : { Icosphere(3), Torus(24, 14), Plane(14, 14, 0.2) })
    {
      const FitErrors errors = CompareFits(test, { VertexSource(3) }, noise);
      EXPECT_LT(errors.Fitted, 1.5 * errors.Linear) << noise;
    }
  }
}

TEST(SourceFit, AnySurfaceAndAnythingUnreached)
{
  for (const NamedMesh& named : AllMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    std::vector<double> distances = DistancesFrom(mesh, ExactEngine::Triangle, 0);
    for (std::size_t v = 0; v < distances.size(); v += 7)
    {
      distances[v] = v % 2 == 0 ? Infinity : std::nan("");
    }
    const VirtualSources found = Fit(mesh, distances);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (distances[v] < Infinity)
      {
        ASSERT_TRUE(std::isfinite(found[v].Angle)) << named.Name;
        ASSERT_GE(found[v].Length, 0.0) << named.Name;
        ASSERT_NEAR(found[v].Offset + found[v].Length, distances[v],
          1e-9 * (mesh.GetMeanEdgeLength() + std::abs(distances[v])))
          << named.Name;
        if (mesh.Kind(v) == VertexKind::Irregular)
        {
          EXPECT_EQ(found[v].Length, 0.0);
        }
      }
      else
      {
        EXPECT_EQ(found[v].Offset, Infinity);
      }
    }
  }
}

namespace
{
using dgg::FitSurface;
using dgg::LocalFit;
using dgg::Point3;

/// Returns random points of the height field z = a x^2 + b y^2 around the origin, rotated, with
/// noise.
std::vector<Point3> Samples(
  int count, double radius, double a, double b, double noise, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(-radius, radius);
  std::normal_distribution<double> error;
  std::vector<Point3> points;
  while (static_cast<int>(points.size()) < count)
  {
    const double x = place(generator);
    const double y = place(generator);
    if (x * x + y * y <= radius * radius)
    {
      const double z = a * x * x + b * y * y + noise * error(generator);
      // The z axis is rotated to (0, 0.6, 0.8).
      points.push_back({ x, 0.8 * y + 0.6 * z, -0.6 * y + 0.8 * z });
    }
  }
  return points;
}
}

TEST(LocalFit, QuadricsAreFound)
{
  const std::vector<Point3> points = Samples(32, 0.1, 1.5, -0.5, 0.0, 3);
  const LocalFit fit = FitSurface({ 0.0, 0.0, 0.0 }, points.data(), points.size());
  EXPECT_NEAR(std::abs(dgg::Dot(fit.Normal, { 0.0, 0.6, 0.8 })), 1.0, 1e-5);
  EXPECT_NEAR(fit.Curvature, 3.0, 0.1);
  EXPECT_LT(fit.Residual, 1e-4);
  EXPECT_LT(dgg::Norm(fit.ToSurface), 1e-4);
}

TEST(LocalFit, NoiseIsMeasuredAndPointsAreMovedToTheSurface)
{
  const double noise = 0.004;
  double residual = 0.0;
  double off = 0.0;
  const int trials = 50;
  for (int trial = 0; trial < trials; ++trial)
  {
    std::vector<Point3> points = Samples(60, 0.1, 0.8, 0.8, noise, 100 + trial);
    // At three times the noise from the surface.
    const Point3 point{ 0.0, 0.6 * 3.0 * noise, 0.8 * 3.0 * noise };
    points.push_back(point);
    const LocalFit fit = FitSurface(point, points.data(), points.size());
    residual += fit.Residual / trials;
    off += dgg::Norm(point + fit.ToSurface) / trials;
  }
  EXPECT_NEAR(residual, noise, 0.25 * noise);
  EXPECT_LT(off, noise);
}

TEST(LocalFit, TooLittleForAPlane)
{
  const Point3 origin;
  const std::vector<Point3> line{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  EXPECT_EQ(dgg::Norm(FitSurface(origin, line.data(), line.size()).Normal), 0.0);
  EXPECT_EQ(dgg::Norm(FitSurface(origin, line.data(), 2).Normal), 0.0);
  const std::vector<Point3> same(20, Point3{ 1.0, 2.0, 3.0 });
  EXPECT_EQ(dgg::Norm(FitSurface(same[0], same.data(), same.size()).Normal), 0.0);
  // Four coplanar points determine only a plane.
  const std::vector<Point3> square{ { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const LocalFit fit = FitSurface({ 0.5, 0.5, 0.0 }, square.data(), square.size());
  EXPECT_NEAR(std::abs(fit.Normal.Z), 1.0, 1e-12);
  EXPECT_NEAR(fit.ToSurface.Z, 1.0, 1e-12);
  EXPECT_EQ(fit.Curvature, 0.0);
}

TEST(LocalFit, NeighborsOnACircleDoNotDecideOnAQuadric)
{
  std::vector<Point3> ring;
  for (int i = 0; i < 12; ++i)
  {
    ring.push_back({ std::cos(i * 0.5236), std::sin(i * 0.5236), 0.0 });
  }
  const LocalFit fit = FitSurface({ 0.0, 0.0, 0.0 }, ring.data(), ring.size());
  EXPECT_NEAR(std::abs(fit.Normal.Z), 1.0, 1e-6);
  EXPECT_LT(fit.Curvature, 1e-3);
}
