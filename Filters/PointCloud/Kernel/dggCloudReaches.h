// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far the edges of the points of a cloud reach. Internal.
#ifndef dggCloudReaches_h
#define dggCloudReaches_h

#include "dggCloudSetup.h" // for CloudSetup
#include "dggSetupLoop.h"  // for SetupLoop

#include <vector> // for curvatures

namespace dgg
{
/// Choose the reach of each node by the scheme. Needs all else of the pairs, and `curvatures` of
/// the surface at the nodes.
void ChooseReaches(const CloudGraphOptions& options, double medianSpacing,
  const std::vector<float>& curvatures, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics);
}

#endif
