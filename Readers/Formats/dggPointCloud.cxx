// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPointCloud.h"

#include "dggNumberTypes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace
{
using dgg::ArrayRole;
using dgg::DataArray;
using dgg::FieldSource;
using dgg::NumberType;
using dgg::PointCloudView;
using dgg::PointField;
using dgg::PointFieldView;
using Vector = std::array<const PointFieldView*, 3>;

NumberType GetType(const PointField& field)
{
  return { field.Kind, static_cast<std::size_t>(field.Size) };
}

/// Fields of a cloud by their names.
struct FieldTable
{
  std::map<std::string, const PointFieldView*> Views;

  /// Returns the field, or null.
  const PointFieldView* Find(const std::string& name) const
  {
    const auto view = this->Views.find(name);
    return view == this->Views.end() ? nullptr : view->second;
  }
  Vector FindVector(const std::string& prefix) const
  {
    return { { this->Find(prefix + "x"), this->Find(prefix + "y"), this->Find(prefix + "z") } };
  }
  /// Returns all three fields, or three nulls.
  Vector FindNormals() const
  {
    const Vector views = this->FindVector("normal_");
    const bool isVector = std::all_of(views.begin(), views.end(), [&](const PointFieldView* view) {
      return view && view->Field.Count == 1 && view->Field.Kind == 'F' &&
        view->Field.Size == views[0]->Field.Size;
    });
    return isVector ? views : Vector();
  }
  const PointFieldView* FindColor(const char* name) const
  {
    const PointFieldView* view = this->Find(name);
    return view && view->Field.Size == 4 && view->Field.Count == 1 ? view : nullptr;
  }
};

/// Returns fields of one type and number of values as the components of one array.
DataArray Join(
  const PointFieldView* const* views, int fields, std::size_t count, const std::string& name)
{
  const PointField& first = views[0]->Field;
  const int components = fields * first.Count;
  DataArray array{ name, components,
    dgg::MakeValues(GetType(first), count * static_cast<std::size_t>(components)) };
  const std::size_t bytes = first.GetBytes();
  std::visit(
    [&](auto& values) {
      for (int f = 0; f < fields && count > 0; ++f)
      {
        char* out = reinterpret_cast<char*>(values.data()) + static_cast<std::size_t>(f) * bytes;
        const char* in = views[f]->Data;
        for (std::size_t i = 0; i < count; ++i, in += views[f]->Stride)
        {
          std::memcpy(out, in, bytes);
          out += static_cast<std::size_t>(fields) * bytes;
        }
      }
    },
    array.Values);
  return array;
}

void AddCoordinates(const Vector& views, std::size_t count, dgg::MeshData& mesh)
{
  mesh.Points.resize(3 * count);
  mesh.HasFloatPoints = true;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const NumberType type = GetType(views[c]->Field);
    mesh.HasFloatPoints = mesh.HasFloatPoints && type == NumberType();
    dgg::DispatchNumber(type, [&](auto number) {
      const char* in = views[c]->Data;
      for (std::size_t i = 0; i < count; ++i, in += views[c]->Stride)
      {
        std::memcpy(&number, in, sizeof(number));
        mesh.Points[3 * i + c] = static_cast<double>(number);
      }
    });
  }
}

/// Returns colors from the bytes of numbers: alpha, red, green, blue, starting with the most
/// significant byte.
DataArray UnpackColors(const PointFieldView& view, int components, std::size_t count)
{
  std::vector<std::uint8_t> bytes;
  bytes.reserve(count * static_cast<std::size_t>(components));
  const char* in = view.Data;
  for (std::size_t i = 0; i < count; ++i, in += view.Stride)
  {
    std::uint32_t packed = 0;
    std::memcpy(&packed, in, 4);
    for (const int shift : { 16, 8, 0, 24 })
    {
      if (shift < 24 || components == 4)
      {
        bytes.push_back(static_cast<std::uint8_t>(packed >> shift));
      }
    }
  }
  return { components == 4 ? "RGBA" : "RGB", components, std::move(bytes), ArrayRole::Colors };
}

DataArray PackColors(const DataArray& colors)
{
  const auto& bytes = std::get<std::vector<std::uint8_t>>(colors.Values);
  const auto components = static_cast<std::size_t>(colors.Components);
  std::vector<std::uint32_t> packed;
  for (std::size_t i = 0; i + components <= bytes.size(); i += components)
  {
    const std::uint32_t alpha = components == 4 ? bytes[i + 3] : 255u;
    packed.push_back(alpha << 24 | static_cast<std::uint32_t>(bytes[i]) << 16 |
      static_cast<std::uint32_t>(bytes[i + 1]) << 8 | bytes[i + 2]);
  }
  return { "", 1, std::move(packed) };
}

