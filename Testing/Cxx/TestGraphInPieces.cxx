// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs that several processes build together. Run under mpiexec; a single process is valid, too.
#include "PieceGraphFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDiscreteGeodesicGraph.h"

#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

using namespace dggtest;

namespace
{
struct Case
{
  const char* Name;
  vtkSmartPointer<vtkPolyData> (*Make)();
  double Accuracy;
};

vtkSmartPointer<vtkPolyData> MakeTwoComponents()
{
  return Beside(MakeTerrain(24), MakeCube(), 3.0);
}

/// A strip along which windows cross many cells, so that regions grow after the first round.
vtkSmartPointer<vtkPolyData> MakeLongStrip()
{
  auto strip = MakeGrid(150, 3, GridCells::Quads);
  MovePoints(strip, [](double* p) {
    p[0] += 0.3 * std::sin(5.1 * p[0] + 7.3 * p[1]);
    p[1] += 0.3 * std::sin(3.7 * p[0] + 2.9 * p[1]);
  });
  return strip;
}

/// Three bumpy sheets that share a row of points; its edges have three triangles.
vtkSmartPointer<vtkPolyData> MakePages()
{
  constexpr int n = 12;
  Points points;
  Cells cells;
  for (int page = 0; page < 3; ++page)
  {
    const double turn = 2.0 * vtkMath::Pi() * page / 3.0;
    const auto getId = [&](int i, int j) {
      return static_cast<vtkIdType>(j == 0 ? i : n + (page * (n - 1) + j - 1) * n + i);
    };
    for (int j = page == 0 ? 0 : 1; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const double out = j + 0.2 * std::sin(1.7 * i + j + page);
        points.push_back({ { static_cast<double>(i) + 0.1 * std::cos(1.3 * i),
          j == 0 ? 0.0 : out * std::cos(turn), j == 0 ? 0.0 : out * std::sin(turn) } });
      }
    }
    for (int j = 0; j + 1 < n; ++j)
    {
      for (int i = 0; i + 1 < n; ++i)
      {
        cells.push_back({ getId(i, j), getId(i + 1, j), getId(i, j + 1) });
        cells.push_back({ getId(i + 1, j), getId(i + 1, j + 1), getId(i, j + 1) });
      }
    }
  }
  return MakeSurface(points, cells);
}

const Case cases[] = { { "Terrain", [] { return MakeTerrain(32); }, 0.05 },
  { "TwoComponents", MakeTwoComponents, 0.02 }, { "Pages", MakePages, 0.05 },
  { "Quads", [] { return MakeGrid(30, 20, GridCells::Quads); }, 0.1 },
  { "LongStrip", MakeLongStrip, 0.001 },
  { "DoubleLengths", [] { return MakeTerrain(10); }, 5e-6 } };

class GraphInPieces
  : public PieceGraph
  , public testing::WithParamInterface<std::tuple<Division, Case>>
{
protected:
  const Case& GetCase() const { return std::get<1>(this->GetParam()); }

  Labels GetLabels(vtkPolyData* surface) const
  {
    return std::get<0>(this->GetParam()).Label(surface, this->Count);
  }

  vtkSmartPointer<vtkPolyData> TakePiece(vtkPolyData* surface, bool ghosts) const
  {
    return TakePart(surface, this->GetLabels(surface), this->Here, PartIds::Global, ghosts);
  }
};
}

