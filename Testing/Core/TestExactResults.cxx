// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Predecessors, statistics, and the edge graph's upper bound.
#include "EdgeGraph.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dggtest
{
namespace
{
/// Follow the roots from v to a source. Adds up the straight pieces; fails the test when a piece
/// has not the length that it claims. Returns the source.
Id FollowRoots(const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources,
  const dgg::ExactResult& result, Id v)
{
  for (Id steps = 0; steps <= mesh.GetNumberOfVertices(); ++steps)
  {
    const dgg::Predecessor& p = result.Predecessors[v];
    const double scale = result.Distances[v];
    // Length of the last straight piece.
    double piece = 0.0;
    if (p.HalfEdge != dgg::NoId)
    {
      EXPECT_EQ(mesh.Apex(p.HalfEdge), v);
      EXPECT_LT(p.ImageY, 0.0);
      piece = std::hypot(mesh.ApexX(p.HalfEdge) - p.ImageX, mesh.ApexY(p.HalfEdge) - p.ImageY);
      // The piece crosses the half-edge.
      const double t = -p.ImageY / (mesh.ApexY(p.HalfEdge) - p.ImageY);
      const double x = p.ImageX + t * (mesh.ApexX(p.HalfEdge) - p.ImageX);
      EXPECT_GE(x, -1e-9 * mesh.Length(p.HalfEdge));
      EXPECT_LE(x, (1.0 + 1e-9) * mesh.Length(p.HalfEdge));
    }
    else if (p.Root >= 0 && p.Root != v)
    {
      piece = dgg::Infinity; // along a mesh edge
      for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
      {
        const Id incoming = dgg::SurfaceMesh::Previous(*h);
        if (mesh.Destination(*h) == p.Root)
        {
          piece = std::min(piece, mesh.Length(*h));
        }
        if (mesh.Origin(incoming) == p.Root)
        {
          piece = std::min(piece, mesh.Length(incoming));
        }
      }
    }
    if (p.Root < 0)
    {
      const Id k = ~p.Root;
      EXPECT_GE(k, 0);
      EXPECT_LT(k, static_cast<Id>(sources.size()));
      if (p.HalfEdge == dgg::NoId)
      {
        // The source lies in a face of v.
        double straight = dgg::Infinity;
        const dgg::SurfacePoint& point = sources[k].Point;
        for (int c = 0; c < 3; ++c)
        {
          if (mesh.Origin(3 * point.Face + c) == v)
          {
            straight = dgg::DistanceToCorner(mesh, point.Face, point.Barycentric, c);
          }
        }
        piece = straight < dgg::Infinity ? straight : scale - sources[k].InitialDistance;
      }
      EXPECT_NEAR(scale, sources[k].InitialDistance + piece, 1e-12 * (scale + 1.0));
      return k;
    }
    if (p.Root == v)
    {
      const Id k = result.NearestSource[v];
      EXPECT_EQ(sources[k].Point.Vertex, v);
      EXPECT_EQ(scale, sources[k].InitialDistance);
      return k;
    }
    EXPECT_NEAR(scale, result.Distances[p.Root] + piece, 1e-11 * (scale + 1.0)) << v;
    EXPECT_EQ(result.NearestSource[v], result.NearestSource[p.Root]);
    v = p.Root;
  }
  ADD_FAILURE() << "the roots run in a circle";
  return dgg::NoId;
}
}

class ExactResults : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactResults);

TEST_P(ExactResults, RootsLeadToTheNearestSource)
{
  std::vector<Id> sheetOf;
  for (const TestMesh& input : { NoisySphere(2, 0.4, 3), Cube(4), Plane(8, 8), Terrain(10, 2.0, 4),
         Plate(
           8, 8, [](Id i, Id j) { return i < 3 || j < 3; }, 0.2),
         SeveralComponents(), WithNoise(Book(3, 4, sheetOf, 0.2, 2), 0.1, 3), MoebiusStrip(9, 4),
         Ellipsoid(2, 20.0) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const auto points = RandomSurfacePoints(mesh, 3, 5);
    const std::vector<dgg::GeodesicSource> sources{ VertexSource(0, 0.1), { points[0], 0.0 },
      { points[1], 0.2 }, VertexSource(mesh.GetNumberOfVertices() - 1) };
    for (const auto& chosen : { std::vector<dgg::GeodesicSource>{ sources[0] },
           std::vector<dgg::GeodesicSource>{ sources[1] }, sources })
    {
      const dgg::ExactResult result = Solve(mesh, this->Engine(), chosen);
      ASSERT_EQ(static_cast<Id>(result.Predecessors.size()), mesh.GetNumberOfVertices());
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (result.Distances[v] < dgg::Infinity)
        {
          EXPECT_EQ(FollowRoots(mesh, chosen, result, v), result.NearestSource[v]) << v;
        }
        else
        {
          EXPECT_EQ(result.Predecessors[v].Root, dgg::NoId);
        }
      }
    }
  }
}

