// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point arrays with one component per source. Internal.
#ifndef DGGSpectralOutputs_h
#define DGGSpectralOutputs_h

#include "vtkDoubleArray.h"  // for the arrays
#include "vtkSmartPointer.h" // to hold them

#include <cstddef> // for std::size_t
#include <string>  // for the name
#include <vector>  // for values

namespace dgg
{
class PreparedSurface;
}

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

#endif
