// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWriters.h"

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using dgg::ArrayRole;
using dgg::DataArray;
using dgg::NumberType;

/// One property of an element: a component of an array.
struct Column
{
  const DataArray* Array;
  std::size_t Component;
  NumberType Type; ///< type in the file
};

/// Returns the type of values in the file. PLY has no 64-bit integers: they become 32-bit integers
/// if all fit, otherwise double.
NumberType GetFileType(const dgg::ArrayValues& values)
{
  return std::visit(
    [](const auto& v) -> NumberType {
      using T = typename std::decay_t<decltype(v)>::value_type;
      constexpr NumberType type = dgg::TypeOf<T>();
      if constexpr (std::is_integral_v<T> && sizeof(T) == 8)
      {
        using Narrow = std::conditional_t<std::is_signed_v<T>, std::int32_t, std::uint32_t>;
        const bool fits = std::all_of(v.begin(), v.end(),
          [](T number) { return static_cast<T>(static_cast<Narrow>(number)) == number; });
        return fits ? dgg::TypeOf<Narrow>() : NumberType{ 'F', 8 };
      }
      return type;
    },
    values);
}

const char* GetTypeName(const NumberType& type)
{
  const bool isSigned = type.Kind == 'I';
  return type.Kind == 'F' ? (type.Size == 4 ? "float" : "double")
    : type.Size == 1      ? (isSigned ? "char" : "uchar")
    : type.Size == 2      ? (isSigned ? "short" : "ushort")
                          : (isSigned ? "int" : "uint");
}

/// Properties of an element.
class Table
{
public:
  explicit Table(std::set<std::string> reserved)
    : Taken(std::move(reserved))
  {
  }

  /// Adds the arrays; the first one of each role gets the names of its role.
  void Add(const std::vector<DataArray>& arrays)
  {
    static const char* const names[][4] = { {}, { "nx", "ny", "nz", nullptr },
      { "u", "v", nullptr, nullptr }, { "red", "green", "blue", "alpha" } };
    for (const ArrayRole role : { ArrayRole::Normals, ArrayRole::TCoords, ArrayRole::Colors })
    {
      if (const DataArray* array = dgg::FindArray(arrays, role))
      {
        for (int c = 0; c < array->Components; ++c)
        {
          this->AddColumn(*array, c, names[static_cast<int>(role)][c]);
        }
      }
    }
    for (const DataArray& array : arrays)
    {
      if (array.Role != ArrayRole::None && &array == dgg::FindArray(arrays, array.Role))
      {
        continue;
      }
      for (int c = 0; c < array.Components; ++c)
      {
        this->AddColumn(
          array, c, array.Name + (array.Components > 1 ? "_" + std::to_string(c) : ""));
      }
    }
  }

  const std::string& GetHeader() const { return this->Header; }

  void PutRecord(std::size_t i, dgg::FileSink& sink) const
  {
    for (const Column& column : this->Columns)
    {
      std::visit(
        [&](const auto& values) {
          const auto value =
            values[i * static_cast<std::size_t>(column.Array->Components) + column.Component];
          dgg::DispatchNumber(
            column.Type, [&](auto zero) { sink.PutBytes(static_cast<decltype(zero)>(value)); });
        },
        column.Array->Values);
    }
  }

private:
  void AddColumn(const DataArray& array, int component, std::string name)
  {
    std::replace_if(
      name.begin(), name.end(),
      [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == 127; }, '_');
    while (name.empty() || !this->Taken.insert(name).second)
    {
      name += '_';
    }
    const NumberType type = GetFileType(array.Values);
    this->Columns.push_back({ &array, static_cast<std::size_t>(component), type });
    this->Header += std::string("property ") + GetTypeName(type) + " " + name + "\n";
  }

  std::vector<Column> Columns;
  std::set<std::string> Taken; ///< names in use
  std::string Header;
};
}

void dgg::WritePLY(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  const CellList& polygons = mesh.Polygons;
  const std::size_t points = mesh.GetNumberOfPoints();
  const std::size_t faces = polygons.GetCount();
  if (points > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    Fail(FileCode::Malformed, "there are ", points, " points, more than a PLY file can index");
  }
  Table pointTable({ "x", "y", "z" });
  pointTable.Add(mesh.PointArrays);
  Table faceTable({ "vertex_indices" });
  faceTable.Add(mesh.CellArrays);
  std::int64_t corners = 0;
  for (std::size_t i = 0; i < faces; ++i)
  {
    corners = std::max(corners, polygons.Offsets[i + 1] - polygons.Offsets[i]);
  }
  const std::string type = mesh.HasFloatPoints ? "float" : "double";
  sink.Put("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points) +
    "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\n" +
    pointTable.GetHeader());
  if (faces > 0)
  {
    sink.Put("element face " + std::to_string(faces) + "\nproperty list " +
      (corners < 256 ? "uchar" : "int") + " int vertex_indices\n" + faceTable.GetHeader());
  }
  sink.Put("end_header\n");
  for (std::size_t i = 0; i < points; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double value = mesh.Points[3 * i + c];
      mesh.HasFloatPoints ? sink.PutBytes(static_cast<float>(value)) : sink.PutBytes(value);
    }
    pointTable.PutRecord(i, sink);
    progress.At(i, points + faces);
  }
  for (std::size_t i = 0; i < faces; ++i)
  {
    const std::int64_t size = polygons.Offsets[i + 1] - polygons.Offsets[i];
    corners < 256 ? sink.PutBytes(static_cast<std::uint8_t>(size))
                  : sink.PutBytes(static_cast<std::int32_t>(size));
    for (std::int64_t k = polygons.Offsets[i]; k < polygons.Offsets[i + 1]; ++k)
    {
      sink.PutBytes(static_cast<std::int32_t>(polygons.Connectivity[static_cast<std::size_t>(k)]));
    }
    faceTable.PutRecord(mesh.Verts.GetCount() + i, sink); // verts are not written
    progress.At(points + i, points + faces);
  }
}
