// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMeshReader.h"

#include "DGGCompatibility.h"
#include "DGGMeshConversion.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkDGGMeshReader::vtkDGGMeshReader(int format)
  : Format(format)
{
}

int vtkDGGMeshReader::CanReadFile(const char* fileName, int format)
{
  return dgg::LooksLike(static_cast<dgg::FileFormat>(format), fileName ? fileName : "") ? 1 : 0;
}

int vtkDGGMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto work = [&](const dgg::FileProgress& progress) {
    dgg::MeshData mesh;
    dgg::FileStatus status = dgg::ReadMesh(
      static_cast<dgg::FileFormat>(this->Format), this->FileName,
      [&progress](double done) { return progress(0.9 * done); }, mesh);
    for (const std::string& warning : mesh.Warnings)
    {
      vtkWarningMacro(<< this->FileName << ": " << warning);
    }
    if (status.IsOk() && !progress(0.9))
    {
      status.Kind = dgg::FileStatus::Code::Aborted;
    }
    if (status.IsOk())
    {
      vtkDGG::ToPolyData(std::move(mesh), output);
    }
    return status;
  };
  this->SetErrorCode(vtkDGG::RunOnFile(this, "read", this->FileName, work));
  if (this->ErrorCode == vtkErrorCode::NoError && !vtkDGGIsAbortedMacro(this))
  {
    this->UpdateProgress(1.0);
    return 1;
  }
  output->Initialize();
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  outInfo->Set(vtkStreamingDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  // Filters downstream run only after success, except on several processes: there the filters of
  // the other processes would wait for this one.
  auto* pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  return this->ErrorCode == vtkErrorCode::NoError ||
      (outInfo->Has(pieces) && outInfo->Get(pieces) > 1)
    ? 1
    : 0;
}
