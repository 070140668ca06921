// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which labels of virtual sources are propagated at one time. Internal.
#ifndef dggPropagationRounds_h
#define dggPropagationRounds_h

#include "dggBucketQueue.h"      // for the queue
#include "dggPropagationLabel.h" // for labels

#include <atomic>  // for what threads share
#include <cstddef> // for std::size_t
#include <vector>  // for entries

namespace dgg
{
/// The best label of a face or an edge.
struct alignas(32) PropagationSlot // not on two cache lines
{
  std::atomic<float> Key;
  std::atomic<bool> IsPending; ///< has changed and not been propagated since
  std::atomic<bool> IsLocked;
  float Threshold; ///< what a key has to be below: that propagated last, less rounding
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

/// Slots that wait to be propagated, nearest first: a round takes a bucket one mean edge wide, or a
/// part of one where triangles are much smaller than that. Each thread has a queue of its own: what
/// it has pushed is in its cache. Which thread that is does not change what a round consists of.
class PropagationRounds
{
public:
  explicit PropagationRounds(int threads);

  void Push(int thread, float key, Id slot) { this->Queues[thread].Push(key, slot); }
  /// Which entries to look at in the next round, by threads; false when there are none left.
  bool Next(const PropagationSlot* slots, std::vector<std::vector<BucketQueue::Entry>>& entries);
  /// After a round: how many labels it has propagated, and how many of slots that had been
  /// propagated before.
  void AdjustWidth(std::size_t labels, std::size_t known);

private:
  std::vector<BucketQueue> Queues;
  /// Where buckets are too wide: entries up to the current bucket, the nearest one in front.
  std::vector<BucketQueue::Entry> Near;
  float Width = 1.0F;
  std::size_t WindowLabels = 0;
  std::size_t WindowKnown = 0;
};
}

#endif
