// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Borders of Voronoi cells within large faces: what finding them may cost.
#include "FlatMeshes.h"
#include "PathChecks.h"
#include "SearchChecks.h"

#include "dggBorderRefinement.h"
#include "dggCentroidal.h"
#include "dggEdgeCuts.h"
#include "dggVoronoi.h"

#include <gtest/gtest.h>

#include <vector>

namespace dggtest
{
namespace
{
/// Upright walls along the lines of a grid of columns x rows cells, in `height` rows of quads.
TestMesh Honeycomb(Id columns, Id rows, Id height)
{
  TestMesh mesh;
  const auto at = [&](Id i, Id j, Id k) { return (k * (rows + 1) + j) * (columns + 1) + i; };
  for (Id k = 0; k <= height; ++k)
  {
    for (Id j = 0; j <= rows; ++j)
    {
      for (Id i = 0; i <= columns; ++i)
      {
        mesh.AddPoint(i, j, 0.3 * k);
      }
    }
  }
  for (Id k = 0; k < height; ++k)
  {
    for (Id j = 0; j <= rows; ++j)
    {
      for (Id i = 0; i <= columns; ++i)
      {
        if (i < columns)
        {
          mesh.AddQuad(at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1));
        }
        if (j < rows)
        {
          mesh.AddQuad(at(i, j, k), at(i, j + 1, k), at(i, j + 1, k + 1), at(i, j, k + 1));
        }
      }
    }
  }
  return mesh;
}

}

/// Links are dear where light multiplies: they end before they take many times what the rest does.
TEST(BorderRefinement, IsBounded)
{
  const SearchCase c("honeycomb", Honeycomb(5, 5, 40), 0.05);
  const dgg::GraphBuilder builder(c.GetMesh());
  const std::vector<dgg::SurfacePoint> sites = AtVertices({ 0, 50, 100, 140 });
  dgg::LinkedSites linked;
  ASSERT_TRUE(dgg::LinkSites(sites, &builder, 0.05, linked).IsOk());
  dgg::SiteDistances distances;
  ASSERT_TRUE(distances.Run(c.GetSearch(), c.GetMesh(), linked.Seeds, nullptr).IsOk());
  const dgg::BorderRefinement refinement(c.GetMesh(), distances, builder, 0.05, sites);
  dgg::VoronoiDiagram diagram;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    diagram.NearestSites.push_back(distances.Nearest(v)->Site);
    diagram.Distances.push_back(distances.Nearest(v)->Distance);
  }
  dgg::EdgeCuts cuts(c.GetMesh());
  ASSERT_TRUE(cuts.Run(distances, &refinement, nullptr, diagram));
  EXPECT_GT(refinement.GetWork(), 0u);
  EXPECT_LE(refinement.GetWork(), refinement.GetMostWork() + refinement.GetMostWork() / 8);
}
}
