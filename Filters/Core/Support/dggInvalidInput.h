// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages in parts. Internal.
#ifndef dggInvalidInput_h
#define dggInvalidInput_h

#include "dggTypes.h" // for Status

#include <sstream> // for messages

namespace dgg
{
/// Status::Invalid() with a message of texts and numbers.
template <typename... Parts>
Status InvalidInput(const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  return Status::Invalid(message.str());
}
}

#endif
