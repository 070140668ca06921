// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Seeds of searches from surface points. Internal.
#ifndef dggGraphSeeds_h
#define dggGraphSeeds_h

#include "dggGraphBuilder.h" // for GraphLink
#include "dggGraphSearch.h"  // for GraphSeed

#include <vector> // for links and seeds

namespace dgg
{
/// Returns the link of a point at a vertex.
inline GraphLink LinkOfVertex(Id vertex)
{
  constexpr double noDirection = -1.0;
  return { vertex, 0.0, noDirection };
}

/// Finds the links of a point, like GraphBuilder::Link(), which is called for points that are not
/// vertices. Fails for these if `builder` is null.
Status FindLinks(const GraphBuilder* builder, const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct);

/// Appends the seeds of a source with these links and this initial distance.
void AppendSeeds(const std::vector<GraphLink>& links, std::vector<GraphSeed>& seeds, Id source = 0,
  double initialDistance = 0.0);
/// Returns the seeds of a search from the point that has these links.
std::vector<GraphSeed> MakeSeeds(const std::vector<GraphLink>& links);
}

#endif
