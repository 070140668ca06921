// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshArrays.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
using dgg::ArrayRole;
using dgg::DataArray;

/// Returns true if values of this type and number of components can have the role.
bool CanHaveRole(const DataArray& array, ArrayRole role, int components)
{
  const bool isFloat = std::holds_alternative<std::vector<float>>(array.Values) ||
    std::holds_alternative<std::vector<double>>(array.Values);
  const bool isByte = std::holds_alternative<std::vector<std::uint8_t>>(array.Values);
  return array.Components == components && (role == ArrayRole::Colors ? isByte : isFloat);
}
}

void dgg::SetRoles(std::vector<DataArray>& arrays, const ActiveArrays& active)
{
  std::vector<std::size_t> order;
  const auto set = [&](int index, ArrayRole role, int components) {
    const auto i = static_cast<std::size_t>(index);
    const bool canSet = index >= 0 && CanHaveRole(arrays[i], role, components);
    if (canSet)
    {
      arrays[i].Role = role;
      order.push_back(i);
    }
    return canSet;
  };
  const auto setColors = [&](int components) {
    const char* const name = components == 3 ? "RGB" : "RGBA";
    const auto named = std::find_if(
      arrays.begin(), arrays.end(), [name](const DataArray& array) { return array.Name == name; });
    const int index = named == arrays.end() ? -1 : static_cast<int>(named - arrays.begin());
    return set(index, ArrayRole::Colors, components) ||
      set(active.Scalars, ArrayRole::Colors, components);
  };
  set(active.Normals, ArrayRole::Normals, 3);
  set(active.TCoords, ArrayRole::TCoords, 2);
  // Active colors come first.
  const bool hasRGB = setColors(3);
  const bool hasRGBA = setColors(4);
  if (hasRGB && hasRGBA && order.back() == static_cast<std::size_t>(active.Scalars))
  {
    std::swap(order[order.size() - 1], order[order.size() - 2]);
  }
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    if (arrays[i].Role == ArrayRole::None)
    {
      order.push_back(i);
    }
  }
  std::vector<DataArray> sorted;
  for (const std::size_t i : order)
  {
    sorted.push_back(std::move(arrays[i]));
  }
  arrays = std::move(sorted);
}

std::vector<dgg::DataArray> dgg::MakeLayoutArrays(const CloudLayout& layout)
{
  std::vector<DataArray> arrays(2);
  arrays[0].Name = DimensionsName;
  arrays[0].Values = std::vector<std::int64_t>{ layout.Width, layout.Height };
  arrays[1].Name = ViewpointName;
  arrays[1].Values = std::vector<double>(layout.Sensor.begin(), layout.Sensor.end());
  return arrays;
}

dgg::CloudLayout dgg::ReadLayout(
  std::size_t count, const std::vector<double>& dimensions, const std::vector<double>& viewpoint)
{
  const auto total = static_cast<std::int64_t>(count);
  CloudLayout layout;
  layout.Width = total;
  if (dimensions.size() == 2 && dimensions[0] >= 1.0 && dimensions[1] >= 1.0 &&
    dimensions[0] * dimensions[1] == static_cast<double>(total))
  {
    const auto width = static_cast<std::int64_t>(dimensions[0]);
    const auto height = static_cast<std::int64_t>(dimensions[1]);
    layout.Width = width * height == total ? width : total;
    layout.Height = width * height == total ? height : 1;
  }
  if (viewpoint.size() == layout.Sensor.size() &&
    std::all_of(viewpoint.begin(), viewpoint.end(), [](double v) { return std::isfinite(v); }))
  {
    std::copy(viewpoint.begin(), viewpoint.end(), layout.Sensor.begin());
  }
  return layout;
}
