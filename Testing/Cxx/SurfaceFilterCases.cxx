// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All filters on surfaces, and the input that all of them refuse.
#include "FilterCases.h"

namespace dggtest
{
namespace
{
/// Returns a copy of the input of a filter.
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

Refusal RefuseCloud()
{
  using F = vtkGeodesicAlgorithm;
  return Refuse<F>(
    [](F* f) {
      const auto points = CopyInput(f);
      points->SetPolys(nullptr);
      points->SetLines(MakeCells({ { 0, 1 } }));
      f->SetInputData(points);
    },
    { "81 points", "no polygons", "vtkPointCloudDGG" });
}
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
    filter.Refusals = filter.Refusals + RefuseInput() + RefuseSurface();
    if (!filter.TakesPoints)
    {
      filter.Refusals.push_back(RefuseCloud());
    }
    if (filter.SetPoints)
    {
      filter.Refusals = filter.Refusals + RefusePoints(filter, "ProjectionTolerance");
    }
  }
  return all;
}
}
