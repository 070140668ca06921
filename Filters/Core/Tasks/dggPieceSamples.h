// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest point samples of a surface that several processes have in pieces. Internal.
#ifndef dggPieceSamples_h
#define dggPieceSamples_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status
#include "dggTypes.h"      // for Offset

namespace dgg
{
class PieceLinks;
class PieceSearch;
class PieceSurface;
class ProcessGroup;
struct Output;
struct SourceCollection;
struct TaskContext;

/// Options of samples in pieces, see SamplerOptions.
struct PieceSampleOptions
{
  Offset NumberOfSamples;
  double CoveringRadius;
  Offset FirstSample; ///< see SetFirstSample()
  double Tolerance;   ///< of given samples, see SourceCollection::Locate()
};

/// Computes samples at vertices together with the other processes, and writes them on the first one
/// as FindSamples() and WriteSamples() do. `start` has the given samples, if it is connected;
/// `links` may be null otherwise. `accuracy` is that of links. Collection and options must be the
/// same on all processes.
DGG_CORE_EXPORT Status FindPieceSamples(const TaskContext& context, ProcessGroup& group,
  const PieceSurface& surface, PieceSearch& search, PieceLinks* links, double accuracy,
  const SourceCollection& start, const PieceSampleOptions& options, Output& output);
}

#endif
