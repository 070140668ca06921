// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contract of all filters, on surfaces and on clouds: state, invalid input, threads, progress,
/// caching; names and ranges of distances from sources.
#include "FilterCases.h"
#include "GraphTestTools.h"

#include "vtkGeodesicDistanceAlgorithm.h"

#include <sstream>

using namespace dggtest;

namespace
{
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

std::vector<FilterCase> GetFiltersWithSources()
{
  std::vector<FilterCase> filters;
  for (const FilterCase& filter : GetAllFilters())
  {
    if (vtkGeodesicDistanceAlgorithm::SafeDownCast(filter.Make(MakeRelief(VTK_DOUBLE))))
    {
      filters.push_back(filter);
    }
  }
  return filters;
}

class DistanceContract : public ::testing::TestWithParam<FilterCase>
{
};
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
  const bool isSurface = this->Relief->GetNumberOfPolys() > 0;
  EXPECT_NE(os.str().find(isSurface ? "triangles: 128\n" : "no surface\n"), std::string::npos);
}

TEST_P(FilterContract, SameBitsForAnyThreads)
{
  std::string expected;
  ForEachThreading([&](const std::string& threading) {
    const auto filter = this->Make(24);
    ExpectSuccess(filter);
    const std::string found = DescribeOutputs(filter);
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
  const std::string expected = DescribeOutputs(filter);
  watch.Progress.clear();
  filter->Modified();
  ExpectSuccess(filter); // runs with filled caches
  const std::vector<double> progress = watch.Progress;
  for (std::size_t step = 0; step < progress.size(); step += 1 + progress.size() / 10)
  {
    watch.StopAt = progress[step];
    filter->Modified();
    ExpectSuccess(filter); // an abort is not an error
    if (progress[step] < 1.0)
    {
      ExpectEmptyOutput(filter);
    }
    watch.StopAt = 2.0;
    ExpectSuccess(filter); // nothing has changed, but the filter executes
    EXPECT_TRUE(DescribeOutputs(filter) == expected);
  }
  // An abort that was requested before an update is ignored.
  filter->AbortExecuteOn();
  filter->Modified();
  ExpectSuccess(filter);
  EXPECT_TRUE(DescribeOutputs(filter) == expected);
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

TEST_P(FilterContract, RunsWhenSomethingHasChanged)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  const std::string expected = DescribeOutputs(filter);
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
  EXPECT_TRUE(DescribeOutputs(filter) == expected);
  MovePoints(this->Relief, [&](double* p) { p[2] *= 1.01; });
  ExpectSuccess(filter);
  EXPECT_EQ(counter.Starts, 2);
  EXPECT_GT(filter->GetMeshBuildTime(), built);
  EXPECT_FALSE(DescribeOutputs(filter) == expected);
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

TEST_P(FilterContract, InputMayHaveNoFieldData)
{
  const auto expected = this->Make();
  ExpectSuccess(expected);
  const auto filter = this->Make();
  this->Relief->SetFieldData(nullptr);
  ExpectSuccess(filter);
  EXPECT_EQ(DescribeOutputs(filter), DescribeOutputs(expected));
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
    // The arrays exist nevertheless, for filters downstream.
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

TEST_P(DistanceContract, EndsAtTheMaximumDistance)
{
  const auto algorithm = this->GetParam().Make(MakeRelief(VTK_DOUBLE, 16));
  auto* filter = vtkGeodesicDistanceAlgorithm::SafeDownCast(algorithm);
  ExpectSuccess(filter);
  const std::vector<double> whole = GetDistances(filter);
  const std::vector<int> sources = GetNearestSources(filter);
  ASSERT_EQ(whole.size(), 289u);
  std::vector<double> sorted = whole;
  std::sort(sorted.begin(), sorted.end());
  for (const std::size_t count : { 2u, 20u, 150u })
  {
    // The limit is inclusive: sources are reached with limit 0.
    filter->SetMaximumDistance(count == 2 ? 0.0 : 0.5 * (sorted[count - 1] + sorted[count]));
    filter->SetUnreachedValue(-7.0);
    ExpectSuccess(filter);
    const std::vector<double> cut = GetDistances(filter);
    const std::vector<int> nearest = GetNearestSources(filter);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      const bool isReached = whole[i] <= filter->GetMaximumDistance();
      EXPECT_EQ(cut[i], isReached ? whole[i] : -7.0) << i;
      EXPECT_EQ(nearest[i], isReached ? sources[i] : -1) << i;
    }
  }
  filter->SetMaximumDistance(std::numeric_limits<double>::infinity());
  ExpectSuccess(filter);
  EXPECT_EQ(GetDistances(filter), whole);
}

TEST_P(DistanceContract, NamesItsArrays)
{
  const auto relief = MakeRelief(VTK_DOUBLE);
  vtkNew<vtkFloatArray> old;
  old->SetName("d");
  old->SetNumberOfTuples(relief->GetNumberOfPoints());
  old->Fill(-5.0);
  relief->GetPointData()->SetScalars(old);
  const auto algorithm = this->GetParam().Make(relief);
  auto* filter = vtkGeodesicDistanceAlgorithm::SafeDownCast(algorithm);
  filter->SetDistanceArrayName("d"); // replaces the array of the input
  filter->SetSourceArrayName("s");
  ExpectSuccess(filter);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), data->HasArray("Component") ? 3 : 2); // 3 arrays on clouds
  EXPECT_STREQ(data->GetScalars()->GetName(), "d");
  EXPECT_EQ(data->GetScalars()->GetDataType(), VTK_DOUBLE);
  ASSERT_NE(data->GetArray("s"), nullptr);
  EXPECT_EQ(data->GetArray("s")->GetDataType(), VTK_INT);
  EXPECT_EQ(relief->GetPointData()->GetScalars(), old.Get());
  EXPECT_EQ(old->GetValue(1), -5.0f);
}

INSTANTIATE_TEST_SUITE_P(Filters, DistanceContract, ::testing::ValuesIn(GetFiltersWithSources()),
  [](const ::testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });
