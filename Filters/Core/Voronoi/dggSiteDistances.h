// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of vertices from all sites that may be nearest in an adjacent face. Internal.
#ifndef dggSiteDistances_h
#define dggSiteDistances_h

#include "dggGraphSearch.h" // for GraphSeed
#include "dggGroups.h"      // for the lists

#include <cstddef> // for std::size_t
#include <vector>  // for seeds

namespace dgg
{
class FartherSites;
struct NearestSites;

/// Returns the indices of the seeds of distinct sites. A site with exactly the seeds of an earlier
/// one is a duplicate. `points` are the points of the seeds.
std::vector<std::size_t> ListDistinctSeeds(
  const std::vector<GraphSeed>& seeds, const std::vector<Offset>& points);

/// Returns the limit of labels that may matter in the faces around a vertex (SiteDistances), given
/// the label of the nearest site and MeasureReach(). Labels exceed distances by up to the accuracy.
inline double LimitOfLabel(const GraphInfo& info, double nearest, double reach)
{
  return nearest * (1.0 + info.Accuracy) + 2.0 * reach;
}

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

  /// Sets the entries: one list per vertex, sorted by site.
  void Set(bool hasVirtualSources, ValueLists<Entry> entries);
  /// Adds the list of a vertex, of final labels and estimates.
  static void AddList(
    const NearestSites& nearest, const FartherSites& farther, Id v, ValueLists<Entry>& entries);

  /// Returns the range of the sites of a vertex, sorted by index; empty if no site reaches it.
  const Entry* Begin(Id v) const { return this->Entries.Begin(v); }
  const Entry* End(Id v) const { return this->Entries.End(v); }

  /// Returns the entry of a site at a vertex; null if there is none.
  const Entry* Find(Id v, Id site) const;

  /// Returns the nearest site of a vertex, on ties that with the smallest index; null if unreached.
  const Entry* Nearest(Id v) const;

  /// Returns true if the graph has angles.
  bool HasVirtualSources() const { return this->HasDirections; }

private:
  bool HasDirections = false;
  ValueLists<Entry> Entries; // per vertex
};
}

#endif
