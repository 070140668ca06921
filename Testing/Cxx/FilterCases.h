// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tables of filters on surfaces and clouds: construction of a working filter, and the input that
/// it must refuse.
#ifndef FilterCases_h
#define FilterCases_h

#include "FilterTestTools.h"

#include <ostream>
#include <type_traits>

namespace dggtest
{
/// An invalid property or input, and the words expected in the message: property name and value.
struct Refusal
{
  std::function<void(vtkGeodesicAlgorithm*)> Spoil;
  std::vector<std::string> Parts;
};

struct FilterCase
{
  const char* Name;
  /// Returns the filter on a relief, or on its points, ready to execute.
  std::function<vtkSmartPointer<vtkGeodesicAlgorithm>(vtkPolyData* relief)> Make;
  /// Makes the filter use surface points on its further input ports, in place of ids. Null for
  /// filters without such a port.
  std::function<void(vtkGeodesicAlgorithm*, vtkPolyData* points)> SetPoints;
  std::vector<const char*> Defaults = {}; ///< lines that a new filter prints
  std::vector<Refusal> Refusals = {};
  std::vector<int> Ports = {};          ///< output ports with new points on the surface
  std::vector<const char*> Arrays = {}; ///< point arrays of each of these outputs
  bool TakesPoints = false;             ///< true if the input has no polygons (a cloud)
};
void PrintTo(const FilterCase& filter, std::ostream* os);

std::vector<FilterCase> GetCurveFilters();
std::vector<FilterCase> GetDistanceFilters();
std::vector<FilterCase> GetSpectralFilters();
/// Returns the filters of the test program: all filters on surfaces, or all on clouds.
std::vector<FilterCase> GetAllFilters();

/// Returns all outputs of a filter as text.
std::string DescribeOutputs(vtkGeodesicAlgorithm* filter, bool withFieldData = true);

/// Returns a bumpy surface of (n + 1) x (n + 1) points with integer coordinates of the given type.
vtkSmartPointer<vtkPolyData> MakeRelief(int dataType, int n = 8);
/// Returns the point of a relief of any size that corresponds to point `id` of the relief of 9 x 9
/// points.
vtkIdType OnRelief(vtkPolyData* relief, vtkIdType id);
std::vector<vtkIdType> OnRelief(vtkPolyData* relief, std::vector<vtkIdType> ids);
void AddNote(vtkPolyData* surface, const char* name);
/// Adds straight-line distances from the first point as an array of geodesic distances. Returns the
/// largest distance.
double AddSpaceDistances(vtkPolyData* surface);
/// A point above the relief, farther away than the tolerance.
constexpr std::array<double, 3> FarFromRelief{ { 0.0, 0.0, 99.0 } };
/// Returns five points on edges of a relief: four around its middle, and one in the middle.
Points GetPointsOnEdges(vtkPolyData* relief);

template <typename Filter>
vtkSmartPointer<Filter> MakeFilter(vtkPolyData* relief)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(relief);
  return filter;
}

/// Returns a refusal whose invalid input is set by a member function of the filter class.
template <typename Filter, typename Function>
Refusal Refuse(Function spoil, const std::vector<std::string>& parts)
{
  return { [spoil](vtkGeodesicAlgorithm* filter) { spoil(Filter::SafeDownCast(filter)); }, parts };
}

/// Returns a FilterCase::SetPoints that calls a member function of the filter class.
template <typename Filter, typename Function>
std::function<void(vtkGeodesicAlgorithm*, vtkPolyData*)> PointSetter(Function set)
{
  return [set](vtkGeodesicAlgorithm* filter, vtkPolyData* points) {
    set(Filter::SafeDownCast(filter), points);
  };
}

/// Returns the refusals of surface points that are not finite or too far from the surface.
std::vector<Refusal> RefusePoints(const FilterCase& filter, const std::string& words);
/// Returns the refusals of invalid values of a property.
template <typename Filter, typename Value>
std::vector<Refusal> RefuseValues(void (Filter::*set)(Value),
  const std::vector<std::decay_t<Value>>& values, const std::vector<std::string>& parts)
{
  std::vector<Refusal> refusals;
  for (const auto& value : values)
  {
    refusals.push_back(Refuse<Filter>([set, value](Filter* f) { (f->*set)(value); }, parts));
  }
  return refusals;
}
Refusal RefuseMemoryLimit(vtkTypeInt64 limit);
/// Returns the refusals common to all filters.
std::vector<Refusal> RefuseInput();

/// Returns the refusals common to all filters that search a graph.
template <typename Filter>
std::vector<Refusal> RefuseGraph()
{
  auto refusals = RefuseValues(&Filter::SetAccuracy,
    { 0.0, 9e-7, 0.51, std::numeric_limits<double>::quiet_NaN() }, { "ccuracy", "1e-06", "0.5" });
  refusals.push_back(RefuseMemoryLimit(1000));
  return refusals;
}

inline std::vector<Refusal> operator+(std::vector<Refusal> a, const std::vector<Refusal>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
}

#endif
