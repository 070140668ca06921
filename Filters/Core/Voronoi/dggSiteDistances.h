// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of vertices from all sites that may be nearest in an adjacent face. Internal.
#ifndef dggSiteDistances_h
#define dggSiteDistances_h

#include "dggGraphSearch.h" // for GraphSeed

#include <vector> // for the lists

namespace dgg
{
/// For each vertex, the distances from the nearest site and from all sites that may be nearest at a
/// point of an adjacent face.
///
/// If site j is nearest at a point p of a face of vertex v, then d(j, v) <= d(j, p) + |pv| <= d(v)
/// + 2 |pv|, where d(v) is the distance from the nearest site. Hence all sites are needed whose
/// excess d(j, v) - d(v) is at most twice the longest edge of the faces around v. Along a shortest
/// path from j the excess never decreases, as d grows by at most the length of each step. Therefore
/// labels with a larger excess need not be followed, and few labels are computed away from the
/// borders of cells.
class SiteDistances
{
public:
  struct Entry
  {
    Id Site;
    double Distance;      ///< the estimate (see SearchResult::Corrected)
    VirtualSource Source; ///< unspecified unless HasVirtualSources()
  };

  /// The Source of a seed is its site, from 0 on; initial distances are not allowed. A site with
  /// exactly the seeds of an earlier one is ignored: its cell is empty. Fails like
  /// GraphSearch::Run().
  Status Run(const GraphSearch& search, const SurfaceMesh& mesh,
    const std::vector<GraphSeed>& seeds, const ProgressCallback& progress);

  /// Returns the range of the sites of a vertex, sorted by index; empty if no site reaches it.
  const Entry* Begin(Id v) const { return this->Entries.data() + this->Offsets[v]; }
  const Entry* End(Id v) const { return this->Entries.data() + this->Offsets[v + 1]; }

  /// Returns the entry of a site at a vertex; null if there is none.
  const Entry* Find(Id v, Id site) const;

  /// Returns the nearest site of a vertex, on ties that with the smallest index; null if unreached.
  const Entry* Nearest(Id v) const;

  /// Returns true if the graph has angles.
  bool HasVirtualSources() const { return this->HasDirections; }

private:
  bool HasDirections = false;
  std::vector<Offset> Offsets; ///< per vertex, plus one
  std::vector<Entry> Entries;
};
}

#endif
