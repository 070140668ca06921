// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops over the points of a cloud with a common progress. Internal.
#ifndef dggSetupLoop_h
#define dggSetupLoop_h

#include "dggBlockLoop.h" // for ForBlocks()

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t

namespace dgg
{
/// Runs the loops of a setup, each with a weight in the total progress. After a stop, no further
/// loop runs.
class SetupLoop
{
public:
  SetupLoop(const ParallelFor& parallel, const ProgressCallback& progress)
    : Parallel(parallel)
    , Progress(progress)
  {
  }

  bool IsStopped() const { return this->Stopped; }

  /// Sets the total progress after all steps so far.
  void FinishAt(double done) { this->Done = done; }
  /// Adds the progress weight of a step that was run elsewhere.
  void Skip(double share) { this->Done += share; }
  /// Reports the fraction `part` of a step with the progress weight `share`. Returns false if
  /// stopped.
  bool Report(double share, double part)
  {
    this->Stopped = this->Stopped ||
      (this->Progress && !this->Progress(std::min(1.0, this->Done + share * part)));
    return !this->Stopped;
  }

  /// Runs `body(begin, end)` over [0, size) in several threads, in blocks of `grain`. Returns false
  /// if stopped.
  template <typename Body>
  bool ForPieces(Offset size, Offset grain, double share, Body&& body)
  {
    if (!this->Stopped)
    {
      const ProgressCallback part = ProgressPart(this->Progress, this->Done, this->Done + share);
      const Status status = ForBlocks(size, grain, this->Parallel, part,
        [&](Offset, Offset begin, Offset end, const ProgressCallback&) {
          body(begin, end);
          return Status::Success();
        });
      this->Stopped = !status.IsOk();
    }
    this->Done += share;
    return !this->Stopped;
  }

  /// Like ForPieces(), over node ids. Blocks are smaller if a node takes `cost` times as long as in
  /// most loops.
  template <typename Body>
  bool ForNodes(std::size_t nodes, double share, Body&& body, std::size_t cost = 1)
  {
    const Offset grain =
      std::max<Offset>(1, NodesPerBlock / std::max<Offset>(1, static_cast<Offset>(cost)));
    return this->ForPieces(static_cast<Offset>(nodes), grain, share,
      [&](Offset begin, Offset end) { body(static_cast<Id>(begin), static_cast<Id>(end)); });
  }

private:
  static constexpr Offset NodesPerBlock = 1024;

  const ParallelFor& Parallel;
  const ProgressCallback& Progress;
  double Done = 0.0;    ///< total progress so far, from 0 to 1
  bool Stopped = false; ///< true if the caller has stopped the setup
};
}

#endif
