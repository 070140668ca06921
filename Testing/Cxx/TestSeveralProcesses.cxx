// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same results on any number of processes. Run under mpiexec; alone as well.
#include "PartTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkBiharmonicDistance.h"
#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkDGGOFFReader.h"
#include "vtkDGGPath.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkHarmonicBSpline.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPPolyDataWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>

using namespace dggtest;

namespace
{
class SeveralProcesses : public testing::Test
{
protected:
  vtkMultiProcessController* Controller = vtkMultiProcessController::GetGlobalController();
  const int Count = Controller->GetNumberOfProcesses();
  const int Here = Controller->GetLocalProcessId();
  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(33);

  bool IsFirst() const { return this->Here == 0; }

  void Update(vtkAlgorithm* filter) { filter->UpdatePiece(this->Here, this->Count, 0); }

  /// The part of this process of a surface in strips.
  vtkSmartPointer<vtkPolyData> TakeStrip(
    vtkPolyData* surface, PartIds ids = PartIds::None, bool ghosts = false) const
  {
    return TakePart(surface, LabelStrips(surface, this->Count), this->Here, ids, ghosts);
  }

  vtkSmartPointer<vtkPolyData> TakeRandom(vtkPolyData* surface, unsigned int seed) const
  {
    return TakePart(surface, LabelRandomly(surface, this->Count, seed), this->Here);
  }

  /// A place amid the terrain, and one near its rim.
  static vtkSmartPointer<vtkPolyData> MakeSources()
  {
    return MakeSourcePoints({ { { 0.31, 0.42, GetTerrainHeight(0.31, 0.42) } },
      { { 0.9, 0.85, GetTerrainHeight(0.9, 0.85) } } });
  }

  /// What a filter finds without other processes.
  template <typename Filter>
  static vtkSmartPointer<Filter> Alone(
    vtkPolyData* surface, const std::function<void(Filter*)>& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetController(nullptr);
    filter->SetInputData(surface);
    prepare(filter);
    filter->Update();
    return filter;
  }

  template <typename Filter>
  vtkSmartPointer<Filter> Together(vtkDataObject* part, const std::function<void(Filter*)>& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(part);
    prepare(filter);
    const Listener listener(filter);
    this->Update(filter);
    EXPECT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    EXPECT_TRUE(listener.Warnings.empty()) << listener.Warnings[0];
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    return filter;
  }

  /// Arrays of points of a part are those of the whole.
  static void ExpectArray(
    vtkPolyData* part, vtkPolyData* whole, const std::string& name, double tolerance)
  {
    vtkDataArray* array = part->GetPointData()->GetArray(name.c_str());
    vtkDataArray* expected = whole->GetPointData()->GetArray(name.c_str());
    vtkDataArray* ids = part->GetPointData()->GetArray("Whole");
    ASSERT_TRUE(array && expected) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), part->GetNumberOfPoints());
    ASSERT_EQ(array->GetNumberOfComponents(), expected->GetNumberOfComponents());
    const double range = std::max(std::abs(expected->GetRange()[0]), expected->GetRange()[1]);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        ASSERT_NEAR(array->GetComponent(i, k), expected->GetComponent(id, k), tolerance * range)
          << name << " at point " << id;
      }
    }
  }

  static vtkIdType GetNumberOfReached(vtkPolyData* part)
  {
    vtkDataArray* array = part->GetPointData()->GetArray("GeodesicDistance");
    vtkIdType reached = 0;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      reached += array->GetComponent(i, 0) >= 0.0 ? 1 : 0;
    }
    return reached;
  }

  /// The same points in the same number of cells, whatever their order.
  static void ExpectSameSet(vtkPolyData* curves, vtkPolyData* expected, double tolerance)
  {
    ASSERT_GT(expected->GetNumberOfPoints(), 0);
    EXPECT_EQ(curves->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_EQ(curves->GetNumberOfCells(), expected->GetNumberOfCells());
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      double p[3];
      expected->GetPoint(i, p);
      double nearest = 1e300;
      for (vtkIdType j = 0; j < curves->GetNumberOfPoints(); ++j)
      {
        double q[3];
        curves->GetPoint(j, q);
        nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
      ASSERT_LT(nearest, tolerance);
    }
  }
};

}

//------------------------------------------------------------------------------
template <typename Filter>
class SeveralProcessesDistance : public SeveralProcesses
{
};
/// Where cells come in another order, angles in graphs are rounded to other floats, and with them
/// corrected distances.
constexpr double FloatTolerance = 1e-7;
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

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, FewerPartsThanProcesses)
{
  vtkSmartPointer<vtkPolyData> part = vtkSmartPointer<vtkPolyData>::New();
  if (this->Here == this->Count - 1)
  {
    part = TakePart(this->Surface, Labels(this->Surface->GetNumberOfCells(), 0), 0);
  }
  const std::function<void(vtkDGGDistance*)> prepare = [](vtkDGGDistance* filter) {
    filter->SetSourceIds({ 40 });
  };
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), part->GetNumberOfPoints());
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"), nullptr);
}

