// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of vertices from all sites that may matter around them. Internal.
#ifndef dggSiteDistances_h
#define dggSiteDistances_h

#include "dggGraphSearch.h" // for GraphSeed

#include <vector> // for the lists

namespace dgg
{
/// For each vertex, the distances from the nearest site and from all sites that may be the nearest
/// one of a point of a face around it.
///
/// If site j is the nearest one of a point p of a face of vertex v, then
/// d(j, v) <= d(j, p) + |pv| <= d(v) + 2 |pv|, where d(v) is the distance from the nearest site: so
/// all sites are needed whose excess d(j, v) - d(v) is at most twice the longest edge of the faces
/// around v. Along a shortest path from j the excess never shrinks, as d grows by no more than the
/// length of each step. So labels with a larger excess need not be followed, and few labels are
/// found away from the borders of cells.
class SiteDistances
{
public:
  struct Entry
  {
    Id Site;
    double Distance;      ///< the estimate (see SearchResult::Corrected)
    VirtualSource Source; ///< unspecified unless HasVirtualSources()
  };

  /// Sources of the seeds are the sites, from 0 on, without initial distances. A site with the very
  /// seeds of an earlier one is left out: it has no points. Fails as GraphSearch::Run() does.
  Status Run(const GraphSearch& search, const SurfaceMesh& mesh,
    const std::vector<GraphSeed>& seeds, const ProgressCallback& progress);

  /// The sites of a vertex, by their numbers; none where no site reaches.
  const Entry* Begin(Id v) const { return this->Entries.data() + this->Offsets[v]; }
  const Entry* End(Id v) const { return this->Entries.data() + this->Offsets[v + 1]; }

  /// The nearest one, of several at the same distance the one with the smallest number; null where
  /// no site reaches.
  const Entry* Nearest(Id v) const;

  /// True if the graph has angles.
  bool HasVirtualSources() const { return this->HasDirections; }

private:
  bool HasDirections = false;
  std::vector<Offset> Offsets; ///< per vertex, and one more
  std::vector<Entry> Entries;
};
}

#endif
