// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources of a field of which only the distances are known.
#ifndef dggSourceFit_h
#define dggSourceFit_h

#include "dggParallel.h"       // for ParallelFor
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggTypes.h"          // for ProgressCallback
#include "dggVirtualSources.h" // for VirtualSources

namespace dgg
{
/// Find for each vertex the virtual source that explains the distances of its neighbours best:
/// its direction and the curvature of the wave that comes from there, which is one over its
/// distance. Neighbours whose distance comes another way hardly count. The field may be a foreign
/// one, from fast marching or heat; of the distance at a source nothing is assumed.
///
/// `distances` are per vertex; Infinity or NaN where unreached. Where there is nothing to fit, as
/// at a source or an Irregular vertex, the virtual source is the vertex itself. False when stopped;
/// then nothing is found.
bool FitVirtualSources(const SurfaceMesh& mesh, const double* distances,
  const ParallelFor& parallel, VirtualSources& found,
  const ProgressCallback& progress = ProgressCallback());
}

#endif
