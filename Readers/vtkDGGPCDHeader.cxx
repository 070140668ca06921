// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPCDHeader.h"

#include "vtkDGGFileLoader.h"

#include "vtkErrorCode.h"
#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using vtkDGG::PointField;
using vtkDGG::Quote;

namespace
{
constexpr auto Malformed = vtkErrorCode::FileFormatError;

/// What follows a keyword.
struct Entry
{
  std::size_t Line = 0;
  std::vector<std::string> Values;
};
using Entries = std::map<std::string, Entry>;

const char* const Keywords[] = { "VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH",
  "HEIGHT", "VIEWPOINT", "POINTS", "DATA" };
const char* const DataNames[] = { "ascii", "binary", "binary_compressed" };

/// Words of a line that are kept, at most: one more than there may be, so that too many are
/// noticed. A word takes many times the memory of its text.
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
    const char* const first = std::find_if_not(cursor, last, vtkDGG::IsBlank);
    cursor = std::find_if(first, last, vtkDGG::IsBlank);
    if (first == cursor || (words.empty() && *first == '#'))
    {
      break;
    }
    words.emplace_back(first, cursor);
  }
  cursor = last + (last != end ? 1 : 0);
  return words;
}

template <typename Number>
bool ToNumber(const std::string& text, Number& number)
{
  const char* const last = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), last, number);
  return parsed.ec == std::errc() && parsed.ptr == last;
}

[[noreturn]] void Fail(const Entry& entry, const std::string& message)
{
  vtkDGGFailAtLine(Malformed, entry.Line, message);
}

const Entry* Find(const Entries& entries, const char* keyword)
{
  const auto entry = entries.find(keyword);
  return entry == entries.end() ? nullptr : &entry->second;
}

/// The line with one value for each of `count` fields; null when it is not there.
const Entry* FindPerField(const Entries& entries, const char* keyword, std::size_t count)
{
  const Entry* entry = Find(entries, keyword);
  if (entry && entry->Values.size() != count)
  {
    Fail(*entry,
      std::string(keyword) + " has " + std::to_string(entry->Values.size()) + " values for " +
        std::to_string(count) + " fields");
  }
  return entry;
}

std::vector<PointField> ReadNames(const Entries& entries)
{
  const Entry* names = Find(entries, "FIELDS");
  const Entry* columns = Find(entries, "COLUMNS");
  if (names && columns)
  {
    Fail(*columns, "both FIELDS and COLUMNS");
  }
  names = names ? names : columns;
  if (!names || names->Values.empty())
  {
    Fail(names ? *names : entries.at("DATA"), "no FIELDS before the data");
  }
  if (names->Values.size() > vtkDGGPCDHeader::MostFields)
  {
    Fail(*names, "more than " + std::to_string(vtkDGGPCDHeader::MostFields) + " fields");
  }
  std::vector<PointField> fields;
  std::set<std::string> seen;
  for (const std::string& name : names->Values)
  {
    if (name != "_" && !seen.insert(name).second)
    {
      Fail(*names, "two fields " + Quote(name));
    }
    fields.push_back({ name, 'F', 4, 1 });
  }
  for (const char* name : { "x", "y", "z" })
  {
    if (seen.count(name) == 0)
    {
      Fail(
        *names, std::string("no field '") + name + "': a point cloud needs the fields x, y and z");
    }
  }
  return fields;
}

/// Files of old have neither SIZE nor TYPE: all numbers are floats then.
void ReadTypes(const Entries& entries, std::vector<PointField>& fields)
{
  const Entry* sizes = FindPerField(entries, "SIZE", fields.size());
  const Entry* types = FindPerField(entries, "TYPE", fields.size());
  if (!sizes != !types)
  {
    Fail(sizes ? *sizes : *types, sizes ? "SIZE without TYPE" : "TYPE without SIZE");
  }
  for (std::size_t i = 0; sizes && i < fields.size(); ++i)
  {
    PointField& field = fields[i];
    const std::string& size = sizes->Values[i];
    const std::string& type = types->Values[i];
    if (type != "F" && type != "I" && type != "U")
    {
      Fail(*types, "TYPE " + Quote(type) + " is none of F, I and U");
    }
    field.Kind = type[0];
    if (!ToNumber(size, field.Size) || !vtkDGG::IsPointFieldType(field.Kind, field.Size))
    {
      Fail(*sizes,
        "SIZE " + Quote(size) + " of the field " + Quote(field.Name) +
          " is not one of a number of type " + type +
          (field.Kind == 'F' ? " (4 or 8)" : " (1, 2, 4 or 8)"));
    }
  }
}

void ReadFieldCounts(const Entries& entries, std::vector<PointField>& fields)
{
  const Entry* counts = FindPerField(entries, "COUNT", fields.size());
  std::size_t bytes = 0;
  for (std::size_t i = 0; counts && i < fields.size(); ++i)
  {
    PointField& field = fields[i];
    if (!ToNumber(counts->Values[i], field.Count) || field.Count < 1)
    {
      Fail(*counts,
        "COUNT " + Quote(counts->Values[i]) + " of the field " + Quote(field.Name) +
          " is not a positive number");
    }
    if (field.Count != 1 && (field.Name == "x" || field.Name == "y" || field.Name == "z"))
    {
      Fail(*counts, "the field '" + field.Name + "' must have COUNT 1");
    }
    bytes += field.GetBytes();
    if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
      Fail(*counts, "the values of a point take more than 2 GB");
    }
  }
}

