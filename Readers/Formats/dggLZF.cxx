// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLZF.h"

#include <algorithm>
#include <cstdint>

namespace
{
constexpr std::size_t LongestLiteral = 32;
constexpr std::size_t LongestDistance = 8192;
constexpr std::size_t ShortestMatch = 3; // a copy of two bytes saves nothing
constexpr std::size_t LongestMatch = 264;
constexpr unsigned int HashBits = 16;

std::size_t HashThree(const unsigned char* bytes)
{
  const std::uint32_t three = static_cast<std::uint32_t>(bytes[0]) |
    static_cast<std::uint32_t>(bytes[1]) << 8 | static_cast<std::uint32_t>(bytes[2]) << 16;
  return three * 2654435761u >> (32 - HashBits); // Fibonacci hashing
}

void AppendLiterals(const char* first, const char* last, std::vector<char>& output)
{
  while (first != last)
  {
    const std::size_t count = std::min(static_cast<std::size_t>(last - first), LongestLiteral);
    output.push_back(static_cast<char>(count - 1));
    output.insert(output.end(), first, first + count);
    first += count;
  }
}

void AppendCopy(std::size_t distance, std::size_t length, std::vector<char>& output)
{
  const std::size_t back = distance - 1;
  const std::size_t code = length - 2;
  output.push_back(static_cast<char>(std::min<std::size_t>(code, 7) << 5 | back >> 8));
  if (code >= 7)
  {
    output.push_back(static_cast<char>(code - 7));
  }
  output.push_back(static_cast<char>(back & 255));
}
}

bool dgg::DecompressLZF(
  const char* input, std::size_t inputSize, char* output, std::size_t outputSize)
{
  const auto* in = reinterpret_cast<const unsigned char*>(input);
  const unsigned char* const inEnd = in + inputSize;
  char* out = output;
  char* const outEnd = output + outputSize;
  while (in != inEnd)
  {
    const std::size_t control = *in++;
    const auto left = static_cast<std::size_t>(inEnd - in);
    const auto room = static_cast<std::size_t>(outEnd - out);
    if (control < LongestLiteral)
    {
      const std::size_t count = control + 1;
      if (count > left || count > room)
      {
        return false;
      }
      out = std::copy(in, in + count, out);
      in += count;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    const bool isLong = control >> 5 == 7;
    if (left < (isLong ? 2u : 1u))
    {
      return false;
    }
    if (isLong)
    {
      length += *in++;
    }
    const std::size_t distance = ((control & 31) << 8 | *in++) + 1;
    if (length > room || distance > static_cast<std::size_t>(out - output))
    {
      return false;
    }
    // Source and destination may overlap, which repeats the bytes; hence byte by byte.
    for (const char* const end = out + length; out != end; ++out)
    {
      *out = *(out - distance);
    }
  }
  return out == outEnd;
}

void dgg::CompressLZF(const char* input, std::size_t inputSize, std::vector<char>& output)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(input);
  // Last position of three bytes with the same hash, plus one; 0 if there is none.
  std::vector<std::size_t> last(std::size_t(1) << HashBits, 0);
  std::size_t literals = 0; // start of the pending literals
  std::size_t i = 0;
  while (i + ShortestMatch <= inputSize)
  {
    std::size_t& entry = last[HashThree(bytes + i)];
    const std::size_t candidate = entry;
    entry = i + 1;
    std::size_t length = 0;
    if (candidate > 0 && i - (candidate - 1) <= LongestDistance)
    {
      const unsigned char* const match = bytes + (candidate - 1);
      const std::size_t most = std::min(LongestMatch, inputSize - i);
      while (length < most && match[length] == bytes[i + length])
      {
        ++length;
      }
    }
    if (length < ShortestMatch)
    {
      ++i;
      continue;
    }
    AppendLiterals(input + literals, input + i, output);
    AppendCopy(i - (candidate - 1), length, output);
    // Bytes inside the copy may be copied later, too.
    const std::size_t next = i + length;
    for (++i; i < next && i + ShortestMatch <= inputSize; ++i)
    {
      last[HashThree(bytes + i)] = i + 1;
    }
    i = next;
    literals = next;
  }
  AppendLiterals(input + literals, input + inputSize, output);
}
