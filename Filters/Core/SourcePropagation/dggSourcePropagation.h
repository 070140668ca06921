// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Approximate distances by propagation of virtual sources.
#ifndef dggSourcePropagation_h
#define dggSourcePropagation_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggParallel.h"       // for ParallelFor
#include "dggVirtualSources.h" // for VirtualSources

#include <memory> // for the prepared faces
#include <vector> // for the results

namespace dgg
{
/// Elements that store a virtual source.
enum class PropagationQuality
{
  Fast, ///< one source per face
  High  ///< one source per edge: more accurate, and slower
};

struct PropagationOptions
{
  PropagationQuality Quality = PropagationQuality::Fast;
  /// Vertices farther than this are left unreached.
  double MaximumDistance = Infinity;
  bool WantNearestSource = false;
  bool WantVirtualSource = false; ///< needs the angles of the mesh
  ParallelFor Parallel;           ///< may be empty; the result does not depend on it
  ProgressCallback Progress;      ///< may be empty
};

struct PropagationResult
{
  std::vector<double> Distances; ///< per vertex; Infinity where unreached
  /// Per vertex, index into the sources; NoId where unreached. Empty unless requested.
  std::vector<Id> NearestSource;
  /// Virtual sources, see SearchResult. Empty unless requested.
  VirtualSources Virtual;
  /// False if the search ended before distances settled. The distances are then lengths of paths,
  /// but may be far too long.
  bool IsSettled = true;
};

class ProcessGroup;
class PropagationFaces;
class PropagationPieces;

/// Virtual source propagation (Trettner, Bommes and Kobbelt, "Geodesic distance computation via
/// virtual source propagation", 2021) on one mesh, which must outlive the object. A virtual source
/// is unfolded from face to face as long as the straight line from it to the next face crosses the
/// edge between them; otherwise the nearer end of the edge becomes the virtual source. Each face
/// (or edge) stores the best source that has reached it. No distance is longer than the shortest
/// path along mesh edges. Otherwise the error is unbounded: where sources pass a saddle vertex,
/// points in its shadow may be reached too early, and single vertices too late.
///
/// The implementation differs from the paper in five respects.
/// - Faces are visited in synchronous rounds over buckets of distance, so that the result does not
///   depend on the number of threads.
/// - Of sources at equal distance, up to rounding, the one with the smaller offset is kept: it
///   explains more of the mesh. On regular and flat meshes this determines the accuracy.
/// - A source that would reach an end of the edge earlier than any path found so far is moved so
///   that it does not, because that end lies in a shadow. This is skipped where no path can bend,
///   as in the plane.
/// - Corners of a face may be nearest to a source other than that of the face. A shorter path along
///   an edge, or from one of several sources that a face has rejected, is used for the vertex to
///   which it leads.
/// - Irregular vertices, and edges with many faces, store the best source as well and pass it on to
///   all their faces, at most once per round.
///
/// Computations use single precision, relative to the mean edge length and to the largest distance.
/// Any triangle complex is accepted. Run() may be called by several threads simultaneously.
class DGG_CORE_EXPORT SourcePropagation
{
public:
  explicit SourcePropagation(const SurfaceMesh& mesh);
  /// For a piece of a surface; `meanEdgeLength` is that of the surface.
  SourcePropagation(
    const SurfaceMesh& mesh, double meanEdgeLength, std::unique_ptr<PropagationPieces> pieces);
  ~SourcePropagation();
  SourcePropagation(const SourcePropagation&) = delete;
  SourcePropagation& operator=(const SourcePropagation&) = delete;

  /// Computes distances from the nearest source. Fails like ExactGeodesics::Run(), and if initial
  /// distances differ by more than 1e30 mean edge lengths. On some meshes of small needles,
  /// distances do not settle in single precision. The search then ends; see
  /// PropagationResult::IsSettled.
  Status Run(const std::vector<GeodesicSource>& sources, const PropagationOptions& options,
    PropagationResult& result) const;

  ///@{
  /// Functions for pieces, which all processes must call. `isUsable` becomes false on all processes
  /// if a vertex is irregular. RunPiece() is like Run(), but all sources must be valid. A source
  /// outside of the mesh has the vertex NoId. Distances are those at the corners of the
  /// faces of this process; nearest and virtual sources are not available. `inUse` are the bytes in
  /// use already.
  Status Prepare(ProcessGroup& group, bool& isUsable);
  Status RunPiece(ProcessGroup& group, const std::vector<GeodesicSource>& sources,
    const PropagationOptions& options, double inUse, PropagationResult& result) const;
  ///@}

private:
  const SurfaceMesh& Mesh;
  std::unique_ptr<PropagationPieces> Pieces; // null for an entire surface
  std::unique_ptr<PropagationFaces> Faces;
};
}

#endif
