// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkPoissonVectorGraphics: known colors, and arrays of the output.
#include "VectorGraphicsTestTools.h"

using namespace dggtest;

TEST(PoissonVectorGraphics, ColorsBetweenTwoCurvesAreLinear)
{
  for (const bool isInBytes : { false, true })
  {
    for (const bool isOfCells : { false, true })
    {
      GraphicsFixture drawing = MakeTwoAcross();
      const std::vector<double> left = { 51, 0, 0, 255, 0, 102 };
      const std::vector<double> right = { 0, 255, 0, 0, 0, 255 };
      const auto add = [&](const std::string& name, std::vector<double> values) {
        for (double& value : values)
        {
          value = isInBytes ? value : value / 255.0;
        }
        if (!isOfCells) // two points each
        {
          values.insert(values.begin() + 3, values.begin(), values.begin() + 3);
          values.insert(values.end(), values.end() - 3, values.end());
        }
        vtkFieldData* data = isOfCells ? static_cast<vtkFieldData*>(drawing.OfCells())
                                       : static_cast<vtkFieldData*>(drawing.OfPoints());
        isInBytes ? AddArray<vtkUnsignedCharArray>(data, name, values, 3)
                  : AddArray(data, name, values, 3);
      };
      add("LeftColor", left);
      add("RightColor", right);
      vtkPolyData* output = drawing.Run();
      vtkDataArray* colors = output->GetPointData()->GetArray("Colors");
      ASSERT_EQ(colors->GetDataType(), VTK_DOUBLE);
      vtkDataArray* shown = output->GetPointData()->GetScalars();
      ASSERT_EQ(shown->GetDataType(), VTK_UNSIGNED_CHAR);
      ASSERT_STREQ(shown->GetName(), "RGB");
      for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
      {
        const double x = MiddleOfCell(output, cell);
        vtkNew<vtkIdList> corners;
        output->GetCellPoints(cell, corners);
        ASSERT_EQ(corners->GetNumberOfIds(), 3);
        for (int k = 0; k < 3; ++k)
        {
          const vtkIdType id = corners->GetId(k);
          const double t = (output->GetPoint(id)[0] - 1.5) / 2.5;
          for (int c = 0; c < 3; ++c)
          {
            const double expected = x < 1.5 ? left[c]
              : x > 4.0                     ? right[3 + c]
                                            : (1.0 - t) * right[c] + t * left[3 + c];
            EXPECT_NEAR(colors->GetComponent(id, c), expected / 255.0, 1e-9) << x;
            EXPECT_NEAR(shown->GetComponent(id, c), expected, 0.5 + 1e-6);
          }
        }
      }
      EXPECT_EQ(output->GetFieldData()->GetArray("NetSource")->GetNumberOfComponents(), 3);
    }
  }
}

TEST(PoissonVectorGraphics, DataOfTheSurfaceComeAlong)
{
  GraphicsFixture drawing = MakeTwoAcross();
  AddArray(drawing.OfCells(), "LeftColor", { 1, 2 }, 1);
  AddArray(drawing.OfCells(), "RightColor", { 3, 4 }, 1);
  std::vector<double> xs;
  for (vtkIdType i = 0; i < drawing.Surface->GetNumberOfPoints(); ++i)
  {
    xs.push_back(3.0 * drawing.Surface->GetPoint(i)[0] - drawing.Surface->GetPoint(i)[1]);
  }
  AddArray(drawing.Surface->GetPointData(), "linear", xs, 1);
  AddArray(drawing.Surface->GetPointData(), "broken", { 1, 2, 3 }, 1);
  std::vector<double> cells;
  for (vtkIdType i = 0; i < drawing.Surface->GetNumberOfCells(); ++i)
  {
    cells.push_back(std::floor(MiddleOfCell(drawing.Surface, i)));
  }
  AddArray(drawing.Surface->GetCellData(), "column", cells, 1);
  AddArray(drawing.Surface->GetFieldData(), "note", { 7 }, 1);
  for (const int level : { 0, 1, 2 })
  {
    drawing.Filter->SetRefinementLevel(level);
    vtkPolyData* output = drawing.Run();
    EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Colors"); // one channel
    EXPECT_EQ(output->GetFieldData()->GetArray("note")->GetComponent(0, 0), 7.0);
    EXPECT_EQ(output->GetPointData()->GetArray("broken"), nullptr);
    vtkDataArray* linear = output->GetPointData()->GetArray("linear");
    vtkDataArray* column = output->GetCellData()->GetArray("column");
    double area = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double* p = output->GetPoint(i);
      EXPECT_NEAR(linear->GetComponent(i, 0), 3.0 * p[0] - p[1], 1e-12);
    }
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(column->GetComponent(cell, 0), std::floor(MiddleOfCell(output, cell)));
      vtkNew<vtkIdList> ids;
      output->GetCellPoints(cell, ids);
      double p[3][3];
      for (int k = 0; k < 3; ++k)
      {
        output->GetPoint(ids->GetId(k), p[k]);
      }
      const double twice =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
      EXPECT_GT(twice, 0.0); // oriented as in the input
      area += 0.5 * twice;
    }
    EXPECT_NEAR(area, 24.0, 1e-9);
    EXPECT_GE(output->GetNumberOfCells(), 48 * (1 << (2 * level)));
  }
  drawing.Filter->SetRefinementLevel(3);
  drawing.Filter->SetRefinementRegionToNearCurves();
  const vtkIdType near = drawing.Run()->GetNumberOfCells();
  drawing.Filter->SetRefinementRegionToEverywhere();
  EXPECT_LT(near, drawing.Run()->GetNumberOfCells());
  // Only the last column is refined: triangles of other columns are not smaller than before.
  drawing.Filter->SetRefinementLevel(1);
  drawing.Filter->SetRefinementRegionToCells();
  ExpectError(drawing.Filter, { "'Refine'", "RefinementArrayName" });
  drawing.Filter->SetRefinementArrayName("");
  ExpectError(drawing.Filter, { "''", "RefinementArrayName" });
  for (double& cell : cells)
  {
    cell = cell == 5.0 ? 1.0 : 0.0;
  }
  AddArray(drawing.Surface->GetCellData(), "fine", cells, 1);
  drawing.Filter->SetRefinementArrayName("fine");
  const auto countColumn = [&](double number) {
    const std::vector<double> columns = [&] {
      std::vector<double> values;
      vtkDataArray* array = drawing.Run()->GetCellData()->GetArray("column");
      for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
      {
        values.push_back(array->GetComponent(cell, 0));
      }
      return values;
    }();
    return std::count(columns.begin(), columns.end(), number);
  };
  EXPECT_EQ(countColumn(5.0), 4 * 2 * 4);
  EXPECT_EQ(countColumn(2.0), 4 * 2);
  // A different selection changes the drawing.
  for (double& cell : cells)
  {
    cell = 1.0 - cell;
  }
  AddArray(drawing.Surface->GetCellData(), "fine", cells, 1);
  EXPECT_EQ(countColumn(2.0), 4 * 2 * 4);
}

