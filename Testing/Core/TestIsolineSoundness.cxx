// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Isolines: continuous and complete for any field, on any mesh; threads, progress, bad arguments.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "IsolineChecks.h"

#include "dggBands.h"
#include "dggFaceProfile.h"
#include "dggGraphSearch.h"
#include "dggIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dgg;
using namespace dggtest;

TEST(Isolines, AreSoundOnAllMeshes)
{
  std::vector<NamedMesh> meshes = SoundMeshes();
  for (NamedMesh& named : DefectMeshes())
  {
    meshes.push_back(std::move(named));
  }
  for (const NamedMesh& named : meshes)
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<GeodesicSource> sources{ VertexSource(1),
      { RandomSurfacePoints(mesh, 1, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } };
    const ExactField field(mesh, sources);
    std::vector<double> levels = EvenLevels(field.Exact, 9);
    levels.push_back(0.02 * mesh.GetMeanEdgeLength());
    levels.push_back(field.Result.Distances[mesh.GetNumberOfVertices() / 2]);
    levels.erase(std::remove_if(levels.begin(), levels.end(),
                   [](double level) { return !std::isfinite(level); }),
      levels.end());
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      const Isolines lines = Trace(*f, levels);
      ExpectSound(*f, levels, lines,
        named.Name +
          (f == &field.Exact      ? ""
              : f == &field.Local ? " (local)"
                                  : " (linear)"));
    }
  }
}

/// On long thin faces the ridges that are looked for between two nodes may leave the face; with the
/// first three seeds they did.
TEST(Isolines, StayInFacesThatAreLongAndThin)
{
  for (const std::uint64_t seed : { 922, 1039, 1997, 1, 2, 3 })
  {
    SCOPED_TRACE(seed);
    const SurfaceMesh mesh = Build(DrilledBar(seed));
    const GeodesicGraph graph = BuildGraph(mesh, 0.01);
    const GraphSearch search(graph.View(), &mesh);
    for (const Id source : { Id{ 1 }, mesh.GetNumberOfVertices() / 2 })
    {
      const ExactField exact(mesh, { VertexSource(source) });
      GraphSeed start;
      start.Vertex = source;
      SearchOptions options;
      options.Correct = true;
      SearchResult result;
      ASSERT_TRUE(search.Run({ start }, options, result).IsOk());
      const DistanceField local{ &mesh, result.Corrected.data(), nullptr, &result.Virtual };
      for (const DistanceField* field : { &exact.Exact, &local })
      {
        const std::vector<double> levels = EvenLevels(*field, 20);
        const Isolines lines = Trace(*field, levels);
        ExpectSound(*field, levels, lines, field == &local ? "graph" : "windows");
        Bands bands;
        const Status status = MakeBands(*field, levels, lines, nullptr, bands);
        EXPECT_TRUE(status.IsOk()) << status.GetMessage();
      }
    }
  }
}

TEST(Isolines, OfAnyNumbersAreSound)
{
  for (const TestMesh& test : { Icosphere(2), Terrain(10, 0.6, 3), RandomSoup(60, 120, 4) })
  {
    const SurfaceMesh mesh = Build(test);
    Random random(9);
    std::vector<double> values;
    VirtualSources sources;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      values.push_back(v % 17 == 16 ? Infinity : random.Uniform(-3.0, 3.0));
      sources.Lengths.push_back(random.Uniform(0.0, 2.0));
      sources.Offsets.push_back(values.back() - sources.Lengths.back());
      sources.Angles.push_back(random.Uniform(-9.0, 9.0));
    }
    const DistanceField linear{ &mesh, values.data(), nullptr, nullptr };
    const DistanceField local{ &mesh, values.data(), nullptr, &sources };
    const std::vector<double> levels{ -2.0, -1.0, 0.0, 0.1, 2.5 };
    for (const DistanceField& field : { linear, local })
    {
      const Isolines lines = Trace(field, levels);
      EXPECT_GT(lines.Lines.size(), 4u);
      ExpectSound(field, levels, lines, field.HasSources() ? "noise (local)" : "noise");
      ExpectSound(field, levels, Trace(field, levels, 0.0, IsolineMethod::Apollonius),
        field.HasSources() ? "noise (Apollonius, local)" : "noise (Apollonius)");
    }
  }
}

