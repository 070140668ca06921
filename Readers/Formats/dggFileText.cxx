// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFileText.h"

#include <zlib.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <memory>
#include <system_error>

namespace
{
/// Largest number of bytes per decompression step
constexpr std::size_t BlockBytes = std::size_t(1) << 20;

/// Returns the first bytes of a file compressed by gzip.
std::vector<char> Decompress(const std::string& name, std::size_t limit)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(name.c_str(), "rb"), gzclose);
  if (!file)
  {
    dgg::Fail(dgg::FileCode::CannotOpen, "the file cannot be opened");
  }
  std::vector<char> bytes;
  // An error follows a short read. Since zlib 1.3.2, the next read would clear it.
  int count = 0;
  int wanted = 0;
  do
  {
    const std::size_t begin = bytes.size();
    wanted = static_cast<int>(std::min(BlockBytes, limit - begin));
    bytes.resize(begin + static_cast<std::size_t>(wanted));
    count = gzread(file.get(), bytes.data() + begin, static_cast<unsigned>(wanted));
    bytes.resize(begin + static_cast<std::size_t>(std::max(count, 0)));
  } while (count == wanted && bytes.size() < limit);
  int error = Z_OK;
  const char* message = gzerror(file.get(), &error);
  if (count < 0 || error != Z_OK)
  {
    const bool isCut = error == Z_BUF_ERROR;
    const std::string prefix = name + ": "; // callers add the name of the file
    message += std::string_view(message).substr(0, prefix.size()) == prefix ? prefix.size() : 0;
    dgg::Fail(isCut ? dgg::FileCode::Premature : dgg::FileCode::Malformed,
      "the file cannot be decompressed: ", isCut ? "the compressed data end too early" : message);
  }
  return bytes;
}
}

std::vector<char> dgg::LoadFile(const std::string& name, std::size_t limit)
{
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(name, code);
  if (!fs::exists(status))
  {
    Fail(FileCode::NotFound, "the file does not exist");
  }
  if (!fs::is_regular_file(status))
  {
    Fail(FileCode::CannotOpen,
      fs::is_directory(status) ? "it is a folder" : "it is not an ordinary file");
  }
  std::ifstream file(name, std::ios::binary);
  const std::uintmax_t size = fs::file_size(name, code);
  if (!file || code)
  {
    Fail(FileCode::CannotOpen, "the file cannot be opened");
  }
  if (file.get() == 0x1f && file.get() == 0x8b)
  {
    return Decompress(name, limit);
  }
  file.clear();
  file.seekg(0);
  std::vector<char> bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, limit)));
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    Fail(FileCode::Premature, "the file cannot be read to its end");
  }
  return bytes;
}

std::string dgg::Quote(std::string_view text)
{
  constexpr std::size_t longest = 32;
  std::string shown(text.substr(0, longest));
  std::replace_if(
    shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}

#if !defined(__cpp_lib_to_chars)
namespace
{
/// Converts the text with strtof_l() or strtod_l().
template <typename Number>
std::from_chars_result Convert(const char* first, const char* last, Number& number,
  Number (*convert)(const char*, char**, locale_t))
{
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text(first, last);
  const bool isNumber = !text.empty() && std::isspace(static_cast<unsigned char>(text[0])) == 0 &&
    text[0] != '+' && text.find_first_of("xX") == std::string::npos;
  char* end = nullptr;
  errno = 0;
  const Number found = convert(text.c_str(), &end, locale);
  if (!isNumber || end == text.c_str())
  {
    return { first, std::errc::invalid_argument };
  }
  const bool isOutOfRange = errno == ERANGE && (std::isinf(found) || found == 0);
  number = isOutOfRange ? number : found;
  return { first + (end - text.c_str()),
    isOutOfRange ? std::errc::result_out_of_range : std::errc() };
}
}

std::from_chars_result dgg::FromChars(const char* first, const char* last, float& number)
{
  return Convert(first, last, number, strtof_l);
}

std::from_chars_result dgg::FromChars(const char* first, const char* last, double& number)
{
  return Convert(first, last, number, strtod_l);
}
#endif

bool dgg::IsTooSmall(std::string_view text)
{
  std::istringstream stream{ std::string(text) };
  stream.imbue(std::locale::classic());
  double number = 0.0; // zero after underflow, the largest double after overflow
  stream >> number;
  return std::abs(number) < 1.0;
}
