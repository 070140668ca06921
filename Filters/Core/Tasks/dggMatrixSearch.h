// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between two sets of surface points. Internal.
#ifndef dggMatrixSearch_h
#define dggMatrixSearch_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggDistanceRows.h"   // for DistanceRows
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggMemoryLimit.h"    // for MemoryBudget
#include "dggParallel.h"       // for ParallelFor
#include "dggSurfacePoint.h"   // for SurfacePoint

#include <cstddef> // for std::size_t
#include <vector>  // for the points

namespace dgg
{
class GraphSession;
struct TaskContext;

/// Allocates a matrix of Infinity. Writing the entries commits the memory. Fails if the matrix
/// would exceed the limit, or the matrix with a table that repeats it, or with another copy.
DGG_CORE_EXPORT Status AllocateMatrix(const MemoryBudget& memory, std::size_t rows,
  std::size_t columns, bool withTable, bool withCopy, Buffer<double>& matrix);

/// Returns entries that are Infinity. Writing them commits the memory.
DGG_CORE_EXPORT Buffer<double> MakeUnreached(std::size_t size);

/// Finds the distances of all pairs of a row and a column in a graph. `columns` are null if they
/// are the rows. `graph` must be up to date, and all entries of `matrix`, row by row, must be
/// Infinity. Entries without a path or above `radius` become `unreachedValue`.
///
/// A point that is not a vertex has links to vertices. A path between two such points uses a link
/// of each point, or is a straight path outside the graph.
DGG_CORE_EXPORT Status FindMatrix(const TaskContext& context, GraphSession& graph,
  const std::vector<SurfacePoint>& rows, const std::vector<SurfacePoint>* columns, double radius,
  double unreachedValue, double* matrix);

/// Copies a matrix that is stored row by row to one array per column.
DGG_CORE_EXPORT void CopyColumns(const double* matrix, std::size_t numberOfRows,
  const std::vector<double*>& columns, const ParallelFor& parallel);

/// Finds the distances up to `radius` from each source, corrected if requested and not on a cloud,
/// as compressed rows. `graph` must be up to date.
DGG_CORE_EXPORT Status FindDistanceRows(const TaskContext& context, GraphSession& graph,
  const std::vector<GeodesicSource>& sources, double radius, bool correct, DistanceRows& rows);
}

#endif
