// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPolylineWriter.h"

#include "vtkDGGMakeArray.h"
#include "vtkDGGNewGeometry.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkDGGPolylineWriter::vtkDGGPolylineWriter(const vtkDGGNewGeometry& geometry, vtkIdType size)
  : Geometry(geometry)
  , Points(geometry.MakePoints(size))
  , Faces(vtkDGGMakeArray<vtkIdTypeArray>("FaceId", size))
  , PointIds(vtkDGGMakeArray<vtkIdTypeArray>("vtkOriginalPointIds", size))
  , ArcLengths(vtkDGGMakeArray<vtkDoubleArray>("ArcLength", size))
{
  this->Lines->AllocateEstimate(1, size);
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGPolylineWriter::CountPoints(const dgg::SurfacePath& path, bool isClosed)
{
  return static_cast<vtkIdType>(path.Points.size()) - (isClosed ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkDGGPolylineWriter::Add(const dgg::SurfacePath& path, bool isClosed)
{
  const auto count = static_cast<std::size_t>(CountPoints(path, isClosed));
  const vtkIdType first = this->Next;
  double arcLength = 0.0;
  const bool isPoint = path.Points.size() == 1; // twice: a polyline has two ends
  this->Lines->InsertNextCell(isPoint ? 2 : static_cast<int>(path.Points.size()));
  for (std::size_t i = 0; i < count; ++i)
  {
    arcLength += i > 0 ? this->MeasurePiece(path, i - 1) : 0.0;
    const dgg::SurfacePoint& point = path.Points[i];
    this->Geometry.SetPoint(this->Points, this->Next, point);
    this->Faces->SetValue(this->Next, this->FindCell(path, i));
    this->PointIds->SetValue(this->Next, vtkDGGNewGeometry::GetPointId(point));
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
void vtkDGGPolylineWriter::AddTo(vtkPolyData* output) const
{
  output->SetPoints(this->Points);
  output->SetLines(this->Lines);
  output->GetPointData()->AddArray(this->Faces);
  output->GetPointData()->AddArray(this->PointIds);
  output->GetPointData()->AddArray(this->ArcLengths);
}

//------------------------------------------------------------------------------
double vtkDGGPolylineWriter::MeasurePiece(const dgg::SurfacePath& path, std::size_t piece) const
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
/// The cell of the input that piece i lies in; the last piece for the last point.
vtkIdType vtkDGGPolylineWriter::FindCell(const dgg::SurfacePath& path, std::size_t i) const
{
  const dgg::Id face = path.Faces.empty()
    ? dgg::FindFaceOf(this->Geometry.GetMesh(), path.Points[i])
    : path.Faces[std::min(i, path.Faces.size() - 1)];
  return this->Geometry.GetCell(face);
}
