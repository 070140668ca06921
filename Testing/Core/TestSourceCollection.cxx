// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Ids, positions, and cells with coordinates as points of surfaces and clouds.
#include "TestMeshes.h"

#include "dggCellCoordinates.h"
#include "dggSourceCollection.h"
#include "dggSurfacePath.h"

namespace dggtest
{
namespace
{
using dgg::Offset;
using Coordinates = std::array<double, 3>;
using Numbers = std::vector<double>;

const double NaN = std::numeric_limits<double>::quiet_NaN();
/// A unit square and a point beside it.
const Numbers SquarePoints = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 3, 3, 0 };

/// A surface or a cloud with its input cells.
struct Input
{
  Input(const Numbers& points, const std::vector<std::vector<Offset>>& polygons,
    dgg::Domain::KindType kind = dgg::Domain::Surface, Offset firstCell = 0)
  {
    for (const std::vector<Offset>& polygon : polygons)
    {
      this->Ids.insert(this->Ids.end(), polygon.begin(), polygon.end());
      this->Offsets.push_back(static_cast<Offset>(this->Ids.size()));
    }
    this->Arrays.Points = points.data();
    this->Arrays.NumberOfPoints = static_cast<Offset>(points.size() / 3);
    this->Arrays.Polygons = { static_cast<Offset>(polygons.size()), this->Offsets.data(),
      this->Ids.data(), this->Offsets.back() };
    this->Arrays.FirstCell = firstCell;
    const dgg::Domain domain{ kind, 0.0 };
    const auto print = dgg::PreparedSurface::ComputeFingerprint(this->Arrays, domain);
    EXPECT_TRUE(Ok(dgg::PreparedSurface::Make(this->Arrays, domain, print, this->Surface)));
  }

  dgg::Status Locate(const dgg::SourceCollection& sources, double tolerance = 0.01)
  {
    return sources.Locate(this->Arrays, *this->Surface, tolerance, this->Found);
  }

  Coordinates GetPosition(std::size_t i = 0) const
  {
    return dgg::PositionOf(
      this->Surface->GetMesh(), this->Found.at(i).Point, this->Surface->GetPositions());
  }

  std::vector<Offset> Offsets = { 0 };
  std::vector<Offset> Ids;
  dgg::SurfaceArrays Arrays;
  dgg::PreparedSurface::Pointer Surface;
  std::vector<dgg::GeodesicSource> Found;
};

Input MakeSquare()
{
  return Input(SquarePoints, { { 0, 1, 2 }, { 0, 2, 3 } });
}

dgg::SourceCollection At(const Numbers& positions)
{
  dgg::SourceCollection sources;
  sources.Role = "source";
  sources.Property = "SourceIds";
  sources.IsConnected = true;
  sources.Positions = positions;
  return sources;
}

/// Returns a point of a cell, with a different position.
dgg::SourceCollection InCell(double cell, const Coordinates& coordinates)
{
  dgg::SourceCollection sources = At({ 9, 9, 9 });
  sources.Cells = { cell };
  sources.Barycentric.assign(coordinates.begin(), coordinates.end());
  return sources;
}

void ExpectNear(const Coordinates& found, const Coordinates& expected)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(found[k], expected[k], 1e-14) << k;
  }
}
}

TEST(SourceCollection, IdsComeBeforePositions)
{
  Input input = MakeSquare();
  dgg::SourceCollection sources = At({ 0.25, 0.5, 0.001, 1.003, -0.003, 0 });
  sources.Ids = { 3 };
  sources.InitialDistancesOfIds = { -0.5 };
  sources.InitialDistances = { 0.25, 0.75 };
  ASSERT_TRUE(Ok(input.Locate(sources)));
  ASSERT_EQ(input.Found.size(), 3u);
  EXPECT_EQ(input.Found[0].Point.Vertex, 3);
  ExpectNear(input.GetPosition(1), { { 0.25, 0.5, 0.0 } });
  EXPECT_EQ(input.Found[2].Point.Vertex, 1);
  EXPECT_EQ(input.Found[0].InitialDistance, -0.5);
  EXPECT_EQ(input.Found[2].InitialDistance, 0.75);
}

