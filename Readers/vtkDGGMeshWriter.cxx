// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMeshWriter.h"

#include "DGGCompatibility.h"
#include "DGGMeshConversion.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string>

namespace
{
/// Returns true if double does not hold all integers of the array exactly.
bool HasLargeIntegers(vtkDataArray* array)
{
  const bool isWide = array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE;
  for (int c = 0; isWide && c < array->GetNumberOfComponents(); ++c)
  {
    const double* range = array->GetRange(c);
    if (std::max(-range[0], range[1]) >= 9007199254740992.0)
    {
      return true;
    }
  }
  return false;
}

bool HasTrianglesOnly(const dgg::CellList& polygons)
{
  std::int64_t corners = 0;
  return std::all_of(
    polygons.Offsets.begin(), polygons.Offsets.end(), [&corners](std::int64_t end) {
      const bool isNext = end == corners;
      corners += 3;
      return isNext;
    });
}
}

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

void vtkDGGMeshWriter::WarnOfArrays(vtkFieldData* data, bool isPLY)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    name = name ? name : "(without a name)";
    vtkDataArray* array = data->GetArray(i);
    if (!array)
    {
      vtkWarningMacro("The array " << name << " is skipped: its values are not numeric.");
    }
    else if (isPLY && HasLargeIntegers(array))
    {
      vtkWarningMacro(
        "The array " << name << " has integers of 2^53 or more, which a PLY file rounds.");
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
      this->WarnOfArrays(input->GetPointData(), format == dgg::FileFormat::PLY);
    }
    if (format == dgg::FileFormat::PLY)
    {
      this->WarnOfArrays(input->GetCellData(), true);
    }
    dgg::MeshData mesh;
    dgg::FileStatus status = vtkDGG::FromPolyData(input, mesh);
    if (status.IsOk() && format == dgg::FileFormat::STL && !HasTrianglesOnly(mesh.Polygons))
    {
      vtkNew<vtkTriangleFilter> triangulate;
      triangulate->PassVertsOff();
      triangulate->PassLinesOff();
      triangulate->SetInputData(input);
      triangulate->Update();
      mesh = dgg::MeshData();
      status = vtkDGG::FromPolyData(triangulate->GetOutput(), mesh);
    }
    if (status.IsOk())
    {
      status = dgg::WriteMesh(format, this->FileName, std::move(mesh), progress);
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
