// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of the graph builder by themselves.
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggDirectionUnion.h"
#include "dggGraphAssembly.h"
#include "dggGraphPruning.h"
#include "dggRowStore.h"
#include "dggSurfaceOrder.h"
#include "dggUnfoldingTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::Offset;
using dgg::RowEdge;
using dgg::RowStore;
using dgg::SurfaceMesh;

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

TEST(GraphParts, RowStoreKeepsRows)
{
  for (const bool wide : { false, true })
  {
    RowStore rows(wide);
    EXPECT_EQ(rows.GetNumberOfRows(), 0);
    Random random(2);
    std::vector<std::vector<RowEdge>> expected;
    for (Id row = 0; row < 500; ++row)
    {
      std::vector<RowEdge> edges;
      for (Id k = random.Index(40); k > 0; --k)
      {
        edges.push_back(
          { random.Index(1000) + 1000 * static_cast<Id>(edges.size()), random.Uniform(0.5, 2.0),
            static_cast<float>(random.Uniform()), static_cast<float>(random.Uniform()) });
      }
      Append(rows, edges);
      expected.push_back(edges);
    }
    // Every third edge is removed from the rows from 200 on.
    std::vector<unsigned char> flags;
    for (std::size_t row = 200; row < expected.size(); ++row)
    {
      std::vector<RowEdge> kept;
      for (const RowEdge& edge : expected[row])
      {
        flags.push_back(flags.size() % 3 == 0 ? 1 : 0);
        if (flags.back() == 0)
        {
          kept.push_back(edge);
        }
      }
      expected[row] = kept;
    }
    rows.Remove(200, flags);
    ASSERT_EQ(rows.GetNumberOfRows(), 500);
    Offset next = 0;
    for (Id row = 0; row < 500; ++row)
    {
      ASSERT_EQ(rows.Begin(row), next);
      ASSERT_EQ(rows.End(row) - rows.Begin(row), static_cast<Offset>(expected[row].size()));
      for (const RowEdge& edge : expected[row])
      {
        const RowEdge stored = rows.Get(next);
        ASSERT_EQ(stored.Target, edge.Target);
        ASSERT_EQ(
          stored.Length, wide ? edge.Length : static_cast<double>(dgg::RoundedUp(edge.Length)));
        ASSERT_EQ(stored.Departure, edge.Departure);
        ASSERT_EQ(stored.Arrival, edge.Arrival);
        ++next;
      }
    }
    EXPECT_EQ(rows.GetNumberOfEdges(), next);
  }
}

TEST(GraphParts, UniteDirections)
{
  // 0-1 and 1-0, the latter shorter; 0-2 only from 0, 2-1 only from 2; 3-0 of equal lengths.
  RowStore rows(true);
  Append(rows, { { 1, 2.0, 0.1F, 0.2F }, { 2, 3.0, 0.3F, 0.4F }, { 3, 5.0, 0.5F, 0.6F } });
  Append(rows, { { 0, 1.5, 0.7F, 0.8F } });
  dgg::DirectionUnion directions;
  directions.Unite(rows, 0, nullptr);
  // Further rows come later, as the builder has them.
  Append(rows, { { 1, 4.0, 0.9F, 1.0F } });
  Append(rows, { { 0, 5.0, 1.1F, 1.2F } });
  directions.Unite(rows, 2, nullptr);
  EXPECT_EQ(TargetsOf(rows, 0), (std::vector<Id>{ 1, 2, 3 }));
  EXPECT_EQ(TargetsOf(rows, 1), (std::vector<Id>{}));
  EXPECT_EQ(TargetsOf(rows, 2), (std::vector<Id>{ 1 }));
  EXPECT_EQ(TargetsOf(rows, 3), (std::vector<Id>{}));
  const RowEdge shorter = rows.Get(0);
  EXPECT_EQ(shorter.Length, 1.5);
  EXPECT_EQ(shorter.Departure, 0.8F); // the way back, taken over
  EXPECT_EQ(shorter.Arrival, 0.7F);
  EXPECT_EQ(rows.Get(2).Departure, 0.5F); // of equal ones, the first

  // Rows are those of other vertices in the end: 0 1 2 3 become 2 0 3 1.
  dgg::GeodesicGraph graph;
  ASSERT_TRUE(dgg::AssembleGraph(rows, { 2, 0, 3, 1 }, true, nullptr, nullptr, graph).IsOk());
  EXPECT_TRUE(dgg::CheckGraph(graph.View(), 8).IsOk());
  const dgg::GraphView view = graph.View();
  EXPECT_EQ(view.GetNumberOfEdges(), 8);
  const auto expectEdge = [&](Id from, Id to, double length, float departure, float arrival) {
    const Offset e = FindEdge(view, from, to);
    ASSERT_GE(e, 0) << from << " to " << to;
    EXPECT_EQ(view.Length(e), length);
    EXPECT_EQ(view.Angles[e], departure);
    EXPECT_EQ(view.ArrivalAngles[e], arrival);
  };
  expectEdge(2, 0, 1.5, 0.8F, 0.7F);
  expectEdge(0, 2, 1.5, 0.7F, 0.8F);
  expectEdge(2, 3, 3.0, 0.3F, 0.4F);
  expectEdge(3, 2, 3.0, 0.4F, 0.3F);
  expectEdge(3, 0, 4.0, 0.9F, 1.0F);
  expectEdge(0, 3, 4.0, 1.0F, 0.9F);
  expectEdge(2, 1, 5.0, 0.5F, 0.6F);
  expectEdge(1, 2, 5.0, 0.6F, 0.5F);
}

