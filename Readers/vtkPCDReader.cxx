// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDReader.h"

#include "vtkDGGFileLoader.h"
#include "vtkDGGPCDBody.h"
#include "vtkDGGPCDHeader.h"
#include "vtkDGGPointFields.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
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
  const vtkDGGFileProgress progress = [this](double done) {
    this->UpdateProgress(0.9 * done);
    return this->GetAbortExecute() == 0;
  };
  const auto read = [&](vtkPolyData* output, vtkDGGFileError& error) {
    const vtkSmartPointer<vtkPolyData> cloud = ReadFile(this->FileName, progress, error);
    if (cloud)
    {
      if (!progress(1.0)) // the last look: what follows takes no time
      {
        return false;
      }
      output->ShallowCopy(cloud);
      this->UpdateProgress(1.0);
    }
    return cloud != nullptr;
  };
  vtkDGGFileError error;
  const int done = vtkDGGReadFile(this->FileName, outputVector, read, error);
  this->SetErrorCode(error.Code);
  if (error.Code != vtkErrorCode::NoError)
  {
    vtkErrorMacro(<< error.Message);
  }
  return done;
}

void vtkPCDReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
