// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rows of matrices of distances, on one or several processes. Internal.
#ifndef dggMatrixRows_h
#define dggMatrixRows_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggDistanceRows.h" // for RowConsumer
#include "dggGraphSearch.h"  // for seeds

#include <cstddef> // for std::size_t
#include <vector>  // for the points

namespace dgg
{
class ProcessGroup;
struct TaskContext;

/// Path between a vertex and a target.
struct TargetLink
{
  Id Target = NoId;
  Id Vertex = NoId;
  double Length = 0.0;
};

/// Rows that are requested.
struct MatrixRowOptions
{
  std::size_t NumberOfSources = 0;
  double SearchRadius = Infinity;    ///< see ManyOptions::MaximumDistance
  double MaximumDistance = Infinity; ///< largest distance in rows without targets
  bool Correct = false;              ///< see ManyOptions
  bool HasTargets = false;           ///< columns are targets; otherwise vertices
  bool IsSymmetric = false;          ///< if true, the row of source i begins with target i + 1
};

/// Sources and targets that are linked to a graph.
struct MatrixRowLinks
{
  std::vector<GraphSeed> Seeds;    ///< of all sources, by GraphSeed::Source
  std::vector<TargetLink> Targets; ///< of all targets, ascending
};

/// Finds the distances of all sources in the graph of `search`, on the surface of the context. The
/// other processes of the context find some of the rows. Rows contain reached columns only.
Status FindMatrixRows(const TaskContext& context, const GraphSearch& search,
  const MatrixRowLinks& links, const MatrixRowOptions& options, const ProgressCallback& progress,
  const RowConsumer& consume);

///@{
/// Steps of processes that help the first one, see TaskContext::Group. DismissHelpers() makes
/// HelpFirstProcess() return on the other processes, whose contexts need no surface.
DGG_CORE_EXPORT Status DismissHelpers(ProcessGroup& group);
DGG_CORE_EXPORT Status HelpFirstProcess(const TaskContext& context);
///@}
}

#endif
