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
  this->Aside.clear();
  this->Origin = origin;
  this->PerWidth = 1.0 / width;
  this->First = 0.0;
  this->Cursor = 0;
  this->Size = 0;
}

bool BucketQueue::Advance()
{
  for (;;)
  {
    if (this->Size == 0)
    {
      if (this->Aside.empty())
      {
        return false;
      }
      this->JumpAside();
    }
    if (!this->Ring[this->Cursor & Mask].empty())
    {
      return true;
    }
    ++this->Cursor;
    if ((this->Cursor & Mask) == 0 && !this->Aside.empty())
    {
      this->PlaceAside();
    }
  }
}

void BucketQueue::PlaceAside()
{
  this->Scratch.swap(this->Aside);
  for (const Entry& entry : this->Scratch)
  {
    this->Place(entry);
  }
  this->Scratch.clear();
}

void BucketQueue::JumpAside()
{
  const auto nearest = std::min_element(this->Aside.begin(), this->Aside.end(),
    [](const Entry& a, const Entry& b) { return a.Key < b.Key; });
  // The nearest one lands in bucket 0, so that there is progress whatever rounding does.
  this->First = std::floor(static_cast<double>(nearest->Key));
  this->Cursor = 0;
  this->PlaceAside();
}
}
