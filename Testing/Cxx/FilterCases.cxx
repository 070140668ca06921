// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterCases.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dggtest
{
namespace
{
/// The input of a filter, a copy of its own.
vtkSmartPointer<vtkPolyData> CopyInput(vtkGeodesicAlgorithm* filter)
{
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(filter->GetInputDataObject(0, 0));
  return copy.Get();
}

std::vector<Refusal> RefuseSurface()
{
  using F = vtkGeodesicAlgorithm;
  return {
    Refuse<F>([](F* f) { f->SetInputConnection(nullptr); }, { "no input" }),
    Refuse<F>([](F* f) { f->SetInputDataObject(vtkSmartPointer<vtkImageData>::New()); },
      { "vtkImageData", "vtkPolyData" }),
    Refuse<F>(
      [](F* f) {
        const auto broken = CopyInput(f);
        broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
        f->SetInputData(broken);
      },
      { "point 5 of cell ", "not finite" }),
    Refuse<F>(
      [](F* f) {
        const auto broken = CopyInput(f);
        const vtkIdType ids[] = { 0, 1, 81 };
        broken->GetPolys()->ReplaceCellAtId(7, 3, ids);
        f->SetInputData(broken);
      },
      { "cell 7 ", "point 81" }),
  };
}

Refusal RefusePoints()
{
  using F = vtkGeodesicAlgorithm;
  return Refuse<F>(
    [](F* f) {
      const auto points = CopyInput(f);
      points->SetPolys(nullptr);
      points->SetLines(MakeCells({ { 0, 1 } }));
      f->SetInputData(points);
    },
    { "81 points", "no polygons" });
}
}

void PrintTo(const FilterCase& filter, std::ostream* os)
{
  *os << filter.Name;
}

Refusal RefuseMemoryLimit(vtkTypeInt64 limit)
{
  return { [limit](vtkGeodesicAlgorithm* f) { f->SetMemoryLimit(limit); }, { "MemoryLimit" } };
}

std::vector<FilterCase> GetAllFilters()
{
  std::vector<FilterCase> all;
  for (const auto& filters : { GetCurveFilters(), GetDistanceFilters(), GetSpectralFilters() })
  {
    all.insert(all.end(), filters.begin(), filters.end());
  }
  for (FilterCase& filter : all)
  {
    filter.Refusals = filter.Refusals + RefuseSurface();
    if (!filter.TakesPoints)
    {
      filter.Refusals.push_back(RefusePoints());
    }
  }
  return all;
}

vtkSmartPointer<vtkPolyData> MakeRelief(int dataType, int n)
{
  auto surface = MakeGrid(n, n);
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    points->InsertNextPoint(10.0 * p[0], 10.0 * p[1], static_cast<double>(i * i * 7 % 9));
  }
  surface->SetPoints(points);
  return surface;
}

vtkIdType OnRelief(vtkPolyData* relief, vtkIdType id)
{
  const auto points = static_cast<double>(relief->GetNumberOfPoints());
  const vtkIdType side = points > 0.0 ? static_cast<vtkIdType>(std::lround(std::sqrt(points))) : 9;
  return id / 9 * (side - 1) / 8 * side + id % 9 * (side - 1) / 8;
}

std::vector<vtkIdType> OnRelief(vtkPolyData* relief, std::vector<vtkIdType> ids)
{
  for (vtkIdType& id : ids)
  {
    id = OnRelief(relief, id);
  }
  return ids;
}

void AddNote(vtkPolyData* surface, const char* name)
{
  vtkNew<vtkStringArray> note;
  note->SetName(name);
  note->InsertNextValue("kept");
  surface->GetFieldData()->AddArray(note);
}

double AddSpaceDistances(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("GeodesicDistance");
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    distances->InsertNextValue(EuclideanDistance(surface, 0, i));
    largest = std::max(largest, distances->GetValue(i));
  }
  surface->GetPointData()->AddArray(distances);
  return largest;
}
}
