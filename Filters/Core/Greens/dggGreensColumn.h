// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One Green's function: what is solved for, and what is made of the solution. Internal.
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
/// What threads do not share.
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

/// Usage: Start(), solve for TakeSources(), Finish() with the solution.
class GreensColumn
{
public:
  explicit GreensColumn(const PoissonSystem& system)
    : System(system)
  {
  }

  /// `progress` takes the place of the query's.
  Status Start(const SurfacePoint& pole, const GreensQuery& query, const ProgressCallback& progress,
    GreensWorkspace& workspace);
  /// Per vertex: the load of the pole, and of the logarithm; values where they are given.
  std::vector<double> TakeSources() { return std::move(this->Sources); }
  /// `solution` is changed.
  Status Finish(std::vector<double>& solution, const ProgressCallback& progress,
    GreensWorkspace& workspace, GreensResult& result) const;

  /// Add the logarithm to the regular part, which is changed and given away.
  void AddLogarithm(std::vector<double>& solution, GreensResult& result) const;

  /// The same for GreensOrder::BiLaplace, with the result that Finish() has made: the sources of
  /// the second equation, and the result from its solution.
  /// @{
  std::vector<double> TakeSecondSources(GreensResult& result) const;
  void FinishSecond(std::vector<double>& solution, GreensResult& result) const;
  /// @}

  /// Where the logarithm ends if nothing else is asked for and there are no ridges.
  static double GetUsualRadius(const PoissonSystem& system, Id component);
  static bool IsTooCoarse(const PoissonSystem& system, Id component, double radius);
  /// Whether triangles are so large beside the usual radius that functions of points in different
  /// ones would not be symmetric. The same for all poles of a component, which have the same method
  /// then.
  static bool HasLargeTriangles(const PoissonSystem& system, Id component);

  bool HasLogarithm() const { return this->Method == GreensMethod::SingularitySubtraction; }
  /// Weighted mean of the logarithm.
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
  ProgressCallback Progress; // of what is left of Start()
  GreensMethod Method = GreensMethod::Vertex;
  GreensRemark Remark = GreensRemark::None;
  Id Component = NoId;
  Logarithm Singular{ 1.0, 1.0 };
  double Mean = 0.0;
  std::vector<double> Sources;
  std::vector<double> Distances;
  std::vector<double> TargetDistances;
  std::vector<double> Integrals; // of the logarithm, with loads of its potential where it is needed
};

/// Fails when the solver is not ready or the query makes no sense.
Status CheckGreensQuery(const PoissonSolver& solver, const GreensQuery& query);

/// What is asked of the Laplacian first. The order stays, which columns know of.
GreensQuery GetFirstQuery(const GreensQuery& query);
/// Replace the results of the first query by those of GreensOrder::BiLaplace.
void RaiseOrder(const PoissonSystem& system, const GreensQuery& query,
  const std::vector<GreensColumn>& columns, GreensResult* results);

/// Value of piecewise linear data at a point.
double InterpolateAt(
  const SurfaceMesh& mesh, const SurfacePoint& point, const std::vector<double>& values);
}

#endif
