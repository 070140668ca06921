// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point arrays with one component per source. Internal.
#ifndef DGGSpectralOutputs_h
#define DGGSpectralOutputs_h

#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for places
#include "dggTypes.h"         // for numbers

#include "vtkDoubleArray.h"  // for the arrays
#include "vtkSmartPointer.h" // to hold them
#include "vtkType.h"         // for vtkMTimeType

#include <cstddef> // for std::size_t
#include <string>  // for the name
#include <vector>  // for values

namespace dgg
{
class PreparedSurface;
}
struct DGGContext;
struct DGGSourceSet;

/// The results of a vtkSpectralAlgorithm, for the points of the surface and those of evaluation.
class DGGSpectralOutputs
{
public:
  /// Bytes of both arrays.
  static double EstimateMemory(
    std::size_t numberOfPoints, std::size_t numberOfTargets, std::size_t numberOfSources);

  /// Without sources there are no arrays of results.
  DGGSpectralOutputs(const dgg::PreparedSurface& mesh, std::size_t numberOfPoints,
    std::size_t numberOfTargets, std::size_t numberOfSources, const std::string& name);
  ~DGGSpectralOutputs();
  DGGSpectralOutputs(const DGGSpectralOutputs&) = delete;
  DGGSpectralOutputs& operator=(const DGGSpectralOutputs&) = delete;

  /// The values of one source, per vertex of the mesh and per target. Several threads may set those
  /// of different sources at once.
  void Set(
    std::size_t source, const std::vector<double>& values, const std::vector<double>& targetValues);

  /// A further array besides that of results (vtkDoubleArray or vtkIdTypeArray), per vertex of the
  /// mesh and per target.
  template <typename ArrayType, typename Number>
  void Add(const std::string& name, const std::vector<Number>& values,
    const std::vector<Number>& targetValues);

  /// A further vtkDoubleArray with several components.
  void AddColumns(const std::string& name, const std::vector<std::vector<double>>& columns,
    const std::vector<std::vector<double>>& targetColumns);

  /// Further arrays of the points, and of the targets.
  const std::vector<vtkSmartPointer<vtkDataArray>>& GetFurtherArrays(int port) const
  {
    return this->Further[port];
  }

  vtkDoubleArray* GetPointArray() const { return this->AtPoints; }
  vtkDoubleArray* GetTargetArray() const { return this->AtTargets; }

private:
  void SetComponents(vtkDoubleArray* atPoints, vtkDoubleArray* atTargets, std::size_t component,
    const std::vector<double>& values, const std::vector<double>& targetValues) const;

  const dgg::PreparedSurface& Mesh;
  std::size_t NumberOfPoints;
  vtkSmartPointer<vtkDoubleArray> AtPoints;
  vtkSmartPointer<vtkDoubleArray> AtTargets;
  std::vector<vtkSmartPointer<vtkDataArray>> Further[2];
};

/// One call of vtkSpectralAlgorithm::ComputeValues(). Places exist on the mesh, the solver is
/// ready; what a filter adds to inputs and properties of its own, it has checked or checks itself.
struct DGGSpectralTask
{
  const DGGContext& Context;                     ///< of the update
  const dgg::PoissonSolver& Solver;              ///< ready
  vtkMTimeType SolverTime;                       ///< changes with the solver
  const std::vector<dgg::SurfacePoint>& Sources; ///< none only where the filter may choose them
  const std::vector<dgg::SurfacePoint>& Targets; ///< may be none
  const DGGSourceSet& SourceSet;                 ///< as sources are given
  double FreeMemory;                             ///< bytes of the limit that are left for caches
  dgg::ProgressCallback Progress;                ///< the part of the context's that is left
  DGGSpectralOutputs& Outputs;                   ///< to be set for each source
};

#endif
