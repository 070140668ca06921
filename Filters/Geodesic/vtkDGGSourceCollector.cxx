// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGSourceCollector.h"

#include "vtkDGGMeshAdapter.h"
#include "vtkDGGSurfaceLocator.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

namespace
{
vtkIdType CountPoints(vtkPolyData* points)
{
  return points ? points->GetNumberOfPoints() : 0;
}

/// "source point 3 at (x, y, z)"
std::string Describe(vtkIdType index, const double p[3])
{
  std::ostringstream text;
  text << "source point " << index << " of input port 1, at (" << p[0] << ", " << p[1] << ", "
       << p[2] << "),";
  return text.str();
}

dgg::Status CheckInitialDistances(vtkPolyData* points, const std::string& name)
{
  std::ostringstream message;
  vtkPointData* data = points->GetPointData();
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array)
  {
    if (data->GetAbstractArray(name.c_str()))
    {
      message << "the point array '" << name << "' of input port 1 is not numeric: "
              << "InitialDistance needs one number per source point";
      return dgg::Status::Invalid(message.str());
    }
    return dgg::Status::Success();
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != CountPoints(points))
  {
    message << "the point array '" << name << "' of input port 1 has "
            << array->GetNumberOfComponents() << " components and " << array->GetNumberOfTuples()
            << " tuples for " << CountPoints(points) << " source points: one number per source "
            << "point is needed";
    return dgg::Status::Invalid(message.str());
  }
  for (vtkIdType i = 0; i < CountPoints(points); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      message << "the point array '" << name << "' of input port 1 gives source point " << i
              << " the initial distance " << value << ": a finite number is needed";
      return dgg::Status::Invalid(message.str());
    }
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
vtkDGGSourceCollector::vtkDGGSourceCollector() = default;
vtkDGGSourceCollector::~vtkDGGSourceCollector() = default;

//------------------------------------------------------------------------------
void vtkDGGSourceCollector::Forget()
{
  this->Locator.reset();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGSourceCollector::Check(const std::vector<vtkIdType>& ids, vtkPolyData* points,
  const std::string& initialDistanceName, vtkIdType numberOfPoints)
{
  if (ids.empty() && CountPoints(points) == 0)
  {
    return dgg::Status::Invalid(points
        ? "there is no source: input port 1 has no points. Give it points, or call AddSourceId() "
          "or SetSourceIds()"
        : "there is no source: call AddSourceId() or SetSourceIds(), or connect points to input "
          "port 1");
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      std::ostringstream message;
      message << "source id " << ids[i] << " (number " << i << " of the source ids) is out of "
              << "range: the input has " << numberOfPoints << " points, so ids must be in [0, "
              << numberOfPoints - 1 << "]";
      return dgg::Status::Invalid(message.str());
    }
  }
  for (vtkIdType i = 0; i < CountPoints(points); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return dgg::Status::Invalid(
        Describe(i, p) + " has coordinates that are not finite: move or remove it");
    }
  }
  return points ? CheckInitialDistances(points, initialDistanceName) : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGSourceCollector::Collect(const std::vector<vtkIdType>& ids, vtkPolyData* points,
  const std::string& initialDistanceName, double tolerance, const vtkDGGMeshAdapter& adapter,
  vtkPoints* coordinates, std::vector<dgg::GeodesicSource>& sources)
{
  sources.clear();
  for (const vtkIdType id : ids)
  {
    sources.push_back({ dgg::SurfacePoint::AtVertex(adapter.GetVertex(id)), 0.0 });
  }
  if (CountPoints(points) == 0)
  {
    return dgg::Status::Success();
  }

  if (!this->Locator)
  {
    this->Locator = std::make_unique<vtkDGGSurfaceLocator>(adapter.GetMesh(), coordinates);
  }
  const double farthest = tolerance * this->Locator->GetDiagonal();
  vtkDataArray* offsets = points->GetPointData()->GetArray(initialDistanceName.c_str());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    dgg::GeodesicSource source;
    source.InitialDistance = offsets ? offsets->GetComponent(i, 0) : 0.0;
    double distance = dgg::Infinity;
    const bool found = this->Locator->FindClosestPoint(p, source.Point, distance);
    if (!found || !(distance <= farthest))
    {
      std::ostringstream message;
      message << Describe(i, p) << " is " << distance << " away from the surface, farther than "
              << farthest << " (ProjectionTolerance " << tolerance << " times the diagonal "
              << this->Locator->GetDiagonal()
              << "): move it to the surface, or raise ProjectionTolerance";
      return dgg::Status::Invalid(message.str());
    }
    sources.push_back(source);
  }
  return dgg::Status::Success();
}
