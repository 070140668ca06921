// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges of a graph are followed over the mesh with little work, on thin triangles as well.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "SearchChecks.h"

#include "dggPathTracer.h"

#include <gtest/gtest.h>

namespace dggtest
{
namespace
{
/// Long along one axis.
TestMesh Stretched(TestMesh mesh, double factor)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= factor;
  }
  return mesh;
}

struct TraceWork
{
  std::size_t GraphEdges = 0;
  std::size_t Missed = 0;
  std::size_t Beams = 0;
};

/// Trace edges of the graph of a mesh, every `step`-th.
TraceWork TraceEdges(const TestMesh& mesh, dgg::Offset step)
{
  const SearchCase c("mesh", mesh, 0.05);
  const dgg::GraphView graph = c.GetGraph();
  dgg::GraphEdgeTracer tracer(c.GetMesh());
  TraceWork work;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; e += step)
    {
      Id face = dgg::NoId;
      std::vector<dgg::EdgeCrossing> crossings;
      const bool isFound = tracer.Trace(
        { v, graph.Angles[e], dgg::SurfacePoint::AtVertex(graph.Targets[e]), graph.Length(e) },
        face, crossings);
      ++work.GraphEdges;
      work.Missed += isFound ? 0 : 1;
      work.Beams += tracer.GetNumberOfBeams();
    }
  }
  return work;
}

TEST(GraphEdgeTracer, WorkDoesNotGrowWithTheLengthOfTriangles)
{
  const std::vector<NamedMesh> meshes = { { "sphere", NoisySphere(3, 0.05, 1) },
    { "plane", Plane(20, 20, 0.2) }, { "torus", Torus(20, 20) },
    { "box", Box(8, 8, 8, 1.0, 1.0, 1.0, 0.2) } };
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const TraceWork clean = TraceEdges(named.Mesh, 7);
    EXPECT_EQ(clean.Missed, 0u);
    EXPECT_LE(clean.Beams, 10 * clean.GraphEdges);
    for (const double factor : { 1e3, 1e5, 1e7 })
    {
      SCOPED_TRACE(factor);
      const TraceWork work = TraceEdges(Stretched(named.Mesh, factor), 7);
      EXPECT_LE(work.Missed, work.GraphEdges / 50);
      EXPECT_LE(work.Beams, 500 * work.GraphEdges);
    }
  }
}

/// A tiny edge has the rounding errors of the long ones next to it.
TEST(GraphEdgeTracer, FindsHeadsNextToLongEdges)
{
  TestMesh mesh = NoisySphere(2, 0.05, 2);
  Random random(2);
  for (int i = 0; i < 60; ++i)
  {
    const Id* corners = &mesh.Triangles[3 * random.Index(mesh.GetNumberOfFaces())];
    const Id a = corners[0];
    const Id b = corners[1];
    if (EuclideanDistance(mesh, a, b) > 1e-4)
    {
      SplitEdge(mesh, a, b, 1e-11 * random.Uniform(0.5, 1.0));
    }
  }
  EXPECT_EQ(TraceEdges(mesh, 7).Missed, 0u);
}
}
}
