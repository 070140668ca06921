// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCounted.h"
#include "dggNumberTypes.h"
#include "dggParsers.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <iterator>

namespace
{
using dgg::ArrayRole;
using dgg::DataArray;
using dgg::FileCode;
using dgg::NumberType;
using dgg::Quote;

constexpr dgg::TextRules Rules{ true, false, false, false, false };
/// Limit of elements and properties of a header: VTK's search of arrays by name is linear, so the
/// time is quadratic.
constexpr std::size_t MaximumHeaderEntries = 10000;

struct TypeName
{
  const char* Name;
  const char* OtherName;
  NumberType Type;
};
constexpr TypeName TypeNames[] = { { "char", "int8", { 'I', 1 } }, { "uchar", "uint8", { 'U', 1 } },
  { "short", "int16", { 'I', 2 } }, { "ushort", "uint16", { 'U', 2 } },
  { "int", "int32", { 'I', 4 } }, { "uint", "uint32", { 'U', 4 } },
  { "float", "float32", { 'F', 4 } }, { "double", "float64", { 'F', 8 } } };

/// Purpose of the lists of a property.
enum class ListUse
{
  Skipped,
  Face,
  Strips
};

struct Property
{
  std::string Name;
  NumberType Type;
  bool IsList = false;
  NumberType CountType; ///< type of the lengths of lists
  ListUse Use = ListUse::Skipped;
  DataArray* Target = nullptr; ///< array that receives the values; null to skip them
  std::size_t Component = 0;   ///< component of the target
};

struct Element
{
  std::string Name;
  std::size_t Count = 0; ///< number of records
  std::size_t Line = 0;  ///< line of the header
  std::vector<Property> Properties;

  Property* Find(std::string_view name)
  {
    const auto found = std::find_if(this->Properties.begin(), this->Properties.end(),
      [name](const Property& property) { return property.Name == name; });
    return found == this->Properties.end() ? nullptr : &*found;
  }
};

class PLYParser
{
public:
  PLYParser(std::string_view file, dgg::MeshData& mesh)
    : File(file)
    , Text(file, Rules)
    , Mesh(mesh)
    , Faces(mesh)
  {
  }

  void Parse(const dgg::ProgressReport& progress)
  {
    this->ReadHeader();
    this->CheckCounts();
    for (Element& element : this->Elements)
    {
      this->SetTargets(element);
      this->Current = &element;
      for (this->Record = 0; this->Record < element.Count; ++this->Record)
      {
        progress.At(this->Record, this->Text.GetFraction());
        for (const Property& property : element.Properties)
        {
          property.IsList ? this->ReadList(property) : this->ReadNumber(property);
        }
      }
    }
    this->CheckRest();
    if (!this->IsBinary)
    {
      dgg::WarnOfOpenLine(this->File, this->Mesh);
    }
    this->Finish();
  }

private:
  void ReadHeader()
  {
    if (this->TakeWord() != "ply")
    {
      dgg::Fail(
        FileCode::Unrecognized, "line 1: the file does not begin with a line of the word ply");
    }
    std::string_view format;
    std::string_view keyword = "ply";
    while (keyword != "end_header")
    {
      this->Text.SkipLine();
      keyword = this->TakeWord();
      if (keyword == "format")
      {
        format = this->TakeWord();
      }
      else if (keyword == "element")
      {
        this->ReadElement();
      }
      else if (keyword == "property")
      {
        this->ReadProperty();
      }
      else if (keyword != "comment" && keyword != "obj_info" && keyword != "end_header")
      {
        this->Fail(Quote(keyword), " is not a keyword of the header");
      }
    }
    const bool isText = format == "ascii";
    this->IsBigEndian = format == "binary_big_endian";
    if (!isText && !this->IsBigEndian && format != "binary_little_endian")
    {
      this->Fail("the format ", Quote(format),
        " is unknown. Expected ascii, binary_little_endian or binary_big_endian");
    }
    this->Text.SkipLine();
    this->IsBinary = !isText;
  }

  void ReadElement()
  {
    Element element;
    element.Name = this->TakeWord();
    element.Line = this->Text.GetLine();
    const std::string_view count = this->TakeWord();
    if (dgg::ParseNumber(count, element.Count))
    {
      this->Fail(Quote(count), " is not a number of records of the element ", Quote(element.Name));
    }
    for (const Element& other : this->Elements)
    {
      if (other.Name == element.Name)
      {
        this->Fail("the header has a second element ", Quote(element.Name));
      }
    }
    this->Elements.push_back(std::move(element));
    this->CountEntry();
  }

