// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sparse matrices of distances.
#ifndef dggDistanceRows_h
#define dggDistanceRows_h

#include "dggBuffer.h"      // for the arrays
#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggGraphSearch.h" // for GraphSearch

#include <vector> // for the sources

namespace dgg
{
class PreparedSurface;

/// Distances from some sources to the points around each of them, as compressed rows.
struct DistanceRows
{
  Buffer<Offset> Offsets; ///< row i is [Offsets[i], Offsets[i + 1])
  Buffer<Id> Columns;     ///< points, ascending in each row
  Buffer<double> Distances;
};

struct DistanceRowsOptions
{
  double MaximumDistance = Infinity; ///< largest distance that is stored
  double SearchRadius = Infinity;    ///< at least MaximumDistance; limits the search
  bool Correct = false;              ///< see ManyOptions
  double MemoryLimit = Infinity;     ///< maximum size of the rows in bytes
  /// Per point, the next point that is merged into the same vertex; NoId after the last point. The
  /// first point of a vertex has the id of the vertex. Empty if no points are merged.
  std::vector<Id> NextPoints;
};

/// Returns the value of DistanceRowsOptions::NextPoints for a surface.
DGG_CORE_EXPORT std::vector<Id> FindNextPoints(const PreparedSurface& surface);

/// Computes one row per source. The cost is proportional to the number of entries if most of the
/// surface is outside the radius. The rows do not depend on the number of threads.
DGG_CORE_EXPORT Status FindDistanceRows(const GraphSearch& search,
  const std::vector<std::vector<GraphSeed>>& sources, const DistanceRowsOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, DistanceRows& rows);
}

#endif
