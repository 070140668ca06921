// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGVoronoiOutputs.h"

#include "vtkDGGMakeArray.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGSourceCollector.h"
#include "vtkDGGUnreachedArray.h"
#include "vtkDGGWindowArrays.h"

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

#include <algorithm>

//------------------------------------------------------------------------------
void vtkDGGFillSurfacePoints(const std::vector<dgg::SurfacePoint>& places,
  const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto points = geometry.MakePoints(places.size());
  vtkNew<vtkCellArray> verts;
  output->SetPoints(points);
  output->SetVerts(verts);
  const auto ids =
    vtkDGGAddArray<vtkIdTypeArray>(output->GetPointData(), "vtkOriginalPointIds", places.size());
  const auto faces =
    vtkDGGAddArray<vtkIdTypeArray>(output->GetPointData(), "FaceId", places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const dgg::SurfacePoint& place = places[k];
    geometry.SetPoint(points, i, place);
    verts->InsertNextCell(1, &i);
    ids->SetValue(i, vtkDGGNewGeometry::GetPointId(place));
    faces->SetValue(i, geometry.GetCell(dgg::FindFaceOf(geometry.GetMesh(), place)));
  }
}

//------------------------------------------------------------------------------
vtkDGGVoronoiOutputs::vtkDGGVoronoiOutputs(const vtkDGGVoronoiResult& result,
  const vtkDGGMeshAdapter& mesh, const vtkDGGNewGeometry& geometry, const std::string& distanceName,
  double unreachedValue)
  : Result(result)
  , Mesh(mesh)
  , Geometry(geometry)
  , DistanceName(distanceName)
  , UnreachedValue(unreachedValue)
{
}

//------------------------------------------------------------------------------
/// Infinity where no site reaches.
double vtkDGGVoronoiOutputs::GetTrueDistance(dgg::Id point) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const auto n = static_cast<dgg::Id>(diagram.Distances.size());
  return point < n ? diagram.Distances[point] : diagram.BorderDistances[point - n];
}

//------------------------------------------------------------------------------
double vtkDGGVoronoiOutputs::GetDistance(dgg::Id point) const
{
  const double distance = this->GetTrueDistance(point);
  return distance < dgg::Infinity ? distance : this->UnreachedValue;
}

//------------------------------------------------------------------------------
dgg::SurfacePoint vtkDGGVoronoiOutputs::GetPlace(dgg::Id point) const
{
  const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
  const auto n = static_cast<dgg::Id>(diagram.Distances.size());
  return point < n ? dgg::SurfacePoint::AtVertex(point) : diagram.BorderPoints[point - n];
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
  const auto distances = vtkDGGAddArray<vtkDoubleArray>(data, this->DistanceName, n);
  // Those of the input belong to the array that has just been replaced.
  vtkDGGWindowArrays::RemoveFrom(output->GetFieldData(), this->DistanceName);
  vtkDGGUnreachedArray::RemoveFrom(data, this->DistanceName);
  const auto sites = vtkDGGAddArray<vtkIntArray>(data, sourceName, n);
  std::vector<bool> isReached(n);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const dgg::Id vertex = this->Mesh.GetVertex(i);
    distances->SetValue(i, this->GetDistance(vertex));
    sites->SetValue(i, diagram.NearestSites[vertex]);
    isReached[static_cast<std::size_t>(i)] = this->GetTrueDistance(vertex) < dgg::Infinity;
  }
  vtkDGGUnreachedArray::AddTo(data, this->DistanceName, this->UnreachedValue, isReached);
  // Not SetScalars(), which would remove the scalars of the input.
  data->SetActiveScalars(sourceName.c_str());
  if (!this->Result.Energies.empty())
  {
    const auto energies = vtkDGGAddArray<vtkDoubleArray>(
      output->GetFieldData(), "Energy", this->Result.Energies.size());
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
  this->Geometry.Begin(output);
  const auto points = this->Geometry.MakePoints(used.size());
  const auto distances =
    vtkDGGAddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, used.size());
  for (std::size_t k = 0; k < used.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    this->Geometry.SetPoint(points, i, this->GetPlace(used[k]));
    distances->SetValue(i, this->GetDistance(used[k]));
  }
  vtkNew<vtkCellArray> lines;
  const auto sites =
    vtkDGGAddArray<vtkIntArray>(output->GetCellData(), "SiteId", diagram.GetNumberOfCurves(), 2);
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
  this->Geometry.Begin(output);
  const std::size_t n = diagram.Distances.size() + diagram.BorderPoints.size();
  const auto points = this->Geometry.MakePoints(n);
  const auto distances =
    vtkDGGAddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, n);
  std::vector<bool> isReached(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const auto point = static_cast<dgg::Id>(k);
    this->Geometry.SetPoint(points, i, this->GetPlace(point));
    distances->SetValue(i, this->GetDistance(point));
    isReached[k] = this->GetTrueDistance(point) < dgg::Infinity;
  }
  vtkDGGUnreachedArray::AddTo(
    output->GetPointData(), this->DistanceName, this->UnreachedValue, isReached);
  const std::vector<double> areas = this->SumAreas();
  vtkNew<vtkCellArray> polygons;
  vtkCellData* data = output->GetCellData();
  const std::size_t count = diagram.GetNumberOfPolygons();
  const auto sites = vtkDGGAddArray<vtkIntArray>(data, "SiteId", count);
  const auto cellAreas = vtkDGGAddArray<vtkDoubleArray>(data, "CellArea", count);
  const auto faces = vtkDGGAddArray<vtkIdTypeArray>(data, "FaceId", count);
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
    faces->SetValue(i, this->Geometry.GetCell(face));
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  data->SetActiveScalars("SiteId");
}

//------------------------------------------------------------------------------
void vtkDGGVoronoiOutputs::FillSites(vtkPolyData* output) const
{
  vtkDGGFillSurfacePoints(vtkDGGGetPlaces(this->Result.Sites), this->Geometry, output);
  const std::size_t count = this->Result.Sites.size();
  const auto numbers = vtkDGGAddArray<vtkIntArray>(output->GetPointData(), "SiteId", count);
  for (std::size_t k = 0; k < count; ++k)
  {
    numbers->SetValue(static_cast<vtkIdType>(k), static_cast<int>(k));
  }
  if (this->Result.LabelsOnly)
  {
    return;
  }
  const std::vector<double> areas = this->SumAreas();
  const auto cellAreas = vtkDGGAddArray<vtkDoubleArray>(output->GetPointData(), "CellArea", count);
  for (std::size_t k = 0; k < count; ++k)
  {
    cellAreas->SetValue(static_cast<vtkIdType>(k), areas[k]);
  }
}
