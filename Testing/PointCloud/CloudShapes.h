// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point clouds with known distances, and checks of graphs.
#ifndef CloudShapes_h
#define CloudShapes_h

#include "GraphChecks.h"

#include "dggCloudGraphBuilder.h"
#include "dggPoint3.h"

namespace cloudtest
{
using dgg::Id;
using dgg::Point3;
using dggtest::GraphDistances;
using dggtest::WithThreads;

/// Point coordinates (x, y, z per point), and the distance between two points.
struct Cloud
{
  std::vector<double> Points;
  std::function<double(Id, Id)> Distance;

  Id GetSize() const { return static_cast<Id>(this->Points.size() / 3); }
  Point3 At(Id i) const
  {
    const std::size_t k = 3 * static_cast<std::size_t>(i);
    return { this->Points[k], this->Points[k + 1], this->Points[k + 2] };
  }
  void Add(const Point3& p)
  {
    for (const double x : { p.X, p.Y, p.Z })
    {
      this->Points.push_back(x);
    }
  }
};

/// Returns random points of the unit sphere. `noise` moves points along each axis, but does not
/// change the known distances.
Cloud Sphere(int count, unsigned seed, double noise = 0.0);
/// Returns random points of a unit square. The density at the right side is `gradient` times the
/// density at the left side.
Cloud Square(int count, unsigned seed, double gradient = 1.0);
/// Returns a regular grid of n x n points of the unit square.
Cloud Grid(int n);
/// Returns random points of a cylinder of radius 1 and height 3 around the z axis.
Cloud Cylinder(int count, unsigned seed);

/// Returns a builder for the points of a cloud, which must outlive the builder.
dgg::CloudGraphBuilder MakeBuilder(const Cloud& cloud);

/// Returns the prediction of the kernel; a refusal fails the test.
dgg::CloudGraphEstimate Predict(
  const Cloud& cloud, const dgg::CloudGraphOptions& options = dgg::CloudGraphOptions());

/// Returns the message with which a graph is refused; empty if it is built.
std::string GetRefusal(const Cloud& cloud, const dgg::CloudGraphOptions& options);

/// Builds a graph. A refusal, or a malformed graph, fails the test.
dgg::CloudGraph BuildGraph(const Cloud& cloud,
  const std::function<void(dgg::CloudGraphOptions&)>& change = nullptr,
  dgg::CloudGraphStatistics* statistics = nullptr);

struct Errors
{
  double Mean = 0.0; ///< mean absolute value
  double Bias = 0.0;
  double Max = 0.0;
  int Unreached = 0;
};

/// Returns the relative errors of distances from some vertices, for distances larger than `least`.
Errors MeasureErrors(const Cloud& cloud, const dgg::GraphView& graph, double least = 0.0);
}

#endif
