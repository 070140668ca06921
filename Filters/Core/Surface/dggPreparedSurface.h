// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The surface or cloud that tasks compute on, made from points and cells.
#ifndef dggPreparedSurface_h
#define dggPreparedSurface_h

#include "dggCapSplitting.h"  // for CapSplitting
#include "dggCellArrays.h"    // for CellArrays
#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for Signature
#include "dggMeshReport.h"    // for MeshReport
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <cstdint> // for the build number
#include <memory>  // for sharing
#include <mutex>   // for std::once_flag
#include <string>  // for the warnings
#include <vector>  // for the maps

namespace dgg
{
class Locator;

/// Points and cells of an input.
struct SurfaceArrays
{
  const double* Points = nullptr; ///< x y z each
  Offset NumberOfPoints = 0;
  CellArrays Polygons;
  CellArrays Strips;          ///< triangle strips
  Offset FirstCell = 0;       ///< id of the first polygon; strips follow the polygons
  bool AreFromFloats = false; ///< the points were stored in single precision
};

/// Selects the elements along which distances are measured.
struct Domain
{
  enum KindType
  {
    Surface,       ///< the polygons and strips, connected where they share point ids
    MergedSurface, ///< Surface with coincident points merged
    Cloud          ///< the points alone; cells are ignored
  };

  KindType Kind = Surface;
  double MergeTolerance = 0.0; ///< for MergedSurface, as a fraction of the diagonal; else 0

  bool operator==(const Domain& other) const
  {
    return this->Kind == other.Kind && this->MergeTolerance == other.MergeTolerance;
  }
};

/// An item of the report on a surface.
struct ReportItem
{
  const char* Name;  ///< identifier, such as "NumberOfTriangles"
  const char* Words; ///< readable name, such as "triangles"
  double Value;
  std::string Text; ///< readable value, such as "yes"
};

/// A surface, or a cloud, as the kernel sees it. Every point of the input is a vertex of the mesh,
/// with the same id. Polygons and strips are triangulated. The mesh of a cloud has no faces; a
/// graph connects its points.
///
/// A prepared surface is immutable, so that tasks on the same surface share it, from any thread. In
/// a chain of filters the surface, and its parts that are made on demand, are prepared once.
class DGG_CORE_EXPORT PreparedSurface : public std::enable_shared_from_this<PreparedSurface>
{
public:
  using Pointer = std::shared_ptr<const PreparedSurface>;

  /// Constructs an empty surface. Use Make() for other surfaces.
  PreparedSurface();
  ~PreparedSurface();

  /// Returns 128 bits that identify the domain, its points and its cells. Equal fingerprints give
  /// equal surfaces. Costs much less than Make().
  static Signature ComputeFingerprint(const SurfaceArrays& input, const Domain& domain);

  /// Makes a surface, or returns the one in use with this fingerprint. Fails with a message that
  /// names the point or cell at fault.
  ///
  /// Triangles of a MergedSurface use the first one of all points that are merged; the others
  /// become vertices without faces, and GetVertex() returns the vertex that they share.
  static Status Make(const SurfaceArrays& input, const Domain& domain, const Signature& fingerprint,
    Pointer& prepared);

  /// Returns the mesh. Angles are measured at the first call.
  const SurfaceMesh& GetMesh() const;
  /// Returns the mesh for callers that need no angles: see SurfaceMesh::FromPointsWithoutAngles().
  const SurfaceMesh& GetMeshWithoutAngles() const { return this->Mesh; }
  ///@{
  /// Returns the report on the mesh, computed at the first call.
  const MeshReport& GetReport() const;
  double GetMeanAnisotropy() const; ///< see MeasureMeanAnisotropy()
  const Locator& GetLocator() const;
  ///@}
  /// Returns the size, defects and quality of the surface. An empty surface has zeros and is
  /// orientable.
  std::vector<ReportItem> ListReport() const;
  /// Returns the coordinates x y z per vertex.
  const double* GetPositions() const { return this->Positions.data(); }
  /// Returns the signature of the points and triangles.
  const Signature& GetSignature() const { return this->MeshSignature; }
  const Domain& GetDomain() const { return this->InputDomain; }
  bool IsCloud() const { return this->InputDomain.Kind == Domain::Cloud; }
  /// Returns a unique number of this surface in the process; 0 for an empty surface.
  std::uint64_t GetBuildNumber() const { return this->BuildNumber; }

  /// Returns the vertex that represents a point of the input.
  Id GetVertex(Offset point) const
  {
    return this->Vertices.empty() ? static_cast<Id>(point) : this->Vertices[point];
  }
  /// Returns the cell of the input that contains a face of the mesh.
  Offset GetCell(Id face) const
  {
    return this->Cells.empty() ? this->FirstCell + face : this->Cells[face];
  }
  /// Returns true if the faces are the cells of the input, with the same point ids. A face may be
  /// flipped.
  bool HasCellsOfInput() const { return this->HasInputCells; }
  /// Returns the faces in a cell of the input; none for an excluded cell.
  std::vector<Id> GetFaces(Offset cell) const;

  /// Returns the largest height of excluded triangles without area, model units.
  double GetLargestCapHeight() const { return this->Caps.LargestHeight; }
  /// Returns the number of points that share the vertex of an earlier point.
  Offset GetNumberOfMergedPoints() const { return this->NumberOfMergedPoints; }
  /// Returns the number of points without a face.
  Offset GetNumberOfIsolatedPoints() const
  {
    return this->GetReport().IsolatedVertices - this->NumberOfMergedPoints;
  }
  /// Returns the warnings about the mesh, one topic each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Returns a warning if most of the surface is not connected with a vertex that is reached,
  /// although its parts almost touch; else an empty text.
  std::string DescribeGaps(const std::vector<bool>& isReached) const;

private:
  Status Build(const SurfaceArrays& input);
  Status Triangulate(const SurfaceArrays& input, std::vector<Id>& triangles);
  void TriangulateCells(
    const CellArrays& cells, bool areStrips, Offset firstCell, std::vector<Id>& triangles);
  Status CheckCells(const CellArrays& cells, Offset firstCell, bool areFinite) const;
  void MergeCoincidentPoints();
  std::vector<Id> CollectBoundary() const;
  void CountCoincidentBoundaryPoints();
  void CheckPrecision();
  bool IsRegular() const;
  void CollectWarnings();

  Domain InputDomain;
  std::uint64_t BuildNumber = 0;
  std::vector<double> Positions;

  mutable std::once_flag AnglesOnce;
  mutable SurfaceMesh Mesh;
  Signature MeshSignature{};
  std::vector<Id> Vertices;             // per point; empty unless coincident points are merged
  std::vector<Offset> Cells;            // per face; empty if they are consecutive
  Offset FirstCell = 0;                 // cell of face 0
  bool HasInputCells = false;           // see HasCellsOfInput()
  std::size_t NumberOfOrderedFaces = 0; // before the pieces of split faces
  Offset NumberOfDroppedCells = 0;
  CapSplitting Caps;       // excluded triangles without area
  Offset NumberOfFans = 0; // self-intersecting or self-touching polygons
  Offset NumberOfMergedPoints = 0;
  Offset NumberOfCoincidentPoints = 0;
  Offset NumberOfCoincidentBoundaryPoints = 0;
  std::vector<std::string> Warnings;

  mutable std::once_flag ReportOnce;
  mutable MeshReport Report;
  mutable std::once_flag AnisotropyOnce;
  mutable double MeanAnisotropy = 0.0;
  mutable std::once_flag LocatorOnce;
  mutable std::unique_ptr<Locator> ClosestPoints;
};
}

#endif
