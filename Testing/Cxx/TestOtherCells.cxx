// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Filters of the Laplacian: verts, lines, points that no polygon uses; surfaces that are too thin.
#include "VectorGraphicsTestTools.h"

#include "vtkBiharmonicDistance.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkHarmonicBSpline.h"
#include "vtkSurfaceEarthMoversDistance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace dggtest;

namespace
{
/// A square of 6 x 4 quads on 35 points, and besides a vert, a line, and a point of no cell.
vtkSmartPointer<vtkPolyData> MakeMixedSurface()
{
  vtkSmartPointer<vtkPolyData> surface = MakeGrid(6, 4, GridCells::Quads);
  const vtkIdType first = surface->GetNumberOfPoints();
  for (int i = 0; i < 4; ++i)
  {
    surface->GetPoints()->InsertNextPoint(10.0 + i, 1.0, 2.0);
  }
  surface->SetVerts(MakeCells({ { first } }));
  surface->SetLines(MakeCells({ { first + 1, first + 2 } }));
  std::vector<double> numbers;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    numbers.push_back(static_cast<double>(cell));
  }
  AddArray(surface->GetCellData(), "number", numbers, 1);
  return surface;
}

/// The output has all points and cells of the input, with its arrays.
void ExpectPassedOn(vtkPolyData* input, vtkPolyData* output)
{
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfVerts(), 1);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  ASSERT_EQ(output->GetNumberOfPolys(), 24);
  for (vtkIdType cell = 0; cell < 26; ++cell)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("number")->GetComponent(cell, 0), cell);
  }
}

/// All components of a point array are `value` at points without a polygon, and finite elsewhere.
void ExpectThere(vtkPolyData* output, const std::string& name, double value)
{
  vtkDataArray* array = output->GetPointData()->GetArray(name.c_str());
  ASSERT_NE(array, nullptr) << name;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double found = array->GetComponent(i, c);
      const bool isAlone = i >= 35;
      EXPECT_TRUE(isAlone || std::isfinite(found)) << name << " " << i;
      EXPECT_TRUE(!isAlone || found == value || (std::isnan(found) && std::isnan(value)))
        << name << " " << i << ": " << found;
    }
  }
}
}

TEST(OtherCells, ArePassedOnByGreensFunctions)
{
  vtkSmartPointer<vtkPolyData> surface = MakeMixedSurface();
  vtkNew<vtkDiscreteGreensFunction> filter;
  filter->SetInputData(surface);
  filter->SetSourceIds({ 9, 17 });
  filter->SetMethodToVertex(); // the mesh is too coarse for others
  ExpectSuccess(filter);
  ExpectPassedOn(surface, filter->GetOutput());
  ExpectThere(filter->GetOutput(), "GreensFunction", 0.0);
}

TEST(OtherCells, ArePassedOnBySplines)
{
  vtkSmartPointer<vtkPolyData> surface = MakeMixedSurface();
  AddArray(surface->GetPointData(), "heating", std::vector<double>(39, 0.0), 1);
  surface->GetPointData()->GetArray("heating")->SetComponent(9, 0, 1.0);
  surface->GetPointData()->GetArray("heating")->SetComponent(25, 0, -1.0);
  surface->GetPointData()->GetArray("heating")->SetComponent(37, 0, 5.0); // on the line
  vtkNew<vtkHarmonicBSpline> filter;
  filter->SetInputData(surface);
  filter->SetNumberOfSites(5);
  filter->SetRightHandSideArrayName("heating");
  ExpectSuccess(filter);
  ExpectPassedOn(surface, filter->GetOutput());
  ExpectThere(filter->GetOutput(), "HarmonicBSpline", 0.0);
  ExpectThere(filter->GetOutput(), "PoissonSolution", 0.0);
  ExpectThere(filter->GetOutput(), "Cell", -1.0);
}

TEST(OtherCells, ArePassedOnByBiharmonicDistances)
{
  vtkSmartPointer<vtkPolyData> surface = MakeMixedSurface();
  vtkNew<vtkBiharmonicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSourceIds({ 9, 17 });
  filter->SetNumberOfEigenvalues(12);
  ExpectSuccess(filter);
  ExpectPassedOn(surface, filter->GetOutput());
  ExpectThere(filter->GetOutput(), "BiharmonicDistance", std::numeric_limits<double>::quiet_NaN());
  filter->SetUnreachedValue(-2.0);
  ExpectSuccess(filter);
  ExpectThere(filter->GetOutput(), "BiharmonicDistance", -2.0);
}

