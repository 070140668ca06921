// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells that are not triangles: quads, polygons, strips; verts and lines that are not used.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
class CellKinds : public ::testing::Test
{
protected:
  std::vector<double> Solve(vtkPolyData* surface, vtkIdType source)
  {
    this->Filter->SetInputData(surface);
    this->Filter->SetSourceIds({ source });
    ExpectSuccess(this->Filter);
    return GetDistances(this->Filter);
  }

  void ExpectEuclidean(vtkPolyData* plate, vtkIdType source)
  {
    this->Solve(plate, source);
    dggtest::ExpectEuclidean(this->Filter, plate);
  }

  vtkNew<vtkExactGeodesicDistance> Filter;
};
}

TEST_F(CellKinds, Quads)
{
  auto grid = MakeGrid(6, 5, GridCells::Quads);
  this->ExpectEuclidean(grid, 8);
}

TEST_F(CellKinds, Strips)
{
  auto grid = MakeGrid(6, 5, GridCells::Strips);
  ASSERT_EQ(grid->GetNumberOfPolys(), 0);
  this->ExpectEuclidean(grid, 8);
}

TEST_F(CellKinds, StripsThatRepeatPoints)
{
  // Two rows joined into one strip by repeated points.
  auto grid = MakeGrid(2, 2, GridCells::Strips);
  grid->SetStrips(MakeCells({ { 3, 0, 4, 1, 5, 2, 2, 6, 6, 3, 7, 4, 8, 5 } }));
  const auto distances = this->Solve(grid, 0);
  EXPECT_EQ(GetReported(this->Filter, "NumberOfTriangles"), 8);
  EXPECT_EQ(GetReported(this->Filter, "NumberOfDroppedFaces"), 0);
  EXPECT_NEAR(distances[8], std::sqrt(8.0), 1e-12);
}

TEST_F(CellKinds, MixedKindsAndIdsOfCells)
{
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } },
                               { { 2, 0, 0 } }, { { 2, 1, 0 } }, { { 3, 0.5, 0 } } },
    { { 0, 1, 2, 3 }, { 4, 6, 5 } });
  surface->SetVerts(MakeCells({ { 0 }, { 3 } }));
  surface->SetLines(MakeCells({ { 0, 6 } })); // a shortcut that must not be used
  surface->SetStrips(MakeCells({ { 1, 2, 4, 5 } }));
  this->ExpectEuclidean(surface, 0);
  EXPECT_EQ(GetReported(this->Filter, "NumberOfTriangles"), 5);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), surface->GetNumberOfCells());
}

TEST_F(CellKinds, LinesDoNotConduct)
{
  auto surface = MakeSurface(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 3, 0, 0 } } }, { { 0, 1, 2 } });
  surface->SetLines(MakeCells({ { 1, 3 } }));
  const auto distances = this->Solve(surface, 0);
  EXPECT_TRUE(std::isnan(distances[3]));
  EXPECT_EQ(GetReported(this->Filter, "NumberOfIsolatedPoints"), 1);
}

TEST_F(CellKinds, ConvexPolygon)
{
  Points points;
  std::vector<vtkIdType> polygon;
  for (int i = 0; i < 11; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / 11.0;
    points.push_back({ { 3.0 * std::cos(angle), 2.0 * std::sin(angle), 1.0 } });
    polygon.push_back(i);
  }
  this->ExpectEuclidean(MakeSurface(points, { polygon }), 4);
}

TEST_F(CellKinds, PolygonWithPointsOnItsEdges)
{
  this->ExpectEuclidean(
    MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 2, 1, 0 } },
                  { { 2, 2, 0 } }, { { 1, 2, 0 } }, { { 0, 2, 0 } } },
      { { 0, 1, 2, 3, 4, 5, 6 } }),
    0);
}

