// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSetup.h"

#include "dggCloudNoise.h"
#include "dggMemoryLimit.h"
#include "dggQuantile.h"
#include "dggSetupLoop.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Progress weights of steps other than the band and the reaches.
constexpr double ShareOfFits = 0.22;
/// Weight of the fits to more neighbors, and of the repeated fits after points have been moved.
constexpr double ShareOfNoise = 0.08;
constexpr double ShareOfSmoothing = 0.2;

/// Memory, in bytes, per node for all data of the nodes and their kd-tree, and per point before the
/// nodes are known.
constexpr std::size_t BytesPerNode = 191;
constexpr std::size_t BytesPerPoint = 72;

/// Runs the steps of the setup in sequence.
class SetupBuilder
{
public:
  SetupBuilder(const CloudGraphOptions& options, const ProgressCallback& progress,
    CloudSetup& setup, CloudGraphStatistics& statistics)
    : Options(options)
    , Loop(options.Parallel, progress)
    , Setup(setup)
    , Pairs(setup.Pairs)
    , Statistics(statistics)
  {
  }

  Status Run()
  {
    const std::size_t n = this->Pairs.Points.size();
    this->Pairs.IsSmooth.assign(n, 0);
    this->Pairs.UsesArcs = this->Options.ArcLengthWeights;
    this->Setup.Neighbors = std::make_unique<CloudNeighbors>(this->Pairs.Points);
    CloudNoise noise;
    if (!this->Loop.Report(0.0, 0.0) ||
      !FitSurfaces(this->Setup, ShareOfFits, this->Loop, this->Fits) ||
      !RemoveNoise(this->Setup, ShareOfNoise, this->Loop, this->Fits, noise))
    {
      return Status::Abort();
    }
    this->Loop.FinishAt(ShareOfFits + ShareOfNoise); // with or without noise
    this->Statistics.Noise = noise.Removed / this->Setup.Nodes.Scale;
    this->Statistics.NoiseByRadius = noise.RemovedByRadius;
    this->Statistics.OffSurface = noise.OffSurface;
    this->Statistics.Scatter = noise.Scatter;
    this->SmoothSpacings();
    if (this->Loop.IsStopped())
    {
      return Status::Abort();
    }
    if (this->Options.Normals)
    {
      this->TakeNormals();
    }
    DGG_RETURN_IF_ERROR(BuildCloudBand(this->Options, this->Loop, this->Setup, this->Statistics));
    this->Pairs.FindNearestPoint = [&neighbors = *this->Setup.Neighbors](const Point3& place) {
      thread_local std::vector<CloudNeighbor> found;
      neighbors.FindNearest(place, 1, found);
      return found[0].Point;
    };
    ChooseReaches(this->Options, this->MedianSpacing, this->Fits.Curvatures, this->Loop,
      this->Setup, this->Statistics);
    return this->Loop.IsStopped() ? Status::Abort() : Status::Success();
  }

private:
  /// Replaces spacings and curvatures by values that are robust against single points far from the
  /// surface.
  void SmoothSpacings()
  {
    std::vector<float> spacings(this->Pairs.Spacings.size());
    std::vector<float> curvatures(spacings.size());
    this->Loop.ForNodes(spacings.size(), ShareOfSmoothing, [&](Id begin, Id end) {
      std::vector<CloudNeighbor> neighbors;
      std::vector<float> around;
      for (Id node = begin; node < end; ++node)
      {
        this->Setup.Neighbors->FindNearest(
          this->Pairs.Points[node], SpacingNeighbors + 1, neighbors);
        spacings[node] = SmoothSpacing(this->Pairs.Spacings[node], neighbors, this->Pairs.Spacings);
        around.clear();
        for (const CloudNeighbor& neighbor : neighbors)
        {
          around.push_back(this->Fits.Curvatures[neighbor.Point]);
        }
        curvatures[node] = Quantile(around, 0.5);
      }
    });
    this->Pairs.Spacings.swap(spacings);
    this->Fits.Curvatures.swap(curvatures);
    spacings = this->Pairs.Spacings;
    this->MedianSpacing = Quantile(spacings, 0.5);
    this->Statistics.Spacing = this->MedianSpacing / this->Setup.Nodes.Scale;
  }

  /// Replaces fitted normals by the given ones, where these are finite and not 0.
  void TakeNormals()
  {
    const double* normals = this->Options.Normals;
    const std::size_t oriented = this->Options.HasOrientedNormals ? this->Pairs.Points.size() : 0;
    this->Pairs.IsOriented.assign(oriented, 0);
    for (std::size_t i = 0; i < this->Pairs.Points.size(); ++i)
    {
      const double* n = normals + 3 * static_cast<std::size_t>(this->Setup.Nodes.Originals[i]);
      const double largest = std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) });
      if (largest > 0.0 && std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]))
      {
        const Point3 normal{ n[0] / largest, n[1] / largest, n[2] / largest };
        this->Pairs.Normals[i] = (1.0 / Norm(normal)) * normal;
        if (this->Options.HasOrientedNormals)
        {
          this->Pairs.IsOriented[i] = 1; // fitted normals have arbitrary sign
        }
      }
    }
  }

  const CloudGraphOptions& Options;
  SetupLoop Loop;
  CloudSetup& Setup;
  CloudPairs& Pairs;
  CloudGraphStatistics& Statistics;
  CloudFits Fits;
  double MedianSpacing = 0.0;
};
}

std::size_t CloudSetup::GetMemorySize() const
{
  return this->NormalsMemory + BytesPerNode * this->Pairs.Points.size() +
    this->Nodes.Coincident.capacity() * sizeof(this->Nodes.Coincident[0]) +
    this->Pairs.Band.GetMemorySize() + this->Pairs.Nearest.capacity() * sizeof(Id);
}

std::size_t CloudSetup::GetMemoryBefore(Id numberOfPoints) const
{
  return this->NormalsMemory + BytesPerPoint * static_cast<std::size_t>(numberOfPoints);
}

Status CheckSetupMemory(std::size_t bytes, const CloudGraphOptions& options)
{
  return options.MemoryLimit > 0
    ? CheckMemory("The preparation of the points", static_cast<double>(bytes),
        static_cast<double>(options.MemoryLimit), "Use fewer points")
    : Status::Success();
}

Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics)
{
  setup.NormalsMemory =
    options.Normals ? static_cast<std::size_t>(numberOfPoints) * sizeof(Point3) : 0;
  DGG_RETURN_IF_ERROR(CheckSetupMemory(setup.GetMemoryBefore(numberOfPoints), options));
  Status status = FindNodes(points, numberOfPoints, setup.Nodes, setup.Pairs.Points);
  statistics.UnusedPoints = setup.Nodes.Unused;
  statistics.Outliers = setup.Nodes.NumberOfOutliers;
  statistics.CoincidentPoints = static_cast<Id>(setup.Nodes.Coincident.size());
  if (!status.IsOk() || setup.Pairs.Points.empty())
  {
    return status;
  }
  DGG_RETURN_IF_ERROR(CheckSetupMemory(setup.GetMemorySize(), options));
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  return SetupBuilder(options, progress, setup, statistics).Run();
}
}
