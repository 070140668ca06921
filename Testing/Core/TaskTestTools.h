// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prepared surfaces and graphs for tests of tasks.
#ifndef TaskTestTools_h
#define TaskTestTools_h

#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggGraphSession.h"
#include "dggPreparedSurface.h"
#include "dggStoredGraph.h"
#include "dggTaskContext.h"

namespace dggtest
{
/// Arrays of a test mesh, which must outlive them.
struct MeshArrays
{
  explicit MeshArrays(const TestMesh& mesh)
    : Ids(mesh.Triangles.begin(), mesh.Triangles.end())
  {
    for (Id f = 0; f <= mesh.GetNumberOfFaces(); ++f)
    {
      this->Offsets.push_back(3 * static_cast<dgg::Offset>(f));
    }
    this->Arrays.Points = mesh.Points.data();
    this->Arrays.NumberOfPoints = mesh.GetNumberOfVertices();
    this->Arrays.Polygons = { mesh.GetNumberOfFaces(), this->Offsets.data(), this->Ids.data(),
      this->Offsets.back() };
  }
  MeshArrays(const MeshArrays&) = delete;
  MeshArrays& operator=(const MeshArrays&) = delete;

  std::vector<dgg::Offset> Offsets;
  std::vector<dgg::Offset> Ids;
  dgg::SurfaceArrays Arrays;
};

/// Prepares a test mesh, or only its points for a cloud.
inline dgg::PreparedSurface::Pointer Prepare(
  const TestMesh& mesh, const dgg::Domain& domain = dgg::Domain())
{
  const MeshArrays arrays(mesh);
  const auto print = dgg::PreparedSurface::ComputeFingerprint(arrays.Arrays, domain);
  dgg::PreparedSurface::Pointer prepared;
  EXPECT_TRUE(Ok(dgg::PreparedSurface::Make(arrays.Arrays, domain, print, prepared)));
  return prepared;
}

/// Returns the context of a task on a surface that was made from these arrays.
inline dgg::TaskContext MakeContext(const dgg::PreparedSurface& surface, const MeshArrays& arrays)
{
  return { surface, { 0, nullptr }, 2, nullptr, WithThreads(2),
    [&arrays]() -> const dgg::SurfaceArrays& { return arrays.Arrays; } };
}

/// Returns the graph of a cloud with edges of length 1 between successive points.
inline dgg::GeodesicGraph ChainGraph(const dgg::PreparedSurface& cloud, Id links)
{
  dgg::GeodesicGraph graph;
  const Id points = cloud.GetMesh().GetNumberOfVertices();
  graph.Info.Kind = dgg::GraphKind::Cloud;
  graph.Info.Construction = dgg::GraphConstruction::CloudConstant;
  graph.Info.Surface = cloud.GetSignature();
  graph.Offsets = dgg::Buffer<dgg::Offset>(static_cast<std::size_t>(points) + 1);
  graph.Targets = dgg::Buffer<Id>(2 * static_cast<std::size_t>(links));
  graph.Lengths = dgg::Buffer<float>(graph.Targets.Size());
  dgg::Offset edge = 0;
  for (Id v = 0; v < points; ++v)
  {
    graph.Offsets[v] = edge;
    for (const Id target : { v - 1, v + 1 })
    {
      if (target >= 0 && target <= links && v <= links)
      {
        graph.Targets[edge] = target;
        graph.Lengths[edge++] = 1.0F;
      }
    }
  }
  graph.Offsets[points] = edge;
  return graph;
}

/// A surface with a graph, or a cloud with a chain, and the context of a task on it.
struct GraphWorld
{
  explicit GraphWorld(const TestMesh& mesh, double accuracy = 0.01)
    : Surface(Prepare(mesh))
    , Graph(BuildGraph(this->Surface->GetMesh(), accuracy))
  {
    this->Graph.Info.Surface = this->Surface->GetSignature();
  }
  GraphWorld(const TestMesh& points, Id links, const std::vector<double>& radii)
    : Surface(Prepare(points, { dgg::Domain::Cloud, 0.0 }))
    , Graph(ChainGraph(*this->Surface, links))
    , Radii(radii)
  {
  }

  dgg::StoredGraph Store() const { return { this->Graph.View(), { 0.25, this->Radii.data() } }; }
  dgg::TaskContext MakeContext(std::uint64_t memoryLimit = 0) const
  {
    return { *this->Surface, { memoryLimit, nullptr }, 2, nullptr, WithThreads(2), nullptr };
  }

  dgg::PreparedSurface::Pointer Surface;
  dgg::GeodesicGraph Graph;
  std::vector<double> Radii;
};

inline dgg::PreparedGraph::Pointer MakeGraph(const GraphWorld& world, std::uintptr_t key = 1)
{
  return dgg::PreparedGraph::Make(world.Store(), { key }, nullptr, *world.Surface);
}

inline dgg::GraphSession StartSession(const GraphWorld& world)
{
  dgg::GraphSession session;
  session.Start(*world.Surface);
  session.Use(MakeGraph(world));
  return session;
}

/// Returns an L of three points at distance 1, and a point that no edge reaches.
inline TestMesh CornerCloud()
{
  TestMesh cloud;
  cloud.Points = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 7, 7, 0 };
  return cloud;
}
inline GraphWorld CornerWorld()
{
  return { CornerCloud(), 2, { 1.0, 1.0, 1.0, 0.0 } };
}
}

#endif
