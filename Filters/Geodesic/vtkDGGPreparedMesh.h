// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh of the kernel made from a vtkPolyData, with all that is known of it. Internal.
#ifndef vtkDGGPreparedMesh_h
#define vtkDGGPreparedMesh_h

#include "vtkDGGDomain.h" // for what it is made of

#include "dggCapSplitting.h"  // for what was left out
#include "dggGeodesicGraph.h" // for Signature
#include "dggMeshReport.h"    // for MeshReport
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include "vtkType.h" // for vtkIdType

#include <memory> // for sharing
#include <string> // for the warnings
#include <vector> // for the maps

class vtkPolyData;

/// What vtkDGGMeshAdapter keeps. The mesh of a cloud has all of its points as vertices, and no
/// face. It does not change any more once it is made, so that filters with the same surface share
/// it, in any threads: in a chain of filters the mesh is prepared once.
class vtkDGGPreparedMesh
{
public:
  using Pointer = std::shared_ptr<const vtkDGGPreparedMesh>;

  /// 128 bits that identify the domain, its points and its cells. Equal ones give equal
  /// meshes. Much cheaper than to prepare a mesh.
  static dgg::Signature ComputeFingerprint(vtkPolyData* input, const vtkDGGDomain& domain);

  /// The mesh of a domain: one that is in use already where there is one of this fingerprint, else
  /// a new one. Fails with a message that names the offending point or cell.
  static dgg::Status Make(vtkPolyData* input, const vtkDGGDomain& domain,
    const dgg::Signature& fingerprint, Pointer& prepared);

  /// Fails when there is nothing that a surface could be made of.
  static dgg::Status CheckSurface(vtkPolyData* input);

  /// The warning to report when most of the surface is not connected with a vertex that is
  /// reached, though its parts all but touch; else nothing. `input` is what the mesh was made from.
  std::string DescribeGaps(vtkPolyData* input, const std::vector<bool>& isReached) const;

  vtkDGGDomain Domain;

  dgg::SurfaceMesh Mesh;
  dgg::MeshReport Report;
  dgg::Signature Signature{};
  std::vector<double> Positions; ///< of a cloud, x y z per point; else empty
  std::vector<dgg::Id> Vertices; ///< per point; empty unless coincident points are merged
  std::vector<vtkIdType> Cells;  ///< per face
  vtkIdType NumberOfDroppedCells = 0;
  dgg::CapSplitting Caps;     ///< triangles without area that were left out
  vtkIdType NumberOfFans = 0; ///< polygons that cross or touch themselves
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfCoincidentBoundaryPoints = 0;
  std::vector<std::string> Warnings;

private:
  dgg::Status Build(vtkPolyData* input);
  dgg::Status BuildCloud(vtkPolyData* input);
  dgg::Status Triangulate(
    vtkPolyData* input, const double* points, std::vector<dgg::Id>& triangles);
  void MergeCoincidentPoints(const double* points, vtkIdType numberOfPoints);
  std::vector<dgg::Id> CollectBoundary() const;
  void CountCoincidentBoundaryPoints(const double* points);
  void CollectWarnings();
  dgg::Id GetVertex(vtkIdType point) const
  {
    return this->Vertices.empty() ? static_cast<dgg::Id>(point) : this->Vertices[point];
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGPreparedMesh.h
