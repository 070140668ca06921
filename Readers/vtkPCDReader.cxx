// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDReader.h"

#include "vtkDGGFileLoader.h"
#include "vtkDGGPCDBody.h"
#include "vtkDGGPCDHeader.h"
#include "vtkDGGPointFields.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace
{
/// Enough of a file to find the fields behind comments.
constexpr std::size_t HeaderRange = 16384;

/// Nothing on error, and when stopped by the callback (without an error).
vtkSmartPointer<vtkPolyData> ReadFile(
  const char* name, const vtkDGGFileProgress& progress, vtkDGGFileError& error)
{
  std::vector<char> bytes;
  vtkDGGPCDHeader header;
  if (!vtkDGGLoadFile(name, SIZE_MAX, bytes, error) ||
    !header.Parse(bytes.data(), bytes.data() + bytes.size(), error))
  {
    return nullptr;
  }
  vtkDGGPCDBody body(bytes.data(), bytes.data() + bytes.size(), header, progress);
  if (!body.Read())
  {
    error = body.GetError();
    return nullptr;
  }
  std::string trouble;
  vtkSmartPointer<vtkPolyData> cloud = vtkDGG::MakePolyData(body.GetView(), trouble);
  if (!cloud)
  {
    error = { vtkErrorCode::FileFormatError, trouble };
  }
  return cloud;
}
}

vtkStandardNewMacro(vtkPCDReader);

vtkPCDReader::vtkPCDReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkPCDReader::~vtkPCDReader()
{
  this->SetFileName(nullptr);
}

int vtkPCDReader::CanReadFile(const char* fileName)
{
  std::vector<char> bytes;
  vtkDGGFileError error;
  return fileName && vtkDGGLoadFile(fileName, HeaderRange, bytes, error) &&
    vtkDGGLooksLikePCD(bytes.data(), bytes.data() + bytes.size());
}

int vtkPCDReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !this->FileName[0])
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("There is no file name: call SetFileName() first.");
    return 0;
  }
  vtkDGGFileError error;
  try
  {
    const vtkDGGFileProgress progress = [this](double done) {
      this->UpdateProgress(0.9 * done);
      return this->GetAbortExecute() == 0;
    };
    if (vtkSmartPointer<vtkPolyData> cloud = ReadFile(this->FileName, progress, error))
    {
      output->ShallowCopy(cloud);
      this->UpdateProgress(1.0);
      return 1;
    }
  }
  catch (const std::exception& exception) // out of memory
  {
    error = { vtkErrorCode::UnknownError, exception.what() };
  }
  catch (...)
  {
    error = { vtkErrorCode::UnknownError, "unexpected failure" };
  }
  output->Initialize();
  if (error.Code == vtkErrorCode::NoError)
  {
    // Aborted: nothing to complain about, but an empty output does not count as up to date.
    outputVector->GetInformationObject(0)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    return 1;
  }
  this->SetErrorCode(error.Code);
  vtkErrorMacro("Cannot read " << this->FileName << ": " << error.Message);
  return 0;
}

void vtkPCDReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
