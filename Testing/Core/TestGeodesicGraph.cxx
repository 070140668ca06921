// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The flat arrays of a graph: views, validation, signature and checksum.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggGeodesicGraph.h"

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::Buffer;
using dgg::GeodesicGraph;
using dgg::GraphView;
using dgg::Offset;

constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float Unbounded = std::numeric_limits<float>::infinity();

template <typename T>
Buffer<T> Copy(const Buffer<T>& original)
{
  Buffer<T> copy(original.Size());
  for (std::size_t i = 0; i < original.Size(); ++i)
  {
    copy[i] = original[i];
  }
  return copy;
}

GeodesicGraph Copy(const GeodesicGraph& original)
{
  GeodesicGraph copy;
  copy.Info = original.Info;
  copy.Offsets = Copy(original.Offsets);
  copy.Targets = Copy(original.Targets);
  copy.Lengths = Copy(original.Lengths);
  copy.WideLengths = Copy(original.WideLengths);
  copy.Angles = Copy(original.Angles);
  copy.ArrivalAngles = Copy(original.ArrivalAngles);
  return copy;
}

Offset EdgesOf(const GeodesicGraph& graph)
{
  return static_cast<Offset>(graph.Targets.Size());
}

dgg::Status Check(const GeodesicGraph& graph)
{
  return dgg::CheckGraph(graph.View(), EdgesOf(graph));
}

/// A case of damage: what is done to a graph, and what the message has to name.
struct Damage
{
  std::string Name;
  std::function<void(GeodesicGraph&)> Do;
  std::string Expected;
};

void ExpectNoticed(const GeodesicGraph& sound, const std::vector<Damage>& cases)
{
  ASSERT_TRUE(Check(sound).IsOk()) << Check(sound).GetMessage();
  for (const Damage& damage : cases)
  {
    GeodesicGraph graph = Copy(sound);
    damage.Do(graph);
    const dgg::Status status = Check(graph);
    EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput) << damage.Name;
    EXPECT_NE(status.GetMessage().find(damage.Expected), std::string::npos)
      << damage.Name << ": " << status.GetMessage();
    EXPECT_TRUE(Says(status, "build the graph again"));
  }
}

class GraphArrays : public testing::Test
{
protected:
  static GeodesicGraph Sound(double accuracy = 0.05)
  {
    return BuildGraph(Build(Terrain(6, 0.4, 3)), accuracy);
  }
};
}

TEST_F(GraphArrays, EmptyGraphsAreValid)
{
  EXPECT_TRUE(dgg::CheckGraph(GraphView(), 0).IsOk());
  const Offset zero[] = { 0, 0, 0 };
  GraphView isolated;
  isolated.NumberOfVertices = 2;
  isolated.Offsets = zero;
  EXPECT_TRUE(dgg::CheckGraph(isolated, 0).IsOk());
  EXPECT_FALSE(dgg::CheckGraph(isolated, 1).IsOk());
  isolated.Offsets = nullptr;
  EXPECT_FALSE(dgg::CheckGraph(isolated, 0).IsOk());
  EXPECT_FALSE(dgg::CheckGraph(GraphView(), 1).IsOk());
  EXPECT_FALSE(dgg::CheckGraph(GraphView(), -1).IsOk());
}

TEST_F(GraphArrays, ViewAndMemory)
{
  const GeodesicGraph graph = Sound();
  const GraphView view = graph.View();
  EXPECT_EQ(view.NumberOfVertices, graph.GetNumberOfVertices());
  EXPECT_EQ(view.GetNumberOfEdges(), EdgesOf(graph));
  EXPECT_EQ(view.Info.Accuracy, graph.Info.Accuracy);
  EXPECT_EQ(view.WideLengths, nullptr);
  EXPECT_EQ(view.Length(3), static_cast<double>(graph.Lengths[3]));
  EXPECT_EQ(graph.GetMemorySize(), 16 * graph.Targets.Size() + 8 * graph.Offsets.Size());
  EXPECT_EQ(GeodesicGraph().GetMemorySize(), 0u);
  EXPECT_EQ(GeodesicGraph().GetNumberOfVertices(), 0);
  EXPECT_EQ(GeodesicGraph().View().GetNumberOfEdges(), 0);
}

