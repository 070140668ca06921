// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGVoronoiOutputs.h"

#include "vtkDGGMeshAdapter.h"
#include "vtkDGGPointCoordinates.h"

#include "dggSurfacePath.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
/// An array with its memory, added to some data.
template <typename ArrayType>
vtkSmartPointer<ArrayType> AddArray(
  vtkFieldData* data, const std::string& name, std::size_t size, int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(size));
  data->AddArray(array);
  return array.Get();
}

vtkSmartPointer<vtkPoints> MakePoints(std::size_t size)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(size));
  return points.Get();
}

std::vector<dgg::SurfacePoint> GetPlaces(const std::vector<dgg::GeodesicSource>& sites)
{
  std::vector<dgg::SurfacePoint> places;
  places.reserve(sites.size());
  for (const dgg::GeodesicSource& site : sites)
  {
    places.push_back(site.Point);
  }
  return places;
}
}

//------------------------------------------------------------------------------
void vtkDGGFillSurfacePoints(const std::vector<dgg::SurfacePoint>& places,
  const vtkDGGMeshAdapter& mesh, vtkPoints* coordinates, vtkPolyData* output)
{
  const vtkDGGPointCoordinates positions(coordinates);
  const auto points = MakePoints(places.size());
  vtkNew<vtkCellArray> verts;
  output->SetPoints(points);
  output->SetVerts(verts);
  const auto ids =
    AddArray<vtkIdTypeArray>(output->GetPointData(), "vtkOriginalPointIds", places.size());
  const auto faces = AddArray<vtkIdTypeArray>(output->GetPointData(), "FaceId", places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const dgg::SurfacePoint& place = places[k];
    points->SetPoint(i, dgg::PositionOf(mesh.GetMesh(), place, positions.GetData()).data());
    verts->InsertNextCell(1, &i);
    const bool isVertex = place.On == dgg::SurfacePoint::Support::Vertex;
    ids->SetValue(i, isVertex ? place.Vertex : -1);
    const dgg::Id face = dgg::FindFaceOf(mesh.GetMesh(), place);
    faces->SetValue(i, face == dgg::NoId ? -1 : mesh.GetCell(face));
  }
}

//------------------------------------------------------------------------------
vtkDGGVoronoiOutputs::vtkDGGVoronoiOutputs(const vtkDGGVoronoiResult& result,
  const vtkDGGMeshAdapter& mesh, vtkPoints* coordinates, const std::string& distanceName,
  double unreachedValue)
  : Result(result)
  , Mesh(mesh)
  , Coordinates(coordinates)
  , DistanceName(distanceName)
  , UnreachedValue(unreachedValue)
{
}

//------------------------------------------------------------------------------
double vtkDGGVoronoiOutputs::GetDistance(dgg::Id point) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const auto n = static_cast<dgg::Id>(diagram.Distances.size());
  const double distance = point < n ? diagram.Distances[point] : diagram.BorderDistances[point - n];
  return distance < dgg::Infinity ? distance : this->UnreachedValue;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkDGGVoronoiOutputs::GetPosition(
  dgg::Id point, const double* positions) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const auto n = static_cast<dgg::Id>(diagram.Distances.size());
  return dgg::PositionOf(this->Mesh.GetMesh(),
    point < n ? dgg::SurfacePoint::AtVertex(point) : diagram.BorderPoints[point - n], positions);
}

//------------------------------------------------------------------------------
/// Area of the cell of each site, and at the end of what no site reaches.
std::vector<double> vtkDGGVoronoiOutputs::SumAreas() const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  std::vector<double> areas(this->Result.Sites.size() + 1, 0.0);
  for (std::size_t i = 0; i < diagram.GetNumberOfPolygons(); ++i)
  {
    const dgg::Id site = diagram.PolygonSites[i];
    (site == dgg::NoId ? areas.back() : areas[site]) += diagram.PolygonAreas[i];
  }
  return areas;
}

//------------------------------------------------------------------------------
void vtkDGGVoronoiOutputs::AddToSurface(const std::string& sourceName, vtkPolyData* output) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const auto n = static_cast<std::size_t>(output->GetNumberOfPoints());
  vtkPointData* data = output->GetPointData();
  const auto distances = AddArray<vtkDoubleArray>(data, this->DistanceName, n);
  const auto sites = AddArray<vtkIntArray>(data, sourceName, n);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const dgg::Id vertex = this->Mesh.GetVertex(i);
    distances->SetValue(i, this->GetDistance(vertex));
    sites->SetValue(i, diagram.NearestSites[vertex]);
  }
  // Not SetScalars(), which would remove the scalars of the input.
  data->SetActiveScalars(sourceName.c_str());
  if (!this->Result.Energies.empty())
  {
    const auto energies =
      AddArray<vtkDoubleArray>(output->GetFieldData(), "Energy", this->Result.Energies.size());
    std::copy(this->Result.Energies.begin(), this->Result.Energies.end(), energies->GetPointer(0));
  }
}