TEST(GraphParts, UniteDirectionsOfLongRows)
{
  // Random graphs of more rows than are united at once, and with long rows, in two steps: what is
  // left is one edge a pair, the shorter way, in the row of the earlier vertex where that has it.
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
      dgg::DirectionUnion directions;
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
  // From 0, the candidate 2 is beyond 1 with a detour that the accuracy just does or does not allow
  // for: 1 / 1.25 + w <= 2 up to w = 1.2.
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
  // 3 is reached in time by 2, but 2 itself is not kept; by 1 it is not reached in time. If pruned
  // candidates counted, errors would add up.
  RowStore rows(true);
  Append(rows, { { 1, 1.0, 0.0F, 0.0F }, { 2, 2.0, 0.0F, 0.0F }, { 3, 3.0, 0.0F, 0.0F } });
  Append(rows, { { 2, 1.15, 0.0F, 0.0F } });
  Append(rows, { { 3, 1.3, 0.0F, 0.0F } });
  Append(rows, {});
  Prune(rows, 0.25);
  EXPECT_EQ(TargetsOf(rows, 0), (std::vector<Id>{ 1, 3 }));
}

TEST(GraphParts, PruningCanBeStopped)
{
  // More rows than one wave; what is stopped leaves the rows alone.
  constexpr Id count = 2000;
  RowStore rows(true);
  const auto prune = [&](const dgg::ProgressCallback& progress) {
    rows = RowStore(true);
    for (Id row = 0; row < count; ++row)
    {
      Append(
        rows, { { (row + 1) % count, 1.0, 0.0F, 0.0F }, { (row + 2) % count, 2.0, 0.0F, 0.0F } });
    }
    return dgg::PruneCandidates(rows, 0.25, nullptr, progress);
  };
  const ProgressListener whole =
    ExpectStops(prune, [&] { EXPECT_EQ(rows.GetNumberOfEdges(), 2 * count); });
  EXPECT_GT(whole.Calls, 1);
  EXPECT_EQ(whole.Done, 1.0);
  EXPECT_TRUE(prune(nullptr).IsOk());
  EXPECT_EQ(rows.GetNumberOfEdges(), count);
  EXPECT_EQ(TargetsOf(rows, 7), std::vector<Id>{ 8 });
}

TEST(GraphParts, PatchOrderIsAPermutationOfPatches)
{
  for (const NamedMesh& named :
    { NamedMesh{ "Sphere", Icosphere(4) }, NamedMesh{ "Components", SeveralComponents() },
      NamedMesh{ "Isolated", SphereWithIsolatedPoints(3) },
      NamedMesh{ "Plates", PinchedPlates(12) }, NamedMesh{ "Repeated", RepeatedVertexPlane(9) } })
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<Id> order = dgg::ComputePatchOrder(mesh, 64);
    std::vector<Id> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Id> all(mesh.GetNumberOfVertices());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
    EXPECT_EQ(dgg::ComputePatchOrder(mesh, 64), order);
  }
  // Vertices next to each other in the order are close on the surface, whatever the numbering of
  // the mesh.
  const TestMesh input = Plane(60, 60, 0.2);
  const SurfaceMesh mesh =
    Build(Renumbered(input, RandomPermutation(input.GetNumberOfVertices(), 3), 3));
  const std::vector<Id> order = dgg::ComputePatchOrder(mesh, 64);
  std::vector<Id> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<Id>(i);
  }
  Offset samePatch = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    samePatch += rank[mesh.Origin(h)] / 64 == rank[mesh.Destination(h)] / 64 ? 1 : 0;
  }
  EXPECT_GT(samePatch, mesh.GetNumberOfHalfEdges() / 2);
}

