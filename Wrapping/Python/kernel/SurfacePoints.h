// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of a surface as arguments.
#ifndef SurfacePoints_h
#define SurfacePoints_h

#include "dggSourceCollection.h" // for SourceCollection

#include <pybind11/pybind11.h>

#include <string> // for names
#include <vector> // for points

namespace dgg
{
struct TaskContext;
}

namespace dggPython
{
namespace py = pybind11;

class Arguments;

/// Points of a surface or a cloud as specified by the user.
class SurfacePoints
{
public:
  /// Reads points in any of the forms that the documentation of the module lists; None for no
  /// points. `role` is the name of a point in messages. The points are an argument with the name of
  /// `property`, such as "FirstLandmarks".
  SurfacePoints(const py::handle& object, const std::string& role, const std::string& property);

  /// Reads `initial_distances` and `projection_tolerance`.
  void ReadInitialDistances(Arguments& arguments);
  void ReadTolerance(Arguments& arguments);
  void SetTolerance(double tolerance) { this->Tolerance = tolerance; }

  /// Returns the number of points.
  std::size_t Size() const;
  bool IsEmpty() const { return this->Size() == 0; }
  double GetTolerance() const { return this->Tolerance; }
  /// Returns the points that the kernel locates, to change their wording or kind.
  dgg::SourceCollection& GetCollection() { return this->Collection; }

  ///@{
  /// Locate the points. Warns about points that no polygon uses if `warnings` is not null.
  dgg::Status Locate(const dgg::TaskContext& context, std::vector<dgg::GeodesicSource>& sources,
    std::vector<std::string>* warnings = nullptr) const;
  dgg::Status Locate(const dgg::TaskContext& context, std::vector<dgg::SurfacePoint>& points,
    std::vector<std::string>* warnings = nullptr) const;
  ///@}

private:
  dgg::SourceCollection Collection;
  double Tolerance = dgg::SourceCollection::DefaultTolerance;
};
}

#endif
