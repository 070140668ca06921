// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hash of the bit patterns of arrays, to identify them and to detect damage. Internal.
#ifndef dggBitHash_h
#define dggBitHash_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include <array>           // for the lanes
#include <cstddef>         // for std::size_t
#include <cstdint>         // for the words
#include <cstring>         // for std::memcpy

namespace dgg
{
/// Hashes arrays to 128 bits. Each step is a bijection of the state for any word, so that two
/// arrays that differ in one word never have the same hash; other collisions have random
/// probability. Not secure against deliberate collisions. Depends on the byte order of the machine.
class DGG_CORE_EXPORT BitHash
{
public:
  /// Adds an array to the hash. The boundaries between arrays affect the hash.
  template <typename T>
  void Add(const T* values, std::size_t count)
  {
    this->AddBytes(values, count * sizeof(T));
  }

  std::array<std::uint64_t, 2> Finish() const;

private:
  void AddBytes(const void* bytes, std::size_t size);

  // Several lanes in parallel hide the latency of multiplications.
  static constexpr std::size_t NumberOfLanes = 4;
  static constexpr std::size_t BlockSize = NumberOfLanes * sizeof(std::uint64_t);
  using State = std::array<std::uint64_t, NumberOfLanes>;

  void Mix(const unsigned char* blocks, std::size_t count);

  State Lanes{ { 0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u,
    0x082efa98ec4e6c89u } };
};

/// Returns a number of another type with the same bits.
template <typename To, typename From>
To CopyBits(From from)
{
  static_assert(sizeof(To) == sizeof(From), "not the same bits");
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}
}

#endif
