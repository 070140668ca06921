// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of distance filters share: small surfaces as vtkPolyData, results as vectors, and
/// what a filter says.
#ifndef FilterTestTools_h
#define FilterTestTools_h

#include "vtkGeodesicDistanceAlgorithm.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace dggtest
{
using Points = std::vector<std::array<double, 3>>;
using Cells = std::vector<std::vector<vtkIdType>>;

/// A surface with points stored as doubles.
vtkSmartPointer<vtkPolyData> MakeSurface(const Points& points, const Cells& polygons);
vtkSmartPointer<vtkCellArray> MakeCells(const Cells& cells);
/// Offsets beyond the end of the connectivity.
vtkSmartPointer<vtkCellArray> MakeContradictoryCells();
/// Points for input port 1.
vtkSmartPointer<vtkPolyData> MakeSourcePoints(const Points& points);

enum class GridCells
{
  Triangles,
  Quads,
  Strips
};
/// The rectangle [0, columns] x [0, rows] in unit squares; point i of row j has the id
/// j * (columns + 1) + i.
vtkSmartPointer<vtkPolyData> MakeGrid(
  int columns, int rows, GridCells cells = GridCells::Triangles, double unit = 1.0);
/// The unit cube of 12 triangles; the id of the point (x, y, z) is x + 2y + 4z.
vtkSmartPointer<vtkPolyData> MakeCube();
/// A bumpy sheet without any symmetry over [0, 1] x [0, 1], n points on each side.
vtkSmartPointer<vtkPolyData> MakeTerrain(int n);
double GetTerrainHeight(double x, double y);

/// A plate of 3 x 1 with a round hole of 40 corners, as CAD models have it: long triangles from the
/// hole to the rim, and more small ones on the wall of the hole. It is closed and has 308 points.
vtkSmartPointer<vtkPolyData> MakePlateWithHole();

/// Two surfaces of polygons as one, the second one shifted along x.
vtkSmartPointer<vtkPolyData> Beside(vtkPolyData* first, vtkPolyData* second, double shift);

/// Points and cells, as text.
std::string DescribeGeometry(vtkPolyData* output);

/// The distances in the output, or nothing when they are missing.
std::vector<double> GetDistances(vtkGeodesicDistanceAlgorithm* filter);
std::vector<int> GetNearestSources(vtkGeodesicDistanceAlgorithm* filter);
double EuclideanDistance(vtkPolyData* surface, vtkIdType a, vtkIdType b);
/// Expects straight distances from the first source id to all points of a plate.
void ExpectEuclidean(
  vtkGeodesicDistanceAlgorithm* filter, vtkPolyData* plate, double tolerance = 1e-12);

/// Listens to what an algorithm or an executive says, so that it is not printed.
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

/// Update, and expect what the contract promises on wrong input: one error that names the filter
/// and contains all of `parts`, an empty output, an error code.
void ExpectError(vtkAlgorithm* filter, const std::vector<std::string>& parts);
/// Update, and expect neither an error nor a warning.
void ExpectSuccess(vtkAlgorithm* filter);
/// Update, and expect success with one warning that contains all of `parts`.
void ExpectWarning(vtkAlgorithm* filter, const std::vector<std::string>& parts);
/// Expect that no output has points, cells, rows or arrays.
void ExpectEmptyOutput(vtkAlgorithm* filter);

/// Records progress; asks to stop when it reaches a value.
struct ProgressWatch
{
  std::vector<double> Progress;
  double StopAt = 2.0;

  explicit ProgressWatch(vtkAlgorithm* filter);
  void Observe(vtkObject* caller, unsigned long event, void* data);
  /// Expect that it grew from 0 to 1, not all at once: with this many steps in between.
  void ExpectGrowth(int steps = 3) const;
};
}

#endif