//------------------------------------------------------------------------------
/// The first process alone has what is read.
TEST_F(SeveralProcesses, ReadersGiveOnePiece)
{
  vtkNew<vtkDGGOFFReader> reader;
  reader->SetFileName(DGG_TEST_DATA "/tetrahedron.off");
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSourceIds({ 0 });
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), this->IsFirst() ? 4 : 0);
  if (this->Count == 1)
  {
    return;
  }
  // Without a file, nobody waits for the first process.
  reader->SetFileName("none.off");
  const Listener silence(reader);
  const Listener listener(filter);
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
/// A plane in pieces of other cells than triangles, with verts and lines.
TEST_F(SeveralProcesses, PiecesOfQuadsAndStrips)
{
  for (const GridCells cells : { GridCells::Quads, GridCells::Strips })
  {
    const auto part = MakeGrid(10, 3, cells);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      double p[3];
      part->GetPoint(i, p);
      part->GetPoints()->SetPoint(i, p[0], p[1] + 3.0 * this->Here, 0.0);
    }
    part->SetVerts(MakeCells({ { 1 }, { 5 } }));
    part->SetLines(MakeCells({ { 0, 7, 3 } }));
    const std::function<void(vtkExactGeodesicDistance*)> prepare =
      [](vtkExactGeodesicDistance* filter) {
        filter->SetSourceData(MakeSourcePoints({ { { 2.5, 0.5, 0.0 } } }));
      };
    const auto filter = this->Together<vtkExactGeodesicDistance>(part, prepare);
    const auto distances = GetDistances(filter);
    ASSERT_EQ(distances.size(), static_cast<std::size_t>(part->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const double* p = part->GetPoint(i);
      EXPECT_NEAR(distances[i], std::hypot(p[0] - 2.5, p[1] - 0.5), 1e-12);
    }
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), part->GetNumberOfCells());
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, PiecesOfASource)
{
  vtkNew<vtkSphereSource> sphere; // whose pieces differ by roundings on their rims
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetSourceData(MakeSourcePoints({ { { 0.5, 0.0, 0.0 } } }));
  this->Update(filter);
  if (this->IsFirst())
  {
    EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), 0);
    EXPECT_EQ(filter->GetGenus(), 0);
    EXPECT_EQ(filter->GetNumberOfComponents(), 1);
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, ParallelFiles)
{
  const std::string name =
    std::string(DGG_TEST_OUTPUT) + "/SeveralProcesses" + std::to_string(this->Count) + ".pvtp";
  vtkNew<vtkXMLPPolyDataWriter> writer;
  writer->SetInputData(this->TakeRandom(this->Surface, 11));
  writer->SetController(this->Controller);
  writer->SetFileName(name.c_str());
  writer->SetNumberOfPieces(this->Count);
  writer->SetStartPiece(this->Here);
  writer->SetEndPiece(this->Here);
  writer->SetWriteSummaryFile(1);
  writer->Update();
  this->Controller->Barrier();
  vtkNew<vtkXMLPPolyDataReader> reader;
  reader->SetFileName(name.c_str());
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSourceData(MakeSources());
  this->Update(filter);
  const auto alone = Alone<vtkDGGDistance>(
    this->Surface, [](vtkDGGDistance* other) { other->SetSourceData(MakeSources()); });
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", FloatTolerance);
}

//------------------------------------------------------------------------------
/// Four pieces in a file, of which a process may have several side by side.
TEST_F(SeveralProcesses, FilesOfMorePieces)
{
  const std::string base =
    std::string(DGG_TEST_OUTPUT) + "/FourPieces" + std::to_string(this->Count);
  if (this->IsFirst())
  {
    std::ofstream file(base + ".pvtp");
    file << "<VTKFile type=\"PPolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<PPolyData GhostLevel=\"0\">\n"
            "<PPointData><PDataArray type=\"Int64\" Name=\"Whole\"/></PPointData>\n"
            "<PPoints><PDataArray type=\"Float64\" NumberOfComponents=\"3\"/></PPoints>\n";
    for (int i = 0; i < 4; ++i)
    {
      const std::string name = base + "_" + std::to_string(i) + ".vtp";
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetFileName(name.c_str());
      writer->SetInputData(TakePart(this->Surface, LabelRandomly(this->Surface, 4, 13), i));
      writer->Write();
      file << "<Piece Source=\"" << name.substr(name.rfind('/') + 1) << "\"/>\n";
    }
    file << "</PPolyData>\n</VTKFile>\n";
  }
  this->Controller->Barrier();
  vtkNew<vtkXMLPPolyDataReader> reader;
  reader->SetFileName((base + ".pvtp").c_str());
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSourceData(MakeSources());
  filter->MergeCoincidentPointsOn();
  this->Update(filter);
  const auto alone = Alone<vtkExactGeodesicDistance>(
    this->Surface, [](vtkExactGeodesicDistance* other) { other->SetSourceData(MakeSources()); });
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 1e-12);
}

