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
  BucketQueue* const end = queues + count;
  while (std::all_of(queues, end, [](const BucketQueue& queue) { return queue.Current().empty(); }))
  {
    if (std::all_of(queues, end, [](const BucketQueue& queue) { return queue.Size == 0; }))
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (const BucketQueue* queue = queues; queue != end; ++queue)
      {
        for (const Entry& entry : queue->Overflow)
        {
          nearest = std::min<double>(nearest, entry.Key);
        }
      }
      if (nearest > LargestKey)
      {
        return false;
      }
      std::for_each(queues, end, [&](BucketQueue& queue) { queue.JumpTo(nearest); });
      continue;
    }
    for (BucketQueue* queue = queues; queue != end; ++queue)
    {
      ++queue->Cursor;
      if ((queue->Cursor & Mask) == 0 && !queue->Overflow.empty())
      {
        queue->PlaceOverflow();
      }
    }
  }
  return true;
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
