// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Index types, constants and the progress callback of the kernel.
#ifndef dggTypes_h
#define dggTypes_h

#include <cstdint>    // for fixed-width indices
#include <functional> // for ProgressCallback
#include <limits>     // for Infinity

namespace dgg
{
/// Index of a vertex, a face or a half-edge. Half-edge 3f+k starts at corner k of face f.
using Id = std::int32_t;
/// Offset into flat arrays that may hold more than 2^31 entries.
using Offset = std::int64_t;

/// "No such element" for every kind of Id.
constexpr Id NoId = -1;
constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Called periodically by long loops, from any of their threads, with the finished fraction in [0,
/// 1]; returns false to stop.
using ProgressCallback = std::function<bool(double)>;
}

#endif
