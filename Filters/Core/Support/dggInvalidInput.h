// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages in parts. Internal.
#ifndef dggInvalidInput_h
#define dggInvalidInput_h

#include "dggTypes.h" // for Status

#include <sstream> // for JoinText
#include <string>  // for JoinText

namespace dgg
{
/// Texts and numbers as one text.
template <typename... Parts>
std::string JoinText(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Status::Invalid() with a message of texts and numbers.
template <typename... Parts>
Status InvalidInput(const Parts&... parts)
{
  return Status::Invalid(JoinText(parts...));
}
}

#endif
