// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Unit tests of the components of the graph builder and of searches; signature and checksum of a
// graph.
#include "GraphChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggCrossingBlocks.h"
#include "dggDirectionUnion.h"
#include "dggGeodesicGraph.h"
#include "dggGraphAssembly.h"
#include "dggGraphPruning.h"
#include "dggRowStore.h"
#include "dggSurfaceOrder.h"

#include <numeric>

namespace dggtest
{
namespace
{
using dgg::Offset;
using dgg::RowEdge;
using dgg::RowStore;

void Append(RowStore& rows, const std::vector<RowEdge>& edges)
{
  rows.AppendRow(edges.data(), edges.data() + edges.size());
}

void Prune(RowStore& rows, double accuracy)
{
  ASSERT_TRUE(dgg::PruneCandidates(rows, accuracy, nullptr, nullptr).IsOk());
}

std::vector<Id> TargetsOf(const RowStore& rows, Id row)
{
  std::vector<Id> targets;
  for (Offset i = rows.Begin(row); i < rows.End(row); ++i)
  {
    targets.push_back(rows.Target(i));
  }
  return targets;
}
}

TEST(GraphParts, RoundedUp)
{
  Random random(1);
  for (int i = 0; i < 10000; ++i)
  {
    const double value = std::exp(random.Uniform(-80.0, 80.0));
    const float up = dgg::RoundedUp(value);
    ASSERT_GE(static_cast<double>(up), value);
    ASSERT_LT(static_cast<double>(std::nextafter(up, 0.0F)), value);
    ASSERT_EQ(dgg::RoundedUp(static_cast<double>(up)), up);
  }
  EXPECT_GT(dgg::RoundedUp(1e-60), 0.0F);
}

TEST(GraphParts, EquallyLongPathsDoNotDependOnTheOrderOfRows)
{
  // Of two paths of the same length, the one that vertex 0 has found is kept.
  for (const std::vector<Id>& ids : { std::vector<Id>{ 0, 1 }, std::vector<Id>{ 1, 0 } })
  {
    RowStore rows(true);
    for (Id row = 0; row < 2; ++row)
    {
      const auto vertex = static_cast<float>(ids[row]);
      Append(rows, { { 1 - row, 1.0, 2.0F + vertex, 4.0F + vertex } });
    }
    dgg::DirectionUnion(ids).Unite(rows, 0, nullptr);
    ASSERT_EQ(rows.GetNumberOfEdges(), 1);
    EXPECT_EQ(rows.Departure(0), ids[0] == 0 ? 2.0F : 4.0F);
    EXPECT_EQ(rows.Arrival(0), ids[0] == 0 ? 4.0F : 2.0F);
  }
}

TEST(GraphParts, UniteDirectionsOfLongRows)
{
  // Random graphs with more rows than are united in one batch, and with long rows, in two steps.
  // The result has one edge per pair, the shorter path, stored in the row of the first vertex if
  // that row has the edge.
  for (const Id degree : { 3, 40, 400 })
  {
    constexpr Id count = 900;
    Random random(degree);
    std::vector<std::map<Id, double>> found(count);
    std::vector<std::vector<RowEdge>> all(count);
    for (Id row = 0; row < count; ++row)
    {
      for (Id k = 0; k < degree; ++k)
      {
        const Id target = random.Index(count);
        const double length = random.Uniform(1.0, 2.0);
        if (target != row && found[row].emplace(target, length).second)
        {
          all[row].push_back({ target, length, static_cast<float>(row), 0.0F });
        }
      }
    }
    const auto unite = [&](const dgg::ParallelFor& parallel) {
      RowStore rows(true);
      std::vector<Id> ids(count);
      std::iota(ids.begin(), ids.end(), 0);
      dgg::DirectionUnion directions(ids);
      for (const Id last : { 520, 521, count })
      {
        const Id first = rows.GetNumberOfRows();
        for (Id row = first; row < last; ++row)
        {
          Append(rows, all[row]);
        }
        directions.Unite(rows, first, parallel);
      }
      return rows;
    };
    const RowStore rows = unite(nullptr);
    std::size_t kept = 0;
    for (Id row = 0; row < count; ++row)
    {
      Offset next = rows.Begin(row);
      for (const auto& edge : all[row])
      {
        const auto back = found[edge.Target].find(row);
        const bool isDouble = back != found[edge.Target].end();
        if (isDouble && edge.Target < row)
        {
          continue;
        }
        const bool isBackShorter = isDouble && back->second < edge.Length;
        ASSERT_LT(next, rows.End(row));
        ASSERT_EQ(rows.Target(next), edge.Target);
        ASSERT_EQ(rows.Length(next), isBackShorter ? back->second : edge.Length);
        ASSERT_EQ(rows.Arrival(next), isBackShorter ? static_cast<float>(edge.Target) : 0.0F);
        ++next;
        ++kept;
      }
      ASSERT_EQ(next, rows.End(row));
    }
    EXPECT_EQ(static_cast<Offset>(kept), rows.GetNumberOfEdges());
    const RowStore others = unite(WithThreads(3));
    ASSERT_EQ(others.GetNumberOfEdges(), rows.GetNumberOfEdges());
    for (Offset i = 0; i < rows.GetNumberOfEdges(); ++i)
    {
      ASSERT_EQ(others.Target(i), rows.Target(i));
      ASSERT_EQ(others.Length(i), rows.Length(i));
    }
  }
}

TEST(GraphParts, PruneCandidates)
{
  // From 0, the candidate 2 is behind 1 with a detour just within or just beyond the accuracy: 1 /
  // 1.25 + w <= 2 up to w = 1.2.
  for (const double w : { 1.1999, 1.2001 })
  {
    RowStore rows(true);
    Append(rows, { { 2, 2.0, 0.0F, 0.0F }, { 1, 1.0, 0.0F, 0.0F } });
    Append(rows, { { 0, 1.0, 0.0F, 0.0F }, { 2, w, 0.0F, 0.0F } });
    Append(rows, { { 0, 2.0, 0.0F, 0.0F }, { 1, w, 0.0F, 0.0F } });
    Prune(rows, 0.25);
    EXPECT_EQ(TargetsOf(rows, 0), w < 1.2 ? (std::vector<Id>{ 1 }) : (std::vector<Id>{ 2, 1 }));
    EXPECT_EQ(TargetsOf(rows, 1), (std::vector<Id>{ 0, 2 }));
  }
}

TEST(GraphParts, PrunedCandidatesAreNoRelays)
{
  // The detour to 3 by 2 is within the accuracy, but 2 itself is pruned; the detour by 1 is not. If
  // pruned candidates were used as relays, errors would accumulate.
  RowStore rows(true);
  Append(rows, { { 1, 1.0, 0.0F, 0.0F }, { 2, 2.0, 0.0F, 0.0F }, { 3, 3.0, 0.0F, 0.0F } });
  Append(rows, { { 2, 1.15, 0.0F, 0.0F } });
  Append(rows, { { 3, 1.3, 0.0F, 0.0F } });
  Append(rows, {});
  Prune(rows, 0.25);
  EXPECT_EQ(TargetsOf(rows, 0), (std::vector<Id>{ 1, 3 }));
}

TEST(GraphParts, UnfoldingTableSaysWhenTooLarge)
{
  // No mesh of that size is built: only its extent is checked.
  constexpr Offset most = std::numeric_limits<Id>::max();
  const auto check = [](Offset halfEdges, bool needsMirrors, Offset branchHalfEdges) {
    dgg::UnfoldingTable::Extent extent;
    extent.HalfEdges = halfEdges;
    extent.NeedsMirrors = needsMirrors;
    extent.BranchHalfEdges = branchHalfEdges;
    extent.BranchEdges = branchHalfEdges / 3;
    return dgg::UnfoldingTable::CheckSize(extent);
  };
  EXPECT_TRUE(check(most - 1, false, 0).IsOk());
  EXPECT_TRUE(check(most / 2 - 1, true, most / 4).IsOk());
  for (const dgg::Status& status :
    { check(most / 2 + 3, true, 0), check(most / 2 - 1, true, most / 2 - 1) })
  {
    EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput);
    EXPECT_TRUE(Says(status, "too many"));
    EXPECT_TRUE(Says(status, "manifold"));
  }
}

