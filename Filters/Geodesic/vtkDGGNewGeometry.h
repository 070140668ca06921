// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What outputs have in common that are new geometry on a surface. Internal.
#ifndef vtkDGGNewGeometry_h
#define vtkDGGNewGeometry_h

#include "dggSurfacePoint.h" // for SurfacePoint
#include "dggTypes.h"        // for Status

#include "vtkNew.h"          // for the field data
#include "vtkSmartPointer.h" // for points
#include "vtkType.h"         // for vtkIdType

#include <cstddef> // for std::size_t
#include <vector>  // for the positions

class vtkDGGMeshAdapter;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

/// Paths, loops, samples, cells: outputs whose points lie on a surface but are not its points. Here
/// is what vtkGeodesicAlgorithm promises of all of them: which field data they have, of which
/// precision their points are, how they name cells and points of the input.
class vtkDGGNewGeometry
{
public:
  vtkDGGNewGeometry();
  ~vtkDGGNewGeometry();
  vtkDGGNewGeometry(const vtkDGGNewGeometry&) = delete;
  vtkDGGNewGeometry& operator=(const vtkDGGNewGeometry&) = delete;

  /// Take from a surface and its mesh what outputs need. `precision` is one of
  /// vtkAlgorithm::DesiredOutputPrecision. Coordinates are kept while the mesh is the same. Fails
  /// when coordinates are out of the range of the floats that are asked for.
  dgg::Status Take(vtkPolyData* surface, const vtkDGGMeshAdapter& mesh, int precision);

  /// The mesh that was taken; it must live on.
  const dgg::SurfaceMesh& GetMesh() const;
  /// x y z per vertex.
  const double* GetPositions() const { return this->Positions.data(); }

  /// Make an output empty but for the field data.
  void Begin(vtkPolyData* output) const;
  /// Points to be set.
  vtkSmartPointer<vtkPoints> MakePoints(std::size_t size) const;
  void SetPoint(vtkPoints* points, vtkIdType i, const dgg::SurfacePoint& place) const;

  /// For `vtkOriginalPointIds`: the point of the input, -1 where the place is not at one.
  static vtkIdType GetPointId(const dgg::SurfacePoint& place);
  /// For `FaceId`: the cell of the input that a face is a part of, -1 for no face.
  vtkIdType GetCell(dgg::Id face) const;

private:
  const vtkDGGMeshAdapter* Mesh = nullptr;
  vtkMTimeType MeshTime = 0; // its build time, which Positions belong to
  std::vector<double> Positions;
  vtkNew<vtkFieldData> Fields;
  int DataType;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGNewGeometry.h
