// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationRounds.h"

#include <algorithm>
#include <limits>

namespace dgg
{
namespace
{
/// Rounds are narrowed if slots are propagated more often than this on average, over a window of
/// this many labels.
constexpr std::size_t MostLabelsPerSlot = 3;
constexpr std::size_t LabelsPerWindow = 1024;
}

PropagationRounds::PropagationRounds(int threads)
  : Queues(static_cast<std::size_t>(threads))
{
  for (BucketQueue& queue : this->Queues)
  {
    queue.Reset(0.0, 1.0);
  }
}

/// The set of outdated entries depends on the threads and must not affect the contents of a round.
bool PropagationRounds::Next(
  const PropagationSlot* slots, std::vector<std::vector<BucketQueue::Entry>>& entries)
{
  const auto isFarther = [](const BucketQueue::Entry& a, const BucketQueue::Entry& b) {
    return a.Key > b.Key;
  };
  const auto isOutdated = [&](const BucketQueue::Entry& entry) {
    const PropagationSlot& slot = slots[entry.Vertex];
    return !slot.IsPending.load(std::memory_order_relaxed) ||
      slot.Key.load(std::memory_order_relaxed) != entry.Key;
  };
  const auto pop = [&] {
    std::pop_heap(this->Near.begin(), this->Near.end(), isFarther);
    this->Near.pop_back();
  };
  const auto dropOutdated = [&] {
    while (!this->Near.empty() && isOutdated(this->Near.front()))
    {
      pop();
    }
  };
  std::vector<BucketQueue::Entry>& chosen = entries.front();
  do
  {
    dropOutdated();
    const bool wasEmpty = this->Near.empty();
    if (wasEmpty && !BucketQueue::Advance(this->Queues.data(), this->Queues.size()))
    {
      return false;
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      this->Queues[i].TakeCurrent(entries[i]);
    }
    if (wasEmpty && this->Width == 1.0F)
    {
      return true;
    }
    for (std::vector<BucketQueue::Entry>& some : entries)
    {
      for (const BucketQueue::Entry& entry : some)
      {
        this->Near.push_back(entry);
        std::push_heap(this->Near.begin(), this->Near.end(), isFarther);
      }
      some.clear();
    }
    dropOutdated();
    const float end = this->Near.empty() ? 0.0F : this->Near.front().Key + this->Width;
    while (!this->Near.empty() && this->Near.front().Key <= end)
    {
      if (!isOutdated(this->Near.front()))
      {
        chosen.push_back(this->Near.front());
      }
      pop();
    }
  } while (chosen.empty());
  return true;
}

/// Labels that were propagated too early are propagated again: if triangles are much smaller than
/// the mean edge, thousands of times.
void PropagationRounds::AdjustWidth(std::size_t labels, std::size_t known)
{
  this->WindowLabels += labels;
  this->WindowKnown += known;
  if (this->WindowLabels < LabelsPerWindow)
  {
    return;
  }
  const std::size_t fresh = this->WindowLabels - this->WindowKnown;
  if (this->WindowLabels > MostLabelsPerSlot * fresh)
  {
    this->Width = std::max(0.25F * this->Width, std::numeric_limits<float>::min());
  }
  else if (2 * this->WindowLabels < MostLabelsPerSlot * fresh)
  {
    this->Width = std::min(2.0F * this->Width, 1.0F);
  }
  this->WindowLabels = 0;
  this->WindowKnown = 0;
}
}
