// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "DGGMeshConversion.h"
#include "dggMeshArrays.h"
#include "dggPointCloud.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

/// Implementation of PointFieldSource, hidden from the public header.
class vtkDGG::PointFieldSource::Values : public dgg::FieldSource
{
public:
  explicit Values(dgg::FieldSource&& source)
    : dgg::FieldSource(std::move(source))
  {
  }
};

namespace
{
std::vector<vtkDGG::PointFieldSource> MakeSources(vtkPolyData* data, bool areNamesUnique)
{
  std::vector<vtkDGG::PointFieldSource> sources;
  for (dgg::FieldSource& source : dgg::ListFields(vtkDGG::FromPointsOf(data), areNamesUnique))
  {
    sources.emplace_back(
      std::make_shared<const vtkDGG::PointFieldSource::Values>(std::move(source)));
  }
  return sources;
}
}

vtkSmartPointer<vtkPolyData> vtkDGG::MakePolyData(const PointCloudView& cloud, std::string& error)
{
  dgg::MeshData mesh;
  error = dgg::ToMesh(cloud, mesh);
  if (!error.empty())
  {
    return nullptr;
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  ToPolyData(std::move(mesh), output);
  return output;
}

vtkDGG::PointFieldSource::PointFieldSource(std::shared_ptr<const Values> values)
  : Source(std::move(values))
{
}

const vtkDGG::PointField& vtkDGG::PointFieldSource::GetField() const
{
  return this->Source->GetField();
}

void vtkDGG::PointFieldSource::Copy(
  vtkIdType begin, vtkIdType end, char kind, int size, char* destination, std::size_t stride) const
{
  this->Source->Copy(static_cast<std::size_t>(begin), static_cast<std::size_t>(end), kind, size,
    destination, stride);
}

std::vector<vtkDGG::PointFieldSource> vtkDGG::ListPointFields(vtkPolyData* data)
{
  return MakeSources(data, true);
}

std::vector<const vtkDGG::PointFieldSource*> vtkDGG::FindPointFields(
  vtkPolyData* data, const std::vector<PointField>& fields, std::vector<PointFieldSource>& storage)
{
  storage = MakeSources(data, false);
  std::vector<const PointFieldSource*> found;
  for (const PointField& field : fields)
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
  const auto getValues = [data](const char* name) {
    vtkDataArray* array = data->GetFieldData()->GetArray(name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      const int components = array->GetNumberOfComponents();
      values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
    }
    return values;
  };
  static_cast<dgg::CloudLayout&>(cloud) =
    dgg::ReadLayout(static_cast<std::size_t>(data->GetNumberOfPoints()),
      getValues(dgg::DimensionsName), getValues(dgg::ViewpointName));
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
