// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCounted.h"
#include "dggParsers.h"
#include "dggWriters.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace
{
using dgg::FileCode;
using dgg::Quote;

constexpr dgg::TextRules Rules{ true, false, false, false, false };
constexpr std::size_t HeaderBytes = 84;
constexpr std::size_t FacetBytes = 50;
/// Number of leading bytes that are searched for a zero byte, which only binary files contain
constexpr std::size_t TextBytes = 512;

/// Finds equal points by a hash table with open addressing.
class PointMerger
{
public:
  explicit PointMerger(std::vector<double>& points)
    : Points(points)
    , Table(1024, -1)
  {
  }

  /// Returns the id of the point, which is added if it is new.
  std::int64_t Add(const double (&coordinates)[3])
  {
    const double p[] = { coordinates[0] + 0.0, coordinates[1] + 0.0,
      coordinates[2] + 0.0 }; // replaces -0 by 0
    const std::int64_t count = static_cast<std::int64_t>(this->Points.size() / 3);
    if (2 * static_cast<std::size_t>(count) >= this->Table.size())
    {
      this->Grow();
    }
    std::int64_t& id = this->Table[this->FindSlot(p)];
    if (id < 0)
    {
      id = count;
      this->Points.insert(this->Points.end(), p, p + 3);
    }
    return id;
  }

private:
  /// Returns the slot of the point with the same bits, or an empty one.
  std::size_t FindSlot(const double* p) const
  {
    std::uint64_t hash = 0;
    for (int c = 0; c < 3; ++c)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, p + c, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (this->Table.size() - 1);
    while (this->Table[slot] >= 0 &&
      std::memcmp(this->Points.data() + 3 * this->Table[slot], p, 3 * sizeof(double)) != 0)
    {
      slot = (slot + 1) & (this->Table.size() - 1);
    }
    return slot;
  }

  void Grow()
  {
    this->Table.assign(2 * this->Table.size(), -1);
    for (std::size_t i = 0; i < this->Points.size() / 3; ++i)
    {
      this->Table[this->FindSlot(this->Points.data() + 3 * i)] = static_cast<std::int64_t>(i);
    }
  }

  std::vector<double>& Points;
  std::vector<std::int64_t> Table; ///< ids by slot; -1 if empty
};

/// Returns the number of facets in the header of a binary file.
std::size_t GetFacetCount(std::string_view file)
{
  std::size_t count = 0;
  for (std::size_t i = HeaderBytes; i > HeaderBytes - 4; --i)
  {
    count = count << 8 | static_cast<unsigned char>(file[i - 1]);
  }
  return count;
}

bool IsKeyword(std::string_view word, std::string_view keyword)
{
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
    [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

bool HasZero(std::string_view file)
{
  return file.substr(0, TextBytes).find('\0') != std::string_view::npos;
}

/// Returns true if the file begins as a text. Headers of binary files may begin with solid, too.
bool IsText(std::string_view file)
{
  dgg::TextCursor text(file, Rules);
  return text.FindAnywhere() && IsKeyword(text.TakeWord(), "solid") && !HasZero(file);
}

bool HasBinarySize(std::string_view file)
{
  return file.size() >= HeaderBytes &&
    file.size() == HeaderBytes + FacetBytes * GetFacetCount(file);
}

void ParseBinary(std::string_view file, const dgg::ProgressReport& progress, dgg::MeshData& mesh)
{
  if (file.size() < HeaderBytes)
  {
    dgg::Fail(FileCode::Premature, "byte ", file.size(), ": the file ends inside the header of ",
      HeaderBytes, " bytes");
  }
  const std::size_t facets = GetFacetCount(file);
  const std::size_t expected = HeaderBytes + FacetBytes * facets;
  if (file.size() != expected)
  {
    dgg::Fail(file.size() < expected ? FileCode::Premature : FileCode::Malformed,
      "byte 80: the header declares ", dgg::Counted(facets, "triangle"), ", ", expected,
      " bytes in all, but the file has ", file.size(), " bytes");
  }
  mesh.HasFloatPoints = true;
  PointMerger merger(mesh.Points);
  for (std::size_t i = 0; i < facets; ++i)
  {
    progress.At(i, facets);
    const char* corner = file.data() + HeaderBytes + FacetBytes * i + 12; // after the normal
    for (int k = 0; k < 3; ++k, corner += 12)
    {
      double p[3];
      for (int c = 0; c < 3; ++c)
      {
        std::uint32_t bits = 0;
        for (int b = 3; b >= 0; --b)
        {
          bits = bits << 8 | static_cast<unsigned char>(corner[4 * c + b]);
        }
        float value = 0.0f;
        std::memcpy(&value, &bits, sizeof(value));
        p[c] = static_cast<double>(value);
      }
      mesh.Polygons.Connectivity.push_back(merger.Add(p));
    }
    mesh.Polygons.EndCell();
  }
}

class TextParser
{
public:
  TextParser(std::string_view file, dgg::MeshData& mesh)
    : Text(file, Rules)
    , Mesh(mesh)
    , Merger(mesh.Points)
  {
  }

  /// Reads solids, one after the other.
  void Parse(const dgg::ProgressReport& progress)
  {
    std::size_t facets = 0;
    while (this->Text.FindAnywhere())
    {
      this->Expect({ "solid" });
      this->Text.SkipLine(); // skips the name of the solid
      while (!this->ExpectEither("facet", "endsolid"))
      {
        this->ReadFacet();
        progress.At(++facets, this->Text.GetFraction());
      }
      this->Text.SkipLine();
    }
  }

private:
  void ReadFacet()
  {
    this->Text.SkipLine(); // skips the normal
    this->Expect({ "outer", "loop" });
    for (int k = 0; k < 3; ++k)
    {
      this->Expect({ "vertex" });
      double p[3];
      for (double& coordinate : p)
      {
        const std::string_view word = this->TakeWord("a coordinate");
        if (const char* trouble = dgg::ParseNumber(word, coordinate))
        {
          this->Fail(Quote(word), " ", trouble);
        }
      }
      this->Mesh.Polygons.Connectivity.push_back(this->Merger.Add(p));
    }
    this->Mesh.Polygons.EndCell();
    this->Expect({ "endloop", "endfacet" });
  }

  void Expect(std::initializer_list<const char*> keywords)
  {
    for (const char* keyword : keywords)
    {
      this->ExpectEither(nullptr, keyword);
    }
  }
  /// Takes a keyword, and returns true if it is the second one.
  bool ExpectEither(const char* first, const char* second)
  {
    const std::string_view word = this->TakeWord(second);
    const bool isSecond = IsKeyword(word, second);
    if (!isSecond && !(first && IsKeyword(word, first)))
    {
      this->Fail(
        "expected ", first ? first : "", first ? " or " : "", second, ", got ", Quote(word));
    }
    return isSecond;
  }

  std::string_view TakeWord(const char* awaited)
  {
    if (!this->Text.FindAnywhere())
    {
      dgg::Fail(
        FileCode::Premature, "line ", this->Text.GetLine(), ": the file ends before ", awaited);
    }
    return this->Text.TakeWord();
  }

  template <typename... Parts>
  [[noreturn]] void Fail(const Parts&... parts) const
  {
    dgg::Fail(this->Text.GetBytesLeft() == 0 ? FileCode::Premature : FileCode::Malformed, "line ",
      this->Text.GetLine(), ": ", parts...);
  }

  dgg::TextCursor Text;
  dgg::MeshData& Mesh;
  PointMerger Merger;
};
}

bool dgg::LooksLikeSTL(std::string_view begin)
{
  return IsText(begin) || (begin.size() >= HeaderBytes && HasZero(begin));
}

void dgg::ParseSTL(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  if (!HasBinarySize(file) && IsText(file))
  {
    TextParser(file, mesh).Parse(progress);
  }
  else
  {
    ParseBinary(file, progress, mesh);
  }
}

void dgg::WriteSTL(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  const std::size_t count = mesh.Polygons.GetCount();
  if (count == 0 || count > UINT32_MAX)
  {
    Fail(FileCode::Malformed, "there are ", count, " triangles. Expected 1 to ", UINT32_MAX);
  }
  const auto isFloat = [](double value) {
    return !(static_cast<double>(static_cast<float>(value)) != value); // also true for NaN
  };
  const bool isBinary = std::all_of(mesh.Points.begin(), mesh.Points.end(), isFloat);
  if (isBinary)
  {
    const std::string title = "binary STL, written by vtkDGG";
    sink.Put(title + std::string(HeaderBytes - 4 - title.size(), ' '));
    sink.PutBytes(static_cast<std::uint32_t>(count));
  }
  else
  {
    sink.Put("solid vtkDGG\n");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* p[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] = mesh.Points.data() + 3 * mesh.Polygons.Connectivity[3 * i + k];
    }
    double normal[3];
    for (int c = 0; c < 3; ++c)
    {
      const int a = (c + 1) % 3;
      const int b = (c + 2) % 3;
      normal[c] =
        (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    sink.Put(isBinary ? "" : "facet normal");
    const auto put = [&](const double* vector, double divisor) {
      for (int c = 0; c < 3; ++c)
      {
        isBinary ? sink.PutBytes(static_cast<float>(vector[c] / divisor))
                 : sink.PutNumber(vector[c] / divisor);
      }
    };
    put(normal, length > 0.0 ? length : 1.0);
    sink.Put(isBinary ? "" : "\nouter loop");
    for (const double* corner : p)
    {
      sink.Put(isBinary ? "" : "\nvertex");
      put(corner, 1.0);
    }
    sink.Put(isBinary ? std::string_view("\0\0", 2) : "\nendloop\nendfacet\n");
    progress.At(i, count);
  }
  sink.Put(isBinary ? "" : "endsolid vtkDGG\n");
}