  void ReadProperty()
  {
    if (this->Elements.empty())
    {
      this->Fail("a property precedes the first element");
    }
    Property property;
    std::string_view type = this->TakeWord();
    property.IsList = type == "list";
    if (property.IsList)
    {
      property.CountType = this->FindType(this->TakeWord(), true);
      type = this->TakeWord();
    }
    property.Name = this->TakeWord();
    // Only the first of two lists of this kind is used.
    const std::vector<Property>& others = this->Elements.back().Properties;
    const bool isFace = this->Elements.back().Name == "face" &&
      (property.Name == "vertex_indices" || property.Name == "vertex_index") &&
      std::none_of(others.begin(), others.end(),
        [](const Property& other) { return other.Use == ListUse::Face; });
    const bool isStrip =
      this->Elements.back().Name == "tristrips" && property.Name == "vertex_indices";
    if (property.IsList && (isFace || isStrip))
    {
      property.Use = isFace ? ListUse::Face : ListUse::Strips;
    }
    property.Type = this->FindType(type, property.Use != ListUse::Skipped);
    if (this->Elements.back().Find(property.Name))
    {
      this->Fail("the element has a second property ", Quote(property.Name));
    }
    this->Elements.back().Properties.push_back(property);
    this->CountEntry();
  }

  void CountEntry()
  {
    if (++this->HeaderEntries > MaximumHeaderEntries)
    {
      this->Fail("the header has more than ", MaximumHeaderEntries, " elements and properties");
    }
  }

  NumberType FindType(std::string_view name, bool isInteger) const
  {
    const auto* found = std::find_if(std::begin(TypeNames), std::end(TypeNames),
      [name](const TypeName& type) { return name == type.Name || name == type.OtherName; });
    if (found == std::end(TypeNames) || (isInteger && found->Type.Kind == 'F'))
    {
      this->Fail(Quote(name), " is not a type of ", isInteger ? "integers" : "numbers");
    }
    return found->Type;
  }

  /// Compares the numbers of records with the size of the file.
  void CheckCounts()
  {
    // The last number of a text may lack the blank after it.
    std::size_t room = this->Text.GetBytesLeft() + (this->IsBinary ? 0 : 1);
    for (Element& element : this->Elements)
    {
      std::size_t bytes = 0;
      for (const Property& property : element.Properties)
      {
        bytes += this->GetLeastBytes(property.IsList ? property.CountType : property.Type);
      }
      if (bytes == 0)
      {
        element.Count = 0; // records without values
      }
      else if (element.Count > room / bytes)
      {
        dgg::Fail(FileCode::Premature, "line ", element.Line, ": the header declares ",
          element.Count, " records of the element ", Quote(element.Name), " with at least ", bytes,
          " bytes each, but only ", room, " bytes follow for them");
      }
      room -= element.Count * bytes;
      if (element.Name == "vertex")
      {
        this->NumberOfPoints = static_cast<std::int64_t>(element.Count);
      }
      this->NumberOfFaces = element.Name == "face" ? element.Count : this->NumberOfFaces;
    }
  }

  /// Makes the arrays that receive the numbers of an element.
  void SetTargets(Element& element)
  {
    if (element.Name == "vertex")
    {
      this->SetPointTargets(element);
      const NumberType none{ ' ', 0 };
      this->SetRole(element, "Normals", ArrayRole::Normals, { "nx", "ny", "nz" }, none);
      this->SetRole(element, "TCoords", ArrayRole::TCoords, { "u", "v" }, none);
      this->SetRole(element, "TCoords", ArrayRole::TCoords, { "s", "t" }, none);
      this->SetRole(element, "TCoords", ArrayRole::TCoords, { "texture_u", "texture_v" }, none);
    }
    if (element.Name == "vertex" || element.Name == "face")
    {
      const NumberType byte{ 'U', 1 };
      this->SetRole(element, "RGBA", ArrayRole::Colors, { "red", "green", "blue", "alpha" }, byte);
      this->SetRole(element, "RGB", ArrayRole::Colors, { "red", "green", "blue" }, byte);
      for (Property& property : element.Properties)
      {
        if (!property.IsList && !property.Target)
        {
          this->AddTarget(element, property.Name, ArrayRole::None, { &property });
        }
      }
    }
  }

