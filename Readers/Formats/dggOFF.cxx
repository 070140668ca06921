// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCounted.h"
#include "dggParsers.h"
#include "dggWriters.h"

#include <algorithm>
#include <cstring>

namespace
{
using dgg::FileCode;

constexpr dgg::TextRules Rules{ true, true, false, false, false };
/// Gray level of faces without a color in files with face colors (geomview's default)
constexpr float DefaultGray = 170.0f;

constexpr auto Malformed = FileCode::Malformed;
constexpr auto Premature = FileCode::Premature;

/// Returns true if the word is one or more digits.
bool IsCount(std::string_view word)
{
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

struct RestNumber
{
  double Value;
  bool IsFraction;
};

/// Colors of all vertices or faces. They are fractions of 1 if any component of the file has a
/// decimal point or an exponent, or none exceeds 1; otherwise integers up to 255.
struct Colors
{
  std::vector<float> Values; ///< four per record; red is negative if the record has no color
  bool IsUsed = false;
  bool HasAlpha = false;
  bool SawFraction = false;
  std::size_t LocationAboveOne = 0; ///< line or byte of the first component above 1; 0 if none

  /// Adds the color of the next record, the first `count` numbers.
  void Add(const std::vector<RestNumber>& numbers, std::size_t count, std::size_t location)
  {
    float color[4] = { -1.0f, 0.0f, 0.0f, -1.0f };
    for (std::size_t i = 0; i < count; ++i)
    {
      color[i] = static_cast<float>(numbers[i].Value);
      this->SawFraction = this->SawFraction || numbers[i].IsFraction;
      if (color[i] > 1.0f && this->LocationAboveOne == 0)
      {
        this->LocationAboveOne = location;
      }
    }
    this->IsUsed = this->IsUsed || count > 0;
    this->HasAlpha = this->HasAlpha || count == 4;
    this->Values.insert(this->Values.end(), color, color + 4);
  }

  /// Returns the colors of the records, in [0, 255].
  dgg::DataArray MakeArray() const
  {
    const int components = this->HasAlpha ? 4 : 3;
    const float scale = this->LocationAboveOne > 0 ? 1.0f : 255.0f;
    std::vector<std::uint8_t> bytes;
    for (auto value = this->Values.begin(); value != this->Values.end(); value += 4)
    {
      for (int c = 0; c < components; ++c)
      {
        const bool isOpaque = c == 3 && value[3] < 0.0f;
        const float scaled = value[0] < 0.0f ? DefaultGray : value[c] * scale;
        bytes.push_back(isOpaque ? 255 : static_cast<std::uint8_t>(scaled + 0.5f));
      }
    }
    return { components == 4 ? "RGBA" : "RGB", components, bytes, dgg::ArrayRole::Colors };
  }
};

/// Reads text and binary files. Throws dgg::FileError.
class OFFParser
{
public:
  OFFParser(std::string_view file, dgg::MeshData& mesh)
    : File(file)
    , Text(file, Rules)
    , Mesh(mesh)
    , Faces(mesh)
  {
  }

  /// Reads [ST][C][N][4][n]OFF, the prefixes in any order. 4 and n declare points of other
  /// dimensions than three. Lower case, a missing keyword and a count that follows without a blank
  /// are tolerated. Returns true if there is a keyword.
  bool ReadKeyword()
  {
    this->Awaited = "the keyword OFF";
    const dgg::TextCursor before = this->Text;
    const std::string_view word = this->TakeWord();
    if (IsCount(word))
    {
      this->Text = before;
      return false;
    }
    std::string keyword(word.substr(0, word.find_last_not_of("0123456789") + 1));
    if (std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
    {
      std::transform(keyword.begin(), keyword.end(), keyword.begin(),
        [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    }
    const std::size_t length = keyword.size() < 3 ? 0 : keyword.size() - 3;
    std::string prefix = keyword.substr(0, length);
    const auto take = [&prefix](std::string_view letters) {
      const std::size_t location = prefix.find(letters);
      if (location != std::string::npos)
      {
        prefix.replace(location, letters.size(), " "); // "SCT" does not become "ST"
      }
      return location != std::string::npos;
    };
    this->HasTCoords = take("ST");
    this->HasColors = take("C");
    this->HasNormals = take("N");
    const bool isHomogeneous = take("4");
    const bool isOfAnyDimension = take("n");
    if (keyword.substr(length) != "OFF" || prefix.find_first_not_of(' ') != std::string::npos)
    {
      this->Fail(FileCode::Unrecognized, dgg::Quote(word),
        " is not the keyword of an OFF file. Expected OFF, optionally with the prefixes ST, C, N");
    }
    if (isHomogeneous || isOfAnyDimension)
    {
      this->Fail(FileCode::Unrecognized, dgg::Quote(word),
        " declares points of a dimension other than three. Convert the file to OFF");
    }
    if (keyword.size() < word.size())
    {
      this->Text = before;
      this->Text.FindAnywhere();
      this->Text.Skip(keyword.size());
      return true;
    }
    const dgg::TextCursor after = this->Text;
    this->IsBinary = this->Text.FindOnLine() && this->Text.TakeWord() == "BINARY";
    if (this->IsBinary)
    {
      this->Text.SkipLine();
    }
    else
    {
      this->Text = after;
    }
    return true;
  }

  /// Reads counts, vertices and faces.
  void ReadData(const dgg::ProgressReport& progress)
  {
    this->ReadCounts();
    this->Mesh.HasFloatPoints = this->IsBinary;
    for (std::size_t i = 0; i < this->NumberOfVertices + this->NumberOfFaces; ++i)
    {
      progress.At(i, this->Text.GetFraction());
      if (i < this->NumberOfVertices)
      {
        this->ReadVertex(i);
      }
      else
      {
        this->ReadFace(i - this->NumberOfVertices);
      }
    }
    this->ReadEnd();
    if (!this->IsBinary)
    {
      dgg::WarnOfOpenLine(this->File, this->Mesh);
    }
    this->MakeOutput();
  }

private:
  void ReadCounts()
  {
    this->Awaited = "the number of vertices";
    const long long vertices = this->ReadInteger();
    this->Awaited = "the number of faces";
    const long long faces = this->ReadInteger();
    this->Awaited = "the number of edges";
    // Some text files lack the number of edges, which is not used. It follows on the same line or
    // is alone on the next one.
    if (this->IsBinary || this->Text.FindOnLine())
    {
      this->ReadInteger();
      if (!this->IsBinary && this->Text.FindOnLine())
      {
        this->Fail(
          Malformed, "the header has more than the three counts of vertices, faces and edges");
      }
    }
    else
    {
      const dgg::TextCursor after = this->Text;
      long long edges = 0;
      if (!this->Text.FindAnywhere() || dgg::ParseNumber(this->Text.TakeWord(), edges) ||
        this->Text.FindOnLine())
      {
        this->Text = after;
      }
    }
    if (vertices < 0 || faces < 0)
    {
      this->Fail(Malformed, "the header declares ", vertices, " vertices and ", faces,
        " faces. Expected non-negative numbers");
    }
    // Nothing is allocated before the counts are compared with the fewest bytes: in text a digit
    // and a blank or line end for each number, and the last line may lack its end.
    const auto colors = static_cast<std::size_t>(this->HasColors ? (this->IsBinary ? 4 : 3) : 0);
    const std::size_t perVertex = this->GetLeastBytes() *
      (3 + (this->HasNormals ? 3 : 0) + colors + (this->HasTCoords ? 2 : 0));
    const std::size_t perFace = this->IsBinary ? 12 : 4;
    const std::size_t room = this->Text.GetBytesLeft() + 1;
    const auto v = static_cast<std::size_t>(vertices);
    const auto f = static_cast<std::size_t>(faces);
    if (v > room / perVertex || f > room / perFace || v * perVertex + f * perFace > room)
    {
      this->Fail(Premature, "the header declares ", dgg::Counted(v, "vertex", "vertices"), " and ",
        dgg::Counted(f, "face"), ", but only ", room - 1, " bytes follow");
    }
    this->NumberOfVertices = v;
    this->NumberOfFaces = f;
  }

  void ReadVertex(std::size_t vertex)
  {
    this->Awaited = "the end of vertex ";
    this->Record = vertex;
    for (int i = 0; i < 3; ++i)
    {
      this->Mesh.Points.push_back(this->ReadNumber());
    }
    for (int i = 0; this->HasNormals && i < 3; ++i)
    {
      this->Normals.push_back(this->ReadNumber());
    }
    const std::size_t tCoords = this->HasTCoords ? 2 : 0;
    this->ReadRest((this->HasColors ? 4 : 0) + tCoords);
    const std::size_t rest = this->Rest.size();
    // Some programs write colors without the prefix C.
    this->HasColors =
      this->HasColors || (vertex == 0 && (rest == tCoords + 3 || rest == tCoords + 4));
    if (this->HasColors ? rest != tCoords + 3 && rest != tCoords + 4 : rest != tCoords)
    {
      this->Fail(rest == 0 && this->Text.GetBytesLeft() == 0 ? Premature : Malformed, "vertex ",
        vertex, " has ", rest, " numbers after its coordinates",
        this->HasNormals ? " and normal" : "", ". Expected ",
        this->HasColors ? "3 or 4 of a color" : "none of a color",
        this->HasTCoords ? " and 2 texture coordinates" : "");
    }
    if (this->HasColors)
    {
      this->AddColor(this->PointColors, rest - tCoords);
    }
    for (std::size_t i = 0; i < tCoords; ++i)
    {
      this->TCoords.push_back(this->Rest[rest - tCoords + i].Value);
    }
  }

  void ReadFace(std::size_t face)
  {
    this->Awaited = "the end of face ";
    this->Record = face;
    const long long corners = this->ReadInteger();
    if (corners < 1)
    {
      this->Fail(Malformed, "face ", face, " has ", corners, " vertices. Expected at least 1");
    }
    if (static_cast<std::size_t>(corners) > (this->Text.GetBytesLeft() + 1) / this->GetLeastBytes())
    {
      this->Fail(Premature, "face ", face, " declares ",
        dgg::Counted(corners, "vertex", "vertices"), ", but only ", this->Text.GetBytesLeft(),
        " bytes follow");
    }
    this->Corners.clear();
    for (long long k = 0; k < corners; ++k)
    {
      const long long vertex = this->ReadInteger();
      if (vertex < 0 || vertex >= static_cast<long long>(this->NumberOfVertices))
      {
        this->Fail(Malformed, "face ", face, " refers to vertex ", vertex, ", but the file has ",
          dgg::Counted(this->NumberOfVertices, "vertex", "vertices"), ", numbered from 0");
      }
      this->Corners.push_back(vertex);
    }
    this->Faces.Add(this->Corners);

    if (!this->IsBinary)
    {
      this->ReadRest(0);
    }
    const long long count =
      this->IsBinary ? this->ReadInteger() : static_cast<long long>(this->Rest.size());
    if (count < 0 || count == 2 || count > 4)
    {
      this->Fail(Malformed, "face ", face, " has ", count,
        " numbers after its vertices. Expected none, 1 (an index of a color) or 3 or 4 (a "
        "color)");
    }
    if (this->IsBinary && count == 1)
    {
      this->ReadInteger();
    }
    else if (this->IsBinary)
    {
      this->ReadRest(static_cast<std::size_t>(count));
    }
    // A single number is an index into a table of colors that is not in the file.
    this->AddColor(this->FaceColors, count == 1 ? 0 : static_cast<std::size_t>(count));
  }

  void ReadEnd()
  {
    if (!this->IsBinary && this->Text.FindAnywhere())
    {
      this->Fail(Malformed, dgg::Quote(this->Text.TakeWord()),
        " follows the last face. Correct the counts of the header");
    }
    const std::size_t rest = this->Text.GetRest().find_first_not_of(" \t\n\v\f\r");
    if (rest != std::string_view::npos)
    {
      this->Text.Skip(rest);
      this->Fail(Malformed, this->Text.GetBytesLeft(),
        " bytes follow the last face. Correct the counts of the header");
    }
    for (const Colors* colors : { &this->PointColors, &this->FaceColors })
    {
      if (colors->SawFraction && colors->LocationAboveOne > 0)
      {
        this->FailAt(colors->LocationAboveOne, Malformed,
          "a color component is above 1, but others of the file are fractions of 1");
      }
    }
  }

  void MakeOutput()
  {
    std::vector<dgg::DataArray>& arrays = this->Mesh.PointArrays;
    if (this->HasNormals)
    {
      arrays.push_back({ "Normals", 3, std::move(this->Normals), dgg::ArrayRole::Normals });
    }
    if (this->HasTCoords)
    {
      arrays.push_back({ "TCoords", 2, std::move(this->TCoords), dgg::ArrayRole::TCoords });
    }
    if (this->HasColors)
    {
      arrays.push_back(this->PointColors.MakeArray());
    }
    if (this->FaceColors.IsUsed)
    {
      this->Mesh.CellArrays.push_back(this->FaceColors.MakeArray());
      this->Faces.Sort(this->Mesh.CellArrays.back());
    }
  }

  void AddColor(Colors& colors, std::size_t count) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = this->Rest[i].Value;
      if (!(value >= 0.0 && value <= (this->Rest[i].IsFraction ? 1.0 : 255.0)))
      {
        this->Fail(Malformed, "the color component ", value,
          " is out of range. Use fractions from 0 to 1 or integers from 0 to 255, or the keyword "
          "NOFF if these numbers are normals");
      }
    }
    colors.Add(this->Rest, count, this->GetLocation());
  }

  double ReadNumber()
  {
    if (!this->IsBinary)
    {
      return this->ToNumber(this->TakeWord());
    }
    const std::uint32_t bits = this->ReadBits();
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof(value));
    return static_cast<double>(value);
  }

  long long ReadInteger()
  {
    if (this->IsBinary)
    {
      return static_cast<std::int32_t>(this->ReadBits());
    }
    const std::string_view word = this->TakeWord();
    long long value = 0;
    if (const char* trouble = dgg::ParseNumber(word, value))
    {
      this->Fail(Malformed, dgg::Quote(word), " ", trouble);
    }
    return value;
  }

  /// Reads the remaining numbers of the line, or `countIfBinary` numbers of a binary file, into
  /// Rest.
  void ReadRest(std::size_t countIfBinary)
  {
    this->Rest.clear();
    while (this->IsBinary && this->Rest.size() < countIfBinary)
    {
      this->Rest.push_back({ this->ReadNumber(), true });
    }
    while (!this->IsBinary && this->Text.FindOnLine())
    {
      const std::string_view word = this->Text.TakeWord();
      const bool isFraction = word.find_first_of(".eE") != std::string_view::npos;
      this->Rest.push_back({ this->ToNumber(word), isFraction });
    }
  }

  /// Reads four bytes, most significant first.
  std::uint32_t ReadBits()
  {
    if (this->Text.GetBytesLeft() < 4)
    {
      this->FailEnd();
    }
    std::uint32_t bits = 0;
    for (const char byte : this->Text.GetRest().substr(0, 4))
    {
      bits = bits << 8 | static_cast<unsigned char>(byte);
    }
    this->Text.Skip(4);
    return bits;
  }

  std::string_view TakeWord()
  {
    if (!this->Text.FindAnywhere())
    {
      this->FailEnd();
    }
    return this->Text.TakeWord();
  }

  double ToNumber(std::string_view word) const
  {
    double value = 0.0;
    if (const char* trouble = dgg::ParseNumber(word, value))
    {
      this->Fail(Malformed, dgg::Quote(word), " ", trouble);
    }
    return value;
  }

  /// Returns the smallest size of a number: a digit and a blank in text, four bytes in binary
  /// files.
  std::size_t GetLeastBytes() const { return this->IsBinary ? 4 : 2; }
  std::size_t GetLocation() const
  {
    return this->IsBinary ? this->Text.GetByte() : this->Text.GetLine();
  }
  template <typename... Parts>
  [[noreturn]] void Fail(FileCode code, const Parts&... parts) const
  {
    this->FailAt(this->GetLocation(), code, parts...);
  }
  template <typename... Parts>
  [[noreturn]] void FailAt(std::size_t location, FileCode code, const Parts&... parts) const
  {
    dgg::Fail(code, this->IsBinary ? "byte " : "line ", location, ": ", parts...);
  }
  [[noreturn]] void FailEnd() const
  {
    this->Fail(Premature, "the file ends before ", this->Awaited,
      this->Record == NoRecord ? "" : std::to_string(this->Record));
  }

  static constexpr std::size_t NoRecord = SIZE_MAX;

  const std::string_view File;
  dgg::TextCursor Text;
  dgg::MeshData& Mesh;
  const char* Awaited = "";      ///< value that is being read, for messages
  std::size_t Record = NoRecord; ///< index of the vertex or face that is being read
  bool IsBinary = false;
  bool HasTCoords = false;
  bool HasColors = false;
  bool HasNormals = false;
  std::size_t NumberOfVertices = 0;
  std::size_t NumberOfFaces = 0;
  std::vector<double> Normals;
  std::vector<double> TCoords;
  Colors PointColors;
  Colors FaceColors;
  dgg::FaceSorter Faces;
  std::vector<std::int64_t> Corners; ///< corners of the current face
  std::vector<RestNumber> Rest;      ///< remaining numbers of the current record
};

/// Puts colors as fractions of 1, as geomview defines them.
void PutColor(dgg::FileSink& sink, const dgg::DataArray& colors, std::size_t i)
{
  const auto components = static_cast<std::size_t>(colors.Components);
  const auto& values = std::get<std::vector<std::uint8_t>>(colors.Values);
  for (std::size_t c = 0; c < components; ++c)
  {
    sink.PutNumber(values[i * components + c] / 255.0f);
  }
}
}

bool dgg::LooksLikeOFF(std::string_view begin)
{
  MeshData mesh;
  try
  {
    return OFFParser(begin, mesh).ReadKeyword();
  }
  catch (const FileError&)
  {
    return false;
  }
}

void dgg::ParseOFF(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  OFFParser parser(file, mesh);
  parser.ReadKeyword();
  parser.ReadData(progress);
}

void dgg::WriteOFF(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  const DataArray* const normals = FindArray(mesh.PointArrays, ArrayRole::Normals);
  const DataArray* const tCoords = FindArray(mesh.PointArrays, ArrayRole::TCoords);
  const DataArray* const colors = FindArray(mesh.PointArrays, ArrayRole::Colors);
  const DataArray* const cellColors = FindArray(mesh.CellArrays, ArrayRole::Colors);
  const std::size_t points = mesh.GetNumberOfPoints();
  // Each point of a vert is written as a face of one corner.
  const std::size_t faces =
    mesh.Verts.Connectivity.size() + mesh.Lines.GetCount() + mesh.Polygons.GetCount();
  sink.Put(std::string(tCoords ? "ST" : "") + (colors ? "C" : "") + (normals ? "N" : "") + "OFF\n");
  sink.Put(std::to_string(points) + " " + std::to_string(faces) + " 0\n");
  for (std::size_t i = 0; i < points; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sink.PutNumber(mesh.Points[3 * i + c]);
    }
    if (normals)
    {
      sink.PutNumbers(*normals, i);
    }
    if (colors)
    {
      PutColor(sink, *colors, i);
    }
    if (tCoords)
    {
      sink.PutNumbers(*tCoords, i);
    }
    sink.Put("\n");
    progress.At(i, points + faces);
  }
  std::size_t cell = 0;
  std::size_t face = 0;
  for (const CellList* list : { &mesh.Verts, &mesh.Lines, &mesh.Polygons })
  {
    for (std::size_t i = 0; i < list->GetCount(); ++i, ++cell)
    {
      const std::int64_t size = list->Offsets[i + 1] - list->Offsets[i];
      if (list == &mesh.Lines && size > 2)
      {
        Fail(Malformed,
          "an OFF file cannot store polylines of more than two points. Write an OBJ file");
      }
      const std::int64_t perFace = list == &mesh.Verts ? 1 : size;
      for (std::int64_t k = list->Offsets[i]; k < list->Offsets[i + 1]; k += perFace, ++face)
      {
        sink.PutNumber(perFace);
        for (std::int64_t corner = k; corner < k + perFace; ++corner)
        {
          sink.PutNumber(list->Connectivity[static_cast<std::size_t>(corner)]);
        }
        if (cellColors)
        {
          PutColor(sink, *cellColors, cell);
        }
        sink.Put("\n");
        progress.At(points + face, points + faces);
      }
    }
  }
}
