// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBitHash.h"

#include <cstring>

namespace dgg
{
namespace
{
/// Odd, about half of the bits set: digits of the golden ratio and of the roots of 2, 3 and 5.
constexpr std::uint64_t Multipliers[] = { 0x9e3779b97f4a7c15u, 0x6a09e667f3bcc909u,
  0xbb67ae8584caa73bu, 0x3c6ef372fe94f82bu };

/// Returns a hash in which every bit depends on every bit of the word.
std::uint64_t Avalanche(std::uint64_t word)
{
  for (std::uint64_t multiplier : { Multipliers[0], Multipliers[2] })
  {
    word ^= word >> 32;
    word *= multiplier;
  }
  return word ^ (word >> 29);
}
}

void BitHash::Mix(const unsigned char* blocks, std::size_t count)
{
  State lanes = this->Lanes; // in registers
  for (; count > 0; --count, blocks += BlockSize)
  {
    for (std::size_t i = 0; i < NumberOfLanes; ++i)
    {
      std::uint64_t word = 0;
      std::memcpy(&word, blocks + i * sizeof(word), sizeof(word));
      const std::uint64_t product = (lanes[i] ^ word) * Multipliers[i];
      lanes[i] = product ^ (product >> 32);
    }
  }
  this->Lanes = lanes;
}

void BitHash::AddBytes(const void* bytes, std::size_t size)
{
  const auto* position = static_cast<const unsigned char*>(bytes);
  const std::size_t whole = size / BlockSize;
  this->Mix(position, whole);
  // The rest, padded, and the size, which distinguishes the padding from zeros.
  unsigned char end[2 * BlockSize] = {};
  if (size % BlockSize != 0)
  {
    std::memcpy(end, position + whole * BlockSize, size % BlockSize);
  }
  const std::uint64_t sizes[NumberOfLanes] = { size, size, size, size };
  std::memcpy(end + BlockSize, sizes, BlockSize);
  this->Mix(end, 2);
}

std::array<std::uint64_t, 2> BitHash::Finish() const
{
  std::array<std::uint64_t, 2> hash{ { Avalanche(this->Lanes[0]), Avalanche(~this->Lanes[0]) } };
  for (std::size_t i = 1; i < NumberOfLanes; ++i)
  {
    // Bijective in the lane for either half.
    hash[0] = Avalanche(hash[0] ^ this->Lanes[i]);
    hash[1] = Avalanche(hash[1] + this->Lanes[i]);
  }
  return hash;
}
}
