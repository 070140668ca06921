// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Layouts of curves that are transferred between two surfaces, with the filter.
#include "PathTestTools.h"

#include "vtkGeodesicPatchBoundaries.h"

using namespace dggtest;

namespace
{
/// Returns a layout of landmarks without positions.
vtkSmartPointer<vtkPolyData> MakeLayout(const Cells& patches, const Cells& lines = {})
{
  vtkNew<vtkPolyData> layout;
  layout->SetPolys(MakeCells(patches));
  layout->SetLines(MakeCells(lines));
  return layout.Get();
}

/// Returns the landmarks of four quads on a grid of 8 x 8: corners, midpoints of sides, center.
const std::vector<vtkIdType>& GetNine()
{
  static const std::vector<vtkIdType> ids = { 0, 4, 8, 36, 40, 44, 72, 76, 80 };
  return ids;
}

const Cells& GetFourQuads()
{
  static const Cells patches = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 3, 4, 7, 6 }, { 4, 5, 8, 7 } };
  return patches;
}

/// Returns a grid with a bump in its middle.
vtkSmartPointer<vtkPolyData> MakeBump()
{
  auto bump = MakeGrid(8, 8);
  MovePoints(bump, [&](double* p) {
    p[2] = 2.0 * std::exp(-0.3 * (std::pow(p[0] - 3.5, 2) + std::pow(p[1] - 4.5, 2)));
  });
  return bump;
}

class GeodesicPatchBoundaries : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->First);
    this->Filter->SetSecondSurfaceData(this->Second);
    this->Filter->SetFirstLandmarkIds(GetNine());
    this->Filter->SetSecondLandmarkIds(GetNine());
    this->Filter->SetLayoutData(MakeLayout(GetFourQuads()));
  }

  double Get(vtkDataSetAttributes* data, const char* name, vtkIdType tuple, int component = 0)
  {
    return data->GetArray(name)->GetComponent(tuple, component);
  }

  vtkSmartPointer<vtkPolyData> First = MakeGrid(8, 8);
  vtkSmartPointer<vtkPolyData> Second = MakeBump();
  vtkNew<vtkGeodesicPatchBoundaries> Filter;
};
}

TEST_F(GeodesicPatchBoundaries, LandmarkIds)
{
  this->Filter->AddFirstLandmarkId(7);
  this->Filter->AddSecondLandmarkId(3);
  EXPECT_EQ(this->Filter->GetNumberOfFirstLandmarkIds(), 10);
  EXPECT_EQ(this->Filter->GetFirstLandmarkId(9), 7);
  EXPECT_EQ(this->Filter->GetSecondLandmarkId(9), 3);
  this->Filter->SetFirstLandmarkData(MakeSourcePoints({ { { 0.0, 0.0, 0.0 } } }));
  this->Filter->SetSecondLandmarkData(MakeSourcePoints({ { { 0.0, 0.0, 0.0 } } }));
  this->Filter->RemoveAllLandmarks();
  EXPECT_EQ(this->Filter->GetNumberOfFirstLandmarkIds(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfSecondLandmarkIds(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfInputConnections(2), 0);
  EXPECT_EQ(this->Filter->GetNumberOfInputConnections(3), 0);
  EXPECT_EQ(this->Filter->GetNumberOfInputConnections(4), 1);
}

TEST_F(GeodesicPatchBoundaries, IdsComeBeforePoints)
{
  // Some landmarks of the first surface and all landmarks of the second surface are given by
  // position.
  ExpectSuccess(this->Filter);
  const double length = Get(this->Filter->GetOutput(1)->GetCellData(), "Length", 11);
  Points rest;
  Points all;
  for (std::size_t l = 0; l < 9; ++l)
  {
    all.emplace_back();
    this->Second->GetPoint(GetNine()[l], all.back().data());
    if (l >= 5)
    {
      rest.emplace_back();
      this->First->GetPoint(GetNine()[l], rest.back().data());
    }
  }
  this->Filter->SetFirstLandmarkIds({ 0, 4, 8, 36, 40 });
  this->Filter->SetFirstLandmarkData(MakeSourcePoints(rest));
  this->Filter->RemoveAllSecondLandmarkIds();
  this->Filter->SetSecondLandmarkData(MakeSourcePoints(all));
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput(0)->GetNumberOfLines(), 12);
  EXPECT_NEAR(Get(this->Filter->GetOutput(0)->GetCellData(), "Length", 11), 4.0, 1e-12);
  EXPECT_NEAR(Get(this->Filter->GetOutput(1)->GetCellData(), "Length", 11), length, 1e-12);
}

TEST_F(GeodesicPatchBoundaries, CurvesCorrespond)
{
  ExpectSuccess(this->Filter);
  const Cells sides = { { 0, 1 }, { 1, 4 }, { 4, 3 }, { 3, 0 }, { 1, 2 }, { 2, 5 }, { 5, 4 },
    { 4, 7 }, { 7, 6 }, { 6, 3 }, { 5, 8 }, { 8, 7 } };
  for (const int port : { 0, 1 })
  {
    vtkPolyData* output = this->Filter->GetOutput(port);
    ASSERT_EQ(output->GetNumberOfCells(), 12);
    ASSERT_TRUE(HasPolylines(output, { "Length", "LayoutEdge" }));
    for (vtkIdType c = 0; c < 12; ++c)
    {
      SCOPED_TRACE(c);
      PathLine curve;
      ReadPolyline(output, c, curve);
      ExpectOnSurface(curve, port == 0 ? this->First : this->Second);
      EXPECT_NEAR(port == 0 ? curve.Length : 4.0, 4.0, 1e-12); // straight on the grid
      EXPECT_GE(curve.Length, 4.0 - 1e-12);
      EXPECT_EQ(Get(output->GetCellData(), "LayoutEdge", c, 0), sides[c][0]);
      EXPECT_EQ(Get(output->GetCellData(), "LayoutEdge", c, 1), sides[c][1]);
      EXPECT_EQ(curve.PointIds.front(), GetNine()[sides[c][0]]);
      EXPECT_EQ(curve.PointIds.back(), GetNine()[sides[c][1]]);
      vtkNew<vtkIdList> ids;
      output->GetCellPoints(c, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        EXPECT_NEAR(Get(output->GetPointData(), "ArcFraction", ids->GetId(i)) * curve.Length,
          curve.ArcLengths[i], 1e-12);
      }
      EXPECT_EQ(Get(output->GetPointData(), "ArcFraction", ids->GetId(0)), 0.0);
      EXPECT_EQ(
        Get(output->GetPointData(), "ArcFraction", ids->GetId(ids->GetNumberOfIds() - 1)), 1.0);
    }
  }
}

TEST_F(GeodesicPatchBoundaries, LandmarksAsPoints)
{
  // The landmarks lie slightly off the surface; their cells are the layout.
  vtkNew<vtkPoints> places;
  for (const vtkIdType id : GetNine())
  {
    double p[3];
    this->First->GetPoint(id, p);
    places->InsertNextPoint(p[0], p[1], 0.05);
  }
  vtkSmartPointer<vtkPolyData> landmarks = MakeLayout(GetFourQuads());
  landmarks->SetPoints(places);
  this->Filter->SetFirstLandmarkIds(nullptr);
  this->Filter->SetFirstLandmarkData(landmarks);
  this->Filter->SetLayoutData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput(1)->GetNumberOfLines(), 12);
  this->Filter->SetProjectionTolerance(1e-3);
  ExpectError(this->Filter, { "first landmark 0, at (", "ProjectionTolerance" });
}

