// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkPoissonVectorGraphics: invalid and degenerate input, colors of any magnitude, memory,
/// progress.
#include "LoopTestTools.h"
#include "VectorGraphicsTestTools.h"

using namespace dggtest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

GraphicsFixture MakeTwoColored()
{
  GraphicsFixture drawing = MakeTwoAcross();
  AddArray(drawing.OfCells(), "LeftColor", { 1, 2 }, 1);
  AddArray(drawing.OfCells(), "RightColor", { 3, 4 }, 1);
  return drawing;
}
}

TEST(PoissonVectorGraphics, WrongCurves)
{
  GraphicsFixture drawing = MakeTwoAcross();
  auto* filter = drawing.Filter.Get();
  ExpectError(filter, { "line 0 of input port 1", "'LeftColor'" });
  AddArray(drawing.OfCells(), "LeftColor", { 1, 2 }, 1);
  ExpectError(filter, { "'RightColor'" });
  AddArray(drawing.OfCells(), "RightColor", { 1, 2, 3, 4 }, 2);
  ExpectError(filter, { "'LeftColor'", "1 component,", "'RightColor' has 2" });
  AddArray(drawing.OfCells(), "RightColor", { 1 }, 1);
  ExpectError(filter, { "'RightColor'", "1 tuple.", "with 2 tuples" });
  for (const double wrong : { NaN, std::numeric_limits<double>::infinity() })
  {
    AddArray(drawing.OfCells(), "RightColor", { 1, wrong }, 1);
    ExpectError(filter, { "'RightColor'", "at cell 1", "finite" });
  }
  AddArray(drawing.OfCells(), "RightColor", { 3, 4 }, 1);
  for (const double wrong : { -1.0, 4.0, 0.5, NaN })
  {
    AddArray(drawing.OfCells(), "CurveType", { 0, wrong }, 1);
    ExpectError(filter, { "line 1", "type", "'CurveType'" });
  }
  AddArray(drawing.OfCells(), "CurveType", { 0, 1 }, 1);
  ExpectError(filter, { "line 1", "'Strength'" });
  AddArray(drawing.OfCells(), "Strength", { 0, 1 }, 1);
  AddArray(drawing.OfCells(), "CurveType", { 0, 9, 1, 9 }, 2);
  ExpectError(filter, { "'CurveType'", "2 components" });
  AddArray(drawing.OfCells(), "CurveType", { 0, 1 }, 1);
  for (const double wrong : { 0.0, -1.0 })
  {
    AddArray(drawing.OfCells(), "Width", { 0, wrong }, 1);
    ExpectError(filter, { "line 1", "width" });
  }
  for (const double wrong : { NaN, std::numeric_limits<double>::infinity() })
  {
    AddArray(drawing.OfCells(), "Width", { 0, wrong }, 1);
    ExpectError(filter, { "'Width'", "at cell 1", "finite" });
  }
  AddArray(drawing.OfCells(), "Width", { 1 }, 1);
  ExpectError(filter, { "'Width'", "1 tuple.", "with 2 tuples" });
  AddArray(drawing.OfCells(), "Width", { 1, 1, 1, 1 }, 2);
  ExpectError(filter, { "'Width'", "2 components" });
  AddArray(drawing.OfCells(), "Width", { 0, 1 }, 1);
  drawing.Run();
  AddArray(drawing.OfCells(), "CurveType", { 0, 2 }, 1);
  ExpectError(filter, { "line 1 of input port 1", "open" });
  AddArray(drawing.OfCells(), "CurveType", { 0, 0 }, 1);
  drawing.Curves->GetPoints()->SetPoint(2, 1, 1, 3.0);
  drawing.Curves->GetPoints()->Modified();
  ExpectError(filter, { "curve point 2, at (", "ProjectionTolerance" });
  drawing.Curves->GetPoints()->SetPoint(2, 1, NaN, 0.0);
  drawing.Curves->GetPoints()->Modified();
  ExpectError(filter, { "point 2", "finite" });
  drawing.Curves->GetPoints()->SetPoint(2, 4, 4, 0.0); // coincides with the end of the curve
  drawing.Curves->GetPoints()->Modified();
  ExpectError(filter, { "line 1 of input port 1", "no length" });
  drawing.Curves->SetLines(MakeCells({ { 1 } }));
  ExpectError(filter, { "line 0", "no length" });
  drawing.Curves->SetLines(nullptr);
  ExpectError(filter, { "nothing to draw", "input port 1", "RegionArrayName" });
  filter->SetRegionArrayName("region");
  ExpectError(filter, { "'region'", "RegionArrayName" });
  AddArray(drawing.Surface->GetCellData(), "region", std::vector<double>(24, 1.0), 1);
  ExpectError(filter, { "'RegionStrength'", "RegionStrengthArrayName" });
}

