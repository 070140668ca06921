// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkBiharmonicDistance: closed forms, methods that agree, what is kept, wrong input.
#include "SpectralTestTools.h"

#include "vtkBiharmonicDistance.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace dggtest;

namespace
{
constexpr const char* Name = "BiharmonicDistance";

/// A filter on a surface, with one source.
struct Fixture
{
  explicit Fixture(vtkPolyData* surface, vtkIdType source = 0)
    : Surface(surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->AddSourceId(source);
  }
  std::vector<double> Values(int source = 0)
  {
    return GetValues(this->Filter->GetOutput(), Name, source);
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkBiharmonicDistance> Filter;
};

/// On the unit sphere, by Legendre polynomials.
double SphereBiharmonic(double cosine)
{
  double square = 0.0;
  double previous = 1.0;
  double legendre = cosine;
  for (int l = 1; l < 2000; ++l)
  {
    const double eigenvalue = static_cast<double>(l) * (l + 1);
    square += (2 * l + 1) / (2.0 * vtkMath::Pi()) * (1.0 - legendre) / (eigenvalue * eigenvalue);
    const double next = ((2 * l + 1) * cosine * legendre - l * previous) / (l + 1);
    previous = legendre;
    legendre = next;
  }
  return std::sqrt(square);
}
}

TEST(BiharmonicDistance, SphereByBothMethods)
{
  for (const int method : { vtkBiharmonicDistance::Spectrum, vtkBiharmonicDistance::Exact })
  {
    double previous = 0.0;
    for (const int level : { 2, 3 })
    {
      Fixture sphere(MakeSphere(level), 7);
      sphere.Filter->SetMethod(method);
      ExpectSuccess(sphere.Filter);
      const std::vector<double> values = sphere.Values();
      EXPECT_EQ(values[7], 0.0);
      double source[3];
      sphere.Surface->GetPoint(7, source);
      double largest = 0.0; // of the errors of squares, which are sums of smooth functions
      for (vtkIdType i = 0; i < sphere.Surface->GetNumberOfPoints(); ++i)
      {
        const double expected = SphereBiharmonic(CosineOf(sphere.Surface->GetPoint(i), source));
        largest = std::max(largest, std::abs(values[i] * values[i] - expected * expected));
      }
      EXPECT_TRUE(level == 2 || previous > 2.5 * largest) << previous << " " << largest;
      previous = largest;
    }
    EXPECT_LT(previous, 5e-3);
  }
}

TEST(BiharmonicDistance, EvaluationPointsAreAsPointsOfTheSurface)
{
  Fixture sphere(MakeSphere(3), 7);
  double place[3];
  sphere.Surface->GetPoint(200, place);
  sphere.Filter->SetSourceData(
    MakeSourcePoints({ PointInCell(sphere.Surface, 99, { 0.2, 0.3, 0.5 }) }));
  sphere.Filter->SetEvaluationData(MakeSourcePoints({ { place[0], place[1], place[2] } }));
  for (const int kind : { vtkBiharmonicDistance::Biharmonic, vtkBiharmonicDistance::CommuteTime })
  {
    sphere.Filter->SetKind(kind);
    for (const int method : { vtkBiharmonicDistance::Spectrum, vtkBiharmonicDistance::Exact })
    {
      sphere.Filter->SetMethod(method);
      ExpectSuccess(sphere.Filter);
      for (int source = 0; source < 2; ++source)
      {
        const std::vector<double> there = GetValues(sphere.Filter->GetEvaluation(), Name, source);
        ASSERT_EQ(there.size(), 1u);
        EXPECT_NEAR(there[0], sphere.Values(source)[200], 1e-7);
      }
    }
  }
}

TEST(BiharmonicDistance, DiffusionForgetsWithTime)
{
  Fixture sphere(MakeSphere(3), 7);
  sphere.Filter->SetKindToDiffusion();
  std::vector<double> previous;
  for (const double time : { 0.02, 0.1, 0.5 })
  {
    sphere.Filter->SetDiffusionTime(time);
    ExpectSuccess(sphere.Filter);
    const std::vector<double> values = sphere.Values();
    for (std::size_t i = 0; i < previous.size(); ++i)
    {
      EXPECT_LT(values[i], previous[i] + 1e-12);
    }
    previous = values;
  }
  EXPECT_EQ(sphere.Filter->GetNumberOfSpectra(), 1);
  EXPECT_GT(*std::max_element(previous.begin(), previous.end()), 0.01);
}

TEST(BiharmonicDistance, OtherPartsAreNotReached)
{
  auto sphere = MakeSphere(2);
  Fixture pair(MakePair(sphere, sphere, 4.0), 3);
  const std::size_t n = static_cast<std::size_t>(sphere->GetNumberOfPoints());
  for (const int method : { vtkBiharmonicDistance::Spectrum, vtkBiharmonicDistance::Exact })
  {
    pair.Filter->SetMethod(method);
    pair.Filter->SetUnreachedValue(std::numeric_limits<double>::quiet_NaN());
    ExpectSuccess(pair.Filter);
    for (std::size_t i = 0; i < 2 * n; ++i)
    {
      EXPECT_EQ(std::isnan(pair.Values()[i]), i >= n);
    }
    pair.Filter->SetUnreachedValue(-1.0);
    ExpectSuccess(pair.Filter);
    EXPECT_EQ(pair.Values()[n + 1], -1.0);
  }
}

/// Distances on a small sphere are those of a large one, scaled.
TEST(BiharmonicDistance, SmallPartsHaveEigenvaluesOfTheirOwn)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->SetRadius(1.0);
  sphere->Update();
  const vtkIdType n = sphere->GetOutput()->GetNumberOfPoints();
  ASSERT_EQ(n, 530);
  auto small = vtkSmartPointer<vtkPolyData>::New();
  small->DeepCopy(sphere->GetOutput());
  for (vtkIdType i = 0; i < n; ++i)
  {
    double p[3];
    small->GetPoint(i, p);
    small->GetPoints()->SetPoint(i, 0.1 * p[0], 0.1 * p[1], 0.1 * p[2]);
  }
  Fixture pair(MakePair(sphere->GetOutput(), small, 4.0), 7);
  pair.Filter->SetSourceIds({ 7, n + 7 });
  std::vector<double> exact;
  for (const int method : { vtkBiharmonicDistance::Exact, vtkBiharmonicDistance::Spectrum })
  {
    pair.Filter->SetMethod(method);
    ExpectSuccess(pair.Filter);
    const std::vector<double> large = pair.Values(0);
    const std::vector<double> found = pair.Values(1);
    EXPECT_NEAR(*std::max_element(found.begin() + n, found.end()), 0.051, 1e-3);
    exact = exact.empty() ? found : exact;
    for (vtkIdType i = n; i < 2 * n; ++i)
    {
      EXPECT_NEAR(found[i], 0.1 * large[i - n], 1e-6) << i;
      EXPECT_NEAR(found[i], exact[i], 0.0015) << i;
    }
    EXPECT_EQ(pair.Filter->GetNumberOfSpectra(), method == vtkBiharmonicDistance::Spectrum);
  }
}

