// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What geodesics have in common, shared by the tests of paths and loops.
#ifndef PathChecks_h
#define PathChecks_h

#include "dggSurfacePath.h"

namespace dggtest
{
/// Around each of its points a geodesic is the shortest way. The two ends are not looked at, unless
/// the path is closed and `isSmoothAtStart`.
void ExpectLocallyShortest(
  const dgg::SurfaceMesh& mesh, const dgg::SurfacePath& path, bool isSmoothAtStart = false);
}

#endif