TEST(SourceCollection, WrongNumbersAreRefused)
{
  struct
  {
    std::function<void(dgg::SourceCollection&)> Spoil;
    std::string Message;
  } const cases[] = {
    { [](auto& s) {
       s.Positions.clear();
       s.Input = "input port 1";
     },
      "There is no source: input port 1 has no points. Set SourceIds, or add points to input port "
      "1." },
    { [](auto& s) {
       s = dgg::SourceCollection();
       s.Input = "input port 1";
     },
      "Connect points to input port 1" },
    { [](auto& s) {
       s.Ids = { 0, 5 };
     },
      "Source id 5 is out of range" },
    { [](auto& s) { s.Ids = { -1 }; }, "the input has 5 points. Use ids from 0 to 4." },
    { [](auto& s) { s.Positions[1] = NaN; }, "Source 7, at (0, nan, 0), has coord" },
    { [](auto& s) { s.InitialDistances = { NaN }; }, "has the initial distance nan" },
    { [](auto& s) { s.InitialDistances = { dgg::Infinity }; }, "Source 7 has" },
    { [](auto& s) { s.Positions[2] = 0.1; },
      "is 0.1 away from the surface, farther than 0.0141421" },
  };
  for (const auto& wrong : cases)
  {
    dgg::SourceCollection sources = At({ 0, 0, 0 });
    sources.Indices = { 7 };
    wrong.Spoil(sources);
    EXPECT_TRUE(Says(MakeSquare().Locate(sources), wrong.Message));
  }
}

TEST(SourceCollection, CloudsReachBetweenTheirPoints)
{
  // Outliers, two of them coincident, do not enlarge the diagonal, and are located.
  for (const double off : { 20.0, 1e6, 1e16, 3.4e38, 1e200 })
  {
    SCOPED_TRACE(off);
    Numbers points;
    for (int i = 0; i < 400; ++i)
    {
      points.insert(points.end(), { 0.05 * (i % 20), 0.05 * (i / 20), 0.0 });
    }
    points.insert(points.end(), { off, 0, -off, off, 0, -off, 0, -off, 0 });
    Input input(points, {}, dgg::Domain::Cloud);
    ASSERT_TRUE(Ok(input.Locate(At({ off, 0, -off, 0, -off, 0, 0.31, 0.3, 0.01 }), 0.0)));
    EXPECT_EQ(input.Found[0].Point.Vertex, 400);
    EXPECT_EQ(input.Found[1].Point.Vertex, 402);
    EXPECT_EQ(input.Found[2].Point.On, dgg::SurfacePoint::Support::Near);
    EXPECT_EQ(input.Found[2].Point.Vertex, 6 * 20 + 6);
    EXPECT_TRUE(Says(input.Locate(At({ 0.5, 0.5, 0.3 })), "0.3 away from the cloud"));
    EXPECT_TRUE(Says(input.Locate(At({ 0.9 * off, 0, -off })), "away from the cloud"));
    ASSERT_TRUE(Ok(input.Locate(At({ 0.5, 0.5, 0.3, -off, 0.5 * off, off }), 1e300)));
    EXPECT_LT(input.Found[1].Point.Vertex, 400); // far from all points
    EXPECT_TRUE(Says(input.Locate(InCell(0, { { 1, 0, 0 } })), "do not apply to a point cloud"));
  }
}

TEST(SourceCollection, CellsAreThoseOfTheInput)
{
  // A fan whose long edge touches a degenerate triangle at point 4, where the edge is split. The
  // corners of the second layer have other ids, and two other cells come first.
  const Numbers points = { 0, 0, 0, 4, 0, 0, 1, 3, 0, 2, -2, 0, 2, 0, 0, 4, 0, 0, 1, 3, 0, 5, 4,
    0 };
  const std::vector<std::vector<Offset>> triangles = { { 1, 2, 0 }, { 0, 4, 1 }, { 3, 4, 0 },
    { 4, 3, 1 }, { 5, 6, 7 } };
  for (const auto kind : { dgg::Domain::Surface, dgg::Domain::MergedSurface })
  {
    Input input(points, triangles, kind, 2);
    const dgg::CellCoordinates cells(input.Arrays, *input.Surface);
    const dgg::SurfaceMesh& mesh = input.Surface->GetMesh();
    EXPECT_TRUE(dgg::CellCoordinates::AreAllTriangles(input.Arrays));
    for (const Offset cell : { 2, 4, 5, 6 })
    {
      for (const Coordinates& b : { Coordinates{ { 1, 0, 0 } }, { { 0.25, 0.75, 0 } },
             { { 0.1, 0.3, 0.6 } }, { { 0.7, 0.1, 0.2 } }, { { 0, 0, 1 } } })
      {
        SCOPED_TRACE(cell);
        ASSERT_TRUE(Ok(input.Locate(InCell(static_cast<double>(cell), b))));
        ExpectNear(input.GetPosition(), cells.GetPosition(cell, b));
        const dgg::SurfacePoint& point = input.Found[0].Point;
        const Id face = dgg::FindFaceOf(mesh, point);
        ExpectNear(
          cells.GetPosition(input.Surface->GetCell(face), cells.GetCoordinates(point, face)),
          cells.GetPosition(cell, b));
      }
    }
  }
}

