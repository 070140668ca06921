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
Status PropagationRounds::Next(const PropagationSlot* slots, const PropagationPieces* pieces,
  std::vector<std::vector<BucketQueue::Entry>>& entries, bool& isOver)
{
  const auto findLeast = [&](double& value) {
    return pieces ? pieces->FindLeast(value) : Status::Success();
  };
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
  constexpr double BeforeBuckets = -1.0;
  std::vector<BucketQueue::Entry>& chosen = entries.front();
  for (bool isAnyChosen = false; !isAnyChosen;)
  {
    dropOutdated();
    double next = this->Near.empty() ? Infinity : BeforeBuckets;
    for (std::size_t i = 0; i < this->Queues.size() && next != BeforeBuckets; ++i)
    {
      next = std::min(next, this->Queues[i].FindNext());
    }
    DGG_RETURN_IF_ERROR(findLeast(next));
    isOver = next == Infinity;
    if (isOver)
    {
      return Status::Success();
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      this->Queues[i].AdvanceTo(next);
      this->Queues[i].TakeCurrent(entries[i]);
    }
    if (next != BeforeBuckets && this->Width == 1.0F)
    {
      return Status::Success();
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
    double nearest = this->Near.empty() ? Infinity : this->Near.front().Key;
    DGG_RETURN_IF_ERROR(findLeast(nearest));
    const float end = static_cast<float>(nearest) + this->Width;
    while (!this->Near.empty() && this->Near.front().Key <= end)
    {
      if (!isOutdated(this->Near.front()))
      {
        chosen.push_back(this->Near.front());
      }
      pop();
    }
    double none = chosen.empty() ? 1.0 : 0.0; // 0 if a process has chosen labels
    DGG_RETURN_IF_ERROR(findLeast(none));
    isAnyChosen = none == 0.0;
  }
  return Status::Success();
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
