// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphSeeds.h"

namespace dgg
{
Status FindLinks(const GraphBuilder* builder, const SurfacePoint& point, double accuracy,
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
                 : Status::Invalid("a point that is not a vertex needs a graph builder");
}

void AppendSeeds(const std::vector<GraphLink>& links, std::vector<GraphSeed>& seeds, Id source,
  double initialDistance)
{
  for (const GraphLink& link : links)
  {
    seeds.push_back(
      { link.Vertex, initialDistance + link.Length, initialDistance, source, link.ArrivalAngle });
  }
}

std::vector<GraphSeed> MakeSeeds(const std::vector<GraphLink>& links)
{
  std::vector<GraphSeed> seeds;
  seeds.reserve(links.size());
  AppendSeeds(links, seeds);
  return seeds;
}
}
