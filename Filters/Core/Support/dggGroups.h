// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Elements by the group that each is in. Internal.
#ifndef dggGroups_h
#define dggGroups_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <numeric> // for std::partial_sum
#include <vector>  // for the lists

namespace dgg
{
/// Those of group g are Members[Begins[g]] up to Members[Begins[g + 1]], in their order.
struct Groups
{
  std::vector<Offset> Begins;
  std::vector<Id> Members;
};

/// `groups` has the group of each element, or NoId.
inline Groups MakeGroups(const std::vector<Id>& groups, std::size_t numberOfGroups)
{
  Groups made{ std::vector<Offset>(numberOfGroups + 1, 0), {} };
  for (const Id group : groups)
  {
    made.Begins[group == NoId ? numberOfGroups : group] += group == NoId ? 0 : 1;
  }
  std::partial_sum(made.Begins.begin(), made.Begins.end(), made.Begins.begin());
  made.Members.resize(static_cast<std::size_t>(made.Begins.back()));
  for (std::size_t i = groups.size(); i-- > 0;)
  {
    if (groups[i] != NoId)
    {
      made.Members[--made.Begins[groups[i]]] = static_cast<Id>(i);
    }
  }
  return made;
}
}

#endif
