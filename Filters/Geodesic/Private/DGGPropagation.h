// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Virtual source propagation on the mesh of a filter. Not for use outside of vtkDGG.
 */
#ifndef DGGPropagation_h
#define DGGPropagation_h

#include "DGGContext.h"         // For the mesh
#include "DGGMeshQuality.h"     // For the anisotropy
#include "dggPreparedSurface.h" // For the mesh

#include "dggSourcePropagation.h" // For the solver

#include <cstdint> // for the build number
#include <memory>  // For the solver
#include <vector>  // For the sources

/// Solver of virtual source propagation, prepared once for each mesh.
class DGGPropagation
{
public:
  /// Returns the quality that suits the mesh.
  static dgg::PropagationQuality Choose(const dgg::PreparedSurface& surface)
  {
    return DGGHasLongTriangles(surface) ? dgg::PropagationQuality::High
                                        : dgg::PropagationQuality::Fast;
  }

  /// Computes distances with the threads and the progress of the update.
  dgg::Status Run(const DGGContext& context, const std::vector<dgg::GeodesicSource>& sources,
    dgg::PropagationOptions options, dgg::PropagationResult& result)
  {
    const dgg::PreparedSurface& surface = context.Surface;
    const dgg::SurfaceMesh& mesh =
      options.WantVirtualSource ? surface.GetMesh() : surface.GetMeshWithoutAngles();
    if (!this->Solver || this->MeshBuild != surface.GetBuildNumber())
    {
      this->Solver.reset(); // release before the next is allocated
      this->Solver.reset(new dgg::SourcePropagation(mesh));
      this->MeshBuild = surface.GetBuildNumber();
    }
    options.Parallel = context.Parallel;
    options.Progress = context.Progress;
    return this->Solver->Run(sources, options, result);
  }

private:
  std::unique_ptr<dgg::SourcePropagation> Solver;
  std::uint64_t MeshBuild = 0;
};

#endif
