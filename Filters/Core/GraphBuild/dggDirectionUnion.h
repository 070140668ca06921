// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Makes one edge of what was found from both of its ends. Internal.
#ifndef dggDirectionUnion_h
#define dggDirectionUnion_h

#include "dggParallel.h"      // for ParallelFor
#include "dggRowStore.h"      // for RowStore
#include "dggWorkspacePool.h" // for the workspaces

#include <cstdint> // for places
#include <vector>  // for the workspaces

namespace dgg
{
/// Unites both directions: of an edge that was found from both ends, only the copy in the row of
/// the vertex that comes first is kept; it takes over the other way if that is shorter.
class DirectionUnion
{
public:
  /// `first` is the first row that has not been united with the rows before it.
  void Unite(RowStore& rows, Id first, const ParallelFor& parallel);

private:
  /// An edge whose way back is looked for.
  struct Wanted
  {
    Offset Edge; ///< to an earlier row
    Id Row;      ///< that it is in
    Id Next;     ///< of those to the same row, NoId after the last
  };

  /// Rows are long, and looking for the way back row by row would read the earlier ones again and
  /// again. So the edges of some rows are gathered by target first, and each target is read once.
  class Workspace
  {
  public:
    /// Rows [begin, end), not more than RowsAtOnce. Flags, from the edge `base` on, are set for
    /// what is not to be kept.
    void Unite(RowStore& rows, Id begin, Id end, Offset base, unsigned char* flags);

  private:
    std::vector<Id> Heads; ///< by target: the last one wanted; else NoId
    std::vector<Id> Targets;
    std::vector<Wanted> AllWanted;
    std::vector<std::uint32_t> Found; ///< rows with a way back from there, from the first in hand
    std::vector<Offset> WaysBack;     ///< by row: edge of the target in hand; else -1
  };
  static constexpr Id RowsAtOnce = 256;

  WorkspacePool<Workspace> Workspaces;
};
}

#endif
