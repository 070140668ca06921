// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual source propagation with a solver that is kept. Internal.
#ifndef dggPropagationSession_h
#define dggPropagationSession_h

#include "dggMeshQuality.h"       // for the anisotropy
#include "dggPreparedSurface.h"   // for the mesh
#include "dggSourcePropagation.h" // for the solver
#include "dggTaskContext.h"       // for the loop

#include <cstdint> // for the build number
#include <memory>  // for the solver
#include <vector>  // for the sources

namespace dgg
{
/// Solver of virtual source propagation, prepared once for each mesh.
class PropagationSession
{
public:
  /// Returns the quality that suits the mesh.
  static PropagationQuality Choose(const PreparedSurface& surface)
  {
    return HasLongTriangles(surface) ? PropagationQuality::High : PropagationQuality::Fast;
  }

  /// Computes distances with the loop and the progress of the context.
  Status Run(const TaskContext& context, const std::vector<GeodesicSource>& sources,
    PropagationOptions options, PropagationResult& result)
  {
    const PreparedSurface& surface = context.Surface;
    const SurfaceMesh& mesh =
      options.WantVirtualSource ? surface.GetMesh() : surface.GetMeshWithoutAngles();
    if (!this->Solver || this->MeshBuild != surface.GetBuildNumber())
    {
      this->Solver.reset(); // release before the next is allocated
      this->Solver = std::make_unique<SourcePropagation>(mesh);
      this->MeshBuild = surface.GetBuildNumber();
    }
    options.Parallel = context.Parallel;
    options.Progress = context.Progress;
    return this->Solver->Run(sources, options, result);
  }

private:
  std::unique_ptr<SourcePropagation> Solver;
  std::uint64_t MeshBuild = 0;
};
}

#endif
