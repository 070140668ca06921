// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFReader.h"

#include "DGGFileLoader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace
{
/// Enough of a file to find its keyword behind comments.
constexpr std::size_t KeywordRange = 4096;
/// Records between two reports of progress.
constexpr vtkIdType ProgressInterval = 1 << 16;
/// Colour of faces that have none in a file where others do: geomview's default.
constexpr float DefaultGrey = 170.0f;

constexpr auto Malformed = vtkErrorCode::FileFormatError;
constexpr auto Unrecognized = vtkErrorCode::UnrecognizedFileTypeError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;

struct RestNumber
{
  double Value;
  bool IsFraction;
};

/// A column of colours. Files give them as fractions of 1 or as integers up to 255, and only the
/// whole file says which: any number with a decimal point or exponent, or no number above 1, means
/// fractions.
struct Colors
{
  std::vector<float> Values; ///< four per record; a negative red: no colour of its own
  bool IsUsed = false;
  bool HasAlpha = false;
  bool SawFraction = false;
  std::size_t PlaceAboveOne = 0; ///< of the first; 0 when there is none

  /// The first `count` numbers are the colour of the next record.
  void Add(const std::vector<RestNumber>& numbers, std::size_t count, std::size_t place)
  {
    float color[4] = { -1.0f, 0.0f, 0.0f, -1.0f };
    for (std::size_t i = 0; i < count; ++i)
    {
      color[i] = static_cast<float>(numbers[i].Value);
      this->SawFraction = this->SawFraction || numbers[i].IsFraction;
      if (color[i] > 1.0f && this->PlaceAboveOne == 0)
      {
        this->PlaceAboveOne = place;
      }
    }
    this->IsUsed = this->IsUsed || count > 0;
    this->HasAlpha = this->HasAlpha || count == 4;
    this->Values.insert(this->Values.end(), color, color + 4);
  }

  /// Colours of the records in the given order, in [0, 255].
  vtkNew<vtkUnsignedCharArray> MakeArray(const std::vector<vtkIdType>& order) const
  {
    const int components = this->HasAlpha ? 4 : 3;
    const float scale = this->PlaceAboveOne > 0 ? 1.0f : 255.0f;
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(components == 4 ? "RGBA" : "RGB");
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
    unsigned char* out = array->GetPointer(0);
    for (const vtkIdType record : order)
    {
      const float* value = this->Values.data() + 4 * record;
      for (int c = 0; c < components; ++c)
      {
        const bool isOpaque = c == 3 && value[3] < 0.0f;
        const float scaled = value[0] < 0.0f ? DefaultGrey : value[c] * scale;
        *out++ = isOpaque ? 255 : static_cast<unsigned char>(scaled + 0.5f);
      }
    }
    return array;
  }
};

/// Understands text and binary files. Throws vtkDGG::FileError.
class OFFParser
{
public:
  explicit OFFParser(std::string_view file)
    : Text(file, true)
  {
  }

  /// [ST][C][N][4][n]OFF, the prefixes in any order; 4 and n are points that are not in space.
  void ReadKeyword()
  {
    if (this->Text.GetBytesLeft() == 0)
    {
      this->Fail(Premature, "the file is empty");
    }
    this->Awaited = "the keyword OFF";
    const std::string_view keyword = this->TakeWord();
    const std::size_t length = keyword.size() < 3 ? 0 : keyword.size() - 3;
    std::string prefix(keyword.substr(0, length));
    const auto take = [&prefix](std::string_view letters) {
      const std::size_t place = prefix.find(letters);
      if (place != std::string::npos)
      {
        prefix.replace(place, letters.size(), " "); // "SCT" does not become "ST"
      }
      return place != std::string::npos;
    };
    this->HasTCoords = take("ST");
    this->HasColors = take("C");
    this->HasNormals = take("N");
    const bool isHomogeneous = take("4");
    const bool isOfAnyDimension = take("n");
    if (keyword.substr(length) != "OFF" || prefix.find_first_not_of(' ') != std::string::npos)
    {
      this->Fail(Unrecognized, vtkDGG::Quote(keyword),
        " is not the keyword of an OFF file: OFF, or OFF with the prefixes ST, C, N");
    }
    if (isHomogeneous || isOfAnyDimension)
    {
      this->Fail(Unrecognized, vtkDGG::Quote(keyword),
        " has points of four or any number of coordinates: only points in space can be read, "
        "convert the file to OFF");
    }
    const vtkDGG::TextCursor after = this->Text;
    this->IsBinary = this->Text.FindOnLine() && this->Text.TakeWord() == "BINARY";
    if (this->IsBinary)
    {
      this->Text.SkipLine();
    }
    else
    {
      this->Text = after;
    }
  }

  /// Read all that follows the keyword.
  void ReadData(const vtkDGG::FileProgress& progress, vtkPolyData* output)
  {
    this->ReadCounts();
    const auto prepare = [this](vtkDataArray* array, int components, bool isUsed) {
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(isUsed ? this->NumberOfVertices : 0);
    };
    prepare(this->Points, 3, true);
    prepare(this->Normals, 3, this->HasNormals);
    prepare(this->TCoords, 2, this->HasTCoords);
    this->Cells[2]->AllocateExact(this->NumberOfFaces, 3 * this->NumberOfFaces);
    const auto whole = static_cast<double>(this->Text.GetByte() + this->Text.GetBytesLeft() + 1);
    for (vtkIdType i = 0; i < this->NumberOfVertices + this->NumberOfFaces; ++i)
    {
      if (i % ProgressInterval == 0)
      {
        progress(static_cast<double>(this->Text.GetByte()) / whole);
      }
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
    this->MakeOutput(output);
  }

private:
  void ReadCounts()
  {
    this->Awaited = "the number of vertices";
    const long long vertices = this->ReadInteger();
    this->Awaited = "the number of faces";
    const long long faces = this->ReadInteger();
    this->Awaited = "the number of edges";
    // The number of edges says nothing, and some text files leave it out. It is there when it
    // follows on the same line, or stands alone on the next one.
    if (this->IsBinary || this->Text.FindOnLine())
    {
      this->ReadInteger();
      if (!this->IsBinary && this->Text.FindOnLine())
      {
        this->Fail(Malformed, "more than the three counts of vertices, faces and edges");
      }
    }
    else
    {
      const vtkDGG::TextCursor after = this->Text;
      long long edges = 0;
      if (!this->Text.FindAnywhere() || vtkDGG::ParseNumber(this->Text.TakeWord(), edges) ||
        this->Text.FindOnLine())
      {
        this->Text = after;
      }
    }
    if (vertices < 0 || faces < 0)
    {
      this->Fail(Malformed, "the counts must not be negative, but are ", vertices, " vertices and ",
        faces, " faces");
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
      this->Fail(Premature, "the file promises ", v, " vertices and ", f, " faces, but only ",
        room - 1, " bytes follow");
    }
    this->NumberOfVertices = static_cast<vtkIdType>(vertices);
    this->NumberOfFaces = static_cast<vtkIdType>(faces);
  }

  void ReadVertex(vtkIdType vertex)
  {
    this->Awaited = "the end of vertex ";
    this->Record = vertex;
    double* point = this->Points->GetPointer(3 * vertex);
    for (int i = 0; i < 3; ++i)
    {
      point[i] = this->ReadNumber();
    }
    for (int i = 0; this->HasNormals && i < 3; ++i)
    {
      this->Normals->SetValue(3 * vertex + i, static_cast<float>(this->ReadNumber()));
    }
    const std::size_t tCoords = this->HasTCoords ? 2 : 0;
    this->ReadRest((this->HasColors ? 4 : 0) + tCoords);
    const std::size_t rest = this->Rest.size();
    if (this->HasColors ? rest != tCoords + 3 && rest != tCoords + 4 : rest != tCoords)
    {
      this->Fail(rest == 0 && this->Text.GetBytesLeft() == 0 ? Premature : Malformed, "vertex ",
        vertex, " has ", rest, " numbers after its coordinates",
        this->HasNormals ? " and normal" : "", ", expected ",
        this->HasColors ? "3 or 4 of a colour" : "none of a colour",
        this->HasTCoords ? " and 2 texture coordinates" : "");
    }
    if (this->HasColors)
    {
      this->AddColor(this->PointColors, rest - tCoords);
    }
    for (std::size_t i = 0; i < tCoords; ++i)
    {
      this->TCoords->SetValue(2 * vertex + static_cast<vtkIdType>(i),
        static_cast<float>(this->Rest[rest - tCoords + i].Value));
    }
  }

  void ReadFace(vtkIdType face)
  {
    this->Awaited = "the end of face ";
    this->Record = face;
    const long long corners = this->ReadInteger();
    if (corners < 1)
    {
      this->Fail(Malformed, "face ", face, " has ", corners, " vertices: at least 1 is needed");
    }
    if (static_cast<std::size_t>(corners) > (this->Text.GetBytesLeft() + 1) / this->GetLeastBytes())
    {
      this->Fail(Premature, "face ", face, " promises ", corners, " vertices, but only ",
        this->Text.GetBytesLeft(), " bytes follow");
    }
    this->Corners.clear();
    for (long long k = 0; k < corners; ++k)
    {
      const long long vertex = this->ReadInteger();
      if (vertex < 0 || vertex >= this->NumberOfVertices)
      {
        this->Fail(Malformed, "face ", face, " names vertex ", vertex, ", but the file has ",
          this->NumberOfVertices, " vertices, numbered from 0");
      }
      this->Corners.push_back(static_cast<vtkIdType>(vertex));
    }
    const std::size_t kind = std::min<std::size_t>(this->Corners.size(), 3) - 1;
    this->Cells[kind]->InsertNextCell(static_cast<vtkIdType>(corners), this->Corners.data());
    this->Faces[kind].push_back(face);

    if (!this->IsBinary)
    {
      this->ReadRest(0);
    }
    const long long count =
      this->IsBinary ? this->ReadInteger() : static_cast<long long>(this->Rest.size());
    if (count < 0 || count == 2 || count > 4)
    {
      this->Fail(Malformed, "face ", face, " has ", count,
        " numbers after its vertices, expected none, 1 (an index of a colour) or 3 or 4 (a "
        "colour)");
    }
    if (this->IsBinary && count == 1)
    {
      this->ReadInteger();
    }
    else if (this->IsBinary)
    {
      this->ReadRest(static_cast<std::size_t>(count));
    }
    // A single number is an index into a table of colours that is not in the file.
    this->AddColor(this->FaceColors, count == 1 ? 0 : static_cast<std::size_t>(count));
  }

  void ReadEnd()
  {
    if (!this->IsBinary && this->Text.FindAnywhere())
    {
      this->Fail(Malformed, vtkDGG::Quote(this->Text.TakeWord()),
        " follows the last face: are the counts too small?");
    }
    const std::size_t rest = this->Text.GetRest().find_first_not_of(" \t\n\v\f\r");
    if (rest != std::string_view::npos)
    {
      this->Text.Skip(rest);
      this->Fail(Malformed, this->Text.GetBytesLeft(),
        " bytes follow the last face: are the counts too small?");
    }
    for (const Colors* colors : { &this->PointColors, &this->FaceColors })
    {
      if (colors->SawFraction && colors->PlaceAboveOne > 0)
      {
        this->FailAt(colors->PlaceAboveOne, Malformed,
          "a colour component is above 1, but others of the file are fractions of 1");
      }
    }
  }

  void MakeOutput(vtkPolyData* output)
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Points);
    output->SetPoints(points);
    vtkPointData* data = output->GetPointData();
    if (this->HasNormals)
    {
      this->Normals->SetName("Normals");
      data->SetNormals(this->Normals);
    }
    if (this->HasTCoords)
    {
      this->TCoords->SetName("TCoords");
      data->SetTCoords(this->TCoords);
    }
    if (this->HasColors)
    {
      std::vector<vtkIdType> order(static_cast<std::size_t>(this->NumberOfVertices));
      std::iota(order.begin(), order.end(), vtkIdType(0));
      data->SetScalars(this->PointColors.MakeArray(order));
    }
    if (!this->Faces[0].empty())
    {
      output->SetVerts(this->Cells[0]);
    }
    if (!this->Faces[1].empty())
    {
      output->SetLines(this->Cells[1]);
    }
    this->Cells[2]->Squeeze();
    output->SetPolys(this->Cells[2]);
    if (this->FaceColors.IsUsed)
    {
      // One kind of cells after the other, as vtkPolyData numbers them.
      std::vector<vtkIdType> order;
      for (const std::vector<vtkIdType>& faces : this->Faces)
      {
        order.insert(order.end(), faces.begin(), faces.end());
      }
      output->GetCellData()->SetScalars(this->FaceColors.MakeArray(order));
    }
  }

  void AddColor(Colors& colors, std::size_t count) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = this->Rest[i].Value;
      if (!(value >= 0.0 && value <= (this->Rest[i].IsFraction ? 1.0 : 255.0)))
      {
        this->Fail(Malformed, "the colour component ", value,
          " is out of range: fractions must be in [0, 1], integers in [0, 255]");
      }
    }
    colors.Add(this->Rest, count, this->GetPlace());
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
    if (!std::isfinite(value))
    {
      this->FailAt(this->GetPlace() - 4, Malformed, "a number before ", this->Awaited, this->Record,
        " is not finite");
    }
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
    if (const char* trouble = vtkDGG::ParseNumber(word, value))
    {
      this->Fail(Malformed, vtkDGG::Quote(word), " ", trouble);
    }
    return value;
  }

  /// The numbers left on this line; as many as given in binary files.
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

  /// Four bytes, the most significant one first.
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
    const char* trouble = vtkDGG::ParseNumber(word, value);
    if (trouble || !std::isfinite(value))
    {
      this->Fail(Malformed, vtkDGG::Quote(word), " ", trouble ? trouble : "is not finite");
    }
    return value;
  }

  /// Of a number: of the shortest text, a digit and a blank, or in binary files.
  std::size_t GetLeastBytes() const { return this->IsBinary ? 4 : 2; }
  std::size_t GetPlace() const
  {
    return this->IsBinary ? this->Text.GetByte() : this->Text.GetLine();
  }
  template <typename... Parts>
  [[noreturn]] void Fail(unsigned long code, const Parts&... parts) const
  {
    this->FailAt(this->GetPlace(), code, parts...);
  }
  template <typename... Parts>
  [[noreturn]] void FailAt(std::size_t place, unsigned long code, const Parts&... parts) const
  {
    vtkDGG::Fail(code, this->IsBinary ? "byte " : "line ", place, ": ", parts...);
  }
  [[noreturn]] void FailEnd() const
  {
    this->Fail(Premature, "the file ends before ", this->Awaited,
      this->Record < 0 ? "" : std::to_string(this->Record));
  }

  vtkDGG::TextCursor Text;
  const char* Awaited = ""; ///< what is being read, for messages
  vtkIdType Record = -1;    ///< its number; -1 when there is but one
  bool IsBinary = false;
  bool HasTCoords = false;
  bool HasColors = false;
  bool HasNormals = false;
  vtkIdType NumberOfVertices = 0;
  vtkIdType NumberOfFaces = 0;
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> TCoords;
  Colors PointColors;
  Colors FaceColors;
  vtkNew<vtkCellArray> Cells[3];   ///< vertices, lines, polygons
  std::vector<vtkIdType> Faces[3]; ///< of these cells
  std::vector<vtkIdType> Corners;  ///< of the current face
  std::vector<RestNumber> Rest;    ///< of the current record
};
}

vtkStandardNewMacro(vtkDGGOFFReader);

int vtkDGGOFFReader::CanReadFile(const char* fileName)
{
  try
  {
    const std::vector<char> bytes = vtkDGG::LoadFile(fileName ? fileName : "", KeywordRange);
    OFFParser({ bytes.data(), bytes.size() }).ReadKeyword();
    return 1;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkDGGOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto read = [](std::string_view file, const vtkDGG::FileProgress& progress,
                      vtkPolyData* output) {
    OFFParser parser(file);
    parser.ReadKeyword();
    parser.ReadData(progress, output);
  };
  this->SetErrorCode(vtkDGG::ReadFile(this, this->FileName, outputVector, read));
  return vtkDGG::GoesOn(this->ErrorCode, outputVector) ? 1 : 0;
}