/// Converts to the nearest number of a type.
template <typename To, typename From>
To Narrow(From number)
{
  using Limits = std::numeric_limits<To>;
  if constexpr (!Limits::is_integer)
  {
    return static_cast<To>(number);
  }
  else
  {
    const auto value = static_cast<double>(number);
    // The largest 64-bit integer is not a double, so the next power of two is compared.
    return std::isnan(value)                           ? To(0)
      : value >= std::ldexp(1.0, Limits::digits)       ? Limits::max()
      : value <= static_cast<double>(Limits::lowest()) ? Limits::lowest()
                                                       : static_cast<To>(value);
  }
}

/// Returns a name without blanks that is not taken.
std::string MakeName(std::string name, std::set<std::string>& taken)
{
  std::replace_if(
    name.begin(), name.end(),
    [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == 127; }, '_');
  while (name.empty() || name == dgg::PaddingName || !taken.insert(name).second)
  {
    name += '_';
  }
  return name;
}
}

std::string dgg::CheckPointFields(const PointCloudView& cloud)
{
  FieldTable table;
  for (const PointFieldView& view : cloud.Fields)
  {
    const PointField& field = view.Field;
    if (!IsFieldType(field.Kind, field.Size) || field.Count < 1)
    {
      return "the field '" + field.Name + "' has numbers of no known type, or none";
    }
    if (field.Name != PaddingName && !table.Views.emplace(field.Name, &view).second)
    {
      return "there are two fields '" + field.Name + "'";
    }
  }
  for (const std::string name : { "x", "y", "z" })
  {
    const PointFieldView* view = table.Find(name);
    if (!view)
    {
      return "there is no field '" + name + "'. Add the fields x, y and z";
    }
    if (view->Field.Count != 1)
    {
      return "the field '" + name + "' has " + std::to_string(view->Field.Count) +
        " values per point. Expected one";
    }
  }
  // Arrays with equal names would replace each other.
  const struct
  {
    const PointFieldView* View;
    const char* Fields;
    const char* Array;
  } made[] = { { table.FindNormals()[0], "normal_x, normal_y, normal_z", "Normals" },
    { table.FindColor("rgb"), "rgb", "RGB" }, { table.FindColor("rgba"), "rgba", "RGBA" } };
  for (const auto& array : made)
  {
    if (array.View && table.Find(array.Array))
    {
      return std::string("the fields ") + array.Fields + " and '" + array.Array +
        "' would both become the array " + array.Array;
    }
  }
  return std::string();
}

std::string dgg::ToMesh(const PointCloudView& cloud, MeshData& mesh)
{
  const std::string defect = CheckPointFields(cloud);
  if (!defect.empty())
  {
    return defect;
  }
  if (cloud.Width < 0 || cloud.Height < 0 ||
    (cloud.Height > 0 && cloud.Width > INT64_MAX / cloud.Height))
  {
    return "the width or the height is out of range";
  }
  FieldTable table;
  for (const PointFieldView& view : cloud.Fields)
  {
    table.Views.emplace(view.Field.Name, &view);
  }
  const auto count = static_cast<std::size_t>(cloud.Width * cloud.Height);
  const Vector coordinates = table.FindVector("");
  AddCoordinates(coordinates, count, mesh);
  AddVertsOfFinitePoints(mesh);
  const Vector normals = table.FindNormals();
  if (normals[0])
  {
    mesh.PointArrays.push_back(Join(normals.data(), 3, count, "Normals"));
    mesh.PointArrays.back().Role = ArrayRole::Normals;
  }
  const PointFieldView* colors[] = { table.FindColor("rgba"), table.FindColor("rgb") };
  for (int i = 0; i < 2; ++i)
  {
    if (colors[i])
    {
      mesh.PointArrays.push_back(UnpackColors(*colors[i], 4 - i, count));
    }
  }
  for (const PointFieldView& view : cloud.Fields)
  {
    const auto isOneOf = [&view](const auto& views) {
      return std::find(std::begin(views), std::end(views), &view) != std::end(views);
    };
    if (view.Field.Name != PaddingName && !isOneOf(coordinates) && !isOneOf(normals) &&
      !isOneOf(colors))
    {
      const PointFieldView* views[] = { &view };
      mesh.PointArrays.push_back(Join(views, 1, count, view.Field.Name));
    }
  }
  mesh.Layout = cloud;
  return std::string();
}

