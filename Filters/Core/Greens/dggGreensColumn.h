// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One Green's function: right-hand side and evaluation of the solution. Internal.
#ifndef dggGreensColumn_h
#define dggGreensColumn_h

#include "dggExactGeodesics.h" // for distances
#include "dggGreensFunction.h" // for queries and results
#include "dggPoissonSystem.h"  // for the system
#include "dggSingularPart.h"   // for the logarithm

#include <utility> // for std::move
#include <vector>  // for arrays

namespace dgg
{
/// Per-thread workspace.
struct GreensWorkspace
{
  explicit GreensWorkspace(const PoissonSystem& system)
    : Exact(system.GetMesh())
    , Singular(system)
  {
  }

  ExactGeodesics Exact;
  SingularPart Singular;
};

/// One column. Usage: Start(), solve for TakeSources(), Finish() with the solution.
class GreensColumn
{
public:
  explicit GreensColumn(const PoissonSystem& system)
    : System(system)
  {
  }

  /// Computes distances and loads of a pole. `progress` is used instead of the progress callback of
  /// the query.
  Status Start(const SurfacePoint& pole, const GreensQuery& query, const ProgressCallback& progress,
    GreensWorkspace& workspace);
  /// Returns the right-hand side per vertex: the loads of the pole and of the logarithm, or the
  /// given value.
  std::vector<double> TakeSources() { return std::move(this->Sources); }
  /// Computes the result from `solution`, which is modified.
  Status Finish(std::vector<double>& solution, const ProgressCallback& progress,
    GreensWorkspace& workspace, GreensResult& result) const;

  /// Adds the logarithm to the regular part in `solution`, which is moved to the result.
  void AddLogarithm(std::vector<double>& solution, GreensResult& result) const;

  /// Functions for GreensOrder::BiLaplace, to be called with the result of Finish(): the first
  /// returns the sources of the second equation, the second computes the result from its solution.
  /// @{
  std::vector<double> TakeSecondSources(GreensResult& result) const;
  void FinishSecond(std::vector<double>& solution, GreensResult& result) const;
  /// @}

  /// Returns the default radius of the logarithm in the absence of ridges.
  static double GetUsualRadius(const PoissonSystem& system, Id component);
  static bool IsTooCoarse(const PoissonSystem& system, Id component, double radius);
  /// Returns true if triangles are so large relative to the default radius that functions of points
  /// in different triangles would not be symmetric. The result is the same for all poles of a
  /// component, which then use the same method.
  static bool HasLargeTriangles(const PoissonSystem& system, Id component);

  bool HasLogarithm() const { return this->Method == GreensMethod::SingularitySubtraction; }
  /// Returns the weighted mean of the logarithm.
  double GetMean() const { return this->Mean; }

private:
  void AddLoad(Id v, double weight) { this->Sources[v] += weight; }
  Id FindNearestFreeCorner() const;
  Status StartWithLogarithm(GreensWorkspace& workspace);
  Status FindDistances(double maximum, GreensWorkspace& workspace);
  Status CompleteDistances(double radius, double reached, GreensWorkspace& workspace);
  Status ChooseRadius(GreensWorkspace& workspace, double& radius, double& reached);
  bool FindPoleFaces(std::vector<PoleFace>& faces) const;
  bool FindFlippedPoleFace(std::vector<PoleFace>& faces) const;
  double GetPoleAngle() const;
  double SingularAt(double distance, double area) const;

  const PoissonSystem& System;
  SurfacePoint Pole;
  GreensQuery Query;
  ProgressCallback Progress; // progress of the remaining part of Start()
  GreensMethod Method = GreensMethod::Vertex;
  GreensRemark Remark = GreensRemark::None;
  Id Component = NoId;
  Logarithm Singular{ 1.0, 1.0 };
  double Mean = 0.0;
  std::vector<double> Sources;
  std::vector<double> Distances;
  std::vector<double> TargetDistances;
  std::vector<double>
    Integrals; // integrals of the logarithm, plus loads of its potential if needed
};

/// Fails if the solver is not ready or the query is invalid.
Status CheckGreensQuery(const PoissonSolver& solver, const GreensQuery& query);

/// Returns the query for the first equation, with the Laplacian. Order is unchanged because columns
/// need the order.
GreensQuery GetFirstQuery(const GreensQuery& query);
/// Replaces the results of the first query by those of GreensOrder::BiLaplace.
void RaiseOrder(const PoissonSystem& system, const GreensQuery& query,
  const std::vector<GreensColumn>& columns, GreensResult* results);

/// Returns the value of piecewise linear data at a point.
double InterpolateAt(
  const SurfaceMesh& mesh, const SurfacePoint& point, const std::vector<double>& values);
}

#endif
