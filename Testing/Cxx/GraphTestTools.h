// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of filters with a graph.
#ifndef GraphTestTools_h
#define GraphTestTools_h

#include "FilterTestTools.h"

#include "vtkDiscreteGeodesicGraph.h"

namespace dggtest
{
/// Returns the names of the field arrays of a graph.
const std::vector<std::string>& GetGraphArrayNames();

/// Returns a copy of the surface with a graph.
vtkSmartPointer<vtkPolyData> MakeSurfaceWithGraph(vtkPolyData* surface, double accuracy = 0.05,
  int construction = vtkDiscreteGeodesicGraph::Guaranteed);

/// Returns all bytes of the graph arrays, one string per array; empty for a missing array.
std::vector<std::string> GetGraphBytes(vtkPolyData* data);

/// Returns exact distances from point ids.
std::vector<double> GetExactDistances(vtkPolyData* surface, const std::vector<vtkIdType>& sources);
/// Returns exact distances from the points of `sources`.
std::vector<double> GetExactDistances(vtkPolyData* surface, vtkPolyData* sources);

/// Expects exact <= values <= (1 + accuracy) exact, up to rounding.
void ExpectUpperBounds(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy);
/// Expects |values - exact| <= accuracy exact, up to rounding.
void ExpectWithin(
  const std::vector<double>& values, const std::vector<double>& exact, double accuracy);
/// Returns the mean of |value / exact - 1|.
double GetMeanError(const std::vector<double>& values, const std::vector<double>& exact);

/// Calls `body` for each backend of vtkSMPTools and several numbers of threads. The argument names
/// backend and number.
void ForEachThreading(const std::function<void(const std::string&)>& body);
}

#endif
