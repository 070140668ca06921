// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkBiharmonicDistance: closed forms, agreement of the methods, reuse between updates, invalid
/// input.
#include "SpectralTestTools.h"

#include "vtkBiharmonicDistance.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace dggtest;

namespace
{
constexpr const char* Name = "BiharmonicDistance";

/// The filter on a surface, with one source.
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

/// Returns the biharmonic distance on the unit sphere, by Legendre polynomials.
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
    Fixture sphere(MakeSphere(3), 7);
    sphere.Filter->SetMethod(method);
    ExpectSuccess(sphere.Filter);
    const std::vector<double> values = sphere.Values();
    EXPECT_EQ(values[7], 0.0);
    double source[3];
    sphere.Surface->GetPoint(7, source);
    for (vtkIdType i = 0; i < sphere.Surface->GetNumberOfPoints(); ++i)
    {
      const double expected = SphereBiharmonic(CosineOf(sphere.Surface->GetPoint(i), source));
      EXPECT_NEAR(values[i] * values[i], expected * expected, 5e-3) << i;
    }
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

TEST(BiharmonicDistance, OtherPartsAreNotReached)
{
  auto sphere = MakeSphere(2);
  Fixture pair(Beside(sphere, sphere, 4.0), 3);
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
  ExpectError(terrain.Filter, { "Source 1", "vertex 100" });
  EXPECT_EQ(terrain.Filter->GetNumberOfSpectra(), 0); // reported before any spectrum is computed
}

// Filters share surfaces, so a surface that is used again is the same object. After a failure in
// between, its solver is a new object; no reference to the previous solver may remain.
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
