// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs that several processes build together. Run under mpiexec; a single process is valid, too.
#include "SeveralProcessesFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDiscreteGeodesicGraph.h"

#include "vtkFieldData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

using namespace dggtest;

namespace
{
/// Values of an array in field data; empty if there is no such array.
std::vector<double> GetValues(vtkPolyData* data, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

struct Division
{
  const char* Name;
  Labels (*Label)(vtkPolyData* surface, int parts);
};

/// Assigns cells to connected pieces, and the components without a seed to the first one.
Labels LabelConnected(vtkPolyData* surface, int parts)
{
  Labels labels = LabelRandomly(surface, parts, 5);
  std::replace(labels.begin(), labels.end(), -1, 0);
  return labels;
}

/// Assigns cells to strips; the last of more than two pieces is empty.
Labels LabelStripsButOne(vtkPolyData* surface, int parts)
{
  return LabelStrips(surface, parts > 2 ? parts - 1 : parts);
}

const Division divisions[] = { { "Strips", LabelStrips }, { "Bisection", LabelBisection },
  { "Connected", LabelConnected }, { "Scattered", LabelScattered },
  { "OneIsEmpty", LabelStripsButOne } };

/// Returns the centers of some cells, and points between two of their corners.
vtkSmartPointer<vtkPolyData> MakePointsOfCells(vtkPolyData* surface)
{
  Points points;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 3; cell < surface->GetNumberOfCells();
       cell += surface->GetNumberOfCells() / 7 + 1)
  {
    surface->GetCellPoints(cell, corners);
    std::array<double, 3> center{};
    std::array<double, 3> middle{};
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double x = surface->GetPoint(corners->GetId(k))[axis];
        center[axis] += x / static_cast<double>(corners->GetNumberOfIds());
        middle[axis] += k < 2 ? 0.5 * x : 0.0;
      }
    }
    points.push_back(center);
    points.push_back(middle);
  }
  return MakeSourcePoints(points);
}

/// Returns a point of cells with different labels.
vtkIdType FindSharedPoint(vtkPolyData* surface, const Labels& labels)
{
  std::vector<int> labelOfPoints(surface->GetNumberOfPoints(), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      int& label = labelOfPoints[corners->GetId(k)];
      if (label >= 0 && label != labels[cell])
      {
        return corners->GetId(k);
      }
      label = labels[cell];
    }
  }
  ADD_FAILURE() << "the pieces do not touch";
  return 0;
}

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

class PieceGraph : public SeveralProcesses
{
protected:
  void SetUp() override
  {
    if (this->Count == 1)
    {
      GTEST_SKIP() << "the test needs several processes";
    }
  }

  vtkIdType Sum(vtkIdType here) const
  {
    vtkIdType sum = 0;
    this->Controller->AllReduce(&here, &sum, 1, vtkCommunicator::SUM_OP);
    return sum;
  }