TEST_P(ExactResults, RootsAreWherePathsBend)
{
  // In an L the far arm is seen through the inner corner only.
  const TestMesh input = Plate(
    6, 6, [](Id i, Id j) { return i < 2 || j < 2; }, 0.2, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  const Id corner = VertexAt(input, 2.0, 2.0, 0.0);
  const Id source = VertexAt(input, 6.0, 0.0, 0.0);
  const dgg::ExactResult result = Solve(mesh, this->Engine(), { VertexSource(source) });
  const Id far = VertexAt(input, 0.0, 6.0, 0.0);
  Id v = far;
  bool bends = false;
  while (result.Predecessors[v].Root != v)
  {
    v = result.Predecessors[v].Root;
    bends = bends || v == corner;
  }
  EXPECT_TRUE(bends);
  EXPECT_EQ(v, source);
}

TEST_P(ExactResults, CountsWork)
{
  const dgg::SurfaceMesh small = Build(NoisySphere(2, 0.3, 3));
  const dgg::SurfaceMesh large = Build(NoisySphere(4, 0.3, 3));
  const dgg::ExactResult one = Solve(small, this->Engine(), { VertexSource(0) });
  const dgg::ExactResult other = Solve(large, this->Engine(), { VertexSource(0) });
  EXPECT_GT(one.NumberOfWindows, 300u);
  EXPECT_GT(other.NumberOfWindows, 10 * one.NumberOfWindows);
  EXPECT_GT(one.PeakMemory, 1000u);
  EXPECT_GT(other.PeakMemory, one.PeakMemory);
}

TEST_P(ExactResults, MemoryOfWindowsIsCountedAndLimited)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(4, 0.3, 3));
  dgg::ExactOptions options;
  options.Engine = this->Engine();
  const auto run = [&](dgg::ExactResult& result) {
    return dgg::ExactGeodesics(mesh).Run({ VertexSource(0) }, options, result);
  };
  dgg::ExactResult without;
  dgg::ExactResult with;
  ASSERT_TRUE(run(without).IsOk());
  options.KeepWindows = true;
  ASSERT_TRUE(run(with).IsOk());
  EXPECT_GT(with.PeakMemory, without.PeakMemory);
  // Both the lists and the result, when one is moved to the other.
  EXPECT_GT(with.PeakMemory, 2 * with.Windows.Windows.size() * sizeof(dgg::EdgeWindow));

  dgg::ExactResult result;
  options.MemoryLimit = with.PeakMemory;
  ASSERT_TRUE(run(result).IsOk());
  EXPECT_EQ(result.Distances, with.Distances);
  for (const std::size_t limit : { with.PeakMemory / 2, std::size_t(1) })
  {
    options.MemoryLimit = limit;
    dgg::ExactGeodesics solver(mesh);
    const dgg::Status status = solver.Run({ VertexSource(0) }, options, result);
    EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput);
    for (const std::string& text : { std::to_string(limit) + " bytes", std::string("fewer points"),
           std::string("MaximumDistance"), std::string("GenerateWindows off") })
    {
      EXPECT_NE(status.GetMessage().find(text), std::string::npos) << status.GetMessage();
    }
    EXPECT_TRUE(result.Distances.empty());
    EXPECT_TRUE(result.Windows.IsEmpty());
    options.MemoryLimit = 0; // the same engine goes on
    ASSERT_TRUE(solver.Run({ VertexSource(0) }, options, result).IsOk());
    EXPECT_EQ(result.Distances, with.Distances);
    EXPECT_EQ(result.Windows.Offsets, with.Windows.Offsets);
  }
}

TEST_P(ExactResults, MemoryLimitEndsARunEarly)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(5, 0.3, 3));
  double farthest = 0.0;
  dgg::ExactOptions options;
  options.Engine = this->Engine();
  options.KeepWindows = true;
  options.Progress = [&](double fraction) {
    farthest = std::max(farthest, fraction);
    return true;
  };
  dgg::ExactResult result;
  ASSERT_TRUE(dgg::ExactGeodesics(mesh).Run({ VertexSource(0) }, options, result).IsOk());
  EXPECT_GT(farthest, 0.7);
  farthest = 0.0;
  options.MemoryLimit = result.PeakMemory / 3;
  EXPECT_FALSE(dgg::ExactGeodesics(mesh).Run({ VertexSource(0) }, options, result).IsOk());
  EXPECT_LT(farthest, 0.7);
}

TEST(EdgeGraph, AddsUpEdges)
{
  const TestMesh input = Plane(4, 4); // diagonals from lower left to upper right
  const auto distances = dggtest::EdgeGraphDistances(Build(input), { VertexSource(0) });
  EXPECT_DOUBLE_EQ(distances[4], 4.0);
  EXPECT_DOUBLE_EQ(distances[24], 4.0 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(distances[9], 3.0 + std::sqrt(2.0)); // (4, 1)
  const auto back = dggtest::EdgeGraphDistances(Build(input), { VertexSource(4) });
  EXPECT_DOUBLE_EQ(back[20], 8.0); // against the diagonals
}

}
