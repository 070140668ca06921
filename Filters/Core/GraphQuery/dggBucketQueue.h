// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A queue that is sorted by distance only roughly: into buckets. Internal.
#ifndef dggBucketQueue_h
#define dggBucketQueue_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <limits>  // for LargestKey
#include <vector>  // for the buckets

namespace dgg
{
/// Vertices in buckets of one width of distance each. Within a bucket they come in no order, so the
/// search has to correct labels; but a push is an append, and it is known ahead what will be
/// popped, so that memory can be asked for in time. The buckets form a ring; entries beyond it wait
/// aside.
class alignas(64) BucketQueue // so that threads may have one each
{
public:
  struct Entry
  {
    float Key; ///< distance above the origin in bucket widths, rounded
    Id Vertex;
  };

  /// Start anew, empty. No distance may be below `origin`.
  void Reset(double origin, double width);

  /// The key under which a distance is entered. Always finite: distances without measure, which
  /// sources may start with, are all the same.
  float Key(double distance) const
  {
    const double place = (distance - this->Origin) * this->PerWidth;
    return place < LargestKey ? static_cast<float>(place) : LargestKey;
  }

  /// Distances below the current bucket go into the current bucket.
  void Push(double distance, Id vertex) { this->Place({ this->Key(distance), vertex }); }

  /// Returns true if entries with this distance belong before the current bucket.
  bool IsPast(double distance) const
  {
    return this->Key(distance) - this->First < static_cast<double>(this->Cursor);
  }

  /// Go to the first bucket that is not empty; false when there is none.
  bool Advance() { return Advance(this, 1); }
  /// The same with several queues of one origin and width, of which any has the first bucket. They
  /// must not be advanced otherwise.
  static bool Advance(BucketQueue* queues, std::size_t count);

  /// Remove the entries of the current bucket for which `isOutdated(entry)` holds.
  template <typename IsOutdated>
  void Sift(const IsOutdated& isOutdated)
  {
    std::vector<Entry>& bucket = this->Ring[this->Cursor & Mask];
    std::size_t kept = 0;
    for (const Entry& entry : bucket)
    {
      bucket[kept] = entry;
      kept += isOutdated(entry) ? 0 : 1;
    }
    this->Size -= bucket.size() - kept;
    bucket.resize(kept);
  }

  /// The entries of the current bucket. Grows while vertices are pushed.
  const std::vector<Entry>& Current() const { return this->Ring[this->Cursor & Mask]; }

  /// The entry that will come up `ahead` entries after the given one of the current bucket, as far
  /// as can be said now; null if there is none in this bucket or the next.
  const Entry* LookAhead(std::size_t index, std::size_t ahead) const
  {
    const std::vector<Entry>& bucket = this->Current();
    if (index + ahead < bucket.size())
    {
      return &bucket[index + ahead];
    }
    const std::vector<Entry>& next = this->Ring[(this->Cursor + 1) & Mask];
    const std::size_t place = index + ahead - bucket.size();
    return place < next.size() ? &next[place] : nullptr;
  }

  /// Empty the current bucket into `entries`, which are replaced.
  void TakeCurrent(std::vector<Entry>& entries)
  {
    entries.clear();
    entries.swap(this->Ring[this->Cursor & Mask]);
    this->Size -= entries.size();
  }

  /// Empty the current bucket.
  void ClearCurrent()
  {
    std::vector<Entry>& bucket = this->Ring[this->Cursor & Mask];
    this->Size -= bucket.size();
    bucket.clear();
  }

private:
  static constexpr std::size_t NumberOfBuckets = 256;
  static constexpr std::size_t Mask = NumberOfBuckets - 1;
  static constexpr float LargestKey = std::numeric_limits<float>::max();

  void Place(const Entry& entry)
  {
    const double ahead = entry.Key - this->First;
    if (!(ahead < static_cast<double>(this->Cursor + NumberOfBuckets)))
    {
      this->Aside.push_back(entry);
      return;
    }
    const auto bucket = ahead > 0.0 ? static_cast<std::size_t>(ahead) : 0;
    this->Ring[(bucket > this->Cursor ? bucket : this->Cursor) & Mask].push_back(entry);
    ++this->Size;
  }

  /// Put the entries that wait aside where they belong now.
  void PlaceAside();
  /// With an empty ring: go on at the given key, the nearest one aside.
  void JumpTo(double key);

  std::vector<Entry> Ring[NumberOfBuckets];
  std::vector<Entry> Aside;
  std::vector<Entry> Scratch;
  double Origin = 0.0;
  double PerWidth = 1.0;
  double First = 0.0;     ///< key of bucket 0
  std::size_t Cursor = 0; ///< current bucket
  std::size_t Size = 0;   ///< entries in the ring
};
}

#endif