TEST_F(CellKinds, NonConvexPolygon)
{
  // An L-shaped polygon: the path turns around the inner corner. A fan around the first point would
  // give 2 sqrt 2.
  auto surface = MakeSurface({ { { 2, 0, 0 } }, { { 2, 1, 0 } }, { { 1, 1, 0 } }, { { 1, 2, 0 } },
                               { { 0, 2, 0 } }, { { 0, 0, 0 } } },
    { { 0, 1, 2, 3, 4, 5 } });
  const auto distances = this->Solve(surface, 1);
  EXPECT_NEAR(distances[3], 2.0, 1e-12);
  EXPECT_NEAR(distances[4], 1.0 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(distances[5], std::sqrt(5.0), 1e-12);
}

TEST_F(CellKinds, PolygonWithAHole)
{
  // A square around a square hole, as one polygon with a bridge from corner 3 to corner 4 and back.
  auto surface = MakeSurface({ { { 3, 0, 0 } }, { { 3, 3, 0 } }, { { 0, 3, 0 } }, { { 0, 0, 0 } },
                               { { 1, 1, 0 } }, { { 1, 2, 0 } }, { { 2, 2, 0 } }, { { 2, 1, 0 } } },
    { { 0, 1, 2, 3, 4, 5, 6, 7, 4, 3 } });
  const auto distances = this->Solve(surface, 3);
  EXPECT_NEAR(distances[6], 1.0 + std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(distances[1], 2.0 * std::sqrt(5.0), 1e-12);
}

TEST_F(CellKinds, PolygonWithRepeatedPositions)
{
  // An L-shaped polygon whose corner 1 is duplicated, exactly or nearly, and with a spike at corner
  // 3.
  for (const double gap : { 0.0, 1e-12 })
  {
    auto surface = MakeSurface(
      { { { 2, 0, 0 } }, { { 2, 1, 0 } }, { { 1, 1, 0 } }, { { 1, 2, 0 } }, { { 0, 2, 0 } },
        { { 0, 0, 0 } }, { { 2, 1 - gap, 0 } }, { { 1, 3, 0 } }, { { 1, 2, 0 } } },
      { { 0, 1, 6, 2, 3, 7, 8, 4, 5 } });
    this->Filter->SetInputData(surface);
    this->Filter->SetSourceIds({ 0 });
    const Listener listener(this->Filter); // may warn about the spike
    this->Filter->Update();
    const auto distances = GetDistances(this->Filter);
    EXPECT_NEAR(distances[3], 1.0 + std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(distances[4], std::sqrt(8.0), 1e-9);
    EXPECT_NEAR(distances[6], 1.0, 1e-9);
    EXPECT_NEAR(distances[7], 2.0 + std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(distances[8], distances[3], 1e-9);
  }
}

TEST_F(CellKinds, NonConvexQuad)
{
  // An arrowhead; only the diagonal from the notch (point 2) lies inside. For any first point of
  // the cell, the path from tip to tip turns around the notch.
  const std::vector<vtkIdType> quad = { 0, 1, 2, 3 };
  for (int shift = 0; shift < 4; ++shift)
  {
    std::vector<vtkIdType> turned;
    for (int i = 0; i < 4; ++i)
    {
      turned.push_back(quad[(i + shift) % 4]);
    }
    auto surface = MakeSurface(
      { { { 0, 3, 0 } }, { { -2, 0, 0 } }, { { 0, 1, 0 } }, { { 2, 0, 0 } } }, { turned });
    const auto distances = this->Solve(surface, 1);
    EXPECT_NEAR(distances[3], 2.0 * std::sqrt(5.0), 1e-12);
    EXPECT_NEAR(distances[0], std::sqrt(13.0), 1e-12);
  }
}

TEST_F(CellKinds, WarpedQuadIsCutAlongTheShorterDiagonal)
{
  // Diagonal 0-2 is longer than 1-3, so the surface has the ridge 1-3.
  auto surface =
    MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0.5 } }, { { 1.2, 1.2, 0 } }, { { 0, 1, 0.5 } } },
      { { 0, 1, 2, 3 } });
  EXPECT_NEAR(this->Solve(surface, 1)[3], std::sqrt(2.0), 1e-12);
  // The path crosses the middle of the ridge, by symmetry.
  const double expected = std::sqrt(0.25 + 0.25 + 0.25) + std::sqrt(0.49 + 0.49 + 0.25);
  EXPECT_NEAR(this->Solve(surface, 0)[2], expected, 1e-12);
}

TEST_F(CellKinds, PolygonsThatCrossThemselves)
{
  // No triangulation is correct; nevertheless all points are reached.
  const Points points = { { 0, 0, 0 }, { 4, 3, 0 }, { 4, 0, 0 }, { 0, 3, 0 }, { 2, 5, 0 } };
  for (const std::vector<vtkIdType>& polygon :
    { std::vector<vtkIdType>{ 0, 1, 2, 3, 4 }, { 0, 1, 2, 3 }, { 4, 2, 1, 0 } })
  {
    this->Filter->SetInputData(MakeSurface(points, { polygon }));
    this->Filter->SetSourceIds({ 0 });
    ExpectWarning(this->Filter, { "1 self-intersecting or self-touching polygon." });
    const std::vector<double> distances = GetDistances(this->Filter);
    for (const vtkIdType id : polygon)
    {
      EXPECT_TRUE(std::isfinite(distances[id]));
    }
  }
  // A quad on four edges of a tetrahedron is folded sharply, but does not cross itself.
  this->Solve(
    MakeSurface({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } }, { { 0, 1, 2, 3 } }),
    0);
}

TEST_F(CellKinds, QuadWithASpikeIsCutThere)
{
  // The first edge and the last one overlap from (0, 0) to (1, 0).
  this->Filter->SetInputData(
    MakeSurface({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 } }, { { 0, 1, 2, 3 } }));
  this->Filter->SetSourceIds({ 2 });
  ExpectWarning(this->Filter, { "1 triangle without area" });
  EXPECT_NEAR(GetDistances(this->Filter)[0], 2.0, 1e-12);
}

TEST_F(CellKinds, PolygonsAtExtremeScales)
{
  for (const double unit : { 1e-38, 1e-6, 1e6, 1e38 })
  {
    auto surface =
      MakeSurface({ { { 2 * unit, 0, 0 } }, { { 2 * unit, unit, 0 } }, { { unit, unit, 0 } },
                    { { unit, 2 * unit, 0 } }, { { 0, 2 * unit, 0 } }, { { 0, 0, 0 } } },
        { { 0, 1, 2, 3, 4, 5 } });
    const auto distances = this->Solve(surface, 1);
    EXPECT_NEAR(distances[3] / unit, 2.0, 1e-12) << unit;
  }
}
