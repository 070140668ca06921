// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Filters that search the same graph share search data, and give the same results as a single
/// filter.
#include "../Benchmark/MemoryProbe.h"
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"
#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
/// Lower bounds of the size of tables (measured: 64 to 66) and landmarks, bytes per vertex.
constexpr double BytesOfTables = 55.0;
constexpr double BytesOfLandmarks = 68.0;
/// Lower bound of the size of the table that links points, bytes per vertex: a crossing and an
/// angle for each of six half-edges.
constexpr double BytesOfBuilder = 6 * 72.0;

class SharedGraph : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Holder->SetInputData(this->Surface); // shares the surface: its memory is not measured
    this->Holder->AddSourceId(0);
    ExpectSuccess(this->Holder);
  }

  vtkSmartPointer<vtkDGGDistance> MakeDistance(vtkIdType source) const
  {
    auto filter = vtkSmartPointer<vtkDGGDistance>::New();
    filter->SetInputData(this->Surface);
    filter->AddSourceId(source);
    return filter;
  }

  vtkSmartPointer<vtkDGGPath> MakePath(vtkIdType pairs) const
  {
    auto filter = vtkSmartPointer<vtkDGGPath>::New();
    filter->SetInputData(this->Surface);
    filter->StraightenOff();
    for (vtkIdType i = 0; i < pairs; ++i)
    {
      filter->AddPair(7 * i, this->Surface->GetNumberOfPoints() - 1 - 5 * i);
    }
    return filter;
  }

  struct Memory
  {
    double Peak;
    double Growth;
  };
  static Memory Measure(vtkAlgorithm* filter)
  {
    const MemoryProbe probe;
    ExpectSuccess(filter);
    return { static_cast<double>(probe.GetHeapPeak()), static_cast<double>(probe.GetHeapGrowth()) };
  }

  static std::vector<double> GetCoordinates(vtkPolyData* paths)
  {
    std::vector<double> coordinates;
    for (vtkIdType i = 0; i < paths->GetNumberOfPoints(); ++i)
    {
      const double* p = paths->GetPoint(i);
      coordinates.insert(coordinates.end(), p, p + 3);
    }
    return coordinates;
  }

  vtkSmartPointer<vtkPolyData> Surface = MakeSurfaceWithGraph(MakeTerrain(100), 0.05);
  vtkNew<vtkExactGeodesicDistance> Holder;
  const double Size = static_cast<double>(Surface->GetNumberOfPoints());
};
}

TEST_F(SharedGraph, TheSecondFilterMakesNoTables)
{
  const auto first = this->MakeDistance(5);
  const auto second = this->MakeDistance(5);
  const Memory alone = Measure(first);
  const Memory shared = Measure(second);
  if (alone.Growth > 0.0) // otherwise memory cannot be measured
  {
    EXPECT_LT(shared.Growth, alone.Growth - BytesOfTables * this->Size);
    EXPECT_LT(shared.Peak, alone.Peak - BytesOfTables * this->Size);
  }
  EXPECT_EQ(GetDistances(first), GetDistances(second));
}

TEST_F(SharedGraph, AChainHasOneGraph)
{
  const auto first = this->MakeDistance(5);
  const auto second = this->MakeDistance(9);
  second->SetInputConnection(first->GetOutputPort());
  second->SetDistanceArrayName("Second");
  const Memory alone = Measure(first);
  const Memory shared = Measure(second);
  if (alone.Growth > 0.0)
  {
    EXPECT_LT(shared.Growth, alone.Growth - BytesOfTables * this->Size);
  }
}

TEST_F(SharedGraph, PointsAreLinkedByOneBuilder)
{
  const auto first = this->MakeDistance(5);
  const auto second = this->MakeDistance(5);
  for (const auto& filter : { first, second })
  {
    ExpectSuccess(filter);
    filter->SetProjectionTolerance(1.0);
    filter->SetSourceData(MakeSourcePoints({ { { 0.51, 0.53, 0.1 } } }));
  }
  const Memory alone = Measure(first);
  const Memory shared = Measure(second);
  if (alone.Growth > 0.0)
  {
    EXPECT_LT(shared.Peak, alone.Peak - BytesOfBuilder * this->Size);
  }
  EXPECT_EQ(GetDistances(first), GetDistances(second));
}

TEST_F(SharedGraph, LandmarksAreFoundOnce)
{
  const auto first = this->MakePath(300);
  const auto second = this->MakePath(300);
  const Memory alone = Measure(first);
  const Memory shared = Measure(second);
  if (alone.Growth > 0.0)
  {
    EXPECT_LT(shared.Growth, alone.Growth - (BytesOfTables + BytesOfLandmarks) * this->Size);
  }
  EXPECT_EQ(GetCoordinates(first->GetOutput()), GetCoordinates(second->GetOutput()));
}

/// Landmarks of other filters do not affect a filter with few pairs.
TEST_F(SharedGraph, AnswersDoNotDependOnOthers)
{
  const auto alone = this->MakePath(20);
  ExpectSuccess(alone);
  const auto many = this->MakePath(300);
  ExpectSuccess(many);
  const auto later = this->MakePath(20);
  ExpectSuccess(later);
  EXPECT_EQ(GetCoordinates(alone->GetOutput()), GetCoordinates(later->GetOutput()));
  EXPECT_EQ(alone->GetMemorySize(), later->GetMemorySize());
  EXPECT_GE(static_cast<double>(many->GetMemorySize() - later->GetMemorySize()),
    BytesOfLandmarks * this->Size);
}

/// The graph exists as long as any filter searches it, independent of the filter that built or
/// prepared it.
TEST_F(SharedGraph, OutlivesTheFirst)
{
  const auto second = this->MakeDistance(9);
  std::vector<double> expected;
  {
    const auto first = this->MakeDistance(9);
    ExpectSuccess(first);
    expected = GetDistances(first);
    ExpectSuccess(second);
  }
  this->Holder->SetInputData(MakeTerrain(5));
  ExpectSuccess(this->Holder);
  second->SetMaximumDistance(1e6);
  ExpectSuccess(second);
  EXPECT_EQ(GetDistances(second), expected);
}
