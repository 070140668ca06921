// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contract of all filters on surfaces: state, wrong input, threads, progress, caching, and
/// the graph that some of them search.
#include "FilterCases.h"
#include "GraphTestTools.h"
#include "PathTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace dggtest;

namespace
{
/// Everything that a filter puts out, as text.
std::string Describe(vtkGeodesicAlgorithm* filter, bool withFieldData = true)
{
  std::ostringstream os;
  os.precision(17);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (auto* surface = vtkPolyData::SafeDownCast(output))
    {
      os << DescribeGeometry(surface);
    }
    for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
    {
      const bool isDescribed = withFieldData || kind != vtkDataObject::FIELD;
      vtkFieldData* data = output->GetAttributesAsFieldData(kind);
      for (int a = 0; data && isDescribed && a < data->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = data->GetArray(a);
        os << data->GetArrayName(a);
        for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
        {
          os << " "
             << array->GetComponent(
                  i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
        }
        os << "\n";
      }
    }
  }
  return os.str();
}

class FilterContract : public ::testing::TestWithParam<FilterCase>
{
protected:
  /// Returns the filter on a relief with the given number of edges along each side.
  vtkSmartPointer<vtkGeodesicAlgorithm> Make(int n = 8)
  {
    this->Relief = MakeRelief(VTK_DOUBLE, n);
    return this->GetParam().Make(this->Relief);
  }

  vtkSmartPointer<vtkPolyData> Relief;
};

/// Filters that search a graph: what makes them work on the relief, and points on port 1.
void Prepare(vtkDGGDistance* filter)
{
  filter->AddSourceId(70);
}
void Prepare(vtkGeodesicDistanceMatrix* filter)
{
  filter->SetRowIds({ 0, 70 });
}
void Prepare(vtkDGGPath* filter)
{
  filter->AddPair(0, 70);
}
void Prepare(vtkDGGLoop* filter)
{
  filter->SetModeToRope();
  filter->SetPointIds({ 11, 15, 69, 65 });
}
void Prepare(vtkGeodesicSampler* filter)
{
  filter->SetNumberOfSamples(10);
}
void Prepare(vtkGeodesicVoronoi* filter)
{
  filter->SetSiteIds({ 10, 16, 64, 70 });
  filter->RefineBoundariesOff(); // which needs links as well
}
using Place = std::array<double, 3>;
void SetPlace(vtkDGGDistance* filter, const Place& place)
{
  filter->SetSourceData(MakeSourcePoints({ place }));
}
void SetPlace(vtkGeodesicDistanceMatrix* filter, const Place& place)
{
  filter->SetRowData(MakeSourcePoints({ place }));
}
void SetPlace(vtkDGGPath* filter, const Place& place)
{
  filter->SetPairData(MakePairs({ place, { { 15.0, 15.0, 4.0 } } }));
}
void SetPlace(vtkDGGLoop* filter, const Place& place)
{
  filter->SetPointData(MakeSourcePoints({ place }));
}
void SetPlace(vtkGeodesicSampler* filter, const Place& place)
{
  filter->SetStartData(MakeSourcePoints({ place }));
}
void SetPlace(vtkGeodesicVoronoi* filter, const Place& place)
{
  filter->SetSiteData(MakeSourcePoints({ place }));
}

template <typename FilterType>
class GraphFilters : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Relief);
    this->Filter->SetAccuracy(0.05);
    Prepare(this->Filter);
  }

  vtkSmartPointer<vtkPolyData> Relief = MakeRelief(VTK_DOUBLE);
  vtkNew<FilterType> Filter;
};
using GraphFilterTypes = ::testing::Types<vtkDGGDistance, vtkGeodesicDistanceMatrix, vtkDGGPath,
  vtkDGGLoop, vtkGeodesicSampler, vtkGeodesicVoronoi>;
TYPED_TEST_SUITE(GraphFilters, GraphFilterTypes);
}

TEST_P(FilterContract, PrintsItsState)
{
  const auto used = this->Make();
  const auto fresh = vtkSmartPointer<vtkGeodesicAlgorithm>::Take(used->NewInstance());
  std::ostringstream os;
  fresh->Print(os);
  for (const std::string line : this->GetParam().Defaults)
  {
    EXPECT_NE(os.str().find(line + "\n"), std::string::npos) << line << "\n" << os.str();
  }
  ExpectSuccess(used);
  used->Print(os);
  EXPECT_NE(os.str().find("OutputPointsPrecision: 1\n"), std::string::npos);
  EXPECT_NE(os.str().find("triangles: 128\n"), std::string::npos);
}

