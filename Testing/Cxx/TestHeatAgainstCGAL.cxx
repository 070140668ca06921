// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Comparison of the heat method with CGAL's, with and without edge flips: it must be at least as
/// accurate.

#include "GeneratedMesh.h"
#include "MeshFile.h"
#include "PeerHeat.h"
#include "TestMeshes.h"

#include "dggExactGeodesics.h"
#include "dggHeatMethod.h"
#include "dggSurfaceMesh.h"

#include <gtest/gtest.h>

#include <vtkPolyData.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
MeshArrays ToArrays(const dggtest::TestMesh& mesh)
{
  return { mesh.Points, mesh.Triangles };
}

double GetMeanError(const std::vector<double>& values, const std::vector<double>& exact)
{
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t v = 0; v < exact.size(); ++v)
  {
    if (exact[v] > 0.0 && std::isfinite(exact[v]))
    {
      EXPECT_TRUE(std::isfinite(values[v])) << v;
      sum += std::abs(values[v] / exact[v] - 1.0);
      count += 1.0;
    }
  }
  EXPECT_GT(count, 0.0);
  return sum / count;
}

void Compare(const MeshArrays& mesh)
{
  ASSERT_GT(mesh.GetNumberOfFaces(), 0u);
  dgg::SurfaceMesh surface;
  ASSERT_TRUE(dgg::SurfaceMesh::FromPoints(mesh.Points.data(),
    static_cast<dgg::Offset>(mesh.GetNumberOfVertices()), mesh.Triangles.data(),
    static_cast<dgg::Offset>(mesh.GetNumberOfFaces()), surface)
                .IsOk());
  const auto n = static_cast<dgg::Id>(mesh.GetNumberOfVertices());
  for (const bool flips : { false, true })
  {
    SCOPED_TRACE(flips ? "intrinsic Delaunay" : "direct");
    PeerHeat peer(
      mesh, flips ? PeerHeat::Triangulation::IntrinsicDelaunay : PeerHeat::Triangulation::Direct);
    dgg::HeatMethod heat(surface);
    dgg::HeatOptions options;
    options.IntrinsicDelaunay = flips;
    ASSERT_TRUE(heat.Prepare(options, nullptr).IsOk());
    double ours = 0.0;
    double theirs = 0.0;
    for (const dgg::Id source : { n / 7, n / 3, n / 2, n - 2 })
    {
      const dgg::GeodesicSource place{ dgg::SurfacePoint::AtVertex(source), 0.0 };
      dgg::ExactResult exact;
      ASSERT_TRUE(dgg::ExactGeodesics(surface).Run({ place }, {}, exact).IsOk());
      dgg::HeatResult result;
      ASSERT_TRUE(heat.Run({ place }, {}, result).IsOk());
      peer.Run(source);
      ASSERT_EQ(peer.GetRefusal(), "");
      ours += GetMeanError(result.Distances, exact.Distances);
      theirs += GetMeanError(peer.GetDistances(), exact.Distances);
    }
    EXPECT_LE(ours, 1.1 * theirs);
    EXPECT_LT(ours / 4.0, 0.3);
  }
}

TEST(HeatAgainstCGAL, BumpySphere)
{
  Compare(BumpySphere(5));
}
TEST(HeatAgainstCGAL, RoughSphere)
{
  Compare(BumpySphere(4, 0.5));
}
TEST(HeatAgainstCGAL, Torus)
{
  Compare(Torus(60, 36));
}
TEST(HeatAgainstCGAL, LongTriangles)
{
  Compare(Torus(12, 90));
}
TEST(HeatAgainstCGAL, HillsWithHole)
{
  const auto keep = [](dgg::Id i, dgg::Id j) { return i < 13 || i >= 27 || j < 13 || j >= 27; };
  Compare(ToArrays(dggtest::WithNoise(dggtest::Plate(40, 40, keep, 0.2), 0.2, 7)));
}
TEST(HeatAgainstCGAL, JitteredBox)
{
  Compare(ToArrays(dggtest::Box(5, 9, 14, 0.2, 0.2, 0.2, 0.2)));
}

#ifdef DGG_EXTRA_DATA
class HeatAgainstCGALOnScans : public testing::TestWithParam<const char*>
{
};

TEST_P(HeatAgainstCGALOnScans, NotLessAccurate)
{
  Compare(ToArrays(ReadPolyData(std::string(DGG_EXTRA_DATA) + "/" + GetParam() + ".ply")));
}

INSTANTIATE_TEST_SUITE_P(Real, HeatAgainstCGALOnScans,
  testing::Values("eight", "fertility", "fandisk", "kitten", "rocker_arm", "armadillo"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });
#endif
}
