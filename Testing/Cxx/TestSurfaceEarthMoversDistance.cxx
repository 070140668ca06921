// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkSurfaceEarthMoversDistance: known distances, flows, several representations of distributions,
/// components, reuse between updates.
#include "SpectralTestTools.h"

#include "vtkSurfaceEarthMoversDistance.h"

using namespace dggtest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// The filter on a surface, with the arrays "from" and "to".
struct Fixture
{
  explicit Fixture(vtkPolyData* surface)
    : Surface(surface)
  {
    this->Filter->SetInputData(surface);
  }
  Fixture(vtkPolyData* surface, const std::vector<double>& from, const std::vector<double>& to)
    : Fixture(surface)
  {
    AddArray(surface->GetPointData(), "from", from);
    AddArray(surface->GetPointData(), "to", to);
    this->Filter->SetFromArrayName("from");
    this->Filter->SetToArrayName("to");
  }
  double Distance()
  {
    ExpectSuccess(this->Filter);
    const double distance = this->Field("EarthMoversDistance");
    EXPECT_EQ(distance, this->Filter->GetDistance());
    EXPECT_EQ(this->Field("EarthMoversLowerBound"), this->Filter->GetLowerBound());
    EXPECT_LE(this->Filter->GetLowerBound(), distance * (1.0 + 1e-9));
    return distance;
  }
  double Field(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetFieldData()->GetArray(name);
    return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : NaN;
  }
  vtkDataArray* Flow() { return this->Filter->GetOutput()->GetCellData()->GetVectors(); }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkSurfaceEarthMoversDistance> Filter;
};

/// Returns densities around a position, in double precision.
std::vector<double> Bump(vtkPolyData* surface, double x, double y, double width)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    const double square = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y);
    values.push_back(std::exp(-square / (width * width)));
  }
  return values;
}

/// Returns masses at the end of a strip of the given height, four units in total. All mass leaves
/// or reaches the end along straight lines.
std::vector<double> EndOfStrip(vtkPolyData* strip, double x, double height)
{
  std::vector<double> masses;
  for (vtkIdType i = 0; i < strip->GetNumberOfPoints(); ++i)
  {
    const double* p = strip->GetPoint(i);
    const double weight = p[1] == 0.0 || p[1] == height ? 0.5 : 1.0;
    masses.push_back(p[0] == x ? weight : 0.0);
  }
  return masses;
}
}

TEST(SurfaceEarthMoversDistance, FlowAlongAStripIsStraight)
{
  for (const GridCells cells : { GridCells::Triangles, GridCells::Quads, GridCells::Strips })
  {
    auto strip = MakeGrid(12, 4, cells);
    Fixture moved(strip, EndOfStrip(strip, 0.0, 4.0), EndOfStrip(strip, 12.0, 4.0));
    moved.Filter->SetArrayMeaningToMass();
    moved.Filter->NormalizeOff();
    EXPECT_NEAR(moved.Distance(), 4.0 * 12.0, 0.05);
    EXPECT_NEAR(moved.Filter->GetLowerBound(), 4.0 * 12.0, 0.05);
    // Four units of mass cross a width of four.
    vtkDataArray* flow = moved.Flow();
    ASSERT_NE(flow, nullptr);
    ASSERT_EQ(flow->GetNumberOfTuples(), strip->GetNumberOfCells());
    ASSERT_STREQ(flow->GetName(), "EarthMoversFlow");
    for (vtkIdType c = 0; c < flow->GetNumberOfTuples(); ++c)
    {
      const double* vector = flow->GetTuple3(c);
      EXPECT_NEAR(vector[0], 1.0, 0.02) << c;
      EXPECT_NEAR(vector[1], 0.0, 0.02) << c;
      EXPECT_EQ(vector[2], 0.0) << c;
    }
    const std::vector<double> potential =
      GetValues(moved.Filter->GetOutput(), "EarthMoversPotential");
    ASSERT_EQ(potential.size(), static_cast<std::size_t>(strip->GetNumberOfPoints()));
    for (std::size_t i = 0; i < potential.size(); ++i)
    {
      EXPECT_NEAR(
        potential[i] - potential[0], -strip->GetPoint(static_cast<vtkIdType>(i))[0], 0.05);
    }
    moved.Filter->NormalizeOn();
    EXPECT_NEAR(moved.Distance(), 12.0, 0.0125);
    EXPECT_NEAR(moved.Flow()->GetComponent(0, 0), 0.25, 0.005);
  }
}