TEST_F(GraphArrays, DamagedOffsetsAreNoticed)
{
  const GeodesicGraph sound = Sound();
  const auto last = sound.Offsets.Size() - 1;
  ExpectNoticed(sound,
    { { "not from 0", [](GeodesicGraph& g) { g.Offsets[0] = 1; }, "offsets go from 1" },
      { "past the end", [=](GeodesicGraph& g) { ++g.Offsets[last]; }, "but there are" },
      { "before the end", [=](GeodesicGraph& g) { --g.Offsets[last]; }, "but there are" },
      { "descending", [](GeodesicGraph& g) { g.Offsets[4] = g.Offsets[3] - 1; },
        "offsets of vertex 3" },
      { "negative", [](GeodesicGraph& g) { g.Offsets[1] = -5; }, "offsets of vertex 0" },
      { "far out", [](GeodesicGraph& g) { g.Offsets[2] = Offset(1) << 40; },
        "offsets of vertex 1" } });
}

TEST_F(GraphArrays, DamagedEdgesAreNoticed)
{
  const GeodesicGraph sound = Sound();
  const Id n = sound.GetNumberOfVertices();
  const Offset e = sound.Offsets[5] + 2;
  const std::string name = "edge " + std::to_string(e) + " (of vertex 5)";
  ExpectNoticed(sound,
    { { "target n", [=](GeodesicGraph& g) { g.Targets[e] = n; }, name + " leads to vertex" },
      { "target -1", [=](GeodesicGraph& g) { g.Targets[e] = -1; }, name + " leads to vertex -1" },
      { "loop", [=](GeodesicGraph& g) { g.Targets[e] = 5; }, name + " leads back" },
      { "zero length", [=](GeodesicGraph& g) { g.Lengths[e] = 0.0f; }, name + " has length 0" },
      { "negative length", [=](GeodesicGraph& g) { g.Lengths[e] = -1.0f; }, name + " has length" },
      { "NaN length", [=](GeodesicGraph& g) { g.Lengths[e] = NotANumber; }, name + " has length" },
      { "infinite length", [=](GeodesicGraph& g) { g.Lengths[e] = Unbounded; },
        name + " has length inf" },
      { "NaN angle", [=](GeodesicGraph& g) { g.Angles[e] = NotANumber; }, name + " has angles" },
      { "NaN first angle", [](GeodesicGraph& g) { g.Angles[0] = NotANumber; },
        "edge 0 (of vertex 0) has angles" },
      { "negative angle", [](GeodesicGraph& g) { g.Angles[0] = -0.1f; }, "has angles -0.1" },
      { "infinite angle", [=](GeodesicGraph& g) { g.Angles[g.Offsets[6] - 1] = Unbounded; },
        "has angles inf" },
      { "NaN arrival", [=](GeodesicGraph& g) { g.ArrivalAngles[e] = NotANumber; },
        name + " has angles" },
      { "negative arrival", [=](GeodesicGraph& g) { g.ArrivalAngles[e] = -2.0f; },
        name + " has angles" },
      { "infinite arrival", [=](GeodesicGraph& g) { g.ArrivalAngles[e] = Unbounded; },
        name + " has angles" },
      { "unsorted", [=](GeodesicGraph& g) { std::swap(g.Angles[e], g.Angles[e + 1]); },
        "is not sorted" } });
}

TEST_F(GraphArrays, DamagedWideLengthsAreNoticed)
{
  const GeodesicGraph sound = Sound(1e-6);
  ASSERT_FALSE(sound.WideLengths.IsEmpty());
  ExpectNoticed(sound,
    { { "zero", [](GeodesicGraph& g) { g.WideLengths[7] = 0.0; }, "edge 7 " },
      { "NaN", [](GeodesicGraph& g) { g.WideLengths[7] = std::nan(""); }, "has length" },
      { "infinite", [](GeodesicGraph& g) { g.WideLengths[7] = dgg::Infinity; }, "has length" } });
}

TEST_F(GraphArrays, MissingArraysAreNoticed)
{
  const GeodesicGraph graph = Sound();
  const Offset edges = EdgesOf(graph);
  const std::vector<double> wide(graph.Targets.Size(), 1.0);
  const auto expect = [&](
                        const std::string& message, const std::function<void(GraphView&)>& change) {
    GraphView view = graph.View();
    change(view);
    const dgg::Status status = dgg::CheckGraph(view, edges);
    EXPECT_FALSE(status.IsOk()) << message;
    EXPECT_TRUE(Says(status, message));
  };
  expect("no offsets", [](GraphView& v) { v.Offsets = nullptr; });
  expect("no targets", [](GraphView& v) { v.Targets = nullptr; });
  expect("no lengths", [](GraphView& v) { v.Lengths = nullptr; });
  expect("two precisions", [&](GraphView& v) { v.WideLengths = wide.data(); });
  expect("only one of the two", [](GraphView& v) { v.Angles = nullptr; });
  expect("only one of the two", [](GraphView& v) { v.ArrivalAngles = nullptr; });
  expect("no angles", [](GraphView& v) { v.Angles = v.ArrivalAngles = nullptr; });
  expect("negative sizes", [](GraphView& v) { v.NumberOfVertices = -1; });
  // A cloud has no directions.
  EXPECT_TRUE(dgg::CheckGraph(AsCloud(graph.View()), edges).IsOk());
}

