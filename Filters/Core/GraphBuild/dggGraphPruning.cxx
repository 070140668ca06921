// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphPruning.h"

#include "dggBlockLoop.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace dgg
{
namespace
{
/// Factor that compensates the rounding of stored lengths, which may be floats, rounded up. A
/// candidate must be redundant with respect to its true length, or errors would accumulate from
/// relay to relay.
constexpr double LeastShareOfStored = 1.0 - 1.2e-7;

class CandidatePruner
{
public:
  explicit CandidatePruner(const RowStore& rows)
    : Rows(rows)
    , Reach(rows.GetNumberOfRows(), Infinity)
  {
  }

  /// Visits candidates from the shortest on. An edge that is kept lowers the reach of the targets
  /// of its candidates; a candidate whose reach is already low enough is redundant.
  void Prune(Id row, double kappa, unsigned char* flags)
  {
    const Offset begin = this->Rows.Begin(row);
    const Offset end = this->Rows.End(row);
    this->Order.resize(static_cast<std::size_t>(end - begin));
    std::iota(this->Order.begin(), this->Order.end(), begin);
    std::sort(this->Order.begin(), this->Order.end(), [this](Offset a, Offset b) {
      return this->Rows.Length(a) != this->Rows.Length(b)
        ? this->Rows.Length(a) < this->Rows.Length(b)
        : this->Rows.Target(a) < this->Rows.Target(b);
    });
    for (const Offset i : this->Order)
    {
      const Id r = this->Rows.Target(i);
      if (this->Reach[r] <= this->Rows.Length(i) * LeastShareOfStored)
      {
        flags[i] = 1;
        continue;
      }
      const double cost = kappa * this->Rows.Length(i);
      for (Offset k = this->Rows.Begin(r); k < this->Rows.End(r); ++k)
      {
        double& reach = this->Reach[this->Rows.Target(k)];
        const double by = cost + this->Rows.Length(k);
        if (by < reach)
        {
          if (reach == Infinity)
          {
            this->Touched.push_back(this->Rows.Target(k));
          }
          reach = by;
        }
      }
    }
    for (const Id v : this->Touched)
    {
      this->Reach[v] = Infinity;
    }
    this->Touched.clear();
  }

private:
  const RowStore& Rows;
  std::vector<double> Reach; // kappa w(s,r) + w(r,t), minimum over the edges kept
  std::vector<Id> Touched;
  std::vector<Offset> Order;
};
}

Status PruneCandidates(
  RowStore& rows, double accuracy, const ParallelFor& parallel, const ProgressCallback& progress)
{
  constexpr Offset grain = 64;
  const double kappa = 1.0 / (1.0 + accuracy);
  std::vector<unsigned char> flags(static_cast<std::size_t>(rows.GetNumberOfEdges()), 0);
  WorkspacePool<CandidatePruner> pruners;
  DGG_RETURN_IF_ERROR(ForBlocks(
    rows.GetNumberOfRows(), grain, parallel, progress, [&] { return pruners.Borrow(rows); },
    [&](auto& pruner, Offset, Offset begin, Offset end) {
      for (Offset row = begin; row < end; ++row)
      {
        pruner->Prune(static_cast<Id>(row), kappa, flags.data());
      }
    }));
  rows.Remove(0, flags);
  rows.ShrinkToFit();
  return Status::Success();
}
}
