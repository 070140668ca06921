// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGProperties.h"

#include "dggStatus.h"

#include <map>

//------------------------------------------------------------------------------
std::string DGGRender(const std::string& message)
{
  static const std::map<std::string, std::string> inputs = { { "Curves", "input port 1" },
    { "FromPoints", "input port 1" }, { "InArrays", "on the input" }, { "Pairs", "input port 1" },
    { "PointValues", "input port 1" }, { "ToPoints", "input port 2" } };
  return dgg::Render(message, [](const std::string& name) {
    const auto input = inputs.find(name);
    return input == inputs.end() ? name : input->second;
  });
}

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
