// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFileLoader.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

std::vector<char> vtkDGG::LoadFile(const char* name, std::size_t limit)
{
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(name, code);
  if (!fs::exists(status))
  {
    throw FileError(vtkErrorCode::FileNotFoundError, "the file does not exist");
  }
  if (!fs::is_regular_file(status))
  {
    throw FileError(vtkErrorCode::CannotOpenFileError,
      fs::is_directory(status) ? "it is a folder" : "it is not an ordinary file");
  }
  std::ifstream file(name, std::ios::binary);
  if (!file)
  {
    throw FileError(vtkErrorCode::CannotOpenFileError, "the file cannot be opened");
  }
  const std::uintmax_t size = fs::file_size(name, code);
  if (code)
  {
    throw FileError(vtkErrorCode::CannotOpenFileError, "the size of the file is not known");
  }
  std::vector<char> bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, limit)));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(file.gcount()) != bytes.size())
  {
    throw FileError(vtkErrorCode::PrematureEndOfFileError, "the file cannot be read to its end");
  }
  return bytes;
}

int vtkDGG::ReadFile(vtkAlgorithm* reader, const char* fileName, vtkInformationVector* outputVector,
  const std::function<void(
    const std::vector<char>& bytes, const FileProgress& progress, vtkPolyData* output)>& read,
  unsigned long& code)
{
  code = vtkErrorCode::NoError;
  if (!fileName || !fileName[0])
  {
    code = vtkErrorCode::NoFileNameError;
    vtkErrorWithObjectMacro(reader, "There is no file name: call SetFileName() first.");
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const FileProgress progress = [reader](double done) {
    reader->UpdateProgress(0.9 * done);
    if (reader->GetAbortExecute() != 0)
    {
      throw FileError(vtkErrorCode::NoError, "aborted");
    }
  };
  std::string message;
  try
  {
    read(LoadFile(fileName, SIZE_MAX), progress, output);
    progress(1.0);
    reader->UpdateProgress(1.0);
    return 1;
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
  output->Initialize();
  if (code == vtkErrorCode::NoError)
  {
    outputVector->GetInformationObject(0)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    return 1;
  }
  vtkErrorWithObjectMacro(reader, "Cannot read " << fileName << ": " << message);
  return 0;
}

std::string vtkDGG::Quote(const char* first, const char* last)
{
  constexpr std::ptrdiff_t longest = 32;
  std::string text(first, first + std::min(last - first, longest));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (last - first > longest ? "...'" : "'");
}

std::string vtkDGG::Quote(const std::string& text)
{
  return Quote(text.data(), text.data() + text.size());
}

const char* vtkDGG::SkipByteOrderMark(const char* begin, const char* end)
{
  const std::string_view mark = "\xEF\xBB\xBF";
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  return text.substr(0, mark.size()) == mark ? begin + mark.size() : begin;
}

bool vtkDGG::IsTooSmall(const char* first, const char* last)
{
  // By the power of ten of the first digit.
  const std::string text(first, last);
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), end);
  const std::size_t digit = std::min(text.find_first_of("123456789"), end);
  double power = static_cast<double>(point) - static_cast<double>(digit);
  if (end < text.size())
  {
    power += std::strtod(text.c_str() + end + 1, nullptr); // digits and a sign, however many
  }
  return power < 0.0;
}