bool dgg::IsFieldType(char kind, int size)
{
  return DispatchNumber({ kind, static_cast<std::size_t>(size) }, [](auto) {});
}

void dgg::AddVertsOfFinitePoints(MeshData& mesh)
{
  for (std::size_t i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    const double* p = mesh.Points.data() + 3 * i;
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
    {
      mesh.Verts.Connectivity.push_back(static_cast<std::int64_t>(i));
      mesh.Verts.EndCell();
    }
  }
}

void dgg::FieldSource::Copy(std::size_t begin, std::size_t end, char kind, int size,
  char* destination, std::size_t stride) const
{
  const bool isCopy = this->IsColor || (kind == this->Field.Kind && size == this->Field.Size);
  const auto components = static_cast<std::size_t>(this->Array->Components);
  const auto width = static_cast<std::size_t>(this->Field.Count);
  std::visit(
    [&](const auto& values) {
      const std::size_t bytes = width * sizeof(values[0]);
      const auto copy = [&](auto number) {
        char* out = destination;
        for (std::size_t i = begin; i < end; ++i, out += stride)
        {
          const auto* in = values.data() + i * components + this->FirstComponent;
          for (std::size_t c = 0; c < width && !isCopy; ++c)
          {
            number = Narrow<decltype(number)>(in[c]);
            std::memcpy(out + c * sizeof(number), &number, sizeof(number));
          }
          if (isCopy)
          {
            std::memcpy(out, in, bytes);
          }
        }
      };
      isCopy ? copy(0.0f) : (void)DispatchNumber({ kind, static_cast<std::size_t>(size) }, copy);
    },
    this->Array->Values);
}

std::vector<dgg::FieldSource> dgg::ListFields(MeshData&& mesh, bool areNamesUnique)
{
  std::vector<FieldSource> sources;
  const auto share = [](DataArray&& array) {
    return std::make_shared<const DataArray>(std::move(array));
  };
  const auto addVector = [&](const std::string& prefix, DataArray&& array) {
    const auto shared = share(std::move(array));
    const int size = static_cast<int>(GetType(shared->Values).Size);
    for (int c = 0; c < 3; ++c)
    {
      sources.emplace_back(PointField{ prefix + "xyz"[c], 'F', size, 1 }, shared, c, false);
    }
  };
  DataArray coordinates{ "", 3, {} };
  if (mesh.HasFloatPoints)
  {
    coordinates.Values = std::vector<float>(mesh.Points.begin(), mesh.Points.end());
  }
  else
  {
    coordinates.Values = std::move(mesh.Points);
  }
  addVector("", std::move(coordinates));

  std::set<std::string> taken;
  std::shared_ptr<const DataArray> colors[2]; // without and with alpha
  for (DataArray& array : mesh.PointArrays)
  {
    if (array.Role == ArrayRole::Normals)
    {
      addVector("normal_", std::move(array));
      taken.insert("Normals");
    }
    else if (array.Role == ArrayRole::Colors)
    {
      colors[array.Components - 3] = share(PackColors(array));
      taken.insert(array.Components == 3 ? "RGB" : "RGBA");
    }
  }
  // A float holds the four bytes of rgb, as in PCL.
  const PointField fields[] = { { "rgb", 'F', 4, 1 }, { "rgba", 'U', 4, 1 } };
  for (int i = 0; i < 2; ++i)
  {
    const auto& source = colors[i] || areNamesUnique ? colors[i] : colors[1 - i];
    if (source)
    {
      sources.emplace_back(fields[i], source, 0, true);
    }
  }
  for (const FieldSource& source : sources)
  {
    taken.insert(source.GetField().Name);
  }
  for (DataArray& array : mesh.PointArrays)
  {
    if (array.Role != ArrayRole::Normals && array.Role != ArrayRole::Colors)
    {
      const NumberType type = GetType(array.Values);
      const std::string name = areNamesUnique ? MakeName(array.Name, taken) : array.Name;
      const PointField field{ name, type.Kind, static_cast<int>(type.Size), array.Components };
      sources.emplace_back(field, share(std::move(array)), 0, false);
    }
  }
  return sources;
}
