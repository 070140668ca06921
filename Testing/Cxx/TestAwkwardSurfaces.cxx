// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces with defects: the filters return distances and report the defects.
#include "FilterTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include <random>

using namespace dggtest;

namespace
{
vtkSmartPointer<vtkExactGeodesicDistance> MakeExact(vtkPolyData* surface, vtkIdType source)
{
  auto filter = vtkSmartPointer<vtkExactGeodesicDistance>::New();
  filter->SetInputData(surface);
  filter->AddSourceId(source);
  return filter;
}

/// Returns a grid of 6 x 6 squares in which every triangle has three separate points, as in an STL
/// file. Points are moved at random by up to `jitter` along each axis.
vtkSmartPointer<vtkPolyData> MakeSoup(double jitter)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  auto grid = MakeGrid(6, 6);
  Points points;
  Cells cells;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    vtkIdType n;
    const vtkIdType* ids;
    grid->GetPolys()->GetCellAtId(i, n, ids);
    cells.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    for (int k = 0; k < 3; ++k)
    {
      double p[3];
      grid->GetPoint(ids[k], p);
      points.push_back({ { p[0] + move(random), p[1] + move(random), p[2] + move(random) } });
    }
  }
  return MakeSurface(points, cells);
}

/// Returns two grids side by side with a seam at x = 2: points on the seam are duplicated.
vtkSmartPointer<vtkPolyData> MakeSeam()
{
  auto left = MakeGrid(2, 3);
  Points points;
  Cells cells;
  for (int side = 0; side < 2; ++side)
  {
    for (vtkIdType i = 0; i < left->GetNumberOfPoints(); ++i)
    {
      double p[3];
      left->GetPoint(i, p);
      points.push_back({ { p[0] + 2.0 * side, p[1], p[2] } });
    }
    const vtkIdType first = side * left->GetNumberOfPoints();
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        const vtkIdType a = first + 3 * j + i;
        cells.push_back({ a, a + 1, a + 4, a + 3 });
      }
    }
  }
  return MakeSurface(points, cells);
}
}

TEST(AwkwardSurfaces, NonManifoldEdgeConducts)
{
  // A plate with a fin on its middle line.
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 1, 0 } },
                               { { 1, 1, 0 } }, { { 2, 1, 0 } }, { { 1, 0, 1 } }, { { 1, 1, 1 } } },
    { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 1, 4, 7, 6 } });
  const auto filter = MakeExact(surface, 0);
  ExpectWarning(filter, { "1 edge with more than two triangles" });
  EXPECT_EQ(GetReported(filter, "NumberOfNonManifoldEdges"), 1);
  EXPECT_EQ(GetReported(filter, "Genus"), -1);
  EXPECT_NE(filter->GetMeshReport().find("genus: undefined\n"), std::string::npos);
  const auto distances = GetDistances(filter);
  EXPECT_NEAR(distances[5], std::sqrt(5.0), 1e-12); // straight across
  EXPECT_NEAR(distances[7], std::sqrt(5.0), 1e-12); // across the fin
  EXPECT_NEAR(distances[6], 2.0, 1e-12);

  // The warning belongs to the mesh, not to the update.
  filter->SetSourceIds(std::vector<vtkIdType>{ 2 });
  ExpectSuccess(filter);
  EXPECT_NEAR(GetDistances(filter)[7], std::sqrt(5.0), 1e-12);
}

