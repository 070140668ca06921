// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact distances through the filter: closed forms and invariants. The kernel has tests of its
/// own; these show that nothing is lost on the way through VTK.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace dggtest;

namespace
{
std::vector<double> Distances(
  vtkPolyData* surface, vtkIdType source, int engine = vtkExactGeodesicDistance::Triangle)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->AddSourceId(source);
  filter->SetEngine(engine);
  ExpectSuccess(filter);
  return GetDistances(filter);
}
}

TEST(ExactGeodesicDistance, TakesIdsInBraces)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetSourceIds({ 0 }); // not a null list
  ASSERT_EQ(filter->GetNumberOfSourceIds(), 1);
  EXPECT_EQ(filter->GetSourceId(0), 0);
  filter->SetSourceIds({ 3, 5 });
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 2);
}

TEST(ExactGeodesicDistance, EngineProperty)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  EXPECT_EQ(filter->GetEngine(), vtkExactGeodesicDistance::Triangle);
  filter->SetEngineToReference();
  EXPECT_EQ(filter->GetEngine(), vtkExactGeodesicDistance::Reference);
  filter->SetEngineToTriangle();
  EXPECT_EQ(filter->GetEngine(), vtkExactGeodesicDistance::Triangle);
  filter->SetEngine(77);
  EXPECT_EQ(filter->GetEngine(), vtkExactGeodesicDistance::Triangle);
  filter->SetEngine(-1);
  EXPECT_EQ(filter->GetEngine(), vtkExactGeodesicDistance::Reference);
}

TEST(ExactGeodesicDistance, MemoryLimitOfWindows)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  EXPECT_EQ(filter->GetMemoryLimit(), 0u);
  filter->SetInputData(MakeGrid(30, 30));
  filter->AddSourceId(0);
  filter->SetMemoryLimit(20000);
  ExpectSuccess(filter); // no windows
  filter->GenerateWindowsOn();
  ExpectError(filter, { "MemoryLimit, 20000 bytes", "MaximumDistance", "GenerateWindows off" });
  filter->SetMemoryLimit(0);
  ExpectSuccess(filter);
  EXPECT_TRUE(filter->GetOutput()->GetFieldData()->HasArray("GeodesicDistance.Windows"));
  filter->SetMemoryLimit(7);
  std::ostringstream os;
  filter->Print(os);
  EXPECT_NE(os.str().find("MemoryLimit: 7\n"), std::string::npos);
}

TEST(ExactGeodesicDistance, Cube)
{
  for (const int engine :
    { vtkExactGeodesicDistance::Reference, vtkExactGeodesicDistance::Triangle })
  {
    const auto distances = Distances(MakeCube(), 0, engine);
    const double expected[8] = { 0.0, 1.0, 1.0, std::sqrt(2.0), 1.0, std::sqrt(2.0), std::sqrt(2.0),
      std::sqrt(5.0) };
    for (int i = 0; i < 8; ++i)
    {
      EXPECT_NEAR(distances[i], expected[i], 1e-12) << i;
    }
  }
}

TEST(ExactGeodesicDistance, PointsInTheMiddleOfFacesAndEdges)
{
  // From (0,0,0) to (1,1,1/2) on the unit cube: the point is added to the edge.
  auto cube = MakeCube();
  const vtkIdType middle = cube->GetPoints()->InsertNextPoint(1.0, 1.0, 0.5);
  cube->SetPolys(MakeCells({ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 0, 4, 6, 2 },
    { 2, 6, 7, middle, 3 }, { 1, 3, middle, 7, 5 } }));
  EXPECT_NEAR(Distances(cube, 0)[middle], std::sqrt(13.0) / 2.0, 1e-12);
}

TEST(ExactGeodesicDistance, Cylinder)
{
  // The side of a prism unrolls to a strip.
  const int sides = 9;
  const int rows = 6;
  Points points;
  Cells cells;
  const double pi = 3.14159265358979323846;
  const double width = 2.0 * std::sin(pi / sides);
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i < sides; ++i)
    {
      points.push_back(
        { { std::cos(2.0 * pi * i / sides), std::sin(2.0 * pi * i / sides), 0.7 * j } });
      if (j > 0)
      {
        const vtkIdType a = (j - 1) * sides;
        cells.push_back({ a + i, a + (i + 1) % sides, a + sides + (i + 1) % sides, a + sides + i });
      }
    }
  }
  const auto distances = Distances(MakeSurface(points, cells), 0);
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i < sides; ++i)
    {
      const double around = width * std::min(i, sides - i);
      EXPECT_NEAR(distances[j * sides + i], std::hypot(around, 0.7 * j), 1e-12);
    }
  }
}

