// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkBiharmonicDistance: closed forms, agreement of the methods, reuse between updates, invalid
/// input.
#include "SpectralTestTools.h"

#include "vtkBiharmonicDistance.h"

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

}

TEST(BiharmonicDistance, EvaluationPointsAreAsPointsOfTheSurface)
{
  Fixture sphere(MakeSphere(3), 7);
  double place[3];
  sphere.Surface->GetPoint(200, place);
  sphere.Filter->SetEvaluationData(MakeSourcePoints({ { place[0], place[1], place[2] } }));
  std::vector<double> found;
  for (const int method : { vtkBiharmonicDistance::Spectrum, vtkBiharmonicDistance::Exact })
  {
    sphere.Filter->SetMethod(method);
    ExpectSuccess(sphere.Filter);
    const std::vector<double> there = GetValues(sphere.Filter->GetEvaluation(), Name);
    ASSERT_EQ(there.size(), 1u);
    EXPECT_NEAR(there[0], sphere.Values()[200], 1e-7);
    EXPECT_EQ(sphere.Values()[7], 0.0);
    found.push_back(there[0]);
  }
  EXPECT_NEAR(found[0], found[1], 5e-3);
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

TEST(BiharmonicDistance, OtherComponentsHaveTheUnreachedValue)
{
  const auto sphere = MakeSphere(2);
  Fixture pair(Beside(sphere, sphere, 4.0), 3);
  pair.Filter->SetUnreachedValue(-1.0);
  ExpectSuccess(pair.Filter);
  EXPECT_EQ(pair.Values().back(), -1.0);
}
