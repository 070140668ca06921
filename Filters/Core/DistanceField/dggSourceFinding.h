// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources of exact distances, graph distances, and arbitrary distances.
#ifndef dggSourceFinding_h
#define dggSourceFinding_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggExactGeodesics.h" // for ExactResult
#include "dggGraphSearch.h"    // for SearchResult
#include "dggParallel.h"       // for ParallelFor
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <vector> // for the sources

namespace dgg
{
/// Returns true if the path to a vertex continues straight through its tail. Otherwise the tail is
/// the relay of the vertex.
inline bool IsStraight(const VirtualSource& tail, const VirtualSource& vertex)
{
  return vertex.Offset == tail.Offset;
}

/// Merges virtual sources with their predecessors if the predecessors are better.
///
/// The last straight segment of a path to a vertex starts at its relay: a vertex at which the path
/// bends, or through which the path runs straight. Paths through the relay reach only a narrow
/// wedge behind the relay. Beside the wedge, distances are measured from the virtual source of the
/// relay itself, which may explain more distances around the vertex. Along the boundary of a hole
/// the wedges are as narrow as the segments are short, and faces may be long.
///
/// The distances of neighbors decide. If the model with the relay overestimates the distance of a
/// neighbor, another wavefront may be nearer. If the model of the preceding source underestimates
/// the distance, the preceding source is not visible from the neighbor. Therefore the preceding
/// source may only underestimate slightly in exchange for the distances that it explains.
class DGG_CORE_EXPORT RelayMerger
{
public:
  /// Relay length of vertices whose virtual source is a source of the run.
  static constexpr double NoRelay = -1.0;

  /// Tests all vertices with the relays as found. `relayLengths` contains, per vertex, the length
  /// of the virtual source of its relay, or NoRelay. The other arrays must outlive this object.
  RelayMerger(const SurfaceMesh& mesh, const std::vector<double>& distances,
    const VirtualSources& sources, std::vector<double> relayLengths, const ParallelFor& parallel);

  /// Returns the length of the virtual source of a vertex after merging, given that of its relay.
  double FindLength(Id v, double relayLength) const
  {
    return relayLength == this->RelayLengths[v] ? this->Lengths[v] : this->Lengthen(v, relayLength);
  }

private:
  double Lengthen(Id v, double relayLength) const;

  const SurfaceMesh& Mesh;
  const std::vector<double>& Distances;
  const VirtualSources& Sources;
  std::vector<double> RelayLengths;
  std::vector<double> Lengths; // if the relay is not merged
};

/// Finds the virtual source of each vertex for exact distances. A virtual source is the
/// pseudo-source at the start of the last straight segment of the path to the vertex. If the
/// preceding pseudo-source explains more distances, for example behind flat vertices, the preceding
/// one is used. `sources` are the sources of the run.
DGG_CORE_EXPORT void FindVirtualSources(const SurfaceMesh& mesh,
  const std::vector<GeodesicSource>& sources, const ExactResult& result, VirtualSources& found,
  const ParallelFor& parallel = ParallelFor());

/// Finds the virtual sources of a search, with relays merged, for distances inside faces. Offset
/// plus length of a virtual source equals the entry of `distances`, which contains the labels or
/// the corrected distances of the result. The virtual sources in `result` itself are meant for
/// vertices reached over further edges.
DGG_CORE_EXPORT void FindVirtualSources(const SurfaceMesh& mesh, const SearchResult& result,
  const std::vector<double>& distances, VirtualSources& found,
  const ParallelFor& parallel = ParallelFor());

/// Finds for each vertex the virtual source that best explains the distances of its neighbors. The
/// virtual source represents the direction and the curvature of the wavefront; the curvature is one
/// over the distance from the virtual source. Neighbors whose distance comes from another direction
/// have little weight. The field may be computed by any method, such as fast marching or heat; no
/// assumption is made about distances at sources.
///
/// `distances` are per vertex; Infinity or NaN if unreached. If nothing can be fitted, for example
/// at a source or an Irregular vertex, the virtual source is the vertex itself. Fails when stopped;
/// then `found` must not be used.
DGG_CORE_EXPORT Status FitVirtualSources(const SurfaceMesh& mesh, const double* distances,
  const ParallelFor& parallel, VirtualSources& found,
  const ProgressCallback& progress = ProgressCallback());
}

#endif
