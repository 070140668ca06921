// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The two linear systems of the heat method. Internal.
#ifndef dggHeatSystem_h
#define dggHeatSystem_h

#include "dggHeatMethod.h"    // for the options
#include "dggLaplaceSystem.h" // for the factorizations
#include "dggScaledNumber.h"  // for little heat

#include <Eigen/SparseCore> // for the matrices

#include <array>   // for triangles
#include <cstddef> // for std::size_t
#include <cstdint> // for flags
#include <vector>  // for arrays

namespace dgg
{
/// Matrices and factorizations.
class HeatSystem : public LaplaceSystem
{
public:
  /// Heat injected at a vertex: e to the power of Logarithm, times Weight.
  struct Load
  {
    Id Vertex;
    double Weight;
    double Logarithm;
  };

  explicit HeatSystem(const SurfaceMesh& mesh);

  Status Analyze(const HeatOptions& options, const ProgressCallback& progress);
  Status Factorize(const ProgressCallback& progress);
  bool IsReady() const;

  /// Returns the result of a query, per vertex, up to a constant per component. The result is empty
  /// if `progress` returned false.
  std::vector<double> Solve(const std::vector<Load>& loads, const ProgressCallback& progress) const;

  const HeatOptions& GetOptions() const { return this->Options; }
  /// Returns the distance over which the temperature falls by a factor of e: the square root of the
  /// time.
  double GetHeatLength(Id component) const;
  Id GetNumberOfTriangles(Id component) const { return this->Triangles[component]; }

  double GetEstimatedMemory() const;
  bool HoldsFactors() const;
  int GetNumberOfFactorizations() const { return this->NumberOfFactorizations; }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  /// A triangle with its first edge on the x axis.
  struct Frame
  {
    std::array<Id, 3> Corners;
    double Length;
    double ApexX;
    double ApexY;
  };

  void MeasureEdges();
  void TakeFrames();
  Matrix MakeHeatMatrix() const;
  bool NeedsDirichlet() const { return this->Options.Boundary != HeatBoundary::Neumann; }
  bool NeedsNeumann() const { return this->Options.Boundary != HeatBoundary::Dirichlet; }

  template <typename Number>
  std::vector<Number> SolveHeat(const std::vector<Load>& loads) const;
  template <typename Number>
  bool FindFlow(const std::vector<Load>& loads, std::vector<double>& flow) const;

  HeatOptions Options;
  bool IsAnalyzed = false;
  double NeumannFactor = -1.0;   ///< time step factor of the Neumann system
  double DirichletFactor = -1.0; ///< time step factor of the Dirichlet system
  int NumberOfFactorizations = 0;
  std::vector<double> MeanEdges; // per component
  std::vector<Id> Triangles;     // number of triangles per component
  std::vector<Frame> Frames;
  SparseFactor Heat;
  SparseFactor DirichletHeat;
  SparseFactor Distance;
};
}

#endif
