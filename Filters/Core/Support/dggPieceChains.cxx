// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceChains.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dgg
{
std::vector<PieceChain> JoinPieces(const std::vector<std::array<Id, 2>>& pieces)
{
  // Ends have the indices 2 * piece (start) and 2 * piece + 1 (end).
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::pair<Id, std::size_t>> ends; // sorted by point
  ends.reserve(2 * pieces.size());
  for (const std::array<Id, 2>& piece : pieces)
  {
    ends.emplace_back(piece[0], ends.size());
    ends.emplace_back(piece[1], ends.size());
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::size_t> next(ends.size(), none); // per end, the end that it meets
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end)
  {
    while (end < ends.size() && ends[end].first == ends[begin].first)
    {
      ++end;
    }
    if (end - begin == 2)
    {
      next[ends[begin].second] = ends[begin + 1].second;
      next[ends[begin + 1].second] = ends[begin].second;
    }
  }
  std::vector<PieceChain> chains;
  std::vector<char> isUsed(pieces.size(), 0);
  for (const bool isClosed : { false, true })
  {
    for (const auto& start : ends)
    {
      if (isUsed[start.second / 2] || (!isClosed && next[start.second] != none))
      {
        continue;
      }
      chains.push_back({ {}, isClosed });
      for (std::size_t at = start.second; at != none && !isUsed[at / 2]; at = next[at ^ 1])
      {
        isUsed[at / 2] = 1;
        chains.back().Passages.push_back({ at / 2, at % 2 == 1 });
      }
    }
  }
  return chains;
}
}
