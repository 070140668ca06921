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

/// Reads lines that begin with three numbers, behind a count or a line of words.
void Parse(dgg::TextCursor& text, const dgg::ProgressReport& progress, std::vector<double>& points)
{
  bool isFirst = true;
  for (std::size_t i = 1; text.FindAnywhere(); ++i)
  {
    double p[3] = {};
    std::size_t words = 0;
    std::size_t numbers = 0;
    bool isCount = false;
    std::string_view wrong;
    for (; text.FindOnLine(); ++words)
    {
      const std::string_view word = text.TakeWord();
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
        wrong.empty() ? std::to_string(words) + " numbers" : dgg::Quote(wrong) + " is not a number",
        ", expected the coordinates x, y and z");
    }
    if (!isHeader)
    {
      points.insert(points.end(), p, p + 3);
    }
    if (i % dgg::ProgressInterval == 0)
    {
      progress(text.GetFraction());
    }
  }
}
}

bool dgg::LooksLikeXYZ(std::string_view begin)
{
  const std::size_t end = begin.find_last_of("\r\n"); // the last line may be cut
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
  Parse(text, progress, mesh.Points);
  if (mesh.Points.empty())
  {
    Fail(FileCode::Malformed, "the file has no points");
  }
  AddVertsOfFinitePoints(mesh);
  WarnOfOpenLine(file, mesh);
}

void dgg::WriteXYZ(const MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  for (std::size_t i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sink.PutNumber(mesh.Points[3 * i + c]);
    }
    sink.Put("\n");
    if (i % ProgressInterval == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(mesh.GetNumberOfPoints()));
    }
  }
}
