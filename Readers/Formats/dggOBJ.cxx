// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCounted.h"
#include "dggParsers.h"
#include "dggWriters.h"

#include <algorithm>
#include <array>

namespace
{
using dgg::FileCode;
using dgg::Quote;

constexpr dgg::TextRules Rules{ true, true, false, true, false };

/// Values of all vt or vn statements, and the index of the value that each point uses.
struct PointVectors
{
  const char* Name;               ///< name in messages
  std::size_t Components;         ///< number of components stored
  std::vector<double> Values;     ///< by vector
  std::vector<std::int64_t> Used; ///< by point: its vector; -1 if there is none
  bool IsAmbiguous = false;       ///< true if a point uses vectors that differ

  std::int64_t GetCount() const
  {
    return static_cast<std::int64_t>(this->Values.size() / this->Components);
  }

  void Use(std::int64_t point, std::int64_t vector)
  {
    if (static_cast<std::size_t>(point) >= this->Used.size())
    {
      this->Used.resize(static_cast<std::size_t>(point) + 1, -1);
    }
    std::int64_t& used = this->Used[static_cast<std::size_t>(point)];
    this->IsAmbiguous = this->IsAmbiguous || (used >= 0 && !this->IsSame(used, vector));
    used = vector;
  }

  /// Adds an array if each point uses one vector.
  void Finish(const char* name, dgg::ArrayRole role, dgg::MeshData& mesh) const
  {
    if (this->IsAmbiguous || this->Used.empty() || this->Used.size() != mesh.GetNumberOfPoints() ||
      *std::min_element(this->Used.begin(), this->Used.end()) < 0)
    {
      return;
    }
    std::vector<double> values;
    for (const std::int64_t vector : this->Used)
    {
      const auto first = this->At(vector);
      values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(this->Components));
    }
    mesh.PointArrays.push_back({ name, static_cast<int>(this->Components), values, role });
  }

private:
  std::vector<double>::const_iterator At(std::int64_t vector) const
  {
    return this->Values.begin() + vector * static_cast<std::int64_t>(this->Components);
  }
  bool IsSame(std::int64_t a, std::int64_t b) const
  {
    // A forward reference counts as a different value.
    return a == b ||
      (std::max(a, b) < this->GetCount() &&
        std::equal(
          this->At(a), this->At(a) + static_cast<std::ptrdiff_t>(this->Components), this->At(b)));
  }
};

class OBJParser
{
public:
  OBJParser(std::string_view file, dgg::MeshData& mesh)
    : Text(file, Rules)
    , Mesh(mesh)
  {
  }

  void Parse(const dgg::ProgressReport& progress)
  {
    for (std::size_t i = 1; this->Text.FindAnywhere(); ++i)
    {
      this->ReadStatement();
      progress.At(i, this->Text.GetFraction());
    }
    const std::int64_t counts[] = { this->GetNumberOfPoints(), this->TCoords.GetCount(),
      this->Normals.GetCount() };
    for (int kind = 0; kind < 3; ++kind)
    {
      this->CheckLastId(kind, counts[kind]);
    }
    this->Normals.Finish("Normals", dgg::ArrayRole::Normals, this->Mesh);
    this->TCoords.Finish("TCoords", dgg::ArrayRole::TCoords, this->Mesh);
    this->FinishColors();
  }

private:
  /// Largest forward reference of the cells, and its line
  struct LaterId
  {
    std::int64_t Id = -1;
    std::size_t Line = 0;
  };

  std::int64_t GetNumberOfPoints() const
  {
    return static_cast<std::int64_t>(this->Mesh.GetNumberOfPoints());
  }

  void ReadStatement()
  {
    const std::string_view keyword = this->Text.TakeWord();
    if (keyword == "v")
    {
      this->ReadPoint();
    }
    else if (keyword == "vt")
    {
      this->ReadVector(this->TCoords, 1, 3);
    }
    else if (keyword == "vn")
    {
      this->ReadVector(this->Normals, 3, 3);
    }
    else if (keyword == "f")
    {
      this->ReadCell(this->Mesh.Polygons, "face", 3);
    }
    else if (keyword == "l")
    {
      this->ReadCell(this->Mesh.Lines, "line", 2);
    }
    else if (keyword == "p")
    {
      this->ReadVerts();
    }
    else
    {
      this->Text.SkipLine(); // skips groups, materials, curves
      return;
    }
    if (this->Text.FindOnLine())
    {
      this->Fail(
        Quote(this->Text.TakeWord()), " follows the last value of the statement ", Quote(keyword));
    }
  }

