// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPCDHeader.h"

#include "dggCounted.h"
#include "dggParsers.h"
#include "dggPointCloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using dgg::FileCode;
using dgg::PointField;
using dgg::Quote;

namespace
{
constexpr auto Malformed = FileCode::Malformed;

constexpr const char* Keywords[] = { "VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT",
  "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA" };
constexpr const char* DataNames[] = { "ascii", "binary", "binary_compressed" };

bool IsKeyword(std::string_view text)
{
  return std::find(std::begin(Keywords), std::end(Keywords), text) != std::end(Keywords);
}

/// Returns the words of the next line that is neither blank nor a comment; none at the end of the
/// text. At most one more word than a valid line has is stored, because a view takes many times the
/// memory of a short word.
std::vector<std::string_view> TakeLine(dgg::TextCursor& text)
{
  std::vector<std::string_view> words;
  while (words.empty() && text.FindAnywhere())
  {
    const bool isComment = text.GetRest()[0] == '#';
    while (text.FindOnLine())
    {
      const std::string_view word = text.TakeWord();
      if (!isComment && words.size() < dgg::PCDHeader::MaximumFields + 2)
      {
        words.push_back(word);
      }
    }
  }
  return words;
}

/// A line of the header.
struct Entry
{
  std::string Keyword;
  std::size_t Line = 0;
  std::vector<std::string_view> Values;

  template <typename... Parts>
  [[noreturn]] void Fail(const Parts&... parts) const
  {
    dgg::Fail(Malformed, "line ", this->Line, ": ", parts...);
  }
  /// Reports an invalid value.
  template <typename... Parts>
  [[noreturn]] void FailAt(std::size_t i, const Parts&... parts) const
  {
    this->Fail(this->Keyword, " ", Quote(this->Values[i]), parts...);
  }
};

/// The lines of a header.
class Entries
{
public:
  /// Moves past the line with DATA.
  explicit Entries(dgg::TextCursor& text)
  {
    const bool isEmpty = text.GetBytesLeft() == 0;
    while (this->Lines.count("DATA") == 0)
    {
      std::vector<std::string_view> words = TakeLine(text);
      if (words.empty())
      {
        dgg::Fail(FileCode::Premature, "line ", text.GetLine(), ": ",
          isEmpty ? "the file is empty" : "the file ends before the line DATA of the header");
      }
      const bool isFirst = this->Lines.empty();
      Entry entry{ std::string(words[0]), text.GetLine(), {} };
      if (!IsKeyword(entry.Keyword))
      {
        dgg::Fail(isFirst ? FileCode::Unrecognized : Malformed, "line ", entry.Line, ": ",
          Quote(entry.Keyword),
          isFirst ? " is not the first keyword of a PCD file, such as VERSION"
                  : " is not a keyword of the header of a PCD file");
      }
      if (this->Lines.count(entry.Keyword) > 0)
      {
        entry.Fail("the header has a second ", entry.Keyword);
      }
      words.erase(words.begin());
      entry.Values = std::move(words);
      this->Lines.emplace(std::string(entry.Keyword), std::move(entry));
    }
    text.SkipLine();
  }

  const Entry& Get(const char* keyword) const { return this->Lines.find(keyword)->second; }
  /// Returns the line of a keyword, or null.
  const Entry* Find(const char* keyword) const
  {
    return this->Lines.count(keyword) > 0 ? &this->Get(keyword) : nullptr;
  }
  /// Returns the line of a keyword, which must have `count` values, or null.
  const Entry* Find(const char* keyword, std::size_t count) const
  {
    const Entry* entry = this->Find(keyword);
    if (entry && entry->Values.size() != count)
    {
      entry->Fail(
        keyword, " has ", dgg::Counted(entry->Values.size(), "value"), ". Expected ", count);
    }
    return entry;
  }
  /// Returns a number of points; -1 if there is no such line.
  std::int64_t GetCount(const char* keyword, std::size_t& line) const
  {
    std::int64_t count = -1;
    if (const Entry* entry = this->Find(keyword, 1))
    {
      line = entry->Line;
      if (dgg::ParseNumber(entry->Values[0], count) || count < 0)
      {
        entry->FailAt(0, " is not a number of points");
      }
    }
    return count;
  }

private:
  std::map<std::string, Entry, std::less<>> Lines;
};

/// Reads the fields. Old files have neither SIZE nor TYPE; then all numbers are floats.
void ReadFields(const Entries& entries, dgg::PCDHeader& header)
{
  const Entry* columns = entries.Find("COLUMNS");
  const Entry* names = entries.Find("FIELDS");
  if (names && columns)
  {
    columns->Fail("the header has both FIELDS and COLUMNS");
  }
  names = names ? names : columns;
  if (!names || names->Values.empty())
  {
    (names ? *names : entries.Get("DATA")).Fail("the header has no FIELDS");
  }
  const std::size_t count = names->Values.size();
  if (count > dgg::PCDHeader::MaximumFields)
  {
    names->Fail("the header has more than ", dgg::PCDHeader::MaximumFields, " fields");
  }
  const Entry* sizes = entries.Find("SIZE", count);
  const Entry* types = entries.Find("TYPE", count);
  const Entry* counts = entries.Find("COUNT", count);
  if (!sizes != !types)
  {
    (sizes ? sizes : types)
      ->Fail(sizes ? "SIZE is given without TYPE" : "TYPE is given without SIZE");
  }
  header.FieldsLine = names->Line;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    PointField field{ std::string(names->Values[i]), 'F', 4, 1 };
    if (types)
    {
      const std::string_view type = types->Values[i];
      field.Kind = type.size() == 1 ? type[0] : ' ';
      if (dgg::ParseNumber(sizes->Values[i], field.Size) ||
        !dgg::IsFieldType(field.Kind, field.Size))
      {
        sizes->FailAt(i, " of the field ", Quote(field.Name), " is not one of TYPE ", Quote(type),
          ". Expected 4 or 8 for F, and 1, 2, 4 or 8 for I and U");
      }
    }
    if (counts && (dgg::ParseNumber(counts->Values[i], field.Count) || field.Count < 1))
    {
      counts->FailAt(i, " of the field ", Quote(field.Name), " is not a positive number");
    }
    header.Fields.push_back(field);
    bytes += field.GetBytes();
    if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
      counts->Fail("the values of a point take more than 2 GB");
    }
  }
}