TEST_F(GeodesicPatchBoundaries, LinesAndPatches)
{
  // A polyline is a chain of curves; a curve that coincides with a side adds no curve.
  this->Filter->SetLayoutData(MakeLayout({ { 0, 1, 4, 3 } }, { { 4, 5, 8 }, { 1, 4 } }));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput(0)->GetNumberOfLines(), 6);
  EXPECT_EQ(this->Filter->GetOutput(1)->GetNumberOfLines(), 6);
}

/// A single patch: no landmark has enough sides to define its orientation on either surface.
TEST_F(GeodesicPatchBoundaries, OnePatchThatTurnsEitherWay)
{
  const std::vector<vtkIdType> inside = { 20, 24, 60, 56 };
  const std::vector<vtkIdType> corners = { 0, 8, 80, 72 };
  for (const std::vector<vtkIdType>& landmarks : { inside, corners })
  {
    const std::vector<vtkIdType> mirrored = { landmarks[0], landmarks[3], landmarks[2],
      landmarks[1] };
    for (const bool secondIsMirrored : { false, true })
    {
      for (const bool layoutIsMirrored : { false, true })
      {
        this->Filter->SetFirstLandmarkIds(landmarks);
        this->Filter->SetSecondLandmarkIds(secondIsMirrored ? mirrored : landmarks);
        this->Filter->SetLayoutData(
          layoutIsMirrored ? MakeLayout({ { 3, 2, 1, 0 } }) : MakeLayout({ { 0, 1, 2, 3 } }));
        ExpectSuccess(this->Filter);
        for (int side = 0; side < 2; ++side)
        {
          EXPECT_EQ(this->Filter->GetOutput(side)->GetNumberOfLines(), 4);
        }
      }
    }
  }
}

/// A landmark that no curve contains lies in the same patch of both surfaces.
TEST_F(GeodesicPatchBoundaries, LandmarksInNoCurve)
{
  this->Filter->SetSecondSurfaceData(MakeGrid(8, 8));
  this->Filter->SetLayoutData(MakeLayout({ { 0, 1, 2 }, { 0, 2, 3 } }));
  this->Filter->SetFirstLandmarkIds({ 10, 16, 70, 64, 23 });
  this->Filter->SetSecondLandmarkIds({ 10, 16, 70, 64, 47 });
  ExpectError(this->Filter, { "divide the two surfaces differently at landmark 4" });
  this->Filter->SetSecondLandmarkIds({ 10, 16, 70, 64, 24 });
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput(0)->GetNumberOfLines(), 5);
}
