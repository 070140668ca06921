// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along the graph of a surface that several processes have in pieces. Internal.
#ifndef dggPieceDistances_h
#define dggPieceDistances_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggParallel.h"   // for ProgressCallback
#include "dggStatus.h"     // for Status

namespace dgg
{
class PieceLinks;
class PieceSearch;
struct DistanceOutput;
struct DistanceRequest;
struct ProcessGroup;
struct SourceCollection;

/// Computes distances together with the other processes, and adds them as arrays of the points of
/// the piece. All distances are corrected if requested; arrays of the request receive the lengths
/// of paths, which are upper bounds. `links` finds the positions of the collection, and may be null
/// if there are none; `tolerance` and `accuracy` are those of PieceLinks::Find(). Collection,
/// request and other options must be the same on all processes. Virtual sources and sources of
/// points are not available.
DGG_CORE_EXPORT Status FindPieceDistances(const ProcessGroup& group, PieceSearch& search,
  PieceLinks* links, const SourceCollection& sources, double tolerance, bool correct,
  double accuracy, const DistanceRequest& request, const ProgressCallback& progress,
  DistanceOutput& output);
}

#endif
