// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRowStore.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
float RoundedUp(double value)
{
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) < value
    ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
    : rounded;
}

void RowStore::AppendRow(const RowEdge* begin, const RowEdge* end)
{
  Offset i = this->Begins.back();
  this->Reserve(i + (end - begin));
  for (const RowEdge* edge = begin; edge != end; ++edge)
  {
    this->Set(i++, *edge);
  }
  this->Begins.push_back(i);
}

void RowStore::Reserve(Offset size)
{
  if (size <= this->Capacity)
  {
    return;
  }
  // Unwritten memory is not committed, so that the capacity may be generous.
  this->SetCapacity(std::max<Offset>(size, this->Capacity + this->Capacity / 2 + 1024));
}

void RowStore::ShrinkToFit()
{
  this->SetCapacity(this->GetNumberOfEdges());
}

void RowStore::SetCapacity(Offset capacity)
{
  const auto size = static_cast<std::size_t>(capacity);
  this->Targets.Resize(size);
  if (this->IsWide)
  {
    this->WideLengths.Resize(size);
  }
  else
  {
    this->Lengths.Resize(size);
  }
  this->Departures.Resize(size);
  this->Arrivals.Resize(size);
  this->Capacity = capacity;
}

void RowStore::Set(Offset i, const RowEdge& edge)
{
  this->Targets[i] = edge.Target;
  this->SetWay(i, edge.Length, edge.Departure, edge.Arrival);
}

void RowStore::SetWay(Offset i, double length, float departure, float arrival)
{
  if (this->IsWide)
  {
    this->WideLengths[i] = length;
  }
  else
  {
    this->Lengths[i] = RoundedUp(length);
  }
  this->Departures[i] = departure;
  this->Arrivals[i] = arrival;
}

RowEdge RowStore::Get(Offset i) const
{
  return { this->Targets[i], this->Length(i), this->Departures[i], this->Arrivals[i] };
}

void RowStore::Remove(Id first, const std::vector<unsigned char>& flags)
{
  const Offset base = this->Begins[first];
  Offset kept = base;
  Offset begin = base;
  for (Id row = first; row < this->GetNumberOfRows(); ++row)
  {
    const Offset end = this->Begins[row + 1];
    for (Offset i = begin; i < end; ++i)
    {
      if (!flags[i - base])
      {
        this->Targets[kept] = this->Targets[i];
        if (this->IsWide)
        {
          this->WideLengths[kept] = this->WideLengths[i];
        }
        else
        {
          this->Lengths[kept] = this->Lengths[i];
        }
        this->Departures[kept] = this->Departures[i];
        this->Arrivals[kept] = this->Arrivals[i];
        ++kept;
      }
    }
    this->Begins[row + 1] = kept;
    begin = end;
  }
}

void RowStore::TruncateAngles(Id first)
{
  const auto size = static_cast<std::size_t>(this->Begins[first]);
  this->Departures.Resize(size);
  this->Arrivals.Resize(size);
}

void RowStore::Truncate(Id first)
{
  const auto size = static_cast<std::size_t>(this->Begins[first]);
  this->Begins.resize(static_cast<std::size_t>(first) + 1);
  this->Targets.Resize(size);
  this->IsWide ? this->WideLengths.Resize(size) : this->Lengths.Resize(size);
}
}
