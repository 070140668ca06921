// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A queue that sorts by distance only approximately, into buckets. Internal.
#ifndef dggBucketQueue_h
#define dggBucketQueue_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <limits>  // for LargestKey
#include <vector>  // for the buckets

namespace dgg
{
/// Vertices in buckets that cover distance ranges of equal width. The order within a bucket is
/// arbitrary, so the search has to correct labels. In return, a push is an append, and the next
/// vertices are known in advance, so that their memory can be prefetched. The buckets form a ring;
/// entries beyond the ring are stored in an overflow list.
class alignas(64) BucketQueue // avoids false sharing between the queues of threads
{
public:
  struct Entry
  {
    float Key; ///< distance above the origin in bucket widths, rounded
    Id Vertex;
  };

  /// Empties the queue and sets the bucket width. Distances below `origin` must not be pushed.
  void Reset(double origin, double width);

  /// Returns the key of a distance. The key is always finite: all extremely large distances, such
  /// as initial distances of sources may be, have the same key.
  float Key(double distance) const
  {
    const double place = (distance - this->Origin) * this->PerWidth;
    return place < LargestKey ? static_cast<float>(place) : LargestKey;
  }

  /// Adds a vertex. Distances below the current bucket are put into the current bucket.
  void Push(double distance, Id vertex) { this->Place({ this->Key(distance), vertex }); }

  /// Returns true if entries with this distance belong before the current bucket.
  bool IsPast(double distance) const
  {
    return this->Key(distance) - this->First < static_cast<double>(this->Cursor);
  }

  /// Advances to the first non-empty bucket. Returns false if all buckets are empty.
  bool Advance() { return Advance(this, 1); }
  /// Advances several queues with the same origin and width to the first bucket that is non-empty
  /// in any of them. Returns false if all buckets are empty. Such queues must not be advanced
  /// separately.
  static bool Advance(BucketQueue* queues, std::size_t count);

  /// Returns the smallest key of the first non-empty bucket, rounded down; infinity if all buckets
  /// are empty.
  double FindNext() const;
  /// Advances to the bucket of a key: the smallest FindNext() of several queues with the same
  /// origin and width.
  void AdvanceTo(double key);

  /// Removes the entries of the current bucket for which `isOutdated(entry)` holds.
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

  /// Returns the entries of the current bucket. The list grows while vertices are pushed.
  const std::vector<Entry>& Current() const { return this->Ring[this->Cursor & Mask]; }

  /// Returns the entry `ahead` positions after entry `index` of the current bucket, according to
  /// the present contents; null if neither this bucket nor the next contains the entry.
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

  /// Moves the entries of the current bucket to `entries`, replacing their previous content.
  void TakeCurrent(std::vector<Entry>& entries)
  {
    entries.clear();
    entries.swap(this->Ring[this->Cursor & Mask]);
    this->Size -= entries.size();
  }

  /// Clears the current bucket.
  void ClearCurrent()
  {
    std::vector<Entry>& bucket = this->Ring[this->Cursor & Mask];
    this->Size -= bucket.size();
    bucket.clear();
  }

  /// Working memory of the search: per vertex, the number of children in the tree.
  std::vector<Id> Children;

private:
  static constexpr std::size_t NumberOfBuckets = 256;
  static constexpr std::size_t Mask = NumberOfBuckets - 1;
  static constexpr float LargestKey = std::numeric_limits<float>::max();

  void Place(const Entry& entry)
  {
    const double ahead = entry.Key - this->First;
    if (!(ahead < static_cast<double>(this->Cursor + NumberOfBuckets)))
    {
      this->Overflow.push_back(entry);
      return;
    }
    const auto bucket = ahead > 0.0 ? static_cast<std::size_t>(ahead) : 0;
    this->Ring[(bucket > this->Cursor ? bucket : this->Cursor) & Mask].push_back(entry);
    ++this->Size;
  }

  /// Moves overflow entries that now lie within the ring to their buckets.
  void PlaceOverflow();
  /// Continues an empty ring at the given key, the smallest one in the overflow list.
  void JumpTo(double key);

  std::vector<Entry> Ring[NumberOfBuckets];
  std::vector<Entry> Overflow;
  std::vector<Entry> Scratch;
  double Origin = 0.0;
  double PerWidth = 1.0;
  double First = 0.0;     ///< key of bucket 0
  std::size_t Cursor = 0; ///< current bucket
  std::size_t Size = 0;   ///< entries in the ring
};
}

#endif
