// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggDistanceOutput.h"

#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"
#include "dggStoredWindows.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace dgg
{
namespace
{
/// Adds marks of unreached points, unless all points, also those of other pieces, are reached or
/// the value is unambiguous.
void AddMarks(const std::string& name, double unreachedValue, const std::vector<bool>& isReached,
  bool areOthersUnreached, OutputArrays& arrays)
{
  const bool isPlain = std::isnan(unreachedValue) || unreachedValue == Infinity;
  const bool isNeeded =
    areOthersUnreached || std::find(isReached.begin(), isReached.end(), false) != isReached.end();
  if (!isPlain && isNeeded)
  {
    std::transform(isReached.begin(), isReached.end(),
      arrays.Add<std::uint8_t>(GetUnreachedName(name), isReached.size()),
      [](bool reached) { return reached ? 0 : 1; });
  }
}

/// Adds point arrays with the values of vertices.
struct PointArrayWriter
{
  const PreparedSurface& Surface;
  const DistanceResults& Results;
  const std::vector<bool>& IsReached; ///< per vertex
  OutputArrays& Arrays;

  /// Returns the values. `valueOf(i, k)` returns component k of the result at index i.
  template <typename ValueType, typename ValueOf>
  const ValueType* Add(
    const std::string& name, int components, ValueType unreached, const ValueOf& valueOf)
  {
    const std::size_t size = this->IsReached.size();
    const auto count = static_cast<std::size_t>(components);
    ValueType* const values = this->Arrays.Add<ValueType>(name, size, components);
    if (this->Results.IsSparse)
    {
      std::fill_n(values, size * count, unreached);
      for (std::size_t i = 0; i < this->Results.Vertices.size(); ++i)
      {
        const auto vertex = static_cast<std::size_t>(this->Results.Vertices[i]);
        for (std::size_t k = 0; k < count && this->IsReached[vertex]; ++k)
        {
          values[vertex * count + k] = valueOf(i, k);
        }
      }
      return values;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const Id vertex = this->Surface.GetVertex(static_cast<Offset>(i));
      for (std::size_t k = 0; k < count; ++k)
      {
        values[i * count + k] = this->IsReached[vertex] ? valueOf(vertex, k) : unreached;
      }
    }
    return values;
  }
};

/// Returns the nearest source of each point of the input; NoId if unreached. For results that are
/// not sparse.
std::vector<Id> GetNearestSources(const PreparedSurface& surface, const DistanceResults& results,
  const std::vector<bool>& isReached)
{
  std::vector<Id> nearest(isReached.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    const Id vertex = surface.GetVertex(static_cast<Offset>(i));
    nearest[i] = isReached[vertex] ? results.NearestSource[vertex] : NoId;
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
std::vector<bool> FindReached(const PreparedSurface& surface, const DistanceResults& results)
{
  std::vector<bool> isReached(results.IsSparse
      ? static_cast<std::size_t>(surface.GetMeshWithoutAngles().GetNumberOfVertices())
      : results.Distances.size());
  for (std::size_t i = 0; i < results.Distances.size(); ++i)
  {
    const double distance = results.Distances[i];
    isReached[results.IsSparse ? results.Vertices[i] : i] =
      distance <= results.MaximumDistance && distance < Infinity;
  }
  return isReached;
}

//------------------------------------------------------------------------------
bool AreMostReached(const std::vector<bool>& isReached)
{
  return 2 * std::count(isReached.begin(), isReached.end(), true) >
    static_cast<std::ptrdiff_t>(isReached.size());
}

//------------------------------------------------------------------------------
Status DistanceRequest::Check() const
{
  DGG_RETURN_IF_ERROR(CheckLengths({ { "MaximumDistance", this->MaximumDistance } }));
  std::vector<std::pair<std::string, std::string>> names = { { "DistanceArrayName",
    this->Names.Distance } };
  if (this->WantNearestSource)
  {
    names.emplace_back("SourceArrayName", this->Names.Source);
  }
  if (this->WantVirtualSource)
  {
    names.emplace_back("VirtualSourceArrayName", this->Names.VirtualSource);
  }
  for (const VertexArray& array : this->Arrays)
  {
    names.emplace_back(array.Property, array.Name);
  }
  return CheckNames(names);
}

//------------------------------------------------------------------------------
Status FindDistances(const TaskContext& context, const SourceCollection& sources, double tolerance,
  const DistanceRequest& request, const std::function<Status(DistanceTask&)>& method,
  DistanceOutput& output)
{
  const PreparedSurface& surface = context.Surface;
  if (surface.IsCloud() && request.WantVirtualSource)
  {
    return InvalidInput(
      "Virtual sources are directions on a surface and do not exist on a point cloud")
      .At("GenerateVirtualSource")
      .Fix("Turn off {GenerateVirtualSource}");
  }
  std::vector<GeodesicSource> located;
  DGG_RETURN_IF_ERROR(sources.Locate(context, tolerance, located, &output.Warnings));
  DistanceTask task{ {}, located };
  task.MaximumDistance = request.MaximumDistance;
  task.Arrays = request.Arrays;
  task.WantNearestSource = request.WantNearestSource || request.WantSourceOfPoints;
  task.WantVirtualSource = request.WantVirtualSource;
  task.MayBeSparse = surface.GetNumberOfMergedPoints() == 0 && !request.WantSourceOfPoints;
  const Status status = method(task);
  output.QualityWarning = task.QualityWarning;
  DGG_RETURN_IF_ERROR(status);
  DGG_RETURN_IF_ERROR(ReportTo(context.Progress, 1.0)); // the observer may still abort here
  output.IsReached = FindReached(surface, task);
  if (request.WantSourceOfPoints)
  {
    output.SourceOfPoints = GetNearestSources(surface, task, output.IsReached);
  }
  WriteDistances(surface, task, output.IsReached, request, output);
  return Status::Success();
}

//------------------------------------------------------------------------------
void WriteDistances(const PreparedSurface& surface, const DistanceResults& results,
  const std::vector<bool>& isReached, const DistanceRequest& request, Output& output)
{
  const DistanceNames& names = request.Names;
  const double unreachedValue = request.UnreachedValue;
  OutputArrays& arrays = output.PointData;
  PointArrayWriter writer{ surface, results, isReached, arrays };
  std::vector<bool> isPointReached = isReached;
  for (std::size_t i = 0; surface.GetNumberOfMergedPoints() > 0 && i < isReached.size(); ++i)
  {
    isPointReached[i] = isReached[surface.GetVertex(static_cast<Offset>(i))];
  }
  const double* const distances = writer.Add(names.Distance, 1, unreachedValue,
    [&](std::size_t i, std::size_t) { return results.Distances[i]; });
  output.PointScalars = names.Distance;
  AddMarks(names.Distance, unreachedValue, isPointReached, results.AreOthersUnreached, arrays);
  if (request.WantNearestSource)
  {
    writer.Add<std::int32_t>(
      names.Source, 1, NoId, [&](std::size_t i, std::size_t) { return results.NearestSource[i]; });
  }
  if (request.WantVirtualSource)
  {
    writer.Add(names.VirtualSource, 3, unreachedValue, [&](std::size_t i, std::size_t k) {
      const VirtualSource& source = results.VirtualSource[i];
      return k == 0 ? source.Offset : k == 1 ? source.Length : source.Angle;
    });
  }
  for (const VertexArray& array : results.Arrays)
  {
    writer.Add(array.Name, static_cast<int>(array.Components.size()), unreachedValue,
      [&](std::size_t i, std::size_t k) { return array.Components[k][i]; });
    if (array.Components.size() == 1) // can be read as distances
    {
      AddMarks(array.Name, unreachedValue, isPointReached, results.AreOthersUnreached, arrays);
    }
  }
  if (!results.Windows.IsEmpty())
  {
    StoredWindows(results.Windows, distances, isReached.size(), surface)
      .AddTo(names.Distance, output.FieldData);
  }
}

//------------------------------------------------------------------------------
std::string GetUnreachedName(const std::string& distances)
{
  return distances + ".Unreached";
}

//------------------------------------------------------------------------------
void AddDistances(const std::string& name, const std::vector<double>& distances,
  double unreachedValue, OutputArrays& arrays, bool areOthersUnreached)
{
  std::vector<bool> isReached(distances.size());
  std::transform(distances.begin(), distances.end(), isReached.begin(),
    [](double distance) { return distance < Infinity; });
  std::transform(distances.begin(), distances.end(), arrays.Add<double>(name, distances.size()),
    [=](double distance) { return distance < Infinity ? distance : unreachedValue; });
  AddMarks(name, unreachedValue, isReached, areOthersUnreached, arrays);
}
}
