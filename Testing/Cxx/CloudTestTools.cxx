// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudTestTools.h"

#include "vtkAbstractArray.h"

#include <random>

namespace dggtest
{
vtkSmartPointer<vtkPolyData> MakeCloud(const Points& points)
{
  return MakeSurface(points, {});
}

Points MakeFlatPoints(int n, double jitter)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-jitter, jitter);
  Points points;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const double x = i + noise(random);
      const double y = j + noise(random);
      points.push_back({ { x / (n - 1), y / (n - 1), 0.0 } });
    }
  }
  return points;
}

Points MakeSpherePoints(int n)
{
  const double golden = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  Points points;
  for (int i = 0; i < n; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / n;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back({ { r * std::cos(golden * i), r * std::sin(golden * i), z } });
  }
  return points;
}

Points MakeVolumePoints(int n)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number;
  Points points;
  for (int i = 0; i < n; ++i)
  {
    const double x = number(generator);
    const double y = number(generator);
    points.push_back({ x, y, number(generator) });
  }
  return points;
}

Points Move(Points points, const std::array<double, 3>& by)
{
  for (std::array<double, 3>& p : points)
  {
    for (int c = 0; c < 3; ++c)
    {
      p[c] += by[c];
    }
  }
  return points;
}

Points Join(Points first, const Points& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

vtkSmartPointer<vtkPolyData> MakeCloudWithGraph(const Points& points)
{
  vtkNew<vtkPointCloudDGG> graph;
  graph->SetInputData(MakeCloud(points));
  graph->Update();
  EXPECT_EQ(graph->GetErrorCode(), 0u);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(graph->GetOutput());
  return copy;
}

const std::vector<std::string>& GetCloudArrayNames()
{
  static const std::vector<std::string> names = { "DGG.Offsets", "DGG.Targets", "DGG.Lengths",
    "DGG.Radii", "DGG.Info" };
  return names;
}

std::vector<std::string> GetCloudBytes(vtkPolyData* data)
{
  std::vector<std::string> bytes;
  for (const std::string& name : GetCloudArrayNames())
  {
    vtkAbstractArray* array = data->GetFieldData()->GetAbstractArray(name.c_str());
    bytes.emplace_back();
    if (array)
    {
      const auto* begin = static_cast<const char*>(array->GetVoidPointer(0));
      bytes.back().assign(begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize());
    }
  }
  return bytes;
}

std::vector<int> GetComponents(vtkPolyData* data)
{
  auto* array = vtkIntArray::SafeDownCast(data->GetPointData()->GetArray("Component"));
  if (!array)
  {
    return {};
  }
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples() };
}

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double SphereDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return 2.0 * std::asin(std::min(1.0, 0.5 * Distance(a, b)));
}

double GetMeanCloudError(const std::vector<double>& values, const std::vector<double>& exact)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (exact[i] > 0.0)
    {
      sum += std::abs(values[i] / exact[i] - 1.0);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}
}
