// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGDistribution.h"

#include "dggPreparedSurface.h"

#include "dggEarthMovers.h"
#include "dggInvalidInput.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace
{
bool HasPoints(const DGGMassOrigin& origin)
{
  return origin.Points && origin.Points->GetNumberOfPoints() > 0;
}

DGGSourceSet GetSet(const DGGMassOrigin& origin)
{
  static const std::vector<vtkIdType> none;
  return { none, origin.Points, origin.Port, "'" + origin.Name + "' point", "call " + origin.Setter,
    "" };
}
}

//------------------------------------------------------------------------------
dgg::Status DGGReadNumbers(vtkPolyData* data, const std::string& name, const std::string& where,
  const std::string& setter, bool areMasses, std::vector<double>& values)
{
  vtkAbstractArray* found = data->GetPointData()->GetAbstractArray(name.c_str());
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  const vtkIdType n = data->GetNumberOfPoints();
  const std::string called = "the point array '" + name + (areMasses ? "' of " + where : "'");
  values.clear();
  if (!found)
  {
    return dgg::InvalidInput(
      where, " has no point array '", name, "': call ", setter, " with the name of one");
  }
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != n)
  {
    return dgg::InvalidInput(called, " has ", found->GetNumberOfComponents(), " components and ",
      found->GetNumberOfTuples(), " tuples of type ", found->GetDataTypeAsString(), " for ", n,
      " points: one number per point is needed");
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    values.push_back(array->GetComponent(i, 0));
    if (!std::isfinite(values.back()) || (areMasses && values.back() < 0.0))
    {
      return dgg::InvalidInput(called, " has the value ", values.back(), " at point ", i,
        areMasses ? ": mass must be finite and not negative" : ": sources must be finite");
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGDistribution::Read(const DGGMassOrigin& origin, vtkPolyData* surface)
{
  const std::string port = "input port " + std::to_string(origin.Port);
  if (origin.Array.empty() && !HasPoints(origin))
  {
    return dgg::Status::Invalid("there is nothing to move " + origin.Name + ": call " +
      origin.Setter + " with the name of a point array, or connect points to " + port);
  }
  this->Values.clear();
  this->Masses.clear();
  if (!origin.Array.empty())
  {
    DGG_RETURN_IF_ERROR(
      DGGReadNumbers(surface, origin.Array, "the surface", origin.Setter, true, this->Values));
  }
  if (!HasPoints(origin))
  {
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(DGGSourceCollector::Check(GetSet(origin), surface->GetNumberOfPoints()));
  this->Masses.assign(static_cast<std::size_t>(origin.Points->GetNumberOfPoints()), 1.0);
  return origin.MassArray.empty() ? dgg::Status::Success()
                                  : DGGReadNumbers(origin.Points, origin.MassArray, port,
                                      "SetMassArrayName()", true, this->Masses);
}

//------------------------------------------------------------------------------
dgg::Status DGGDistribution::Collect(
  const DGGContext& context, const DGGMassOrigin& origin, double tolerance)
{
  this->Places.clear();
  if (!HasPoints(origin))
  {
    return dgg::Status::Success();
  }
  std::vector<dgg::GeodesicSource> found;
  const dgg::Status status = DGGSourceCollector::Collect(context, GetSet(origin), tolerance, found);
  this->Places = DGGGetPlaces(found);
  return status;
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