TEST(GraphParts, UnfoldingTable)
{
  for (const NamedMesh& named :
    { NamedMesh{ "Terrain", Terrain(8, 2.0, 1) }, NamedMesh{ "Moebius", MoebiusStrip(9, 4) },
      NamedMesh{ "Misoriented", MisorientedSphere(2, 4) },
      NamedMesh{ "Cubes", VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }) } })
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    const dgg::UnfoldingTable table(mesh, dgg::ComputePatchOrder(mesh, 50));
    ASSERT_EQ(table.GetNumberOfVertices(), mesh.GetNumberOfVertices());
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_EQ(table.NewVertex(table.OldVertex(v)), v);
    }
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const dgg::FaceCrossing& crossing = table[table.EntryOf(h)];
      ASSERT_EQ(crossing.HalfEdge, h);
      ASSERT_EQ(table.OldVertex(crossing.ApexVertex), mesh.Apex(h));
      ASSERT_EQ(crossing.Apex.X, mesh.ApexX(h));
      ASSERT_EQ(crossing.Apex.Y, mesh.ApexY(h));

      // Behind an edge come all other faces of it, each laid out next to the edge: walking from a
      // crossing to the next, ends and lengths fit.
      std::multiset<Id> behind;
      table.ForEach(table.CodeBehind(h), [&](Id entry) {
        const dgg::FaceCrossing& next = table[entry];
        const bool isMirrored = next.HalfEdge < 0;
        const Id e = isMirrored ? ~next.HalfEdge : next.HalfEdge;
        behind.insert(e);
        ASSERT_EQ(mesh.Origin(e) == mesh.Origin(h), isMirrored);
        ASSERT_EQ(mesh.Length(e), mesh.Length(h));
        // The apex is at the right distances of both ends; the ends of a mirrored crossing are
        // exchanged.
        const double toOrigin = std::hypot(next.Apex.X, next.Apex.Y);
        const double toEnd = std::hypot(next.Apex.X - mesh.Length(e), next.Apex.Y);
        const double first = mesh.Length(SurfaceMesh::Previous(e));
        const double second = mesh.Length(SurfaceMesh::Next(e));
        ASSERT_NEAR(toOrigin, isMirrored ? second : first, 1e-12 * mesh.Length(e));
        ASSERT_NEAR(toEnd, isMirrored ? first : second, 1e-12 * mesh.Length(e));
        for (const dgg::Point2& direction : next.Direction)
        {
          ASSERT_NEAR(std::hypot(direction.X, direction.Y), 1.0, 1e-14);
        }
      });
      std::multiset<Id> expected;
      for (Id e = mesh.Twin(h); e != dgg::NoId && e != h; e = mesh.Twin(e))
      {
        expected.insert(e);
      }
      ASSERT_EQ(behind, expected) << h;
    }
  }
}

TEST(GraphParts, UnfoldingTableOfManyPages)
{
  // Behind an edge of k faces come k - 1 faces, from each of the k: one list for all of them.
  std::vector<Id> unused;
  const SurfaceMesh mesh = Build(Book(3000, 1, unused));
  const dgg::UnfoldingTable table(mesh, dgg::ComputePatchOrder(mesh, 256));
  EXPECT_TRUE(table.Check().IsOk());
  Id edges = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = mesh.Twin(h);
    if (twin == dgg::NoId || mesh.Twin(twin) == h || ++edges % 100 != 1)
    {
      continue;
    }
    // In the order of the list of the mesh, from the next one on.
    Id next = twin;
    table.ForEach(table.CodeBehind(h), [&](Id entry) {
      ASSERT_EQ(table[entry].GetHalfEdge(), next);
      ASSERT_EQ(table[entry].IsMirrored(), mesh.Origin(next) == mesh.Origin(h));
      next = mesh.Twin(next);
    });
    ASSERT_EQ(next, h);
  }
  EXPECT_EQ(edges, 3000);
}

TEST(GraphParts, UnfoldingTableSaysWhenTooLarge)
{
  // No mesh that large is made here: only what would become of it.
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
}
