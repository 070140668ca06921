// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGPath on point clouds.
#include "CloudFixture.h"
#include "dggBandSizes.h"

#include "vtkDGGPath.h"

#include <cstddef>

namespace dggtest
{
namespace
{
class CloudPath : public CloudFixture
{
};

/// Returns the polyline of a path as points.
Points GetPolyline(vtkPolyData* paths, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  paths->GetLines()->GetCellAtId(line, ids);
  Points points;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    points.emplace_back();
    paths->GetPoint(ids->GetId(i), points.back().data());
  }
  return points;
}
}

TEST_F(CloudPath, PathsInThePlane)
{
  this->Use(MakeFlatPoints(40, 0.2));
  const Points& cloud = this->Cloud;
  const Points places = { { { 0.111, 0.222, 0.0 } }, { { 0.9, 0.8, 0.0 } }, // far from each other
    { { 0.501, 0.5, 0.0 } }, { { 0.506, 0.504, 0.0 } } };                   // within a spacing
  const auto lines = MakeSourcePoints(places);
  lines->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->SetPairData(lines);
  path->AddPair(0, 1599);
  path->AddPair(39, 800);
  path->AddPair(5, 5);
  ExpectSuccess(path);
  vtkPolyData* output = path->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 5);
  const std::array<double, 3> ends[5][2] = { { cloud[0], cloud[1599] }, { cloud[39], cloud[800] },
    { cloud[5], cloud[5] }, { places[0], places[1] }, { places[2], places[3] } };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    SCOPED_TRACE(i);
    const Points line = GetPolyline(output, i);
    EXPECT_NEAR(Distance(line.front(), ends[i][0]), 0.0, i < 3 ? 0.0 : 1e-12);
    EXPECT_NEAR(Distance(line.back(), ends[i][1]), 0.0, i < 3 ? 0.0 : 1e-12);
    double length = 0.0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
      length += Distance(line[k], line[k + 1]);
    }
    const double exact = Distance(ends[i][0], ends[i][1]);
    EXPECT_NEAR(Value(output->GetCellData(), "Length", i), length, 1e-12);
    EXPECT_GE(length, exact - 1e-12);
    EXPECT_LE(length, 1.02 * exact + 1e-12);
    EXPECT_NEAR(Value(output->GetCellData(), "GraphLength", i), exact, 0.02 * exact + 1e-12);
    EXPECT_EQ(Value(output->GetCellData(), "PairId", i), static_cast<double>(i));
    EXPECT_EQ(Value(output->GetCellData(), "Straightened", i), 1.0);
  }
  EXPECT_EQ(GetPolyline(output, 4).size(), 2u);
  vtkPointData* data = output->GetPointData();
  const vtkIdType last = output->GetNumberOfPoints() - 1;
  EXPECT_EQ(Value(data, "vtkOriginalPointIds", 0), 0.0);
  EXPECT_EQ(Value(data, "vtkOriginalPointIds", last), -1.0);
  for (vtkIdType i = 0; i <= last; ++i)
  {
    EXPECT_EQ(Value(data, "FaceId", i), -1.0);
  }
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("DGG.Info"), nullptr);
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("DGG.Radii"), nullptr);
}

TEST_F(CloudPath, SmoothPathsStayWithinASpacing)
{
  // Rows of the unit sphere. The geodesic between points of the uppermost row follows that row,
  // because the great circle leaves the band.
  Points points;
  for (int k = 0; k < 8; ++k)
  {
    const double latitude = 0.3 + 2.0 * vtkMath::Pi() * k / 160;
    for (int j = 0; j < 160; ++j)
    {
      const double longitude = 2.0 * vtkMath::Pi() * j / 160;
      points.push_back({ { std::cos(latitude) * std::cos(longitude),
        std::cos(latitude) * std::sin(longitude), std::sin(latitude) } });
    }
  }
  this->Use(points);
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(1120, 1173);
  ExpectSuccess(path);
  EXPECT_EQ(Value(path->GetOutput()->GetCellData(), "Straightened", 0), 1.0);
  EXPECT_NEAR(Value(path->GetOutput()->GetCellData(), "Length", 0), 1.74674, 0.001 * 1.74674);
  vtkDataArray* radii = this->Graph->GetOutput()->GetFieldData()->GetArray("DGG.Radii");
  for (const auto& position : GetPolyline(path->GetOutput(), 0))
  {
    double nearest = INFINITY; // in spacings
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double spacing =
        radii->GetTuple1(static_cast<vtkIdType>(i)) / dgg::AutomaticBallBySpacing;
      nearest = std::min(nearest, Distance(position, points[i]) / spacing);
    }
    EXPECT_LT(nearest, 1.0);
  }
}

TEST_F(CloudPath, PathsThatDoNotExist)
{
  const Points part = MakeFlatPoints(12, 0.2);
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(0, 200);
  path->AddPair(0, 100);
  ExpectWarning(path, { "No path in the graph of the cloud" });
  EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
}
}
