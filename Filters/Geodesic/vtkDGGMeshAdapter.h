// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From vtkPolyData to the mesh of the kernel. Internal.
#ifndef vtkDGGMeshAdapter_h
#define vtkDGGMeshAdapter_h

#include "dggGeodesicGraph.h" // for Signature
#include "dggMeshReport.h"    // for MeshReport
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include "vtkTimeStamp.h" // for the build time
#include "vtkType.h"      // for vtkIdType

#include <array>  // for the key
#include <string> // for the warnings
#include <vector> // for the maps

class vtkPolyData;

/// Keeps the kernel's mesh of a vtkPolyData until points, polygons or strips change. Every point of
/// the input is a vertex of the mesh, with the same id. Polygons and strips are triangulated; verts
/// and lines are not looked at.
class vtkDGGMeshAdapter
{
public:
  /// Prepare the mesh. Fails with a message that names the offending point or cell; then there is
  /// no mesh.
  ///
  /// With `mergeCoincidentPoints`, triangles use the first one of all points that have the very
  /// same coordinates; the others become vertices without faces, and GetVertex() tells which vertex
  /// they share.
  dgg::Status Update(vtkPolyData* input, bool mergeCoincidentPoints);

  /// Whether Update() would give the same mesh again. Takes note of the object that it is asked
  /// about.
  bool IsUpToDate(vtkPolyData* input, bool mergeCoincidentPoints);

  /// Forget the mesh.
  void Clear();

  const dgg::SurfaceMesh& GetMesh() const { return this->Mesh; }
  const dgg::MeshReport& GetReport() const { return this->Report; }
  /// Of the points as doubles and the triangles made of the cells.
  const dgg::Signature& GetSignature() const { return this->Signature; }
  /// Whether coincident points have been taken as one.
  bool IsMerged() const { return !this->Vertices.empty(); }

  /// The vertex that stands for a point of the input.
  dgg::Id GetVertex(vtkIdType point) const
  {
    return this->Vertices.empty() ? static_cast<dgg::Id>(point) : this->Vertices[point];
  }
  /// The cell of the input that a face of the mesh is a part of.
  vtkIdType GetCell(dgg::Id face) const { return this->Cells[face]; }

  /// Polygons left out because fewer than three of their points are distinct.
  vtkIdType GetNumberOfDroppedCells() const { return this->NumberOfDroppedCells; }
  /// Points that share the vertex of an earlier point.
  vtkIdType GetNumberOfMergedPoints() const { return this->NumberOfMergedPoints; }
  /// Points without a face.
  vtkIdType GetNumberOfIsolatedPoints() const
  {
    return this->Report.IsolatedVertices - this->NumberOfMergedPoints;
  }
  /// Points on the boundary with the very coordinates of another point on the boundary.
  vtkIdType GetNumberOfCoincidentBoundaryPoints() const
  {
    return this->NumberOfCoincidentBoundaryPoints;
  }
  /// What a user should be told about the mesh, one topic each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  /// When the mesh was last built.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  /// Identity and age of points, polygons and strips. Time stamps are unique in VTK.
  using Key = std::array<vtkMTimeType, 7>;
  static Key MakeKey(vtkPolyData* input, bool mergeCoincidentPoints);

  dgg::Status Build(vtkPolyData* input, bool mergeCoincidentPoints);
  dgg::Status Triangulate(
    vtkPolyData* input, const double* points, std::vector<dgg::Id>& triangles);
  dgg::Status CheckCell(const double* points, vtkIdType numberOfPoints, vtkIdType cell,
    vtkIdType size, const vtkIdType* ids) const;
  void MergeCoincidentPoints(const double* points, vtkIdType numberOfPoints);
  void CountCoincidentBoundaryPoints(const double* points);
  void CollectWarnings();

  dgg::SurfaceMesh Mesh;
  dgg::MeshReport Report;
  dgg::Signature Signature{};
  std::vector<dgg::Id> Vertices; // per point; empty when nothing was merged
  std::vector<vtkIdType> Cells;  // per face
  vtkIdType NumberOfDroppedCells = 0;
  vtkIdType NumberOfFans = 0; // polygons that cross or touch themselves
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfCoincidentBoundaryPoints = 0;
  std::vector<std::string> Warnings;
  vtkTimeStamp BuildTime;
  Key BuiltFrom{};
  vtkMTimeType Object = 0; // the vtkPolyData last seen, and its own time
  vtkMTimeType ObjectTime = 0;
  bool IsBuilt = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGMeshAdapter.h