//------------------------------------------------------------------------------
/// Wherever something is wrong, all processes say so, and go on together.
TEST_F(SeveralProcesses, ErrorsOfOneProcess)
{
  if (this->Count == 1)
  {
    GTEST_SKIP() << "the whole surface is here";
  }
  const auto part = this->TakeStrip(this->Surface);
  vtkNew<vtkPolyData> bad;
  const auto sources = MakeSources();
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputData(part);
  filter->SetSourceData(sources);
  const auto expectError = [&](const char* text) {
    const Listener listener(filter);
    this->Update(filter);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find(text), std::string::npos) << listener.Errors[0];
    EXPECT_NE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    ExpectEmptyOutput(filter);
  };
  for (const bool isMissing : { true, false })
  {
    bad->DeepCopy(part);
    if (this->Here == this->Count - 1 && isMissing)
    {
      const vtkIdType cell[3] = { 0, 1, 1000000 };
      bad->GetPolys()->InsertNextCell(3, cell);
    }
    else if (this->Here == this->Count - 1)
    {
      bad->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
    }
    filter->SetInputData(bad);
    expectError(isMissing ? "names point 1000000" : "not finite");
  }
  filter->SetInputData(part);
  filter->SetGatherLimit(100);
  expectError("GatherLimit is 100");
  filter->SetGatherLimit(1000000);
  filter->SetMemoryLimit(1000);
  expectError("gathering the pieces");
  filter->SetMemoryLimit(0);
  filter->SetProjectionTolerance(-1.0);
  expectError("ProjectionTolerance");
  filter->SetProjectionTolerance(0.01);
  filter->SetController(nullptr);
  expectError("pieces was asked for");
  filter->SetController(this->Controller);
  filter->UpdatePiece(0, this->Count + 1, 0);
  EXPECT_NE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));

  // The first process is asked to stop.
  ProgressWatch watch(filter);
  watch.StopAt = this->IsFirst() ? 0.3 : 2.0;
  filter->SetAccuracy(0.02);
  this->Update(filter);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  watch.StopAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Modified();
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), part->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, GlobalIdsInTwoPlaces)
{
  if (this->Count == 1)
  {
    GTEST_SKIP() << "the whole surface is here";
  }
  const auto part = this->TakeStrip(this->Surface, PartIds::Global);
  vtkDataArray* ids = part->GetPointData()->GetGlobalIds();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetTuple1(i, static_cast<double>(i)); // those of this process
  }
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputData(part);
  filter->SetSourceIds({ 0 });
  const Listener listener(filter);
  this->Update(filter);
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("have the global id"), std::string::npos);
}

//------------------------------------------------------------------------------
/// Blocks of which each process has a part.
TEST_F(SeveralProcesses, BlocksInParts)
{
  vtkNew<vtkMultiBlockDataSet> whole;
  vtkNew<vtkMultiBlockDataSet> part;
  for (unsigned int block = 0; block < 3; ++block)
  {
    const auto surface = MakeTerrain(15 + 4 * static_cast<int>(block));
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      surface->GetPoints()->SetPoint(i, p[0] + block, p[1], p[2]);
    }
    whole->SetBlock(block, surface);
    // Of the second block, only the first process has a part.
    part->SetBlock(block,
      block != 1          ? this->TakeStrip(surface).Get()
        : this->IsFirst() ? TakePart(surface, Labels(surface->GetNumberOfCells(), 0), 0).Get()
                          : nullptr);
  }
  const std::function<void(vtkDGGDistance*)> prepare = [](vtkDGGDistance* filter) {
    filter->SetSourceData(MakeSourcePoints({ { { 0.3, 0.5, GetTerrainHeight(0.3, 0.5) } },
      { { 2.8, 0.5, GetTerrainHeight(0.8, 0.5) } } }));
    filter->SetUnreachedValue(-1.0);
  };
  vtkNew<vtkDGGDistance> alone;
  alone->SetController(nullptr);
  alone->SetInputDataObject(whole);
  prepare(alone);
  alone->Update();
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  auto* expected = vtkMultiBlockDataSet::SafeDownCast(alone->GetOutputDataObject(0));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (unsigned int block = 0; block < 3; ++block)
  {
    auto* leaf = vtkPolyData::SafeDownCast(output->GetBlock(block));
    EXPECT_EQ(leaf != nullptr, block != 1 || this->IsFirst());
    if (leaf)
    {
      ExpectArray(leaf, vtkPolyData::SafeDownCast(expected->GetBlock(block)), "GeodesicDistance",
        FloatTolerance);
    }
  }
  // Each process alone, with the same parts.
  filter->SetSourceData(MakeSourcePoints({ { { (this->Here + 0.5) / this->Count, 0.5, 0.0 } } }));
  filter->SetProjectionTolerance(0.5);
  filter->Update();
  output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(GetNumberOfReached(vtkPolyData::SafeDownCast(output->GetBlock(0))),
    vtkPolyData::SafeDownCast(part->GetBlock(0))->GetNumberOfPoints());
}
