// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Unites the two copies of a graph edge that were found from its two ends. Internal.
#ifndef dggDirectionUnion_h
#define dggDirectionUnion_h

#include "dggParallel.h"      // for ParallelFor
#include "dggRowStore.h"      // for RowStore
#include "dggWorkspacePool.h" // for the workspaces

#include <cstdint> // for places
#include <vector>  // for the workspaces

namespace dgg
{
/// Unites both directions of edges. If an edge was found from both ends, only the copy in the row
/// of the earlier vertex is kept, with the shorter of the two paths. Of equally long paths the one
/// that was found from the vertex with the smaller id is kept, so that the edge does not depend on
/// the order of rows.
class DirectionUnion
{
public:
  /// `ids` is the id of the vertex of each row.
  explicit DirectionUnion(const std::vector<Id>& ids)
    : Ids(ids)
  {
  }

  /// Unites the rows from `first` on. `first` is the first row that has not been united with the
  /// rows before it.
  void Unite(RowStore& rows, Id first, const ParallelFor& parallel);

private:
  /// An edge whose reverse edge is sought.
  struct Wanted
  {
    Offset Edge; ///< index of the edge; its target is an earlier row
    Id Row;      ///< row of the edge
    Id Next;     ///< next candidate with the same target, NoId after the last
  };

  /// Data of one block of rows. Rows are long, and searching reverse edges row by row would read
  /// the earlier rows repeatedly. Therefore the edges of a block are first grouped by target, and
  /// each target row is read once.
  class Workspace
  {
  public:
    /// Processes rows [begin, end), at most RowsAtOnce. Sets the flags of edges to be removed;
    /// flags[0] belongs to the edge `base`.
    void Unite(const std::vector<Id>& ids, RowStore& rows, Id begin, Id end, Offset base,
      unsigned char* flags);

  private:
    std::vector<Id> Heads; ///< per target, head of its list in AllWanted, or NoId
    std::vector<Id> Targets;
    std::vector<Wanted> AllWanted;
    std::vector<std::uint32_t> Found; ///< rows with a reverse edge, relative to `begin`
    std::vector<Offset> WaysBack;     ///< per row, the edge from the current target, or -1
  };
  static constexpr Id RowsAtOnce = 256;

  const std::vector<Id>& Ids;
  WorkspacePool<Workspace> Workspaces;
  std::vector<unsigned char> IsDouble; ///< per edge of the new rows, 1 if to be removed
};
}

#endif
