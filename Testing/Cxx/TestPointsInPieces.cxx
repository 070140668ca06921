// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Samples and probes that several processes compute together. Run under mpiexec; a single process
/// is valid, too.
#include "PieceGraphFixture.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicProbe.h"
#include "vtkGeodesicSampler.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace dggtest;

namespace
{
/// A case of a filter; the message of a process is that of a single one.
template <typename Filter>
struct FilterCase
{
  const char* Name;
  std::function<void(Filter*)> Prepare;
};

/// Returns the values of an array, with a number in place of NaN; empty without an array.
std::vector<double> GetNumbers(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      const double value = array->GetComponent(i, k);
      values.push_back(std::isnan(value) ? -1e300 : value);
    }
  }
  return values;
}

/// Expects that points and point arrays are equal, bit by bit.
void ExpectSamePoints(vtkPolyData* output, vtkPolyData* expected)
{
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfVerts(), expected->GetNumberOfVerts());
  vtkPointData* data = output->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), expected->GetPointData()->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(GetNumbers(data->GetArray(i)),
      GetNumbers(expected->GetPointData()->GetArray(data->GetArrayName(i))))
      << data->GetArrayName(i);
  }
  if (output->GetNumberOfPoints() > 0)
  {
    EXPECT_EQ(output->GetPoints()->GetDataType(), expected->GetPoints()->GetDataType());
    EXPECT_EQ(
      GetNumbers(output->GetPoints()->GetData()), GetNumbers(expected->GetPoints()->GetData()));
  }
}

class PointsInPieces : public DividedSurface
{
protected:
  /// Two terrains, with two components.
  const vtkSmartPointer<vtkPolyData> Terrains = Beside(MakeTerrain(20), MakeTerrain(15), 2.0);

  /// Returns points in cells, on edges and at points, one of which several processes have.
  vtkSmartPointer<vtkPolyData> MakePoints() const
  {
    const auto points = MakePointsOfCells(this->Terrains);
    const vtkIdType shared =
      FindSharedPoint(this->Terrains, this->GetParam().Label(this->Terrains, this->Count));
    for (const vtkIdType id : { shared, this->Terrains->GetNumberOfPoints() - 3 })
    {
      points->GetPoints()->InsertNextPoint(this->Terrains->GetPoint(id));
    }
    return points;
  }

  /// Updates a filter on all processes, with pieces that must not be gathered. Expects the outputs
  /// and messages of a single process. Returns the filter.
  template <typename Filter>
  vtkSmartPointer<Filter> ExpectSame(
    vtkPolyData* piece, vtkPolyData* surface, const std::function<void(Filter*)>& prepare)
  {
    vtkNew<Filter> alone;
    alone->SetController(nullptr);
    alone->SetInputData(surface);
    prepare(alone);
    const Listener expected(alone);
    alone->Update();
    auto together = vtkSmartPointer<Filter>::New();
    together->SetInputData(piece);
    together->SetGatherLimit(1);
    prepare(together);
    const Listener listener(together);
    this->Update(together);
    EXPECT_EQ(StripAddresses(listener.Errors), StripAddresses(expected.Errors));
    EXPECT_EQ(StripAddresses(listener.Warnings),
      this->IsFirst() ? StripAddresses(expected.Warnings) : std::vector<std::string>());
    ExpectSamePoints(
      together->GetOutput(), this->IsFirst() ? alone->GetOutput() : vtkNew<vtkPolyData>().Get());
    return together;
  }
};
}

//------------------------------------------------------------------------------
/// Samples, messages and covering radii are those of a single process.
TEST_P(PointsInPieces, SamplesAreTheSame)
{
  const auto piece = this->TakePiece(this->Terrains);
  const auto points = this->MakePoints();
  using F = vtkGeodesicSampler;
  const FilterCase<F> cases[] = {
    { "Automatic", [](F* filter) { filter->SetNumberOfSamples(40); } },
    { "FirstSample",
      [](F* filter) {
        filter->SetFirstSample(77);
        filter->SetNumberOfSamples(40);
      } },
    { "CoveringRadius",
      [](F* filter) {
        filter->SetCoveringRadius(0.3);
        filter->SetNumberOfSamples(1000);
      } },
    { "Start",
      [&](F* filter) {
        filter->SetStartData(points);
        filter->SetNumberOfSamples(50);
      } },
    { "MoreComponentsThanSamples", [](F* filter) { filter->SetNumberOfSamples(1); } },
    { "MoreSamplesThanPoints", [](F* filter) { filter->SetNumberOfSamples(1000); } },
    { "FirstSampleOutOfRange", [](F* filter) { filter->SetFirstSample(625); } },
    { "DistantStart",
      [](F* filter) {
        filter->SetStartData(MakeSourcePoints({ { { 0.5, 0.5, 9.0 } } }));
      } },
    { "SquaredDistanceOverflows",
      [](F* filter) {
        filter->SetStartData(MakeSourcePoints({ { { 0.5, 0.5, 1e200 } } }));
      } },
    { "DistantStarts",
      [](F* filter) {
        filter->SetStartData(MakeSourcePoints({ { { 0.5, 0.5, 9.0 } }, { { 0.5, 0.5, 1e200 } } }));
      } },
    { "LargestTolerance",
      [](F* filter) {
        filter->SetStartData(MakeSourcePoints({ { { 0.5, 0.5, 1e200 } } }));
        filter->SetProjectionTolerance(std::numeric_limits<double>::max());
      } },
    { "NoStart", [](F* filter) { filter->SetStartData(vtkNew<vtkPolyData>()); } },
  };
  for (const FilterCase<F>& tested : cases)
  {
    SCOPED_TRACE(tested.Name);
    this->ExpectSame<F>(piece, this->Terrains, [&](F* filter) {
      filter->SetAccuracy(0.1);
      tested.Prepare(filter);
    });
  }
}

