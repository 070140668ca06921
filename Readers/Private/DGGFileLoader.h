// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the readers and writers share: bytes, words and numbers of files, errors, progress.
/// Internal.
///
/// They are our own because the file library of PCL, pcl_io, links a VTK of its own, which would be
/// a second one in the process of ParaView, and because PCL allocates what a header promises. VTK
/// has an OFF reader from 9.4 on only.
#ifndef DGGFileLoader_h
#define DGGFileLoader_h

#include <charconv>    // for std::from_chars
#include <cstddef>     // for std::size_t
#include <functional>  // for callbacks
#include <sstream>     // for messages
#include <stdexcept>   // for the error
#include <string>      // for messages
#include <string_view> // for words
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

/// Throw an error with the text of all parts.
template <typename... Parts>
[[noreturn]] void Fail(unsigned long code, const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw FileError(code, message.str());
}

/// Reports the finished fraction now and then. Throws when the user has aborted.
using FileProgress = std::function<void(double)>;

/// Do what a reader or writer does, and report its errors: "Cannot <verb> <fileName>: ...". True
/// when it is done; otherwise `code` is the error code, NoError when the user has aborted.
bool RunOnFile(vtkAlgorithm* algorithm, const char* verb, const char* fileName,
  const std::function<void(const FileProgress&)>& work, unsigned long& code);

/// Load a file for a reader and let `read` turn it into the output; if that fails, or the user has
/// aborted, it is empty and does not count as up to date. Returns the error code.
unsigned long ReadFile(vtkAlgorithm* reader, const char* fileName,
  vtkInformationVector* outputVector,
  void (*read)(std::string_view file, const FileProgress& progress, vtkPolyData* output));

/// Whether filters downstream of a reader are to run, as they do after success. One that reads for
/// several processes must not be the only one to stop: filters of the others would wait for this
/// one.
bool GoesOn(unsigned long errorCode, vtkInformationVector* outputVector);

/// The first bytes of a file, at most `limit`. Throws.
std::vector<char> LoadFile(const char* name, std::size_t limit);

/// A part of a file as it can be shown in a message: quoted, not too long, and printable.
std::string Quote(std::string_view text);

/// The words of a text, line by line. In OFF files, \r alone ends a line as well, and everything
/// from # to the end of a line is passed over.
class TextCursor
{
public:
  TextCursor(std::string_view text, bool isOFF)
    : Begin(text.data())
    , Place(text.data())
    , End(text.data() + text.size())
    , IsOFF(isOFF)
  {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // some editors put it before texts in UTF-8
    this->Place += text.substr(0, mark.size()) == mark ? mark.size() : 0;
  }

  /// Move to the next word on this line; false when there is none.
  bool FindOnLine()
  {
    bool isComment = false;
    for (; this->Place != this->End && !this->IsAtLineEnd(); ++this->Place)
    {
      isComment = isComment || (this->IsOFF && *this->Place == '#');
      if (!isComment && !IsBlank(*this->Place))
      {
        return true;
      }
    }
    return false;
  }
  /// Move to the next word on this or a later line; false at the end of the text.
  bool FindAnywhere()
  {
    while (!this->FindOnLine())
    {
      if (this->Place == this->End)
      {
        return false;
      }
      ++this->Place; // the line end
      ++this->Line;
    }
    return true;
  }
  /// Move over the word that was found.
  std::string_view TakeWord()
  {
    const char* const first = this->Place;
    while (this->Place != this->End && *this->Place != '\n' && !IsBlank(*this->Place) &&
      !(this->IsOFF && *this->Place == '#'))
    {
      ++this->Place;
    }
    return { first, static_cast<std::size_t>(this->Place - first) };
  }
  /// Move behind the end of this line.
  void SkipLine()
  {
    while (this->FindOnLine())
    {
      this->TakeWord();
    }
    this->Place += this->Place == this->End ? 0 : 1;
    ++this->Line;
  }
  void Skip(std::size_t bytes) { this->Place += bytes; }

  std::string_view GetRest() const { return { this->Place, this->GetBytesLeft() }; }
  std::size_t GetBytesLeft() const { return static_cast<std::size_t>(this->End - this->Place); }
  std::size_t GetByte() const { return static_cast<std::size_t>(this->Place - this->Begin); }
  std::size_t GetLine() const { return this->Line; }

private:
  static bool IsBlank(char c)
  {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }
  bool IsAtLineEnd() const
  {
    const char* const next = this->Place + 1;
    return *this->Place == '\n' ||
      (this->IsOFF && *this->Place == '\r' && (next == this->End || *next != '\n'));
  }

  const char* Begin;
  const char* Place;
  const char* End;
  bool IsOFF;
  std::size_t Line = 1;
};

/// Whether a number that std::from_chars finds out of range is too small, not too large.
bool IsTooSmall(std::string_view text);

/// Put the number that a word says, in any locale, into `number`; a float that is too small is
/// zero. Returns null, or what is wrong: "is not a number", say.
template <typename Number>
const char* ParseNumber(std::string_view text, Number& number)
{
  const char* first = text.data();
  const char* const last = first + text.size();
  if (text.size() > 1 && first[0] == '+' && first[1] != '-')
  {
    ++first; // std::from_chars does not know a leading plus
  }
  const auto parsed = std::from_chars(first, last, number);
  if (parsed.ptr != last || parsed.ec == std::errc::invalid_argument)
  {
    return std::is_integral<Number>::value ? "is not an integer" : "is not a number";
  }
  if (parsed.ec == std::errc::result_out_of_range)
  {
    if (std::is_integral<Number>::value || !IsTooSmall(text))
    {
      return "is out of range";
    }
    number = 0;
  }
  return nullptr;
}
}

#endif
