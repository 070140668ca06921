// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGProperties.h"

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