TEST(Isolines, OfNumbersThatOverflowLieOnTheSurface)
{
  const SurfaceMesh mesh = Build(Plane(3, 3, 0.2));
  for (const double huge : { 1e17, 1e150, 1e300, 1.7e308 })
  {
    Random random(3);
    std::vector<double> values;
    VirtualSources sources;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      values.push_back(huge * random.Uniform(-1.0, 1.0));
      sources.Lengths.push_back(v % 2 == 0 ? huge : 1.0);
      sources.Offsets.push_back(values.back());
      sources.Angles.push_back(random.Uniform(0.0, 6.0));
    }
    const DistanceField linear{ &mesh, values.data(), nullptr, nullptr };
    const DistanceField local{ &mesh, values.data(), nullptr, &sources };
    for (const DistanceField& field : { linear, local })
    {
      for (const IsolineMethod method : { IsolineMethod::LocalSources, IsolineMethod::Apollonius })
      {
        const Isolines lines = Trace(field, { -0.5 * huge, 0.0, 0.5 * huge }, 0.0, method);
        EXPECT_FALSE(lines.Lines.empty());
        for (const SurfacePath& line : lines.Lines)
        {
          const Status status = CheckPath(mesh, line);
          EXPECT_TRUE(status.IsOk()) << huge << ": " << status.GetMessage();
        }
      }
    }
  }
}

TEST(Isolines, LevelsOfVerticesAreNoTrouble)
{
  const TestMesh test = Plane(8, 8);
  const SurfaceMesh mesh = Build(test);
  const Id source = 4 * 9 + 4;
  const ExactField field(mesh, { VertexSource(source) });
  const std::vector<double> levels{ 0.0, 1.0, 2.0, 3.0, 4.0 };
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    const Isolines lines = Trace(*f, levels);
    ExpectSound(*f, levels, lines, "grid");
    std::map<Id, int> counts = LinesPerLevel(lines);
    EXPECT_EQ(counts[0], 0); // nothing is nearer
    for (Id level = 1; level < 4; ++level)
    {
      EXPECT_EQ(counts[level], 1) << level;
    }
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      EXPECT_TRUE(lines.IsClosed[i] || lines.Levels[i] == 4);
      std::set<Id> vertices;
      for (const SurfacePoint& point : lines.Lines[i].Points)
      {
        if (IsVertex(point))
        {
          vertices.insert(point.Vertex);
        }
      }
      EXPECT_TRUE(vertices.size() >= 4u || !lines.IsClosed[i]);
    }
  }
}

TEST(Isolines, FlatFieldsHaveNone)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const std::vector<double> ones(mesh.GetNumberOfVertices(), 1.0);
  const DistanceField field{ &mesh, ones.data(), nullptr, nullptr };
  EXPECT_TRUE(Trace(field, { 0.5, 1.0, 1.5 }).Lines.empty());
  EXPECT_TRUE(Trace(field, {}).Lines.empty());

  std::vector<double> step = ones;
  step[3] = 2.0; // the only one above
  const DistanceField peak{ &mesh, step.data(), nullptr, nullptr };
  EXPECT_TRUE(Trace(peak, { 1.0 }).Lines.empty());
  EXPECT_EQ(Trace(peak, { 1.5 }).Lines.size(), 1u);
  EXPECT_TRUE(Trace(peak, { 2.0 }).Lines.empty()); // shrunk to the vertex
}

