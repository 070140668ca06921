// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances from all sites that may be nearest, on a surface in pieces. Internal.
#ifndef dggPieceSites_h
#define dggPieceSites_h

#include "dggFartherSites.h"  // for labels
#include "dggGroups.h"        // for lists
#include "dggPieceSearch.h"   // for the search
#include "dggSiteDistances.h" // for the distances

#include <vector> // for the lists

namespace dgg
{
class PieceSurface;

/// Finds the entries of SiteDistances at the points of a surface in pieces. Each process lowers the
/// labels of its vertices, and sends improved labels of vertices that are ghosts elsewhere, until
/// no label improves. Estimates are then sent in the same manner. All functions must be called by
/// all processes.
class PieceSites
{
public:
  using Lists = ValueLists<SiteDistances::Entry>;

  /// The arguments must outlive this object.
  PieceSites(PieceSearch& search, const PieceSurface& surface);

  /// Computes the entries of SiteDistances::Run() on the entire surface, for the points of the
  /// piece that belong to this process. `isUsable` becomes false on all processes for the reasons
  /// of PieceSearch::Run().
  Status Run(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
    const ProgressCallback& progress, Lists& entries, bool& isUsable);

private:
  /// Process and index in PieceSearch::GetSent() of a vertex.
  struct Reader
  {
    std::size_t Process;
    Id Index;
  };

  Status FindNearest(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
    const ProgressCallback& progress, NearestSites& nearest, bool& isUsable) const;
  std::vector<double> FindLimits(const NearestSites& nearest) const;
  Status FindLabels(ProcessGroup& group, FartherSites& farther, const ProgressCallback& progress);
  Status FindEstimates(ProcessGroup& group, FartherSites& farther, bool& isUsable);
  template <typename Value>
  Status Exchange(ProcessGroup& group, const FartherSites& farther, const std::vector<Id>& labels,
    const Value& valueOf, std::vector<Message>& messages, bool& isOver) const;

  PieceSearch& Search;
  const PieceSurface& Surface;
  std::vector<Reader> Readers;
  Groups ReadersOf; // per vertex, members of Readers
};
}

#endif
