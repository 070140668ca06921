// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGDistribution.h"

#include "DGGPreparedMesh.h"

#include "dggEarthMovers.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

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
  std::ostringstream message;
  if (!found)
  {
    message << where << " has no point array '" << name << "': call " << setter
            << " with the name of one";
  }
  else if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != n)
  {
    message << called << " has " << found->GetNumberOfComponents() << " components and "
            << found->GetNumberOfTuples() << " tuples of type " << found->GetDataTypeAsString()
            << " for " << n << " points: one number per point is needed";
  }
  bool isGood = message.str().empty();
  values.clear();
  for (vtkIdType i = 0; i < n && isGood; ++i)
  {
    values.push_back(array->GetComponent(i, 0));
    isGood = std::isfinite(values.back()) && !(areMasses && values.back() < 0.0);
    if (!isGood)
    {
      message << called << " has the value " << values.back() << " at point " << i
              << (areMasses ? ": mass must be finite and not negative"
                            : ": sources must be finite");
    }
  }
  return isGood ? dgg::Status::Success() : dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
dgg::Status DGGDistribution::Read(const DGGMassOrigin& origin, vtkPolyData* surface)
{
  std::ostringstream port;
  port << "input port " << origin.Port;
  if (origin.Array.empty() && !HasPoints(origin))
  {
    return dgg::Status::Invalid("there is nothing to move " + origin.Name + ": call " +
      origin.Setter + " with the name of a point array, or connect points to " + port.str());
  }
  dgg::Status status;
  this->Values.clear();
  if (!origin.Array.empty())
  {
    status =
      DGGReadNumbers(surface, origin.Array, "the surface", origin.Setter, true, this->Values);
  }
  this->Masses.clear();
  if (status.IsOk() && HasPoints(origin))
  {
    status = DGGSourceCollector::Check(GetSet(origin), surface->GetNumberOfPoints());
    this->Masses.assign(static_cast<std::size_t>(origin.Points->GetNumberOfPoints()), 1.0);
    if (status.IsOk() && !origin.MassArray.empty())
    {
      status = DGGReadNumbers(
        origin.Points, origin.MassArray, port.str(), "SetMassArrayName()", true, this->Masses);
    }
  }
  return status;
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
dgg::Status DGGDistribution::Integrate(
  const DGGPreparedMesh& mesh, const std::vector<double>* areas, std::vector<double>& masses) const
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
  dgg::Status status;
  for (std::size_t i = 0; i < this->Places.size() && status.IsOk(); ++i)
  {
    status = dgg::AddPointMass(mesh.GetMesh(), this->Places[i], this->Masses[i], masses);
  }
  return status;
}
