// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Selects the labels that are propagated in each round. Internal.
#ifndef dggPropagationRounds_h
#define dggPropagationRounds_h

#include "dggBucketQueue.h"       // for the queue
#include "dggPropagationPieces.h" // for other processes
#include "dggPropagationLabel.h"  // for labels

#include <atomic>  // for shared data
#include <cstddef> // for std::size_t
#include <vector>  // for entries

namespace dgg
{
/// The best label of a face or an edge.
struct alignas(32) PropagationSlot // does not straddle cache lines
{
  std::atomic<float> Key;
  std::atomic<bool> IsPending; ///< changed since it was last propagated
  std::atomic<bool> IsLocked;
  float Threshold; ///< upper limit of new keys: last propagated key minus rounding
  PropagationLabel Best;

  void Clear()
  {
    this->Key.store(UnreachedKey, std::memory_order_relaxed);
    this->IsPending.store(false, std::memory_order_relaxed);
    this->IsLocked.store(false, std::memory_order_relaxed);
    this->Threshold = UnreachedKey;
    this->Best = { 0.0F, 0.0F, 0.0F, NoId, NoId };
  }
};

/// Slots that wait to be propagated, nearest first: a round takes a bucket with a width of one mean
/// edge, or a part of a bucket if triangles are much smaller. Each thread has its own queue, since
/// the entries that it has pushed are in its cache. The contents of a round do not depend on the
/// assignment to threads.
class PropagationRounds
{
public:
  explicit PropagationRounds(int threads);

  void Push(int thread, float key, Id slot) { this->Queues[thread].Push(key, slot); }
  /// Gets the entries of the next round, per thread. `isOver` becomes true if none are left. The
  /// rounds of all processes are the same; `pieces` is null if there are no others.
  Status Next(const PropagationSlot* slots, const PropagationPieces* pieces,
    std::vector<std::vector<BucketQueue::Entry>>& entries, bool& isOver);
  /// Adapts the width after a round, given the number of propagated labels, and of labels from
  /// slots that had been propagated before.
  void AdjustWidth(std::size_t labels, std::size_t known);

private:
  std::vector<BucketQueue> Queues;
  /// If buckets are too wide: a heap of the entries up to the current bucket, the nearest one in
  /// front.
  std::vector<BucketQueue::Entry> Near;
  float Width = 1.0F;
  std::size_t WindowLabels = 0;
  std::size_t WindowKnown = 0;
};
}

#endif