TEST(PoissonVectorGraphics, RegionsOfCurvesAndCellsAreTheSame)
{
  GraphicsFixture byCurve(
    { { 1, 1, 0 }, { 4, 1, 0 }, { 4, 3, 0 }, { 1, 3, 0 } }, { { 0, 1, 2, 3, 0 } });
  AddArray<vtkIntArray>(byCurve.OfCells(), "CurveType", { 2 }, 1);
  AddArray(byCurve.OfCells(), "Strength", { 0.5, 0.25, 1.0 }, 3);
  GraphicsFixture byCells({ { 0, 0, 0 } }, {});
  byCells.Filter->SetCurveData(nullptr);
  std::vector<double> regions;
  std::vector<double> strengths;
  for (vtkIdType cell = 0; cell < byCells.Surface->GetNumberOfCells(); ++cell)
  {
    const double x = MiddleOfCell(byCells.Surface, cell);
    double bounds[6];
    byCells.Surface->GetCellBounds(cell, bounds);
    const bool isInside = x > 1.0 && x < 4.0 && bounds[2] >= 1.0 && bounds[3] <= 3.0;
    regions.push_back(isInside ? 3.0 : 0.0);
    const double strength[] = { 0.5, 0.25, 1.0 };
    for (const double number : strength)
    {
      strengths.push_back(isInside ? number : 0.0);
    }
  }
  AddArray(byCells.Surface->GetCellData(), "region", regions, 1);
  AddArray(byCells.Surface->GetCellData(), "RegionStrength", strengths, 3);
  byCells.Filter->SetRegionArrayName("region");
  vtkPolyData* outputs[] = { byCurve.Run(), byCells.Run() };
  ASSERT_EQ(outputs[0]->GetNumberOfPoints(), outputs[1]->GetNumberOfPoints());
  for (int c = 0; c < 3; ++c)
  {
    const std::vector<double> values[] = { GetValues(outputs[0], "Colors", c),
      GetValues(outputs[1], "Colors", c) };
    for (std::size_t i = 0; i < values[0].size(); ++i)
    {
      EXPECT_NEAR(values[0][i], values[1][i], 1e-12);
    }
    EXPECT_GT(*std::max_element(values[0].begin(), values[0].end()), c == 2 ? 0.5 : 0.1);
    for (vtkPolyData* output : outputs)
    {
      vtkDataArray* net = output->GetFieldData()->GetArray("NetSource");
      ASSERT_EQ(net->GetNumberOfTuples(), 1);
      EXPECT_NEAR(net->GetComponent(0, c), 0.0, 1e-12);
    }
  }
}

TEST(PoissonVectorGraphics, SourcesAreReported)
{
  GraphicsFixture drawing({ { 1, 2, 0 }, { 5, 2, 0 } }, { { 0, 1 } });
  AddArray<vtkIntArray>(drawing.OfCells(), "CurveType", { 3 }, 1);
  AddArray(drawing.OfPoints(), "Strength", { 1.0, 2.0 }, 1);
  EXPECT_NEAR(drawing.Run()->GetFieldData()->GetArray("NetSource")->GetComponent(0, 0), 6.0, 1e-12);
}

