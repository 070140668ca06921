// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Format of stored graphs: the named arrays in field data and in files. Internal.
#ifndef dggStoredGraph_h
#define dggStoredGraph_h

#include "dggBuffer.h"          // for the info array
#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h"   // for GraphView
#include "dggPreparedSurface.h" // for Domain
#include "dggStoredArray.h"     // for StoredArray

#include <array>   // for the arrays
#include <cstdint> // for fixed-width words
#include <string>  // for messages

namespace dgg
{
/// The band in which the graph of a cloud was built: the union of balls around the points, divided
/// into voxels.
struct CloudBand
{
  double VoxelSize = 0.0;
  const double* Radii = nullptr; ///< per point
};

/// Vertices of the graph of a piece that belong to other processes. Ghosts, which are points of
/// other pieces, come last.
struct GhostVertices
{
  const Offset* Ids = nullptr; ///< global ids of ghosts
  Id Count = 0;                ///< of ghosts
  /// Per vertex, the process that it belongs to; Here for this process.
  const Id* Owners = nullptr;
  static constexpr Id Here = -1;
};

/// A graph of a mesh, of a piece of a mesh or of a cloud, and the arrays that store it. The
/// contents of the arrays are documented in vtkDiscreteGeodesicGraph, and for clouds in
/// vtkPointCloudDGG.
class DGG_CORE_EXPORT StoredGraph
{
public:
  enum Role
  {
    Offsets,
    Targets,
    Lengths,
    Angles,
    ArrivalAngles,
    Radii,
    GhostIds,
    Owners,
    Info,
    NumberOfRoles
  };
  using Arrays = std::array<StoredArray, NumberOfRoles>;

  /// Returns the name of an array.
  static const char* GetName(int role);
  /// Returns true if `info`, the array Info, belongs to the graph of a cloud.
  static bool IsOfCloud(const StoredArray& info);
  /// Returns true if `info` belongs to the graph of a piece of a surface.
  static bool IsOfPiece(const StoredArray& info);

  StoredGraph() = default;
  ///@{
  /// Constructs the object with references to the arrays of a graph that was just built.
  StoredGraph(const GraphView& graph, const CloudBand& band);
  StoredGraph(const GraphView& graph, const GhostVertices& ghosts, const Signature& piece);
  ///@}

  /// Reads the arrays of a graph of `surface`, and stores references to them. Checks types, sizes,
  /// format version, ids, the signature of the surface and a checksum. After a failure this graph
  /// is empty.
  Status Read(const Arrays& arrays, const PreparedSurface& surface, const ParallelFor& parallel);
  /// Reads the arrays of the graph of a piece with this number of points in the same manner, except
  /// that the caller has to compare the signature.
  Status ReadPiece(const Arrays& arrays, Offset numberOfPoints, const ParallelFor& parallel);
  /// Reads the parameters of a graph from the array Info alone: GetView().Info and GetDomain().
  Status ReadInfo(const StoredArray& info);

  /// Returns the array Info that stores this graph of `surface`.
  Buffer<std::int64_t> MakeInfo(const PreparedSurface& surface, const ParallelFor& parallel) const;

  /// Returns true if graphs of this kind have an array of the given role.
  bool HasRole(int role) const;
  const GraphView& GetView() const { return this->View; }
  /// Returns the domain of the surface that a stored graph was built on.
  const Domain& GetDomain() const { return this->BuiltOn; }
  /// Returns the band of a cloud; its pointers are null for a mesh.
  const CloudBand& GetBand() const { return this->Band; }
  const GhostVertices& GetGhosts() const { return this->Ghosts; }
  /// Returns true if the graph is that of a piece with this signature.
  bool IsOf(const Signature& piece) const;
  /// Returns the defect of arrays that Read() refused as damaged. Empty for arrays that are intact
  /// but belong to another surface or format version.
  const std::string& GetDamage() const { return this->Damage; }

private:
  Status Check(const Arrays& arrays, const PreparedSurface& surface, const ParallelFor& parallel);
  Status CheckTypes(const Arrays& arrays);
  Status CheckType(int role, const StoredArray& array);
  Status ReadSizes(const Arrays& arrays, Offset numberOfPoints);
  void Refer(const Arrays& arrays);
  Status CheckSurface(const PreparedSurface& surface) const;
  Status CheckContents(const std::int64_t* info, Offset edges, const ParallelFor& parallel);
  Status CheckBand();
  std::int64_t ComputeChecksum(const std::int64_t* info, const ParallelFor& parallel) const;
  template <typename... Parts>
  Status Damaged(const Parts&... parts);

  GraphView View;
  Domain BuiltOn;
  CloudBand Band;
  GhostVertices Ghosts;
  std::int64_t PieceMark = 0; // of the signature of a piece; 0 for an entire surface
  std::string Damage;
};

/// Properties of a graph that remain valid when its arrays have been released.
struct DGG_CORE_EXPORT GraphSummary
{
  GraphInfo Info;
  Id NumberOfVertices = 0;
  Offset NumberOfEdges = 0;
  std::size_t MemorySize = 0; ///< bytes of the arrays

  GraphSummary() = default;
  explicit GraphSummary(const GraphView& graph);
};
}

#endif
