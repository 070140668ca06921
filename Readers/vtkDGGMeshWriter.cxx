// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMeshWriter.h"

#include "DGGCompatibility.h"
#include "DGGMeshConversion.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string>

vtkStandardNewMacro(vtkDGGMeshWriter);

vtkDGGMeshWriter::~vtkDGGMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkDGGMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

vtkPolyData* vtkDGGMeshWriter::GetInput()
{
  return this->GetInput(0);
}

vtkPolyData* vtkDGGMeshWriter::GetInput(int port)
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput(port));
}

int vtkDGGMeshWriter::Write()
{
  this->IsWritten = false;
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Superclass::Write();
  if (!this->IsWritten && this->GetErrorCode() == vtkErrorCode::NoError &&
    !vtkDGGIsAbortedMacro(this))
  {
    // The superclass does not report the failure of a reader or filter upstream.
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
  return this->IsWritten ? 1 : 0;
}

int vtkDGGMeshWriter::FindFormat() const
{
  // Extensions in the order of dgg::FileFormat.
  const char* const extensions[] = { ".obj", ".off", ".pcd", ".ply", ".stl", ".xyz" };
  std::string extension = std::filesystem::path(this->FileName).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::find(std::begin(extensions), std::end(extensions), extension);
  return found == std::end(extensions) ? -1 : static_cast<int>(found - std::begin(extensions));
}

void vtkDGGMeshWriter::WarnOfArrays(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    name = name ? name : "(without a name)";
    if (!data->GetArray(i))
    {
      vtkWarningMacro("The array " << name << " is skipped: its values are not numeric.");
    }
  }
}

void vtkDGGMeshWriter::WriteData()
{
  const auto work = [this](const dgg::FileProgress& progress) -> dgg::FileStatus {
    const int found = this->FindFormat();
    if (found < 0)
    {
      return { dgg::FileStatus::Code::Unrecognized,
        "the extension is unknown. Expected .obj, .off, .pcd, .ply, .stl or .xyz." };
    }
    const auto format = static_cast<dgg::FileFormat>(found);
    vtkPolyData* input = this->GetInput();
    if (format != dgg::FileFormat::OBJ && format != dgg::FileFormat::OFF &&
      format != dgg::FileFormat::STL && format != dgg::FileFormat::XYZ)
    {
      this->WarnOfArrays(input->GetPointData());
    }
    if (format == dgg::FileFormat::PLY)
    {
      this->WarnOfArrays(input->GetCellData());
    }
    dgg::MeshData mesh = vtkDGG::FromPolyData(input);
    const dgg::FileStatus status = dgg::WriteMesh(format, this->FileName, mesh, progress);
    for (const std::string& warning : mesh.Warnings)
    {
      vtkWarningMacro(<< warning);
    }
    this->IsWritten = status.IsOk();
    return status;
  };
  this->SetErrorCode(vtkDGG::RunOnFile(this, "write", this->FileName, work));
}

void vtkDGGMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