//------------------------------------------------------------------------------
/// Probed distances and messages are those of a single process.
TEST_P(PointsInPieces, ProbedDistancesAreTheSame)
{
  const auto search = [&](auto* filter) {
    filter->SetAccuracy(0.1);
    filter->SetInputData(1, this->MakeSources());
    filter->SetMaximumDistance(0.8);
    filter->SetUnreachedValue(-1.0);
    filter->GenerateVirtualSourceOn();
  };
  const auto alone = Alone<vtkDGGDistance>(this->Terrains, search);
  const auto distance = this->Together<vtkDGGDistance>(this->TakePiece(this->Terrains), search);
  const auto points = this->MakePoints();
  const auto distant = MakeSourcePoints({ { { 0.5, 0.5, 9.0 } } });
  using F = vtkGeodesicProbe;
  const FilterCase<F> cases[] = {
    { "Points", [&](F* filter) { filter->SetProbeData(points); } },
    { "OnePoint", [&](F* filter) { filter->SetProbeData(this->MakeSources()); } },
    { "DistantPoint", [&](F* filter) { filter->SetProbeData(distant); } },
    { "DistantPointWithinTolerance",
      [&](F* filter) {
        filter->SetProbeData(distant);
        filter->SetProjectionTolerance(10.0);
      } },
    { "NoPoint", [](F* filter) { filter->SetProbeData(vtkNew<vtkPolyData>()); } },
    { "NoInput", [](F*) {} },
  };
  for (const FilterCase<F>& tested : cases)
  {
    SCOPED_TRACE(tested.Name);
    this->ExpectSame<F>(distance->GetOutput(), alone->GetOutput(), [&](F* filter) {
      filter->SetUnreachedValue(-1.0);
      tested.Prepare(filter);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, PointsInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });

//------------------------------------------------------------------------------
/// An abort or a failure of one process ends the update of all, and the next update gives the
/// points of a single process.
TEST_F(PieceGraph, PointsAfterFailures)
{
  const auto expectPoints = [&](auto* filter, auto* expected) {
    this->ExpectRecovery(filter, { 0.2, 0.5 }, [&] {
      ExpectSamePoints(
        filter->GetOutput(), this->IsFirst() ? expected->GetOutput() : vtkNew<vtkPolyData>().Get());
    });
  };
  const auto piece = this->TakeStrip(this->Surface, PartIds::Global);
  const auto sample = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetNumberOfSamples(30);
  };
  const auto samples = Alone<vtkGeodesicSampler>(this->Surface, sample);
  const auto sampler = this->Together<vtkGeodesicSampler>(piece, sample);
  expectPoints(sampler.Get(), samples.Get());
  EXPECT_EQ(this->Sum(sampler->GetNumberOfGraphEdges()), samples->GetNumberOfGraphEdges());
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceIds({ 5 });
    filter->GenerateVirtualSourceOn();
  };
  const auto probe = [&](auto* filter) { filter->SetProbeData(MakePointsOfCells(this->Surface)); };
  const auto distances = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance = this->Together<vtkDGGDistance>(piece, search);
  expectPoints(this->Together<vtkGeodesicProbe>(distance->GetOutput(), probe).Get(),
    Alone<vtkGeodesicProbe>(distances->GetOutput(), probe).Get());
}

//------------------------------------------------------------------------------
/// Surfaces are gathered if samples may be in faces, if points name cells, or if distances have no
/// virtual sources.
TEST_F(PieceGraph, PointsThatAreGathered)
{
  const auto piece = this->TakeStrip(this->Surface, PartIds::Global);
  const auto expectSame = [&](auto* together, auto* alone) {
    ExpectSamePoints(
      together->GetOutput(), this->IsFirst() ? alone->GetOutput() : vtkNew<vtkPolyData>().Get());
  };
  const auto first =
    Alone<vtkGeodesicSampler>(this->Surface, [](auto* filter) { filter->SetNumberOfSamples(5); });
  for (const bool inFaces : { false, true })
  {
    const auto sample = [&](auto* filter) {
      filter->SetNumberOfSamples(20);
      filter->SetInFaces(inFaces);
      filter->SetStartData(inFaces ? nullptr : first->GetOutput());
    };
    const auto samples = Alone<vtkGeodesicSampler>(this->Surface, sample);
    const auto sampler = this->Together<vtkGeodesicSampler>(piece, sample);
    expectSame(sampler.Get(), samples.Get());
    EXPECT_EQ(
      sampler->GetNumberOfGraphEdges(), this->IsFirst() ? samples->GetNumberOfGraphEdges() : 0);
  }
  const auto search = [](auto* filter) { filter->SetSourceIds({ 5 }); };
  const auto probe = [](auto* filter) { filter->SetProbeData(MakeSources()); };
  const auto distances = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance = this->Together<vtkDGGDistance>(piece, search);
  expectSame(this->Together<vtkGeodesicProbe>(distance->GetOutput(), probe).Get(),
    Alone<vtkGeodesicProbe>(distances->GetOutput(), probe).Get());
}
