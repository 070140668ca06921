// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistribution.h"

#include "vtkDGGMeshAdapter.h"

#include "dggEarthMovers.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

namespace
{
bool HasPoints(const vtkDGGMassOrigin& origin)
{
  return origin.Points && origin.Points->GetNumberOfPoints() > 0;
}

vtkDGGSourceSet GetSet(const vtkDGGMassOrigin& origin)
{
  static const std::vector<vtkIdType> none;
  return { none, origin.Points, origin.Port, "'" + origin.Name + "' point", "call " + origin.Setter,
    "" };
}

/// One number per point that is finite and not negative. `where` is what messages call the data.
dgg::Status ReadArray(vtkPolyData* data, const std::string& name, const std::string& where,
  const std::string& setter, std::vector<double>& values)
{
  vtkAbstractArray* found = data->GetPointData()->GetAbstractArray(name.c_str());
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  const vtkIdType n = data->GetNumberOfPoints();
  std::ostringstream message;
  if (!found)
  {
    message << where << " has no point array '" << name << "': call " << setter
            << " with the name of one";
  }
  else if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != n)
  {
    message << "the point array '" << name << "' of " << where << " has "
            << found->GetNumberOfComponents() << " components and " << found->GetNumberOfTuples()
            << " tuples of type " << found->GetDataTypeAsString() << " for " << n
            << " points: one number per point is needed";
  }
  if (!message.str().empty())
  {
    return dgg::Status::Invalid(message.str());
  }
  values.resize(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      message << "the point array '" << name << "' of " << where << " has the value " << value
              << " at point " << i << ": mass must be finite and not negative";
      return dgg::Status::Invalid(message.str());
    }
    values[static_cast<std::size_t>(i)] = value;
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistribution::Read(const vtkDGGMassOrigin& origin, vtkPolyData* surface)
{
  std::ostringstream port;
  port << "input port " << origin.Port;
  if (origin.Array.empty() && !HasPoints(origin))
  {
    return dgg::Status::Invalid("there is nothing to move " + origin.Name + ": call " +
      origin.Setter + " with the name of a point array, or connect points to " + port.str());
  }
  this->Values.clear();
  this->Masses.clear();
  if (!origin.Array.empty())
  {
    DGG_RETURN_IF_ERROR(
      ReadArray(surface, origin.Array, "the surface", origin.Setter, this->Values));
  }
  if (!HasPoints(origin))
  {
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(vtkDGGSourceCollector::Check(GetSet(origin), surface->GetNumberOfPoints()));
  this->Masses.assign(static_cast<std::size_t>(origin.Points->GetNumberOfPoints()), 1.0);
  return origin.MassArray.empty()
    ? dgg::Status::Success()
    : ReadArray(origin.Points, origin.MassArray, port.str(), "SetMassArrayName()", this->Masses);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistribution::Collect(const vtkDGGMassOrigin& origin, double tolerance,
  const vtkDGGMeshAdapter& mesh, vtkPolyData* surface, vtkDGGSourceCollector& collector)
{
  this->Places.clear();
  if (!HasPoints(origin))
  {
    return dgg::Status::Success();
  }
  std::vector<dgg::GeodesicSource> found;
  const dgg::Status status =
    collector.Collect(GetSet(origin), tolerance, mesh, surface->GetPoints(), found);
  this->Places = vtkDGGGetPlaces(found);
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistribution::Integrate(const vtkDGGMeshAdapter& mesh,
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
