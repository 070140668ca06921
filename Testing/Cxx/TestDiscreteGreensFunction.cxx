// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The values of vtkDiscreteGreensFunction: closed forms, symmetry, components, boundaries,
/// options. Thin surfaces, which all filters of the Laplacian refuse.
#include "GraphTestTools.h"
#include "SpectralTestTools.h"

#include "vtkBiharmonicDistance.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkHarmonicBSpline.h"

#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Returns the relative L2 error on the unit sphere within an angle of the source.
double ErrorOnSphere(vtkPolyData* sphere, const std::vector<double>& values,
  const std::array<double, 3>& source, double within)
{
  const std::vector<double> areas = GetPointAreas(sphere);
  double difference = 0.0;
  double size = 0.0;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double cosine = CosineOf(sphere->GetPoint(i), source.data());
    if (cosine < 1.0 - 1e-9 && cosine > std::cos(within))
    {
      const double expected = SphereGreens(cosine);
      difference += areas[i] * (values[i] - expected) * (values[i] - expected);
      size += areas[i] * expected * expected;
    }
  }
  return std::sqrt(difference / size);
}
}

TEST(DiscreteGreensFunction, SphereByEveryMethod)
{
  Fixture sphere(MakeSphere(4));
  const std::array<double, 3> inside = PointInCell(sphere.Surface, 777, { 0.2, 0.3, 0.5 });
  sphere.Filter->AddSourceId(7);
  sphere.Filter->SetSourceData(MakeSourcePoints({ inside }));
  std::array<double, 3> atPoint;
  sphere.Surface->GetPoint(7, atPoint.data());
  const std::vector<double> areas = GetPointAreas(sphere.Surface);
  double errors[4];
  for (int method = 0; method < 4; ++method)
  {
    sphere.Filter->SetMethod(method);
    ExpectSuccess(sphere.Filter);
    vtkDataArray* array = sphere.Filter->GetOutput()->GetPointData()->GetScalars();
    ASSERT_NE(array, nullptr);
    EXPECT_STREQ(array->GetName(), Name);
    EXPECT_EQ(array->GetNumberOfComponents(), 2);
    for (int source = 0; source < 2; ++source)
    {
      EXPECT_EQ(sphere.Filter->GetUsedMethod(source), method);
      double mean = 0.0;
      for (std::size_t i = 0; i < areas.size(); ++i)
      {
        mean += areas[i] * sphere.Values(source)[i] / 12.5;
      }
      EXPECT_NEAR(mean, 0.0, 1e-3);
    }
    EXPECT_LT(ErrorOnSphere(sphere.Surface, sphere.Values(0), atPoint, 4.0), 2e-2);
    errors[method] = ErrorOnSphere(sphere.Surface, sphere.Values(1), inside, 0.25);
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_LT(20.0 * errors[0], errors[2]);
  EXPECT_LT(errors[1], 1.5 * errors[2]);
  EXPECT_LT(1.5 * errors[2], errors[3]);
  EXPECT_EQ(sphere.Filter->GetNumberOfFactorizations(), 1);
  EXPECT_EQ(sphere.Filter->GetUsedMethod(2), -1);
  EXPECT_EQ(sphere.Filter->GetUsedRadius(-1), 0.0);
}

TEST(DiscreteGreensFunction, EvaluationPointsSeeTheLogarithm)
{
  Fixture sphere(MakeSphere(4));
  const std::array<double, 3> source = PointInCell(sphere.Surface, 500, { 0.4, 0.35, 0.25 });
  sphere.Filter->SetSourceData(MakeSourcePoints({ source }));
  Points places;
  places.push_back(PointInCell(sphere.Surface, 500, { 0.5, 0.35, 0.15 })); // in the same face
  places.push_back(PointInCell(sphere.Surface, 501, { 0.2, 0.2, 0.6 }));
  for (vtkIdType cell = 0; cell < 5000; cell += 123)
  {
    places.push_back(PointInCell(sphere.Surface, cell, { 0.1, 0.3, 0.6 }));
  }
  std::array<double, 3> corner;
  sphere.Surface->GetPoint(33, corner.data());
  places.push_back(corner);
  auto points = MakeSourcePoints(places);
  vtkNew<vtkIntArray> marks;
  marks->SetName("Mark");
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    marks->InsertNextValue(static_cast<int>(k));
  }
  points->GetPointData()->AddArray(marks);
  sphere.Filter->SetEvaluationData(points);
  ExpectSuccess(sphere.Filter);
  vtkPolyData* evaluation = sphere.Filter->GetEvaluation();
  ASSERT_EQ(evaluation->GetNumberOfPoints(), static_cast<vtkIdType>(places.size()));
  EXPECT_TRUE(evaluation->GetPointData()->HasArray("Mark"));
  const std::vector<double> values = sphere.Evaluated();
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    // The expected value uses the chord, because the points lie slightly inside the sphere.
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      square += (places[k][axis] - source[axis]) * (places[k][axis] - source[axis]);
    }
    EXPECT_NEAR(values[k], SphereGreens(1.0 - 0.5 * square), 4e-3) << k;
  }
  EXPECT_NEAR(values.back(), sphere.Values()[33], 1e-12);
  // Linear interpolation does not represent the pole.
  sphere.Filter->SetMethodToInterpolated();
  ExpectSuccess(sphere.Filter);
  EXPECT_GT(std::abs(sphere.Evaluated()[0] - values[0]), 0.05);
}

