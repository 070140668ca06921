// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggParsers.h"
#include "dggPointCloud.h"
#include "dggWriters.h"

#include <algorithm>

namespace
{
using dgg::FileCode;

constexpr dgg::TextRules Rules{ true, true, true, false, true };

/// Returns true if commas in a line may be decimal points: "0,5 1,5 2,5" or "0,5;1,5;2,5".
bool HasAmbiguousCommas(std::string_view line)
{
  if (line.find(',') == line.npos || line.find(';') != line.npos)
  {
    return line.find(',') != line.npos;
  }
  bool hasBlanks = false; // as separators, without a comma
  bool hasTightCommas = false;
  char last = ' '; // last character that is not a blank
  bool isBehindBlank = false;
  for (const char c : line)
  {
    if (c == ' ' || c == '\t' || c == '\r')
    {
      isBehindBlank = true;
      continue;
    }
    hasBlanks = hasBlanks || (isBehindBlank && c != ',' && last != ',' && last != ' ');
    hasTightCommas = hasTightCommas || (!isBehindBlank && c != ',' && last == ',');
    last = c;
    isBehindBlank = false;
  }
  return hasBlanks && hasTightCommas;
}

/// Reads lines that begin with three numbers, after a count or a line of words. Returns the count;
/// -1 if there is none.
double Parse(
  dgg::TextCursor& text, const dgg::ProgressReport& progress, std::vector<double>& points)
{
  double count = -1.0;
  bool isFirst = true;
  for (std::size_t i = 1; text.FindAnywhere(); ++i)
  {
    double p[3] = {};
    std::size_t words = 0;
    std::size_t numbers = 0;
    bool isCount = false;
    std::string_view wrong;
    const std::string_view rest = text.GetRest();
    std::string_view line; // without a comment
    for (; text.FindOnLine(); ++words)
    {
      const std::string_view word = text.TakeWord();
      line = rest.substr(0, rest.size() - text.GetBytesLeft());
      double number = 0.0;
      if (words < 3 || (isFirst && numbers == 0))
      {
        const bool isNumber = !dgg::ParseNumber(word, number);
        isCount = word.find_first_not_of("0123456789") == std::string_view::npos;
        wrong = isNumber || !wrong.empty() ? wrong : word;
        numbers += isNumber ? 1 : 0;
        p[std::min<std::size_t>(words, 2)] = number;
      }
    }
    const bool isHeader = isFirst && (numbers == 0 || (words == 1 && isCount));
    isFirst = false;
    if (!isHeader && (words < 3 || !wrong.empty()))
    {
      dgg::Fail(text.GetBytesLeft() == 0 ? FileCode::Premature : FileCode::Malformed, "line ",
        text.GetLine(), ": ",
        wrong.empty() ? "the line has " + std::to_string(words) + " numbers"
                      : dgg::Quote(wrong) + " is not a number",
        ". Expected the coordinates x, y and z");
    }
    if (!isHeader && HasAmbiguousCommas(line))
    {
      dgg::Fail(FileCode::Malformed, "line ", text.GetLine(),
        ": ',' may separate numbers or be a decimal point. Use decimal points");
    }
    if (!isHeader)
    {
      points.insert(points.end(), p, p + 3);
    }
    else if (numbers > 0)
    {
      count = p[0];
    }
    progress.At(i, text.GetFraction());
  }
  return count;
}
}

bool dgg::LooksLikeXYZ(std::string_view begin)
{
  const std::size_t end = begin.find_last_of("\r\n"); // the last line may be truncated
  begin = begin.substr(0, std::min(end, begin.size()));
  TextCursor text(begin, Rules);
  std::vector<double> points;
  try
  {
    Parse(text, ProgressReport({}), points);
  }
  catch (const FileError&)
  {
    return false;
  }
  return !points.empty();
}

void dgg::ParseXYZ(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  TextCursor text(file, Rules);
  const double count = Parse(text, progress, mesh.Points);
  const auto points = static_cast<double>(mesh.GetNumberOfPoints());
  if (count >= 0.0 && count != points)
  {
    Fail(points < count ? FileCode::Premature : FileCode::Malformed,
      "the declared number of points is ", count, ", but the file has ", points);
  }
  if (mesh.Points.empty())
  {
    Fail(FileCode::Malformed, "the file has no points");
  }
  AddVertsOfFinitePoints(mesh);
  WarnOfOpenLine(file, mesh);
}

void dgg::WriteXYZ(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  RequirePoints(mesh);
  for (std::size_t i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sink.PutNumber(mesh.Points[3 * i + c]);
    }
    sink.Put("\n");
    progress.At(i, mesh.GetNumberOfPoints());
  }
}