/// Threads use blocks simultaneously, in other orders than they were filled, after some have been
/// released.
TEST(GraphParts, ReleasedCrossingsAreComputedAgain)
{
  std::vector<Id> sheets;
  for (const TestMesh& points : { Plane(40, 30, 0.2, 1), Book(3, 20, sheets) })
  {
    const dgg::SurfaceMesh mesh = Build(points);
    const dgg::UnfoldingTable table(mesh, dgg::ComputePatchOrder(mesh, 256));
    ASSERT_GE(table.GetNumberOfBlocks(), 5u);
    dgg::CrossingBlocks crossings(table);
    for (int round = 0; round < 6; ++round)
    {
      const auto parallel = WithThreads(round % 2 == 0 ? 1 : 4, 50);
      parallel(mesh.GetNumberOfHalfEdges(), 1, [&](dgg::Offset begin, dgg::Offset end) {
        for (auto h = static_cast<Id>(begin); h < end; ++h)
        {
          const Id entry = table.EntryOf(h);
          EXPECT_EQ(crossings[entry].HalfEdge, h);
          EXPECT_EQ(crossings[entry].Apex.X, mesh.ApexX(h));
          EXPECT_EQ(crossings.PolarAngle(h), mesh.PolarAngle(h));
          if (table.NeedsMirrors())
          {
            EXPECT_EQ(crossings[entry + mesh.GetNumberOfHalfEdges()].HalfEdge, ~h);
          }
        }
      });
      crossings.Trim(1);
    }
  }
}

namespace
{
using dgg::Buffer;
using dgg::GeodesicGraph;
using dgg::GraphView;

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

}

TEST(GraphArrays, ChecksumCoversEveryArray)
{
  const GeodesicGraph sound = BuildGraph(Build(Terrain(6, 0.4, 3)), 0.05);
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

TEST(GraphArrays, SignatureDistinguishesSurfaces)
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
  // Every coordinate is hashed, including the last bit and the sign of zero.
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
  // The boundary between points and triangles is hashed, and so are zeros at an end.
  expectNew([](TestMesh& m) { m.AddPoint(0.0, 0.0, 0.0); });
  expectNew([](TestMesh& m) { m.Triangles.resize(m.Triangles.size() - 3); });
}
}