TEST(BiharmonicDistance, KeepsWhatItCan)
{
  Fixture terrain(MakeTerrain(25), 100);
  const auto expectSpectra = [&](int count, int factorizations) {
    ExpectSuccess(terrain.Filter);
    EXPECT_EQ(terrain.Filter->GetNumberOfSpectra(), count);
    EXPECT_EQ(terrain.Filter->GetNumberOfFactorizations(), factorizations);
  };
  expectSpectra(1, 1);
  terrain.Filter->SetSourceIds({ 3, 4, 5 });
  expectSpectra(1, 1);
  terrain.Filter->SetKindToCommuteTime();
  expectSpectra(1, 1);
  const std::vector<double> kept = terrain.Values();
  terrain.Filter->SetNumberOfEigenvalues(50);
  expectSpectra(2, 1);
  terrain.Filter->SetBoundaryToDirichlet();
  terrain.Filter->SetSourceIds({ 100, 101 });
  expectSpectra(3, 2);
  Fixture fresh(terrain.Surface, 3);
  fresh.Filter->SetKindToCommuteTime();
  ExpectSuccess(fresh.Filter);
  EXPECT_EQ(fresh.Values(), kept);
}

TEST(BiharmonicDistance, SourcesWithoutFacesAreNamed)
{
  Fixture terrain(MakeTerrain(10), 50);
  terrain.Filter->SetMethodToSpectrum();
  auto* surface = vtkPolyData::SafeDownCast(terrain.Filter->GetInput());
  const vtkIdType lone = surface->GetPoints()->InsertNextPoint(0.5, 0.5, 5.0);
  surface->Modified();
  terrain.Filter->SetSourceIds({ 50, lone });
  ExpectError(terrain.Filter, { "source 1: vertex 100 has no face" });
  EXPECT_EQ(terrain.Filter->GetNumberOfSpectra(), 0); // said at once
}

