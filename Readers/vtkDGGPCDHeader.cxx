// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPCDHeader.h"

#include "vtkErrorCode.h"
#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

namespace
{
/// A line of the header: a keyword and what follows it.
struct Entry
{
  std::size_t Line = 0;
  std::vector<std::string> Values;
};
using Entries = std::map<std::string, Entry>;

const char* const Keywords[] = { "VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH",
  "HEIGHT", "VIEWPOINT", "POINTS", "DATA" };

/// Words of a line that are kept, at most: one more than there may be, so that it is told that
/// there are too many. A word takes many times the memory of its text.
constexpr std::size_t MostWords = vtkDGGPCDHeader::MostFields + 2;

bool IsKeyword(const std::string& text)
{
  return std::find(std::begin(Keywords), std::end(Keywords), text) != std::end(Keywords);
}

/// The words of the line that begins at `cursor`, which moves behind the line end. No words when it
/// is blank or a comment, and never more than MostWords.
std::vector<std::string> TakeLine(const char*& cursor, const char* end)
{
  const char* const last = std::find(cursor, end, '\n');
  std::vector<std::string> words;
  while (cursor != last && words.size() < MostWords)
  {
    const auto isBlank = [](char c) {
      return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
    };
    const char* const first = std::find_if_not(cursor, last, isBlank);
    cursor = std::find_if(first, last, isBlank);
    if (first != cursor)
    {
      if (words.empty() && *first == '#')
      {
        break;
      }
      words.emplace_back(first, cursor);
    }
  }
  cursor = last + (last != end ? 1 : 0);
  return words;
}

/// Behind the mark that some editors put before texts in UTF-8.
const char* SkipMark(const char* begin, const char* end)
{
  const std::string_view mark = "\xEF\xBB\xBF";
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  return text.substr(0, mark.size()) == mark ? begin + mark.size() : begin;
}

template <typename Number>
bool ToNumber(const std::string& text, Number& number)
{
  const char* const last = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), last, number);
  return parsed.ec == std::errc() && parsed.ptr == last;
}

/// What the lines say, checked.
class HeaderBuilder
{
public:
  HeaderBuilder(const Entries& entries, vtkDGGPCDHeader& header, vtkDGGFileError& error)
    : All(entries)
    , Header(header)
    , Error(error)
  {
  }

  bool Build()
  {
    return this->BuildFields() && this->BuildCounts() && this->BuildViewpoint() &&
      this->BuildData();
  }

private:
  bool Fail(const Entry& entry, const std::string& message)
  {
    this->Error = { vtkErrorCode::FileFormatError,
      "line " + std::to_string(entry.Line) + ": " + message };
    return false;
  }
  const Entry* Find(const char* keyword) const
  {
    const auto entry = this->All.find(keyword);
    return entry == this->All.end() ? nullptr : &entry->second;
  }
  const Entry& GetEnd() const { return this->All.at("DATA"); }

  /// One value for each field; null when the line is not there.
  bool FindPerField(const char* keyword, const Entry*& entry)
  {
    entry = this->Find(keyword);
    return !entry || entry->Values.size() == this->Header.Fields.size() ||
      this->Fail(*entry,
        std::string(keyword) + " has " + std::to_string(entry->Values.size()) + " values for " +
          std::to_string(this->Header.Fields.size()) + " fields");
  }

  bool BuildFields()
  {
    const Entry* names = this->Find("FIELDS");
    const Entry* columns = this->Find("COLUMNS");
    if (names && columns)
    {
      return this->Fail(*columns, "both FIELDS and COLUMNS");
    }
    names = names ? names : columns;
    if (!names || names->Values.empty())
    {
      return this->Fail(names ? *names : this->GetEnd(), "no FIELDS before the data");
    }
    if (names->Values.size() > vtkDGGPCDHeader::MostFields)
    {
      return this->Fail(
        *names, "more than " + std::to_string(vtkDGGPCDHeader::MostFields) + " fields");
    }
    std::set<std::string> seen;
    for (const std::string& name : names->Values)
    {
      if (name != "_" && !seen.insert(name).second)
      {
        return this->Fail(*names, "two fields " + vtkDGGQuote(name));
      }
      this->Header.Fields.push_back({ name, 'F', 4, 1 });
    }
    for (const char* name : { "x", "y", "z" })
    {
      if (seen.count(name) == 0)
      {
        return this->Fail(*names,
          std::string("no field '") + name + "': a point cloud needs the fields x, y and z");
      }
    }
    return this->BuildTypes() && this->BuildFieldCounts();
  }

