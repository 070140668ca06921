// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Elements sorted by group. Internal.
#ifndef dggGroups_h
#define dggGroups_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <numeric> // for std::partial_sum
#include <vector>  // for the lists

namespace dgg
{
/// The members of group g are [Begins[g], Begins[g + 1]) of Members, in ascending order.
struct Groups
{
  std::vector<Offset> Begins;
  std::vector<Id> Members;
};

/// Lists of values, one after the other.
template <typename Value>
struct ValueLists
{
  std::vector<Offset> Begins{ 0 }; ///< of each list, and the end of the last one
  std::vector<Value> Values;

  /// Ends the list of the values that have been added to Values.
  void EndList() { this->Begins.push_back(static_cast<Offset>(this->Values.size())); }
  /// Adds a list.
  void Add(const Value* begin, const Value* end)
  {
    this->Values.insert(this->Values.end(), begin, end);
    this->EndList();
  }
  ///@{
  /// Returns the range of the i-th list.
  const Value* Begin(Offset i) const { return this->Values.data() + this->Begins[i]; }
  const Value* End(Offset i) const { return this->Values.data() + this->Begins[i + 1]; }
  ///@}
};

/// Sorts elements by group; `groupOf(i)` is the group of an element, or NoId.
template <typename GroupOf>
Groups MakeGroups(Id numberOfElements, Id numberOfGroups, const GroupOf& groupOf)
{
  Groups made{ std::vector<Offset>(static_cast<std::size_t>(numberOfGroups) + 1, 0), {} };
  for (Id i = 0; i < numberOfElements; ++i)
  {
    const Id group = groupOf(i);
    if (group != NoId)
    {
      ++made.Begins[group];
    }
  }
  std::partial_sum(made.Begins.begin(), made.Begins.end(), made.Begins.begin());
  made.Members.resize(static_cast<std::size_t>(made.Begins.back()));
  for (Id i = numberOfElements; i-- > 0;)
  {
    const Id group = groupOf(i);
    if (group != NoId)
    {
      made.Members[--made.Begins[group]] = i;
    }
  }
  return made;
}

/// Sorts elements by group; `groups` contains the group of each element, or NoId.
inline Groups MakeGroups(const std::vector<Id>& groups, std::size_t numberOfGroups)
{
  return MakeGroups(static_cast<Id>(groups.size()), static_cast<Id>(numberOfGroups),
    [&](Id i) { return groups[i]; });
}
}

#endif
