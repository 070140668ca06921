// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFileLoader.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <system_error>

bool vtkDGGLoadFile(
  const char* name, std::size_t limit, std::vector<char>& bytes, vtkDGGFileError& error)
{
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(name, code);
  if (!fs::exists(status))
  {
    error = { vtkErrorCode::FileNotFoundError, "the file does not exist" };
    return false;
  }
  if (fs::is_directory(status))
  {
    error = { vtkErrorCode::CannotOpenFileError, "it is a folder" };
    return false;
  }
  if (!fs::is_regular_file(status))
  {
    error = { vtkErrorCode::CannotOpenFileError, "it is not an ordinary file" };
    return false;
  }
  std::ifstream file(name, std::ios::binary);
  if (!file)
  {
    error = { vtkErrorCode::CannotOpenFileError, "the file cannot be opened" };
    return false;
  }
  const std::uintmax_t size = fs::file_size(name, code);
  if (code)
  {
    error = { vtkErrorCode::CannotOpenFileError, "the size of the file is not known" };
    return false;
  }
  bytes.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(size, limit)));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(file.gcount()) != bytes.size())
  {
    error = { vtkErrorCode::PrematureEndOfFileError, "the file cannot be read to its end" };
    return false;
  }
  return true;
}

int vtkDGGReadFile(const char* fileName, vtkInformationVector* outputVector,
  const std::function<bool(vtkPolyData* output, vtkDGGFileError& error)>& read,
  vtkDGGFileError& error)
{
  error = vtkDGGFileError();
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!fileName || !fileName[0])
  {
    error = { vtkErrorCode::NoFileNameError, "There is no file name: call SetFileName() first." };
    return 0;
  }
  try
  {
    if (read(output, error))
    {
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
  error.Message = std::string("Cannot read ") + fileName + ": " + error.Message;
  return 0;
}

std::string vtkDGGQuote(const char* first, const char* last)
{
  constexpr std::ptrdiff_t longest = 32;
  std::string text(first, first + std::min(last - first, longest));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (last - first > longest ? "...'" : "'");
}

std::string vtkDGGQuote(const std::string& text)
{
  return vtkDGGQuote(text.data(), text.data() + text.size());
}
