// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Sites that move to the center of their cells, with known centers and on any surface.
#include "GeodesicChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggCentroidal.h"
#include "dggSurfacePath.h"

namespace dggtest
{
namespace
{
using dgg::CentroidalOptions;
using dgg::SurfacePoint;
using Sites = std::vector<SurfacePoint>;

std::vector<double> Move(
  const SearchCase& c, Sites& sites, const CentroidalOptions& options, double accuracy)
{
  const dgg::GraphBuilder builder(c.GetMesh());
  std::vector<double> energies;
  const dgg::Status status =
    dgg::MoveToCenters(c.GetSearch(), c.GetMesh(), builder, accuracy, options, sites, energies);
  EXPECT_TRUE(status.IsOk()) << c.GetName() << ": " << status.GetMessage();
  return energies;
}

void ExpectDecrease(const std::vector<double>& energies, const std::string& what)
{
  EXPECT_FALSE(energies.empty()) << what;
  for (std::size_t i = 1; i < energies.size(); ++i)
  {
    EXPECT_LT(energies[i], energies[i - 1]) << what;
  }
}
}

TEST(Centroidal, ASingleSiteGoesToTheCentroid)
{
  // Each vertex is weighted by its area.
  for (double jitter : { 0.0, 0.25 })
  {
    const TestMesh points = Plane(14, 10, jitter, 3);
    const SearchCase c("plane", points, 0.01);
    std::array<double, 3> centroid{};
    double total = 0.0;
    for (Id f = 0; f < points.GetNumberOfFaces(); ++f)
    {
      const double area = FaceArea(points, f);
      total += area;
      for (int k = 0; k < 9; ++k)
      {
        centroid[k % 3] += area / 3.0 * points.Point(points.Triangles[3 * f + k / 3])[k % 3];
      }
    }
    Sites starts = RandomSurfacePoints(c.GetMesh(), 6, 11);
    starts.push_back(SurfacePoint::AtVertex(40));
    starts.push_back(SurfacePoint::AtVertex(0));
    for (const SurfacePoint& start : starts)
    {
      CentroidalOptions options;
      options.NumberOfIterations = 1;
      Sites sites{ start };
      const std::vector<double> energies = Move(c, sites, options, 0.01);
      ASSERT_EQ(energies.size(), 2u);
      ExpectDecrease(energies, "plane");
      const auto p = dgg::PositionOf(c.GetMesh(), sites[0], points.Points.data());
      const double size = points.Point(points.GetNumberOfVertices() - 1)[0];
      EXPECT_NEAR(p[0], centroid[0] / total, 0.005 * size);
      EXPECT_NEAR(p[1], centroid[1] / total, 0.005 * size);
    }
  }
}

/// The site starts at a reflex corner of the boundary.
TEST(Centroidal, LeavesReflexCorners)
{
  const TestMesh plate = Plate(18, 9, [](Id i, Id j) { return i < 6 || j < 5; });
  const SearchCase c("L", plate, 0.05);
  Id corner = dgg::NoId;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    if (c.GetMesh().Kind(v) == dgg::VertexKind::Boundary &&
      c.GetMesh().TotalAngle(v) > 1.2 * dgg::Pi)
    {
      corner = v;
    }
  }
  ASSERT_NE(corner, dgg::NoId);
  CentroidalOptions options;
  options.NumberOfIterations = 10;
  Sites sites{ SurfacePoint::AtVertex(corner) };
  const std::vector<double> energies = Move(c, sites, options, 0.05);
  ASSERT_GT(energies.size(), 1u);
  EXPECT_LT(energies.back(), 0.999 * energies.front());
}

