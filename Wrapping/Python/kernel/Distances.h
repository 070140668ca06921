// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Arguments and results that all distances share.
#ifndef Distances_h
#define Distances_h

#include "Arguments.h"
#include "Call.h"
#include "Outputs.h"
#include "Surface.h"
#include "SurfacePoints.h"

#include "dggDistanceOutput.h" // for DistanceTask

#include <functional> // for steps
#include <string>     // for names

namespace dggPython
{
///@{
/// Default names of arrays.
constexpr const char* DistanceName = "GeodesicDistance";
constexpr const char* SourceName = "GeodesicSource";
constexpr const char* VirtualSourceName = "GeodesicVirtualSource";
///@}

/// Documentation of the arguments and results of distances.
#define DGG_DISTANCE_DOCUMENTATION(parameters, references)                                       \
  "sources : surface points\n"                                                                   \
  "initial_distances : array_like, one per source\n"                                             \
  "    Distances at the sources. Default: 0.\n"                                                  \
  "maximum_distance : float\n"                                                                   \
  "    Points farther than this are not reached. Default: no limit.\n"                           \
  "unreached_value : float\n"                                                                    \
  "    Distance of unreached points. Default: NaN. Another value than NaN or infinity adds the " \
  "array\n"                                                                                      \
  "    \"GeodesicDistance.Unreached\".\n"                                                        \
  "generate_nearest_source, generate_virtual_source : bool\n"                                    \
  "    Add \"GeodesicSource\" (int32, -1 if unreached) or \"GeodesicVirtualSource\" (offset, "   \
  "length, angle), and for a graph on large triangles exact distances with windows.\n"           \
  "distance_array_name, source_array_name, virtual_source_array_name : str\n"                    \
  "    Names of the arrays.\n" parameters                                                        \
  "projection_tolerance, memory_limit, number_of_threads, progress\n"                            \
  "    See the module.\n\n"                                                                      \
  "Returns\n-------\n"                                                                           \
  "SimpleNamespace\n"                                                                            \
  "    Point data: \"GeodesicDistance\" (float64) and the arrays above.\n"                       \
  "    quality_warning is true if a warning is about the accuracy.\n\n"                          \
  "Raises\n------\n"                                                                             \
  "Error\n"                                                                                      \
  "    For an invalid source or option, and if memory is insufficient.\n\n"                      \
  "References\n----------\n" references

/// A computation of distances.
class Distances
{
public:
  /// Computes the distances of a task.
  using Step = std::function<dgg::Status(const dgg::TaskContext& context, dgg::DistanceTask& task)>;

  Distances(const py::handle& sources, Arguments& arguments);

  /// Requests an array of upper bounds with this name.
  void RequestUpperBound(const std::string& name);

  /// Locates the sources, runs the step and writes the results. `what` is the name of distances
  /// that need a surface; null if clouds are accepted.
  py::object Run(Call& call, const Surface& surface, const char* what, const Step& step);

private:
  SurfacePoints Sources;
  dgg::DistanceRequest Request;
};

/// Fails for a point cloud; `what` needs a surface.
dgg::Status RequireSurface(const dgg::PreparedSurface& surface, const char* what);
}

#endif
