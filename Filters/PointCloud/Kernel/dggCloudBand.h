// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The band of voxels around a cloud. Internal.
#ifndef dggCloudBand_h
#define dggCloudBand_h

#include "dggCloudSetup.h" // for CloudSetup
#include "dggSetupLoop.h"  // for SetupLoop

namespace dgg
{
/// Choose the radii of balls and the size of voxels, mark the band, and find the nearest point of
/// each of its voxels. Needs the spacings of the nodes and the tree of them. Fails when parts of
/// the cloud are too far apart, when the band does not fit into the memory, and when stopped.
Status BuildCloudBand(const CloudGraphOptions& options, double medianSpacing, SetupLoop& loop,
  CloudSetup& setup, CloudGraphStatistics& statistics);
}

#endif
