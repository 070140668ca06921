// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGBandOutput.h"

#include "vtkDGGMakeArray.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGWindowArrays.h"

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
#include <array>
#include <utility>
#include <vector>

namespace
{
/// The points of the output, in their order: the vertices of faces in bands.
std::vector<dgg::Id> FindUsedVertices(const dgg::Bands& bands)
{
  const dgg::RefinedSurface& surface = bands.Surface;
  std::vector<bool> isUsed(surface.Points.size(), false);
  for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
  {
    if (bands.BandOf[h / 3] != dgg::NoId)
    {
      isUsed[surface.Triangles[h]] = true;
    }
  }
  std::vector<dgg::Id> used;
  for (std::size_t v = 0; v < isUsed.size(); ++v)
  {
    if (isUsed[v])
    {
      used.push_back(static_cast<dgg::Id>(v));
    }
  }
  return used;
}

/// The limits of all bands; the first and the last are those of the distances.
std::vector<double> FindLimits(const dgg::Bands& bands, const std::vector<dgg::Id>& used)
{
  std::vector<double> limits = bands.Levels;
  double least = limits.empty() ? dgg::Infinity : limits.front();
  double greatest = limits.empty() ? -dgg::Infinity : limits.back();
  for (const dgg::Id v : used)
  {
    least = std::min(least, bands.Distances[v]);
    greatest = std::max(greatest, bands.Distances[v]);
  }
  limits.insert(limits.begin(), least);
  limits.push_back(greatest);
  return limits;
}
}

//------------------------------------------------------------------------------
void vtkDGGWriteBands(const dgg::Bands& bands, const std::string& distanceName,
  const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  const dgg::RefinedSurface& surface = bands.Surface;
  const std::vector<dgg::Id> used = FindUsedVertices(bands);
  const std::vector<double> limits = FindLimits(bands, used);
  geometry.Begin(output);
  vtkDGGWindowArrays::RemoveFrom(output->GetFieldData(), distanceName); // they are of the surface
  const auto points = geometry.MakePoints(used.size());
  const auto distances =
    vtkDGGAddArray<vtkDoubleArray>(output->GetPointData(), distanceName, used.size());
  const auto ids =
    vtkDGGAddArray<vtkIdTypeArray>(output->GetPointData(), "vtkOriginalPointIds", used.size());
  std::vector<vtkIdType> pointOf(surface.Points.size(), -1);
  for (std::size_t k = 0; k < used.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const dgg::SurfacePoint& place = surface.Points[used[k]];
    geometry.SetPoint(points, i, place);
    distances->SetValue(i, bands.Distances[used[k]]);
    ids->SetValue(i, vtkDGGNewGeometry::GetPointId(place));
    pointOf[used[k]] = i;
  }
  const auto count = static_cast<std::size_t>(
    bands.BandOf.size() - std::count(bands.BandOf.begin(), bands.BandOf.end(), dgg::NoId));
  vtkCellData* data = output->GetCellData();
  const auto numbers = vtkDGGAddArray<vtkIntArray>(data, "Band", count);
  const auto minima = vtkDGGAddArray<vtkDoubleArray>(data, "BandMinimum", count);
  const auto maxima = vtkDGGAddArray<vtkDoubleArray>(data, "BandMaximum", count);
  const auto faces = vtkDGGAddArray<vtkIdTypeArray>(data, "FaceId", count);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateEstimate(static_cast<vtkIdType>(count), 3);
  vtkIdType next = 0;
  for (std::size_t f = 0; f < bands.BandOf.size(); ++f)
  {
    const dgg::Id band = bands.BandOf[f];
    if (band == dgg::NoId)
    {
      continue;
    }
    std::array<vtkIdType, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = pointOf[surface.Triangles[3 * f + k]];
    }
    if (geometry.GetMesh().IsFlipped(surface.Faces[f]))
    {
      std::swap(corners[1], corners[2]); // as the input has it
    }
    triangles->InsertNextCell(3, corners.data());
    numbers->SetValue(next, band);
    minima->SetValue(next, limits[band]);
    maxima->SetValue(next, limits[band + 1]);
    faces->SetValue(next, geometry.GetCell(surface.Faces[f]));
    ++next;
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetActiveScalars(distanceName.c_str());
  data->SetActiveScalars("Band");
}
