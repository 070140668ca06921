// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggInputArray.h"

#include "dggCounted.h"
#include "dggPreparedSurface.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
//------------------------------------------------------------------------------
Status InputArray::CheckPoints(
  const std::string& where, Offset numberOfPoints, int components) const
{
  if (this->Fits(numberOfPoints, components))
  {
    return Status::Success();
  }
  return InvalidInput("The point array '", this->Name, "' of ", where, " has ",
    Counted(this->NumberOfComponents, "component"), " and ", Counted(this->NumberOfTuples, "tuple"),
    " of type ", this->Type, " for ", Counted(numberOfPoints, "point"))
    .Fix(components == 1 ? "Use an array with one number per point"
                         : "Use an array with numbers for each point");
}

//------------------------------------------------------------------------------
Status InputArray::RequirePoints(const std::string& where, const std::string& property,
  Offset numberOfPoints, int components) const
{
  return this->Exists() ? this->CheckPoints(where, numberOfPoints, components)
                        : InvalidInput("There is no point array '", this->Name, "' on ", where)
                            .At(property)
                            .Fix("Set {", property, "} to the name of a point array");
}

//------------------------------------------------------------------------------
Status InputArray::RequireNumbers(const std::string& where, const std::string& property,
  Offset numberOfPoints, bool areMasses) const
{
  DGG_RETURN_IF_ERROR(this->RequirePoints(where, property, numberOfPoints, 1));
  const auto wrong = std::find_if(this->Values.begin(), this->Values.end(),
    [areMasses](double x) { return !std::isfinite(x) || (areMasses && x < 0.0); });
  if (wrong == this->Values.end())
  {
    return Status::Success();
  }
  const Offset point = wrong - this->Values.begin();
  return InvalidInput(
    "The point array '", this->Name, "' of ", where, " has the value ", *wrong, " at point ", point)
    .At(property, point)
    .Fix(areMasses ? "Use finite masses of at least 0" : "Use finite sources");
}

//------------------------------------------------------------------------------
std::vector<double> InputArray::Integrate(
  const PreparedSurface& surface, const std::vector<double>* areas) const
{
  std::vector<double> sums(
    static_cast<std::size_t>(surface.GetMeshWithoutAngles().GetNumberOfVertices()), 0.0);
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const Id v = surface.GetVertex(static_cast<Offset>(i));
    if (!areas || v == static_cast<Id>(i)) // merged points have the density of the first
    {
      sums[v] += areas ? this->Values[i] * (*areas)[v] : this->Values[i];
    }
  }
  return sums;
}
}