TEST(DiscreteGreensFunction, ZeroOnADirichletBoundary)
{
  Fixture grid(MakeGrid(24, 24));
  grid.Filter->SetBoundaryToDirichlet();
  grid.Filter->AddSourceId(12 * 25 + 12);
  // In a face next to a corner of the boundary; the largest barycentric coordinate belongs to that
  // corner.
  grid.Filter->SetSourceData(MakeSourcePoints({ { 6.3, 0.2, 0.0 }, { 10.25, 11.5, 0.0 } }));
  for (int method = 0; method < 4; ++method)
  {
    grid.Filter->SetMethod(method);
    Listener listener(grid.Filter); // not all methods can be used so close to the boundary
    grid.Filter->Update();
    EXPECT_EQ(listener.Errors.size(), 0u);
    for (int source = 0; source < 3; ++source)
    {
      const std::vector<double> values = grid.Values(source);
      double largest = 0.0;
      for (vtkIdType i = 0; i < 625; ++i)
      {
        const bool isOnRim = i % 25 == 0 || i % 25 == 24 || i / 25 == 0 || i / 25 == 24;
        EXPECT_TRUE(!isOnRim || std::abs(values[i]) < 1e-12) << i << " " << values[i];
        largest = std::max(largest, values[i]);
      }
      EXPECT_GT(largest, 0.03) << method << " " << source;
    }
  }
}

TEST(DiscreteGreensFunction, NothingReachesOtherParts)
{
  auto sphere = MakeSphere(3);
  auto pair = Beside(sphere, MakeGrid(20, 20), 5.0);
  pair->GetPoints()->InsertNextPoint(50.0, 0.0, 0.0); // no polygon uses this point
  Fixture parts(pair);
  const vtkIdType n = sphere->GetNumberOfPoints();
  parts.Filter->SetSourceIds({ 3, n + 220 });
  parts.Filter->SetEvaluationData(MakeSourcePoints({ { 0.0, 0.0, 1.0 }, { 8.5, 4.25, 0.0 } }));
  for (int method = 0; method < 4; ++method)
  {
    parts.Filter->SetMethod(method);
    ExpectSuccess(parts.Filter);
    for (vtkIdType i = 0; i < pair->GetNumberOfPoints(); ++i)
    {
      const bool isAlone = i == pair->GetNumberOfPoints() - 1;
      EXPECT_EQ(parts.Values(0)[i] == 0.0, i >= n) << i;
      EXPECT_EQ(parts.Values(1)[i] == 0.0, i < n || isAlone) << i;
    }
    EXPECT_NE(parts.Evaluated(0)[0], 0.0);
    EXPECT_EQ(parts.Evaluated(0)[1], 0.0);
    EXPECT_EQ(parts.Evaluated(1)[0], 0.0);
    EXPECT_NE(parts.Evaluated(1)[1], 0.0);
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
  ExpectWarning(sphere.Filter, { "2 of the 2 sources", "too coarse" });
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
