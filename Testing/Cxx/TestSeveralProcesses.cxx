// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same results on any number of processes. Run under mpiexec; alone as well.
#include "SeveralProcessesFixture.h"

#include "vtkApolloniusIsolines.h"
#include "vtkBiharmonicDistance.h"
#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkDGGPath.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkHarmonicBSpline.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

using namespace dggtest;

//------------------------------------------------------------------------------
template <typename Filter>
class SeveralProcessesDistance : public SeveralProcesses
{
};
template <typename Filter>
constexpr double Tolerance = 1e-12;
template <>
constexpr double Tolerance<vtkDGGDistance> = FloatTolerance;

using DistanceFilters = testing::Types<vtkDGGDistance, vtkExactGeodesicDistance,
  vtkHeatGeodesicDistance, vtkDGGFastMarchingDistance, vtkVirtualSourceGeodesicDistance>;
TYPED_TEST_SUITE(SeveralProcessesDistance, DistanceFilters);

TYPED_TEST(SeveralProcessesDistance, IsThatOfTheWhole)
{
  const std::function<void(TypeParam*)> prepare = [this](TypeParam* filter) {
    filter->SetSourceData(this->MakeSources());
    filter->GenerateNearestSourceOn();
  };
  const auto alone = this->template Alone<TypeParam>(this->Surface, prepare);
  for (unsigned int seed = 0; seed < 3; ++seed)
  {
    const auto part =
      seed == 0 ? this->TakeStrip(this->Surface) : this->TakeRandom(this->Surface, seed);
    const auto filter = this->template Together<TypeParam>(part, prepare);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), part->GetNumberOfPoints());
    EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "GeodesicDistance");
    this->ExpectArray(
      filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", Tolerance<TypeParam>);
    this->ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicSource", 0.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, ArraysOfSources)
{
  const auto sources = this->MakeSources();
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("middle");
  names->InsertNextValue("rim");
  sources->GetPointData()->AddArray(names);
  const std::function<void(vtkExactGeodesicDistance*)> prepare =
    [&sources](vtkExactGeodesicDistance* filter) {
      filter->SetSourceData(sources);
      filter->GenerateNearestSourceOn();
      filter->PassSourceArraysOn();
    };
  const auto filter =
    this->Together<vtkExactGeodesicDistance>(this->TakeStrip(this->Surface), prepare);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  auto* found = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  ASSERT_NE(found, nullptr);
  for (vtkIdType i = 0; i < found->GetNumberOfValues(); ++i)
  {
    const int source = static_cast<int>(data->GetArray("GeodesicSource")->GetComponent(i, 0));
    ASSERT_EQ(found->GetValue(i), names->GetValue(source));
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, GlobalIdsNumberPoints)
{
  for (const bool ghosts : { false, true })
  {
    const auto part = this->TakeStrip(this->Surface, PartIds::Global, ghosts);
    const std::function<void(vtkDGGDistance*)> prepare = [](vtkDGGDistance* filter) {
      filter->SetSourceIds({ 77, 500 });
    };
    const auto alone = Alone<vtkDGGDistance>(this->Surface, prepare);
    const auto filter = this->Together<vtkDGGDistance>(part, prepare);
    ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  }
}

//------------------------------------------------------------------------------
/// Ids that neither 32 bits nor a double hold.
TEST_F(SeveralProcesses, LargeGlobalIds)
{
  const auto part = this->TakeStrip(this->Surface, PartIds::Global);
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(part->GetPointData()),
         static_cast<vtkDataSetAttributes*>(part->GetCellData()) })
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(data->GetGlobalIds());
    ASSERT_NE(ids, nullptr);
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      ids->SetValue(i, ids->GetValue(i) + (vtkIdType(1) << 54) + (vtkIdType(1) << 33));
    }
  }
  const std::function<void(vtkDGGDistance*)> prepare = [](vtkDGGDistance* filter) {
    filter->SetSourceIds({ 77, 500 });
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  if (this->IsFirst())
  {
    EXPECT_EQ(filter->GetNumberOfTriangles(), this->Surface->GetNumberOfCells());
  }
}

