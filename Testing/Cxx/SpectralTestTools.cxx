// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpectralTestTools.h"

#include "vtkTriangle.h"

namespace dggtest
{
namespace
{
std::array<double, 3> Normalized(std::array<double, 3> p)
{
  vtkMath::Normalize(p.data());
  return p;
}
}

vtkSmartPointer<vtkPolyData> MakeSphere(int level)
{
  const double t = 0.5 * (1.0 + std::sqrt(5.0));
  Points points = { { -1, t, 0 }, { 1, t, 0 }, { -1, -t, 0 }, { 1, -t, 0 }, { 0, -1, t },
    { 0, 1, t }, { 0, -1, -t }, { 0, 1, -t }, { t, 0, -1 }, { t, 0, 1 }, { -t, 0, -1 },
    { -t, 0, 1 } };
  for (auto& p : points)
  {
    p = Normalized(p);
  }
  Cells triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (int k = 0; k < level; ++k)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto middle = [&](vtkIdType a, vtkIdType b) {
      const auto found = middles.emplace(std::minmax(a, b), points.size());
      if (found.second)
      {
        points.push_back(Normalized({ points[a][0] + points[b][0], points[a][1] + points[b][1],
          points[a][2] + points[b][2] }));
      }
      return found.first->second;
    };
    Cells finer;
    for (const auto& t3 : triangles)
    {
      const vtkIdType ab = middle(t3[0], t3[1]);
      const vtkIdType bc = middle(t3[1], t3[2]);
      const vtkIdType ca = middle(t3[2], t3[0]);
      finer.push_back({ t3[0], ab, ca });
      finer.push_back({ t3[1], bc, ab });
      finer.push_back({ t3[2], ca, bc });
      finer.push_back({ ab, bc, ca });
    }
    triangles.swap(finer);
  }
  return MakeSurface(points, triangles);
}

std::vector<double> GetValues(vtkPolyData* output, const std::string& name, int component)
{
  std::vector<double> values;
  vtkDataArray* array = output->GetPointData()->GetArray(name.c_str());
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, component));
  }
  return values;
}

std::array<double, 3> PointInCell(
  vtkPolyData* surface, vtkIdType cell, const std::array<double, 3>& barycentric)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  std::array<double, 3> result{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    double p[3];
    surface->GetPoint(ids->GetId(k), p);
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis] += barycentric[k] * p[axis];
    }
  }
  return result;
}

std::vector<double> GetPointAreas(vtkPolyData* surface)
{
  std::vector<double> areas(surface->GetNumberOfPoints(), 0.0);
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(c, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids->GetId(k), p[k]);
    }
    for (const vtkIdType id : *ids)
    {
      areas[id] += vtkTriangle::TriangleArea(p[0], p[1], p[2]) / 3.0;
    }
  }
  return areas;
}

double CosineOf(const double a[3], const double b[3])
{
  return vtkMath::Dot(a, b) / (vtkMath::Norm(a) * vtkMath::Norm(b));
}

double SphereGreens(double cosine)
{
  return -(std::log(1.0 - cosine) + 1.0 - std::log(2.0)) / (4.0 * vtkMath::Pi());
}
}