//------------------------------------------------------------------------------
void vtkDGGVoronoiOutputs::FillBoundaries(vtkPolyData* output) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  // Only points of curves, in their order.
  std::vector<dgg::Id> used = diagram.CurvePoints;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const vtkDGGPointCoordinates positions(this->Coordinates);
  const auto points = MakePoints(used.size());
  const auto distances =
    AddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, used.size());
  for (std::size_t k = 0; k < used.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    points->SetPoint(i, this->GetPosition(used[k], positions.GetData()).data());
    distances->SetValue(i, this->GetDistance(used[k]));
  }
  vtkNew<vtkCellArray> lines;
  const auto sites =
    AddArray<vtkIntArray>(output->GetCellData(), "SiteId", diagram.GetNumberOfCurves(), 2);
  for (std::size_t k = 0; k < diagram.GetNumberOfCurves(); ++k)
  {
    const dgg::Offset begin = diagram.CurveOffsets[k];
    const dgg::Offset end = diagram.CurveOffsets[k + 1];
    lines->InsertNextCell(static_cast<int>(end - begin));
    for (dgg::Offset i = begin; i < end; ++i)
    {
      lines->InsertCellPoint(
        std::lower_bound(used.begin(), used.end(), diagram.CurvePoints[i]) - used.begin());
    }
    for (int c = 0; c < 2; ++c)
    {
      sites->SetTypedComponent(static_cast<vtkIdType>(k), c, diagram.CurveSites[k][c]);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
}

//------------------------------------------------------------------------------
void vtkDGGVoronoiOutputs::FillCells(vtkPolyData* output) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const vtkDGGPointCoordinates positions(this->Coordinates);
  const std::size_t n = diagram.Distances.size() + diagram.BorderPoints.size();
  const auto points = MakePoints(n);
  const auto distances = AddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, n);
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const auto point = static_cast<dgg::Id>(k);
    points->SetPoint(i, this->GetPosition(point, positions.GetData()).data());
    distances->SetValue(i, this->GetDistance(point));
  }
  const std::vector<double> areas = this->SumAreas();
  vtkNew<vtkCellArray> polygons;
  vtkCellData* data = output->GetCellData();
  const std::size_t count = diagram.GetNumberOfPolygons();
  const auto sites = AddArray<vtkIntArray>(data, "SiteId", count);
  const auto cellAreas = AddArray<vtkDoubleArray>(data, "CellArea", count);
  const auto faces = AddArray<vtkIdTypeArray>(data, "FaceId", count);
  std::vector<vtkIdType> corners;
  for (std::size_t k = 0; k < count; ++k)
  {
    corners.assign(diagram.PolygonPoints.begin() + diagram.PolygonOffsets[k],
      diagram.PolygonPoints.begin() + diagram.PolygonOffsets[k + 1]);
    const dgg::Id face = diagram.PolygonFaces[k];
    if (this->Mesh.GetMesh().IsFlipped(face))
    {
      std::reverse(corners.begin(), corners.end()); // as the input has it
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    const auto i = static_cast<vtkIdType>(k);
    const dgg::Id site = diagram.PolygonSites[k];
    sites->SetValue(i, site);
    cellAreas->SetValue(i, site == dgg::NoId ? areas.back() : areas[site]);
    faces->SetValue(i, this->Mesh.GetCell(face));
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  data->SetActiveScalars("SiteId");
}

//------------------------------------------------------------------------------
void vtkDGGVoronoiOutputs::FillSites(vtkPolyData* output) const
{
  vtkDGGFillSurfacePoints(GetPlaces(this->Result.Sites), this->Mesh, this->Coordinates, output);
  const std::size_t count = this->Result.Sites.size();
  const auto numbers = AddArray<vtkIntArray>(output->GetPointData(), "SiteId", count);
  for (std::size_t k = 0; k < count; ++k)
  {
    numbers->SetValue(static_cast<vtkIdType>(k), static_cast<int>(k));
  }
  if (this->Result.LabelsOnly)
  {
    return;
  }
  const std::vector<double> areas = this->SumAreas();
  const auto cellAreas = AddArray<vtkDoubleArray>(output->GetPointData(), "CellArea", count);
  for (std::size_t k = 0; k < count; ++k)
  {
    cellAreas->SetValue(static_cast<vtkIdType>(k), areas[k]);
  }
}
