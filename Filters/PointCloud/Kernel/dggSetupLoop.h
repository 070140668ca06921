// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops over the points of a cloud, with one progress. Internal.
#ifndef dggSetupLoop_h
#define dggSetupLoop_h

#include "dggBlockLoop.h" // for ForBlocks()

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t

namespace dgg
{
/// The loops of a setup, each of which has a share of its progress. Once stopped, nothing runs any
/// more.
class SetupLoop
{
public:
  SetupLoop(const ParallelFor& parallel, const ProgressCallback& progress)
    : Parallel(parallel)
    , Progress(progress)
  {
  }

  bool IsStopped() const { return this->Stopped; }

  /// All steps so far have made that part of the progress.
  void FinishAt(double done) { this->Done = done; }
  /// A step of that share has been made, outside of these loops.
  void Skip(double share) { this->Done += share; }
  /// Report a part of a step that has that share. False when stopped.
  bool Report(double share, double part)
  {
    this->Stopped = this->Stopped ||
      (this->Progress && !this->Progress(std::min(1.0, this->Done + share * part)));
    return !this->Stopped;
  }

  /// Run `body(begin, end)` over [0, size), in several threads. False when stopped.
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

  /// The same over nodes: `body(begin, end)` takes their numbers. Pieces are smaller where a node
  /// takes `cost` times as long as in most loops.
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
  double Done = 0.0;    ///< of all steps
  bool Stopped = false; ///< by the caller
};
}

#endif
