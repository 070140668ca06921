// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGeodesicSource.h"

#include "dggInvalidInput.h"

#include <cmath>
#include <string>

namespace dgg
{
Status CheckSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources)
{
  if (sources.empty())
  {
    return Status::Invalid("there is no source: give at least one");
  }
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(sources[k].Point.Check(mesh).Of("source " + std::to_string(k)));
    if (!std::isfinite(sources[k].InitialDistance))
    {
      return InvalidInput(
        "source ", k, ": the initial distance ", sources[k].InitialDistance, " is not finite");
    }
  }
  return Status::Success();
}
}