  /// Files of old have neither SIZE nor TYPE: all numbers are floats then.
  bool BuildTypes()
  {
    const Entry* sizes = nullptr;
    const Entry* types = nullptr;
    if (!this->FindPerField("SIZE", sizes) || !this->FindPerField("TYPE", types))
    {
      return false;
    }
    if (!sizes != !types)
    {
      return this->Fail(sizes ? *sizes : *types, sizes ? "SIZE without TYPE" : "TYPE without SIZE");
    }
    for (std::size_t i = 0; sizes && i < this->Header.Fields.size(); ++i)
    {
      vtkDGG::PointField& field = this->Header.Fields[i];
      const std::string& size = sizes->Values[i];
      const std::string& type = types->Values[i];
      if (type != "F" && type != "I" && type != "U")
      {
        return this->Fail(*types, "TYPE " + vtkDGGQuote(type) + " is none of F, I and U");
      }
      field.Kind = type[0];
      if (!ToNumber(size, field.Size) || !vtkDGG::IsPointFieldType(field.Kind, field.Size))
      {
        return this->Fail(*sizes,
          "SIZE " + vtkDGGQuote(size) + " of the field " + vtkDGGQuote(field.Name) +
            " is not one of a number of type " + type +
            (field.Kind == 'F' ? " (4 or 8)" : " (1, 2, 4 or 8)"));
      }
    }
    return true;
  }

  bool BuildFieldCounts()
  {
    const Entry* counts = nullptr;
    if (!this->FindPerField("COUNT", counts))
    {
      return false;
    }
    std::size_t bytes = 0;
    for (std::size_t i = 0; counts && i < this->Header.Fields.size(); ++i)
    {
      vtkDGG::PointField& field = this->Header.Fields[i];
      if (!ToNumber(counts->Values[i], field.Count) || field.Count < 1)
      {
        return this->Fail(*counts,
          "COUNT " + vtkDGGQuote(counts->Values[i]) + " of the field " + vtkDGGQuote(field.Name) +
            " is not a positive number");
      }
      const bool isCoordinate = field.Name == "x" || field.Name == "y" || field.Name == "z";
      if (isCoordinate && field.Count != 1)
      {
        return this->Fail(*counts, "the field '" + field.Name + "' must have COUNT 1");
      }
      bytes += field.GetBytes();
      if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      {
        return this->Fail(*counts, "the values of a point take more than 2 GB");
      }
    }
    return true;
  }

  /// Not there: -1.
  bool GetCount(const char* keyword, vtkIdType& count)
  {
    count = -1;
    const Entry* entry = this->Find(keyword);
    if (!entry)
    {
      return true;
    }
    this->Header.CountLine = entry->Line;
    if (entry->Values.size() != 1 || !ToNumber(entry->Values[0], count) || count < 0)
    {
      return this->Fail(*entry,
        std::string(keyword) + " " +
          (entry->Values.size() == 1 ? vtkDGGQuote(entry->Values[0]) + " is not a number of points"
                                     : "is followed by " + std::to_string(entry->Values.size()) +
                " values, expected one"));
    }
    return true;
  }

  bool BuildCounts()
  {
    vtkIdType width = 0;
    vtkIdType height = 0;
    vtkIdType points = 0;
    if (!this->GetCount("WIDTH", width) || !this->GetCount("HEIGHT", height) ||
      !this->GetCount("POINTS", points))
    {
      return false;
    }
    if (width < 0 && points < 0)
    {
      return this->Fail(this->GetEnd(), "neither WIDTH nor POINTS before the data");
    }
    if (width < 0 && height > 1)
    {
      return this->Fail(*this->Find("HEIGHT"), "HEIGHT without WIDTH");
    }
    // Old files have POINTS only, or say WIDTH 0 and HEIGHT 0 beside it.
    if (width < 0 || (width == 0 && height == 0))
    {
      width = std::max<vtkIdType>(points, 0);
      height = 1;
    }
    height = height < 0 ? 1 : height;
    if (height > 0 && width > VTK_ID_MAX / height)
    {
      return this->Fail(*this->Find("WIDTH"), "WIDTH times HEIGHT is too large");
    }
    if (points >= 0 && width * height != points)
    {
      return this->Fail(*this->Find("POINTS"),
        "POINTS " + std::to_string(points) + " is not WIDTH " + std::to_string(width) +
          " times HEIGHT " + std::to_string(height));
    }
    this->Header.Width = width;
    this->Header.Height = height;
    return true;
  }

  bool BuildViewpoint()
  {
    const Entry* entry = this->Find("VIEWPOINT");
    if (!entry)
    {
      return true;
    }
    if (entry->Values.size() != this->Header.Sensor.size())
    {
      return this->Fail(*entry,
        "VIEWPOINT has " + std::to_string(entry->Values.size()) +
          " values, expected 7 (translation x y z, quaternion w x y z)");
    }
    for (std::size_t i = 0; i < this->Header.Sensor.size(); ++i)
    {
      if (!ToNumber(entry->Values[i], this->Header.Sensor[i]) ||
        !std::isfinite(this->Header.Sensor[i]))
      {
        return this->Fail(
          *entry, "VIEWPOINT " + vtkDGGQuote(entry->Values[i]) + " is not a finite number");
      }
    }
    return true;
  }

