// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The crossings of faces near the sources of windows. Internal.
#ifndef dggCrossingBlocks_h
#define dggCrossingBlocks_h

#include "dggUnfoldingTable.h" // for the blocks

#include <atomic>  // for blocks that threads share
#include <cstddef> // for std::size_t
#include <cstdint> // for indices
#include <memory>  // for the blocks
#include <mutex>   // for the blocks
#include <utility> // for std::pair
#include <vector>  // for the blocks

namespace dgg
{
/// Stores the crossings of an UnfoldingTable, in blocks that are filled at their first use. Several
/// threads may use the crossings simultaneously.
class CrossingBlocks
{
public:
  explicit CrossingBlocks(const UnfoldingTable& table)
    : Table(table)
    , Blocks(table.GetNumberOfBlocks())
  {
  }

  const UnfoldingTable& GetTable() const { return this->Table; }

  const FaceCrossing& operator[](Id entry)
  {
    return this->BlockOf(entry).Crossings[IndexInBlock(entry)];
  }
  /// Returns the code behind half-edge `exit`, through which its own face is left.
  Id CodeBehind(Id exit)
  {
    return (*this)[this->Table.EntryOf(SurfaceMesh::Next(exit))].Behind[FaceCrossing::Left];
  }
  /// Returns SurfaceMesh::PolarAngle() of a half-edge of the mesh, stored in the order of the
  /// table.
  double PolarAngle(Id h)
  {
    const Id entry = this->Table.EntryOf(h);
    return this->BlockOf(entry).PolarAngles[IndexInBlock(entry)];
  }

  /// Releases the older half of the blocks if there are more than `most`, for reuse. No thread may
  /// use crossings during the call.
  void Trim(std::size_t most);

private:
  // Unsigned, for which divisions are shifts.
  static std::uint32_t BlockIndex(Id entry)
  {
    return static_cast<std::uint32_t>(entry) / CrossingBlock::Size;
  }
  static std::uint32_t IndexInBlock(Id entry)
  {
    return static_cast<std::uint32_t>(entry) % CrossingBlock::Size;
  }
  const CrossingBlock& BlockOf(Id entry)
  {
    const CrossingBlock* const block =
      this->Blocks[BlockIndex(entry)].load(std::memory_order_acquire);
    return block ? *block : this->Fill(BlockIndex(entry));
  }
  const CrossingBlock& Fill(std::size_t index);

  const UnfoldingTable& Table;
  std::vector<std::atomic<const CrossingBlock*>> Blocks;
  std::mutex Mutex; // of the members below
  std::vector<std::unique_ptr<CrossingBlock[]>> Memory;
  std::size_t Capacity = 0; // blocks in Memory
  std::vector<CrossingBlock*> Idle;
  std::vector<std::pair<std::size_t, CrossingBlock*>> Filled; // with their indices, oldest first
};
}

#endif