TEST(OtherCells, ArePassedOnByEarthMovers)
{
  vtkSmartPointer<vtkPolyData> surface = MakeMixedSurface();
  std::vector<double> from(39, 0.0);
  std::vector<double> to(39, 0.0);
  from[9] = 1.0;
  to[25] = 1.0;
  AddArray(surface->GetPointData(), "from", from, 1);
  AddArray(surface->GetPointData(), "to", to, 1);
  vtkNew<vtkSurfaceEarthMoversDistance> filter;
  filter->SetInputData(surface);
  filter->SetFromArrayName("from");
  filter->SetToArrayName("to");
  ExpectSuccess(filter);
  ExpectPassedOn(surface, filter->GetOutput());
  ExpectThere(filter->GetOutput(), "EarthMoversPotential", 0.0);
  vtkDataArray* flow = filter->GetOutput()->GetCellData()->GetArray("EarthMoversFlow");
  ASSERT_NE(flow, nullptr);
  ASSERT_EQ(flow->GetNumberOfTuples(), 26);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    EXPECT_EQ(flow->GetTuple3(cell)[0], 0.0);
    EXPECT_EQ(flow->GetTuple3(cell)[1], 0.0);
  }
}

TEST(OtherCells, AreLeftOutByVectorGraphicsButForTheirPoints)
{
  vtkSmartPointer<vtkPolyData> surface = MakeMixedSurface();
  GraphicsFixture drawing = MakeTwoAcross();
  AddArray(drawing.OfCells(), "LeftColor", { 1, 0.5, 0, 1, 0.5, 0 }, 3);
  AddArray(drawing.OfCells(), "RightColor", { 0, 0.5, 1, 0, 0.5, 1 }, 3);
  drawing.Filter->SetInputData(surface);
  drawing.Filter->SetBackgroundColor(0.25, 0.5, 0.75);
  vtkPolyData* output = drawing.Run();
  EXPECT_EQ(output->GetNumberOfVerts(), 0);
  EXPECT_EQ(output->GetNumberOfLines(), 0);
  EXPECT_EQ(output->GetNumberOfPolys(), output->GetNumberOfCells());
  EXPECT_EQ(output->GetCellData()->GetArray("number")->GetRange(0)[0], 2.0);
  const std::vector<double> components = GetValues(output, "Component");
  vtkDataArray* net = output->GetFieldData()->GetArray("NetSource");
  for (vtkIdType i = 35; i < 39; ++i)
  {
    EXPECT_EQ(output->GetPoint(i)[0], 10.0 + static_cast<double>(i - 35));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(output->GetPointData()->GetArray("Colors")->GetComponent(i, c), 0.25 * (c + 1));
      EXPECT_EQ(net->GetComponent(static_cast<vtkIdType>(components[i]), c), 0.0);
    }
    for (vtkIdType k = 35; k < i; ++k)
    {
      EXPECT_NE(components[k], components[i]); // one of its own
    }
  }
}

/// A square of 10 x 10 squashed to a strip of relative height 1e-8, where rounding leaves nothing.
TEST(ThinSurfaces, AreRefused)
{
  vtkSmartPointer<vtkPolyData> surface = MakeGrid(10, 10, GridCells::Triangles);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, p[0], 1e-8 * p[1], p[2]);
  }
  const char* const said = "triangles are too thin";
  vtkNew<vtkDiscreteGreensFunction> greens;
  greens->SetInputData(surface);
  greens->SetSourceIds({ 24 });
  ExpectError(greens, { said });
  for (const bool isExact : { false, true })
  {
    vtkNew<vtkBiharmonicDistance> biharmonic;
    biharmonic->SetInputData(surface);
    biharmonic->SetSourceIds({ 0 });
    biharmonic->SetMethod(isExact ? vtkBiharmonicDistance::Exact : vtkBiharmonicDistance::Spectrum);
    ExpectError(biharmonic, { said });
  }
  vtkNew<vtkHarmonicBSpline> splines;
  splines->SetInputData(surface);
  splines->SetNumberOfSites(8);
  ExpectError(splines, { said });
}