TEST(SurfaceEarthMoversDistance, DistributionsInSeveralWays)
{
  auto terrain = MakeTerrain(20);
  const std::vector<double> from = Bump(terrain, 0.3, 0.3, 0.15);
  const std::vector<double> to = Bump(terrain, 0.7, 0.5, 0.2);
  Fixture densities(terrain, from, to);
  const double expected = densities.Distance();
  EXPECT_GT(expected, 0.35);
  EXPECT_LT(expected, 0.7);
  // The same distributions as masses, which do not need to be normalized.
  const std::vector<double> areas = GetPointAreas(terrain);
  std::vector<double> fromMasses(from);
  std::vector<double> toMasses(to);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    fromMasses[i] *= 1e200 * areas[i];
    toMasses[i] *= 1e-200 * areas[i];
  }
  Fixture masses(MakeTerrain(20), fromMasses, toMasses);
  masses.Filter->SetArrayMeaningToMass();
  EXPECT_NEAR(masses.Distance(), expected, 1e-9);
  // Distributions as points with masses, and one half as an array.
  auto points = MakeSourcePoints({});
  points->SetPoints(terrain->GetPoints());
  for (double& mass : fromMasses)
  {
    mass *= 0.25e-200;
  }
  AddArray(points->GetPointData(), "half", fromMasses);
  for (double& mass : fromMasses)
  {
    mass *= 3.0;
  }
  Fixture both(MakeTerrain(20), fromMasses, toMasses);
  both.Filter->SetArrayMeaningToMass();
  both.Filter->SetFromData(points);
  both.Filter->SetMassArrayName("half");
  EXPECT_NEAR(both.Distance(), expected, 1e-9);
  // Without a name, each point has mass 1, which is another distribution.
  both.Filter->SetMassArrayName(nullptr);
  EXPECT_GT(std::abs(both.Distance() - expected), 0.01);
}

TEST(SurfaceEarthMoversDistance, PartsNeedTheSameMass)
{
  auto sphere = MakeSphere(2);
  const auto n = static_cast<std::size_t>(sphere->GetNumberOfPoints());
  Fixture single(sphere);
  single.Filter->SetFromData(MakeSourcePoints({ { 1.0, 0.0, 0.0 } }));
  single.Filter->SetToData(MakeSourcePoints({ { 0.0, 0.0, 1.0 } }));
  single.Filter->SetProjectionTolerance(0.1);
  const double expected = single.Distance();
  Fixture pair(Beside(sphere, sphere, 4.0));
  pair.Filter->SetProjectionTolerance(0.1);
  pair.Filter->SetFromData(MakeSourcePoints({ { 1.0, 0.0, 0.0 }, { 5.0, 0.0, 0.0 } }));
  pair.Filter->SetToData(MakeSourcePoints({ { 0.0, 0.0, 1.0 }, { 4.0, 0.0, 1.0 } }));
  EXPECT_NEAR(pair.Distance(), expected, 0.02 * expected);
  pair.Filter->NormalizeOff();
  EXPECT_NEAR(pair.Distance(), 2.0 * expected, 0.04 * expected);
  pair.Filter->SetToData(MakeSourcePoints({ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } }));
  ExpectError(pair.Filter, { "mass cannot move between components" });
  // Sums of single-precision values are accurate enough.
  std::vector<double> from(2 * n);
  std::vector<double> to(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
  {
    from[i] = 1.0 / 3.0 + static_cast<double>(i % 7);
    to[i] = 3e-8 * static_cast<double>(i % 5) + from[i];
  }
  AddArray<vtkFloatArray>(pair.Surface->GetPointData(), "from", from);
  AddArray<vtkFloatArray>(pair.Surface->GetPointData(), "to", to);
  Fixture floats(pair.Surface);
  floats.Filter->SetFromArrayName("from");
  floats.Filter->SetToArrayName("to");
  EXPECT_LT(floats.Distance(), 1e-6);
}

TEST(SurfaceEarthMoversDistance, MassesOfMergedPointsAreAdded)
{
  // Two halves of a strip with separate points along their common line x = 6.
  auto strip = Beside(MakeGrid(6, 4), MakeGrid(6, 4), 6.0);
  Fixture moved(strip, EndOfStrip(strip, 0.0, 4.0), EndOfStrip(strip, 6.0, 4.0));
  moved.Filter->SetArrayMeaningToMass();
  moved.Filter->MergeCoincidentPointsOn();
  EXPECT_NEAR(moved.Distance(), 6.0, 0.0125);
  moved.Filter->NormalizeOff();
  ExpectError(moved.Filter, { "has the mass 4 and the second one 8" });
}

