// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Counts in messages. Internal.
#ifndef dggCounted_h
#define dggCounted_h

#include <string>      // for texts
#include <type_traits> // for integers

namespace dgg
{
/// Returns a count with its noun in the singular or the plural: "1 point", "2 points". Without
/// `plural`, an s is appended.
template <typename Number>
std::string Counted(Number count, const std::string& noun, const std::string& plural = "")
{
  static_assert(std::is_integral_v<Number>);
  return std::to_string(count) + " " + (count == 1 ? noun : plural.empty() ? noun + "s" : plural);
}
}

#endif
