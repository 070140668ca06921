// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of distance filters: small surfaces as vtkPolyData, results as
/// vectors, and observers of errors, warnings and progress.
#ifndef FilterTestTools_h
#define FilterTestTools_h

#include "vtkGeodesicDistanceAlgorithm.h"

// Classes that most tests of filters use.
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dggtest
{
struct TestMesh;
using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::vector<vtkIdType>>;

/// Returns a surface with points stored as doubles.
vtkSmartPointer<vtkPolyData> MakeSurface(const Points& points, const Cells& polygons);
/// Returns a mesh of the kernel tests.
vtkSmartPointer<vtkPolyData> MakeSurface(const TestMesh& mesh);
vtkSmartPointer<vtkCellArray> MakeCells(const Cells& cells);
/// Returns cells whose offsets exceed the connectivity array.
vtkSmartPointer<vtkCellArray> MakeContradictoryCells();
/// Returns source points for input port 1.
vtkSmartPointer<vtkPolyData> MakeSourcePoints(const Points& points);

/// Adds an array of values, component by component.
template <typename ArrayType = vtkDoubleArray>
void AddArray(vtkFieldData* data, const std::string& name, const std::vector<double>& values,
  int components = 1)
{
  vtkNew<ArrayType> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename ArrayType::ValueType>(value));
  }
  data->AddArray(array);
}

enum class GridCells
{
  Triangles,
  Quads,
  Strips
};
/// Returns the rectangle [0, columns] x [0, rows] in unit squares; point i of row j has the id j *
/// (columns + 1) + i.
vtkSmartPointer<vtkPolyData> MakeGrid(
  int columns, int rows, GridCells cells = GridCells::Triangles, double unit = 1.0);
/// Returns the unit cube of 12 triangles; the id of the point (x, y, z) is x + 2y + 4z.
vtkSmartPointer<vtkPolyData> MakeCube();
/// Returns a bumpy surface without any symmetry over [0, 1] x [0, 1], n points on each side.
vtkSmartPointer<vtkPolyData> MakeTerrain(int n);
double GetTerrainHeight(double x, double y);

/// Returns a 3 x 1 plate with a round hole of 40 corners, triangulated as in CAD models: long
/// triangles from the hole to the rim, and many small triangles on the wall of the hole. The
/// surface is closed and has 308 points.
vtkSmartPointer<vtkPolyData> MakePlateWithHole();

/// Changes the coordinates of each point.
void MovePoints(vtkPolyData* data, const std::function<void(double*)>& move);

/// Returns the union of two polygonal surfaces, the second one shifted along x.
vtkSmartPointer<vtkPolyData> Beside(vtkPolyData* first, vtkPolyData* second, double shift);

/// Returns points and cells as text.
std::string DescribeGeometry(vtkPolyData* output);

/// Returns a number of the filter's mesh report by its column.
double GetReported(vtkGeodesicAlgorithm* filter, const char* name);

/// Returns the distances in the output; empty if they are missing.
std::vector<double> GetDistances(vtkGeodesicDistanceAlgorithm* filter);
std::vector<int> GetNearestSources(vtkGeodesicDistanceAlgorithm* filter);
double EuclideanDistance(vtkPolyData* surface, vtkIdType a, vtkIdType b);
/// Expects Euclidean distances from the first source id to all points of a plate.
void ExpectEuclidean(
  vtkGeodesicDistanceAlgorithm* filter, vtkPolyData* plate, double tolerance = 1e-12);

/// Records the errors and warnings of an algorithm or an executive instead of printing them.
class Listener
{
public:
  explicit Listener(vtkObject* subject);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener();

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  class Command;
  vtkSmartPointer<vtkObject> Subject;
  vtkSmartPointer<vtkCommand> Observer;
};

/// Updates the filter and expects the behavior that the contract promises on invalid input: one
/// error that names the filter and contains all of `parts`, an empty output, an error code.
void ExpectError(vtkAlgorithm* filter, const std::vector<std::string>& parts);
/// Updates the filter and expects neither an error nor a warning.
void ExpectSuccess(vtkAlgorithm* filter);
/// Updates the filter and expects success with one warning that contains all of `parts`.
void ExpectWarning(vtkAlgorithm* filter, const std::vector<std::string>& parts);
/// Expects that no output has points, cells, rows or arrays.
void ExpectEmptyOutput(vtkAlgorithm* filter);

/// Records progress; requests an abort when progress reaches `StopAt`.
struct ProgressWatch
{
  std::vector<double> Progress;
  double StopAt = 2.0;

  explicit ProgressWatch(vtkAlgorithm* filter);
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;
  ~ProgressWatch();
  void Observe(vtkObject* caller, unsigned long event, void* data);
  /// Expects that progress grew from 0 to 1, with at least this number of steps in between.
  void ExpectGrowth(int steps = 3) const;

private:
  vtkSmartPointer<vtkAlgorithm> Filter;
  unsigned long Tag;
};
}

#endif
