// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSurfaceLocator.h"

#include "dggBarycentric.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
/// In units in the last place of the largest coordinate.
constexpr double UnitsOfRounding = 8.0;

using Vector = std::array<double, 3>;
using dgg::Cross;
using dgg::Dot;
using dgg::operator-;
}

//------------------------------------------------------------------------------
DGGSurfaceLocator::DGGSurfaceLocator(const dgg::SurfaceMesh& mesh, vtkPoints* points)
  : Mesh(mesh)
{
  this->MeasureExtent(points);

  vtkNew<vtkPoints> scaled;
  scaled->SetDataTypeToDouble();
  scaled->SetNumberOfPoints(points->GetNumberOfPoints());
  for (dgg::Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    Vector p{ { 0.0, 0.0, 0.0 } }; // points without faces may have any coordinates
    if (mesh.FanBegin(v) != mesh.FanEnd(v))
    {
      points->GetPoint(v, p.data());
    }
    scaled->SetPoint(v, p[0] * this->Scale, p[1] * this->Scale, p[2] * this->Scale);
  }
  this->Surface->SetPoints(scaled);
  this->AddCells();
  this->Locator->SetDataSet(this->Surface);
  this->Locator->BuildLocator();
}

//------------------------------------------------------------------------------
void DGGSurfaceLocator::MeasureExtent(vtkPoints* points)
{
  Vector low{ { dgg::Infinity, dgg::Infinity, dgg::Infinity } };
  Vector high{ { -dgg::Infinity, -dgg::Infinity, -dgg::Infinity } };
  for (dgg::Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Mesh.FanBegin(v) == this->Mesh.FanEnd(v))
    {
      continue;
    }
    Vector p;
    points->GetPoint(v, p.data());
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::max({ largest, -low[i], high[i] });
  }
  this->Rounding = UnitsOfRounding * std::numeric_limits<double>::epsilon() * largest;
  const Vector size = high - low;
  const double extent = *std::max_element(size.begin(), size.end());
  this->Scale = std::ldexp(1.0, -std::ilogb(extent));
  const Vector unit{ { size[0] * this->Scale, size[1] * this->Scale, size[2] * this->Scale } };
  this->Diagonal = std::sqrt(Dot(unit, unit)) / this->Scale;
}

//------------------------------------------------------------------------------
void DGGSurfaceLocator::AddCells()
{
  // VTK finds nothing on a triangle without area. It goes in as its longest edge, or as a point.
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  std::vector<dgg::Id> vertFaces;
  std::vector<dgg::Id> lineFaces;
  std::vector<dgg::Id> polyFaces;
  for (dgg::Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    if (this->Mesh.IsDropped(f))
    {
      continue;
    }
    const auto ids = this->GetInputTriangle(f);
    const vtkIdType t[3] = { ids[0], ids[1], ids[2] };
    const std::array<Vector, 3> p{ { this->GetPosition(ids[0]), this->GetPosition(ids[1]),
      this->GetPosition(ids[2]) } };
    const Vector normal = Cross(p[1] - p[0], p[2] - p[0]);
    if (Dot(normal, normal) > 0.0)
    {
      polys->InsertNextCell(3, t);
      polyFaces.push_back(f);
      continue;
    }
    int longest = 0;
    std::array<double, 3> squares{};
    for (int k = 0; k < 3; ++k)
    {
      const Vector edge = p[(k + 1) % 3] - p[k];
      squares[k] = Dot(edge, edge);
      longest = squares[k] > squares[longest] ? k : longest;
    }
    if (squares[longest] > 0.0)
    {
      const vtkIdType edge[2] = { t[longest], t[(longest + 1) % 3] };
      lines->InsertNextCell(2, edge);
      lineFaces.push_back(f);
    }
    else
    {
      verts->InsertNextCell(1, t);
      vertFaces.push_back(f);
    }
  }
  this->Surface->SetVerts(verts);
  this->Surface->SetLines(lines);
  this->Surface->SetPolys(polys);
  this->Faces = std::move(vertFaces); // cell ids of vtkPolyData: verts, lines, polygons
  this->Faces.insert(this->Faces.end(), lineFaces.begin(), lineFaces.end());
  this->Faces.insert(this->Faces.end(), polyFaces.begin(), polyFaces.end());
}

//------------------------------------------------------------------------------
std::array<dgg::Id, 3> DGGSurfaceLocator::GetInputTriangle(dgg::Id face) const
{
  auto triangle = this->Mesh.GetTriangle(face);
  if (this->Mesh.IsFlipped(face))
  {
    std::swap(triangle[1], triangle[2]);
  }
  return triangle;
}

//------------------------------------------------------------------------------
DGGSurfaceLocator::Vector DGGSurfaceLocator::GetPosition(dgg::Id vertex) const
{
  Vector p;
  this->Surface->GetPoint(vertex, p.data());
  return p;
}

//------------------------------------------------------------------------------
std::array<double, 3> DGGSurfaceLocator::Project(
  const Vector& p, dgg::Id face, double& squaredDistance) const
{
  const auto ids = this->GetInputTriangle(face);
  return dgg::FindClosestInTriangle(
    { { this->GetPosition(ids[0]), this->GetPosition(ids[1]), this->GetPosition(ids[2]) } }, p,
    squaredDistance);
}

//------------------------------------------------------------------------------
bool DGGSurfaceLocator::FindClosestPoint(
  const double position[3], dgg::SurfacePoint& closest, double& distance)
{
  const Vector p{ { position[0] * this->Scale, position[1] * this->Scale,
    position[2] * this->Scale } };
  Vector found;
  vtkIdType cell = -1;
  int subId = 0;
  double squaredDistance = 0.0;
  this->Locator->FindClosestPoint(p.data(), found.data(), this->Cell, cell, subId, squaredDistance);
  if (cell < 0)
  {
    return false;
  }
  dgg::Id face = this->Faces[cell];
  closest = dgg::SurfacePoint::InFace(this->Mesh, face, this->Project(p, face, squaredDistance));
  if (closest.On == dgg::SurfacePoint::Support::Edge)
  {
    // All faces of the edge are equally good. Take the first, whichever the locator came upon.
    const dgg::Id h = closest.HalfEdge;
    dgg::Id first = h;
    for (dgg::Id t = this->Mesh.Twin(h); t != dgg::NoId && t != h; t = this->Mesh.Twin(t))
    {
      first = std::min(first, t);
    }
    if (dgg::SurfaceMesh::Face(first) != face)
    {
      face = dgg::SurfaceMesh::Face(first);
      closest =
        dgg::SurfacePoint::InFace(this->Mesh, face, this->Project(p, face, squaredDistance));
    }
  }
  distance = std::sqrt(squaredDistance) / this->Scale;
  return true;
}
