// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathCases.h"

#include "BenchmarkTools.h"
#include "ErrorStatistics.h"
#include "dggExactGeodesics.h"
#include "dggSurfacePath.h"
#include "vtkGeodesicDistanceMatrix.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace
{
constexpr unsigned int RowSeed = 20190523u;
constexpr unsigned int ColumnSeed = 20190524u;

/// Returns surface points as points in space.
vtkSmartPointer<vtkPolyData> ToPolyData(
  const BenchmarkMesh& mesh, const std::vector<dgg::SurfacePoint>& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const dgg::SurfacePoint& point : points)
  {
    places->InsertNextPoint(
      dgg::PositionOf(mesh.GetSurface(), point, mesh.GetArrays().Points.data()).data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  return data;
}

/// Returns the errors of the first row of the matrix.
ErrorStatistics CheckFirstRow(const BenchmarkMesh& mesh, const dgg::SurfacePoint& row,
  const std::vector<dgg::SurfacePoint>& columns, vtkDoubleArray* matrix)
{
  dgg::ExactOptions options;
  options.Targets = columns;
  options.StopAtTargets = true;
  dgg::ExactResult exact;
  dgg::ExactGeodesics(mesh.GetSurface()).Run({ { row, 0.0 } }, options, exact);
  const double* values = matrix->GetPointer(0);
  return ErrorStatistics::Of(
    std::vector<double>(values, values + columns.size()), exact.TargetDistances);
}
}

void MeasureMatrix(
  benchmark::State& state, const MeshRecipe& recipe, double accuracy, int size, int threads)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::SurfaceMesh& surface = mesh.GetSurface();
  const auto rows = RandomPoints(surface, size, false, RowSeed);
  const auto columns = RandomPoints(surface, size, false, ColumnSeed);
  vtkSMPTools::Initialize(threads);
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(mesh.GetPolyData());
  filter->SetAccuracy(accuracy);
  filter->SetUnreachedValue(dgg::Infinity);
  filter->GenerateTableOff();
  // Builds the graph and the structures that link points to it.
  filter->SetRowData(ToPolyData(mesh, { rows[0] }));
  filter->SetColumnData(ToPolyData(mesh, { columns[0] }));
  filter->Update();
  const vtkMTimeType built = filter->GetGraphBuildTime();
  filter->SetRowData(ToPolyData(mesh, rows));
  filter->SetColumnData(ToPolyData(mesh, columns));
  Measure(
    state, [&] { filter->Modified(); }, [&] { filter->Update(); }, WallSeconds);
  vtkSMPTools::Initialize();
  Require(filter->GetMatrix()->GetNumberOfTuples() == size && filter->GetGraphBuildTime() == built,
    "no matrix, or the graph was built again");
  const ErrorStatistics errors = CheckFirstRow(mesh, rows[0], columns, filter->GetMatrix());
  Require(!errors.IsEmpty(), "no column is reached from the first row");
  ReportMesh(state, mesh);
  state.counters["size"] = size;
  state.counters["threads"] = threads;
  state.counters["error_mean"] = errors.Mean;
  state.counters["error_max"] = errors.Maximum;
  state.counters["unreached"] = static_cast<double>(errors.Unreached);
}
