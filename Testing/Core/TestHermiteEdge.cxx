// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cubics on edges that the published isolines cross.
#include "CurvedMeshes.h"
#include "FieldChecks.h"
#include "FlatMeshes.h"
#include "GraphChecks.h"

#include "dggHermiteEdge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dgg;
using namespace dggtest;

TEST(HermiteEdge, HasValuesAndSlopesOfItsEnds)
{
  const TestMesh test = Plane(8, 8, 0.2);
  const FieldCase c(test, { VertexSource(30) });
  HermiteEdge edge(c.Local, 3);
  const double* source = test.Point(30);
  int smooth = 0;
  for (Id h = 0; h < c.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    edge.Enter(h);
    const Id from = c.Mesh.Origin(edge.GetHalfEdge());
    const Id to = c.Mesh.Destination(edge.GetHalfEdge());
    EXPECT_FALSE(edge.HasRidge());
    const double length = edge.GetLength();
    EXPECT_EQ(edge.At(0.0), c.Result.Distances[from]);
    EXPECT_EQ(edge.At(length), c.Result.Distances[to]);
    auto slopeAt = [&](Id v) {
      const double* p = test.Point(v);
      const double d = c.Result.Distances[v];
      return ((p[0] - source[0]) * (test.Point(to)[0] - test.Point(from)[0]) +
               (p[1] - source[1]) * (test.Point(to)[1] - test.Point(from)[1])) /
        (d * length);
    };
    const double step = 1e-6 * length;
    if (from != 30 && to != 30)
    {
      EXPECT_NEAR((edge.At(step) - edge.At(0.0)) / step, slopeAt(from), 1e-4);
      EXPECT_NEAR((edge.At(length) - edge.At(length - step)) / step, slopeAt(to), 1e-4);
      ++smooth;
    }
    const std::vector<RimNode>& nodes = edge.GetNodes();
    EXPECT_EQ(
      std::count_if(nodes.begin(), nodes.end(), [](const RimNode& n) { return n.IsSite; }), 5);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      EXPECT_LT(nodes[i].X, nodes[i + 1].X);
    }
  }
  EXPECT_GT(smooth, 100);
}

TEST(HermiteEdge, KeepsRidgesSharp)
{
  const TestMesh test = Plane(10, 10, 0.2);
  const Id first = 27;
  const Id second = 93;
  const FieldCase c(test, { VertexSource(first), VertexSource(second, 0.2) });
  HermiteEdge edge(c.Local, 2);
  int ridges = 0;
  for (Id h = 0; h < c.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    edge.Enter(h);
    if (!edge.HasRidge())
    {
      continue;
    }
    ++ridges;
    const double* a = test.Point(c.Mesh.Origin(edge.GetHalfEdge()));
    const double* b = test.Point(c.Mesh.Destination(edge.GetHalfEdge()));
    for (const double t : { 0.1, 0.3, 0.5, 0.8 })
    {
      const double x = (1.0 - t) * a[0] + t * b[0];
      const double y = (1.0 - t) * a[1] + t * b[1];
      const double exact = std::min(std::hypot(x - test.Point(first)[0], y - test.Point(first)[1]),
        0.2 + std::hypot(x - test.Point(second)[0], y - test.Point(second)[1]));
      EXPECT_NEAR(edge.At(t * edge.GetLength()), exact, 1e-10);
    }
  }
  EXPECT_GT(ridges, 30);
}

TEST(HermiteEdge, NumbersThatOverflowStayFinite)
{
  const SurfaceMesh mesh = Build(Plane(2, 2));
  const double huge = 1.7e308;
  std::vector<double> values;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    values.push_back(v % 3 == 0 ? huge : v % 3 == 1 ? -huge : 1.0);
  }
  const DistanceField field{ &mesh, values.data(), nullptr, nullptr };
  HermiteEdge edge(field, 3);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    edge.Enter(h);
    for (const RimNode& node : edge.GetNodes())
    {
      EXPECT_TRUE(std::isfinite(node.Value));
      EXPECT_TRUE(node.X >= 0.0 && node.X <= edge.GetLength());
    }
  }
}
