// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceAlgorithm.h"

#include "DGGDistanceInternals.h"
#include "DGGFieldInput.h"
#include "DGGOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGWindowArrays.h"

#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

vtkDGGDefineInputMacro(vtkGeodesicDistanceAlgorithm, Source, 1);

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
    vtkErrorMacro(<< "There are " << initialDistances.size() << " initial distances for "
                  << ids.size() << " source ids. Pass one per id; the sources are unchanged.");
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
  std::vector<std::pair<std::string, std::string>> names = { { "DistanceArrayName",
    this->Filter->DistanceArrayName } };
  if (this->Filter->GenerateNearestSource)
  {
    names.emplace_back("SourceArrayName", this->Filter->SourceArrayName);
  }
  if (this->Filter->GenerateVirtualSource)
  {
    names.emplace_back("VirtualSourceArrayName", this->Filter->VirtualSourceArrayName);
  }
  for (const dgg::VertexArray& array : this->DeclareArrays())
  {
    names.emplace_back(array.Property, array.Name);
  }
  return DGGCheckNames(names);
}

//------------------------------------------------------------------------------
DGGSourceSet DGGDistanceInternals::GetSources(vtkInformationVector** inputVector) const
{
  return { this->Filter->SourceIds, vtkPolyData::GetData(inputVector[1]), 1, "source", "SourceIds",
    this->Filter->InitialDistanceArrayName, &this->Filter->SourceOffsets };
}

//------------------------------------------------------------------------------
dgg::Status DGGDistanceInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (context.Surface.IsCloud() && this->Filter->GenerateVirtualSource)
  {
    return dgg::InvalidInput(
      "Virtual sources are directions on a surface and do not exist on a point cloud")
      .At("GenerateVirtualSource")
      .Fix("Turn off {GenerateVirtualSource}");
  }
  std::vector<dgg::GeodesicSource> sources;
  const DGGSourceSet set = this->GetSources(inputVector);
  DGG_RETURN_IF_ERROR(
    DGGLocate(context, set, this->Filter->ProjectionTolerance, sources, this->Filter));

  DGGDistanceTask task{ { {}, sources }, context };
  task.MaximumDistance =
    this->Filter->MaximumDistance < VTK_DOUBLE_MAX ? this->Filter->MaximumDistance : dgg::Infinity;
  task.Arrays = this->DeclareArrays();
  task.WantNearestSource = this->Filter->GenerateNearestSource || this->Filter->PassSourceArrays;
  task.WantVirtualSource = this->Filter->GenerateVirtualSource;
  task.MayBeSparse =
    context.Surface.GetNumberOfMergedPoints() == 0 && !this->Filter->PassSourceArrays;
  DGG_RETURN_IF_ERROR(this->ComputeDistances(task));
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, 1.0)); // the observer may still abort here
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  const std::vector<bool> isReached = dgg::FindReached(context.Surface, task);
  if (this->Filter->PassSourceArrays) // before the results, which replace arrays of the same name
  {
    DGGPassArrays(
      set, dgg::GetNearestSources(context.Surface, task, isReached), output->GetPointData());
  }
  this->AddResults(task, isReached, output);
  this->WarnAboutGaps(isReached);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGDistanceTask task{ { {}, {} }, context };
  task.Arrays = this->DeclareArrays();
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  this->AddResults(task, dgg::FindReached(context.Surface, task), output);
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::AddResults(
  const DGGDistanceTask& task, const std::vector<bool>& isReached, vtkPolyData* output) const
{
  const dgg::PreparedSurface& surface = task.Context.Surface;
  const std::string& name = this->Filter->DistanceArrayName;
  const dgg::DistanceNames names{ name,
    this->Filter->GenerateNearestSource ? this->Filter->SourceArrayName : "",
    this->Filter->GenerateVirtualSource ? this->Filter->VirtualSourceArrayName : "" };
  vtkPointData* data = output->GetPointData();
  if (data->HasArray(name.c_str()))
  {
    // Such arrays of the input belong to the distances that are replaced below.
    data->RemoveArray(this->Filter->SourceArrayName.c_str());
    data->RemoveArray(this->Filter->VirtualSourceArrayName.c_str());
  }
  DGGRemoveDistances(output, name);
  for (const dgg::VertexArray& array : task.Arrays)
  {
    DGGRemoveDistances(output, array.Name); // such arrays can be read as distances
  }
  dgg::OutputArrays arrays;
  dgg::WriteDistances(surface, task, isReached, names, this->Filter->UnreachedValue, arrays);
  DGGAddArrays(arrays, data);
  data->SetActiveScalars(name.c_str()); // SetScalars() would remove the scalars of the input
  if (!task.Windows.IsEmpty())
  {
    DGGWindowArrays::AddTo(output->GetFieldData(),
      vtkDoubleArray::SafeDownCast(data->GetArray(name.c_str())), surface, task.Windows);
  }
}
