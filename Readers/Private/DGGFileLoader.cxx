// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGFileLoader.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <locale>
#include <system_error>

bool vtkDGG::RunOnFile(vtkAlgorithm* algorithm, const char* verb, const char* fileName,
  const std::function<void(const FileProgress&)>& work, unsigned long& code)
{
  if (!fileName || !fileName[0])
  {
    code = vtkErrorCode::NoFileNameError;
    vtkErrorWithObjectMacro(algorithm, "There is no file name: call SetFileName() first.");
    return false;
  }
  algorithm->SetAbortExecute(0); // of an earlier run: VTK 9.1 would do so, later ones do not
  std::string message;
  try
  {
    work([algorithm](double done) {
      algorithm->UpdateProgress(done);
      if (algorithm->GetAbortExecute() != 0)
      {
        Fail(vtkErrorCode::NoError, "aborted");
      }
    });
    code = vtkErrorCode::NoError;
    return true;
  }
  catch (const FileError& error)
  {
    code = error.Code;
    message = error.what();
  }
  catch (const std::exception& exception) // out of memory
  {
    code = vtkErrorCode::UnknownError;
    message = exception.what();
  }
  if (code != vtkErrorCode::NoError)
  {
    vtkErrorWithObjectMacro(algorithm, "Cannot " << verb << " " << fileName << ": " << message);
  }
  return false;
}

unsigned long vtkDGG::ReadFile(vtkAlgorithm* reader, const char* fileName,
  vtkInformationVector* outputVector,
  void (*read)(std::string_view file, const FileProgress& progress, vtkPolyData* output))
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto work = [&](const FileProgress& progress) {
    const std::vector<char> bytes = LoadFile(fileName, SIZE_MAX);
    const FileProgress most = [&progress](double done) { progress(0.9 * done); };
    read({ bytes.data(), bytes.size() }, most, output);
    most(1.0);
    reader->UpdateProgress(1.0);
  };
  unsigned long code = vtkErrorCode::NoError;
  if (!RunOnFile(reader, "read", fileName, work, code))
  {
    output->Initialize();
    outputVector->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
  return code;
}

bool vtkDGG::GoesOn(unsigned long errorCode, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  auto* pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  return errorCode == vtkErrorCode::NoError || (outInfo->Has(pieces) && outInfo->Get(pieces) > 1);
}

std::vector<char> vtkDGG::LoadFile(const char* name, std::size_t limit)
{
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(name, code);
  if (!fs::exists(status))
  {
    Fail(vtkErrorCode::FileNotFoundError, "the file does not exist");
  }
  if (!fs::is_regular_file(status))
  {
    Fail(vtkErrorCode::CannotOpenFileError,
      fs::is_directory(status) ? "it is a folder" : "it is not an ordinary file");
  }
  std::ifstream file(name, std::ios::binary);
  const std::uintmax_t size = fs::file_size(name, code);
  if (!file || code)
  {
    Fail(vtkErrorCode::CannotOpenFileError, "the file cannot be opened");
  }
  std::vector<char> bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, limit)));
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    Fail(vtkErrorCode::PrematureEndOfFileError, "the file cannot be read to its end");
  }
  return bytes;
}

std::string vtkDGG::Quote(std::string_view text)
{
  constexpr std::size_t longest = 32;
  std::string shown(text.substr(0, longest));
  std::replace_if(
    shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}

bool vtkDGG::IsTooSmall(std::string_view text)
{
  std::istringstream stream{ std::string(text) };
  stream.imbue(std::locale::classic());
  double number = 0.0; // the nearest one that there is
  stream >> number;
  return std::abs(number) < 1.0;
}
