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
/// What keeps a virtual source of its own.
enum class PropagationQuality
{
  Fast, ///< each face
  High  ///< each edge: more accurate, and slower
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
  /// Per vertex, index into the sources; NoId where unreached. Empty unless asked for.
  std::vector<Id> NearestSource;
  /// As in SearchResult. Empty unless asked for.
  VirtualSources Virtual;
  /// False if the search ended before distances settled. They are lengths of paths that were found,
  /// and may be far too long.
  bool IsSettled = true;
};

class PropagationFaces;

/// Trettner, Bommes and Kobbelt, "Geodesic distance computation via virtual source propagation",
/// 2021, on one mesh, which must outlive it. A virtual source is unfolded from face to face, as
/// long as the straight line from it to the next face crosses the edge between them; else the
/// nearer end of the edge becomes the virtual source. Each face (or edge) keeps the best one that
/// has reached it. No distance is longer than the shortest way along mesh edges. Nothing else
/// bounds the error: where sources pass a saddle vertex, what lies in the shadow may be reached too
/// early, and single vertices too late.
///
/// Five things differ from the paper.
///  - Faces are visited in synchronous rounds over buckets of distance, so that the result does not
///    depend on the number of threads.
///  - Of sources that are equally near, up to rounding, that with the smaller offset is kept: it
///    explains more of the mesh. On regular and flat meshes this decides on the accuracy.
///  - A source that would reach an end of the edge earlier than any way found so far is moved to
///    where it does not: that end lies in a shadow. Not so where no way can bend, as in the plane.
///  - Faces have corners that are nearest to other sources than the one they keep. A way that is
///    shorter along an edge, or from one of several sources that a face has turned down, counts for
///    the vertex that it leads to.
///  - Irregular vertices, and edges of many faces, keep the best source as well and pass it on to
///    all their faces, once a round at most.
///
/// Single precision inside, relative to the mean edge and to the largest distance. Any triangle
/// complex will do. Run() may be called by several threads at once.
class DGG_CORE_EXPORT SourcePropagation
{
public:
  explicit SourcePropagation(const SurfaceMesh& mesh);
  ~SourcePropagation();
  SourcePropagation(const SourcePropagation&) = delete;
  SourcePropagation& operator=(const SourcePropagation&) = delete;

  /// Distances from the nearest of the sources. Fails as ExactGeodesics does, and with initial
  /// distances more than 1e30 mean edges apart. On some meshes of small needles, distances do
  /// not settle in single precision. The search then ends; see PropagationResult::IsSettled.
  Status Run(const std::vector<GeodesicSource>& sources, const PropagationOptions& options,
    PropagationResult& result) const;

private:
  const SurfaceMesh& Mesh;
  std::unique_ptr<PropagationFaces> Faces;
};
}

#endif
