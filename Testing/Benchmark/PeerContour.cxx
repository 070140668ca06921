// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerContour.h"

#include "MeshFile.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace
{
const char* const FaceName = "Face";
const char* const DistanceName = "Distance";

/// Coordinates of a point in the plane of three others.
std::array<double, 3> FindBarycentric(const double* p, const double* const corners[3])
{
  double e[3];
  double f[3];
  double r[3];
  vtkMath::Subtract(corners[1], corners[0], e);
  vtkMath::Subtract(corners[2], corners[0], f);
  vtkMath::Subtract(p, corners[0], r);
  const double ee = vtkMath::Dot(e, e);
  const double ef = vtkMath::Dot(e, f);
  const double ff = vtkMath::Dot(f, f);
  const double er = vtkMath::Dot(e, r);
  const double fr = vtkMath::Dot(f, r);
  const double determinant = ee * ff - ef * ef;
  const double b = (ff * er - ef * fr) / determinant;
  const double c = (ee * fr - ef * er) / determinant;
  return { { 1.0 - b - c, b, c } };
}
}

PeerContour::PeerContour(
  const MeshArrays& mesh, const std::vector<double>& distances, const std::vector<double>& levels)
  : Arrays(mesh)
  , Levels(levels)
  , Mesh(ToPolyData(mesh))
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName(DistanceName);
  const double beyond = 2.0 * *std::max_element(levels.begin(), levels.end());
  for (const double distance : distances)
  {
    scalars->InsertNextValue(std::isfinite(distance) ? distance : beyond);
  }
  this->Mesh->GetPointData()->SetScalars(scalars);
  vtkNew<vtkIdTypeArray> faces;
  faces->SetName(FaceName);
  for (vtkIdType f = 0; f < this->Mesh->GetNumberOfCells(); ++f)
  {
    faces->InsertNextValue(f);
  }
  this->Mesh->GetCellData()->AddArray(faces);
  this->Filter->SetInputData(this->Mesh);
  this->Filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    this->Filter->SetValue(static_cast<int>(i), levels[i]);
  }
}

PeerContour::~PeerContour() = default;

void PeerContour::Run()
{
  this->Filter->Modified();
  this->Filter->Update();
}

double PeerContour::FindLevel(double value) const
{
  return *std::min_element(this->Levels.begin(), this->Levels.end(),
    [value](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
}

std::vector<IsolineSegment> PeerContour::GetSegments(const dgg::SurfaceMesh& surface) const
{
  vtkPolyData* contour = this->Filter->GetOutput();
  vtkDataArray* faces = contour->GetCellData()->GetArray(FaceName);
  vtkDataArray* values = contour->GetPointData()->GetArray(DistanceName);
  std::vector<IsolineSegment> segments;
  // Cell data start with those of vertices.
  vtkIdType cell = contour->GetNumberOfVerts();
  vtkCellArray* lines = contour->GetLines();
  lines->InitTraversal();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (; lines->GetNextCell(size, ids); ++cell)
  {
    double p[3];
    double q[3];
    contour->GetPoint(ids[0], p);
    contour->GetPoint(ids[1], q);
    IsolineSegment segment;
    segment.Face = static_cast<dgg::Id>(faces->GetTuple1(cell));
    segment.Level = this->FindLevel(values->GetTuple1(ids[0]));
    segment.Length = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    const auto triangle = surface.GetTriangle(segment.Face);
    const double* const corners[3] = { this->Arrays.Points.data() + 3 * triangle[0],
      this->Arrays.Points.data() + 3 * triangle[1], this->Arrays.Points.data() + 3 * triangle[2] };
    const double middle[3] = { 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) };
    segment.Middle = FindBarycentric(middle, corners);
    if (segment.Length > 0.0 && !surface.IsDropped(segment.Face))
    {
      segments.push_back(segment);
    }
  }
  return segments;
}