  /// Reads at most `most` numbers of this line and returns their number.
  std::size_t ReadNumbers(std::size_t most)
  {
    std::size_t count = 0;
    for (; count < most && this->Text.FindOnLine(); ++count)
    {
      const std::string_view word = this->Text.TakeWord();
      if (const char* trouble = dgg::ParseNumber(word, this->Numbers[count]))
      {
        this->Fail(Quote(word), " ", trouble);
      }
    }
    return count;
  }

  /// Reads a point: three coordinates, then a weight or a color, or both.
  void ReadPoint()
  {
    const std::size_t count = this->ReadNumbers(7);
    if (count < 3 || count == 5)
    {
      this->Fail("point ", this->GetNumberOfPoints(), " has ", count,
        " numbers. Expected 3 coordinates, optionally followed by a weight or a color");
    }
    this->Mesh.Points.insert(
      this->Mesh.Points.end(), this->Numbers.begin(), this->Numbers.begin() + 3);
    if (count >= 6)
    {
      this->Colors.insert(this->Colors.end(), this->Numbers.begin() + 3, this->Numbers.begin() + 6);
    }
  }

  void ReadVector(PointVectors& vectors, std::size_t least, std::size_t most)
  {
    this->Numbers = {};
    const std::size_t count = this->ReadNumbers(most);
    if (count < least)
    {
      this->Fail("the ", vectors.Name, " ", vectors.GetCount() + 1, " has ", count,
        " numbers. Expected ", least);
    }
    vectors.Values.insert(vectors.Values.end(), this->Numbers.begin(),
      this->Numbers.begin() + static_cast<std::ptrdiff_t>(vectors.Components));
  }

  void ReadCell(dgg::CellList& cells, const char* name, std::size_t least)
  {
    std::size_t corners = 0;
    for (; this->Text.FindOnLine(); ++corners)
    {
      cells.Connectivity.push_back(this->ReadCorner());
    }
    if (corners < least)
    {
      this->Fail(
        "the ", name, " has ", dgg::Counted(corners, "point"), ". Expected at least ", least);
    }
    cells.EndCell();
  }

  void ReadVerts()
  {
    while (this->Text.FindOnLine())
    {
      this->Mesh.Verts.Connectivity.push_back(this->ReadCorner());
      this->Mesh.Verts.EndCell();
    }
  }

  /// Reads v, v/vt, v//vn or v/vt/vn, and returns the id of the point.
  std::int64_t ReadCorner()
  {
    const std::string_view corner = this->Text.TakeWord();
    const std::int64_t counts[] = { this->GetNumberOfPoints(), this->TCoords.GetCount(),
      this->Normals.GetCount() };
    std::int64_t ids[] = { -1, -1, -1 };
    std::string_view rest = corner;
    for (int kind = 0; kind == 0 || !rest.empty(); ++kind)
    {
      const std::size_t length = std::min(rest.find('/'), rest.size());
      const std::string_view word = rest.substr(0, length);
      std::int64_t number = 0;
      if (kind == 3 || ((kind == 0 || !word.empty()) && dgg::ParseNumber(word, number)))
      {
        this->Fail(Quote(corner), " is not a corner. Expected v, v/vt, v//vn or v/vt/vn");
      }
      if (!word.empty())
      {
        ids[kind] = this->Resolve(kind, number, counts[kind]);
      }
      rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    PointVectors* const vectors[] = { nullptr, &this->TCoords, &this->Normals };
    for (int kind = 1; kind < 3; ++kind)
    {
      if (ids[kind] >= 0)
      {
        // Nothing is stored for a point that may not exist.
        vectors[kind]->IsAmbiguous = vectors[kind]->IsAmbiguous || ids[0] >= counts[0];
        vectors[kind]->Use(std::min(ids[0], counts[0]), ids[kind]);
      }
    }
    return ids[0];
  }

  /// Converts an index of the file (from 1, or negative and relative to the end) to an id from 0.
  std::int64_t Resolve(int kind, std::int64_t number, std::int64_t count)
  {
    const std::int64_t id = number > 0 ? number - 1 : count + number;
    if (id < 0 || number == 0)
    {
      this->FailId(this->Text.GetLine(), kind, number, count);
    }
    LaterId& later = this->Later[kind];
    if (id >= count && id > later.Id)
    {
      later = { id, this->Text.GetLine() };
    }
    return id;
  }

  void CheckLastId(int kind, std::int64_t count) const
  {
    if (this->Later[kind].Id >= count)
    {
      this->FailId(this->Later[kind].Line, kind, this->Later[kind].Id + 1, count);
    }
  }

  [[noreturn]] static void FailId(
    std::size_t line, int kind, std::int64_t number, std::int64_t count)
  {
    const char* const names[] = { "point", "texture coordinate", "normal" };
    dgg::Fail(FileCode::Malformed, "line ", line, ": the ", names[kind], " ", number,
      " is out of range: the file has ", dgg::Counted(count, names[kind]),
      number < 0 ? " before this line" : "", ", numbered from 1");
  }

  /// Adds the colors, which are fractions of 1 or of 255. Any other numbers are not colors.
  void FinishColors()
  {
    if (this->Colors.empty() || this->Colors.size() != this->Mesh.Points.size())
    {
      return;
    }
    if (!std::all_of(this->Colors.begin(), this->Colors.end(),
          [](double value) { return value >= 0.0 && value <= 255.0; }))
    {
      return;
    }
    const double most = *std::max_element(this->Colors.begin(), this->Colors.end());
    const double scale = most > 1.0 ? 1.0 : 255.0;
    std::vector<std::uint8_t> bytes;
    for (const double value : this->Colors)
    {
      bytes.push_back(static_cast<std::uint8_t>(value * scale + 0.5));
    }
    this->Mesh.PointArrays.push_back({ "RGB", 3, bytes, dgg::ArrayRole::Colors });
  }

  template <typename... Parts>
  [[noreturn]] void Fail(const Parts&... parts) const
  {
    dgg::Fail(this->Text.GetBytesLeft() == 0 ? FileCode::Premature : FileCode::Malformed, "line ",
      this->Text.GetLine(), ": ", parts...);
  }

  dgg::TextCursor Text;
  dgg::MeshData& Mesh;
  std::array<double, 7> Numbers = {};
  std::vector<double> Colors;
  PointVectors TCoords{ "texture coordinate", 2, {}, {} };
  PointVectors Normals{ "normal", 3, {}, {} };
  LaterId Later[3]; ///< points, texture coordinates, normals
};
}