TEST(Isolines, EndWhereNothingIsReached)
{
  const SurfaceMesh mesh = Build(Plane(10, 10, 0.2));
  ExactOptions options;
  options.KeepWindows = true;
  options.MaximumDistance = 4.0;
  ExactResult limited;
  ASSERT_TRUE(ExactGeodesics(mesh).Run({ VertexSource(60) }, options, limited).IsOk());
  const DistanceField field{ &mesh, limited.Distances.data(), &limited.Windows, nullptr };
  const std::vector<double> levels{ 1.0, 2.0, 3.0, 3.9 };
  const Isolines lines = Trace(field, levels);
  EXPECT_GE(lines.Lines.size(), 4u);
  EXPECT_FALSE(AllClosed(lines));
  ExpectSound(field, levels, lines, "limited");
}

TEST(Isolines, MayBeAskedForInAnyOrder)
{
  const SurfaceMesh mesh = Build(Icosphere(2));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels{ 2.0, 0.5, 1.0, 0.5 };
  const Isolines lines = Trace(field.Exact, levels);
  EXPECT_EQ(lines.Levels, (std::vector<Id>{ 1, 3, 2, 0 }));
  EXPECT_EQ(lines.Lines[0].Points.size(), lines.Lines[1].Points.size());
  EXPECT_LT(lines.Lines[0].Length, lines.Lines[2].Length);
}

TEST(Isolines, DoNotDependOnThreads)
{
  const SurfaceMesh mesh = Build(Terrain(40, 1.0, 3));
  const ExactField field(mesh, { VertexSource(0), VertexSource(800) });
  const std::vector<double> levels = EvenLevels(field.Exact, 20);
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    const Isolines expected = Trace(*f, levels);
    ASSERT_GT(TotalLength(expected), 0.0);
    for (const ParallelFor& parallel :
      { WithThreads(2, 0), WithThreads(7, 0), WithThreads(3, 1), WithThreads(2, 1 << 30) })
    {
      Isolines lines;
      ASSERT_TRUE(TraceIsolines(*f, levels, {}, parallel, nullptr, lines).IsOk());
      ExpectSameLines(expected, lines, "threads");
    }
  }
}

TEST(Isolines, TellProgressAndCanBeStopped)
{
  const SurfaceMesh mesh = Build(Terrain(40, 1.0, 3));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels = EvenLevels(field.Exact, 5);
  std::vector<double> told;
  Isolines lines;
  const auto tell = [&](double done) {
    told.push_back(done);
    return true;
  };
  ASSERT_TRUE(TraceIsolines(field.Exact, levels, {}, nullptr, tell, lines).IsOk());
  EXPECT_GE(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
  const std::size_t steps = told.size();
  for (std::size_t stop = 1; stop <= steps; ++stop)
  {
    told.clear();
    const auto stopAt = [&](double done) {
      told.push_back(done);
      return told.size() < stop;
    };
    EXPECT_TRUE(TraceIsolines(field.Exact, levels, {}, nullptr, stopAt, lines).IsAborted());
    EXPECT_EQ(told.size(), stop);
    EXPECT_TRUE(lines.Lines.empty());
  }
}

TEST(Isolines, BadArgumentsAreRefused)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const ExactField field(mesh, { VertexSource(0) });
  Isolines lines;
  const auto refuses = [&](const DistanceField& f, const std::vector<double>& levels, double t) {
    IsolineOptions options;
    options.ChordTolerance = t;
    const Status status = TraceIsolines(f, levels, options, nullptr, nullptr, lines);
    return status.GetCode() == Status::Code::InvalidInput && lines.Lines.empty();
  };
  EXPECT_FALSE(refuses(field.Exact, { 1.0 }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0, Infinity }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { std::nan("") }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0 }, -1.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0 }, std::nan("")));
  EXPECT_TRUE(refuses({ &mesh, nullptr, nullptr, nullptr }, { 1.0 }, 0.0));
  EXPECT_TRUE(refuses({}, { 1.0 }, 0.0));
  IsolineOptions options;
  options.Method = IsolineMethod::Apollonius;
  for (const int points : { -1, MaximumSteinerPoints + 1 })
  {
    options.SteinerPoints = points;
    EXPECT_FALSE(TraceIsolines(field.Exact, { 1.0 }, options, nullptr, nullptr, lines).IsOk());
  }
}
