// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphSeeds.h"

#include <cmath>
#include <sstream>
#include <string>

namespace dgg
{
namespace
{
Status InvalidSeed(std::size_t index, const std::string& what)
{
  return Status::Invalid("source " + std::to_string(index) + ": " + what);
}

Status CheckSeed(const GraphSeed& seed, std::size_t index, Id numberOfVertices)
{
  const Status status = CheckVertex(seed.Vertex, numberOfVertices);
  if (!status.IsOk())
  {
    return InvalidSeed(index, status.GetMessage());
  }
  std::ostringstream what;
  if (!std::isfinite(seed.Distance) || !std::isfinite(seed.InitialDistance))
  {
    what << "the distances " << seed.Distance << " and " << seed.InitialDistance
         << " that it starts with are not finite";
    return InvalidSeed(index, what.str());
  }
  if (!std::isfinite(seed.ArrivalAngle))
  {
    return InvalidSeed(index, "its arrival angle is not finite");
  }
  if (seed.ArrivalAngle >= 0.0 && seed.Distance < seed.InitialDistance)
  {
    what << "it starts with the distance " << seed.Distance
         << ", which is below its initial distance " << seed.InitialDistance;
    return InvalidSeed(index, what.str());
  }
  return Status::Success();
}
}

Status CheckVertex(Id vertex, Id numberOfVertices)
{
  if (vertex >= 0 && vertex < numberOfVertices)
  {
    return Status::Success();
  }
  return Status::Invalid("vertex " + std::to_string(vertex) + " does not exist, there are " +
    std::to_string(numberOfVertices) + " vertices");
}

Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices)
{
  if (seeds.empty())
  {
    return Status::Invalid("there is no source: give at least one");
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    Status status = CheckSeed(seeds[i], i, numberOfVertices);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}
}
