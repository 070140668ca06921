// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "vtkDGGPointNumbers.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>

namespace
{
using vtkDGG::PointField;
using vtkDGG::PointFieldSource;

template <typename T>
T Narrow(double number)
{
  if (!std::numeric_limits<T>::is_integer)
  {
    return static_cast<T>(number);
  }
  if (std::isnan(number))
  {
    return T(0);
  }
  // The largest number of 64 bits is not a double: the next power of two is compared with.
  if (number >= std::ldexp(1.0, std::numeric_limits<T>::digits))
  {
    return std::numeric_limits<T>::max();
  }
  return number <= static_cast<double>(std::numeric_limits<T>::lowest())
    ? std::numeric_limits<T>::lowest()
    : static_cast<T>(number);
}

std::uint32_t PackColor(vtkUnsignedCharArray* colors, vtkIdType point)
{
  const int components = colors->GetNumberOfComponents();
  const unsigned char* in = colors->GetPointer(point * components);
  const std::uint32_t alpha = components == 4 ? in[3] : 255u;
  return alpha << 24 | static_cast<std::uint32_t>(in[0]) << 16 |
    static_cast<std::uint32_t>(in[1]) << 8 | in[2];
}

/// A name that a file can hold, and that no other field has.
std::string MakeName(const char* name, std::set<std::string>& taken)
{
  std::string text = name ? name : "";
  std::replace_if(
    text.begin(), text.end(),
    [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte <= ' ' || byte == 127;
    },
    '_');
  while (text.empty() || text == vtkDGGPaddingName || !taken.insert(text).second)
  {
    text += '_';
  }
  return text;
}

bool IsColor(vtkDataArray* array, int components = 0)
{
  return vtkUnsignedCharArray::SafeDownCast(array) &&
    (components == 0 ? array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4
                     : array->GetNumberOfComponents() == components);
}

/// The arrays of a vtkPolyData by their meaning.
struct ArrayTable
{
  explicit ArrayTable(vtkPolyData* data)
  {
    vtkPointData* pointData = data->GetPointData();
    if (data->GetPoints())
    {
      this->Coordinates = data->GetPoints()->GetData();
    }
    else
    {
      this->Coordinates = vtkSmartPointer<vtkFloatArray>::New();
      this->Coordinates->SetNumberOfComponents(3);
    }
    const vtkIdType count = this->Coordinates->GetNumberOfTuples();
    auto isWhole = [=](
                     vtkDataArray* array) { return array && array->GetNumberOfTuples() == count; };
    vtkDataArray* normals = isWhole(pointData->GetNormals()) ? pointData->GetNormals() : nullptr;
    this->Normals = vtkFloatArray::SafeDownCast(normals) || vtkDoubleArray::SafeDownCast(normals)
      ? normals
      : nullptr;
    const char* const names[] = { "RGB", "RGBA" };
    for (int i = 0; i < 2; ++i)
    {
      vtkDataArray* named = pointData->GetArray(names[i]);
      vtkDataArray* scalars = pointData->GetScalars();
      this->Colors[i] = isWhole(named) && IsColor(named, 3 + i) ? named
        : isWhole(scalars) && IsColor(scalars, 3 + i)           ? scalars
                                                                : nullptr;
    }
    for (int i = 0; i < pointData->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = pointData->GetArray(i); // null for strings
      if (isWhole(array) && array != this->Normals && array != this->Colors[0] &&
        array != this->Colors[1] && array->GetNumberOfComponents() > 0)
      {
        this->Others.push_back(array);
      }
    }
  }

  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkDataArray* Normals = nullptr;
  vtkDataArray* Colors[2] = { nullptr, nullptr };
  std::vector<vtkDataArray*> Others;
};

void AddVector(vtkDataArray* array, const char* prefix, std::vector<PointFieldSource>& sources)
{
  for (int c = 0; array && c < 3; ++c)
  {
    const int size = array->GetDataType() == VTK_FLOAT ? 4 : 8;
    sources.emplace_back(
      PointField{ std::string(prefix) + "xyz"[c], 'F', size, 1 }, array, c, false);
  }
}

void AddFixedFields(const ArrayTable& table, std::vector<PointFieldSource>& sources)
{
  AddVector(table.Coordinates, "", sources);
  AddVector(table.Normals, "normal_", sources);
  if (table.Colors[0])
  {
    // A float for its four bytes: what PCL has.
    sources.emplace_back(PointField{ "rgb", 'F', 4, 1 }, table.Colors[0], 0, true);
  }
  if (table.Colors[1])
  {
    sources.emplace_back(PointField{ "rgba", 'U', 4, 1 }, table.Colors[1], 0, true);
  }
}

PointFieldSource MakeSource(const std::string& name, vtkDataArray* array)
{
  PointField field{ name, 'F', 4, array->GetNumberOfComponents() };
  vtkDGGGetArrayNumbers(array, field.Kind, field.Size);
  return PointFieldSource(field, array, 0, false);
}
}

bool vtkDGG::IsPointFieldType(char kind, int size)
{
  const bool isLarge = size == 4 || size == 8;
  return kind == 'F' ? isLarge
                     : (kind == 'I' || kind == 'U') && (isLarge || size == 1 || size == 2);
}

vtkDGG::PointFieldSource::PointFieldSource(
  const PointField& field, vtkDataArray* array, int firstComponent, bool isPacked)
  : Field(field)
  , Array(array)
  , FirstComponent(firstComponent)
  , IsPacked(isPacked)
{
  if (!array->HasStandardMemoryLayout())
  {
    this->Array.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    this->Array->DeepCopy(array);
  }
}

