// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The point of a surface that is closest to a point in space. Internal.
#ifndef DGGSurfaceLocator_h
#define DGGSurfaceLocator_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "DGGLocator.h"                // for the base class

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include "vtkGenericCell.h"       // for the locator's workspace
#include "vtkNew.h"               // for vtkNew
#include "vtkPolyData.h"          // for the located cells
#include "vtkStaticCellLocator.h" // for the search

#include <array>  // for the coordinates
#include <vector> // for the map

class vtkPoints;

/// Finds closest points on a mesh of the kernel whose vertices have the given coordinates. The
/// coordinates are scaled by a power of two for the search, so that any scale gives the same
/// answer, bit by bit.
class VTKDGGFILTERSCOMMON_EXPORT DGGSurfaceLocator : public DGGLocator
{
public:
  /// `mesh` must outlive the locator and have a face.
  DGGSurfaceLocator(const dgg::SurfaceMesh& mesh, vtkPoints* points);

  /// It does not depend on the order in which cells are visited, except for ties between different
  /// places.
  bool FindClosestPoint(
    const double position[3], dgg::SurfacePoint& closest, double& distance) override;

  /// Of the faces.
  double GetDiagonal() const override { return this->Diagonal; }

  /// Up to rounding.
  bool IsClose(const dgg::SurfacePoint&, double distance, double farthest) override
  {
    return distance <= farthest + this->Rounding;
  }

private:
  using Vector = std::array<double, 3>;

  void MeasureExtent(vtkPoints* points);
  void AddCells();
  /// Barycentric coordinates, in the order of the input, of the point of a face that is closest.
  std::array<double, 3> Project(const Vector& p, dgg::Id face, double& squaredDistance) const;
  std::array<dgg::Id, 3> GetInputTriangle(dgg::Id face) const;
  Vector GetPosition(dgg::Id vertex) const;

  const dgg::SurfaceMesh& Mesh;
  double Diagonal = 0.0;
  double Rounding = 0.0; // a few units in the last place of the largest coordinate
  double Scale = 1.0;    // power of two
  vtkNew<vtkPolyData> Surface;
  std::vector<dgg::Id> Faces; // of the mesh, per cell of Surface
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

#endif