//------------------------------------------------------------------------------
/// Rows, and distances along them, are those of a single process, bit by bit.
TEST_P(GraphInPieces, RowsAndDistancesAreTheSame)
{
  const auto surface = this->GetCase().Make();
  const auto prepare = [&](auto* graph) { graph->SetAccuracy(this->GetCase().Accuracy); };
  const auto alone = Alone<vtkDiscreteGeodesicGraph>(surface, prepare);
  const auto piece = this->TakePiece(surface, this->Count % 2 == 0);
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(piece);
  prepare(graph.Get());
  this->Update(graph);
  this->ExpectRows(graph->GetOutput(), alone->GetOutput());

  const vtkIdType onRim = FindSharedPoint(surface, this->GetLabels(surface));
  const double radius = 0.4 * surface->GetLength();
  const std::vector<std::function<void(vtkDGGDistance*)>> searches = {
    [&](vtkDGGDistance* filter) {
      filter->SetSourceIds({ 5, 60, onRim });
    },
    [&](vtkDGGDistance* filter) {
      filter->SetSourceIds({ 7, 31, 7 }, { 0.1, 0.0, 0.05 });
      filter->SetMaximumDistance(radius);
    },
    [](vtkDGGDistance* filter) {
      filter->SetSourceIds({ 60, 5 });
      filter->CorrectionOff();
    },
    [&](vtkDGGDistance* filter) {
      filter->SetSourceIds({ 17 });
      filter->SetInputData(1, MakePointsOfCells(surface)); // on all processes
      filter->SetMaximumDistance(VTK_DOUBLE_MAX);
      filter->CorrectionOn();
    }
  };
  vtkNew<vtkDGGDistance> distance;
  vtkNew<vtkDGGDistance> expected;
  expected->SetController(nullptr);
  distance->SetInputData(graph->GetOutput());
  expected->SetInputData(alone->GetOutput());
  for (const auto& search : searches)
  {
    for (vtkDGGDistance* filter : { distance.Get(), expected.Get() })
    {
      filter->SetUnreachedValue(-1.0);
      filter->GenerateNearestSourceOn();
      filter->GenerateUpperBoundOn();
      search(filter);
    }
    expected->Update();
    this->Update(distance);
    for (const char* name : { "GeodesicDistance", "GeodesicSource", "GeodesicUpperBound" })
    {
      ExpectArray(distance->GetOutput(), expected->GetOutput(), name, 0.0);
    }
    EXPECT_TRUE(distance->GetUsedInputGraph()); // on all processes
    EXPECT_EQ(distance->GetGraphBuildTime(), 0u);
    this->ExpectRows(distance->GetOutput(), alone->GetOutput());
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, GraphInPieces,
  testing::Combine(testing::ValuesIn(divisions), testing::ValuesIn(cases)),
  [](const testing::TestParamInfo<GraphInPieces::ParamType>& tested) {
    return std::string(std::get<0>(tested.param).Name) + std::get<1>(tested.param).Name;
  });

//------------------------------------------------------------------------------
/// The other rules, and polygons with more than three corners in pieces with ghosts.
TEST_F(PieceGraph, OtherRules)
{
  const auto surface = MakeGrid(24, 10, GridCells::Quads);
  MovePoints(surface, [](double* p) { p[2] = GetTerrainHeight(0.03 * p[0], 0.07 * p[1]); });
  for (const int rule :
    { vtkDiscreteGeodesicGraph::OneRelay, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    const auto prepare = [&](auto* graph) {
      graph->SetConstruction(rule);
      graph->SetAccuracy(0.1);
      graph->SetNumberOfNeighbors(12);
    };
    const auto alone = Alone<vtkDiscreteGeodesicGraph>(surface, prepare);
    const auto piece =
      TakePart(surface, LabelBisection(surface, this->Count), this->Here, PartIds::Global, true);
    const auto graph = this->Together<vtkDiscreteGeodesicGraph>(piece, prepare);
    this->ExpectRows(graph->GetOutput(), alone->GetOutput());
  }
}

//------------------------------------------------------------------------------
/// The first process gives the warnings of a single process.
TEST_F(PieceGraph, WarnsAboutDefects)
{
  Points points;
  Cells cells;
  for (vtkIdType i = 0; i < 40; ++i) // a band of triangles
  {
    points.push_back({ { 0.5 * i, i % 2 == 0 ? 0.0 : 1.0, 0.0 } });
    if (i >= 2)
    {
      cells.push_back(i % 2 == 0 ? std::vector<vtkIdType>{ i - 2, i, i - 1 }
                                 : std::vector<vtkIdType>{ i - 2, i - 1, i });
    }
  }
  for (vtkIdType i = 5; i < 36; i += 10) // of each kind of defects, one in each part of the band
  {
    const auto added = static_cast<vtkIdType>(points.size());
    points.push_back({ { 0.5 * i, 0.5, 1.0 } });
    points.push_back({ { 0.5 * i + 0.5, 0.4, 1.0 } });
    points.push_back({ { 0.5 * i + 0.4, 0.7, 1.5 } });
    cells.push_back({ i, i + 1, added });             // a third triangle of an edge
    cells.push_back({ i + 4, added + 1, added + 2 }); // a layer that touches another one
    cells.push_back({ i - 1, i, i + 1 });             // a duplicate
    cells.push_back({ i, i, i + 1 });                 // no triangle
    points.push_back({ { 0.5 * i, 3.0, 0.0 } });      // a quad that crosses itself
    points.push_back({ { 0.5 * i + 1.0, 4.0, 0.0 } });
    points.push_back({ { 0.5 * i + 1.0, 3.0, 0.0 } });
    points.push_back({ { 0.5 * i, 4.0, 0.0 } });
    cells.push_back({ added + 3, added + 4, added + 5, added + 6 });
  }
  const auto surface = MakeSurface(points, cells);
  const auto getWarnings = [](vtkPolyData* data, vtkMultiProcessController* controller,
                             const auto& update) {
    vtkNew<vtkDiscreteGeodesicGraph> graph;
    graph->SetController(controller);
    graph->SetInputData(data);
    graph->SetAccuracy(0.1);
    const Listener listener(graph);
    update(graph.Get());
    EXPECT_EQ(graph->GetOutput()->GetFieldData()->HasArray("DGG.GhostIds"), controller ? 1 : 0);
    std::vector<std::string> warnings; // without the address of the filter
    for (const std::string& text : listener.Warnings)
    {
      warnings.push_back(text.substr(text.find("The mesh")));
    }
    return warnings;
  };
  const auto alone = getWarnings(surface, nullptr, [](vtkAlgorithm* filter) { filter->Update(); });
  const auto together = getWarnings(this->TakeStrip(surface, PartIds::Global, true),
    this->Controller, [this](vtkAlgorithm* filter) { this->Update(filter); });
  EXPECT_EQ(alone.size(), 5u);
  EXPECT_EQ(together, this->IsFirst() ? alone : std::vector<std::string>());
}

//------------------------------------------------------------------------------
/// Pieces that cannot be distributed are gathered. The first process then has the graph of a single
/// process, and a second filter passes it on.
TEST_F(PieceGraph, GathersOtherPieces)
{
  const auto plain = MakeTerrain(12);
  const auto turned = MakeTerrain(12); // one triangle has another orientation
  vtkNew<vtkIdList> corners;
  turned->GetPolys()->GetCellAtId(50, corners);
  const vtkIdType reversed[3] = { corners->GetId(0), corners->GetId(2), corners->GetId(1) };
  turned->GetPolys()->ReplaceCellAtId(50, 3, reversed);
  const auto flat = MakeTerrain(12); // a triangle has no area
  double p[3];
  flat->GetPoint(40, p);
  flat->GetPoints()->SetPoint(41, p);
  using Graph = vtkDiscreteGeodesicGraph;
  const std::vector<std::pair<vtkPolyData*, std::function<void(Graph*)>>> gathered = {
    { turned, [](Graph*) {} }, { flat, [](Graph*) {} },
    { plain, [](Graph* graph) { graph->SetConstructionToIndirect(); } },
    { plain, [](Graph* graph) { graph->GenerateGraphLinesOn(); } }
  };
  for (const auto& [surface, prepare] : gathered)
  {
    const auto setUp = [&prepare = prepare](Graph* graph) {
      graph->SetAccuracy(0.1);
      prepare(graph);
    };
    const auto alone = Alone<Graph>(surface, setUp);
    vtkNew<Graph> graph;
    graph->SetInputData(this->TakeStrip(surface, PartIds::Global));
    setUp(graph);
    this->Update(graph);
    for (const char* name : { "DGG.Offsets", "DGG.Targets", "DGG.Lengths", "DGG.Angles" })
    {
      EXPECT_EQ(GetValues(graph->GetOutput(), name),
        this->IsFirst() ? GetValues(alone->GetOutput(), name) : std::vector<double>());
    }
    vtkNew<Graph> next;
    next->SetInputData(graph->GetOutput());
    next->SetAccuracy(0.1);
    next->SetConstruction(graph->GetConstruction());
    this->Update(next);
    EXPECT_EQ(next->GetGraphBuildTime(), 0u);
  }
}

//------------------------------------------------------------------------------
/// The graph of pieces can be written and read, and is passed on if nothing has changed. After a
/// change on one process, all of them build it again.
TEST_F(PieceGraph, IsWrittenAndRead)
{
  const auto prepare = [](auto* graph) { graph->SetAccuracy(0.1); };
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(
    this->TakeStrip(this->Surface, PartIds::Global), prepare);
  const vtkMTimeType built = graph->GetGraphBuildTime();
  graph->Modified();
  this->Update(graph);
  EXPECT_EQ(graph->GetGraphBuildTime(), built);

  const std::string file = std::string(DGG_TEST_OUTPUT) + "/GraphInPieces" +
    std::to_string(this->Count) + "_" + std::to_string(this->Here) + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(graph->GetOutput());
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  const auto again = this->Together<vtkDiscreteGeodesicGraph>(read, prepare);
  EXPECT_EQ(again->GetGraphBuildTime(), 0u);
  EXPECT_EQ(again->GetNumberOfGraphEdges(), graph->GetNumberOfGraphEdges());
  const auto search = [](auto* filter) { filter->SetSourceIds({ 5 }); };
  const auto expected = this->Together<vtkDGGDistance>(graph->GetOutput(), search);
  const auto distance = this->Together<vtkDGGDistance>(read, search);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(distance), GetDistances(expected));

  // One process has another surface than the graph.
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(read);
  if (this->IsFirst())
  {
    MovePoints(moved, [](double* p) { p[2] += p[0] == 0.0 ? 0.1 : 0.0; });
  }
  vtkNew<vtkDiscreteGeodesicGraph> other;
  prepare(other.Get());
  other->SetInputData(moved);
  const Listener listener(other);
  this->Update(other);
  EXPECT_GT(other->GetGraphBuildTime(), 0u);
  ASSERT_EQ(listener.Warnings.size(), 1u);
  EXPECT_NE(listener.Warnings[0].find("out of date"), std::string::npos) << listener.Warnings[0];
}

//------------------------------------------------------------------------------
/// A piece may have no field data.
TEST_F(PieceGraph, OfPieceWithoutFieldData)
{
  const auto prepare = [](auto* graph) { graph->SetAccuracy(0.1); };
  const auto piece = this->TakeStrip(this->Surface, PartIds::Global);
  if (this->IsFirst())
  {
    piece->SetFieldData(nullptr);
  }
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(piece, prepare);
  this->ExpectRows(
    graph->GetOutput(), Alone<vtkDiscreteGeodesicGraph>(this->Surface, prepare)->GetOutput());
}

//------------------------------------------------------------------------------
/// If properties differ, those of the first process count. A graph is not kept for another piece.
TEST_F(PieceGraph, PropertiesAndPiecesThatDiffer)
{
  const auto prepare = [](auto* graph) { graph->SetAccuracy(0.1); };
  const auto alone = Alone<vtkDiscreteGeodesicGraph>(this->Surface, prepare);
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetAccuracy(this->IsFirst() ? 0.1 : 0.5);
  const Labels labels = LabelStrips(this->Surface, this->Count);
  for (const int shift : { 0, 1 })
  {
    graph->SetInputData(
      TakePart(this->Surface, labels, (this->Here + shift) % this->Count, PartIds::Global, false));
    this->Update(graph);
    this->ExpectRows(graph->GetOutput(), alone->GetOutput());
  }
  if (!this->IsFirst())
  {
    graph->SetConstructionToIndirect();
  }
  graph->Modified();
  this->Update(graph); // gathers
  EXPECT_EQ(graph->GetNumberOfGraphEdges(), this->IsFirst() ? alone->GetNumberOfGraphEdges() : 0);
}

//------------------------------------------------------------------------------
/// A filter that merges points does not use a graph without merged points.
TEST_F(PieceGraph, OfPointsThatAreMerged)
{
  Points points;
  Cells cells;
  for (int sheet = 0; sheet < 2; ++sheet) // with the points of one side twice
  {
    const auto getId = [&](
                         int i, int j) { return static_cast<vtkIdType>(100 * sheet + 10 * j + i); };
    for (int j = 0; j < 10; ++j)
    {
      for (int i = 0; i < 10; ++i)
      {
        points.push_back({ { i + 9.0 * sheet, static_cast<double>(j), 0.0 } });
        if (i < 9 && j < 9)
        {
          cells.push_back({ getId(i, j), getId(i + 1, j), getId(i, j + 1) });
          cells.push_back({ getId(i + 1, j), getId(i + 1, j + 1), getId(i, j + 1) });
        }
      }
    }
  }
  const auto surface = MakeSurface(points, cells);
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(
    this->TakeStrip(surface, PartIds::Global), [](auto* filter) { filter->SetAccuracy(0.1); });
  const auto search = [](auto* filter) {
    filter->SetSourceIds({ 0 });
    filter->MergeCoincidentPointsOn();
  };
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(graph->GetOutput());
  search(distance.Get());
  this->Update(distance);
  EXPECT_FALSE(distance->GetUsedInputGraph());
  ExpectArray(distance->GetOutput(), Alone<vtkDGGDistance>(surface, search)->GetOutput(),
    "GeodesicDistance", 0.0);
}

//------------------------------------------------------------------------------
/// An error, exhausted memory or an abort of one process ends the update of all processes.
TEST_F(PieceGraph, ErrorsOfOneProcess)
{
  const auto part = this->TakeStrip(this->Surface, PartIds::Global);
  const bool isLast = this->Here == this->Count - 1;
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(part);
  const auto expectError = [&](const char* text) {
    const Listener listener(graph);
    this->Update(graph);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find(text), std::string::npos) << listener.Errors[0];
    ExpectEmptyOutput(graph);
  };
  graph->SetAccuracy(isLast ? 2.0 : 0.01);
  expectError("Accuracy is 2");
  graph->SetAccuracy(0.01);
  graph->SetMemoryLimit(isLast ? 1000 : 0);
  expectError("more than the limit of 1000 bytes");
  graph->SetMemoryLimit(0);
  vtkNew<vtkPolyData> bad;
  bad->DeepCopy(part);
  if (isLast)
  {
    const vtkIdType cell[3] = { 0, 1, 1000000 };
    bad->GetPolys()->InsertNextCell(3, cell);
  }
  graph->SetInputData(bad);
  expectError("1000000");
  graph->SetInputData(part);
  ProgressWatch watch(graph);
  watch.StopAt = isLast ? 0.3 : 2.0;
  this->Update(graph);
  EXPECT_EQ(graph->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(graph->GetOutput()->GetNumberOfPoints(), 0);
  watch.StopAt = 2.0;
  this->Update(graph);
  EXPECT_GT(graph->GetNumberOfGraphEdges(), 0);
}
