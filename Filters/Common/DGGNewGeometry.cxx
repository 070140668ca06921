// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGNewGeometry.h"

#include "DGGContext.h"
#include "DGGGraphArrays.h"
#include "DGGMakeArray.h"
#include "DGGSurfaceArrays.h"
#include "DGGWindowArrays.h"

#include "dggCellCoordinates.h"
#include "dggStatus.h"
#include "dggPreparedSurface.h"
#include "dggSurfacePath.h"

#include "vtkAlgorithm.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
/// Returns the data type of points for a value of vtkAlgorithm::DesiredOutputPrecision.
int ChooseDataType(int precision, vtkPoints* input)
{
  switch (precision)
  {
    case vtkAlgorithm::SINGLE_PRECISION:
      return VTK_FLOAT;
    case vtkAlgorithm::DOUBLE_PRECISION:
      return VTK_DOUBLE;
    default:
      // New points are not integers, even if the points of the input are.
      return input && input->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  }
}

/// Returns an error if floats cannot represent the positions because the largest coordinate
/// overflows or underflows.
dgg::Status CheckRange(const double* begin, const double* end)
{
  double largest = 0.0;
  std::for_each(begin, end, [&](double x) { largest = std::max(largest, std::abs(x)); });
  if (largest == 0.0 ||
    (largest >= std::numeric_limits<float>::min() && largest <= std::numeric_limits<float>::max()))
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput("{OutputPointsPrecision} is single, but coordinates of up to ", largest,
    " are out of the range of floats")
    .At("OutputPointsPrecision")
    .Fix("Set {OutputPointsPrecision} to double");
}
}

//------------------------------------------------------------------------------
DGGNewGeometry::DGGNewGeometry()
  : DataType(VTK_DOUBLE)
{
}

//------------------------------------------------------------------------------
DGGNewGeometry::~DGGNewGeometry() = default;

//------------------------------------------------------------------------------
dgg::Status DGGNewGeometry::Take(const DGGContext& context, int precision)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  vtkPoints* points = context.Input->GetPoints();
  this->Fields->Initialize();
  this->Fields->PassData(context.Input->GetFieldData());
  // The graph and the windows belong to the points of the input.
  DGGGraphArrays::RemoveFrom(this->Fields);
  DGGWindowArrays::RemoveAllFrom(this->Fields);
  this->DataType = ChooseDataType(precision, points);
  this->Mesh = &mesh;
  this->Cells = std::make_unique<DGGSurfaceArrays>(context.Input, false, !mesh.IsCloud());
  this->Coordinates = mesh.IsCloud() || !dgg::CellCoordinates::AreAllTriangles(this->Cells->Get())
    ? nullptr
    : std::make_unique<dgg::CellCoordinates>(this->Cells->Get(), mesh);
  const double* positions = mesh.GetPositions();
  const std::size_t size = 3 * static_cast<std::size_t>(mesh.GetMesh().GetNumberOfVertices());
  return precision == vtkAlgorithm::SINGLE_PRECISION ? CheckRange(positions, positions + size)
                                                     : dgg::Status::Success();
}

//------------------------------------------------------------------------------
const dgg::SurfaceMesh& DGGNewGeometry::GetMesh() const
{
  return this->Mesh->GetMesh();
}

//------------------------------------------------------------------------------
const double* DGGNewGeometry::GetPositions() const
{
  return this->Mesh->GetPositions();
}

//------------------------------------------------------------------------------
void DGGNewGeometry::Begin(vtkPolyData* output) const
{
  output->Initialize();
  output->GetFieldData()->PassData(this->Fields);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> DGGNewGeometry::MakePoints(std::size_t size) const
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(this->DataType);
  points->SetNumberOfPoints(static_cast<vtkIdType>(size));
  return points;
}

//------------------------------------------------------------------------------
void DGGNewGeometry::SetPoint(vtkPoints* points, vtkIdType i, const dgg::SurfacePoint& place) const
{
  points->SetPoint(i, dgg::PositionOf(this->GetMesh(), place, this->GetPositions()).data());
}

//------------------------------------------------------------------------------
vtkIdType DGGNewGeometry::GetPointId(const dgg::SurfacePoint& place)
{
  return dgg::IsVertex(place) ? place.Vertex : -1;
}

//------------------------------------------------------------------------------
vtkIdType DGGNewGeometry::GetCell(dgg::Id face) const
{
  return face == dgg::NoId ? -1 : this->Mesh->GetCell(face);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> DGGNewGeometry::MakeBarycentric(std::size_t size) const
{
  vtkSmartPointer<vtkDoubleArray> array;
  if (this->Coordinates)
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName("Barycentric");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(size));
  }
  return array;
}

//------------------------------------------------------------------------------
void DGGNewGeometry::SetBarycentric(
  vtkDoubleArray* array, vtkIdType i, const dgg::SurfacePoint& point, dgg::Id face) const
{
  if (array)
  {
    const std::array<double, 3> coordinates = face == dgg::NoId
      ? std::array<double, 3>{ { 0.0, 0.0, 0.0 } }
      : this->Coordinates->GetCoordinates(point, face);
    array->SetTuple(i, coordinates.data());
  }
}

