// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the readers of files share: bytes, errors, progress, numbers in text. Internal.
///
/// The readers are our own because the file library of PCL, pcl_io, links a VTK of its own, which
/// would be a second one in the process of ParaView, and because PCL allocates what a header
/// promises.
#ifndef vtkDGGFileLoader_h
#define vtkDGGFileLoader_h

#include <charconv>    // for std::from_chars
#include <cstddef>     // for std::size_t
#include <functional>  // for callbacks
#include <stdexcept>   // for the error
#include <string>      // for messages
#include <type_traits> // for integers
#include <vector>      // for the bytes

class vtkAlgorithm;
class vtkInformationVector;
class vtkPolyData;

namespace vtkDGG
{
/// Thrown by what reads or writes a file, and caught before it gets out of a filter.
struct FileError : std::runtime_error
{
  FileError(unsigned long code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }
  unsigned long Code; ///< of vtkErrorCode; NoError when the user has aborted
};

/// Reports the finished fraction now and then. Throws when the user has aborted.
using FileProgress = std::function<void(double)>;

/// The first bytes of a file, at most `limit`. Throws.
std::vector<char> LoadFile(const char* name, std::size_t limit);

/// Load a file for a reader and let `read` turn it into the output. Errors are reported; the output
/// is empty then, and when the user has aborted it does not count as up to date. Returns what
/// RequestData() returns, and in `code` the error code.
int ReadFile(vtkAlgorithm* reader, const char* fileName, vtkInformationVector* outputVector,
  const std::function<void(
    const std::vector<char>& bytes, const FileProgress& progress, vtkPolyData* output)>& read,
  unsigned long& code);

/// A part of a file as it can be shown in a message: quoted, not too long, and printable.
std::string Quote(const char* first, const char* last);
std::string Quote(const std::string& text);

/// Blanks within a line.
inline bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Behind the byte order mark that some editors put before texts in UTF-8.
const char* SkipByteOrderMark(const char* begin, const char* end);

/// Whether a number that std::from_chars finds out of range is too small, not too large.
bool IsTooSmall(const char* first, const char* last);

enum class NumberText
{
  Valid,
  Malformed,
  OutOfRange
};

/// The number that [first, last) says, in any locale. A float that is too small is zero.
template <typename Number>
NumberText ParseNumber(const char* first, const char* last, Number& number)
{
  if (last - first > 1 && first[0] == '+' && first[1] != '-')
  {
    ++first; // std::from_chars does not know a leading plus
  }
  const auto parsed = std::from_chars(first, last, number);
  if (parsed.ptr != last || parsed.ec == std::errc::invalid_argument)
  {
    return NumberText::Malformed;
  }
  if (parsed.ec == std::errc::result_out_of_range)
  {
    if (std::is_integral<Number>::value || !IsTooSmall(first, last))
    {
      return NumberText::OutOfRange;
    }
    number = 0;
  }
  return NumberText::Valid;
}
}

#endif
// VTK-HeaderTest-Exclude: vtkDGGFileLoader.h
