// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGIsolineOutputs.h"

#include "DGGMakeArray.h"
#include "DGGNewGeometry.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr double DegreesPerRadian = 180.0 / dgg::Pi;

/// Returns the limits of the bands; the first and the last limit are the extreme distances.
std::vector<double> FindLimits(const dgg::Bands& bands, const std::vector<dgg::Id>& used)
{
  std::vector<double> limits = bands.Levels;
  if (used.empty())
  {
    return limits;
  }
  double least = dgg::Infinity;
  double largest = -dgg::Infinity;
  for (const dgg::Id v : used)
  {
    least = std::min(least, bands.Distances[v]);
    largest = std::max(largest, bands.Distances[v]);
  }
  limits.insert(limits.begin(), bands.Levels.empty() ? least : std::min(least, bands.Levels[0]));
  limits.push_back(std::max(largest, limits.back()));
  return limits;
}
}

//------------------------------------------------------------------------------
void DGGIsolineOutputs::WritePolylines(const std::vector<dgg::SurfacePath>& lines,
  const std::vector<bool>& isClosed, const char* name, const std::vector<double>& numbers,
  vtkPolyData* output) const
{
  this->Geometry.Begin(output);
  vtkIdType size = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    size += DGGPolylineWriter::CountPoints(lines[i], isClosed[i]);
  }
  DGGPolylineWriter writer(this->Geometry, size);
  const auto array = DGGMakeArray<vtkDoubleArray>(name, lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    writer.Add(lines[i], isClosed[i]);
    array->SetValue(static_cast<vtkIdType>(i), numbers[i]);
  }
  writer.AddTo(output);
  output->GetCellData()->SetScalars(array);
}

//------------------------------------------------------------------------------
void DGGIsolineOutputs::WriteLines(
  const dgg::Isolines& lines, const std::vector<double>& values, vtkPolyData* output) const
{
  std::vector<double> numbers;
  for (const dgg::Id level : lines.Levels)
  {
    numbers.push_back(values[level]);
  }
  this->WritePolylines(lines.Lines, lines.IsClosed, "IsoValue", numbers, output);
}

//------------------------------------------------------------------------------
void DGGIsolineOutputs::WriteRidges(const dgg::Ridges& ridges, vtkPolyData* output) const
{
  std::vector<double> numbers;
  for (const double angle : ridges.Angles)
  {
    numbers.push_back(angle * DegreesPerRadian);
  }
  const std::vector<bool> isClosed(ridges.Lines.size(), false);
  this->WritePolylines(ridges.Lines, isClosed, "RidgeAngle", numbers, output);
}

//------------------------------------------------------------------------------
void DGGIsolineOutputs::WriteBands(const dgg::Bands& bands, vtkPolyData* output) const
{
  this->Geometry.Begin(output);
  const dgg::SubMesh& surface = bands.Surface;
  std::vector<dgg::Id> faces;
  std::vector<dgg::Id> used; // vertices of the output
  std::vector<vtkIdType> pointOf(surface.Points.size(), -1);
  for (dgg::Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (bands.BandOf[f] == dgg::NoId)
    {
      continue;
    }
    faces.push_back(f);
    for (dgg::Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      vtkIdType& point = pointOf[surface.Triangles[h]];
      if (point < 0)
      {
        point = static_cast<vtkIdType>(used.size());
        used.push_back(surface.Triangles[h]);
      }
    }
  }

  const auto points = this->Geometry.MakePoints(used.size());
  output->SetPoints(points);
  vtkPointData* pointData = output->GetPointData();
  const auto distances = DGGMakeArray<vtkDoubleArray>(this->DistanceName, used.size());
  const auto ids = DGGAddArray<vtkIdTypeArray>(pointData, "vtkOriginalPointIds", used.size());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const dgg::SurfacePoint& place = surface.Points[used[i]];
    this->Geometry.SetPoint(points, id, place);
    distances->SetValue(id, bands.Distances[used[i]]);
    ids->SetValue(id, DGGNewGeometry::GetPointId(place));
  }
  pointData->SetScalars(distances);

  vtkCellData* cellData = output->GetCellData();
  const auto numbers = DGGMakeArray<vtkIntArray>("Band", faces.size());
  const auto lower = DGGAddArray<vtkDoubleArray>(cellData, "BandMinimum", faces.size());
  const auto upper = DGGAddArray<vtkDoubleArray>(cellData, "BandMaximum", faces.size());
  const auto cells = DGGAddArray<vtkIdTypeArray>(cellData, "FaceId", faces.size());
  cellData->SetScalars(numbers);
  const std::vector<double> limits = FindLimits(bands, used);
  vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const dgg::Id f = faces[i];
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = pointOf[surface.Triangles[3 * f + k]];
    }
    if (this->Geometry.GetMesh().IsFlipped(surface.Faces[f]))
    {
      std::swap(corners[1], corners[2]); // same orientation as in the input
    }
    triangles->InsertNextCell(3, corners);
    const dgg::Id band = bands.BandOf[f];
    numbers->SetValue(id, band);
    lower->SetValue(id, limits[band]);
    upper->SetValue(id, limits[band + 1]);
    cells->SetValue(id, this->Geometry.GetCell(surface.Faces[f]));
  }
  output->SetPolys(triangles);
}
