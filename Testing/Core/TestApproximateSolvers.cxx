// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds for the heat method and for fast marching: close to exact, any triangles, invariances.
#include "ApproximationChecks.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "EdgeGraph.h"

#include "dggFastMarching.h"
#include "dggHeatMethod.h"

#include <functional>
#include <string>

namespace dggtest
{
namespace
{
struct Field
{
  std::vector<double> Distances;
  std::vector<Id> NearestSource;
  dgg::VirtualSources Virtual;
};

struct Approximation
{
  std::string Name;
  std::function<Field(const dgg::SurfaceMesh&, const dgg::GeodesicSource&)> Run;
  bool IsHeat;
};

Field March(
  const dgg::SurfaceMesh& mesh, const dgg::GeodesicSource& source, dgg::MarchingUpdate update)
{
  dgg::MarchingOptions options;
  options.Update = update;
  options.WantVirtualSource = true;
  dgg::MarchingResult result;
  EXPECT_TRUE(dgg::FastMarching(mesh).Run({ source }, options, result).IsOk());
  return { result.Distances, result.NearestSource, result.Virtual };
}

Field Heat(const dgg::SurfaceMesh& mesh, const dgg::GeodesicSource& source,
  dgg::HeatBoundary boundary, bool isDelaunay)
{
  dgg::HeatMethod heat(mesh);
  dgg::HeatOptions options;
  options.Boundary = boundary;
  options.IntrinsicDelaunay = isDelaunay;
  EXPECT_TRUE(heat.Prepare(options, nullptr).IsOk());
  dgg::HeatQuery query;
  query.WantNearestSource = true;
  query.WantVirtualSource = true;
  dgg::HeatResult result;
  EXPECT_TRUE(heat.Run({ source }, query, result).IsOk());
  return { result.Distances, result.NearestSource, result.Virtual };
}

/// The usual ones first.
std::vector<Approximation> Approximations()
{
  std::vector<Approximation> all;
  for (const auto update : { dgg::MarchingUpdate::Spherical, dgg::MarchingUpdate::Planar })
  {
    all.push_back({ update == dgg::MarchingUpdate::Spherical ? "spherical" : "planar",
      [update](const dgg::SurfaceMesh& mesh, const dgg::GeodesicSource& source) {
        return March(mesh, source, update);
      },
      false });
  }
  for (const auto boundary : { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Average })
  {
    const bool isDelaunay = boundary == dgg::HeatBoundary::Average;
    all.push_back({ isDelaunay ? "heat, average" : "heat, no flips",
      [boundary, isDelaunay](const dgg::SurfaceMesh& mesh, const dgg::GeodesicSource& source) {
        return Heat(mesh, source, boundary, isDelaunay);
      },
      true });
  }
  all.push_back({ "heat",
    [](const dgg::SurfaceMesh& mesh, const dgg::GeodesicSource& source) {
      return Heat(mesh, source, dgg::HeatBoundary::Neumann, true);
    },
    true });
  return all;
}
}

TEST(ApproximateSolvers, CloseToExactOnSoundMeshes)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    // Fronts lose their way in triangles of 1:20.
    const bool isLong = named.Name.find("Ellipsoid20") != std::string::npos;
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto point = dgg::SurfacePoint::InFace(mesh, 1, { { 0.2, 0.3, 0.5 } });
    for (const dgg::GeodesicSource& source : { VertexSource(0), dgg::GeodesicSource{ point, 0.0 } })
    {
      const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, { source }).Distances;
      for (const Approximation& approximation : Approximations())
      {
        if (approximation.Name != "spherical" && approximation.Name != "heat")
        {
          continue;
        }
        SCOPED_TRACE(named.Name + ", " + approximation.Name);
        const Errors errors = Compare(approximation.Run(mesh, source).Distances, exact);
        EXPECT_LT(errors.Mean, approximation.IsHeat ? 0.25 : isLong ? 0.15 : 0.03);
        EXPECT_TRUE(approximation.IsHeat || errors.Largest < (isLong ? 5.0 : 0.3));
      }
    }
  }
}

TEST(ApproximateSolvers, AnyTrianglesWillDo)
{
  for (const NamedMesh& named : DefectMeshesAndSoups(100))
  {
    dgg::SurfaceMesh mesh;
    if (named.Mesh.Points.empty())
    {
      mesh = Build(named.Mesh);
    }
    else if (!dgg::SurfaceMesh::FromPoints(named.Mesh.Points.data(),
               named.Mesh.GetNumberOfVertices(), named.Mesh.Triangles.data(),
               named.Mesh.GetNumberOfFaces(), mesh)
                .IsOk())
    {
      continue; // single points
    }
    for (const Id v : { 0, mesh.GetNumberOfVertices() - 1 })
    {
      const auto bound = EdgeGraphDistances(mesh, { VertexSource(v) });
      const double diameter = LargestFinite(bound);
      for (const Approximation& approximation : Approximations())
      {
        SCOPED_TRACE(named.Name + ", " + approximation.Name);
        const Field field = approximation.Run(mesh, VertexSource(v));
        ASSERT_EQ(field.Distances.size(), bound.size());
        for (std::size_t u = 0; u < bound.size(); ++u)
        {
          const bool isReached = bound[u] < dgg::Infinity;
          ASSERT_EQ(field.Distances[u] < dgg::Infinity, isReached) << u;
          ASSERT_EQ(field.NearestSource[u], isReached ? 0 : dgg::NoId) << u;
          ASSERT_GE(field.Distances[u], 0.0); // false for NaN
          ASSERT_LE(field.Distances[u],
            approximation.IsHeat && isReached ? 20.0 * diameter : bound[u] + 1e-9 * diameter);
          ASSERT_TRUE(!isReached || std::isfinite(field.Virtual.Angles[u])) << u;
        }
      }
    }
  }
}

TEST(ApproximateSolvers, Invariance)
{
  const TestMesh input = NoisySphere(3, 0.2, 9);
  for (const Approximation& approximation : Approximations())
  {
    SCOPED_TRACE(approximation.Name);
    const auto run = [&](const TestMesh& mesh, Id source) {
      return approximation.Run(Build(mesh), VertexSource(source)).Distances;
    };
    const auto base = run(input, 5);
    for (const double factor : { 1e-60, 1e-6, 1e6, 1e60 })
    {
      const auto scaled = run(Scaled(input, factor), 5);
      for (std::size_t v = 0; v < base.size(); ++v)
      {
        EXPECT_NEAR(scaled[v] / factor, base[v], 1e-9) << factor;
      }
    }
    const auto moved = run(MovedRigidly(input, 1.1, { { 3.0, -2.0, 1.0 } }), 5);
    ExpectSameField(base, moved, 1e-9, "moved");
    const auto newIds = RandomPermutation(input.GetNumberOfVertices(), 4);
    const auto renumbered = run(Renumbered(input, newIds, 6), newIds[5]);
    for (std::size_t v = 0; v < base.size(); ++v)
    {
      EXPECT_NEAR(renumbered[newIds[v]], base[v], 1e-9);
    }
  }
}
}
