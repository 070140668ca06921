// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "DGGPointNumbers.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

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

/// Colours in the bytes of numbers: alpha, red, green, blue, from the most significant one on.
vtkSmartPointer<vtkDataArray> PackColors(vtkUnsignedCharArray* colors)
{
  const int components = colors->GetNumberOfComponents();
  auto packed = vtkSmartPointer<vtkUnsignedIntArray>::New();
  packed->SetNumberOfTuples(colors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    const unsigned char* in = colors->GetPointer(i * components);
    const std::uint32_t alpha = components == 4 ? in[3] : 255u;
    packed->SetValue(i,
      alpha << 24 | static_cast<std::uint32_t>(in[0]) << 16 |
        static_cast<std::uint32_t>(in[1]) << 8 | in[2]);
  }
  return packed;
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
  while (text.empty() || text == DGGPaddingName || !taken.insert(text).second)
  {
    text += '_';
  }
  return text;
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
    const auto isWhole = [this](vtkDataArray* array) {
      return array && array->GetNumberOfTuples() == this->Coordinates->GetNumberOfTuples();
    };
    vtkDataArray* normals = pointData->GetNormals();
    if (isWhole(normals) &&
      (normals->GetDataType() == VTK_FLOAT || normals->GetDataType() == VTK_DOUBLE))
    {
      this->Normals = normals;
    }
    const char* const names[] = { "RGB", "RGBA" };
    for (int i = 0; i < 2; ++i)
    {
      for (vtkDataArray* array : { pointData->GetArray(names[i]), pointData->GetScalars() })
      {
        if (!this->Colors[i] && isWhole(array) && vtkUnsignedCharArray::SafeDownCast(array) &&
          array->GetNumberOfComponents() == 3 + i)
        {
          this->Colors[i] = array;
        }
      }
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

  /// Those of coordinates, normals and colours.
  std::vector<PointFieldSource> MakeFixedSources() const
  {
    std::vector<PointFieldSource> sources;
    for (vtkDataArray* array : { this->Coordinates.Get(), this->Normals })
    {
      for (int c = 0; array && c < 3; ++c)
      {
        const int size = array->GetDataType() == VTK_FLOAT ? 4 : 8;
        const std::string name = array == this->Normals ? "normal_" : "";
        sources.emplace_back(PointField{ name + "xyz"[c], 'F', size, 1 }, array, c, false);
      }
    }
    // A float for its four bytes: what PCL has.
    this->AddColor({ "rgb", 'F', 4, 1 }, this->Colors[0], sources);
    this->AddColor({ "rgba", 'U', 4, 1 }, this->Colors[1], sources);
    return sources;
  }
  void AddColor(
    const PointField& field, vtkDataArray* colors, std::vector<PointFieldSource>& sources) const
  {
    if (colors)
    {
      sources.emplace_back(field, PackColors(vtkUnsignedCharArray::SafeDownCast(colors)), 0, true);
    }
  }

  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkDataArray* Normals = nullptr;
  vtkDataArray* Colors[2] = { nullptr, nullptr }; ///< without and with alpha
  std::vector<vtkDataArray*> Others;
};

PointFieldSource MakeSource(const std::string& name, vtkDataArray* array)
{
  PointField field{ name, 'U', array->GetDataTypeSize(), array->GetNumberOfComponents() };
  switch (array->GetDataType())
  {
    vtkTemplateMacro(field.Kind = !std::numeric_limits<VTK_TT>::is_integer ? 'F'
        : std::numeric_limits<VTK_TT>::is_signed                           ? 'I'
                                                                           : 'U');
    default: // bits become bytes
      field.Size = 1;
      break;
  }
  return PointFieldSource(field, array, 0, false);
}
}

vtkDGG::PointFieldSource::PointFieldSource(
  const PointField& field, vtkDataArray* array, int firstComponent, bool isColor)
  : Field(field)
  , Array(array)
  , FirstComponent(firstComponent)
  , IsColor(isColor)
{
  int type = array->GetDataType();
  if (type == VTK_BIT)
  {
    type = VTK_UNSIGNED_CHAR;
  }
  else if (field.Kind == 'F' && !isColor && type != VTK_FLOAT)
  {
    type = VTK_DOUBLE; // points may be integers
  }
  if (type != array->GetDataType() || !array->HasStandardMemoryLayout())
  {
    this->Array.TakeReference(vtkDataArray::CreateDataArray(type));
    this->Array->DeepCopy(array);
  }
}

