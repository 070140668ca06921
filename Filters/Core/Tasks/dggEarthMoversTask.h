// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Earth mover's distance as a task. Internal.
#ifndef dggEarthMoversTask_h
#define dggEarthMoversTask_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggEarthMovers.h"  // for options
#include "dggInputArray.h"   // for masses
#include "dggSurfacePoint.h" // for points

#include <string> // for names
#include <vector> // for points

namespace dgg
{
class PoissonSession;
class PreparedSurface;
struct Output;
struct TaskContext;

/// Distribution of mass by one number per point of the surface, by masses at other points, or both.
struct DGG_CORE_EXPORT MassDistribution
{
  ///@{
  /// Words of messages.
  std::string Role;           ///< "from" or "to"
  std::string Property;       ///< property with the name of Values
  std::string PointsProperty; ///< name of the input of other points
  ///@}

  InputArray Values{};                ///< array of the surface; without a name if there are none
  InputArray Masses{};                ///< array of other points; without a name, each has mass 1
  Offset NumberOfPlaces = 0;          ///< number of other points
  std::vector<SurfacePoint> Places{}; ///< where they are on the surface

  /// Fails if there is no mass at all, if an array is missing or has a wrong size, or if a number
  /// is negative or not finite. Places are not used.
  Status Check(const PreparedSurface& surface) const;
};

struct EarthMoversTask
{
  EarthMoversOptions Options; ///< progress is set here
  bool IsIntrinsicDelaunay = false;
  bool AreDensities = true; ///< meaning of MassDistribution::Values; otherwise masses
  bool Normalizes = true;
  Offset NumberOfCells = 0; ///< cells of the input, of any type

  ///@{
  /// Results: the distance, a lower bound, and the gap between them relative to the distance.
  double Distance = 0.0;
  double LowerBound = 0.0;
  double Gap = 0.0;
  int Iterations = 0;
  ///@}
};

/// Name of the point array with the potential, and of the cell array with the flow.
constexpr const char* EarthMoversPotentialName = "EarthMoversPotential";
constexpr const char* EarthMoversFlowName = "EarthMoversFlow";

/// Computes the distance between two distributions, which have been checked. Adds to the surface
/// the potential, the flow (unless IsIntrinsicDelaunay), and the distance and its lower bound as
/// field data. `remedy` is what to do if memory is insufficient.
DGG_CORE_EXPORT Status FindEarthMoversDistance(const TaskContext& context, PoissonSession& session,
  const MassDistribution* distributions, const std::string& remedy, EarthMoversTask& task,
  Output& output);
}

#endif
