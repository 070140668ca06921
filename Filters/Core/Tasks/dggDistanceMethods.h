// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of a task by the methods that need no graph. Internal.
#ifndef dggDistanceMethods_h
#define dggDistanceMethods_h

#include "dggBandSizes.h"          // for BandOptions
#include "dggCoreExport.h"         // for DGG_CORE_EXPORT
#include "dggHeatMethod.h"         // for HeatOptions
#include "dggPropagationSession.h" // for PropagationSession

#include <array>    // for positions
#include <cstdint>  // for the build number
#include <memory>   // for solvers
#include <optional> // for the quality
#include <string>   // for remedies
#include <vector>   // for sources

namespace dgg
{
class CloudMarching;
class FastMarching;
enum class ExactEngine;
enum class MarchingUpdate;
struct DistanceTask;
struct TaskContext;

/// Computes exact distances. The memory of windows is limited if they are kept.
DGG_CORE_EXPORT Status FindExactDistances(
  const TaskContext& context, ExactEngine engine, bool keepWindows, DistanceTask& task);

/// The position of a source.
struct PlacedSource
{
  double InitialDistance = 0.0;
  std::array<double, 3> Position;
};

/// Raises distances below the straight line in space to the nearest source, if there are few.
/// `unit` is the mean edge length of the surface: squares of coordinates may overflow.
void KeepAboveStraightLine(const TaskContext& context, const std::vector<PlacedSource>& sources,
  double unit, double maximum, PropagationResult& result);

/// Computes distances by propagation of virtual sources.
DGG_CORE_EXPORT Status FindPropagatedDistances(const TaskContext& context,
  PropagationSession& session, std::optional<PropagationQuality> quality, DistanceTask& task);

/// Solver of the heat method, kept until the surface changes.
class DGG_CORE_EXPORT HeatSession
{
public:
  /// Computes the distances of a task. `remedy` is the suggested action if memory is insufficient.
  Status Run(const TaskContext& context, const HeatOptions& options, const std::string& remedy,
    DistanceTask& task);

  int GetNumberOfFactorizations() const;
  /// Returns the approximate number of bytes that are held.
  double GetMemorySize() const { return this->Method ? this->Method->GetEstimatedMemory() : 0.0; }

private:
  std::unique_ptr<HeatMethod> Method;
  std::uint64_t MeshBuild = 0;
  int EarlierFactorizations = 0; // for meshes before this one
};

/// Solver of fast marching, kept until the surface changes, or the band of a cloud.
class DGG_CORE_EXPORT MarchingSession
{
public:
  MarchingSession();
  ~MarchingSession();

  /// Fails if an option is out of range.
  static Status Check(const BandOptions& band);

  /// Computes the distances of a task. Only clouds use `band`.
  Status Run(
    const TaskContext& context, MarchingUpdate update, const BandOptions& band, DistanceTask& task);

  ///@{
  /// Returns the median radius of balls, in voxels, or the number of voxels along the longest side;
  /// 0 unless the last surface was a cloud.
  double GetBandRadius() const;
  Id GetResolution() const;
  ///@}

private:
  Status MarchOnMesh(const TaskContext& context, MarchingUpdate update, DistanceTask& task);
  Status MarchOnCloud(const TaskContext& context, const BandOptions& band, DistanceTask& task);

  std::unique_ptr<FastMarching> OnMesh;
  std::unique_ptr<CloudMarching> OnCloud;
  BandOptions Band; // of OnCloud
  std::uint64_t MeshBuild = 0;
};
}

#endif
