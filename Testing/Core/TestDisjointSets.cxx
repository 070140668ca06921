// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are joined, and half-edges that stand for their edge.
#include "DefectMeshes.h"
#include "FlatMeshes.h"

#include "dggDisjointSets.h"
#include "dggEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::Id;
}

TEST(DisjointSets, AreThoseOfLabels)
{
  const Id count = 300;
  dgg::DisjointSets sets(count);
  std::vector<Id> labels(count); // the plain way: relabel one of the two
  for (Id i = 0; i < count; ++i)
  {
    labels[i] = i;
    EXPECT_EQ(sets.Find(i), i);
  }
  std::mt19937 random(7);
  int joined = 0;
  for (int k = 0; k < 600; ++k)
  {
    const Id i = static_cast<Id>(random() % count);
    const Id j = static_cast<Id>(random() % count);
    const Id from = std::max(labels[i], labels[j]);
    const Id to = std::min(labels[i], labels[j]);
    EXPECT_EQ(sets.Join(i, j), from != to);
    joined += from != to ? 1 : 0;
    std::replace(labels.begin(), labels.end(), from, to);
  }
  EXPECT_GT(joined, 200);
  EXPECT_LT(joined, 299);
  for (Id i = 0; i < count; ++i)
  {
    EXPECT_EQ(sets.Find(i), labels[i]) << i;
  }
}

TEST(DisjointSets, SmallestNumberStandsForALongChain)
{
  const Id count = 100000;
  dgg::DisjointSets sets(count);
  for (Id i = count - 1; i > 0; --i)
  {
    EXPECT_TRUE(sets.Join(i, i - 1));
  }
  EXPECT_EQ(sets.Find(count - 1), 0);
  EXPECT_FALSE(sets.Join(17, 4711));
}

TEST(Edges, AllHalfEdgesOfAnEdgeHaveTheSame)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  meshes.push_back({ "cube", Cube(2) });
  meshes.push_back({ "plane", Plane(4, 3) });
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id edge = dgg::FindEdge(mesh, h);
      EXPECT_LE(edge, h);
      EXPECT_EQ(dgg::FindEdge(mesh, edge), edge);
      EXPECT_EQ(std::minmax(mesh.Origin(edge), mesh.Destination(edge)),
        std::minmax(mesh.Origin(h), mesh.Destination(h)));
      if (mesh.Twin(h) == dgg::NoId)
      {
        EXPECT_EQ(edge, h);
      }
      else
      {
        EXPECT_EQ(dgg::FindEdge(mesh, mesh.Twin(h)), edge);
      }
    }
  }
}
}
