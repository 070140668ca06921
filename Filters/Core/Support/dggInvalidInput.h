// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Composition of messages. Internal.
#ifndef dggInvalidInput_h
#define dggInvalidInput_h

#include "dggTypes.h" // for Status

#include <sstream> // for JoinText
#include <string>  // for JoinText

namespace dgg
{
/// Concatenates texts and numbers.
template <typename... Parts>
std::string JoinText(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Returns Status::Invalid() with a message composed of texts and numbers.
template <typename... Parts>
Status InvalidInput(const Parts&... parts)
{
  return Status::Invalid(JoinText(parts...));
}
}

#endif
