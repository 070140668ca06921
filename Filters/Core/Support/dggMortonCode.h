// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Positions along a space-filling curve. Internal.
#ifndef dggMortonCode_h
#define dggMortonCode_h

#include <algorithm> // for std::min
#include <cstdint>   // for the code

namespace dgg
{
/// Returns the position of a point of the unit cube along the Z-order curve through 2^63 cells.
/// Coordinates are clamped to [0, 1]; NaN counts as 0. Points with similar positions are close to
/// each other.
inline std::uint64_t GetMortonCode(double x, double y, double z)
{
  // Inserts two zero bits between the bits of a cell index along one axis.
  const auto spread = [](double coordinate) {
    constexpr double cells = 1 << 21;
    auto bits = static_cast<std::uint64_t>(
      std::min(std::max(0.0, cells * coordinate), cells - 1.0)); // 0 for NaN
    bits = (bits | bits << 32) & 0x001f00000000ffffULL;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
    bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
    return (bits | bits << 2) & 0x1249249249249249ULL;
  };
  return spread(x) | spread(y) << 1 | spread(z) << 2;
}
}

#endif
