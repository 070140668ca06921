// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The surface that filters compute on, made from a vtkPolyData. Internal.
#ifndef DGGPreparedMesh_h
#define DGGPreparedMesh_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "DGGDomain.h"                 // for what it is made of
#include "DGGLocator.h"                // for the locator

#include "dggCapSplitting.h"  // for what was left out
#include "dggGeodesicGraph.h" // for Signature
#include "dggMeshReport.h"    // for MeshReport
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include "vtkTimeStamp.h" // for the time
#include "vtkType.h"      // for vtkIdType

#include <memory> // for sharing
#include <mutex>  // for what is made on demand
#include <string> // for the warnings
#include <vector> // for the maps

class vtkPoints;
class vtkPolyData;

/// A surface, or a cloud, as the kernel sees it. Every point of the input is a vertex of the mesh,
/// with the same id. Polygons and strips are triangulated; verts and lines are not looked at. The
/// mesh of a cloud has no faces: what connects its points is a graph.
///
/// It does not change once it is made, so that filters with the same surface share it, in any
/// threads: in a chain of filters the mesh is prepared once, and so is what is made on demand.
class VTKDGGFILTERSCOMMON_EXPORT DGGPreparedMesh
  : public std::enable_shared_from_this<DGGPreparedMesh>
{
public:
  using Pointer = std::shared_ptr<const DGGPreparedMesh>;

  /// 128 bits that identify the domain, its points and its cells. Equal ones give equal
  /// meshes. Much cheaper than to prepare a mesh.
  static dgg::Signature ComputeFingerprint(vtkPolyData* input, const DGGDomain& domain);

  /// The mesh of a domain: one that is in use already where there is one of this fingerprint, else
  /// a new one. Fails with a message that names the offending point or cell.
  ///
  /// Of a MergedSurface, triangles use the first one of all points that are merged; the others
  /// become vertices without faces, and GetVertex() is the vertex that they share.
  static dgg::Status Make(vtkPolyData* input, const DGGDomain& domain,
    const dgg::Signature& fingerprint, Pointer& prepared);

  /// Fails when there is nothing that a surface could be made of.
  static dgg::Status CheckSurface(vtkPolyData* input);

  /// Angles are measured when it is asked for first.
  const dgg::SurfaceMesh& GetMesh() const;
  /// The same for who needs no angles: see SurfaceMesh::FromPointsWithoutAngles().
  const dgg::SurfaceMesh& GetMeshWithoutAngles() const { return this->Mesh; }
  ///@{
  /// Made when they are asked for first.
  const dgg::MeshReport& GetReport() const;
  const dgg::Anisotropy& GetAnisotropy() const;
  ///@}
  /// Of the points as doubles and the triangles made of the cells.
  const dgg::Signature& GetSignature() const { return this->Signature; }
  /// What the input is treated as.
  const DGGDomain& GetDomain() const { return this->Domain; }
  /// Whether only points have been looked at.
  bool IsCloud() const { return this->Domain.Kind == DGGDomain::Cloud; }
  /// Unlike that of any other mesh; 0 when there is none.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  /// The vertex that represents a point of the input.
  dgg::Id GetVertex(vtkIdType point) const
  {
    return this->Vertices.empty() ? static_cast<dgg::Id>(point) : this->Vertices[point];
  }
  /// The cell of the input that a face of the mesh is a part of.
  vtkIdType GetCell(dgg::Id face) const { return this->Cells[face]; }
  /// Returns the faces that are parts of a cell of the input; empty for an excluded cell.
  std::vector<dgg::Id> GetFaces(vtkIdType cell) const;

  /// Polygons left out because fewer than three of their points are distinct.
  vtkIdType GetNumberOfDroppedCells() const { return this->NumberOfDroppedCells; }
  /// Of triangles without area that were left out.
  double GetLargestCapHeight() const { return this->Caps.LargestHeight; }
  /// Points that share the vertex of an earlier point.
  vtkIdType GetNumberOfMergedPoints() const { return this->NumberOfMergedPoints; }
  /// Points without a face.
  vtkIdType GetNumberOfIsolatedPoints() const
  {
    return this->GetReport().IsolatedVertices - this->NumberOfMergedPoints;
  }
  /// Points on the boundary with the very coordinates of another point on the boundary.
  vtkIdType GetNumberOfCoincidentBoundaryPoints() const
  {
    return this->NumberOfCoincidentBoundaryPoints;
  }
  /// Warnings about the mesh, one topic each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// The warning to report when most of the surface is not connected with a vertex that is
  /// reached, though its parts all but touch; else nothing. `input` is what the mesh was made from.
  std::string DescribeGaps(vtkPolyData* input, const std::vector<bool>& isReached) const;

  ///@{
  /// Made when they are asked for first, from the points of any input with this mesh: x y z per
  /// vertex, and what finds places, which is to be locked while it is used.
  const double* GetPositions(vtkPoints* points) const;
  DGGLocator& GetLocator(vtkPoints* points) const;
  ///@}
  /// x y z per vertex, of a cloud or after GetPositions().
  const double* GetPositions() const { return this->Positions.data(); }

private:
  dgg::Status Build(vtkPolyData* input);
  dgg::Status BuildCloud(vtkPolyData* input);
  dgg::Status Triangulate(
    vtkPolyData* input, const double* points, std::vector<dgg::Id>& triangles);
  void MergeCoincidentPoints(const double* points, vtkIdType numberOfPoints);
  std::vector<dgg::Id> CollectBoundary() const;
  void CountCoincidentBoundaryPoints(const double* points);
  void CheckPrecision(const double* points);
  bool IsPlain() const;
  void CollectWarnings();

  DGGDomain Domain;
  vtkTimeStamp BuildTime;

  mutable std::once_flag AnglesOnce;
  mutable dgg::SurfaceMesh Mesh;
  dgg::Signature Signature{};
  std::vector<dgg::Id> Vertices;        // per point; empty unless coincident points are merged
  std::vector<vtkIdType> Cells;         // per face
  std::size_t NumberOfOrderedFaces = 0; // before the pieces of split triangles
  vtkIdType NumberOfDroppedCells = 0;
  dgg::CapSplitting Caps;     // triangles without area that were left out
  vtkIdType NumberOfFans = 0; // polygons that cross or touch themselves
  vtkIdType NumberOfMergedPoints = 0;
  dgg::Offset NumberOfCoincidentPoints = 0;
  vtkIdType NumberOfCoincidentBoundaryPoints = 0;
  std::vector<std::string> Warnings;

  mutable std::once_flag ReportOnce;
  mutable dgg::MeshReport Report;
  mutable std::once_flag AnisotropyOnce;
  mutable dgg::Anisotropy Anisotropy;
  mutable std::once_flag PositionsOnce;
  mutable std::vector<double> Positions;
  mutable std::once_flag LocatorOnce;
  mutable std::unique_ptr<DGGLocator> Locator;
};

#endif
