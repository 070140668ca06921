// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropertyChecks.h"

#include "dggCounted.h"

#include <algorithm>

namespace dgg
{
//------------------------------------------------------------------------------
Status CheckLengths(const std::vector<std::pair<std::string, double>>& properties)
{
  for (const auto& [name, value] : properties)
  {
    if (!(value >= 0.0)) // also true for NaN
    {
      return InvalidValue(name, value).Fix("Use a number of at least 0");
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CheckNames(const std::vector<std::pair<std::string, std::string>>& names)
{
  for (auto name = names.begin(); name != names.end(); ++name)
  {
    if (name->second.empty())
    {
      return InvalidValue(name->first, "empty").Fix("Use a name");
    }
    const auto same = std::find_if(
      names.begin(), name, [&](const auto& other) { return other.second == name->second; });
    if (same != name)
    {
      return InvalidInput(
        "{", same->first, "} and {", name->first, "} are both '", name->second, "'")
        .At(name->first)
        .Fix("Use different names");
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CheckCells(Offset numberOfPoints, Offset numberOfCells, const std::string& remedy)
{
  return numberOfCells > 0 ? Status::Success()
                           : InvalidInput("The input has ", Counted(numberOfPoints, "point"),
                               " but no polygons or triangle strips")
                               .At("Cells")
                               .Fix(remedy);
}
}
