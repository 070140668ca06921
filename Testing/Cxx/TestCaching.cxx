// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh is prepared again if it has changed, and only then.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
class Caching : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Grid = MakeGrid(4, 4);
    this->Filter->SetInputData(this->Grid);
    this->Filter->AddSourceId(0);
    EXPECT_EQ(this->Filter->GetMeshBuildTime(), 0u);
    ExpectSuccess(this->Filter);
    this->Built = this->Filter->GetMeshBuildTime();
    EXPECT_GT(this->Built, 0u);
  }

  void ExpectKept(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetMeshBuildTime(), this->Built) << what;
  }

  void ExpectRebuilt(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_GT(this->Filter->GetMeshBuildTime(), this->Built) << what;
    this->Built = this->Filter->GetMeshBuildTime();
  }

  vtkSmartPointer<vtkPolyData> Grid;
  vtkNew<vtkExactGeodesicDistance> Filter;
  vtkMTimeType Built = 0;
};
}

TEST_F(Caching, PropertiesAndSourcesKeepTheMesh)
{
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 24 });
  this->ExpectKept("source ids");
  EXPECT_NEAR(GetDistances(this->Filter)[0], std::sqrt(32.0), 1e-12);
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 0.0 } } }));
  this->ExpectKept("source points");
  EXPECT_NEAR(GetDistances(this->Filter)[0], std::sqrt(0.5), 1e-12);
  this->Filter->SetMaximumDistance(2.0);
  this->ExpectKept("maximum distance");
  this->Filter->GenerateNearestSourceOn();
  this->ExpectKept("nearest source");
  this->Filter->SetEngineToReference();
  this->ExpectKept("engine");
  this->Filter->SetDistanceArrayName("d");
  this->ExpectKept("name");
  this->Filter->AddSourceId(77);
  ExpectError(this->Filter, { "77" });
  this->Filter->SetSourceIds({ 1 });
  this->ExpectKept("after an error");
}

TEST_F(Caching, PointsRebuildTheMesh)
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(this->Grid->GetPoints());
  points->SetPoint(1, 1.5, 0.0, 0.0);
  this->Grid->SetPoints(points);
  this->ExpectRebuilt("other points");
  EXPECT_NEAR(GetDistances(this->Filter)[1], 1.5, 1e-12);
  points->SetPoint(1, 1.25, 0.0, 0.0);
  points->Modified();
  this->ExpectRebuilt("a moved point");
  EXPECT_NEAR(GetDistances(this->Filter)[1], 1.25, 1e-12);
}

TEST_F(Caching, ModifiedOnTheDataObjectWillDo)
{
  // The same change as through the numpy view of the points.
  auto* coordinates = vtkDoubleArray::SafeDownCast(this->Grid->GetPoints()->GetData());
  ASSERT_NE(coordinates, nullptr);
  for (vtkIdType i = 0; i < coordinates->GetNumberOfValues(); ++i)
  {
    *coordinates->GetPointer(i) *= 2.0;
  }
  this->Grid->Modified();
  this->ExpectRebuilt("moved points, marked on the data object");
  EXPECT_NEAR(GetDistances(this->Filter)[1], 2.0, 1e-12);
}

TEST_F(Caching, PolygonsRebuildTheMesh)
{
  this->Grid->SetPolys(MakeGrid(4, 4, GridCells::Quads)->GetPolys());
  this->ExpectRebuilt("other polygons");
  const vtkIdType corner[3] = { 0, 4, 24 };
  this->Grid->SetPolys(MakeCells({ { 0, 4, 24, 20 } }));
  this->ExpectRebuilt("a single polygon");
  EXPECT_TRUE(std::isnan(GetDistances(this->Filter)[12])); // no longer on the surface
  this->Grid->SetPolys(MakeCells({ { corner[0], corner[1], corner[2] } }));
  this->ExpectRebuilt("a single triangle");
  this->Grid->SetStrips(MakeGrid(4, 4, GridCells::Strips)->GetStrips());
  this->Grid->SetPolys(nullptr);
  this->ExpectRebuilt("strips instead");
  EXPECT_NEAR(GetDistances(this->Filter)[12], std::sqrt(8.0), 1e-12);
  const vtkIdType other[3] = { 0, 1, 6 };
  this->Grid->SetPolys(MakeGrid(4, 4)->GetPolys());
  this->Grid->SetStrips(nullptr);
  this->ExpectRebuilt("triangles again");
  this->Grid->GetPolys()->ReplaceCellAtId(0, 3, other);
  this->Grid->GetPolys()->Modified();
  const Listener listener(this->Filter); // warns about overlapping triangles
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetMeshBuildTime(), this->Built);
}
