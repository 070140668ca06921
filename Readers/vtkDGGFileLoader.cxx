// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFileLoader.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <cstdint>
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
