// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBucketQueue.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
void BucketQueue::Reset(double origin, double width)
{
  for (std::vector<Entry>& bucket : this->Ring)
  {
    bucket.clear();
  }
  this->Overflow.clear();
  this->Origin = origin;
  this->PerWidth = 1.0 / width;
  this->First = 0.0;
  this->Cursor = 0;
  this->Size = 0;
}

bool BucketQueue::Advance(BucketQueue* queues, std::size_t count)
{
  double next = Infinity;
  for (BucketQueue* queue = queues; queue != queues + count; ++queue)
  {
    next = std::min(next, queue->FindNext());
  }
  if (next == Infinity)
  {
    return false;
  }
  std::for_each(queues, queues + count, [&](BucketQueue& queue) { queue.AdvanceTo(next); });
  return true;
}

double BucketQueue::FindNext() const
{
  const double placed = this->First + static_cast<double>((this->Cursor | Mask) + 1);
  double next = Infinity;
  for (std::size_t b = this->Cursor; this->Size > 0 && next == Infinity; ++b)
  {
    next = this->Ring[b & Mask].empty() ? Infinity : this->First + static_cast<double>(b);
  }
  if (next >= placed) // where the overflow list may begin
  {
    for (const Entry& entry : this->Overflow)
    {
      next = std::min<double>(next, std::floor(entry.Key));
    }
  }
  return next;
}

void BucketQueue::AdvanceTo(double key)
{
  while (this->First + static_cast<double>(this->Cursor) < key)
  {
    if (this->Size == 0)
    {
      this->JumpTo(key);
      return;
    }
    ++this->Cursor;
    if ((this->Cursor & Mask) == 0 && !this->Overflow.empty())
    {
      this->PlaceOverflow();
    }
  }
}

void BucketQueue::PlaceOverflow()
{
  this->Scratch.swap(this->Overflow);
  for (const Entry& entry : this->Scratch)
  {
    this->Place(entry);
  }
  this->Scratch.clear();
}

void BucketQueue::JumpTo(double key)
{
  // The nearest entry is put into bucket 0, which ensures progress despite rounding.
  this->First = std::floor(key);
  this->Cursor = 0;
  this->PlaceOverflow();
}
}
