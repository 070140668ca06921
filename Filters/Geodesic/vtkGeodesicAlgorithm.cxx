// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGMeshAdapter.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cstring>
#include <sstream>

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::vtkGeodesicAlgorithm()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::~vtkGeodesicAlgorithm()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkGeodesicAlgorithm, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GatherLimit: " << this->GatherLimit << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "MeshBuildTime: " << this->GetMeshBuildTime() << "\n";
  os << indent << "MeshReport:\n";
  std::istringstream report(this->GetMeshReport());
  for (std::string line; std::getline(report, line);)
  {
    os << indent.GetNextIndent() << line << "\n";
  }
}

//------------------------------------------------------------------------------
std::string vtkGeodesicAlgorithm::GetMeshReport() const
{
  const dgg::PreparedSurface& surface = this->Internals->GetMesh().Get();
  if (surface.GetMeshWithoutAngles().GetNumberOfFaces() == 0)
  {
    return "no surface\n";
  }
  std::string text;
  for (const dgg::ReportItem& item : surface.ListReport())
  {
    text += std::string(item.Words) + ": " + item.Text + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
vtkTable* vtkGeodesicAlgorithm::GetMeshReportTable()
{
  vtkNew<vtkTable> table;
  for (const dgg::ReportItem& item : this->Internals->GetMesh().Get().ListReport())
  {
    DGGAddArray<vtkDoubleArray>(table->GetRowData(), item.Name, 1)->SetValue(0, item.Value);
  }
  this->Internals->ReportTable = table;
  return table;
}

//------------------------------------------------------------------------------
double vtkGeodesicAlgorithm::GetMeanAnisotropy() const
{
  return this->Internals->GetMesh().Get().GetMeanAnisotropy();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeodesicAlgorithm::GetMeshBuildTime() const
{
  return this->Internals->GetMesh().GetBuildTime();
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Port 0 is required but checked here: the check by the pipeline would keep an earlier output.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return port >= 0 && port < this->GetNumberOfInputPorts() ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == 0 && this->Internals->PassesSurface() ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGeodesicAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) &&
    this->Internals->PassesSurface())
  {
    this->MakeSurfaceOutput(
      vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
/// Makes an output of the type of a composite input, otherwise a vtkPolyData.
void vtkGeodesicAlgorithm::MakeSurfaceOutput(vtkDataObject* input, vtkInformation* outInfo) const
{
  const char* type =
    vtkCompositeDataSet::SafeDownCast(input) ? input->GetClassName() : "vtkPolyData";
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  if (!output || std::strcmp(output->GetClassName(), type) != 0)
  {
    outInfo->Set(vtkDataObject::DATA_OBJECT(),
      vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type)));
  }
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internals->Update(request, inputVector, outputVector);
  return 1; // filters downstream must run and become empty as well
}