bool dgg::LooksLikeOBJ(std::string_view begin)
{
  TextCursor text(begin, Rules);
  if (!text.FindAnywhere())
  {
    return false;
  }
  const std::string_view keyword = text.TakeWord();
  constexpr const char* keywords[] = { "v", "vt", "vn", "vp", "g", "o", "s", "mtllib", "usemtl" };
  return std::find(std::begin(keywords), std::end(keywords), keyword) != std::end(keywords);
}

void dgg::ParseOBJ(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  OBJParser(file, mesh).Parse(progress);
  if (mesh.Points.empty())
  {
    Fail(FileCode::Malformed, "the file has no points (lines that begin with v)");
  }
  WarnOfOpenLine(file, mesh);
}

void dgg::WriteOBJ(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  RequirePoints(mesh);
  const std::size_t records = mesh.GetNumberOfPoints() + mesh.Verts.GetCount() +
    mesh.Lines.GetCount() + mesh.Polygons.GetCount();
  std::size_t record = 0;
  const DataArray* const normals = FindArray(mesh.PointArrays, ArrayRole::Normals);
  const DataArray* const tCoords = FindArray(mesh.PointArrays, ArrayRole::TCoords);
  const DataArray* const colors = FindArray(mesh.PointArrays, ArrayRole::Colors);
  for (std::size_t i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    sink.Put("v");
    for (std::size_t c = 0; c < 3; ++c)
    {
      sink.PutNumber(mesh.Points[3 * i + c]);
    }
    for (int c = 0; colors && c < 3; ++c)
    {
      const auto& values = std::get<std::vector<std::uint8_t>>(colors->Values);
      sink.PutNumber(values[i * static_cast<std::size_t>(colors->Components) + c] / 255.0);
    }
    sink.Put("\n");
    for (const DataArray* vectors : { tCoords, normals })
    {
      if (vectors)
      {
        sink.Put(vectors == tCoords ? "vt" : "vn");
        sink.PutNumbers(*vectors, i);
        sink.Put("\n");
      }
    }
    progress.At(record++, records);
  }
  for (const CellList* cells : { &mesh.Verts, &mesh.Lines, &mesh.Polygons })
  {
    for (std::size_t i = 0; i < cells->GetCount(); ++i)
    {
      const std::int64_t size = cells->Offsets[i + 1] - cells->Offsets[i];
      const bool isVert = cells == &mesh.Verts || size == 1;
      const bool isLine = !isVert && (cells == &mesh.Lines || size == 2);
      sink.Put(isVert ? "p" : isLine ? "l" : "f");
      for (std::int64_t k = cells->Offsets[i]; k < cells->Offsets[i + 1]; ++k)
      {
        const std::string id = std::to_string(cells->Connectivity[static_cast<std::size_t>(k)] + 1);
        sink.Put(" " + id);
        if (!isVert && !isLine && (tCoords || normals))
        {
          sink.Put("/" + (tCoords ? id : "") + (normals ? "/" + id : ""));
        }
      }
      sink.Put("\n");
      progress.At(record++, records);
    }
  }
}
