// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The second step of the indirect construction: pruning candidates. Internal.
#ifndef dggGraphPruning_h
#define dggGraphPruning_h

#include "dggParallel.h" // for ParallelFor
#include "dggRowStore.h" // for RowStore
#include "dggTypes.h"    // for Status

namespace dgg
{
/// Remove from each row s the candidates t that another edge r of the row makes superfluous:
/// w(s,r) / (1 + accuracy) + w(r,t) <= w(s,t), where (r,t) is any candidate. The published
/// procedure (Fang 2019, sec. 3.3) compares w(s,r) + w(r,t) with (1 + accuracy) w(s,t), which lets
/// errors add up; with this condition the argument of the progress rule bounds them, as far as it
/// goes: to what was a candidate (see CandidateRule). Fails when `progress`, which may be empty,
/// asks to stop; then the rows are as they were.
Status PruneCandidates(
  RowStore& rows, double accuracy, const ParallelFor& parallel, const ProgressCallback& progress);
}

#endif
