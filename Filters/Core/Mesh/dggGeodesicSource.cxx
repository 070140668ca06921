// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGeodesicSource.h"

#include "dggStatus.h"

#include <cmath>

namespace dgg
{
Status CheckSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources)
{
  if (sources.empty())
  {
    return InvalidInput("There is no source").Fix("Add at least one source");
  }
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(sources[k].Point.Check(mesh).Of(JoinText("Source ", k)));
    if (!std::isfinite(sources[k].InitialDistance))
    {
      return InvalidInput("Source ", k, " has the initial distance ", sources[k].InitialDistance)
        .At("InitialDistance", static_cast<Offset>(k))
        .Fix("Use a finite number");
    }
  }
  return Status::Success();
}
}
