// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rows of edges while a graph is being built. Internal.
#ifndef dggRowStore_h
#define dggRowStore_h

#include "dggBuffer.h"     // for the arrays
#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id, Offset

#include <algorithm> // for std::lower_bound
#include <vector>    // for where rows begin

namespace dgg
{
/// A stored edge. Lengths are floats, rounded up, unless the graph needs doubles.
struct RowEdge
{
  Id Target;
  double Length;
  float Departure;
  float Arrival;
};

/// Returns the smallest float that is not below a value.
DGG_CORE_EXPORT float RoundedUp(double value);

/// The edges of consecutive rows, in flat growing arrays. Each property has its own array, so that
/// arrays can be released one by one.
class RowStore
{
public:
  /// Creates an empty store. If `wide` is true, lengths are kept as double.
  explicit RowStore(bool wide)
    : IsWide(wide)
    , Begins(1, 0)
  {
  }

  Id GetNumberOfRows() const { return static_cast<Id>(this->Begins.size() - 1); }
  Offset GetNumberOfEdges() const { return this->Begins.back(); }
  /// Returns the size in bytes of the rows.
  double GetMemorySize() const
  {
    return static_cast<double>(this->GetNumberOfEdges()) * (this->IsWide ? 20.0 : 16.0) +
      static_cast<double>(this->Begins.size() * sizeof(Offset));
  }
  Offset Begin(Id row) const { return this->Begins[row]; }
  Offset End(Id row) const { return this->Begins[row + 1]; }

  /// Returns the first row that begins at the edge or behind it.
  Id FindRow(Offset edge) const
  {
    return static_cast<Id>(
      std::lower_bound(this->Begins.begin(), this->Begins.end(), edge) - this->Begins.begin());
  }

  /// Reserves the offsets of `count` rows in one step, since growth may double the memory.
  void ReserveRows(Id count) { this->Begins.reserve(static_cast<std::size_t>(count) + 1); }
  Offset GetCapacityOfRows() const { return static_cast<Offset>(this->Begins.capacity() - 1); }
  void AppendRow(const RowEdge* begin, const RowEdge* end);
  void Set(Offset i, const RowEdge& edge);
  void SetTarget(Offset i, Id target) { this->Targets[i] = target; }
  /// Sets all properties except the target, so that other threads may read targets simultaneously.
  void SetWay(Offset i, double length, float departure, float arrival);
  RowEdge Get(Offset i) const;

  Id Target(Offset i) const { return this->Targets[i]; }
  double Length(Offset i) const
  {
    return this->IsWide ? this->WideLengths[i] : static_cast<double>(this->Lengths[i]);
  }
  float Departure(Offset i) const { return this->Departures[i]; }
  float Arrival(Offset i) const { return this->Arrivals[i]; }

  /// Removes the flagged edges from the rows beginning with `first`. flags[0] belongs to the edge
  /// Begin(first).
  void Remove(Id first, const std::vector<unsigned char>& flags);

  /// Releases the memory of removed edges.
  void ShrinkToFit();
  ///@{
  /// Removes the angles of the rows from `first` on, or these rows, and releases their memory. No
  /// row may be added later.
  void TruncateAngles(Id first);
  void Truncate(Id first);
  ///@}

private:
  void Reserve(Offset size);
  void SetCapacity(Offset capacity);

  bool IsWide;
  std::vector<Offset> Begins;
  Buffer<Id> Targets;
  Buffer<float> Lengths;
  Buffer<double> WideLengths;
  Buffer<float> Departures;
  Buffer<float> Arrivals;
  Offset Capacity = 0;
};
}

#endif