TEST(AwkwardSurfaces, DuplicateTriangles)
{
  auto surface = MakeGrid(3, 3);
  vtkIdType n;
  const vtkIdType* ids;
  surface->GetPolys()->GetCellAtId(4, n, ids);
  const vtkIdType copy[3] = { ids[0], ids[1], ids[2] };
  surface->GetPolys()->InsertNextCell(3, copy);
  const auto filter = MakeExact(surface, 0);
  ExpectWarning(filter, { "1 triangle on the same three points as an earlier one" });
  EXPECT_EQ(GetReported(filter, "NumberOfDuplicateFaces"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfNonManifoldEdges"), 0);
  ExpectEuclidean(filter, surface);
}

// Closed surfaces that touch at one point have no boundary there, even if each triangle is
// duplicated.
TEST(AwkwardSurfaces, DuplicatesHaveNoBoundary)
{
  Points points;
  Cells cells;
  for (const double sign : { 1.0, -1.0 })
  {
    const auto first = static_cast<vtkIdType>(points.size());
    points.push_back({ { 0.0, 0.0, 0.0 } });
    points.push_back({ { sign, 0.0, 0.0 } });
    points.push_back({ { 0.0, sign, 0.0 } });
    points.push_back({ { 0.0, 0.0, sign } });
    for (int copy = 0; copy < 2; ++copy)
    {
      cells.push_back({ first, first + 1, first + 2 });
      cells.push_back({ first, first + 2, first + 3 });
      cells.push_back({ first, first + 3, first + 1 });
      cells.push_back({ first + 1, first + 3, first + 2 });
    }
  }
  const auto filter = MakeExact(MakeSurface(points, cells), 0);
  ExpectWarning(filter, { "8 triangles on the same three points as an earlier one" });
  EXPECT_EQ(GetReported(filter, "NumberOfCoincidentBoundaryPoints"), 0);
  EXPECT_EQ(GetReported(filter, "NumberOfBoundaryEdges"), 0);
}

TEST(AwkwardSurfaces, PolygonsWithFewerThanThreePointsAreDropped)
{
  auto surface = MakeGrid(3, 3);
  for (const std::vector<vtkIdType>& cell : { std::vector<vtkIdType>{ 0, 0, 5 }, { 7, 7, 7 },
         { 1, 2 }, { 4 }, {}, { 0, 15, 0, 15 }, { 0, 15, 0, 1 } })
  {
    surface->GetPolys()->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  const auto filter = MakeExact(surface, 0);
  ExpectWarning(filter, { "7 polygons with fewer than three distinct points" });
  EXPECT_EQ(GetReported(filter, "NumberOfDroppedFaces"), 7);
  EXPECT_EQ(GetReported(filter, "NumberOfTriangles"), 18);
  ExpectEuclidean(filter, surface);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 25); // all cells are passed through
}

TEST(AwkwardSurfaces, SeamsAreCountedAndMerged)
{
  auto surface = MakeSeam();
  const auto filter = MakeExact(surface, 0);
  filter->GenerateNearestSourceOn();
  ExpectWarning(filter, { "8 points of the boundary", "MergeCoincidentPoints" });
  EXPECT_EQ(GetReported(filter, "NumberOfCoincidentPoints"), 4);
  EXPECT_EQ(GetReported(filter, "NumberOfCoincidentBoundaryPoints"), 8);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 2);
  EXPECT_TRUE(std::isnan(GetDistances(filter)[23]));

  filter->MergeCoincidentPointsOn();
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfIsolatedPoints"), 0);
  EXPECT_NE(filter->GetMeshReport().find("merged points: 4\n"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetPoints(), surface->GetPoints());
  EXPECT_EQ(filter->GetOutput()->GetPolys(), surface->GetPolys());
  ExpectEuclidean(filter, surface);
  EXPECT_EQ(GetNearestSources(filter), std::vector<int>(24, 0));

  // Point 12 is a copy of point 2 and acts as the same source, by id and by position.
  filter->SetSourceIds(std::vector<vtkIdType>{ 12 });
  ExpectSuccess(filter);
  ExpectEuclidean(filter, surface);
  const auto byId = GetDistances(filter);
  filter->RemoveAllSourceIds();
  filter->SetSourceData(MakeSourcePoints({ { { 2.0, 0.0, 0.0 } } }));
  ExpectSuccess(filter);
  EXPECT_EQ(GetDistances(filter), byId);

  filter->MergeCoincidentPointsOff();
  filter->SetSourceData(nullptr);
  filter->AddSourceId(0);
  ExpectWarning(filter, { "8 points of the boundary" });
  EXPECT_TRUE(std::isnan(GetDistances(filter)[23]));
}

TEST(AwkwardSurfaces, ZerosOfBothSignsCoincide)
{
  auto surface = MakeSurface({ { { 0.0, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0, 0 } },
                               { { -0.0, 0, 0 } }, { { 0, 1, -0.0 } }, { { 1, 0, 0 } } },
    { { 0, 1, 2 }, { 3, 5, 4 } });
  const auto filter = MakeExact(surface, 2);
  filter->MergeCoincidentPointsOn();
  ExpectSuccess(filter);
  EXPECT_NEAR(GetDistances(filter)[5], 2.0, 1e-12);
}

/// Nearly coincident points split the surface into pieces. The filter reports them.
TEST(AwkwardSurfaces, GapsAreReportedAndMerged)
{
  auto soup = MakeSoup(1e-7);
  const auto expectReport = [&soup](vtkGeodesicDistanceAlgorithm* filter) {
    filter->SetInputData(soup);
    filter->AddSourceId(100);
    const std::string count = "only 3 of " + std::to_string(soup->GetNumberOfPoints()) + " points";
    ExpectWarning(
      filter, { count, "Turn on MergeCoincidentPoints with a MergeTolerance of 1e-06" });
    EXPECT_TRUE(std::isnan(GetDistances(filter)[0]));
  };
  expectReport(vtkNew<vtkDGGDistance>());
  expectReport(vtkNew<vtkDGGFastMarchingDistance>());
  expectReport(vtkNew<vtkVirtualSourceGeodesicDistance>());
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetMaximumDistance(1.0);
  expectReport(filter);
  filter->SetMaximumDistance(VTK_DOUBLE_MAX);
  ExpectSuccess(filter); // warned once for each mesh
  filter->MergeCoincidentPointsOn();
  ExpectWarning(filter, { "only 3 of", "raise MergeTolerance to 1e-06" });
  filter->SetMergeTolerance(1e-6);
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfBoundaryLoops"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfIsolatedPoints"), 0);
  ExpectEuclidean(filter, soup, 1e-5);
  const vtkMTimeType built = filter->GetMeshBuildTime();
  filter->SetMergeTolerance(1e-5);
  ExpectSuccess(filter);
  EXPECT_NE(filter->GetMeshBuildTime(), built);
  filter->SetMergeTolerance(-1.0);
  ExpectError(filter, { "MergeTolerance" });
  filter->SetMergeTolerance(2.0);
  ExpectError(filter, { "a MergeTolerance of 2 merged", "a smaller MergeTolerance" });
  filter->SetMergeTolerance(1e-5);
  filter->SetMemoryLimit(-1);
  ExpectError(filter, { "MemoryLimit is -1" });
}