  /// Expects that the rows of a piece are rows of a graph, bit by bit, and that each row is in one
  /// piece.
  void ExpectRows(vtkPolyData* piece, vtkPolyData* whole) const
  {
    const auto offsets = GetValues(piece, "DGG.Offsets");
    const auto targets = GetValues(piece, "DGG.Targets");
    const auto ghosts = GetValues(piece, "DGG.GhostIds");
    const auto owners = GetValues(piece, "DGG.Owners");
    const auto all = GetValues(whole, "DGG.Offsets");
    const auto allTargets = GetValues(whole, "DGG.Targets");
    const vtkIdType n = piece->GetNumberOfPoints();
    ASSERT_EQ(offsets.size(), n + ghosts.size() + 1);
    ASSERT_EQ(owners.size(), n + ghosts.size());
    vtkIdType edges = 0;
    vtkDataArray* ids = piece->GetPointData()->GetArray("Whole");
    const auto getId = [&](double target) {
      const auto v = static_cast<vtkIdType>(target);
      return v < n ? ids->GetComponent(v, 0) : ghosts[v - n];
    };
    for (vtkIdType i = 0; i < n; ++i)
    {
      const auto id = static_cast<std::size_t>(getId(static_cast<double>(i)));
      const auto begin = static_cast<std::size_t>(offsets[i]);
      const auto size = static_cast<std::size_t>(offsets[i + 1]) - begin;
      if (owners[i] >= 0.0)
      {
        continue; // the point belongs to another process
      }
      edges += static_cast<vtkIdType>(size);
      const auto to = static_cast<std::size_t>(all[id]);
      ASSERT_EQ(size, static_cast<std::size_t>(all[id + 1]) - to) << "point " << id;
      for (std::size_t e = 0; e < size; ++e)
      {
        ASSERT_EQ(getId(targets[begin + e]), allTargets[to + e]) << "point " << id;
      }
      for (const char* name : { "DGG.Lengths", "DGG.Angles", "DGG.ArrivalAngles" })
      {
        const auto values = GetValues(piece, name);
        const auto expected = GetValues(whole, name);
        ASSERT_TRUE(
          std::equal(values.begin() + begin, values.begin() + begin + size, expected.begin() + to))
          << name << " of point " << id;
      }
    }
    EXPECT_EQ(this->Sum(edges), static_cast<vtkIdType>(allTargets.size()));
  }
};

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
/// Sources that are missing or far from the surface, and points without cells, are reported as by
/// one process.
TEST_F(PieceGraph, ReportsSources)
{
  const auto surface = MakeTerrain(12);
  const auto part = this->TakeStrip(surface, PartIds::Global);
  if (this->Here == this->Count - 1)
  {
    part->GetPoints()->InsertNextPoint(0.5, 0.5, 3.0);
    for (const char* name : { "Whole", "GlobalPointIds" })
    {
      vtkIdTypeArray::SafeDownCast(part->GetPointData()->GetArray(name))->InsertNextValue(144);
    }
  }
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(part);
  distance->SetAccuracy(0.1);
  const Listener listener(distance);
  const auto expectError = [&](const char* text) {
    this->Update(distance);
    ASSERT_FALSE(listener.Errors.empty());
    EXPECT_NE(listener.Errors.back().find(text), std::string::npos) << listener.Errors.back();
    ExpectEmptyOutput(distance);
  };
  expectError("There is no source");
  distance->SetSourceIds({ 3, 145 });
  expectError("Source id 145 is out of range: the input has 145 points");
  distance->RemoveAllSourceIds();
  const double* const p = surface->GetPoint(70);
  distance->SetSourceData(MakeSourcePoints({ { { p[0], p[1], p[2] } }, { { 0.5, 0.5, 9.0 } } }));
  expectError("Source 1, at (0.5, 0.5, 9), is ");
  distance->RemoveAllSources();
  distance->SetSourceIds({ 3, 144 });
  const std::size_t errors = listener.Errors.size();
  this->Update(distance);
  EXPECT_EQ(listener.Errors.size(), errors);
  ASSERT_EQ(listener.Warnings.size(), this->IsFirst() ? 1u : 0u);
  if (this->IsFirst())
  {
    EXPECT_NE(
      listener.Warnings[0].find("Source id 144 is a point that no polygon uses"), std::string::npos)
      << listener.Warnings[0];
  }
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
/// An update after a failure or an abort gives the distances of one process, and getters describe
/// the last update.
TEST_F(PieceGraph, DistancesAfterFailures)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceData(MakeSources());
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->TakeStrip(this->Surface, PartIds::Global));
  search(distance.Get());
  const auto expectDistances = [&] {
    this->Update(distance);
    EXPECT_EQ(this->Sum(distance->GetNumberOfGraphEdges()), alone->GetNumberOfGraphEdges());
    ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  };
  const bool isLast = this->Here == this->Count - 1;
  const Listener listener(distance);
  distance->SetMemoryLimit(isLast ? 1000 : 0);
  this->Update(distance);
  EXPECT_EQ(listener.Errors.size(), 1u);
  EXPECT_EQ(distance->GetNumberOfGraphEdges(), 0);
  distance->SetMemoryLimit(0);
  distance->Modified();
  expectDistances();
  ProgressWatch watch(distance);
  for (const double stopAt : { 0.3, 0.6, 0.75, 0.9 })
  {
    watch.StopAt = isLast ? stopAt : 2.0;
    distance->Modified();
    this->Update(distance);
    EXPECT_EQ(distance->GetOutput()->GetNumberOfPoints(), 0) << stopAt;
    watch.StopAt = 2.0;
    expectDistances();
  }
  distance->PassSourceArraysOn(); // gathers
  this->Update(distance);
  EXPECT_EQ(
    distance->GetNumberOfGraphEdges(), this->IsFirst() ? alone->GetNumberOfGraphEdges() : 0);
  EXPECT_EQ(listener.Errors.size(), 1u);
}

