// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a filter of functions of the Laplacian is given to compute. Internal.
#ifndef vtkDGGSpectralTask_h
#define vtkDGGSpectralTask_h

#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for places

#include "vtkType.h" // for vtkMTimeType

#include <vector> // for places

class vtkDGGSpectralOutputs;
class vtkPolyData;

/// One call of vtkSpectralAlgorithm::ComputeValues(). Places exist on the mesh, the solver is
/// ready; what a filter adds to inputs and properties of its own, it has checked or checks itself.
struct vtkDGGSpectralTask
{
  const dgg::PoissonSolver& Solver;              ///< ready
  vtkPolyData* Surface;                          ///< the input as it was, not to be changed
  vtkMTimeType MeshTime;                         ///< another one when the solver is another one
  const std::vector<dgg::SurfacePoint>& Sources; ///< none only where the filter may choose them
  const std::vector<dgg::SurfacePoint>& Targets; ///< may be none
  double FreeMemory;                             ///< bytes of the limit that are left for caches
  dgg::ProgressCallback Progress;                ///< never empty; false means stop
  vtkDGGSpectralOutputs& Outputs;                ///< to be set for each source
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGSpectralTask.h