TEST(BiharmonicDistance, WrongProperties)
{
  Fixture terrain(MakeTerrain(10), 50);
  terrain.Filter->SetKindToDiffusion();
  terrain.Filter->SetMethodToExact();
  ExpectError(terrain.Filter, { "diffusion", "SetMethodToSpectrum()" });
  terrain.Filter->SetMethodToSpectrum();
  for (const double time : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    terrain.Filter->SetDiffusionTime(time);
    ExpectError(terrain.Filter, { "DiffusionTime" });
  }
  terrain.Filter->SetDiffusionTime(0.0);
  terrain.Filter->SetNumberOfEigenvalues(0);
  ExpectError(terrain.Filter, { "NumberOfEigenvalues" });
  terrain.Filter->SetNumberOfEigenvalues(10);
  terrain.Filter->SetSourceIds({ 100 });
  ExpectError(terrain.Filter, { "source id 100" });
  terrain.Filter->SetSourceIds({ 50 });
  terrain.Filter->SetMemoryLimit(1000);
  ExpectError(terrain.Filter, { "MemoryLimit" });
  terrain.Filter->SetMemoryLimit(0);
  ExpectSuccess(terrain.Filter);
  vtkNew<vtkPolyData> none;
  terrain.Filter->SetInputData(none);
  ExpectWarning(terrain.Filter, { "empty" });
  std::ostringstream os;
  terrain.Filter->Print(os);
  EXPECT_NE(os.str().find("Kind: Diffusion"), std::string::npos);
}

TEST(BiharmonicDistance, ProgressGrowsAndStops)
{
  Fixture terrain(MakeTerrain(35), 100);
  terrain.Filter->SetSourceIds({ 100, 200, 300, 400 });
  for (const int method : { vtkBiharmonicDistance::Spectrum, vtkBiharmonicDistance::Exact })
  {
    terrain.Filter->SetMethod(method);
    ExpectProgressAndStops(terrain.Filter, { 0.05, 0.9 }, [&] { return terrain.Values(3); });
  }
}

// Filters share surfaces, so one that comes back is the very same. The solver is not, after a
// failure in between: nothing may refer to the one before.
TEST(BiharmonicDistance, SurfaceThatComesBackHasANewSolver)
{
  const auto sphere = MakeSphere(2);
  const auto other = MakeSphere(3);
  Fixture keeps(sphere);
  ExpectSuccess(keeps.Filter);
  Fixture distance(sphere);
  ExpectSuccess(distance.Filter);
  const std::vector<double> expected = distance.Values();
  distance.Filter->SetInputData(other);
  distance.Filter->SetMemoryLimit(1000);
  ExpectError(distance.Filter, { "MemoryLimit" });
  distance.Filter->SetMemoryLimit(0);
  distance.Filter->SetInputData(sphere);
  ExpectSuccess(distance.Filter);
  EXPECT_EQ(distance.Values(), expected);
}
