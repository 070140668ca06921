// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of vtkPoissonVectorGraphics: arrays, a square with curves.
#ifndef VectorGraphicsTestTools_h
#define VectorGraphicsTestTools_h

#include "SpectralTestTools.h"

#include "vtkPoissonVectorGraphics.h"

namespace dggtest
{
/// A rectangle [0, 6] x [0, 4] and polylines on it.
struct GraphicsFixture
{
  GraphicsFixture(const Points& points, const Cells& lines)
    : Surface(MakeGrid(6, 4, GridCells::Quads))
    , Curves(MakeSourcePoints(points))
  {
    this->Curves->SetVerts(nullptr);
    this->Curves->SetLines(MakeCells(lines));
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetCurveData(this->Curves);
  }
  vtkPolyData* Run()
  {
    ExpectSuccess(this->Filter);
    return this->Filter->GetOutput();
  }
  vtkPointData* OfPoints() { return this->Curves->GetPointData(); }
  vtkCellData* OfCells() { return this->Curves->GetCellData(); }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkPolyData> Curves;
  vtkNew<vtkPoissonVectorGraphics> Filter;
};

/// Returns the rectangle with two upward curves, at x = 1.5 and x = 4.
inline GraphicsFixture MakeTwoAcross()
{
  return GraphicsFixture(
    { { 1.5, 0, 0 }, { 1.5, 4, 0 }, { 4, 0, 0 }, { 4, 4, 0 } }, { { 0, 1 }, { 2, 3 } });
}

inline double MiddleOfCell(vtkPolyData* surface, vtkIdType cell)
{
  double bounds[6];
  surface->GetCellBounds(cell, bounds);
  return 0.5 * (bounds[0] + bounds[1]);
}
}

#endif
