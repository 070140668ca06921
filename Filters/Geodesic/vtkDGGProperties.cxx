// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGProperties.h"

#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
bool vtkDGGChangeNumber(double& property, double value)
{
  const bool bothNaN = std::isnan(value) && std::isnan(property);
  const bool changes = property != value && !bothNaN;
  property = changes ? value : property;
  return changes;
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