TEST(SurfaceEarthMoversDistance, OtherTrianglesHaveNoFlow)
{
  auto terrain = MakeTerrain(20);
  Fixture moved(terrain, Bump(terrain, 0.3, 0.3, 0.15), Bump(terrain, 0.7, 0.5, 0.2));
  const double expected = moved.Distance();
  EXPECT_NE(moved.Flow(), nullptr);
  moved.Filter->IntrinsicDelaunayOn();
  EXPECT_NEAR(moved.Distance(), expected, 0.01 * expected);
  EXPECT_EQ(moved.Flow(), nullptr);
  EXPECT_EQ(moved.Filter->GetNumberOfFactorizations(), 2);
  // The input is unchanged.
  EXPECT_EQ(terrain->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(terrain->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(terrain->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(SurfaceEarthMoversDistance, KeepsActiveArraysOfTheInput)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(2);
  const auto n = static_cast<std::size_t>(sphere->GetNumberOfPoints());
  AddArray(sphere->GetPointData(), "temperature", std::vector<double>(n, 3.0));
  sphere->GetPointData()->SetActiveScalars("temperature");
  AddArray(
    sphere->GetCellData(), "wind", std::vector<double>(3 * sphere->GetNumberOfCells(), 1.0), 3);
  sphere->GetCellData()->SetActiveVectors("wind");
  std::vector<double> from(n, 0.0);
  std::vector<double> to(n, 0.0);
  from[0] = 1.0;
  to[5] = 1.0;
  Fixture fixture(sphere, from, to);
  fixture.Distance();
  vtkPolyData* output = fixture.Filter->GetOutput();
  EXPECT_TRUE(output->GetPointData()->HasArray("temperature"));
  EXPECT_TRUE(output->GetCellData()->HasArray("wind"));
  ASSERT_TRUE(output->GetPointData()->GetScalars());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "EarthMoversPotential");
  ASSERT_TRUE(output->GetCellData()->GetVectors());
  EXPECT_STREQ(output->GetCellData()->GetVectors()->GetName(), "EarthMoversFlow");
}

TEST(SurfaceEarthMoversDistance, KeepsTheFactorization)
{
  auto terrain = MakeTerrain(20);
  Fixture moved(terrain, Bump(terrain, 0.3, 0.3, 0.15), Bump(terrain, 0.7, 0.5, 0.2));
  EXPECT_EQ(moved.Filter->GetMemorySize(), 0u);
  const double there = moved.Distance();
  moved.Filter->SetFromArrayName("to");
  EXPECT_EQ(moved.Distance(), 0.0);
  moved.Filter->SetToArrayName("from");
  EXPECT_NEAR(moved.Distance(), there, 2e-3 * there);
  EXPECT_EQ(moved.Filter->GetNumberOfFactorizations(), 1);
  EXPECT_GT(moved.Filter->GetMemorySize(), 1000u);
  moved.Filter->SetInputData(MakeTerrain(5));
  ExpectError(moved.Filter, { "no point array 'to'" });
  EXPECT_TRUE(std::isnan(moved.Filter->GetDistance()));
  EXPECT_TRUE(std::isnan(moved.Filter->GetLowerBound()));
}

TEST(SurfaceEarthMoversDistance, CopiesOfTrianglesHaveTheirFlow)
{
  auto surface = MakeGrid(5, 4);
  const vtkIdType m = surface->GetNumberOfPolys();
  Fixture once(surface, Bump(surface, 0.0, 0.0, 1.0), Bump(surface, 4.0, 3.0, 1.0));
  const double distance = once.Distance();
  auto twice = MakeGrid(5, 4);
  for (vtkIdType cell = 0; cell < m; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    twice->GetPolys()->GetCellAtId(cell, size, ids);
    const vtkIdType copy[3] = { ids[2], ids[1], ids[0] };
    twice->GetPolys()->InsertNextCell(3, copy);
  }
  Fixture doubled(twice, Bump(twice, 0.0, 0.0, 1.0), Bump(twice, 4.0, 3.0, 1.0));
  ExpectWarning(doubled.Filter, { "on the same three points as an earlier one" });
  EXPECT_EQ(doubled.Filter->GetDistance(), distance);
  for (vtkIdType cell = 0; cell < m; ++cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(doubled.Flow()->GetComponent(cell, axis), once.Flow()->GetComponent(cell, axis));
      EXPECT_EQ(
        doubled.Flow()->GetComponent(cell + m, axis), once.Flow()->GetComponent(cell, axis));
    }
  }
}

// Tolerances below rounding error count as rounding error: no warning reports an open gap.
TEST(SurfaceEarthMoversDistance, AnySmallToleranceIsReached)
{
  auto surface = MakeGrid(5, 4);
  Fixture fixture(surface, Bump(surface, 0.0, 0.0, 1.0), Bump(surface, 4.0, 3.0, 1.0));
  fixture.Filter->SetTolerance(0.0);
  fixture.Distance();
  EXPECT_LE(fixture.Filter->GetGap(), 1e-8);
}
