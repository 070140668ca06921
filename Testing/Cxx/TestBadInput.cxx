// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Invalid input of the filter: error message, output, and success of a later correct call.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkErrorCode.h"

using namespace dggtest;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Inf = std::numeric_limits<double>::infinity();

/// A filter on a small grid with valid input.
class BadInput : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Grid = MakeGrid(3, 3);
    this->Filter->SetInputData(this->Grid);
    this->Filter->AddSourceId(0);
    ExpectSuccess(this->Filter);
    this->Expected = GetDistances(this->Filter);
    ASSERT_EQ(this->Expected.size(), 16u);
  }

  vtkSmartPointer<vtkPolyData> Grid;
  vtkNew<vtkExactGeodesicDistance> Filter;
  std::vector<double> Expected;
};
}

TEST_F(BadInput, AfterAFailureOrAnAbortFiltersDownstreamAreEmpty)
{
  ProgressWatch watch(this->Filter);
  vtkNew<vtkExactGeodesicDistance> downstream;
  downstream->SetInputConnection(this->Filter->GetOutputPort());
  downstream->AddSourceId(0);
  const auto expectEmpty = [&](std::size_t errors) {
    this->Filter->Modified();
    const Listener upstream(this->Filter);
    const Listener listener(downstream);
    downstream->Update();
    EXPECT_EQ(upstream.Errors.size(), errors);
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 0);
  };
  this->Filter->AddSourceId(99);
  expectEmpty(1);
  // Updates without a change do not repeat the error.
  const Listener again(this->Filter);
  downstream->Update();
  EXPECT_TRUE(again.Errors.empty());
  EXPECT_NE(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  vtkNew<vtkExactGeodesicDistance> sourced;
  sourced->SetInputData(this->Grid);
  sourced->SetSourceConnection(this->Filter->GetOutputPort());
  ExpectError(sourced, { "source" });
  this->Filter->SetSourceIds({ 0 });
  watch.StopAt = 0.0;
  expectEmpty(0);
  watch.StopAt = 2.0;
  this->Filter->Modified();
  ExpectSuccess(downstream);
  EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 16);
}

TEST_F(BadInput, SurfacesThatAreRefused)
{
  const Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  const std::array<double, 3> p = { { 1.0, 2.0, 3.0 } };
  // Ids of cells are ids of the input: verts and lines come first.
  const auto mixed = MakeSurface(points, { { 0, 1, 2 } });
  mixed->SetVerts(MakeCells({ { 0 }, { 1 } }));
  mixed->SetLines(MakeCells({ { 0, 1 } }));
  mixed->SetStrips(MakeCells({ { 0, 1, 2, 77 } }));
  const auto contradictory = MakeGrid(1, 1);
  contradictory->SetPolys(MakeContradictoryCells());
  const struct
  {
    vtkSmartPointer<vtkPolyData> Surface;
    std::vector<std::string> Parts;
  } cases[] = {
    { MakeSurface(points, { { 0, 1, 2 }, { 0, 1, 3 } }), { "cell 1 ", "point 3,", "points is 3" } },
    { MakeSurface(points, { { 0, -5, 2 } }), { "cell 0 ", "point -5," } },
    { mixed, { "cell 4 ", "point 77," } },
    { contradictory, { "contradict" } },
    { MakeSurface({ points[0], { { 0, -Inf, 0 } }, points[2] }, { { 0, 1, 2 } }),
      { "point 1 of cell ", "not finite" } },
    { MakeGrid(3, 3, GridCells::Triangles, 1e100), { "scale the mesh" } },
    { MakeGrid(3, 3, GridCells::Triangles, 1e-100), { "scale the mesh" } },
    { MakeSurface(points, { { 0, 0, 0 }, { 0, 1 }, { 2 }, { 0, 1, 0, 1 }, { 1, 2, 2, 1 } }),
      { "5 polygons or strips, but none with three distinct points" } },
    { MakeSurface({ p, p, p }, { { 0, 1, 2 } }), { "single points" } },
  };
  for (const auto& refused : cases)
  {
    SCOPED_TRACE(::testing::PrintToString(refused.Parts));
    this->Filter->SetInputData(refused.Surface);
    ExpectError(this->Filter, refused.Parts);
    EXPECT_EQ(this->Filter->GetMeshReport(), "no surface\n");
    this->Filter->SetInputData(this->Grid);
    ExpectSuccess(this->Filter);
    EXPECT_EQ(GetDistances(this->Filter), this->Expected);
  }
}

TEST_F(BadInput, PointsThatAreNotFiniteAndNotUsed)
{
  for (const bool merge : { false, true })
  {
    auto surface = MakeGrid(3, 3);
    surface->GetPoints()->InsertNextPoint(NaN, Inf, 0.0);
    this->Filter->SetInputData(surface);
    this->Filter->SetMergeCoincidentPoints(merge);
    ExpectSuccess(this->Filter);
    auto distances = GetDistances(this->Filter);
    ASSERT_EQ(distances.size(), 17u);
    EXPECT_TRUE(std::isnan(distances.back()));
    EXPECT_EQ(GetReported(this->Filter, "NumberOfIsolatedPoints"), 1);
    distances.pop_back();
    EXPECT_EQ(distances, this->Expected);
    // Sources on port 1 are not affected.
    this->Filter->SetSourceData(MakeSourcePoints({ { { 0, 0, 0 } } }));
    ExpectSuccess(this->Filter);
    this->Filter->SetSourceData(nullptr);
  }
}