  void SetPointTargets(Element& element)
  {
    this->Points.Components = 3;
    this->Points.Values = dgg::MakeValues({ 'F', 8 }, 3 * element.Count);
    this->Mesh.HasFloatPoints = this->IsBinary;
    const char* const names[] = { "x", "y", "z" };
    for (std::size_t c = 0; c < 3; ++c)
    {
      Property* property = element.Find(names[c]);
      if (!property || property->IsList)
      {
        dgg::Fail(FileCode::Malformed, "line ", element.Line,
          ": the element 'vertex' has no property ", names[c]);
      }
      property->Target = &this->Points;
      property->Component = c;
      this->Mesh.HasFloatPoints = this->Mesh.HasFloatPoints && property->Type == NumberType();
    }
  }

  /// Joins properties to one array if all exist without a target and have one type: `type`, or any
  /// floating-point type if its size is 0. The first array of a role remains.
  void SetRole(Element& element, const char* name, ArrayRole role,
    std::initializer_list<const char*> names, const NumberType& type)
  {
    const std::deque<DataArray>& arrays = this->GetArrays(element);
    if (std::any_of(
          arrays.begin(), arrays.end(), [&](const DataArray& array) { return array.Role == role; }))
    {
      return;
    }
    std::vector<Property*> properties;
    for (const char* propertyName : names)
    {
      Property* property = element.Find(propertyName);
      if (!property || property->IsList || property->Target ||
        !(type.Size == 0 ? property->Type.Kind == 'F' : property->Type == type) ||
        !(properties.empty() || property->Type == properties[0]->Type))
      {
        return;
      }
      properties.push_back(property);
    }
    this->AddTarget(element, name, role, properties);
  }

  std::deque<DataArray>& GetArrays(const Element& element)
  {
    return element.Name == "vertex" ? this->PointArrays : this->CellArrays;
  }

  /// Adds an array; a name that is taken gets one more `_`.
  void AddTarget(const Element& element, std::string name, ArrayRole role,
    const std::vector<Property*>& properties)
  {
    std::deque<DataArray>& arrays = this->GetArrays(element);
    while (std::any_of(
      arrays.begin(), arrays.end(), [&](const DataArray& array) { return array.Name == name; }))
    {
      name += '_';
    }
    arrays.push_back({ name, static_cast<int>(properties.size()),
      dgg::MakeValues(properties[0]->Type, properties.size() * element.Count), role });
    for (std::size_t c = 0; c < properties.size(); ++c)
    {
      properties[c]->Target = &arrays.back();
      properties[c]->Component = c;
    }
  }

  void ReadNumber(const Property& property)
  {
    if (!property.Target)
    {
      this->Read<double>(property.Type);
      return;
    }
    const std::size_t i =
      this->Record * static_cast<std::size_t>(property.Target->Components) + property.Component;
    std::visit(
      [&](auto& values) {
        values[i] = this->Read<typename std::decay_t<decltype(values)>::value_type>(property.Type);
      },
      property.Target->Values);
  }

  void ReadList(const Property& property)
  {
    const auto count = this->Read<std::int64_t>(property.CountType);
    const std::size_t room = this->Text.GetBytesLeft() + (this->IsBinary ? 0 : 1);
    if (count < 0 || (count == 0 && property.Use == ListUse::Face))
    {
      this->Fail("the list ", Quote(property.Name), " has ", count, " values");
    }
    if (static_cast<std::size_t>(count) > room / this->GetLeastBytes(property.Type))
    {
      this->FailEnd();
    }
    this->Corners.clear();
    for (std::int64_t k = 0; k < count; ++k)
    {
      if (property.Use == ListUse::Skipped)
      {
        this->Read<double>(property.Type);
        continue;
      }
      const auto id = this->Read<std::int64_t>(property.Type);
      if (id >= this->NumberOfPoints || id < (property.Use == ListUse::Strips ? -1 : 0))
      {
        this->Fail("the point ", id, " is out of range: the file has ",
          dgg::Counted(this->NumberOfPoints, "point"), ", numbered from 0");
      }
      this->Corners.push_back(id);
    }
    if (property.Use == ListUse::Face)
    {
      this->Faces.Add(this->Corners);
    }
    else if (property.Use == ListUse::Strips)
    {
      this->AddStrips();
    }
  }

  /// Adds the triangles of strips; -1 separates the strips.
  void AddStrips()
  {
    dgg::CellList& polygons = this->Mesh.Polygons;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < this->Corners.size(); ++k)
    {
      if (this->Corners[k] < 0)
      {
        begin = k + 1;
      }
      else if (k >= begin + 2)
      {
        const std::size_t turn = (k - begin) % 2; // every second triangle is reversed
        const std::int64_t* corners = this->Corners.data() + k;
        polygons.Connectivity.insert(polygons.Connectivity.end(),
          { corners[turn ? -1 : -2], corners[turn ? -2 : -1], *corners });
        polygons.EndCell();
      }
    }
  }

