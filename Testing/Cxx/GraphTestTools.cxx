// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GraphTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkSMPTools.h"

namespace dggtest
{
namespace
{
/// Rounding error of lengths in the graph, relative.
constexpr double Rounding = 1e-6;
}

const std::vector<std::string>& GetGraphArrayNames()
{
  static const std::vector<std::string> names = { "DGG.Offsets", "DGG.Targets", "DGG.Lengths",
    "DGG.Angles", "DGG.ArrivalAngles", "DGG.Info" };
  return names;
}

vtkSmartPointer<vtkPolyData> MakeSurfaceWithGraph(
  vtkPolyData* surface, double accuracy, int construction)
{
  vtkNew<vtkDiscreteGeodesicGraph> filter;
  filter->SetInputData(surface);
  filter->SetAccuracy(accuracy);
  filter->SetConstruction(construction);
  filter->Update();
  EXPECT_GT(filter->GetNumberOfGraphEdges(), 0);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
}

std::vector<std::string> GetGraphBytes(vtkPolyData* data)
{
  std::vector<std::string> bytes;
  for (const std::string& name : GetGraphArrayNames())
  {
    vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
    bytes.emplace_back();
    if (array && array->GetNumberOfValues() > 0)
    {
      bytes.back().assign(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    }
  }
  return bytes;
}

std::vector<double> GetExactDistances(vtkPolyData* surface, const std::vector<vtkIdType>& sources)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSourceIds(sources);
  const Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  return GetDistances(filter);
}

std::vector<double> GetExactDistances(vtkPolyData* surface, vtkPolyData* sources)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(sources);
  const Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  return GetDistances(filter);
}

void ExpectUpperBounds(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy)
{
  ASSERT_EQ(values.size(), exact.size());
  ASSERT_FALSE(values.empty());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_GE(values[i], exact[i] * (1.0 - 1e-9)) << i;
    EXPECT_LE(values[i], exact[i] * (1.0 + accuracy) * (1.0 + Rounding)) << i;
  }
}

void ExpectWithin(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy)
{
  ASSERT_EQ(values.size(), exact.size());
  ASSERT_FALSE(values.empty());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_LE(std::abs(values[i] - exact[i]), exact[i] * (accuracy + 2.0 * Rounding)) << i;
  }
}

double GetMeanError(const std::vector<double>& values, const std::vector<double>& exact)
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
  return sum / static_cast<double>(count);
}

void ForEachThreading(const std::function<void(const std::string&)>& body)
{
  const std::string original = vtkSMPTools::GetBackend();
  int backends = 0;
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue; // not available in this build of VTK
    }
    ++backends;
    for (const int threads : { 1, 2, 4 })
    {
      vtkSMPTools::Initialize(threads);
      body(std::string(backend) + " " + std::to_string(threads));
    }
  }
  vtkSMPTools::Initialize();
  vtkSMPTools::SetBackend(original.c_str());
  EXPECT_GE(backends, 2);
}
}
