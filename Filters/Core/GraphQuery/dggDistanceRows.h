// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sparse matrices of distances.
#ifndef dggDistanceRows_h
#define dggDistanceRows_h

#include "dggBuffer.h"     // for the arrays
#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status
#include "dggTypes.h"      // for ids

#include <cstddef>    // for std::size_t
#include <functional> // for RowConsumer
#include <vector>     // for rows

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

/// Distance from the source of a row.
struct RowEntry
{
  Id Column;
  double Distance;
};

/// Entries of a row, with ascending columns.
using DistanceRow = std::vector<RowEntry>;
/// Sorts entries by column.
void SortRow(DistanceRow& row);

/// Receives the row of a source, which may be moved. Called in any order, by several threads
/// simultaneously.
using RowConsumer = std::function<void(std::size_t source, DistanceRow& row)>;

/// Fails if the rows that are stored so far exceed the limit in bytes.
Status CheckRows(double bytes, double limit);

struct DistanceRowsOptions
{
  double MemoryLimit = Infinity; ///< maximum size of the rows in bytes
  /// Per point, the next point that is merged into the same vertex; NoId after the last point. The
  /// first point of a vertex has the id of the vertex. Empty if no points are merged.
  std::vector<Id> NextPoints;
};

/// Returns the value of DistanceRowsOptions::NextPoints for a surface.
DGG_CORE_EXPORT std::vector<Id> FindNextPoints(const PreparedSurface& surface);

/// Compresses the rows of `numberOfSources` sources. `search` passes all rows to a consumer; their
/// columns are vertices.
DGG_CORE_EXPORT Status CompressRows(std::size_t numberOfSources,
  const std::function<Status(const ProgressCallback&, const RowConsumer&)>& search,
  const DistanceRowsOptions& options, const ProgressCallback& progress, DistanceRows& rows);
}

#endif
