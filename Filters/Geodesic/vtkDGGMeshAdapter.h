// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From vtkPolyData to the mesh of the kernel. Internal.
#ifndef vtkDGGMeshAdapter_h
#define vtkDGGMeshAdapter_h

#include "vtkDGGPreparedMesh.h" // for the mesh

#include "vtkTimeStamp.h" // for the build time
#include "vtkType.h"      // for vtkIdType

#include <array>  // for the key
#include <string> // for the warnings
#include <vector> // for the warnings

class vtkPolyData;

/// Keeps the kernel's mesh of a vtkPolyData until points, polygons or strips change. Every point of
/// the input is a vertex of the mesh, with the same id. Polygons and strips are triangulated; verts
/// and lines are not looked at. The mesh of a cloud has no faces: what connects its points is a
/// graph.
class vtkDGGMeshAdapter
{
public:
  vtkDGGMeshAdapter();

  /// Prepare the mesh, or share that of another filter with the same surface; not when it would be
  /// the same again: by time stamps, and where these have changed by the bits of points and cells.
  /// Fails with a message that names the offending point or cell; then there is no mesh.
  ///
  /// Of a MergedSurface, triangles use the first one of all points that are merged; the others
  /// become vertices without faces, and GetVertex() is the vertex that they share.
  dgg::Status Update(vtkPolyData* input, const vtkDGGDomain& domain);

  /// Forget the mesh.
  void Clear();

  const dgg::SurfaceMesh& GetMesh() const { return this->Prepared->Mesh; }
  const dgg::MeshReport& GetReport() const { return this->Prepared->Report; }
  /// Of the points as doubles and the triangles made of the cells.
  const dgg::Signature& GetSignature() const { return this->Prepared->Signature; }
  /// What the input is treated as.
  const vtkDGGDomain& GetDomain() const { return this->Prepared->Domain; }
  /// Whether only points have been looked at.
  bool IsCloud() const { return this->GetDomain().Kind == vtkDGGDomain::Cloud; }

  /// Those of the points of a cloud, x y z each; null for meshes.
  const double* GetPositions() const
  {
    return this->IsCloud() ? this->Prepared->Positions.data() : nullptr;
  }

  /// The vertex that stands for a point of the input.
  dgg::Id GetVertex(vtkIdType point) const
  {
    const std::vector<dgg::Id>& vertices = this->Prepared->Vertices;
    return vertices.empty() ? static_cast<dgg::Id>(point) : vertices[point];
  }
  /// The cell of the input that a face of the mesh is a part of.
  vtkIdType GetCell(dgg::Id face) const { return this->Prepared->Cells[face]; }

  /// Polygons left out because fewer than three of their points are distinct.
  vtkIdType GetNumberOfDroppedCells() const { return this->Prepared->NumberOfDroppedCells; }
  /// Of triangles without area that were left out.
  double GetLargestCapHeight() const { return this->Prepared->Caps.LargestHeight; }
  /// Points that share the vertex of an earlier point.
  vtkIdType GetNumberOfMergedPoints() const { return this->Prepared->NumberOfMergedPoints; }
  /// Points without a face.
  vtkIdType GetNumberOfIsolatedPoints() const
  {
    return this->GetReport().IsolatedVertices - this->GetNumberOfMergedPoints();
  }
  /// Points on the boundary with the very coordinates of another point on the boundary.
  vtkIdType GetNumberOfCoincidentBoundaryPoints() const
  {
    return this->Prepared->NumberOfCoincidentBoundaryPoints;
  }
  /// Warnings about the mesh, one topic each.
  const std::vector<std::string>& GetWarnings() const { return this->Prepared->Warnings; }
  /// See vtkDGGPreparedMesh.
  std::string DescribeGaps(vtkPolyData* input, const std::vector<bool>& isReached) const
  {
    return this->Prepared->DescribeGaps(input, isReached);
  }
  /// When this adapter last took another mesh. It changes with the mesh.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  /// Identity and age of points, polygons and strips. Time stamps are unique in VTK.
  using Key = std::array<vtkMTimeType, 6>;
  static Key MakeKey(vtkPolyData* input, const vtkDGGDomain& domain);

  vtkDGGPreparedMesh::Pointer Prepared; // never null
  dgg::Signature Fingerprint{};         // of what it was made from
  vtkTimeStamp BuildTime;
  Key BuiltFrom{};
  vtkMTimeType Object = 0; // the vtkPolyData last seen, and its own time
  vtkMTimeType ObjectTime = 0;
  bool IsBuilt = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGMeshAdapter.h
