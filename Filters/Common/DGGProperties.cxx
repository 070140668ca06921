// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGProperties.h"

#include "dggStatus.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkIdType DGGGetId(const std::vector<vtkIdType>& ids, vtkIdType i)
{
  return i >= 0 && i < static_cast<vtkIdType>(ids.size()) ? ids[i] : -1;
}

//------------------------------------------------------------------------------
void DGGPrintIds(
  std::ostream& os, vtkIndent indent, const char* name, const std::vector<vtkIdType>& ids)
{
  os << indent << name << ":";
  for (const vtkIdType id : ids)
  {
    os << " " << id;
  }
  os << (ids.empty() ? " (none)\n" : "\n");
}

//------------------------------------------------------------------------------
dgg::Status DGGCheckLengths(std::initializer_list<std::pair<const char*, double>> properties)
{
  for (const auto& [name, value] : properties)
  {
    if (!(value >= 0.0)) // also true for NaN
    {
      return dgg::InvalidValue(name, value).Fix("Use a number of at least 0");
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGCheckNames(const std::vector<std::pair<std::string, std::string>>& names)
{
  for (auto name = names.begin(); name != names.end(); ++name)
  {
    if (name->second.empty())
    {
      return dgg::InvalidValue(name->first, "empty").Fix("Use a name");
    }
    const auto same = std::find_if(
      names.begin(), name, [&](const auto& other) { return other.second == name->second; });
    if (same != name)
    {
      return dgg::InvalidInput(
        "{", same->first, "} and {", name->first, "} are both '", name->second, "'")
        .At(name->first)
        .Fix("Use different names");
    }
  }
  return dgg::Status::Success();
}
