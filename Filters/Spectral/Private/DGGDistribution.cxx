// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGDistribution.h"

#include "DGGContext.h"
#include "DGGSurfaceArrays.h"

#include "dggEarthMovers.h"
#include "dggStatus.h"
#include "dggPreparedSurface.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace
{
DGGSourceSet GetSet(const DGGMassOrigin& origin)
{
  static const std::vector<vtkIdType> none;
  return { none, origin.Points, origin.Port, "'" + origin.Name + "'", "", "" };
}
}

//------------------------------------------------------------------------------
dgg::Status DGGReadNumbers(vtkPolyData* data, const std::string& name, const std::string& where,
  const std::string& property, bool areMasses, std::vector<double>& values)
{
  vtkAbstractArray* found = data->GetPointData()->GetAbstractArray(name.c_str());
  vtkDataArray* array = nullptr;
  values.clear();
  if (!found)
  {
    return dgg::InvalidInput("There is no point array '", name, "' on ", where)
      .At(property)
      .Fix("Set {", property, "} to the name of a point array");
  }
  DGG_RETURN_IF_ERROR(DGGCheckPointArray(found, data, where, 1, array));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
    if (!std::isfinite(values.back()) || (areMasses && values.back() < 0.0))
    {
      return dgg::InvalidInput("The point array '", name, "' of ", where, " has the value ",
        values.back(), " at point ", i)
        .At(property, i)
        .Fix(areMasses ? "Use finite masses of at least 0" : "Use finite sources");
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGDistribution::Read(
  const DGGContext& context, const DGGMassOrigin& origin, double tolerance)
{
  const DGGSourceSet points = GetSet(origin);
  const std::string port = "input port " + std::to_string(origin.Port);
  if (origin.Array.empty() && points.IsEmpty())
  {
    return dgg::InvalidInput("There is nothing to move ", origin.Name)
      .At(origin.Property)
      .Fix("Set {", origin.Property, "} to the name of a point array, or connect points to ", port);
  }
  *this = DGGDistribution();
  if (!origin.Array.empty())
  {
    DGG_RETURN_IF_ERROR(DGGReadNumbers(
      context.Input, origin.Array, "the surface", origin.Property, true, this->Values));
  }
  if (points.IsEmpty())
  {
    return dgg::Status::Success();
  }
  this->Masses.assign(points.CountPoints(), 1.0);
  if (!origin.MassArray.empty())
  {
    DGG_RETURN_IF_ERROR(DGGReadNumbers(
      origin.Points, origin.MassArray, port, "SetMassArrayName()", true, this->Masses));
  }
  return DGGLocate(context, points, tolerance, this->Places);
}

//------------------------------------------------------------------------------
dgg::Status DGGDistribution::Integrate(const dgg::PreparedSurface& mesh,
  const std::vector<double>* areas, std::vector<double>& masses) const
{
  masses.assign(static_cast<std::size_t>(mesh.GetMesh().GetNumberOfVertices()), 0.0);
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const dgg::Id v = mesh.GetVertex(static_cast<vtkIdType>(i));
    if (!areas)
    {
      masses[v] += this->Values[i];
    }
    else if (v == static_cast<dgg::Id>(i))
    {
      masses[v] = this->Values[i] * (*areas)[v];
    }
  }
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(
      dgg::AddPointMass(mesh.GetMesh(), this->Places[i], this->Masses[i], masses));
  }
  return dgg::Status::Success();
}
