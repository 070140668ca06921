// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphicsOutput.h"

#include "DGGContext.h"
#include "DGGMakeArray.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr const char* ShownName = "RGB";
constexpr const char* NetName = "NetSource";
constexpr const char* ComponentName = "Component"; // point array: tuple of NetName

/// Removes arrays whose number of tuples is wrong.
void RemoveBrokenArrays(vtkFieldData* data, vtkIdType tuples)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      data->RemoveArray(i);
    }
  }
}
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphicsOutput::Take(const DGGContext& context, int precision)
{
  this->Surface = context.Input;
  return this->Geometry.Take(context, precision);
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::Fill(const dgg::SubMesh& cut, const dgg::GraphicsResult& result,
  int channels, vtkPolyData* output) const
{
  this->Geometry.Begin(output);
  this->AddPoints(cut.Points, output);
  this->AddTriangles(cut, output);
  this->AddColors(result.Values, channels, output);
  this->AddNetSources(result.NetSources, channels, output);
  auto components =
    DGGAddArray<vtkIdTypeArray>(output->GetPointData(), ComponentName, result.Components.size(), 1);
  std::copy(result.Components.begin(), result.Components.end(), components->GetPointer(0));
}

//------------------------------------------------------------------------------
bool DGGGraphicsOutput::IsTaken(const std::string& name)
{
  return name == ShownName || name == ComponentName;
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::AddNetSources(
  const std::vector<double>& values, int channels, vtkPolyData* output) const
{
  auto net = DGGAddArray<vtkDoubleArray>(
    output->GetFieldData(), NetName, values.size() / static_cast<std::size_t>(channels), channels);
  std::copy(values.begin(), values.end(), net->GetPointer(0));
}

//------------------------------------------------------------------------------
double DGGGraphicsOutput::GetBytesPerPoint(int channels) const
{
  const auto bytesOf = [](vtkFieldData* data, vtkIdType tuples) {
    return tuples > 0 ? 1024.0 * data->GetActualMemorySize() / static_cast<double>(tuples) : 0.0;
  };
  constexpr double triangle = 4.0 * sizeof(vtkIdType);
  return 3.0 * sizeof(double) + channels * sizeof(double) + 3.0 + sizeof(vtkIdType) +
    bytesOf(this->Surface->GetPointData(), this->Surface->GetNumberOfPoints()) +
    2.0 * (triangle + bytesOf(this->Surface->GetCellData(), this->Surface->GetNumberOfCells()));
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::FillFragments(
  const dgg::GraphicsFragments& fragments, int channels, vtkPolyData* output) const
{
  const std::size_t n = fragments.Places.size();
  this->Geometry.Begin(output);
  this->AddPoints(fragments.Places, output);
  vtkNew<vtkCellArray> verts;
  verts->AllocateExact(static_cast<vtkIdType>(n), static_cast<vtkIdType>(n));
  const auto faces = DGGAddArray<vtkIdTypeArray>(output->GetPointData(), "FaceId", n);
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    verts->InsertNextCell(1, &i);
    faces->SetValue(i, this->Geometry.GetCell(fragments.Faces[k]));
  }
  output->SetVerts(verts);
  this->AddColors(fragments.Values, channels, output);
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::AddPoints(
  const std::vector<dgg::SurfacePoint>& places, vtkPolyData* output) const
{
  const std::size_t n = places.size();
  vtkSmartPointer<vtkPoints> points = this->Geometry.MakePoints(n);
  vtkNew<vtkPointData> from;
  from->ShallowCopy(this->Surface->GetPointData());
  RemoveBrokenArrays(from, this->Surface->GetNumberOfPoints());
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from, static_cast<vtkIdType>(n));
  vtkNew<vtkIdList> corners;
  for (std::size_t v = 0; v < n; ++v)
  {
    const dgg::SurfacePoint& place = places[v];
    const auto id = static_cast<vtkIdType>(v);
    this->Geometry.SetPoint(points, id, place);
    if (dgg::IsVertex(place))
    {
      to->CopyData(from, place.Vertex, id);
      continue;
    }
    std::array<double, 3> weights = place.Barycentric;
    corners->Reset();
    for (const dgg::Id corner : this->Geometry.GetMesh().GetTriangle(place.Face))
    {
      corners->InsertNextId(corner);
    }
    to->InterpolatePoint(from, id, corners, weights.data());
  }
  output->SetPoints(points);
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::AddTriangles(const dgg::SubMesh& cut, vtkPolyData* output) const
{
  const auto faces = static_cast<vtkIdType>(cut.Faces.size());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(faces, 3 * faces);
  vtkNew<vtkCellData> from;
  from->ShallowCopy(this->Surface->GetCellData());
  RemoveBrokenArrays(from, this->Surface->GetNumberOfCells());
  vtkCellData* to = output->GetCellData();
  to->CopyAllocate(from, faces);
  for (vtkIdType f = 0; f < faces; ++f)
  {
    const dgg::Id old = cut.Faces[static_cast<std::size_t>(f)];
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = cut.Triangles[static_cast<std::size_t>(3 * f + k)];
    }
    if (this->Geometry.GetMesh().IsFlipped(old))
    {
      std::swap(corners[1], corners[2]); // same orientation as in the input
    }
    cells->InsertNextCell(3, corners);
    to->CopyData(from, this->Geometry.GetCell(old), f);
  }
  output->SetPolys(cells);
}

//------------------------------------------------------------------------------
void DGGGraphicsOutput::AddColors(
  const std::vector<double>& values, int channels, vtkPolyData* output) const
{
  const std::size_t n = values.size() / static_cast<std::size_t>(channels);
  auto colors = DGGAddArray<vtkDoubleArray>(output->GetPointData(), this->Name, n, channels);
  std::copy(values.begin(), values.end(), colors->GetPointer(0));
  if (channels < 3)
  {
    output->GetPointData()->SetActiveScalars(this->Name.c_str());
    return;
  }
  auto shown = DGGAddArray<vtkUnsignedCharArray>(output->GetPointData(), ShownName, n, 3);
  for (std::size_t v = 0; v < n; ++v)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = values[v * static_cast<std::size_t>(channels) + c];
      const double byte = std::min(255.0, std::max(0.0, std::round(255.0 * value)));
      shown->SetComponent(static_cast<vtkIdType>(v), c, byte);
    }
  }
  output->GetPointData()->SetActiveScalars(ShownName);
}