/// Not there: -1.
vtkIdType ReadCount(const Entries& entries, const char* keyword, std::size_t& line)
{
  vtkIdType count = -1;
  const Entry* entry = Find(entries, keyword);
  if (!entry)
  {
    return count;
  }
  line = entry->Line;
  if (entry->Values.size() != 1)
  {
    Fail(*entry,
      std::string(keyword) + " is followed by " + std::to_string(entry->Values.size()) +
        " values, expected one");
  }
  if (!ToNumber(entry->Values[0], count) || count < 0)
  {
    Fail(
      *entry, std::string(keyword) + " " + Quote(entry->Values[0]) + " is not a number of points");
  }
  return count;
}

void ReadCounts(const Entries& entries, vtkDGGPCDHeader& header)
{
  vtkIdType width = ReadCount(entries, "WIDTH", header.CountLine);
  vtkIdType height = ReadCount(entries, "HEIGHT", header.CountLine);
  const vtkIdType points = ReadCount(entries, "POINTS", header.CountLine);
  if (width < 0 && points < 0)
  {
    Fail(entries.at("DATA"), "neither WIDTH nor POINTS before the data");
  }
  if (width < 0 && height > 1)
  {
    Fail(entries.at("HEIGHT"), "HEIGHT without WIDTH");
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
    Fail(entries.at("WIDTH"), "WIDTH times HEIGHT is too large");
  }
  if (points >= 0 && width * height != points)
  {
    Fail(entries.at("POINTS"),
      "POINTS " + std::to_string(points) + " is not WIDTH " + std::to_string(width) +
        " times HEIGHT " + std::to_string(height));
  }
  header.Width = width;
  header.Height = height;
}

void ReadViewpoint(const Entry& entry, vtkDGG::Viewpoint& sensor)
{
  if (entry.Values.size() != sensor.size())
  {
    Fail(entry,
      "VIEWPOINT has " + std::to_string(entry.Values.size()) +
        " values, expected 7 (translation x y z, quaternion w x y z)");
  }
  for (std::size_t i = 0; i < sensor.size(); ++i)
  {
    if (!ToNumber(entry.Values[i], sensor[i]) || !std::isfinite(sensor[i]))
    {
      Fail(entry, "VIEWPOINT " + Quote(entry.Values[i]) + " is not a finite number");
    }
  }
}

vtkDGGPCDData ReadDataMode(const Entry& entry)
{
  const auto name = std::find(
    std::begin(DataNames), std::end(DataNames), entry.Values.empty() ? "" : entry.Values[0]);
  if (entry.Values.size() != 1 || name == std::end(DataNames))
  {
    Fail(entry, "DATA must be one of ascii, binary and binary_compressed");
  }
  return static_cast<vtkDGGPCDData>(name - std::begin(DataNames));
}
}

void vtkDGGFailAtLine(unsigned long code, std::size_t line, const std::string& message)
{
  throw vtkDGG::FileError(code, "line " + std::to_string(line) + ": " + message);
}

std::size_t vtkDGGPCDHeader::GetPointBytes() const
{
  std::size_t bytes = 0;
  for (const PointField& field : this->Fields)
  {
    bytes += field.GetBytes();
  }
  return bytes;
}

std::size_t vtkDGGPCDHeader::GetPointNumbers() const
{
  std::size_t numbers = 0;
  for (const PointField& field : this->Fields)
  {
    numbers += static_cast<std::size_t>(field.Count);
  }
  return numbers;
}

void vtkDGGPCDHeader::Parse(const char* begin, const char* end)
{
  Entries entries;
  const char* cursor = vtkDGG::SkipByteOrderMark(begin, end);
  std::size_t line = 0;
  while (cursor != end && entries.count("DATA") == 0)
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
      vtkDGGFailAtLine(entries.empty() ? vtkErrorCode::UnrecognizedFileTypeError : Malformed, line,
        Quote(keyword) +
          (entries.empty() ? " is not the first keyword of a PCD file, such as VERSION"
                           : " is not a keyword of the header of a PCD file"));
    }
    words.erase(words.begin());
    if (!entries.emplace(keyword, Entry{ line, std::move(words) }).second)
    {
      vtkDGGFailAtLine(Malformed, line, "a second " + keyword);
    }
  }
  if (entries.count("DATA") == 0)
  {
    vtkDGGFailAtLine(vtkErrorCode::PrematureEndOfFileError, std::max<std::size_t>(line, 1),
      begin == end ? "the file is empty" : "the file ends before the line DATA of the header");
  }
  this->BodyBegin = static_cast<std::size_t>(cursor - begin);
  this->BodyLine = line + 1;
  this->Fields = ReadNames(entries);
  ReadTypes(entries, this->Fields);
  ReadFieldCounts(entries, this->Fields);
  ReadCounts(entries, *this);
  if (const Entry* viewpoint = Find(entries, "VIEWPOINT"))
  {
    ReadViewpoint(*viewpoint, this->Sensor);
  }
  this->Data = ReadDataMode(entries.at("DATA"));
}

std::string vtkDGGPCDHeader::Format() const
{
  std::string names;
  std::string sizes;
  std::string types;
  std::string counts;
  for (const PointField& field : this->Fields)
  {
    names += " " + field.Name;
    sizes += " " + std::to_string(field.Size);
    types += std::string(" ") + field.Kind;
    counts += " " + std::to_string(field.Count);
  }
  std::string sensor;
  for (const double value : this->Sensor)
  {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
    sensor += " " + std::string(buffer, end.ptr);
  }
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" +
    sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + std::to_string(this->Width) +
    "\nHEIGHT " + std::to_string(this->Height) + "\nVIEWPOINT" + sensor + "\nPOINTS " +
    std::to_string(this->GetNumberOfPoints()) + "\nDATA " +
    DataNames[static_cast<int>(this->Data)] + "\n";
}

bool vtkDGGLooksLikePCD(const char* begin, const char* end)
{
  bool hasFields = false;
  for (const char* cursor = vtkDGG::SkipByteOrderMark(begin, end); cursor != end;)
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
