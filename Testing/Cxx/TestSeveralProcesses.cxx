// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Equal results on any number of processes. Run under mpiexec; a single process is valid, too.
#include "FilterCases.h"
#include "SeveralProcessesFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"

#include "vtkTable.h"

using namespace dggtest;

namespace
{
class SeveralProcessesContract
  : public SeveralProcesses
  , public testing::WithParamInterface<FilterCase>
{
};
}

//------------------------------------------------------------------------------
/// Every filter, on pieces that are distributed over several processes.
TEST_P(SeveralProcessesContract, OutputsAreThoseOfTheWhole)
{
  if (this->Count == 1)
  {
    GTEST_SKIP() << "the test needs several processes";
  }
  const auto surface = MakeRelief(VTK_DOUBLE);
  const auto alone = this->GetParam().Make(surface);
  alone->SetController(nullptr);
  ExpectSuccess(alone);
  // Isolines on pieces with ids are not on the first process alone (TestIsolinesInPieces.cxx).
  const PartIds ids = alone->IsA("vtkApolloniusIsolines") ? PartIds::None : PartIds::Global;
  for (unsigned int seed = 0; seed < 3; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto filter = this->GetParam().Make(surface);
    filter->SetInputData(seed == 0
        ? this->TakeStrip(surface, ids)
        : TakePart(surface, LabelRandomly(surface, this->Count, seed), this->Here, ids));
    const Listener listener(filter);
    this->Update(filter);
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    EXPECT_EQ(listener.Warnings, std::vector<std::string>());
    ExpectOutputsOfParts(filter, alone, this->IsFirst());
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, SeveralProcessesContract, testing::ValuesIn(GetAllFilters()),
  [](const testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, ArraysOfSources)
{
  const auto sources = this->MakeSources();
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("middle");
  names->InsertNextValue("rim");
  sources->GetPointData()->AddArray(names);
  const auto prepare = [&sources](auto* filter) {
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
    const auto prepare = [](auto* filter) { filter->SetSourceIds({ 77, 500 }); };
    const auto alone = Alone<vtkDGGDistance>(this->Surface, prepare);
    const auto filter = this->Together<vtkDGGDistance>(part, prepare);
    ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  }
}

//------------------------------------------------------------------------------
/// Ids that neither 32 bits nor a double can represent.
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
  const auto prepare = [](auto* filter) { filter->SetSourceIds({ 77, 500 }); };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  const auto gathered = this->Together<vtkExactGeodesicDistance>(part, prepare);
  if (this->IsFirst())
  {
    EXPECT_EQ(GetReported(gathered, "NumberOfTriangles"), this->Surface->GetNumberOfCells());
  }
}

//------------------------------------------------------------------------------
/// Graph distances are bitwise equal: always without correction, and with correction if cells have
/// global ids.
TEST_F(SeveralProcesses, GraphDistancesAreTheSame)
{
  for (const bool corrects : { false, true })
  {
    const auto part = this->TakeStrip(this->Surface, corrects ? PartIds::Global : PartIds::None);
    part->GetPointData()->RemoveArray("GlobalPointIds");
    const auto prepare = [&](auto* filter) {
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
  const auto prepare = [](auto* filter) { filter->SetSourceData(MakeSources()); };
  const auto alone = Alone<vtkExactGeodesicDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkExactGeodesicDistance>(part, prepare);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), own->GetNumberOfPoints());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), own->GetNumberOfCells());
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 1e-12);
  if (this->IsFirst())
  {
    EXPECT_EQ(GetReported(filter, "NumberOfTriangles"), this->Surface->GetNumberOfCells());
    EXPECT_EQ(GetReported(filter, "NumberOfIsolatedPoints"), 0);
  }
}

//------------------------------------------------------------------------------
/// Cuts that cross a seam, even at its end, neither close nor widen the seam.
TEST_F(SeveralProcesses, SeamsStaySeams)
{
  const auto seam = MakeSeam(25);
  const auto prepare = [](auto* filter) {
    filter->SetSourceData(MakeSourcePoints({ { { 0.9, 0.4, GetTerrainHeight(0.9, 0.4) } } }));
  };
  const auto open = Alone<vtkExactGeodesicDistance>(seam, prepare);
  EXPECT_EQ(GetReported(open, "NumberOfBoundaryLoops"), 1);
  for (int shift = 0; shift < 8; ++shift)
  {
    // Cuts between columns, which cross the seam. An edge of the seam that lies on a cut is joined.
    const int columns = 24;
    Labels labels = LabelStrips(seam, columns);
    for (int& label : labels)
    {
      label = std::max(0, label - shift) * this->Count / columns;
    }
    const auto part = TakePart(seam, labels, this->Here);
    vtkNew<vtkExactGeodesicDistance> filter;
    filter->SetInputData(part);
    prepare(filter.Get());
    const Listener listener(filter);
    this->Update(filter);
    ASSERT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    ExpectArray(filter->GetOutput(), open->GetOutput(), "GeodesicDistance", 1e-12);
    if (this->IsFirst())
    {
      EXPECT_EQ(
        GetReported(filter, "NumberOfBoundaryEdges"), GetReported(open, "NumberOfBoundaryEdges"));
      EXPECT_EQ(GetReported(filter, "NumberOfIsolatedPoints"), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, AGraphServesAChain)
{
  const auto part = this->TakeStrip(this->Surface);
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(part, [](auto*) {});
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
  // A graph that is kept by the filter.
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
/// Sources may come from one or all processes. Each source counts once.
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
    const auto prepare = [&](auto* matrix) { matrix->SetRowData(here); };
    const auto matrix = this->Together<vtkGeodesicDistanceMatrix>(part, prepare);
    EXPECT_EQ(matrix->GetOutput()->GetNumberOfRows(), this->IsFirst() ? 2 : 0) << where;
  }
}

//------------------------------------------------------------------------------
/// A surface that every process contains completely, as with most readers, counts once.
TEST_F(SeveralProcesses, TheSameSurfaceEverywhereCountsOnce)
{
  const auto prepare = [](auto* filter) { filter->SetSourceIds({ 3 }); };
  const auto alone = Alone<vtkExactGeodesicDistance>(this->Surface, prepare);
  const auto filter = this->Together<vtkExactGeodesicDistance>(this->Surface, prepare);
  EXPECT_EQ(GetDistances(filter), GetDistances(alone));
}
