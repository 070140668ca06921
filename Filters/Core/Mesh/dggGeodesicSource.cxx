// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGeodesicSource.h"

#include <cmath>
#include <sstream>

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
    const Status status = sources[k].Point.Check(mesh);
    std::ostringstream message;
    if (!status.IsOk())
    {
      message << "source " << k << ": " << status.GetMessage();
      return Status::Invalid(message.str());
    }
    if (!std::isfinite(sources[k].InitialDistance))
    {
      message << "source " << k << ": the initial distance " << sources[k].InitialDistance
              << " is not finite";
      return Status::Invalid(message.str());
    }
  }
  return Status::Success();
}
}