void vtkDGG::PointFieldSource::Copy(
  vtkIdType begin, vtkIdType end, char kind, int size, char* destination, std::size_t stride) const
{
  if (begin >= end)
  {
    return;
  }
  if (this->IsPacked)
  {
    auto* colors = vtkUnsignedCharArray::SafeDownCast(this->Array);
    for (vtkIdType i = begin; i < end; ++i, destination += stride)
    {
      const std::uint32_t packed = PackColor(colors, i);
      std::memcpy(destination, &packed, 4);
    }
    return;
  }
  char ownKind = 'F';
  int ownSize = 4;
  vtkDGGGetArrayNumbers(this->Array, ownKind, ownSize);
  const int components = this->Array->GetNumberOfComponents();
  if (kind == ownKind && size == ownSize && this->Array->GetDataType() != VTK_BIT)
  {
    const auto ownStride = static_cast<std::size_t>(components) * ownSize;
    const auto bytes = static_cast<std::size_t>(this->Field.Count) * ownSize;
    const char* in = static_cast<const char*>(this->Array->GetVoidPointer(0)) +
      static_cast<std::size_t>(begin) * ownStride +
      static_cast<std::size_t>(this->FirstComponent) * ownSize;
    for (vtkIdType i = begin; i < end; ++i, in += ownStride, destination += stride)
    {
      std::memcpy(destination, in, bytes);
    }
    return;
  }
  vtkDGGDispatchNumber(kind, size, [&](auto example) {
    using Number = decltype(example);
    char* out = destination;
    for (vtkIdType i = begin; i < end; ++i, out += stride)
    {
      for (int c = 0; c < this->Field.Count; ++c)
      {
        const auto number = Narrow<Number>(this->Array->GetComponent(i, this->FirstComponent + c));
        std::memcpy(out + static_cast<std::size_t>(c) * sizeof(number), &number, sizeof(number));
      }
    }
  });
}

std::vector<vtkDGG::PointFieldSource> vtkDGG::ListPointFields(vtkPolyData* data)
{
  const ArrayTable table(data);
  std::vector<PointFieldSource> sources;
  AddFixedFields(table, sources);
  // Neither twice the same field, nor two that become the same array when they are read.
  std::set<std::string> taken;
  for (const PointFieldSource& source : sources)
  {
    taken.insert(source.GetField().Name);
  }
  const struct
  {
    vtkDataArray* Array;
    const char* Name;
  } made[] = { { table.Normals, "Normals" }, { table.Colors[0], "RGB" },
    { table.Colors[1], "RGBA" } };
  for (const auto& array : made)
  {
    if (array.Array)
    {
      taken.insert(array.Name);
    }
  }
  for (vtkDataArray* array : table.Others)
  {
    sources.push_back(MakeSource(MakeName(array->GetName(), taken), array));
  }
  return sources;
}

std::vector<const vtkDGG::PointFieldSource*> vtkDGG::FindPointFields(
  vtkPolyData* data, const std::vector<PointField>& wanted, std::vector<PointFieldSource>& storage)
{
  const ArrayTable table(data);
  storage.clear();
  AddFixedFields(table, storage);
  for (int i = 0; i < 2; ++i)
  {
    // The same colours under the other name.
    if (table.Colors[i] && !table.Colors[1 - i])
    {
      storage.emplace_back(
        PointField{ i == 0 ? "rgba" : "rgb", 'U', 4, 1 }, table.Colors[i], 0, true);
    }
  }
  for (vtkDataArray* array : table.Others)
  {
    storage.push_back(MakeSource(array->GetName() ? array->GetName() : "", array));
  }
  std::vector<const PointFieldSource*> found(wanted.size(), nullptr);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto source =
      std::find_if(storage.begin(), storage.end(), [&](const PointFieldSource& candidate) {
        return candidate.GetField().Name == wanted[i].Name &&
          candidate.GetField().Count == wanted[i].Count;
      });
    if (source != storage.end())
    {
      found[i] = &*source;
    }
  }
  return found;
}

void vtkDGG::GetPointCloudLayout(vtkPolyData* data, PointCloudView& cloud)
{
  const vtkIdType count = data->GetNumberOfPoints();
  cloud.Width = count;
  cloud.Height = 1;
  cloud.Sensor = PointCloudView().Sensor;
  vtkDataArray* dimensions = data->GetFieldData()->GetArray(vtkDGGDimensionsName);
  if (dimensions && dimensions->GetNumberOfValues() == 2)
  {
    const double width = dimensions->GetVariantValue(0).ToDouble();
    const double height = dimensions->GetVariantValue(1).ToDouble();
    if (width >= 1.0 && height >= 1.0 && width * height == static_cast<double>(count))
    {
      cloud.Width = static_cast<vtkIdType>(width);
      cloud.Height = static_cast<vtkIdType>(height);
    }
  }
  vtkDataArray* viewpoint = data->GetFieldData()->GetArray(vtkDGGViewpointName);
  if (viewpoint && viewpoint->GetNumberOfValues() == 7)
  {
    Viewpoint sensor;
    for (int i = 0; i < 7; ++i)
    {
      sensor[static_cast<std::size_t>(i)] = viewpoint->GetVariantValue(i).ToDouble();
    }
    if (std::all_of(sensor.begin(), sensor.end(), [](double v) { return std::isfinite(v); }))
    {
      cloud.Sensor = sensor;
    }
  }
}

bool vtkDGG::IsPointCloudDense(vtkPolyData* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return false;
    }
  }
  return true;
}
