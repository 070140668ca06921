// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePoints.h"

#include "Arguments.h"
#include "Arrays.h"
#include "Errors.h"

#include "dggStatus.h"
#include "dggTaskContext.h"

namespace dggPython
{
namespace
{
std::vector<double> ToVector(const Array<double>& array)
{
  return std::vector<double>(array.data(), array.data() + array.size());
}

void ReadIds(const py::handle& object, const std::string& name, dgg::SourceCollection& points)
{
  const Array<dgg::Offset> ids = ToIntegers(object, name.c_str());
  points.Ids.assign(ids.data(), ids.data() + ids.size());
}

/// Reads coordinates of shape (3,) or (..., 3).
void ReadPositions(const py::array& array, const std::string& name, dgg::SourceCollection& points)
{
  const Array<double> positions = ToNumbers(array, name.c_str());
  if (positions.size() > 0 && (positions.ndim() == 0 || positions.shape(positions.ndim() - 1) != 3))
  {
    throw py::value_error(name + ": expected integers or coordinates of shape (n, 3)");
  }
  points.Positions = ToVector(positions);
  points.AreRounded = array.dtype().kind() == 'f' && GetItemSize(array) < 8;
}

/// Reads points whose parts are items of a dict.
void ReadParts(const py::dict& parts, const std::string& name, dgg::SourceCollection& points)
{
  const auto get = [&](const char* key) {
    return parts.contains(key) ? py::object(parts[key]) : py::object();
  };
  const auto read = [&](const char* key, py::ssize_t columns, std::vector<double>& values) {
    if (const py::object part = get(key); part && !part.is_none())
    {
      values = ToVector(ToTable(part, columns, (name + "[\"" + key + "\"]").c_str()));
    }
  };
  if (const py::object ids = get("ids"); ids && !ids.is_none())
  {
    ReadIds(ids, name + "[\"ids\"]", points);
  }
  if (const py::object positions = get("points"); positions && !positions.is_none())
  {
    const py::array array = py::array::ensure(positions);
    if (!array)
    {
      throw py::error_already_set();
    }
    ReadPositions(array, name + "[\"points\"]", points);
  }
  read("original_ids", 1, points.OriginalIds);
  read("cells", 1, points.Cells);
  read("barycentric", 3, points.Barycentric);
  if (points.Positions.empty())
  {
    points.Positions.resize(3 * points.Cells.size()); // their values are not used
  }
  const std::size_t count = points.Positions.size() / 3;
  for (const std::size_t size :
    { points.OriginalIds.size(), points.Cells.size(), points.Barycentric.size() / 3 })
  {
    if (size != 0 && size != count)
    {
      throw py::value_error(name + ": expected " + std::to_string(count) + " rows per array, got " +
        std::to_string(size));
    }
  }
}
}

//------------------------------------------------------------------------------
SurfacePoints::SurfacePoints(
  const py::handle& object, const std::string& role, const std::string& property)
{
  const std::string argument = GetArgumentName(property);
  this->Collection.Role = role;
  this->Collection.Property = property;
  if (!object || object.is_none())
  {
    return;
  }
  if (py::isinstance<py::dict>(object))
  {
    ReadParts(py::reinterpret_borrow<py::dict>(object), argument, this->Collection);
    return;
  }
  const py::array array = py::array::ensure(object);
  if (!array)
  {
    throw py::error_already_set();
  }
  if (array.dtype().kind() == 'f')
  {
    ReadPositions(array, argument, this->Collection);
  }
  else
  {
    ReadIds(array, argument, this->Collection);
  }
}

//------------------------------------------------------------------------------
void SurfacePoints::ReadTolerance(Arguments& arguments)
{
  arguments.ReadLength("projection_tolerance", this->Tolerance);
}

//------------------------------------------------------------------------------
void SurfacePoints::ReadInitialDistances(Arguments& arguments)
{
  std::vector<double> distances;
  arguments.Read("initial_distances", distances);
  if (distances.empty())
  {
    return;
  }
  if (distances.size() != this->Size())
  {
    throw py::value_error("initial_distances: expected one per point, " +
      std::to_string(this->Size()) + ", got " + std::to_string(distances.size()));
  }
  const auto ids = static_cast<std::ptrdiff_t>(this->Collection.Ids.size());
  this->Collection.InitialDistancesOfIds.assign(distances.begin(), distances.begin() + ids);
  this->Collection.InitialDistances.assign(distances.begin() + ids, distances.end());
}

//------------------------------------------------------------------------------
std::size_t SurfacePoints::Size() const
{
  return this->Collection.Ids.size() + this->Collection.Positions.size() / 3;
}

//------------------------------------------------------------------------------
dgg::Status SurfacePoints::Locate(const dgg::TaskContext& context,
  std::vector<dgg::GeodesicSource>& sources, std::vector<std::string>* warnings) const
{
  return this->Collection.Locate(context, this->Tolerance, sources, warnings);
}

//------------------------------------------------------------------------------
dgg::Status SurfacePoints::Locate(const dgg::TaskContext& context,
  std::vector<dgg::SurfacePoint>& points, std::vector<std::string>* warnings) const
{
  return this->Collection.Locate(context, this->Tolerance, points, warnings);
}
}
