// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Size of a cloud without its graph. Internal.
#ifndef dggCloudSize_h
#define dggCloudSize_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggParallel.h"   // for ProgressCallback
#include "dggStatus.h"     // for Status

namespace dgg
{
struct CloudSize
{
  /// Median distance of about 500 points from their fourth neighbor, model units; 0 without points.
  double Spacing = 0.0;
  Id NumberOfComponents = 0; ///< 0 if not counted
};

/// Measures the finite points of a cloud (x y z each). Gaps wider than `gap` spacings separate
/// components; 0 means that components are not counted. Fails when stopped.
DGG_CORE_EXPORT Status MeasureCloud(const double* points, Offset numberOfPoints, double gap,
  const ProgressCallback& progress, CloudSize& size);
}

#endif