void vtkDGG::PointFieldSource::Copy(
  vtkIdType begin, vtkIdType end, char kind, int size, char* destination, std::size_t stride) const
{
  const auto ownSize = static_cast<std::size_t>(this->Array->GetDataTypeSize());
  if (begin < end && (this->IsColor || (kind == this->Field.Kind && size == this->Field.Size)))
  {
    const std::size_t step =
      ownSize * static_cast<std::size_t>(this->Array->GetNumberOfComponents());
    const char* in = static_cast<const char*>(this->Array->GetVoidPointer(0)) +
      static_cast<std::size_t>(begin) * step +
      static_cast<std::size_t>(this->FirstComponent) * ownSize;
    const std::size_t bytes = this->Field.GetBytes();
    for (vtkIdType i = begin; i < end; ++i, in += step, destination += stride)
    {
      std::memcpy(destination, in, bytes);
    }
    return;
  }
  DGGDispatchNumber(DGGGetArrayType(kind, size), [&](auto number) {
    char* out = destination;
    for (vtkIdType i = begin; i < end; ++i, out += stride)
    {
      for (int c = 0; c < this->Field.Count; ++c)
      {
        number = Narrow<decltype(number)>(this->Array->GetComponent(i, this->FirstComponent + c));
        std::memcpy(out + static_cast<std::size_t>(c) * sizeof(number), &number, sizeof(number));
      }
    }
  });
}

std::vector<vtkDGG::PointFieldSource> vtkDGG::ListPointFields(vtkPolyData* data)
{
  const ArrayTable table(data);
  std::vector<PointFieldSource> sources = table.MakeFixedSources();
  // Neither twice the same field, nor two that become the same array when they are read.
  std::set<std::string> taken;
  for (const PointFieldSource& source : sources)
  {
    const std::string& name = source.GetField().Name;
    taken.insert(name);
    taken.insert(name == "rgb" ? "RGB"
        : name == "rgba"       ? "RGBA"
        : table.Normals        ? "Normals"
                               : name);
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
  storage = table.MakeFixedSources();
  if (!table.Colors[0] != !table.Colors[1])
  {
    // The same colours under the other name.
    table.AddColor({ table.Colors[0] ? "rgba" : "rgb", 'U', 4, 1 },
      table.Colors[table.Colors[0] ? 0 : 1], storage);
  }
  for (vtkDataArray* array : table.Others)
  {
    storage.push_back(MakeSource(array->GetName() ? array->GetName() : "", array));
  }
  std::vector<const PointFieldSource*> found;
  for (const PointField& field : wanted)
  {
    const auto source =
      std::find_if(storage.begin(), storage.end(), [&field](const PointFieldSource& candidate) {
        return candidate.GetField().Name == field.Name && candidate.GetField().Count == field.Count;
      });
    found.push_back(source == storage.end() ? nullptr : &*source);
  }
  return found;
}

void vtkDGG::GetPointCloudLayout(vtkPolyData* data, PointCloudView& cloud)
{
  const vtkIdType count = data->GetNumberOfPoints();
  cloud.Width = count;
  cloud.Height = 1;
  cloud.Sensor = PointCloudView().Sensor;
  const auto getValues = [data](const char* name, vtkIdType length) {
    vtkDataArray* array = data->GetFieldData()->GetArray(name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && array->GetNumberOfValues() == length && i < length; ++i)
    {
      const int components = array->GetNumberOfComponents();
      values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
    }
    return values;
  };
  const std::vector<double> size = getValues(DGGDimensionsName, 2);
  if (!size.empty() && size[0] >= 1.0 && size[1] >= 1.0 &&
    size[0] * size[1] == static_cast<double>(count))
  {
    cloud.Width = static_cast<vtkIdType>(size[0]);
    cloud.Height = static_cast<vtkIdType>(size[1]);
  }
  const std::vector<double> sensor = getValues(DGGViewpointName, 7);
  if (!sensor.empty() &&
    std::all_of(sensor.begin(), sensor.end(), [](double v) { return std::isfinite(v); }))
  {
    std::copy(sensor.begin(), sensor.end(), cloud.Sensor.begin());
  }
}

bool vtkDGG::IsPointCloudDense(vtkPolyData* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
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
