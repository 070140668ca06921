// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkDiscreteGreensFunction: arrays, methods used, evaluation points, properties, reuse between
/// updates, surfaces that are refused.
#include "GraphTestTools.h"
#include "SpectralTestTools.h"

#include "vtkDiscreteGreensFunction.h"

using namespace dggtest;

namespace
{
constexpr const char* Name = "GreensFunction";

/// The filter on a surface, without sources.
struct Fixture
{
  explicit Fixture(vtkPolyData* surface)
    : Surface(surface)
  {
    this->Filter->SetInputData(surface);
  }
  std::vector<double> Values(int source = 0)
  {
    return GetValues(this->Filter->GetOutput(), Name, source);
  }
  std::vector<double> Evaluated(int source = 0)
  {
    return GetValues(this->Filter->GetEvaluation(), Name, source);
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkDiscreteGreensFunction> Filter;
};

}

TEST(DiscreteGreensFunction, ReportsTheMethodsUsed)
{
  Fixture sphere(MakeSphere(4));
  sphere.Filter->AddSourceId(7);
  sphere.Filter->SetSourceData(
    MakeSourcePoints({ PointInCell(sphere.Surface, 777, { 0.2, 0.3, 0.5 }) }));
  std::array<double, 3> source;
  std::array<double, 3> target;
  sphere.Surface->GetPoint(7, source.data());
  sphere.Surface->GetPoint(300, target.data());
  const double expected = SphereGreens(CosineOf(source.data(), target.data()));
  for (int method = 0; method < 4; ++method)
  {
    sphere.Filter->SetMethod(method);
    ExpectSuccess(sphere.Filter);
    vtkDataArray* array = sphere.Filter->GetOutput()->GetPointData()->GetScalars();
    ASSERT_NE(array, nullptr);
    EXPECT_STREQ(array->GetName(), Name);
    EXPECT_EQ(array->GetNumberOfComponents(), 2);
    EXPECT_EQ(sphere.Filter->GetUsedMethod(0), method);
    EXPECT_EQ(sphere.Filter->GetUsedMethod(1), method);
    EXPECT_NEAR(sphere.Values()[300], expected, 5e-3);
  }
  EXPECT_EQ(sphere.Filter->GetNumberOfFactorizations(), 1);
  EXPECT_EQ(sphere.Filter->GetUsedMethod(2), -1);
  EXPECT_EQ(sphere.Filter->GetUsedRadius(-1), 0.0);
}

TEST(DiscreteGreensFunction, EvaluationPointsHaveValuesAndKeepTheirArrays)
{
  Fixture sphere(MakeSphere(4));
  sphere.Filter->SetSourceData(
    MakeSourcePoints({ PointInCell(sphere.Surface, 500, { 0.4, 0.35, 0.25 }) }));
  const std::array<double, 3> inside = PointInCell(sphere.Surface, 500, { 0.5, 0.35, 0.15 });
  std::array<double, 3> corner;
  sphere.Surface->GetPoint(33, corner.data());
  auto points = MakeSourcePoints({ inside, corner });
  AddArray(points->GetPointData(), "Mark", { 7, 8 });
  sphere.Filter->SetEvaluationData(points);
  ExpectSuccess(sphere.Filter);
  vtkPolyData* evaluation = sphere.Filter->GetEvaluation();
  ASSERT_EQ(evaluation->GetNumberOfPoints(), 2);
  EXPECT_TRUE(evaluation->GetPointData()->HasArray("Mark"));
  const std::vector<double> values = sphere.Evaluated();
  EXPECT_NEAR(values[1], sphere.Values()[33], 1e-12);
  // Linear interpolation does not represent the pole.
  sphere.Filter->SetMethodToInterpolated();
  ExpectSuccess(sphere.Filter);
  EXPECT_GT(std::abs(sphere.Evaluated()[0] - values[0]), 0.05);
}

TEST(DiscreteGreensFunction, IsZeroOnOtherComponents)
{
  const auto sphere = MakeSphere(2);
  Fixture pair(Beside(sphere, sphere, 5.0));
  const vtkIdType n = sphere->GetNumberOfPoints();
  pair.Filter->SetSourceIds({ 3 });
  pair.Filter->SetEvaluationData(MakeSourcePoints({ PointInCell(sphere, 9, { 0.2, 0.3, 0.5 }),
    PointInCell(pair.Surface, sphere->GetNumberOfCells() + 9, { 0.2, 0.3, 0.5 }) }));
  for (int method = 0; method < 4; ++method)
  {
    pair.Filter->SetMethod(method);
    ExpectSuccess(pair.Filter);
    for (vtkIdType i = 0; i < 2 * n; ++i)
    {
      EXPECT_EQ(pair.Values()[i] == 0.0, i >= n) << i;
    }
    EXPECT_NE(pair.Evaluated()[0], 0.0);
    EXPECT_EQ(pair.Evaluated()[1], 0.0);
  }
}

TEST(DiscreteGreensFunction, SignAndValueAtTheSource)
{
  Fixture sphere(MakeSphere(3));
  sphere.Filter->SetSourceIds({ 20 });
  std::array<double, 3> place;
  sphere.Surface->GetPoint(20, place.data());
  sphere.Filter->SetEvaluationData(MakeSourcePoints({ place }));
  ExpectSuccess(sphere.Filter);
  const std::vector<double> positive = sphere.Values();
  EXPECT_GT(positive[20], 0.3);
  EXPECT_EQ(sphere.Evaluated()[0], positive[20]);
  sphere.Filter->SetSignConventionToNegativeAtSource();
  ExpectSuccess(sphere.Filter);
  for (std::size_t i = 0; i < positive.size(); ++i)
  {
    EXPECT_EQ(sphere.Values()[i], -positive[i]);
  }
  sphere.Filter->SetPoleValueToInfinite();
  ExpectSuccess(sphere.Filter);
  EXPECT_EQ(sphere.Values()[20], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(sphere.Values()[21], -positive[21]);
  EXPECT_EQ(sphere.Evaluated()[0], -std::numeric_limits<double>::infinity());
  // The requested radius is used without reduction.
  sphere.Filter->SetRadius(0.7);
  ExpectSuccess(sphere.Filter);
  EXPECT_EQ(sphere.Filter->GetUsedRadius(0), 0.7);
  EXPECT_NEAR(sphere.Values()[300], -positive[300], 5e-3);
}

TEST(DiscreteGreensFunction, OneFactorizationForAllSources)
{
  Fixture terrain(MakeTerrain(25));
  terrain.Filter->SetSourceIds({ 110 });
  EXPECT_EQ(terrain.Filter->GetMemorySize(), 0u);
  ExpectSuccess(terrain.Filter);
  EXPECT_GT(terrain.Filter->GetMemorySize(), 0u);
  const std::vector<double> alone = terrain.Values();
  int expected = 1;
  const auto expectFactorizations = [&](int more) {
    ExpectSuccess(terrain.Filter);
    expected += more;
    EXPECT_EQ(terrain.Filter->GetNumberOfFactorizations(), expected);
  };
  terrain.Filter->SetSourceIds({ 301, 110, 302, 303, 304, 305, 306, 307, 308, 309 });
  expectFactorizations(0);
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    EXPECT_NEAR(terrain.Values(1)[i], alone[i], 1e-12);
  }
  terrain.Filter->SetMethodToInterpolated();
  expectFactorizations(0);
  terrain.Filter->SetBoundaryToDirichlet();
  expectFactorizations(1);
  terrain.Filter->IntrinsicDelaunayOn();
  expectFactorizations(1);
  terrain.Surface->GetPoints()->SetPoint(5, 0.21, -0.01, 0.3);
  terrain.Surface->GetPoints()->Modified();
  expectFactorizations(1);
  terrain.Filter->SetInputData(MakeSphere(2));
  terrain.Filter->SetBoundaryToNeumann();
  terrain.Filter->SetSourceIds({ 5 });
  expectFactorizations(1);
}

TEST(DiscreteGreensFunction, MemoryLimitCountsTheResults)
{
  Fixture terrain(MakeTerrain(20));
  terrain.Filter->AddSourceId(45);
  terrain.Filter->SetMemoryLimit(3000000);
  ExpectSuccess(terrain.Filter);
  for (int k = 0; k < 2000; ++k)
  {
    terrain.Filter->AddSourceId(k % 400);
  }
  ExpectError(terrain.Filter, { "MemoryLimit", "fewer sources" });
}

TEST(DiscreteGreensFunction, WarnsWhereAMethodCannotBeUsed)
{
  Fixture sphere(MakeSphere(0));
  sphere.Filter->SetSourceIds({ 3, 4 });
  ExpectWarning(sphere.Filter, { "2 of 2 sources", "too coarse" });
  EXPECT_EQ(sphere.Filter->GetUsedMethod(0), vtkDiscreteGreensFunction::Interpolated);
  EXPECT_EQ(sphere.Filter->GetUsedRadius(0), 0.0);
  // Ridges cause neither a change of the method nor a warning at many sources.
  Fixture terrain(MakeTerrain(16));
  int near = 0;
  for (vtkIdType id = 45; id < 95; ++id)
  {
    terrain.Filter->AddSourceId(id);
  }
  ExpectSuccess(terrain.Filter);
  for (int source = 0; source < 50; ++source)
  {
    near += terrain.Filter->IsNearRidge(source) ? 1 : 0;
  }
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 50);
}

/// A square of 10 x 10 squashed to a strip of relative height 1e-8, where only rounding error
/// remains.
TEST(DiscreteGreensFunction, RefusesThinSurfaces)
{
  vtkSmartPointer<vtkPolyData> surface = MakeGrid(10, 10, GridCells::Triangles);
  MovePoints(surface, [&](double* p) { p[1] *= 1e-8; });
  vtkNew<vtkDiscreteGreensFunction> greens;
  greens->SetInputData(surface);
  greens->SetSourceIds({ 24 });
  ExpectError(greens, { "triangles are too thin" });
}