TEST(PoissonVectorGraphics, SurfacesWithoutSides)
{
  GraphicsFixture drawing = MakeTwoColored();
  auto* filter = drawing.Filter.Get();
  // A page attached to the square along a line that a curve crosses: edges of three triangles.
  vtkSmartPointer<vtkPolyData> book = MakeSurface(
    { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 4, 0 }, { 0, 4, 0 }, { 0, 2, 0 }, { 6, 2, 0 }, { 3, 2, 5 } },
    { { 0, 1, 5, 4 }, { 4, 5, 2, 3 }, { 4, 5, 6 } });
  filter->SetInputData(book);
  ExpectError(
    filter, { "line 0 of input port 1", "1 edge of more than two faces", "oriented manifold" });
  EXPECT_EQ(filter->GetMemorySize(), 0u); // no state remains after a failure
  // A curve on a Moebius band: sides are undefined across the seam, but defined elsewhere.
  Points points;
  Cells cells;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.25 * vtkMath::Pi() * i;
    for (const double s : { -0.4, 0.4 })
    {
      const double r = 2.0 + s * std::cos(0.5 * angle);
      points.push_back({ r * std::cos(angle), r * std::sin(angle), s * std::sin(0.5 * angle) });
    }
    const vtkIdType a = 2 * i;
    i < 7 ? cells.push_back({ a, a + 2, a + 3, a + 1 }) : cells.push_back({ a, 1, 0, a + 1 });
  }
  vtkSmartPointer<vtkPolyData> band = MakeSurface(points, cells);
  vtkNew<vtkPolyData> around;
  vtkNew<vtkPoints> places;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.25 * vtkMath::Pi() * i;
    places->InsertNextPoint(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
  }
  around->SetPoints(places);
  around->SetLines(MakeCells({ { 0, 1, 2, 3, 4, 5, 6, 7, 0 } }));
  AddArray(around->GetCellData(), "LeftColor", { 1 }, 1);
  AddArray(around->GetCellData(), "RightColor", { 2 }, 1);
  filter->SetInputData(band);
  filter->SetCurveData(around);
  ExpectError(filter, { "opposite orientations", "one-sided" });
}

TEST(PoissonVectorGraphics, NumbersOfCellsAreChecked)
{
  GraphicsFixture drawing = MakeTwoColored();
  std::vector<double> numbers(24, 0.0);
  numbers[7] = NaN;
  AddArray(drawing.Surface->GetCellData(), "Refine", numbers, 1);
  drawing.Filter->SetRefinementRegionToCells();
  ExpectError(drawing.Filter, { "'Refine'", "cell 7" });
  AddArray(drawing.Surface->GetCellData(), "Part", numbers, 1);
  AddArray(drawing.Surface->GetCellData(), "RegionStrength", std::vector<double>(24, 1.0), 1);
  drawing.Filter->SetRegionArrayName("Part");
  ExpectError(drawing.Filter, { "'Part'", "no number", "cell 7" });
}

TEST(PoissonVectorGraphics, MemoryIsCheckedEarlyAndAlways)
{
  GraphicsFixture drawing = MakeTwoColored();
  auto* filter = drawing.Filter.Get();
  filter->SetRefinementLevel(3);
  drawing.Run();
  const vtkTypeUInt64 kept = filter->GetMemorySize();
  // A cached factorization must not exceed the limit either.
  filter->SetMemoryLimit(kept);
  ExpectError(filter, { "MemoryLimit" });
  filter->SetMemoryLimit(0);
  drawing.Run();
  EXPECT_EQ(filter->GetNumberOfFactorizations(), 1);
  // No memory is kept after an update that did not fit into the limit.
  filter->SetMemoryLimit(kept / 2);
  filter->SetRefinementLevel(4);
  ExpectError(filter, { "MemoryLimit" });
  EXPECT_EQ(filter->GetMemorySize(), 0u);
  // Memory is released wherever the update was refused.
  filter->SetRefinementLevel(3);
  for (const double part : { 0.2, 0.4, 0.6, 0.8, 1.0 })
  {
    filter->SetMemoryLimit(static_cast<vtkTypeInt64>(part * static_cast<double>(kept)));
    ExpectError(filter, { "MemoryLimit" });
    EXPECT_EQ(filter->GetMemorySize(), 0u) << part;
  }
}

TEST(PoissonVectorGraphics, WidthsAreThoseOfFirstPoints)
{
  GraphicsFixture drawing({ { 3, 0, 0 }, { 3, 4, 0 } }, { { 0, 1 } });
  AddArray<vtkIntArray>(drawing.OfCells(), "CurveType", { 1 }, 1);
  AddArray(drawing.OfCells(), "Strength", { 1.0 }, 1);
  drawing.Filter->SetRefinementLevel(2);
  AddArray(drawing.OfCells(), "Width", { 1.25 }, 1);
  const std::vector<double> expected = GetValues(drawing.Run(), "Colors");
  drawing.OfCells()->RemoveArray("Width");
  AddArray(drawing.OfPoints(), "Width", { 1.25, 0.5 }, 1);
  EXPECT_EQ(GetValues(drawing.Run(), "Colors"), expected);
  AddArray(drawing.OfPoints(), "Width", { 0.5, 1.25 }, 1);
  EXPECT_NE(GetValues(drawing.Run(), "Colors"), expected);
  AddArray(drawing.OfPoints(), "Width", { 0.0, 1.25 }, 1);
  ExpectError(drawing.Filter, { "line 0 of input port 1", "width 0." }); // before drawing
}

