// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops of the kernel on threads of the standard library.
#ifndef ThreadedLoop_h
#define ThreadedLoop_h

#include "dggParallel.h" // for ParallelFor

/// A loop on this many threads, each taking the next piece of it when done with one.
dgg::ParallelFor ThreadedLoop(int threads);

#endif
