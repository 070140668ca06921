// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of filters with a graph share.
#ifndef GraphTestTools_h
#define GraphTestTools_h

#include "FilterTestTools.h"

#include "vtkDiscreteGeodesicGraph.h"

#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
/// Names of the field arrays.
const std::vector<std::string>& GetGraphArrayNames();

/// The surface with a graph, a copy of its own.
vtkSmartPointer<vtkPolyData> MakeSurfaceWithGraph(vtkPolyData* surface, double accuracy = 0.05,
  int construction = vtkDiscreteGeodesicGraph::Guaranteed);

/// All bytes of the graph arrays, one string for each; empty for a missing one.
std::vector<std::string> GetGraphBytes(vtkPolyData* data);

/// Exact distances from point ids.
std::vector<double> GetExactDistances(vtkPolyData* surface, const std::vector<vtkIdType>& sources);
/// Exact distances from the points of `sources`.
std::vector<double> GetExactDistances(vtkPolyData* surface, vtkPolyData* sources);

/// Expect exact <= values <= (1 + accuracy) exact, up to rounding.
void ExpectUpperBounds(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy);
/// Expect |values - exact| <= accuracy exact, up to rounding.
void ExpectWithin(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy);
/// Mean of |value / exact - 1|.
double GetMeanError(const std::vector<double>& values, const std::vector<double>& exact);

/// Calls `body` with the backends of vtkSMPTools and several numbers of threads, one after the
/// other; its argument names them.
void ForEachThreading(const std::function<void(const std::string&)>& body);
}

#endif
