// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Virtual sources from distances alone.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggSourceFinding.h"
#include "dggFaceProfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dgg;
using namespace dggtest;

namespace
{
VirtualSources Fit(const SurfaceMesh& mesh, const std::vector<double>& distances)
{
  VirtualSources found;
  FitVirtualSources(mesh, distances.data(), {}, found);
  return found;
}

/// Mean difference from the truth at points inside of faces.
template <typename Truth>
double MeanError(const DistanceField& field, const std::vector<SurfacePoint>& points, Truth&& truth)
{
  FaceProfile profile(field);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    profile.Enter(points[i].Face);
    sum += std::abs(profile.At(profile.PlaceOf(points[i].Barycentric)) - truth(i));
  }
  return sum / static_cast<double>(points.size());
}

std::array<double, 2> PlaceOf(const TestMesh& test, const SurfaceMesh& mesh, const SurfacePoint& p)
{
  std::array<double, 2> place{ { 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const double* corner = test.Point(mesh.Origin(3 * p.Face + k));
    place[0] += p.Barycentric[k] * corner[0];
    place[1] += p.Barycentric[k] * corner[1];
  }
  return place;
}

struct Errors
{
  double Linear = 0.0;
  double True = 0.0;
  double Fitted = 0.0;
};

/// Errors with exact distances and noise on them.
Errors Compare(const TestMesh& test, const std::vector<GeodesicSource>& sources, double noise)
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
    // Somewhere in a face; the distances of its corners have to be those of the source as well.
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
        EXPECT_NEAR(found.Offsets[v], offset, 1e-9) << v;
        EXPECT_NEAR(found.Lengths[v], distances[v] - offset, 1e-9) << v;
        ++inside;
      }
      EXPECT_NEAR(found.Offsets[v] + found.Lengths[v], distances[v], 1e-9);
    }
    EXPECT_EQ(inside, 64);
    const DistanceField field{ &mesh, distances.data(), nullptr, &found };
    const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 500, 5);
    EXPECT_LT(MeanError(field, points,
                [&](std::size_t i) {
                  const std::array<double, 2> p = PlaceOf(test, mesh, points[i]);
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
      EXPECT_GT(found.Lengths[v], 1e4) << v;
    }
  }
  const DistanceField field{ &mesh, distances.data(), nullptr, &found };
  std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 500, 5);
  // At a corner of the plane, two neighbours can be explained by other sources as well.
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
                const std::array<double, 2> p = PlaceOf(test, mesh, points[i]);
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
    const Errors one = Compare(named.Mesh, { VertexSource(3) }, 0.0);
    EXPECT_LT(3.0 * one.Fitted, one.Linear) << named.Name;
    EXPECT_LT(one.Fitted, std::max(4.0 * one.True, 0.25 * one.Linear)) << named.Name;
  }
  const Errors rough = Compare(Terrain(20, 0.4, 3), { VertexSource(3) }, 0.0);
  EXPECT_LT(1.5 * rough.Fitted, rough.Linear);
}

TEST(SourceFit, RidgesDoNotSpoilIt)
{
  const TestMesh plane = Plane(14, 14, 0.2);
  const Errors two = Compare(plane, { VertexSource(48), VertexSource(176, 0.3) }, 0.0);
  EXPECT_LT(10.0 * two.Fitted, two.Linear);
}

TEST(SourceFit, NoiseMakesItHardlyWorseThanLinear)
{
  for (const double noise : { 0.001, 0.01, 0.05, 0.2 })
  {
    for (const TestMesh& test : { Icosphere(3), Torus(24, 14), Plane(14, 14, 0.2) })
    {
      const Errors errors = Compare(test, { VertexSource(3) }, noise);
      EXPECT_LT(errors.Fitted, 1.5 * errors.Linear) << noise;
    }
  }
}

TEST(SourceFit, AnySurfaceAndAnythingUnreached)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  for (const NamedMesh& named : SoundMeshes())
  {
    meshes.push_back(named);
  }
  for (const NamedMesh& named : meshes)
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
        ASSERT_TRUE(std::isfinite(found.Angles[v])) << named.Name;
        ASSERT_GE(found.Lengths[v], 0.0) << named.Name;
        ASSERT_NEAR(found.Offsets[v] + found.Lengths[v], distances[v],
          1e-9 * (mesh.GetMeanEdgeLength() + std::abs(distances[v])))
          << named.Name;
        if (mesh.Kind(v) == VertexKind::Irregular)
        {
          EXPECT_EQ(found.Lengths[v], 0.0);
        }
      }
      else
      {
        EXPECT_EQ(found.Offsets[v], Infinity);
      }
    }
  }
}

TEST(SourceFit, ThreadsDoNotMatter)
{
  const SurfaceMesh mesh = Build(Icosphere(4));
  const std::vector<double> distances = DistancesFrom(mesh, ExactEngine::Triangle, 0);
  const VirtualSources one = Fit(mesh, distances);
  VirtualSources other;
  FitVirtualSources(mesh, distances.data(), WithThreads(4, 50), other);
  EXPECT_EQ(one.Offsets, other.Offsets);
  EXPECT_EQ(one.Lengths, other.Lengths);
  EXPECT_EQ(one.Angles, other.Angles);
}

TEST(SourceFit, CanBeStopped)
{
  const SurfaceMesh mesh = Build(Icosphere(5)); // 10242 vertices
  const std::vector<double> distances(static_cast<std::size_t>(mesh.GetNumberOfVertices()), 1.0);
  VirtualSources found;
  int calls = 0;
  EXPECT_TRUE(FitVirtualSources(mesh, distances.data(), {}, found, [&](double) {
    ++calls;
    return true;
  }));
  EXPECT_GT(calls, 0);
  EXPECT_EQ(found.Offsets.size(), distances.size());
  EXPECT_FALSE(FitVirtualSources(mesh, distances.data(), {}, found, [](double) { return false; }));
  EXPECT_TRUE(found.Offsets.empty());
}
