// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceAlgorithm.h"

#include "DGGDistanceInternals.h"
#include "DGGFieldInput.h"
#include "DGGOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

vtkDGGDefineInputMacro(vtkGeodesicDistanceAlgorithm, Source, 1);

//------------------------------------------------------------------------------
vtkGeodesicDistanceAlgorithm::vtkGeodesicDistanceAlgorithm()
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
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Filter->ProjectionTolerance } }));
  return this->MakeRequest().Check();
}

//------------------------------------------------------------------------------
DGGSourceSet DGGDistanceInternals::GetSources(vtkInformationVector** inputVector) const
{
  return { this->Filter->SourceIds, vtkPolyData::GetData(inputVector[1]), 1, "source", "SourceIds",
    this->Filter->InitialDistanceArrayName, &this->Filter->SourceOffsets };
}

//------------------------------------------------------------------------------
dgg::DistanceRequest DGGDistanceInternals::MakeRequest() const
{
  dgg::DistanceRequest request;
  request.MaximumDistance =
    this->Filter->MaximumDistance >= VTK_DOUBLE_MAX ? dgg::Infinity : this->Filter->MaximumDistance;
  request.UnreachedValue = this->Filter->UnreachedValue;
  request.WantNearestSource = this->Filter->GenerateNearestSource;
  request.WantVirtualSource = this->Filter->GenerateVirtualSource;
  request.WantSourceOfPoints = this->Filter->PassSourceArrays;
  request.Names = { this->Filter->DistanceArrayName, this->Filter->SourceArrayName,
    this->Filter->VirtualSourceArrayName };
  request.Arrays = this->DeclareArrays();
  return request;
}

//------------------------------------------------------------------------------
dgg::Status DGGDistanceInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const DGGSourceSet set = this->GetSources(inputVector);
  dgg::SourceCollection sources;
  DGG_RETURN_IF_ERROR(DGGCollect(set, sources));
  dgg::DistanceOutput results;
  const dgg::Status status = dgg::FindDistances(
    context, sources, this->Filter->ProjectionTolerance, this->MakeRequest(),
    [&](dgg::DistanceTask& task) { return this->ComputeDistances(context, task); }, results);
  this->Warn(results.Warnings);
  this->ReportQuality(results.QualityWarning);
  DGG_RETURN_IF_ERROR(status);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  if (this->Filter->PassSourceArrays) // before the results, which replace arrays of the same name
  {
    DGGPassArrays(set, results.SourceOfPoints, output->GetPointData());
  }
  this->AddResults(results, output);
  this->WarnAboutGaps(results.IsReached);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  const dgg::DistanceRequest request = this->MakeRequest();
  dgg::DistanceResults none;
  none.Arrays = request.Arrays;
  dgg::Output results;
  dgg::WriteDistances(context.Surface, none, {}, request, results);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  this->AddResults(results, output);
}

//------------------------------------------------------------------------------
void DGGDistanceInternals::AddResults(dgg::Output& results, vtkPolyData* output) const
{
  const std::string& name = this->Filter->DistanceArrayName;
  vtkPointData* data = output->GetPointData();
  if (data->HasArray(name.c_str()))
  {
    // Such arrays of the input belong to the distances that are replaced below.
    data->RemoveArray(this->Filter->SourceArrayName.c_str());
    data->RemoveArray(this->Filter->VirtualSourceArrayName.c_str());
  }
  DGGRemoveDistances(output, name);
  for (const dgg::VertexArray& array : this->DeclareArrays())
  {
    DGGRemoveDistances(output, array.Name); // such arrays can be read as distances
  }
  DGGAddArrays(results, output);
}