TEST(PoissonVectorGraphics, FactorizationIsKeptForOtherColors)
{
  GraphicsFixture drawing = MakeTwoAcross();
  auto* filter = drawing.Filter.Get();
  EXPECT_EQ(filter->GetMemorySize(), 0u);
  const auto valuesWith = [&](const std::vector<double>& right) {
    AddArray(drawing.OfCells(), "RightColor", right, 1);
    return GetValues(drawing.Run(), "Colors");
  };
  AddArray(drawing.OfCells(), "LeftColor", { 1, 2 }, 1);
  const std::vector<double> first = valuesWith({ 3, 4 });
  const std::vector<double> second = valuesWith({ 5, 6 });
  EXPECT_NE(first, second);
  EXPECT_EQ(valuesWith({ 3, 4 }), first);
  filter->SetBackgroundColor(1, 1, 1);
  drawing.Run();
  EXPECT_EQ(filter->GetNumberOfFactorizations(), 1);
  EXPECT_GT(filter->GetMemorySize(), 1000u);
  int expected = 1;
  const auto expectAnother = [&](const char* what) {
    drawing.Run();
    EXPECT_EQ(filter->GetNumberOfFactorizations(), ++expected) << what;
  };
  drawing.Curves->GetPoints()->SetPoint(2, 4.5, 0.0, 0.0);
  drawing.Curves->GetPoints()->Modified();
  expectAnother("places");
  filter->IntrinsicDelaunayOff();
  expectAnother("IntrinsicDelaunay");
  filter->SetRefinementLevel(2);
  expectAnother("RefinementLevel");
  filter->SetRefinementRegionToNearCurves();
  expectAnother("RefinementRegion");
  AddArray(drawing.OfCells(), "CurveType", { 0, 1 }, 1);
  AddArray(drawing.OfCells(), "Strength", { 0, 1 }, 1);
  expectAnother("types");
  drawing.Surface->GetPoints()->SetPoint(0, -0.5, 0.0, 0.0);
  drawing.Surface->GetPoints()->Modified();
  expectAnother("the surface");
  // The reused state gives the result of a new filter.
  vtkNew<vtkPoissonVectorGraphics> other;
  other->SetInputData(drawing.Surface);
  other->SetCurveData(drawing.Curves);
  other->IntrinsicDelaunayOff();
  other->SetRefinementLevel(2);
  other->SetRefinementRegionToNearCurves();
  other->SetBackgroundColor(1, 1, 1);
  ExpectSuccess(other);
  EXPECT_EQ(GetValues(filter->GetOutput(), "Colors"), GetValues(other->GetOutput(), "Colors"));
}

TEST(PoissonVectorGraphics, PointsKnowTheirComponents)
{
  // A curve across the whole square, which forms two components, and a point without a cell.
  GraphicsFixture drawing(
    { { 3, 0, 0 }, { 3, 4, 0 }, { 1, 1, 0 }, { 2, 1, 0 } }, { { 0, 1 }, { 2, 3 } });
  drawing.Surface->GetPoints()->InsertNextPoint(50.0, 0.0, 0.0);
  AddArray<vtkIntArray>(drawing.OfCells(), "CurveType", { 1, 3 }, 1);
  AddArray(drawing.OfCells(), "Strength", { 0.0, 2.0 }, 1);
  drawing.Filter->SetWidth(1.0);
  vtkPolyData* output = drawing.Run();
  vtkDataArray* net = output->GetFieldData()->GetArray("NetSource");
  vtkDataArray* components = output->GetPointData()->GetArray("Component");
  ASSERT_NE(components, nullptr);
  ASSERT_EQ(net->GetNumberOfTuples(), 2);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const bool isAlone = output->GetPoint(i)[0] > 40.0;
    EXPECT_NEAR(net->GetComponent(static_cast<vtkIdType>(components->GetComponent(i, 0)), 0),
      isAlone ? 0.0 : 2.0, 1e-12);
  }
}

TEST(PoissonVectorGraphics, OtherCellsAreLeftOutButForTheirPoints)
{
  // In addition to the square: a vertex, a line, and a point without a cell.
  GraphicsFixture drawing = MakeTwoAcross();
  vtkPolyData* surface = drawing.Surface;
  for (int i = 0; i < 4; ++i)
  {
    surface->GetPoints()->InsertNextPoint(10.0 + i, 1.0, 2.0);
  }
  surface->SetVerts(MakeCells({ { 35 } }));
  surface->SetLines(MakeCells({ { 36, 37 } }));
  std::vector<double> numbers(26);
  std::iota(numbers.begin(), numbers.end(), 0.0);
  AddArray(surface->GetCellData(), "number", numbers, 1);
  AddArray(drawing.OfCells(), "LeftColor", { 1, 0.5, 0, 1, 0.5, 0 }, 3);
  AddArray(drawing.OfCells(), "RightColor", { 0, 0.5, 1, 0, 0.5, 1 }, 3);
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
      EXPECT_NE(components[k], components[i]); // a separate component
    }
  }
}