TEST(Centroidal, EnergyIsThatOfTheDistances)
{
  const TestMesh points = Plane(8, 8, 0.2, 3);
  const SearchCase c("plane", points, 0.01);
  CentroidalOptions options;
  options.NumberOfIterations = 0;
  Sites sites{ SurfacePoint::AtVertex(10), SurfacePoint::AtVertex(60) };
  const std::vector<double> energies = Move(c, sites, options, 0.01);
  double expected = 0.0;
  for (Id f = 0; f < points.GetNumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id v = points.Triangles[3 * f + k];
      const double d = std::min(EuclideanDistance(points, v, 10), EuclideanDistance(points, v, 60));
      expected += FaceArea(points, f) / 3.0 * d * d;
    }
  }
  ASSERT_EQ(energies.size(), 1u);
  EXPECT_NEAR(energies[0], expected, 0.002 * expected);
  EXPECT_EQ(sites[0].Vertex, 10);
  EXPECT_EQ(sites[1].Vertex, 60);
}

TEST(Centroidal, EnergyDecreasesOnAnySurface)
{
  const std::vector<NamedMesh> meshes = AllMeshes(); // sound meshes first
  const std::size_t numberOfSound = SoundMeshes().size();
  std::size_t moved = 0;
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    const SearchCase c(meshes[m].Name, meshes[m].Mesh, 0.05);
    Sites sites = RandomSurfacePoints(c.GetMesh(), 4, 3);
    for (const Id v : SomeVertices(c.GetMesh(), 4, 5))
    {
      sites.push_back(SurfacePoint::AtVertex(v));
    }
    CentroidalOptions options;
    options.NumberOfIterations = 5;
    const std::vector<double> energies = Move(c, sites, options, 0.05);
    ExpectDecrease(energies, meshes[m].Name);
    moved += m < numberOfSound && energies.back() < 0.97 * energies.front() ? 1 : 0;
    for (const SurfacePoint& site : sites)
    {
      EXPECT_TRUE(site.Check(c.GetMesh()).IsOk()) << meshes[m].Name;
    }
  }
  EXPECT_GE(moved, numberOfSound - 3);
}

TEST(Centroidal, AtAnyScale)
{
  // Energies scale with the fourth power of lengths.
  const TestMesh points = PrismSide(8, 3, 12, 0.2);
  const SearchCase c("prism", points, 0.01);
  const Sites starts = RandomSurfacePoints(c.GetMesh(), 5, 3);
  Sites sites = starts;
  const std::vector<double> energies = Move(c, sites, {}, 0.01);
  ASSERT_GT(energies.size(), 3u);
  for (const int power : { -220, -170, 170, 220 })
  {
    const TestMesh scaled = Scaled(points, std::ldexp(1.0, power));
    const SearchCase other("prism of another scale", scaled, 0.01);
    Sites moved = starts;
    const std::vector<double> scaledEnergies = Move(other, moved, {}, 0.01);
    ASSERT_GT(scaledEnergies.size(), 3u) << power;
    ExpectDecrease(scaledEnergies, std::to_string(power));
    // Graphs at other scales may have other edges where paths are tied.
    EXPECT_NEAR(std::ldexp(scaledEnergies[0], -4 * power), energies[0], 0.02 * energies[0]);
    EXPECT_NEAR(
      std::ldexp(scaledEnergies.back(), -4 * power), energies.back(), 0.05 * energies.back());
  }
}

TEST(Centroidal, StopsAtTheTolerance)
{
  const SearchCase c("plane", Plane(10, 10, 0.2, 3), 0.02);
  CentroidalOptions options;
  options.NumberOfIterations = 50;
  options.Tolerance = 1e6;
  Sites sites{ SurfacePoint::AtVertex(0) };
  EXPECT_EQ(Move(c, sites, options, 0.02).size(), 1u);
  EXPECT_EQ(sites[0].Vertex, 0);
  options.Tolerance = 0.05;
  const std::size_t some = Move(c, sites, options, 0.02).size();
  EXPECT_GT(some, 1u);
  EXPECT_LT(some, 20u);
}

TEST(Centroidal, DuplicatesPart)
{
  // Only the first of the duplicate sites has a cell and moves; after that the other one has a cell
  // too.
  const SearchCase c("sphere", Icosphere(2), 0.05);
  Sites sites{ SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(90) };
  const std::vector<double> energies = Move(c, sites, CentroidalOptions(), 0.05);
  ExpectDecrease(energies, "sphere");
  EXPECT_LT(energies.back(), 0.8 * energies.front());
}

}
