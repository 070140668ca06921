// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lists of windows on one half-edge as lower envelopes: at each point only the shortest window.
/// Internal.
#ifndef dggWindowEnvelope_h
#define dggWindowEnvelope_h

#include "dggWindow.h" // for Window

#include <cstddef> // for std::ptrdiff_t
#include <limits>  // for a limit that is none
#include <vector>  // for WindowList

namespace dgg
{
/// Windows on one half-edge, in order and disjoint.
using WindowList = std::vector<Window>;

/// Cut off what the ways through the ends of the half-edge, at distances `atOrigin` and `atEnd`,
/// and along it make useless. Returns false when nothing is left.
bool TrimByEnds(Window& window, double length, double atOrigin, double atEnd);

/// Lower envelope of two envelopes on a half-edge of the given length. `out` must be another list.
void MergeEnvelopes(
  const WindowList& first, const WindowList& second, double length, WindowList& out);

/// Lower envelope of windows in any order, in n log n steps for n windows.
WindowList MakeEnvelope(const Window* begin, const Window* end, double length);

/// Insert one window into an envelope, fast when it belongs at the end. Does nothing and returns
/// false when it begins before the end of more than `mostBeyond` windows.
bool InsertIntoEnvelope(WindowList& list, const Window& window, double length, WindowList& scratch,
  std::ptrdiff_t mostBeyond = std::numeric_limits<std::ptrdiff_t>::max());

/// The point in (begin, end) where two windows tie. `first` must be shorter at begin and longer at
/// end, or the other way round.
double TiePoint(const Window& first, const Window& second, double begin, double end);
}

#endif
