// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Seeds of searches from surface points. Internal.
#ifndef dggGraphSeeds_h
#define dggGraphSeeds_h

#include "dggGraphBuilder.h" // for GraphLink
#include "dggGraphSearch.h"  // for GraphSeed
#include "dggStatus.h"       // for Status

#include <vector> // for links and seeds

namespace dgg
{
/// Returns the link of a point at a vertex.
inline GraphLink LinkOfVertex(Id vertex)
{
  constexpr double noDirection = -1.0;
  return { vertex, 0.0, noDirection };
}

/// Finds the links of a point. Calls GraphBuilder::Link() for a point that is not a vertex; fails
/// for such a point if `builder` is null.
inline Status FindLinks(const GraphBuilder* builder, const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct)
{
  if (IsVertex(point))
  {
    links = { LinkOfVertex(point.Vertex) };
    direct.assign(targets.size(), Infinity);
    return Status::Success();
  }
  return builder ? builder->Link(point, accuracy, targets, links, direct)
                 : InvalidInput("A point that is not a vertex needs a graph builder");
}

/// Appends the seeds of a source with these links and this initial distance.
inline void AppendSeeds(const std::vector<GraphLink>& links, std::vector<GraphSeed>& seeds,
  Id source = 0, double initialDistance = 0.0)
{
  for (const GraphLink& link : links)
  {
    seeds.push_back(
      { link.Vertex, initialDistance + link.Length, initialDistance, source, link.ArrivalAngle });
  }
}

/// Returns the seeds of a search from the point that has these links.
inline std::vector<GraphSeed> MakeSeeds(const std::vector<GraphLink>& links)
{
  std::vector<GraphSeed> seeds;
  AppendSeeds(links, seeds);
  return seeds;
}
}

#endif