//------------------------------------------------------------------------------
/// Of a graph, bit by bit: without correction always, with it where cells have global ids.
TEST_F(SeveralProcesses, GraphDistancesAreTheSame)
{
  for (const bool corrects : { false, true })
  {
    const auto part = this->TakeStrip(this->Surface, corrects ? PartIds::Global : PartIds::None);
    part->GetPointData()->RemoveArray("GlobalPointIds");
    const std::function<void(vtkDGGDistance*)> prepare = [&](vtkDGGDistance* filter) {
      filter->SetSourceData(MakeSources());
      filter->SetCorrection(corrects);
    };
    const auto alone = Alone<vtkDGGDistance>(this->Surface, prepare);
    const auto filter = this->Together<vtkDGGDistance>(part, prepare);
    ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, GhostCellsAreLeftOut)
{
  const auto part = this->TakeStrip(this->Surface, PartIds::None, true);
  const auto own = this->TakeStrip(this->Surface);
  const std::function<void(vtkExactGeodesicDistance*)> prepare =
    [](vtkExactGeodesicDistance* filter) { filter->SetSourceData(MakeSources()); };
  const auto alone = Alone<vtkExactGeodesicDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkExactGeodesicDistance>(part, prepare);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), own->GetNumberOfPoints());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), own->GetNumberOfCells());
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 1e-12);
  if (this->IsFirst())
  {
    EXPECT_EQ(filter->GetNumberOfTriangles(), this->Surface->GetNumberOfCells());
    EXPECT_EQ(filter->GetNumberOfIsolatedPoints(), 0);
  }
}

