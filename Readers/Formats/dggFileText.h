// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bytes, words and numbers of files. Internal to the parsers and writers.
///
/// PCL's file library pcl_io links a second VTK, which crashes ParaView. VTK's and PCL's readers
/// allocate the counts of a header unchecked.
#ifndef dggFileText_h
#define dggFileText_h

#include "dggFormats.h" // for the status

#include <charconv>    // for std::from_chars
#include <cstddef>     // for std::size_t
#include <sstream>     // for messages
#include <stdexcept>   // for the error
#include <string>      // for messages
#include <string_view> // for words
#include <type_traits> // for integers
#include <vector>      // for the bytes

namespace dgg
{
using FileCode = FileStatus::Code;

/// Thrown by parsers and writers; the public functions turn it into a status.
struct FileError : std::runtime_error
{
  FileError(FileCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }
  FileCode Code;
};

/// Throws an error with the text of all parts.
template <typename... Parts>
[[noreturn]] void Fail(FileCode code, const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw FileError(code, message.str());
}

/// Number of records of a file between two reports of progress.
constexpr std::size_t ProgressInterval = 1 << 14;

/// Reports the finished fraction; throws if the callback returns false.
class ProgressReport
{
public:
  explicit ProgressReport(const FileProgress& progress)
    : Progress(progress)
  {
  }
  void operator()(double done) const
  {
    if (this->Progress && !this->Progress(done))
    {
      Fail(FileCode::Aborted, "aborted");
    }
  }
  /// Reports the fraction if an interval ends with this record.
  void At(std::size_t record, double done) const
  {
    if (record % ProgressInterval == 0)
    {
      (*this)(done);
    }
  }
  void At(std::size_t record, std::size_t records) const
  {
    this->At(record, static_cast<double>(record) / static_cast<double>(records));
  }

private:
  const FileProgress& Progress;
};

/// Returns the first bytes of a file, at most `limit`, decompressed if the file is compressed by
/// gzip. Throws.
std::vector<char> LoadFile(const std::string& name, std::size_t limit);

/// Returns a part of a file for a message: quoted, shortened and printable.
std::string Quote(std::string_view text);

/// Differences between the text formats.
struct TextRules
{
  bool HasLoneReturns = false;   ///< \r without \n ends a line
  bool HasComments = false;      ///< # starts a comment
  bool HasSlashComments = false; ///< // starts a comment
  bool HasContinuations = false; ///< a line that ends with \ continues on the next line
  bool HasSeparators = false;    ///< , and ; separate words
};

/// Words of a text, line by line.
class TextCursor
{
public:
  TextCursor(std::string_view text, const TextRules& rules)
    : Begin(text.data())
    , Position(text.data())
    , End(text.data() + text.size())
    , Rules(rules)
  {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // byte order mark of UTF-8
    this->Position += text.substr(0, mark.size()) == mark ? mark.size() : 0;
  }

  /// Moves to the next word on this line. Returns false if there is none.
  bool FindOnLine()
  {
    bool isComment = false;
    for (; this->Position != this->End && !this->IsAtLineEnd(); ++this->Position)
    {
      if (this->IsAtContinuation())
      {
        this->Position += this->Position[1] == '\r' ? 2 : 1;
        ++this->Line;
        isComment = false;
        continue;
      }
      isComment = isComment || this->IsAtComment();
      if (!isComment && !this->IsBlank(*this->Position))
      {
        return true;
      }
    }
    return false;
  }
  /// Moves to the next word on this or a later line. Returns false at the end of the text.
  bool FindAnywhere()
  {
    while (!this->FindOnLine())
    {
      if (this->Position == this->End)
      {
        return false;
      }
      ++this->Position; // skips the line end
      ++this->Line;
    }
    return true;
  }
  /// Returns the word at the position and moves to its end.
  std::string_view TakeWord()
  {
    const char* const first = this->Position;
    while (this->Position != this->End && *this->Position != '\n' &&
      !this->IsBlank(*this->Position) && !this->IsAtComment() && !this->IsAtContinuation())
    {
      ++this->Position;
    }
    return { first, static_cast<std::size_t>(this->Position - first) };
  }
  /// Moves to the next line. Continuations are ignored.
  void SkipLine()
  {
    while (this->Position != this->End && !this->IsAtLineEnd())
    {
      ++this->Position;
    }
    this->Position += this->Position == this->End ? 0 : 1;
    ++this->Line;
  }
  void Skip(std::size_t bytes) { this->Position += bytes; }

  std::string_view GetRest() const { return { this->Position, this->GetBytesLeft() }; }
  std::size_t GetBytesLeft() const { return static_cast<std::size_t>(this->End - this->Position); }
  std::size_t GetByte() const { return static_cast<std::size_t>(this->Position - this->Begin); }
  std::size_t GetLine() const { return this->Line; }
  double GetFraction() const
  {
    return static_cast<double>(this->GetByte()) / static_cast<double>(this->End - this->Begin + 1);
  }

private:
  bool IsBlank(char c) const
  {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' ||
      (this->Rules.HasSeparators && (c == ',' || c == ';'));
  }
  bool IsNext(char c) const { return this->Position + 1 != this->End && this->Position[1] == c; }
  bool IsAtComment() const
  {
    return (this->Rules.HasComments && *this->Position == '#') ||
      (this->Rules.HasSlashComments && *this->Position == '/' && this->IsNext('/'));
  }
  bool IsAtContinuation() const
  {
    return this->Rules.HasContinuations && *this->Position == '\\' &&
      (this->IsNext('\n') ||
        (this->IsNext('\r') && this->Position + 2 != this->End && this->Position[2] == '\n'));
  }
  bool IsAtLineEnd() const
  {
    return *this->Position == '\n' ||
      (this->Rules.HasLoneReturns && *this->Position == '\r' && !this->IsNext('\n'));
  }

  const char* Begin;
  const char* Position;
  const char* End;
  TextRules Rules;
  std::size_t Line = 1;
};

/// Returns true if a number outside the range of double underflows; false if it overflows.
bool IsTooSmall(std::string_view text);

#if !defined(__cpp_lib_to_chars)
///@{
/// Replace std::from_chars, which libc++ lacks for floating-point numbers before version 20.
std::from_chars_result FromChars(const char* first, const char* last, float& number);
std::from_chars_result FromChars(const char* first, const char* last, double& number);
///@}
#endif
template <typename Number>
std::from_chars_result FromChars(const char* first, const char* last, Number& number)
{
  return std::from_chars(first, last, number);
}

/// Converts a word to a number, in any locale; a floating-point number that is too small becomes
/// zero. Returns null, or the defect, such as "is not a number".
template <typename Number>
const char* ParseNumber(std::string_view text, Number& number)
{
  const char* first = text.data();
  const char* const last = first + text.size();
  if (text.size() > 1 && first[0] == '+' && first[1] != '-')
  {
    ++first; // FromChars() refuses a leading plus
  }
  const auto parsed = FromChars(first, last, number);
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