void ReadCounts(const Entries& entries, dgg::PCDHeader& header)
{
  header.Layout.Width = entries.GetCount("WIDTH", header.CountLine);
  header.Layout.Height = entries.GetCount("HEIGHT", header.CountLine);
  const std::int64_t points = entries.GetCount("POINTS", header.CountLine);
  if (header.Layout.Width < 0 && points < 0)
  {
    entries.Get("DATA").Fail("the header has neither WIDTH nor POINTS");
  }
  if (header.Layout.Width < 0 && header.Layout.Height > 1)
  {
    entries.Get("HEIGHT").Fail("HEIGHT is given without WIDTH");
  }
  // Old files have only POINTS, or WIDTH 0 and HEIGHT 0 in addition.
  if (header.Layout.Width < 0 || (header.Layout.Width == 0 && header.Layout.Height == 0))
  {
    header.Layout.Width = std::max<std::int64_t>(points, 0);
    header.Layout.Height = 1;
  }
  header.Layout.Height = header.Layout.Height < 0 ? 1 : header.Layout.Height;
  if (header.Layout.Height > 0 && header.Layout.Width > INT64_MAX / header.Layout.Height)
  {
    entries.Get("WIDTH").Fail("WIDTH times HEIGHT is too large");
  }
  if (points >= 0 && header.GetNumberOfPoints() != points)
  {
    entries.Get("POINTS").Fail("POINTS ", points, " is not WIDTH ", header.Layout.Width,
      " times HEIGHT ", header.Layout.Height);
  }
}
}

std::size_t dgg::PCDHeader::GetPointBytes() const
{
  std::size_t bytes = 0;
  for (const PointField& field : this->Fields)
  {
    bytes += field.GetBytes();
  }
  return bytes;
}

void dgg::PCDHeader::Parse(dgg::TextCursor& text)
{
  const Entries entries(text);
  ReadFields(entries, *this);
  ReadCounts(entries, *this);
  if (const Entry* viewpoint = entries.Find("VIEWPOINT", this->Layout.Sensor.size()))
  {
    for (std::size_t i = 0; i < this->Layout.Sensor.size(); ++i)
    {
      if (dgg::ParseNumber(viewpoint->Values[i], this->Layout.Sensor[i]) ||
        !std::isfinite(this->Layout.Sensor[i]))
      {
        viewpoint->FailAt(i, " is not a finite number");
      }
    }
  }
  const Entry& data = entries.Get("DATA");
  const auto* name = std::find(std::begin(DataNames), std::end(DataNames),
    data.Values.size() == 1 ? data.Values[0] : std::string_view());
  if (name == std::end(DataNames))
  {
    data.Fail("the value of DATA is unknown. Expected ascii, binary or binary_compressed");
  }
  this->Data = static_cast<PCDData>(name - std::begin(DataNames));
}

std::string dgg::PCDHeader::Format() const
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
  for (const double value : this->Layout.Sensor)
  {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
    sensor += " " + std::string(buffer, end.ptr);
  }
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" +
    sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " +
    std::to_string(this->Layout.Width) + "\nHEIGHT " + std::to_string(this->Layout.Height) +
    "\nVIEWPOINT" + sensor + "\nPOINTS " + std::to_string(this->GetNumberOfPoints()) + "\nDATA " +
    DataNames[static_cast<int>(this->Data)] + "\n";
}

bool dgg::LooksLikePCD(std::string_view begin)
{
  dgg::TextCursor text(begin, {});
  bool hasFields = false;
  std::string_view keyword;
  while (keyword != "DATA")
  {
    const std::vector<std::string_view> words = TakeLine(text);
    if (words.empty())
    {
      break;
    }
    keyword = words[0];
    const bool isWhole = text.GetRest().find('\n') != std::string_view::npos;
    if (!IsKeyword(keyword))
    {
      return hasFields && !isWhole; // the last line may be truncated
    }
    hasFields = hasFields || keyword == "FIELDS" || keyword == "COLUMNS";
  }
  return hasFields;
}