//------------------------------------------------------------------------------
void DGGFillSurfacePoints(
  const std::vector<dgg::SurfacePoint>& places, const DGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto points = geometry.MakePoints(places.size());
  vtkNew<vtkCellArray> verts;
  output->SetPoints(points);
  output->SetVerts(verts);
  const auto ids =
    DGGAddArray<vtkIdTypeArray>(output->GetPointData(), "vtkOriginalPointIds", places.size());
  const auto faces = DGGAddArray<vtkIdTypeArray>(output->GetPointData(), "FaceId", places.size());
  const auto barycentric = geometry.MakeBarycentric(places.size());
  if (barycentric)
  {
    output->GetPointData()->AddArray(barycentric);
  }
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    const dgg::SurfacePoint& place = places[k];
    geometry.SetPoint(points, i, place);
    verts->InsertNextCell(1, &i);
    ids->SetValue(i, DGGNewGeometry::GetPointId(place));
    const dgg::Id face = dgg::FindFaceOf(geometry.GetMesh(), place);
    faces->SetValue(i, geometry.GetCell(face));
    geometry.SetBarycentric(barycentric, i, place, face);
  }
}

//------------------------------------------------------------------------------
DGGPolylineWriter::DGGPolylineWriter(const DGGNewGeometry& geometry, vtkIdType size)
  : Geometry(geometry)
  , Points(geometry.MakePoints(size))
  , Faces(DGGMakeArray<vtkIdTypeArray>("FaceId", size))
  , Barycentric(geometry.MakeBarycentric(size))
  , PointIds(DGGMakeArray<vtkIdTypeArray>("vtkOriginalPointIds", size))
  , ArcLengths(DGGMakeArray<vtkDoubleArray>("ArcLength", size))
{
  this->Lines->AllocateEstimate(1, size);
}

//------------------------------------------------------------------------------
vtkIdType DGGPolylineWriter::CountPoints(const dgg::SurfacePath& path, bool isClosed)
{
  return static_cast<vtkIdType>(path.Points.size()) - (isClosed ? 1 : 0);
}

//------------------------------------------------------------------------------
void DGGPolylineWriter::Add(const dgg::SurfacePath& path, bool isClosed)
{
  const auto count = static_cast<std::size_t>(CountPoints(path, isClosed));
  const vtkIdType first = this->Next;
  double arcLength = 0.0;
  const bool isPoint = path.Points.size() == 1; // stored twice: a polyline has two ends
  this->Lines->InsertNextCell(isPoint ? 2 : static_cast<int>(path.Points.size()));
  for (std::size_t i = 0; i < count; ++i)
  {
    arcLength += i > 0 ? this->MeasurePiece(path, i - 1) : 0.0;
    const dgg::SurfacePoint& point = path.Points[i];
    this->Geometry.SetPoint(this->Points, this->Next, point);
    const dgg::Id face = this->FindFace(path, i);
    this->Faces->SetValue(this->Next, this->Geometry.GetCell(face));
    this->Geometry.SetBarycentric(this->Barycentric, this->Next, point, face);
    this->PointIds->SetValue(this->Next, DGGNewGeometry::GetPointId(point));
    this->ArcLengths->SetValue(this->Next, arcLength);
    this->Lines->InsertCellPoint(this->Next);
    ++this->Next;
  }
  if (isClosed || isPoint)
  {
    this->Lines->InsertCellPoint(first);
  }
}

//------------------------------------------------------------------------------
void DGGPolylineWriter::AddTo(vtkPolyData* output) const
{
  output->SetPoints(this->Points);
  output->SetLines(this->Lines);
  output->GetPointData()->AddArray(this->Faces);
  if (this->Barycentric)
  {
    output->GetPointData()->AddArray(this->Barycentric);
  }
  output->GetPointData()->AddArray(this->PointIds);
  output->GetPointData()->AddArray(this->ArcLengths);
}

//------------------------------------------------------------------------------
double DGGPolylineWriter::MeasurePiece(const dgg::SurfacePath& path, std::size_t piece) const
{
  const dgg::SurfaceMesh& mesh = this->Geometry.GetMesh();
  if (!path.Faces.empty())
  {
    return dgg::MeasurePiece(mesh, path, piece);
  }
  const double* positions = this->Geometry.GetPositions();
  const auto p = dgg::PositionOf(mesh, path.Points[piece], positions);
  const auto q = dgg::PositionOf(mesh, path.Points[piece + 1], positions);
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

//------------------------------------------------------------------------------
/// Returns the face of piece i; for the last point, the face of the last piece.
dgg::Id DGGPolylineWriter::FindFace(const dgg::SurfacePath& path, std::size_t i) const
{
  return path.Faces.empty() ? dgg::FindFaceOf(this->Geometry.GetMesh(), path.Points[i])
                            : path.Faces[std::min(i, path.Faces.size() - 1)];
}
