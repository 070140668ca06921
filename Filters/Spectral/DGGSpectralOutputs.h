// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point arrays with one component per source. Internal.
#ifndef DGGSpectralOutputs_h
#define DGGSpectralOutputs_h

#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for surface points
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

/// The results of a vtkSpectralAlgorithm at the points of the surface and at evaluation points.
class DGGSpectralOutputs
{
public:
  /// Returns the bytes of both arrays.
  static double EstimateMemory(
    std::size_t numberOfPoints, std::size_t numberOfTargets, std::size_t numberOfSources);

  /// Allocates the arrays of results; none without sources.
  DGGSpectralOutputs(const dgg::PreparedSurface& mesh, std::size_t numberOfPoints,
    std::size_t numberOfTargets, std::size_t numberOfSources, const std::string& name);
  ~DGGSpectralOutputs();
  DGGSpectralOutputs(const DGGSpectralOutputs&) = delete;
  DGGSpectralOutputs& operator=(const DGGSpectralOutputs&) = delete;

  /// Sets the values of one source, per vertex of the mesh and per target. Several threads may set
  /// values of different sources simultaneously.
  void Set(
    std::size_t source, const std::vector<double>& values, const std::vector<double>& targetValues);

  /// Adds a further array (vtkDoubleArray or vtkIdTypeArray), per vertex of the mesh and per
  /// target.
  template <typename ArrayType, typename Number>
  void Add(const std::string& name, const std::vector<Number>& values,
    const std::vector<Number>& targetValues);

  /// Adds a further vtkDoubleArray with several components.
  void AddColumns(const std::string& name, const std::vector<std::vector<double>>& columns,
    const std::vector<std::vector<double>>& targetColumns);

  /// Returns the further arrays of the points (port 0) or of the targets (port 1).
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

/// Arguments of vtkSpectralAlgorithm::ComputeValues(). Surface points are valid and the solver is
/// ready; a filter checks further inputs and properties of its own.
struct DGGSpectralTask
{
  const DGGContext& Context;                     ///< of the update
  const dgg::PoissonSolver& Solver;              ///< ready
  vtkMTimeType SolverTime;                       ///< changes with the solver
  const std::vector<dgg::SurfacePoint>& Sources; ///< empty only if the filter may select sources
  const std::vector<dgg::SurfacePoint>& Targets; ///< may be empty
  const DGGSourceSet& SourceSet;                 ///< sources as given
  double FreeMemory;                             ///< bytes of the limit that are left for caches
  dgg::ProgressCallback Progress;                ///< remaining progress of the context
  DGGSpectralOutputs& Outputs;                   ///< to be set for each source
};

#endif
