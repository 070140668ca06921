// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceAlgorithm.h"

#include "DGGDistanceInternals.h"
#include "DGGMakeArray.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGUnreachedArray.h"
#include "DGGWindowArrays.h"

#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

vtkDGGDefineInputMacro(vtkGeodesicDistanceAlgorithm, Source, 1);

namespace
{
std::size_t GetNumberOfVertices(const DGGDistanceTask& task)
{
  return static_cast<std::size_t>(
    task.Context.Surface.GetMeshWithoutAngles().GetNumberOfVertices());
}

std::vector<bool> FindReached(const DGGDistanceTask& task)
{
  std::vector<bool> isReached(task.IsSparse ? GetNumberOfVertices(task) : task.Distances.size());
  for (std::size_t i = 0; i < task.Distances.size(); ++i)
  {
    const double distance = task.Distances[i];
    isReached[task.IsSparse ? task.Vertices[i] : i] =
      distance <= task.MaximumDistance && distance < dgg::Infinity;
  }
  return isReached;
}

/// Adds point arrays with the values of vertices.
struct PointArrayMaker
{
  const DGGDistanceTask& Task;
  const dgg::PreparedSurface& Surface;
  const std::vector<bool>& IsReached; // per vertex
  vtkIdType NumberOfPoints;