TEST_F(GraphArrays, ChecksumCoversEveryArray)
{
  const GeodesicGraph sound = Sound();
  std::set<std::uint64_t> checksums{ dgg::ComputeChecksum(sound.View()) };
  EXPECT_EQ(dgg::ComputeChecksum(Copy(sound).View()), *checksums.begin());
  const std::vector<std::function<void(GeodesicGraph&)>> changes{
    [](GeodesicGraph& g) { ++g.Offsets[3]; },
    [](GeodesicGraph& g) { ++g.Targets[10]; },
    [](GeodesicGraph& g) { g.Lengths[10] = std::nextafter(g.Lengths[10], 0.0f); },
    [](GeodesicGraph& g) { g.Angles[10] = std::nextafter(g.Angles[10], 0.0f); },
    [](GeodesicGraph& g) { g.ArrivalAngles[10] = std::nextafter(g.ArrivalAngles[10], 0.0f); },
    [](GeodesicGraph& g) { std::swap(g.Targets[10], g.Targets[11]); },
    [](GeodesicGraph& g) { std::swap(g.Angles, g.ArrivalAngles); },
    [](GeodesicGraph& g) { ++g.Targets[g.Targets.Size() - 1]; },
  };
  for (const auto& change : changes)
  {
    GeodesicGraph graph = Copy(sound);
    change(graph);
    checksums.insert(dgg::ComputeChecksum(graph.View()));
  }
  EXPECT_EQ(checksums.size(), changes.size() + 1);
  EXPECT_EQ(dgg::ComputeChecksum(GraphView()), dgg::ComputeChecksum(GeodesicGraph().View()));
}

TEST_F(GraphArrays, SignatureDistinguishesSurfaces)
{
  const TestMesh mesh = Plane(3, 3);
  std::set<dgg::Signature> signatures;
  const auto insert = [&](const TestMesh& m) {
    return signatures
      .insert(dgg::ComputeSignature(
        m.Points.data(), m.GetNumberOfVertices(), m.Triangles.data(), m.GetNumberOfFaces()))
      .second;
  };
  EXPECT_TRUE(insert(mesh));
  EXPECT_FALSE(insert(Plane(3, 3)));
  const auto expectNew = [&](const std::function<void(TestMesh&)>& change) {
    TestMesh changed = mesh;
    change(changed);
    EXPECT_TRUE(insert(changed));
  };
  // Every coordinate counts, down to the last bit and the sign of zero.
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    expectNew([=](TestMesh& m) { m.Points[i] = std::nextafter(m.Points[i], 100.0); });
  }
  expectNew([](TestMesh& m) { m.Points[2] = -0.0; });
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    expectNew([=](TestMesh& m) { m.Triangles[i] = (m.Triangles[i] + 1) % 16; });
  }
  expectNew([](TestMesh& m) { std::swap(m.Triangles[1], m.Triangles[2]); });
  // Where points end and triangles begin, and zeros at an end.
  expectNew([](TestMesh& m) { m.AddPoint(0.0, 0.0, 0.0); });
  expectNew([](TestMesh& m) { m.Triangles.resize(m.Triangles.size() - 3); });
}

TEST_F(GraphArrays, WhatIsGuaranteed)
{
  dgg::GraphInfo info;
  for (const auto construction : AllConstructions())
  {
    info.Construction = construction;
    EXPECT_EQ(info.IsGuaranteed(), construction == dgg::GraphConstruction::Guaranteed);
  }
  info.Construction = dgg::GraphConstruction::Guaranteed;
  info.Kind = dgg::GraphKind::Cloud;
  EXPECT_FALSE(info.IsGuaranteed());
  EXPECT_TRUE(dgg::NeedsWideLengths(9e-6));
  EXPECT_FALSE(dgg::NeedsWideLengths(1e-5));
  EXPECT_FALSE(dgg::NeedsWideLengths(0.0));
}
}