TEST(SourceCollection, CellsWithoutAreaArePositions)
{
  Input input(SquarePoints, { { 0, 1, 3 }, { 0, 1, 1 } });
  ASSERT_TRUE(Ok(input.Locate(InCell(1, { { 0.25, 0.5, 0.25 } }))));
  ExpectNear(input.GetPosition(), { { 0.75, 0, 0 } });
}

TEST(SourceCollection, WrongCellsAreRefused)
{
  const Numbers points = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0 };
  Input input(points, { { 0, 1, 2, 3 }, { 1, 4, 2 } }, dgg::Domain::Surface, 1);
  EXPECT_FALSE(dgg::CellCoordinates::AreAllTriangles(input.Arrays));
  struct
  {
    double Cell;
    Coordinates Barycentric;
    std::string Message;
  } const cases[] = {
    { 3, { { 1, 0, 0 } }, "FaceId 3 is out of range: the input has 3 cells" },
    { -1, { { 1, 0, 0 } }, "FaceId -1 is out of range" },
    { NaN, { { 1, 0, 0 } }, "FaceId nan is not an integer" },
    { 0, { { 1, 0, 0 } }, "FaceId 0 is not a triangle" },
    { 1, { { 1, 0, 0 } }, "FaceId 1 is not a triangle" },
    { 2, { { 1.1, -0.1, 0 } }, "Use non-negative numbers with the sum 1" },
    { 2, { { 0.5, 0.5, 0.5 } }, "Use non-negative numbers with the sum 1" },
    { 2, { { NaN, 0.5, 0.5 } }, "Barycentric are (nan" },
  };
  for (const auto& wrong : cases)
  {
    dgg::SourceCollection sources = InCell(wrong.Cell, wrong.Barycentric);
    EXPECT_TRUE(Says(input.Locate(sources), wrong.Message));
    // Outputs of filters may belong to another surface.
    sources.Positions = { 2, 0, 0 };
    sources.OriginalIds = { 4 };
    ASSERT_TRUE(Ok(input.Locate(sources)));
    EXPECT_EQ(input.Found[0].Point.Vertex, 4);
  }
}

TEST(SourceCollection, CellsOfOtherSurfacesDoNotCount)
{
  // A valid cell and coordinates, but a position elsewhere.
  Input input = MakeSquare();
  dgg::SourceCollection sources = InCell(0, { { 0.25, 0.5, 0.25 } });
  sources.OriginalIds = { 3 };
  sources.Positions = { 0, 1, 0 };
  ASSERT_TRUE(Ok(input.Locate(sources)));
  EXPECT_EQ(input.Found[0].Point.Vertex, 3);
  sources.Positions = { 0.25, 0.5, 0 };
  ASSERT_TRUE(Ok(input.Locate(sources)));
  ExpectNear(input.GetPosition(), { { 0.25, 0.5, 0 } });
}

TEST(SourceCollection, OriginalIdsCountWhereThePointIs)
{
  // Two layers with large map coordinates, and an isolated point.
  const double x = 512345.678;
  const double y = 5403210.987;
  const Numbers points = { x, y, 0, x + 1, y, 0, x, y + 1, 0, x, y, 0, x + 1, y, 0, x, y + 1, 0, x,
    y, 0 };
  Input input(points, { { 0, 1, 2 }, { 3, 4, 5 } });
  for (const Offset id : { 0, 3, 6 })
  {
    dgg::SourceCollection sources = At({ x, y, 0 });
    sources.OriginalIds = { static_cast<double>(id) };
    ASSERT_TRUE(Ok(input.Locate(sources)));
    EXPECT_EQ(input.Found[0].Point.Vertex, id);
    EXPECT_EQ(input.Surface->GetMesh().GetNumberOfFaces(), 2);
    EXPECT_EQ(sources.DescribeIsolated(*input.Surface, input.Found),
      id != 6 ? ""
              : "Source 0 is a point that no polygon uses. Such points reach "
                "no other point. Choose points of polygons");
    sources.Positions[0] += 0.1; // an offset within the precision of floats
    ASSERT_TRUE(Ok(input.Locate(sources)));
    EXPECT_EQ(input.Found[0].Point.On, dgg::SurfacePoint::Support::Edge);
    sources.AreRounded = true;
    ASSERT_TRUE(Ok(input.Locate(sources)));
    EXPECT_EQ(input.Found[0].Point.Vertex, id);
  }
}

TEST(SourceCollection, IsolatedPointsAreCounted)
{
  Input input = MakeSquare();
  dgg::SourceCollection sources = At({});
  sources.Ids = { 0, 4, 4 };
  ASSERT_TRUE(Ok(input.Locate(sources)));
  EXPECT_EQ(sources.DescribeIsolated(*input.Surface, input.Found),
    "Source id 4 and 1 more are points that no polygon uses. Such points reach no other point. "
    "Choose points of polygons");
}
}
