// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCrossingBlocks.h"

namespace dgg
{
const CrossingBlock& CrossingBlocks::Fill(std::size_t index)
{
  Pointer block;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Idle.empty())
    {
      block = std::move(this->Idle.back());
      this->Idle.pop_back();
    }
  }
  block = block ? std::move(block) : std::make_unique<CrossingBlock>();
  this->Table.Fill(index, *block);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (const CrossingBlock* const other = this->Blocks[index].load()) // filled by another thread
  {
    this->Idle.push_back(std::move(block));
    return *other;
  }
  this->Filled.emplace_back(index, std::move(block));
  this->Blocks[index].store(this->Filled.back().second.get(), std::memory_order_release);
  return *this->Filled.back().second;
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
    this->Idle.push_back(std::move(block->second));
  }
  this->Filled.erase(this->Filled.begin(), end);
}
}