//------------------------------------------------------------------------------
/// Cuts that cross a seam, at its end too, neither close nor widen it.
TEST_F(SeveralProcesses, SeamsStaySeams)
{
  const auto seam = MakeSeam(25);
  const std::function<void(vtkExactGeodesicDistance*)> prepare =
    [](vtkExactGeodesicDistance* filter) {
      filter->SetSourceData(MakeSourcePoints({ { { 0.9, 0.4, GetTerrainHeight(0.9, 0.4) } } }));
    };
  const auto open = Alone<vtkExactGeodesicDistance>(seam, prepare);
  EXPECT_EQ(open->GetNumberOfBoundaryLoops(), 1);
  for (int shift = 0; shift < 8; ++shift)
  {
    // Cuts between columns, which cross the seam: where they lie on an edge of it, that is joined.
    const int columns = 24;
    Labels labels = LabelStrips(seam, columns);
    for (int& label : labels)
    {
      label = std::max(0, label - shift) * this->Count / columns;
    }
    const auto part = TakePart(seam, labels, this->Here);
    vtkNew<vtkExactGeodesicDistance> filter;
    filter->SetInputData(part);
    prepare(filter);
    const Listener listener(filter);
    this->Update(filter);
    ASSERT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    ExpectArray(filter->GetOutput(), open->GetOutput(), "GeodesicDistance", 1e-12);
    if (this->IsFirst())
    {
      EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), open->GetNumberOfBoundaryEdges());
      EXPECT_EQ(filter->GetNumberOfIsolatedPoints(), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, PathsIsolinesAndCells)
{
  const auto part = this->TakeRandom(this->Surface, 5);
  auto pairs = MakeSources();
  pairs->SetLines(MakeCells({ { 0, 1 } }));
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    const std::function<void(vtkDGGPath*)> prepare = [&](vtkDGGPath* path) {
      path->SetMethod(method);
      path->SetPairData(pairs);
    };
    const auto alone = Alone<vtkDGGPath>(this->Surface, prepare);
    const auto path = this->Together<vtkDGGPath>(part, prepare);
    if (this->IsFirst())
    {
      ExpectSameSet(path->GetOutput(), alone->GetOutput(), 1e-12);
      EXPECT_NEAR(path->GetOutput()->GetCellData()->GetArray("Length")->GetComponent(0, 0),
        alone->GetOutput()->GetCellData()->GetArray("Length")->GetComponent(0, 0), 1e-12);
    }
    else
    {
      EXPECT_EQ(path->GetOutput()->GetNumberOfPoints(), 0);
    }
  }

  const std::function<void(vtkExactGeodesicDistance*)> exact = [](auto* filter) {
    filter->SetSourceData(MakeSources());
    filter->GenerateWindowsOn();
  };
  const std::function<void(vtkApolloniusIsolines*)> lines = [](vtkApolloniusIsolines* isolines) {
    isolines->GenerateValues(5, 0.05, 0.55);
  };
  const auto alone = Alone<vtkExactGeodesicDistance>(this->Surface, exact);
  const auto linesAlone = Alone<vtkApolloniusIsolines>(alone->GetOutput(), lines);
  const auto filter = this->Together<vtkExactGeodesicDistance>(part, exact);
  const auto isolines = this->Together<vtkApolloniusIsolines>(filter->GetOutput(), lines);
  if (this->IsFirst())
  {
    EXPECT_TRUE(isolines->GetUsedWindows());
    ExpectSameSet(isolines->GetOutput(), linesAlone->GetOutput(), 1e-9);
  }

  const std::function<void(vtkGeodesicVoronoi*)> sites = [](vtkGeodesicVoronoi* voronoi) {
    voronoi->SetSiteData(MakeSources());
    voronoi->RefineBoundariesOff();
  };
  const auto cellsAlone = Alone<vtkGeodesicVoronoi>(this->Surface, sites);
  const auto cells = this->Together<vtkGeodesicVoronoi>(part, sites);
  ExpectArray(cells->GetOutput(), cellsAlone->GetOutput(), "GeodesicSource", 0.0);
  ExpectArray(cells->GetOutput(), cellsAlone->GetOutput(), "GeodesicDistance", FloatTolerance);
  if (this->IsFirst())
  {
    ExpectSameSet(cells->GetBoundaries(), cellsAlone->GetBoundaries(), 1e-9);
    EXPECT_EQ(cells->GetSites()->GetNumberOfPoints(), 2);
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, SpectralFilters)
{
  const auto part = this->TakeRandom(this->Surface, 7);
  const std::function<void(vtkDiscreteGreensFunction*)> greens =
    [](vtkDiscreteGreensFunction* filter) {
      filter->SetSourceData(MakeSources());
      filter->SetEvaluationData(MakeSources());
    };
  const auto alone = Alone<vtkDiscreteGreensFunction>(this->Surface, greens);
  const auto filter = this->Together<vtkDiscreteGreensFunction>(part, greens);
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GreensFunction", 1e-10);
  EXPECT_EQ(filter->GetEvaluation()->GetNumberOfPoints(), this->IsFirst() ? 2 : 0);
  const std::function<void(vtkBiharmonicDistance*)> biharmonic = [](vtkBiharmonicDistance* other) {
    other->SetSourceData(MakeSources());
  };
  ExpectArray(this->Together<vtkBiharmonicDistance>(part, biharmonic)->GetOutput(),
    Alone<vtkBiharmonicDistance>(this->Surface, biharmonic)->GetOutput(), "BiharmonicDistance",
    1e-10);
  const std::function<void(vtkHarmonicBSpline*)> spline = [](vtkHarmonicBSpline* other) {
    other->SetSourceData(MakeSources());
  };
  const auto splines = this->Together<vtkHarmonicBSpline>(part, spline);
  const auto splinesAlone = Alone<vtkHarmonicBSpline>(this->Surface, spline);
  ExpectArray(splines->GetOutput(), splinesAlone->GetOutput(), "HarmonicBSpline", 1e-10);
  ExpectArray(splines->GetOutput(), splinesAlone->GetOutput(), "Cell", 0.0);
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, AGraphServesAChain)
{
  const auto part = this->TakeStrip(this->Surface);
  const auto graph =
    this->Together<vtkDiscreteGeodesicGraph>(part, [](vtkDiscreteGeodesicGraph*) {});
  EXPECT_EQ(graph->GetOutput()->GetFieldData()->HasArray("DGG.Offsets"), this->IsFirst());
  const vtkMTimeType built = graph->GetGraphBuildTime();
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(graph->GetOutputPort());
  vtkMTimeType mesh = 0;
  for (const double x : { 0.2, 0.4, 0.6 })
  {
    distance->SetSourceData(MakeSourcePoints({ { { x, 0.5, GetTerrainHeight(x, 0.5) } } }));
    const Listener listener(distance);
    this->Update(distance);
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_TRUE(listener.Warnings.empty()) << listener.Warnings[0];
    EXPECT_EQ(graph->GetGraphBuildTime(), built);
    EXPECT_EQ(distance->GetUsedInputGraph(), this->IsFirst());
    EXPECT_EQ(distance->GetMeshBuildTime() > 0, this->IsFirst());
    mesh = mesh == 0 ? distance->GetMeshBuildTime() : mesh;
    EXPECT_EQ(distance->GetMeshBuildTime(), mesh);
  }
  // One that a filter keeps.
  vtkNew<vtkDGGDistance> own;
  own->SetInputData(part);
  own->SetSourceData(MakeSources());
  this->Update(own);
  const vtkMTimeType first = own->GetGraphBuildTime();
  own->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, GetTerrainHeight(0.5, 0.5) } } }));
  this->Update(own);
  EXPECT_EQ(own->GetGraphBuildTime(), first);
  EXPECT_EQ(first > 0, this->IsFirst());
}