/// A point is merged into the closest earlier point that is kept, so that no point moves by more
/// than the tolerance.
TEST(AwkwardSurfaces, ChainsOfClosePoints)
{
  Points points;
  Cells cells;
  for (int i = 0; i < 4; ++i)
  {
    points.push_back({ { 0.06 * i, 0.0, 0.0 } });
    points.push_back({ { 3.0, 1.0 + i, 0.0 } });
    points.push_back({ { 2.0, 4.0, 1.0 * i } });
    cells.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  auto surface = MakeSurface(points, cells);
  const auto filter = MakeExact(surface, 0);
  filter->MergeCoincidentPointsOn();
  filter->SetMergeTolerance(0.1 / std::sqrt(9.0 + 16.0 + 9.0));
  ExpectWarning(filter, { "2 points where separate layers touch" });
  EXPECT_NE(filter->GetMeshReport().find("merged points: 2\n"), std::string::npos);
  const auto distances = GetDistances(filter);
  EXPECT_EQ(distances[3], 0.0);
  EXPECT_TRUE(std::isnan(distances[6])); // far from point 0, into which point 3 was merged
  EXPECT_TRUE(std::isnan(distances[9])); // merged into point 6
}

TEST(AwkwardSurfaces, IsolatedPoints)
{
  auto surface = MakeGrid(2, 2);
  surface->GetPoints()->InsertNextPoint(1.0, 1.0, 0.5);
  surface->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  surface->SetVerts(MakeCells({ { 9 } }));
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->GenerateNearestSourceOn();
  filter->AddSourceId(0);
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfIsolatedPoints"), 2);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 1);
  EXPECT_TRUE(std::isnan(GetDistances(filter)[9]));
  EXPECT_EQ(GetNearestSources(filter)[9], -1);

  // This source point reaches only itself.
  filter->SetSourceIds(std::vector<vtkIdType>{ 9 });
  ExpectWarning(filter, { "source id 9 is a point that no polygon uses" });
  const auto distances = GetDistances(filter);
  for (vtkIdType i = 0; i < 11; ++i)
  {
    EXPECT_EQ(std::isnan(distances[i]), i != 9) << i;
  }
  EXPECT_EQ(distances[9], 0.0);
  EXPECT_EQ(GetNearestSources(filter)[9], 0);

  // Another source is not affected.
  filter->SetSourceIds(std::vector<vtkIdType>{ 10, 4 });
  ExpectWarning(filter, { "source id 10 is a point" });
  EXPECT_NEAR(GetDistances(filter)[0], std::sqrt(2.0), 1e-12);
  EXPECT_EQ(GetNearestSources(filter)[0], 1);
}

/// Grid with 0.5 m spacing in UTM coordinates, where single-precision values are 0.5 m apart.
TEST(AwkwardSurfaces, SinglePrecisionFarFromTheOrigin)
{
  struct Case
  {
    int Type;
    double X;
    double Y;
    bool IsCoarse;
  };
  for (const Case& tested : { Case{ VTK_FLOAT, 512345.678, 5403210.987, true },
         Case{ VTK_DOUBLE, 512345.678, 5403210.987, false }, Case{ VTK_FLOAT, 0.0, 0.0, false },
         Case{ VTK_FLOAT, 0.0, 300.0, false }, Case{ VTK_FLOAT, 0.0, 1000.0, true } })
  {
    SCOPED_TRACE(tested.Y);
    auto grid = MakeGrid(60, 60, GridCells::Triangles, 0.5);
    vtkNew<vtkPoints> points;
    points->SetDataType(tested.Type);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      points->InsertNextPoint(p[0] + tested.X, p[1] + tested.Y, p[2]);
    }
    grid->SetPoints(points);
    vtkNew<vtkExactGeodesicDistance> filter;
    filter->SetInputData(grid);
    filter->AddSourceId(0);
    if (tested.IsCoarse)
    {
      ExpectWarning(filter,
        { "single precision", tested.Y > 1e6 ? "are 0.5 apart" : "are 0.00012207 apart",
          "mean edge length 0.", "vtkDGGPLYReader", "vtkdgg.read" });
      filter->AddSourceId(7); // warned once for each mesh
    }
    ExpectSuccess(filter);
  }
}
