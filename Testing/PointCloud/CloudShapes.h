// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point clouds with known distances, and what tests ask of graphs.
#ifndef CloudShapes_h
#define CloudShapes_h

#include "GraphChecks.h"

#include "dggCloudGraphBuilder.h"
#include "dggPoint3.h"

#include <functional>
#include <string>
#include <vector>

namespace cloudtest
{
using dgg::Id;
using dgg::Point3;
using dggtest::GraphDistances;
using dggtest::WithThreads;

/// Points, x y z each, and the distance between two of them.
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

/// Random points of the unit sphere; `noise` moves them along each axis, but not what is known of
/// their distances.
Cloud Sphere(int count, unsigned seed, double noise = 0.0);
/// Random points of a square with sides of length 1. With a `gradient` there are that many times as
/// many per area on the right as on the left.
Cloud Square(int count, unsigned seed, double gradient = 1.0);
/// A regular grid of n x n points of the same.
Cloud Grid(int n);
/// Random points of a cylinder of radius 1 and height 3 around the z axis.
Cloud Cylinder(int count, unsigned seed);

/// A builder for the points of a cloud, which must stay.
dgg::CloudGraphBuilder MakeBuilder(const Cloud& cloud);

/// What is predicted; what the kernel refuses fails the test.
dgg::CloudGraphEstimate Predict(
  const Cloud& cloud, const dgg::CloudGraphOptions& options = dgg::CloudGraphOptions());

/// The message with which a graph is refused; empty when it is built.
std::string GetRefusal(const Cloud& cloud, const dgg::CloudGraphOptions& options);

/// Build; what the kernel refuses, and a graph that is not well formed, fails the test.
dgg::CloudGraph BuildGraph(const Cloud& cloud,
  const std::function<void(dgg::CloudGraphOptions&)>& change = nullptr,
  dgg::CloudGraphStatistics* statistics = nullptr);

struct Errors
{
  double Mean = 0.0; ///< of the absolute values
  double Bias = 0.0;
  double Max = 0.0;
  int Unreached = 0;
};

/// Relative errors of distances from some vertices, of those that are farther than `least`.
Errors MeasureErrors(const Cloud& cloud, const dgg::GraphView& graph, double least = 0.0);
}

#endif
