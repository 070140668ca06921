// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What filters on a surface have in common: properties, wrong input, threads, progress, and the
/// graph that some of them search.
#include "GraphTestTools.h"
#include "PathTestTools.h"
#include "SurfaceFilterCases.h"

#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace dggtest;

namespace
{
/// Everything that a filter puts out, as text.
std::string Describe(vtkGeodesicAlgorithm* filter)
{
  std::ostringstream os;
  os.precision(17);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    os << DescribeGeometry(output);
    for (vtkFieldData* data : { static_cast<vtkFieldData*>(output->GetPointData()),
           static_cast<vtkFieldData*>(output->GetCellData()) })
    {
      for (int a = 0; a < data->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = data->GetArray(a);
        os << data->GetArrayName(a);
        for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
        {
          for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          {
            os << " " << array->GetComponent(i, c);
          }
        }
        os << "\n";
      }
    }
  }
  return os.str();
}

class SurfaceFilters : public ::testing::TestWithParam<SurfaceFilter>
{
};

/// Filters that search a graph: what makes them work on the relief, and points on port 1.
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
using GraphFilterTypes =
  ::testing::Types<vtkDGGPath, vtkDGGLoop, vtkGeodesicSampler, vtkGeodesicVoronoi>;
TYPED_TEST_SUITE(GraphFilters, GraphFilterTypes);
}

TEST_P(SurfaceFilters, PrintWhatTheyAreLike)
{
  const auto used = this->GetParam().Make(MakeRelief(VTK_DOUBLE));
  ExpectSuccess(used);
  const auto fresh = vtkSmartPointer<vtkGeodesicAlgorithm>::Take(used->NewInstance());
  std::ostringstream ofUsed;
  std::ostringstream ofNew;
  used->Print(ofUsed);
  fresh->Print(ofNew);
  EXPECT_NE(ofUsed.str().find("OutputPointsPrecision: 1\n"), std::string::npos);
  for (const std::string line : this->GetParam().Defaults)
  {
    EXPECT_NE(ofNew.str().find(line + "\n"), std::string::npos) << line;
  }
}

TEST_P(SurfaceFilters, AreTheSameForAnyThreads)
{
  const auto run = [&] {
    const auto filter = this->GetParam().Make(MakeRelief(VTK_DOUBLE));
    ExpectSuccess(filter);
    return Describe(filter);
  };
  const std::string expected = run();
  ForEachThreading([&](const std::string& threading) { EXPECT_EQ(run(), expected) << threading; });
}

TEST_P(SurfaceFilters, ReportProgressAndStop)
{
  const auto filter = this->GetParam().Make(MakeRelief(VTK_DOUBLE));
  ProgressWatch watch(filter);
  ExpectSuccess(filter);
  watch.ExpectGrowth(0);
  const std::string expected = Describe(filter);
  watch.Progress.clear();
  filter->Modified();
  ExpectSuccess(filter); // the graph is there
  const std::vector<double> progress = watch.Progress;
  for (const std::size_t step : { progress.size() / 3, 2 * progress.size() / 3 })
  {
    watch.StopAt = progress[step];
    filter->Modified();
    ExpectSuccess(filter); // not an error
    EXPECT_TRUE(progress[step] == 1.0 || filter->GetOutput(0)->GetNumberOfPoints() == 0);
    watch.StopAt = 2.0;
    filter->Modified();
    ExpectSuccess(filter);
    EXPECT_EQ(Describe(filter), expected);
  }
}

TEST_P(SurfaceFilters, NameWhatIsWrongWithTheSurface)
{
  const auto relief = MakeRelief(VTK_DOUBLE);
  const auto filter = this->GetParam().Make(relief);
  filter->SetInputConnection(nullptr);
  ExpectError(filter, { "there is no input" });
  vtkNew<vtkPolyData> points;
  points->SetPoints(relief->GetPoints());
  filter->SetInputData(points);
  ExpectError(filter, { "polygons" });
  filter->SetInputData(relief);
  ExpectSuccess(filter);
  const auto broken = MakeRelief(VTK_DOUBLE);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  ExpectError(this->GetParam().Make(broken), { "point 5", "not finite" });
}

INSTANTIATE_TEST_SUITE_P(Filters, SurfaceFilters, ::testing::ValuesIn(GetSurfaceFilters()),
  [](const ::testing::TestParamInfo<SurfaceFilter>& tested) { return tested.param.Name; });

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
  const std::string expected = Describe(this->Filter);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Relief, 0.05));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(Describe(this->Filter), expected);
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter, { "Accuracy 0.01 is asked for" });
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetAccuracy(0.02);
  ExpectSuccess(this->Filter);
}

TYPED_TEST(GraphFilters, NameWrongProperties)
{
  for (const double accuracy : { 0.0, 0.6, std::nan("") })
  {
    this->Filter->SetAccuracy(accuracy);
    ExpectError(this->Filter, { "ccuracy", "1e-06", "0.5" });
  }
  this->Filter->SetAccuracy(0.05);
  for (const double tolerance : { -1.0, std::nan("") })
  {
    this->Filter->SetProjectionTolerance(tolerance);
    ExpectError(this->Filter, { "ProjectionTolerance", "must not be negative or NaN" });
  }
  this->Filter->SetProjectionTolerance(0.1);
  this->Filter->SetMemoryLimit(1000);
  ExpectError(this->Filter, { "the graph would take" });
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(1000); // the graph is there
  SetPlace(this->Filter, { { 12.0, 31.0, 4.0 } });
  ExpectError(this->Filter, { "linking points that are not vertices" });
}

TYPED_TEST(GraphFilters, NameWrongPlaces)
{
  SetPlace(this->Filter, { { 0.5, std::nan(""), 0.0 } });
  ExpectError(this->Filter, { "point 0 of input port 1", "not finite" });
  SetPlace(this->Filter, { { 0.0, 0.0, 99.0 } });
  ExpectError(this->Filter,
    { "point 0 of input port 1", "(0, 0, 99)", "farther than", "ProjectionTolerance" });
  this->Filter->SetInputDataObject(1, nullptr);
  ExpectSuccess(this->Filter);
}