TEST_P(FilterContract, SameBitsForAnyThreads)
{
  std::string expected;
  ForEachThreading([&](const std::string& threading) {
    const auto filter = this->Make(24);
    ExpectSuccess(filter);
    const std::string found = Describe(filter);
    expected = expected.empty() ? found : expected;
    EXPECT_TRUE(found == expected) << threading;
  });
}

TEST_P(FilterContract, ReportsProgressAndStops)
{
  const auto filter = this->Make(24);
  ProgressWatch watch(filter);
  ExpectSuccess(filter);
  watch.ExpectGrowth(0);
  const std::string expected = Describe(filter);
  watch.Progress.clear();
  filter->Modified();
  ExpectSuccess(filter); // what is kept between updates is there
  const std::vector<double> progress = watch.Progress;
  for (std::size_t step = 0; step < progress.size(); step += 1 + progress.size() / 10)
  {
    watch.StopAt = progress[step];
    filter->Modified();
    ExpectSuccess(filter); // not an error
    if (progress[step] < 1.0)
    {
      ExpectEmptyOutput(filter);
    }
    watch.StopAt = 2.0;
    ExpectSuccess(filter); // nothing has changed, yet it runs
    EXPECT_TRUE(Describe(filter) == expected);
  }
  // A stop that was requested before an update is forgotten.
  filter->AbortExecuteOn();
  filter->Modified();
  ExpectSuccess(filter);
  EXPECT_TRUE(Describe(filter) == expected);
}

TEST_P(FilterContract, RefusesWrongPropertiesAndInputs)
{
  for (const Refusal& refusal : this->GetParam().Refusals)
  {
    SCOPED_TRACE(::testing::PrintToString(refusal.Parts));
    const auto filter = this->Make();
    refusal.Spoil(filter);
    filter->Modified();
    ExpectError(filter, refusal.Parts);
  }
}

TEST_P(FilterContract, RecoversFromErrors)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  const std::string expected = Describe(filter);
  double p[3];
  this->Relief->GetPoint(5, p);
  this->Relief->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->Relief->GetPoints()->Modified();
  ExpectError(filter, { "point 5" });
  {
    const Listener listener(filter);
    filter->Update(); // nothing has changed: the error is not repeated, but stays
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_NE(filter->GetErrorCode(), vtkErrorCode::NoError);
    ExpectEmptyOutput(filter);
  }
  filter->Modified();
  ExpectError(filter, { "point 5" });
  this->Relief->GetPoints()->SetPoint(5, p);
  this->Relief->GetPoints()->Modified();
  {
    const Listener listener(filter);
    filter->UpdatePiece(0, 2, 0);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("one of 2 pieces"), std::string::npos);
    ExpectEmptyOutput(filter);
    filter->UpdatePiece(0, 1, 0);
    EXPECT_EQ(listener.Errors.size(), 1u);
  }
  EXPECT_TRUE(Describe(filter) == expected);
}

TEST_P(FilterContract, RunsWhenSomethingHasChanged)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  const std::string expected = Describe(filter);
  const vtkMTimeType built = filter->GetMeshBuildTime();
  struct
  {
    int Starts = 0;
    void Count(vtkObject*, unsigned long, void*) { ++this->Starts; }
  } counter;
  filter->AddObserver(vtkCommand::StartEvent, &counter, &decltype(counter)::Count);
  filter->Update();
  EXPECT_EQ(counter.Starts, 0);
  filter->Modified();
  ExpectSuccess(filter);
  EXPECT_EQ(counter.Starts, 1);
  EXPECT_EQ(filter->GetMeshBuildTime(), built);
  EXPECT_TRUE(Describe(filter) == expected);
  for (vtkIdType i = 0; i < this->Relief->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Relief->GetPoint(i, p);
    this->Relief->GetPoints()->SetPoint(i, p[0], p[1], 1.01 * p[2]);
  }
  this->Relief->GetPoints()->Modified();
  ExpectSuccess(filter);
  EXPECT_EQ(counter.Starts, 2);
  EXPECT_GT(filter->GetMeshBuildTime(), built);
  EXPECT_FALSE(Describe(filter) == expected);
  filter->RemoveAllObservers();
}

TEST_P(FilterContract, LeavesItsInputAloneAndPassesIt)
{
  const auto filter = this->Make();
  vtkNew<vtkFloatArray> height;
  height->SetName("Height");
  height->SetNumberOfTuples(this->Relief->GetNumberOfPoints());
  height->Fill(4.0);
  this->Relief->GetPointData()->SetScalars(height);
  vtkNew<vtkFloatArray> material;
  material->SetName("Material");
  material->SetNumberOfTuples(this->Relief->GetNumberOfCells());
  material->Fill(2.0);
  this->Relief->GetCellData()->SetScalars(material);
  AddNote(this->Relief, "note");
  vtkNew<vtkPolyData> before;
  before->ShallowCopy(this->Relief);
  const vtkMTimeType time = this->Relief->GetMTime();
  ExpectSuccess(filter);
  EXPECT_EQ(this->Relief->GetMTime(), time);
  EXPECT_EQ(this->Relief->GetPoints(), before->GetPoints());
  EXPECT_EQ(this->Relief->GetPointData()->GetScalars(), height);
  for (int kind = 0; kind < 3; ++kind)
  {
    EXPECT_EQ(this->Relief->GetAttributesAsFieldData(kind)->GetNumberOfArrays(),
      before->GetAttributesAsFieldData(kind)->GetNumberOfArrays());
  }
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  if (output && output->GetPoints() == this->Relief->GetPoints())
  {
    EXPECT_EQ(output->GetPolys(), this->Relief->GetPolys());
    EXPECT_EQ(output->GetPointData()->GetArray("Height"), height);
    EXPECT_EQ(output->GetCellData()->GetArray("Material"), material);
    EXPECT_TRUE(output->GetFieldData()->HasArray("note"));
  }
}

TEST_P(FilterContract, EmptyInputGivesEmptyOutputWithAWarning)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  vtkNew<vtkPolyData> nothing;
  AddNote(nothing, "note");
  const auto empty = this->GetParam().Make(nothing);
  ExpectWarning(empty, { "empty" });
  for (int port = 0; port < empty->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    vtkDataObject* output = empty->GetOutputDataObject(port);
    for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
    {
      EXPECT_EQ(output->GetNumberOfElements(kind), 0);
    }
    // The arrays are there nevertheless, for filters downstream.
    vtkDataSetAttributes* points = output->GetAttributes(vtkDataObject::POINT);
    const bool isNew =
      std::count(this->GetParam().Ports.begin(), this->GetParam().Ports.end(), port);
    EXPECT_TRUE(!isNew || output->GetFieldData()->HasArray("note"));
    for (const char* name : isNew ? this->GetParam().Arrays : std::vector<const char*>())
    {
      EXPECT_TRUE(points->HasArray(name)) << name;
    }
    vtkDataSetAttributes* full =
      filter->GetOutputDataObject(port)->GetAttributes(vtkDataObject::POINT);
    if (full && full->GetScalars())
    {
      EXPECT_TRUE(points->HasArray(full->GetScalars()->GetName()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterContract, ::testing::ValuesIn(GetAllFilters()),
  [](const ::testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });

TYPED_TEST(GraphFilters, TakeTheGraphOnTheirInputOrBuildOne)
{
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_GT(built, 0u);
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_TRUE(this->Filter->GetGraphIsGuaranteed());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_GE(this->Filter->GetMemorySize(),
    static_cast<vtkTypeUInt64>(16 * this->Filter->GetNumberOfGraphEdges()));
  const std::string expected = Describe(this->Filter, false);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Relief, 0.05));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(Describe(this->Filter, false), expected);
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter, { "Accuracy 0.01 is asked for" });
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetAccuracy(0.02);
  ExpectSuccess(this->Filter);
}

TYPED_TEST(GraphFilters, RefuseLinksBeyondTheMemoryLimit)
{
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(1000); // the graph is there
  this->Filter->SetProjectionTolerance(0.1);
  SetPlace(this->Filter, { { 12.0, 31.0, 4.0 } });
  ExpectError(this->Filter, { "linking points that are not vertices" });
}