  bool BuildData()
  {
    const Entry& entry = this->GetEnd();
    const std::string data = entry.Values.size() == 1 ? entry.Values[0] : std::string();
    if (data == "ascii")
    {
      this->Header.Data = vtkDGGPCDData::ASCII;
    }
    else if (data == "binary")
    {
      this->Header.Data = vtkDGGPCDData::Binary;
    }
    else if (data == "binary_compressed")
    {
      this->Header.Data = vtkDGGPCDData::BinaryCompressed;
    }
    else
    {
      return this->Fail(entry, "DATA must be one of ascii, binary and binary_compressed");
    }
    return true;
  }

  const Entries& All;
  vtkDGGPCDHeader& Header;
  vtkDGGFileError& Error;
};

template <typename Number>
void AppendNumber(std::string& text, Number number)
{
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), number);
  text.append(buffer, end.ptr);
}
}

std::size_t vtkDGGPCDHeader::GetPointBytes() const
{
  std::size_t bytes = 0;
  for (const vtkDGG::PointField& field : this->Fields)
  {
    bytes += field.GetBytes();
  }
  return bytes;
}

std::size_t vtkDGGPCDHeader::GetPointNumbers() const
{
  std::size_t numbers = 0;
  for (const vtkDGG::PointField& field : this->Fields)
  {
    numbers += static_cast<std::size_t>(field.Count);
  }
  return numbers;
}

bool vtkDGGPCDHeader::Parse(const char* begin, const char* end, vtkDGGFileError& error)
{
  Entries entries;
  const char* cursor = SkipMark(begin, end);
  std::size_t line = 0;
  const auto fail = [&line, &error](unsigned long code, const std::string& message) {
    error = { code, "line " + std::to_string(line) + ": " + message };
    return false;
  };
  while (cursor != end)
  {
    ++line;
    std::vector<std::string> words = TakeLine(cursor, end);
    if (words.empty())
    {
      continue;
    }
    const std::string keyword = words[0];
    if (!IsKeyword(keyword))
    {
      return entries.empty()
        ? fail(vtkErrorCode::UnrecognizedFileTypeError,
            vtkDGGQuote(keyword) + " is not the first keyword of a PCD file, such as VERSION")
        : fail(vtkErrorCode::FileFormatError,
            vtkDGGQuote(keyword) + " is not a keyword of the header of a PCD file");
    }
    words.erase(words.begin());
    if (!entries.emplace(keyword, Entry{ line, std::move(words) }).second)
    {
      return fail(vtkErrorCode::FileFormatError, "a second " + keyword);
    }
    if (keyword == "DATA")
    {
      this->BodyBegin = static_cast<std::size_t>(cursor - begin);
      this->BodyLine = line + 1;
      return HeaderBuilder(entries, *this, error).Build();
    }
  }
  line = std::max<std::size_t>(line, 1);
  return fail(vtkErrorCode::PrematureEndOfFileError,
    begin == end ? "the file is empty" : "the file ends before the line DATA of the header");
}

std::string vtkDGGPCDHeader::Format() const
{
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS";
  for (const vtkDGG::PointField& field : this->Fields)
  {
    text += " " + field.Name;
  }
  text += "\nSIZE";
  for (const vtkDGG::PointField& field : this->Fields)
  {
    text += " " + std::to_string(field.Size);
  }
  text += "\nTYPE";
  for (const vtkDGG::PointField& field : this->Fields)
  {
    text += std::string(" ") + field.Kind;
  }
  text += "\nCOUNT";
  for (const vtkDGG::PointField& field : this->Fields)
  {
    text += " " + std::to_string(field.Count);
  }
  text += "\nWIDTH " + std::to_string(this->Width);
  text += "\nHEIGHT " + std::to_string(this->Height);
  text += "\nVIEWPOINT";
  for (const double value : this->Sensor)
  {
    text += ' ';
    AppendNumber(text, value);
  }
  text += "\nPOINTS " + std::to_string(this->GetNumberOfPoints());
  const char* const data[] = { "ascii", "binary", "binary_compressed" };
  text += std::string("\nDATA ") + data[static_cast<int>(this->Data)] + "\n";
  return text;
}

bool vtkDGGLooksLikePCD(const char* begin, const char* end)
{
  bool hasFields = false;
  for (const char* cursor = SkipMark(begin, end); cursor != end;)
  {
    const bool isWhole = std::find(cursor, end, '\n') != end;
    const std::vector<std::string> words = TakeLine(cursor, end);
    if (words.empty())
    {
      continue;
    }
    if (!IsKeyword(words[0]))
    {
      // The last line may be cut.
      return hasFields && !isWhole;
    }
    hasFields = hasFields || words[0] == "FIELDS" || words[0] == "COLUMNS";
    if (words[0] == "DATA")
    {
      break;
    }
  }
  return hasFields;
}