  /// Reads a number that the file stores as `type`.
  template <typename T>
  T Read(const NumberType& type)
  {
    T number = 0;
    if (!this->IsBinary)
    {
      const std::string_view word = this->TakeWord();
      if (const char* trouble = dgg::ParseNumber(word, number))
      {
        this->Fail(Quote(word), " ", trouble);
      }
      return number;
    }
    if (this->Text.GetBytesLeft() < type.Size)
    {
      this->FailEnd();
    }
    char bytes[8];
    std::memcpy(bytes, this->Text.GetRest().data(), type.Size);
    if (this->IsBigEndian)
    {
      std::reverse(bytes, bytes + type.Size);
    }
    this->Text.Skip(type.Size);
    dgg::DispatchNumber(type, [&](auto stored) {
      std::memcpy(&stored, bytes, sizeof(stored));
      number = static_cast<T>(stored);
    });
    return number;
  }

  void CheckRest()
  {
    const std::size_t rest = this->Text.GetRest().find_first_not_of(" \t\n\v\f\r");
    if (rest != std::string_view::npos)
    {
      this->Text.FindAnywhere();
      this->FailWith(FileCode::Malformed, this->Text.GetBytesLeft(),
        " bytes follow the last record. Correct the counts of the header");
    }
  }

  void Finish()
  {
    if (this->Points.Components != 3)
    {
      dgg::Fail(FileCode::Malformed, "the header has no element 'vertex'");
    }
    this->Mesh.Points = std::move(std::get<std::vector<double>>(this->Points.Values));
    std::move(this->PointArrays.begin(), this->PointArrays.end(),
      std::back_inserter(this->Mesh.PointArrays));
    // Faces may lack corners, and triangles of strips have no record of their own.
    const std::size_t cells =
      this->Mesh.Verts.GetCount() + this->Mesh.Lines.GetCount() + this->Mesh.Polygons.GetCount();
    if (cells == this->NumberOfFaces && cells == this->Faces.GetCount())
    {
      for (DataArray& array : this->CellArrays)
      {
        this->Faces.Sort(array);
        this->Mesh.CellArrays.push_back(std::move(array));
      }
    }
  }

  std::string_view TakeWord()
  {
    if (!this->Text.FindAnywhere())
    {
      this->FailEnd();
    }
    return this->Text.TakeWord();
  }

  std::size_t GetLeastBytes(const NumberType& type) const { return this->IsBinary ? type.Size : 2; }

  template <typename... Parts>
  [[noreturn]] void FailWith(FileCode code, const Parts&... parts) const
  {
    dgg::Fail(code, this->IsBinary ? "byte " : "line ",
      this->IsBinary ? this->Text.GetByte() : this->Text.GetLine(), ": ", parts...);
  }
  template <typename... Parts>
  [[noreturn]] void Fail(const Parts&... parts) const
  {
    if (this->Current)
    {
      this->FailWith(FileCode::Malformed, "record ", this->Record, " of the element ",
        Quote(this->Current->Name), ": ", parts...);
    }
    this->FailWith(FileCode::Malformed, parts...);
  }
  [[noreturn]] void FailEnd() const
  {
    if (this->Current)
    {
      this->FailWith(FileCode::Premature, "the file ends in record ", this->Record, " of ",
        this->Current->Count, " of the element ", Quote(this->Current->Name));
    }
    this->FailWith(FileCode::Premature, "the file ends inside the header");
  }

  const std::string_view File;
  dgg::TextCursor Text;
  dgg::MeshData& Mesh;
  std::vector<Element> Elements;
  std::size_t HeaderEntries = 0;
  bool IsBinary = false;
  bool IsBigEndian = false;
  const Element* Current = nullptr; ///< element that is being read; null in the header
  std::size_t Record = 0;           ///< index of the current record
  std::int64_t NumberOfPoints = 0;
  std::size_t NumberOfFaces = 0; ///< number of records
  DataArray Points;
  std::deque<DataArray> PointArrays;
  std::deque<DataArray> CellArrays;
  std::vector<std::int64_t> Corners; ///< corners of the current face
  dgg::FaceSorter Faces;
};
}

bool dgg::LooksLikePLY(std::string_view begin)
{
  TextCursor text(begin, Rules);
  return text.FindAnywhere() && text.TakeWord() == "ply";
}

void dgg::ParsePLY(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  PLYParser(file, mesh).Parse(progress);
}
