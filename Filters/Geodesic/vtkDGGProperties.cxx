// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGProperties.h"

#include <sstream>

//------------------------------------------------------------------------------
vtkIdType vtkDGGGetId(const std::vector<vtkIdType>& ids, vtkIdType i)
{
  return i >= 0 && i < static_cast<vtkIdType>(ids.size()) ? ids[i] : -1;
}

//------------------------------------------------------------------------------
void vtkDGGPrintIds(
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
dgg::Status vtkDGGCheckLength(const std::string& property, double value)
{
  if (value >= 0.0) // false for NaN
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << property << " is " << value << ": it must not be negative or NaN";
  return dgg::Status::Invalid(message.str());
}