  /// `valueOf(i, k)` returns component k of the result at index i.
  template <typename ArrayType, typename ValueType, typename ValueOf>
  void Add(vtkPointData* data, const std::string& name, int count, ValueType unreached,
    const ValueOf& valueOf) const
  {
    const auto array = DGGAddArray<ArrayType>(data, name, this->NumberOfPoints, count);
    if (this->Task.IsSparse)
    {
      std::fill_n(array->GetPointer(0), array->GetNumberOfValues(), unreached);
      for (std::size_t i = 0; i < this->Task.Vertices.size(); ++i)
      {
        const dgg::Id vertex = this->Task.Vertices[i];
        for (int k = 0; k < count && this->IsReached[vertex]; ++k)
        {
          array->SetTypedComponent(vertex, k, valueOf(i, k));
        }
      }
      return;
    }
    for (vtkIdType i = 0; i < this->NumberOfPoints; ++i)
    {
      const dgg::Id vertex = this->Surface.GetVertex(i);
      for (int k = 0; k < count; ++k)
      {
        array->SetTypedComponent(i, k, this->IsReached[vertex] ? valueOf(vertex, k) : unreached);
      }
    }
  }
};
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceAlgorithm::vtkGeodesicDistanceAlgorithm()
  : ProjectionTolerance(0.01)
  , MaximumDistance(VTK_DOUBLE_MAX)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , GenerateNearestSource(false)
  , PassSourceArrays(false)
  , GenerateVirtualSource(false)
  , DistanceArrayName("GeodesicDistance")
  , SourceArrayName("GeodesicSource")
  , VirtualSourceArrayName("GeodesicVirtualSource")
  , InitialDistanceArrayName("InitialDistance")
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceIds:";
  for (std::size_t i = 0; i < this->SourceIds.size(); ++i)
  {
    os << " " << this->SourceIds[i];
    if (this->SourceOffsets[i] != 0.0)
    {
      os << " (from " << this->SourceOffsets[i] << ")";
    }
  }
  os << (this->SourceIds.empty() ? " (none)\n" : "\n");
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "GenerateNearestSource: " << (this->GenerateNearestSource ? "On" : "Off") << "\n";
  os << indent << "PassSourceArrays: " << (this->PassSourceArrays ? "On" : "Off") << "\n";
  os << indent << "GenerateVirtualSource: " << (this->GenerateVirtualSource ? "On" : "Off") << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "VirtualSourceArrayName: " << this->VirtualSourceArrayName << "\n";
  os << indent << "InitialDistanceArrayName: " << this->InitialDistanceArrayName << "\n";
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::AddSourceId(vtkIdType id, double initialDistance)
{
  this->SourceIds.push_back(id);
  this->SourceOffsets.push_back(initialDistance);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(vtkIdList* ids)
{
  this->SetSourceIds(
    ids ? std::vector<vtkIdType>(ids->begin(), ids->end()) : std::vector<vtkIdType>());
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(const std::vector<vtkIdType>& ids)
{
  this->SetSourceIds(ids, std::vector<double>(ids.size(), 0.0));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(
  const std::vector<vtkIdType>& ids, const std::vector<double>& initialDistances)
{
  if (ids.size() != initialDistances.size())
  {
    vtkErrorMacro(<< initialDistances.size() << " initial distances for " << ids.size()
                  << " source ids: expected one per id. The sources are unchanged.");
    return;
  }
  if (this->SourceIds != ids || this->SourceOffsets != initialDistances)
  {
    this->SourceIds = ids;
    this->SourceOffsets = initialDistances;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(std::initializer_list<vtkIdType> ids)
{
  this->SetSourceIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::RemoveAllSourceIds()
{
  this->SetSourceIds(std::vector<vtkIdType>());
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::RemoveAllSources()
{
  this->RemoveAllSourceIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfSourceIds() const
{
  return static_cast<vtkIdType>(this->SourceIds.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetSourceId(vtkIdType i) const
{
  return DGGGetId(this->SourceIds, i);
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceAlgorithm::GetSourceInitialDistance(vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfSourceIds() ? this->SourceOffsets[i] : 0.0;
}

//------------------------------------------------------------------------------
DGGDistanceInternals::DGGDistanceInternals(vtkGeodesicDistanceAlgorithm* filter)
  : DGGFilterInternals(filter)
  , Filter(filter)
{
}

//------------------------------------------------------------------------------
dgg::Status DGGDistanceInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGCheckLengths({ { "MaximumDistance", this->Filter->MaximumDistance },
    { "ProjectionTolerance", this->Filter->ProjectionTolerance } }));
  std::vector<DGGPointArray> arrays = this->DeclareArrays();
  if (this->Filter->GenerateVirtualSource)
  {
    arrays.insert(
      arrays.begin(), { this->Filter->VirtualSourceArrayName, "VirtualSourceArrayName", {} });
  }
  if (this->Filter->GenerateNearestSource)
  {
    arrays.insert(arrays.begin(), { this->Filter->SourceArrayName, "SourceArrayName", {} });
  }
  arrays.insert(arrays.begin(), { this->Filter->DistanceArrayName, "DistanceArrayName", {} });
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const DGGPointArray& array = arrays[i];
    if (array.Name.empty())
    {
      return dgg::Status::Invalid(
        array.Property + " is empty: call Set" + array.Property + "() with a name");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if (arrays[j].Name == array.Name)
      {
        return dgg::Status::Invalid(array.Property + " and " + arrays[j].Property + " are both '" +
          array.Name + "': call Set" + array.Property + "() with another name");
      }
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
DGGSourceSet DGGDistanceInternals::GetSources(vtkInformationVector** inputVector) const
{
  return { this->Filter->SourceIds, vtkPolyData::GetData(inputVector[1]), 1, "source",
    "call AddSourceId() or SetSourceIds()", this->Filter->InitialDistanceArrayName,
    &this->Filter->SourceOffsets };
}

//------------------------------------------------------------------------------
dgg::Status DGGDistanceInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (context.Surface.IsCloud() && this->Filter->GenerateVirtualSource)
  {
    return dgg::Status::Invalid("virtual sources are directions on a surface and do not exist on a "
                                "point cloud: turn GenerateVirtualSource off");
  }
  std::vector<dgg::GeodesicSource> sources;
  const DGGSourceSet set = this->GetSources(inputVector);
  DGG_RETURN_IF_ERROR(
    DGGLocate(context, set, this->Filter->ProjectionTolerance, sources, this->Filter));

  const double limit =
    this->Filter->MaximumDistance < VTK_DOUBLE_MAX ? this->Filter->MaximumDistance : dgg::Infinity;
  DGGDistanceTask task{ context, sources, limit,
    this->Filter->GenerateNearestSource || this->Filter->PassSourceArrays,
    this->Filter->GenerateVirtualSource, {}, {}, {}, {}, this->DeclareArrays() };
  task.MayBeSparse =
    context.Surface.GetNumberOfMergedPoints() == 0 && !this->Filter->PassSourceArrays;
  DGG_RETURN_IF_ERROR(this->ComputeDistances(task));
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, 1.0)); // the observer may still abort here
  const std::size_t n = task.IsSparse ? task.Vertices.size() : GetNumberOfVertices(task);
  bool complete = task.Distances.size() == n;
  complete &= !task.WantNearestSource || task.NearestSource.size() == n;
  complete &= !task.WantVirtualSource || task.VirtualSource.size() == n;
  for (const DGGPointArray& array : task.Arrays)
  {
    for (const std::vector<double>& component : array.Components)
    {
      complete &= component.size() == n;
    }
  }
  if (!complete)
  {
    return dgg::Status::Invalid("the results do not match the mesh: report this as a bug");
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  const std::vector<bool> isReached = FindReached(task);
  if (this->Filter->PassSourceArrays) // before the results, which replace arrays of the same name
  {
    std::vector<dgg::Id> nearest(static_cast<std::size_t>(output->GetNumberOfPoints()));
    for (std::size_t i = 0; i < nearest.size(); ++i)
    {
      const dgg::Id vertex = context.Surface.GetVertex(static_cast<vtkIdType>(i));
      nearest[i] = isReached[vertex] ? task.NearestSource[vertex] : dgg::NoId;
    }
    DGGPassArrays(set, nearest, output->GetPointData());
  }
  this->AddResults(task, isReached, output);
  this->WarnAboutGaps(isReached);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  const std::vector<dgg::GeodesicSource> sources;
  const DGGDistanceTask task{ context, sources, dgg::Infinity, this->Filter->GenerateNearestSource,
    this->Filter->GenerateVirtualSource, {}, {}, {}, {}, this->DeclareArrays() };
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  this->AddResults(task, FindReached(task), output);
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::AddResults(
  const DGGDistanceTask& task, const std::vector<bool>& isReached, vtkPolyData* output)
{
  vtkPointData* data = output->GetPointData();
  // Such arrays of the input belong to the distances that are replaced below.
  DGGWindowArrays::RemoveFrom(output->GetFieldData(), this->Filter->DistanceArrayName);
  DGGUnreachedArray::RemoveFrom(data, this->Filter->DistanceArrayName);
  if (data->HasArray(this->Filter->DistanceArrayName.c_str()))
  {
    data->RemoveArray(this->Filter->SourceArrayName.c_str());
    data->RemoveArray(this->Filter->VirtualSourceArrayName.c_str());
  }
  const PointArrayMaker maker{ task, task.Context.Surface, isReached, output->GetNumberOfPoints() };
  maker.Add<vtkDoubleArray>(data, this->Filter->DistanceArrayName, 1, this->Filter->UnreachedValue,
    [&](std::size_t i, int) { return task.Distances[i]; });
  // SetScalars() would remove the scalars of the input.
  data->SetActiveScalars(this->Filter->DistanceArrayName.c_str());
  std::vector<bool> isPointReached = isReached;
  isPointReached.resize(static_cast<std::size_t>(maker.NumberOfPoints));
  const bool areMerged = maker.Surface.GetNumberOfMergedPoints() > 0;
  for (std::size_t i = 0; areMerged && i < isPointReached.size(); ++i)
  {
    isPointReached[i] = isReached[maker.Surface.GetVertex(static_cast<vtkIdType>(i))];
  }
  DGGUnreachedArray::AddTo(
    data, this->Filter->DistanceArrayName, this->Filter->UnreachedValue, isPointReached);
  if (!task.Windows.IsEmpty())
  {
    DGGWindowArrays::AddTo(output->GetFieldData(),
      vtkDoubleArray::SafeDownCast(data->GetArray(this->Filter->DistanceArrayName.c_str())),
      maker.Surface, task.Windows);
  }
  if (this->Filter->GenerateNearestSource)
  {
    maker.Add<vtkIntArray>(data, this->Filter->SourceArrayName, 1, -1,
      [&](std::size_t i, int) { return task.NearestSource[i]; });
  }
  if (task.WantVirtualSource)
  {
    maker.Add<vtkDoubleArray>(data, this->Filter->VirtualSourceArrayName, 3,
      this->Filter->UnreachedValue, [&](std::size_t i, int k) {
        const dgg::VirtualSource& source = task.VirtualSource[i];
        return k == 0 ? source.Offset : k == 1 ? source.Length : source.Angle;
      });
  }
  for (const DGGPointArray& array : task.Arrays)
  {
    const int components = static_cast<int>(array.Components.size());
    maker.Add<vtkDoubleArray>(data, array.Name, components, this->Filter->UnreachedValue,
      [&](std::size_t i, int k) { return array.Components[k][i]; });
    // These arrays can be read as distances.
    DGGWindowArrays::RemoveFrom(output->GetFieldData(), array.Name);
    DGGUnreachedArray::RemoveFrom(data, array.Name);
    if (components == 1)
    {
      DGGUnreachedArray::AddTo(data, array.Name, this->Filter->UnreachedValue, isPointReached);
    }
  }
}
