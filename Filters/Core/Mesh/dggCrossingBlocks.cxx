// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCrossingBlocks.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Number of blocks that are allocated in one step. Allocated one by one, each construction on a
/// small mesh would return them to the system, and take new page faults.
constexpr std::size_t BlocksAtOnce = 64;
}

const CrossingBlock& CrossingBlocks::Fill(std::size_t index)
{
  CrossingBlock* block = nullptr;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Idle.empty())
    {
      // Threads that fill the same block may need more blocks than the table has.
      const std::size_t missing =
        this->Blocks.size() - std::min(this->Capacity, this->Blocks.size());
      const std::size_t count = std::max<std::size_t>(1, std::min(missing, BlocksAtOnce));
      this->Memory.push_back(std::make_unique<CrossingBlock[]>(count));
      this->Capacity += count;
      for (std::size_t i = count; i-- > 0;)
      {
        this->Idle.push_back(&this->Memory.back()[i]);
      }
    }
    block = this->Idle.back();
    this->Idle.pop_back();
  }
  this->Table.Fill(index, *block);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (const CrossingBlock* const other = this->Blocks[index].load()) // filled by another thread
  {
    this->Idle.push_back(block);
    return *other;
  }
  this->Filled.emplace_back(index, block);
  this->Blocks[index].store(block, std::memory_order_release);
  return *block;
}

void CrossingBlocks::Trim(std::size_t most)
{
  if (this->Filled.size() <= most)
  {
    return;
  }
  const auto end = this->Filled.begin() + static_cast<std::ptrdiff_t>(this->Filled.size() / 2);
  for (auto block = this->Filled.begin(); block != end; ++block)
  {
    this->Blocks[block->first] = nullptr;
    this->Idle.push_back(block->second);
  }
  this->Filled.erase(this->Filled.begin(), end);
}
}
