// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lower envelopes of windows on one half-edge: at each point only the shortest window is stored.
/// Internal.
#ifndef dggWindowEnvelope_h
#define dggWindowEnvelope_h

#include "dggWindow.h" // for Window

#include <cstddef> // for std::ptrdiff_t
#include <limits>  // for a limit that is none
#include <vector>  // for WindowList

namespace dgg
{
/// Windows on one half-edge, sorted and disjoint.
using WindowList = std::vector<Window>;

/// Trims the parts of a window where a path through an end of the half-edge, at distances
/// `atOrigin` and `atEnd`, and along the edge is shorter. Returns false if nothing remains.
bool TrimByEnds(Window& window, double length, double atOrigin, double atEnd);

/// Computes the lower envelope of two envelopes on a half-edge of the given length. `out` must be a
/// different list.
void MergeEnvelopes(
  const WindowList& first, const WindowList& second, double length, WindowList& out);

/// Returns the lower envelope of n unsorted windows, in O(n log n).
WindowList MakeEnvelope(const Window* begin, const Window* end, double length);

/// Inserts a window into an envelope; fast if it belongs at the end. Does nothing and returns false
/// if the window begins before the end of more than `mostBeyond` windows.
bool InsertIntoEnvelope(WindowList& list, const Window& window, double length, WindowList& scratch,
  std::ptrdiff_t mostBeyond = std::numeric_limits<std::ptrdiff_t>::max());

/// Returns the point in (begin, end) where two windows tie. `first` must be shorter at begin and
/// longer at end, or vice versa.
double TiePoint(const Window& first, const Window& second, double begin, double end);
}

#endif
