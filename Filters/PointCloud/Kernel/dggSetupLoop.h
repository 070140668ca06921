// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops over the points of a cloud that tell of progress. Internal.
#ifndef dggSetupLoop_h
#define dggSetupLoop_h

#include "dggParallel.h" // for ParallelFor
#include "dggTypes.h"    // for Id, Offset

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t

namespace dgg
{
/// The loops of a setup, each of which has a share of its progress. They run in pieces between
/// which the caller is told how far it is, and may ask to stop: nothing runs any more then.
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
  /// A step of that share has been made.
  void Skip(double share) { this->Done += share; }

  /// Tell of a part of a step that has that share. False when stopped.
  bool Tell(double share, double part)
  {
    this->Stopped = this->Stopped ||
      (this->Progress && !this->Progress(std::min(1.0, this->Done + share * part)));
    return !this->Stopped;
  }

  /// Run `body(begin, end)` over [0, size), in several threads. False when stopped.
  template <typename Body>
  bool ForPieces(Offset size, Offset grain, double share, Body&& body)
  {
    const Offset piece = PiecesPerReport * grain;
    for (Offset first = 0; first < size && !this->Stopped; first += piece)
    {
      const Offset count = std::min(piece, size - first);
      ForRange(this->Parallel, count, grain,
        [&](Offset begin, Offset end) { body(first + begin, first + end); });
      this->Tell(share, static_cast<double>(first + count) / static_cast<double>(size));
    }
    this->Done += share;
    return !this->Stopped;
  }

  /// The same over nodes: `body(begin, end)` takes their numbers. Pieces are smaller where a node
  /// takes `cost` times as long as in most loops.
  template <typename Body>
  bool ForNodes(std::size_t nodes, std::size_t cost, double share, Body&& body)
  {
    const Offset grain =
      std::max<Offset>(1, NodesPerTask / std::max<Offset>(1, static_cast<Offset>(cost)));
    return this->ForPieces(static_cast<Offset>(nodes), grain, share,
      [&](Offset begin, Offset end) { body(static_cast<Id>(begin), static_cast<Id>(end)); });
  }
  template <typename Body>
  bool ForNodes(std::size_t nodes, double share, Body&& body)
  {
    return this->ForNodes(nodes, 1, share, body);
  }

  /// Do a single thing that cannot be interrupted. False when stopped.
  template <typename Body>
  bool ForOne(double share, Body&& body)
  {
    if (!this->Stopped)
    {
      body();
      this->Tell(share, 1.0);
    }
    this->Done += share;
    return !this->Stopped;
  }

private:
  static constexpr Offset NodesPerTask = 64;
  /// Tasks of a loop between two reports of progress.
  static constexpr Offset PiecesPerReport = 64;

  const ParallelFor& Parallel;
  const ProgressCallback& Progress;
  double Done = 0.0;    ///< of all steps
  bool Stopped = false; ///< by the caller
};
}

#endif