TEST(PoissonVectorGraphics, ShortCurvesLoseTheirContrast)
{
  // Three curves of length 2: two open ones with a difference between their sides, and one without.
  GraphicsFixture drawing(
    { { 1, 1, 0 }, { 1, 3, 0 }, { 3, 1, 0 }, { 3, 3, 0 }, { 5, 1, 0 }, { 5, 3, 0 } },
    { { 0, 1 }, { 2, 3 }, { 4, 5 } });
  AddArray<vtkIntArray>(drawing.OfCells(), "CurveType", { 1, 1, 1 }, 1);
  AddArray(drawing.OfCells(), "Strength", { 0.3, 1.0, 1.0 }, 1);
  AddArray(drawing.OfCells(), "RightStrength", { -0.3, 0.0, 1.0 }, 1);
  // At the middles, the other side is at the distance 1 around an end.
  drawing.Filter->SetWidth(1.0);
  const std::vector<double> full = GetValues(drawing.Run(), "Colors");
  EXPECT_NEAR(*std::max_element(full.begin(), full.end()), 1.0, 0.05);
  drawing.Filter->SetWidth(2.0);
  ExpectWarning(
    drawing.Filter, { "Line 0 of input port 1", "width of 2", "at most 44 %", "1 other curve." });
  AddArray(drawing.OfCells(), "Width", { 1.0, 1e8, 1e8 }, 1);
  ExpectWarning(drawing.Filter, { "Line 1 of input port 1", "width of 1e+08", "at most 0 %" });
}

TEST(PoissonVectorGraphics, ClosedCurvesAreNotShort)
{
  // Around the tube of a torus. The way around the hole is shorter than the width.
  const auto torus = MakeTorus(24, 12);
  Points points;
  std::vector<vtkIdType> around;
  for (vtkIdType j = 0; j < 12; ++j)
  {
    points.emplace_back();
    torus->GetPoint(24 * j, points.back().data());
    around.push_back(j);
  }
  around.push_back(0);
  GraphicsFixture drawing(points, { around });
  drawing.Filter->SetInputData(torus);
  drawing.Filter->SetWidth(20.0);
  AddArray<vtkIntArray>(drawing.OfCells(), "CurveType", { 1 }, 1);
  AddArray(drawing.OfCells(), "Strength", { 1.0 }, 1);
  const std::vector<double> colors = GetValues(drawing.Run(), "Colors");
  EXPECT_LT(*std::max_element(colors.begin(), colors.end()), 0.5); // an open curve would warn
}

TEST(PoissonVectorGraphics, MemoryIsPredictedBeforeCurvesAreDrawn)
{
  // The refined mesh would exceed the limit. No progress is reported before the error, although
  // drawing curves would report some.
  GraphicsFixture drawing = MakeTwoColored();
  drawing.Filter->SetRefinementLevel(6);
  drawing.Filter->SetMemoryLimit(20 << 20);
  ProgressWatch watch(drawing.Filter);
  ExpectError(drawing.Filter, { "The refined mesh", "MemoryLimit", "RefinementLevel" });
  for (const double reported : watch.Progress)
  {
    EXPECT_TRUE(reported <= 0.1 + 1e-12 || reported == 1.0)
      << reported; // progress of the mesh, and at the end
  }
  // Refinement near curves respects the memory limit, too.
  drawing.Filter->SetRefinementRegionToNearCurves();
  ExpectError(drawing.Filter, { "refinement", "MemoryLimit", "RefinementLevel" });
  drawing.Filter->SetRefinementLevel(2);
  drawing.Run();
}

TEST(PoissonVectorGraphics, ScaleDoesNotMatter)
{
  std::vector<double> expected;
  for (const double scale : { 1.0, 1e-12, 1e12 })
  {
    GraphicsFixture drawing = MakeTwoColored();
    for (vtkPolyData* data : { drawing.Surface.Get(), drawing.Curves.Get() })
    {
      MovePoints(data, [&](double* p) {
        p[0] *= scale;
        p[1] *= scale;
        p[2] *= scale;
      });
    }
    const std::vector<double> colors = GetValues(drawing.Run(), "Colors");
    expected = expected.empty() ? colors : expected;
    ASSERT_EQ(colors.size(), expected.size());
    for (std::size_t i = 0; i < colors.size(); ++i)
    {
      EXPECT_NEAR(colors[i], expected[i], 1e-9) << scale;
    }
  }
}
