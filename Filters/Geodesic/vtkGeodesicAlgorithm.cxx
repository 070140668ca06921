// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "DGGFilterInternals.h"
#include "DGGMeshAdapter.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <cstring>
#include <sstream>

namespace
{
void WriteReport(std::ostream& os, const dgg::PreparedSurface& mesh)
{
  const dgg::MeshReport& report = mesh.GetReport();
  os << "points: " << report.Vertices << "\n";
  os << "triangles: " << report.Faces << "\n";
  os << "components: " << report.Components << "\n";
  os << "boundary loops: " << report.BoundaryLoops << "\n";
  os << "boundary edges: " << report.BoundaryEdges << "\n";
  os << "orientable: " << (report.Orientable ? "yes" : "no") << "\n";
  os << "genus: ";
  if (report.Genus < 0)
  {
    os << "undefined\n";
  }
  else
  {
    os << report.Genus << "\n";
  }
  os << "non-manifold edges: " << report.NonManifoldEdges << "\n";
  os << "non-manifold vertices: " << report.NonManifoldVertices << "\n";
  os << "dropped faces: " << mesh.GetNumberOfDroppedCells() << "\n";
  os << "degenerate faces: " << report.DegenerateFaces << "\n";
  os << "duplicate faces: " << report.DuplicateFaces << "\n";
  os << "isolated points: " << mesh.GetNumberOfIsolatedPoints() << "\n";
  os << "coincident points: " << report.CoincidentPoints << "\n";
  os << "merged points: " << mesh.GetNumberOfMergedPoints() << "\n";
  os << "length added to degenerate faces: " << report.Mollification << "\n";
  os << "height of degenerate faces left out: " << mesh.GetLargestCapHeight() << "\n";
  os << "anisotropy: mean " << report.MeanAnisotropy << ", median " << report.MedianAnisotropy
     << "\n";
}
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::vtkGeodesicAlgorithm()
  : MemoryLimit(0)
  , MergeCoincidentPoints(false)
  , MergeTolerance(0.0)
  , OutputPointsPrecision(DOUBLE_PRECISION)
  , Controller(nullptr)
  , GatherLimit(100000000)
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
  if (this->GetNumberOfTriangles() == 0)
  {
    return "no surface\n";
  }
  std::ostringstream os;
  WriteReport(os, this->Internals->GetMesh().Get());
  return os.str();
}

//------------------------------------------------------------------------------
#define vtkDGGReportMacro(Type, Name, Value)       \
  Type vtkGeodesicAlgorithm::Get##Name() const     \
  {                                                \
    return this->Internals->GetMesh().Get().Value; \
  }
vtkDGGReportMacro(vtkIdType, NumberOfTriangles, GetMeshWithoutAngles().GetNumberOfFaces());
vtkDGGReportMacro(vtkIdType, NumberOfIsolatedPoints, GetNumberOfIsolatedPoints());
vtkDGGReportMacro(vtkIdType, NumberOfComponents, GetReport().Components);
vtkDGGReportMacro(vtkIdType, NumberOfBoundaryEdges, GetReport().BoundaryEdges);
vtkDGGReportMacro(vtkIdType, NumberOfBoundaryLoops, GetReport().BoundaryLoops);
vtkDGGReportMacro(vtkIdType, NumberOfNonManifoldEdges, GetReport().NonManifoldEdges);
vtkDGGReportMacro(vtkIdType, NumberOfNonManifoldVertices, GetReport().NonManifoldVertices);
vtkDGGReportMacro(vtkIdType, NumberOfDroppedFaces, GetNumberOfDroppedCells());
vtkDGGReportMacro(vtkIdType, NumberOfDegenerateFaces, GetReport().DegenerateFaces);
vtkDGGReportMacro(vtkIdType, NumberOfDuplicateFaces, GetReport().DuplicateFaces);
vtkDGGReportMacro(vtkIdType, NumberOfCoincidentPoints, GetReport().CoincidentPoints);
vtkDGGReportMacro(
  vtkIdType, NumberOfCoincidentBoundaryPoints, GetNumberOfCoincidentBoundaryPoints());
vtkDGGReportMacro(bool, Orientable, GetReport().Orientable);
vtkDGGReportMacro(vtkIdType, Genus, GetReport().Genus);
vtkDGGReportMacro(double, MeanAnisotropy, GetAnisotropy().Mean);
vtkDGGReportMacro(double, MedianAnisotropy, GetAnisotropy().Median);
vtkDGGReportMacro(double, Mollification, GetReport().Mollification);
vtkDGGReportMacro(double, LargestCapHeight, GetLargestCapHeight());
#undef vtkDGGReportMacro

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