//------------------------------------------------------------------------------
/// Ids of sources are numbers of points, whatever global ids the points have. Offsets may be so
/// large that lengths are lost.
TEST_F(PieceGraph, IdsAndOffsetsOfSources)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceIds({ 0, 77 }, { 0.1, 0.0 });
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  using Rule = vtkIdType (*)(vtkIdType);
  for (const Rule rule : { Rule([](vtkIdType id) { return id + 1; }),
         Rule([](vtkIdType id) { return 2 * id; }), Rule([](vtkIdType id) { return id - 5; }) })
  {
    const auto piece = this->TakeStrip(this->Surface, PartIds::Global);
    auto* ids = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetGlobalIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      ids->SetValue(i, rule(ids->GetValue(i)));
    }
    const auto distance = this->Together<vtkDGGDistance>(piece, search);
    ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  }
  const auto far = [&](auto* filter) {
    search(filter);
    filter->SetSourceIds({ 0, 77 }, { 1e17, 1e17 });
  };
  ExpectArray(this->Together<vtkDGGDistance>(this->TakeStrip(this->Surface, PartIds::Global), far)
                ->GetOutput(),
    Alone<vtkDGGDistance>(this->Surface, far)->GetOutput(), "GeodesicDistance", 0.0);
}

//------------------------------------------------------------------------------
/// A graph belongs to its piece: pieces that have exchanged their graphs do not use them.
TEST_F(PieceGraph, BelongsToItsPiece)
{
  const auto surface = Beside(MakeTerrain(12), MakeTerrain(12), 3.0);
  MovePoints(surface, [](double* p) { p[2] *= p[0] > 2.0 ? 5.0 : 1.0; });
  const Labels labels = LabelStrips(surface, 2);
  const auto take = [&](int label) {
    return TakePart(surface, labels, label, PartIds::Global, false); // may be empty
  };
  const auto prepare = [](auto* graph) { graph->SetAccuracy(0.1); };
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(take(this->Here), prepare);
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(take(this->Here < 2 ? 1 - this->Here : this->Here));
  moved->SetFieldData(graph->GetOutput()->GetFieldData());
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(moved);
  distance->SetSourceIds({ 0, 200 });
  const Listener listener(distance);
  this->Update(distance);
  this->Update(distance);
  EXPECT_EQ(listener.Warnings.size(), this->Here < 2 ? 1u : 0u);
  EXPECT_FALSE(distance->GetUsedInputGraph());
  ExpectArray(distance->GetOutput(),
    Alone<vtkDGGDistance>(surface,
      [](auto* filter) {
        filter->SetSourceIds({ 0, 200 });
      })
      ->GetOutput(),
    "GeodesicDistance", 0.0);
}

//------------------------------------------------------------------------------
/// Global ids number the points, also if one process has all of them.
TEST_F(PieceGraph, IdsNumberThePointsOfOneProcess)
{
  const auto piece = TakePart(this->Surface, Labels(this->Surface->GetNumberOfCells(), 0),
    this->Here, PartIds::Global, false);
  if (this->IsFirst())
  {
    vtkNew<vtkPolyData> turned; // the points in reversed order
    const vtkIdType n = piece->GetNumberOfPoints();
    turned->DeepCopy(piece);
    for (vtkIdType i = 0; i < n; ++i)
    {
      turned->GetPoints()->SetPoint(i, piece->GetPoint(n - 1 - i));
      for (const char* name : { "Whole", "GlobalPointIds" })
      {
        turned->GetPointData()->GetArray(name)->SetTuple(
          i, n - 1 - i, piece->GetPointData()->GetArray(name));
      }
    }
    vtkDataArray* corners = turned->GetPolys()->GetConnectivityArray();
    for (vtkIdType k = 0; k < corners->GetNumberOfTuples(); ++k)
    {
      corners->SetTuple1(k, static_cast<double>(n - 1) - corners->GetTuple1(k));
    }
    piece->DeepCopy(turned);
  }
  const auto search = [](auto* filter) {
    filter->SetSourceIds({ 5, 77 });
    filter->GenerateVirtualSourceOn(); // gathers
  };
  ExpectArray(this->Together<vtkDGGDistance>(piece, search)->GetOutput(),
    Alone<vtkDGGDistance>(this->Surface, search)->GetOutput(), "GeodesicDistance", 0.0);
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
