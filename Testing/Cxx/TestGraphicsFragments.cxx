// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The second output of vtkPoissonVectorGraphics: colored points.
#include "VectorGraphicsTestTools.h"

#include "vtkAlgorithmOutput.h"

using namespace dggtest;

namespace
{
/// The rectangle [0, 6] x [0, 4] in unit squares, and an upward curve at x = 1.5 between two
/// colors.
struct Fixture : GraphicsFixture
{
  Fixture()
    : GraphicsFixture({ { 1.5, 0, 0 }, { 1.5, 4, 0 } }, { { 0, 1 } })
  {
    AddArray(this->OfCells(), "LeftColor", { 0.2, 0.4, 2.0 }, 3);
    AddArray(this->OfCells(), "RightColor", { 1.0, 0.0, -1.0 }, 3);
    std::vector<double> xs;
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
    {
      xs.push_back(this->Surface->GetPoint(i)[0]);
      xs.push_back(this->Surface->GetPoint(i)[1]);
    }
    AddArray(this->Surface->GetPointData(), "place", xs, 2);
  }
  vtkPolyData* Run()
  {
    this->GraphicsFixture::Run();
    return this->Filter->GetFragments();
  }
};
}

TEST(GraphicsFragments, AreColoredPointsOfTheSurface)
{
  Fixture drawing;
  EXPECT_EQ(drawing.Run()->GetNumberOfPoints(), 0); // generated only on request
  EXPECT_EQ(drawing.Filter->GetFragmentPort()->GetIndex(), 1);
  drawing.Filter->GenerateFragmentsOn();
  for (const int division : { 1, 3 })
  {
    drawing.Filter->SetFragmentDivision(division);
    vtkPolyData* fragments = drawing.Run();
    const vtkIdType count = fragments->GetNumberOfPoints();
    EXPECT_EQ(count, division * division * drawing.Filter->GetOutput()->GetNumberOfCells());
    ASSERT_EQ(fragments->GetNumberOfVerts(), count);
    ASSERT_EQ(fragments->GetNumberOfCells(), count);
    vtkPointData* data = fragments->GetPointData();
    vtkDataArray* colors = data->GetArray("Colors");
    vtkDataArray* shown = data->GetScalars();
    vtkDataArray* faces = data->GetArray("FaceId");
    vtkDataArray* places = data->GetArray("place");
    ASSERT_EQ(colors->GetDataType(), VTK_DOUBLE);
    ASSERT_STREQ(shown->GetName(), "RGB");
    ASSERT_EQ(faces->GetDataType(), VTK_ID_TYPE);
    ASSERT_EQ(places->GetNumberOfTuples(), count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double p[3];
      fragments->GetPoint(i, p);
      const bool isLeft = p[0] < 1.5;
      EXPECT_NEAR(colors->GetComponent(i, 0), isLeft ? 0.2 : 1.0, 1e-9);
      EXPECT_NEAR(colors->GetComponent(i, 2), isLeft ? 2.0 : -1.0, 1e-9);
      EXPECT_EQ(shown->GetComponent(i, 1), isLeft ? 102.0 : 0.0);
      EXPECT_EQ(shown->GetComponent(i, 2), isLeft ? 255.0 : 0.0);
      EXPECT_EQ(places->GetComponent(i, 0), p[0]) << "not at its place";
      EXPECT_EQ(places->GetComponent(i, 1), p[1]);
      double bounds[6];
      drawing.Surface->GetCellBounds(static_cast<vtkIdType>(faces->GetComponent(i, 0)), bounds);
      EXPECT_TRUE(p[0] > bounds[0] && p[0] < bounds[1] && p[1] > bounds[2] && p[1] < bounds[3]);
      vtkNew<vtkIdList> ids;
      fragments->GetCellPoints(i, ids);
      ASSERT_EQ(ids->GetNumberOfIds(), 1);
      EXPECT_EQ(ids->GetId(0), i);
    }
  }
  EXPECT_EQ(drawing.Filter->GetNumberOfFactorizations(), 1);
  drawing.Filter->SetMemoryLimit(30000000);
  drawing.Run();
  drawing.Filter->SetFragmentDivision(100000);
  EXPECT_EQ(drawing.Filter->GetFragmentDivision(), 256);
  ExpectError(drawing.Filter, { "MemoryLimit", "fragments", "FragmentDivision" });
  EXPECT_EQ(drawing.Filter->GetFragments()->GetNumberOfPoints(), 0);
  drawing.Filter->SetMemoryLimit(0);
  drawing.Filter->GenerateFragmentsOff();
  EXPECT_EQ(drawing.Run()->GetNumberOfPoints(), 0);
}

TEST(GraphicsFragments, AreWhereTheSurfaceIsRefined)
{
  Fixture drawing;
  drawing.Filter->GenerateFragmentsOn();
  drawing.Filter->SetRefinementLevel(2);
  drawing.Filter->SetRefinementRegionToCells();
  std::vector<double> chosen(24, 0.0);
  chosen[4] = 1.0;
  chosen[23] = 1.0;
  AddArray(drawing.Surface->GetCellData(), "Refine", chosen, 1);
  std::vector<double> faces = GetValues(drawing.Run(), "FaceId");
  EXPECT_EQ(faces.size(), 2u * 2u * 16u);
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 4.0), 32);
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 23.0), 32);
  // Near the curve, cells of the second column and their neighbors are refined.
  drawing.Filter->SetRefinementRegionToNearCurves();
  vtkPolyData* fragments = drawing.Run();
  faces = GetValues(fragments, "FaceId");
  EXPECT_GT(faces.size(), 4u * 2u * 16u);
  for (vtkIdType i = 0; i < fragments->GetNumberOfPoints(); ++i)
  {
    const double x = fragments->GetPoint(i)[0];
    EXPECT_TRUE(x > 1.0 && x < 2.0) << x; // the curve is in the middle of these cells
  }
  vtkNew<vtkPolyData> none;
  drawing.Filter->SetInputData(none);
  ExpectWarning(drawing.Filter, { "empty" });
  EXPECT_EQ(drawing.Filter->GetFragments()->GetNumberOfPoints(), 0);
}
