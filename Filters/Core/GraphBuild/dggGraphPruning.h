// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The second step of the indirect construction: pruning candidates. Internal.
#ifndef dggGraphPruning_h
#define dggGraphPruning_h

#include "dggParallel.h" // for ParallelFor
#include "dggRowStore.h" // for RowStore
#include "dggStatus.h"   // for Status

namespace dgg
{
/// Removes from each row s the candidates t that another edge r of the row makes redundant: w(s,r)
/// / (1 + accuracy) + w(r,t) <= w(s,t), where (r,t) is any candidate. The published procedure (Fang
/// 2019, sec. 3.3) compares w(s,r) + w(r,t) with (1 + accuracy) w(s,t), so that errors accumulate.
/// With the condition used in this function, the argument of the progress rule bounds the error for
/// all pairs that were candidates (see CandidateRule). Fails if `progress`, which may be empty,
/// returns false; the rows are unchanged then.
Status PruneCandidates(
  RowStore& rows, double accuracy, const ParallelFor& parallel, const ProgressCallback& progress);
}

#endif