//------------------------------------------------------------------------------
/// Sources come from any process, from one or from all: each counts once.
TEST_F(SeveralProcesses, SourcesCountOnce)
{
  const auto part = this->TakeStrip(this->Surface);
  const auto sources = MakeSources();
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  names->InsertNextValue("one");
  names->InsertNextValue("other");
  vtkNew<vtkDoubleArray> unnamed;
  unnamed->InsertNextValue(1.0);
  unnamed->InsertNextValue(2.0);
  sources->GetPointData()->AddArray(names);
  sources->GetPointData()->AddArray(unnamed);
  vtkNew<vtkPolyData> none;
  for (const std::string where : { "everywhere", "first", "last", "one each" })
  {
    vtkSmartPointer<vtkPolyData> here = sources;
    if (where == "first" || where == "last")
    {
      here = this->Here == (where == "first" ? 0 : this->Count - 1) ? sources.Get() : none.Get();
    }
    else if (where == "one each" && this->Count > 1)
    {
      double p[3];
      sources->GetPoint(std::min(this->Here, 1), p);
      here = this->Here < 2 ? MakeSourcePoints({ { { p[0], p[1], p[2] } } }) : none;
    }
    const std::function<void(vtkGeodesicDistanceMatrix*)> prepare =
      [&](vtkGeodesicDistanceMatrix* matrix) { matrix->SetRowData(here); };
    const auto matrix = this->Together<vtkGeodesicDistanceMatrix>(part, prepare);
    EXPECT_EQ(matrix->GetOutput()->GetNumberOfRows(), this->IsFirst() ? 2 : 0) << where;
  }
}

//------------------------------------------------------------------------------
/// What every process has as a whole, as with most readers, counts once.
TEST_F(SeveralProcesses, TheSameSurfaceEverywhereCountsOnce)
{
  const std::function<void(vtkExactGeodesicDistance*)> prepare =
    [](vtkExactGeodesicDistance* filter) { filter->SetSourceIds({ 3 }); };
  const auto alone = Alone<vtkExactGeodesicDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkExactGeodesicDistance>(this->Surface, prepare);
  EXPECT_EQ(GetDistances(filter), GetDistances(alone));
}