TEST(ExactGeodesicDistance, SaddleCone)
{
  // Eight right angles around a point: farther than pi apart, the way leads through the apex.
  Points points = { { { 0, 0, 0 } } };
  Cells cells;
  const double pi = 3.14159265358979323846;
  for (int i = 0; i < 8; ++i)
  {
    // Alternately up and down so that neighbours are at right angles seen from the apex.
    const double angle = 2.0 * pi * i / 8.0;
    const double c =
      std::cos(angle) * std::cos(angle + pi / 4.0) + std::sin(angle) * std::sin(angle + pi / 4.0);
    const double rise = (i % 2 ? 1.0 : -1.0) * std::sqrt(c);
    const double length = std::sqrt(1.0 + c);
    points.push_back({ { std::cos(angle) / length, std::sin(angle) / length, rise / length } });
    cells.push_back({ 0, 1 + i, 1 + (i + 1) % 8 });
  }
  const auto distances = Distances(MakeSurface(points, cells), 1);
  EXPECT_NEAR(distances[0], 1.0, 1e-12);
  for (int i = 0; i < 8; ++i)
  {
    const double turn = pi / 2.0 * std::min(i, 8 - i);
    const double expected = turn < pi ? 2.0 * std::sin(0.5 * turn) : 2.0;
    EXPECT_NEAR(distances[1 + i], expected, 1e-12) << i;
  }
}

TEST(ExactGeodesicDistance, EnginesAgree)
{
  auto terrain = MakeTerrain(30);
  const auto triangle = Distances(terrain, 31, vtkExactGeodesicDistance::Triangle);
  const auto reference = Distances(terrain, 31, vtkExactGeodesicDistance::Reference);
  ASSERT_EQ(triangle.size(), 900u);
  for (std::size_t i = 0; i < triangle.size(); ++i)
  {
    EXPECT_NEAR(triangle[i], reference[i], 1e-10);
    EXPECT_GE(triangle[i], EuclideanDistance(terrain, 31, static_cast<vtkIdType>(i)) - 1e-12);
  }
}

TEST(ExactGeodesicDistance, Symmetric)
{
  auto terrain = MakeTerrain(14);
  const auto fromFirst = Distances(terrain, 3);
  for (const vtkIdType other : { 20, 77, 130, 195 })
  {
    EXPECT_NEAR(Distances(terrain, other)[3], fromFirst[other], 1e-11);
  }
}

TEST(ExactGeodesicDistance, SeveralSourcesAreThePointwiseMinimum)
{
  auto terrain = MakeTerrain(16);
  const std::vector<vtkIdType> sources = { 5, 120, 250 };
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(terrain);
  filter->SetSourceIds(sources);
  filter->GenerateNearestSourceOn();
  ExpectSuccess(filter);
  const auto together = GetDistances(filter);
  const auto nearest = GetNearestSources(filter);
  std::vector<std::vector<double>> alone;
  for (const vtkIdType source : sources)
  {
    alone.push_back(Distances(terrain, source));
  }
  for (std::size_t i = 0; i < together.size(); ++i)
  {
    const double expected = std::min({ alone[0][i], alone[1][i], alone[2][i] });
    EXPECT_NEAR(together[i], expected, 1e-11);
    EXPECT_NEAR(alone[nearest[i]][i], expected, 1e-11);
  }
}

TEST(ExactGeodesicDistance, RenumberingChangesNothing)
{
  auto terrain = MakeTerrain(15);
  const vtkIdType n = terrain->GetNumberOfPoints();
  auto renumbered = [n](vtkIdType id) { return (id * 97 + 13) % n; }; // 97 and 225 are coprime
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  Cells cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    double p[3];
    terrain->GetPoint(i, p);
    points->SetPoint(renumbered(i), p);
  }
  for (vtkIdType c = terrain->GetNumberOfCells() - 1; c >= 0; --c)
  {
    vtkIdType size;
    const vtkIdType* ids;
    terrain->GetPolys()->GetCellAtId(c, size, ids);
    cells.push_back({ renumbered(ids[1]), renumbered(ids[2]), renumbered(ids[0]) });
  }
  vtkNew<vtkPolyData> other;
  other->SetPoints(points);
  other->SetPolys(MakeCells(cells));
  const auto before = Distances(terrain, 40);
  const auto after = Distances(other, renumbered(40));
  for (vtkIdType i = 0; i < n; ++i)
  {
    EXPECT_NEAR(after[renumbered(i)], before[i], 1e-11);
  }
}

TEST(ExactGeodesicDistance, FloatAndDoublePointsAgree)
{
  auto terrain = MakeTerrain(15);
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  vtkNew<vtkPoints> doubles;
  doubles->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < terrain->GetNumberOfPoints(); ++i)
  {
    double p[3];
    terrain->GetPoint(i, p);
    floats->InsertNextPoint(p);
    floats->GetPoint(i, p); // rounded
    doubles->InsertNextPoint(p);
  }
  terrain->SetPoints(floats);
  const auto fromFloats = Distances(terrain, 40);
  terrain->SetPoints(doubles);
  EXPECT_EQ(Distances(terrain, 40), fromFloats);
}
