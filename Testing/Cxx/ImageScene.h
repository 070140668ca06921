// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Drawing tools of the image tests: panels with a camera each, surfaces, lines as tubes, points as
/// spheres, arrows, and values as colors. All scenes share one style; a scene defines only its
/// content and its viewpoints.
#ifndef ImageScene_h
#define ImageScene_h

#include "FilterTestTools.h"

#include "vtkLookupTable.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace dggtest
{
using Color = std::array<double, 3>;
constexpr Color Clay = { { 0.87, 0.86, 0.82 } };
constexpr Color Ink = { { 0.12, 0.12, 0.15 } };
constexpr Color Red = { { 0.82, 0.1, 0.14 } };
constexpr Color Blue = { { 0.1, 0.32, 0.68 } };
constexpr Color Orange = { { 0.95, 0.6, 0.1 } };

/// Camera of a panel; z is up.
struct Viewpoint
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  double Angle; ///< view angle, degrees
};
/// Viewpoints of MakeTerrain() and MakePebble().
constexpr Viewpoint TerrainView = { { { 0.15, -0.7, 2.0 } }, { { 0.54, 0.455, 0.0 } }, 29.5 };
constexpr Viewpoint PebbleView = { { { 2.2, -5.0, 3.0 } }, { { 0.17, 0.05, 0.06 } }, 26.0 };

/// Returns a closed smooth surface without symmetry: a sphere with two bumps and a dent, of 20 *
/// 4^level triangles.
vtkSmartPointer<vtkPolyData> MakePebble(int level);

/// Returns the colors of distances and other functions, in bands of equal width, from yellow (low)
/// to purple (high). NaN is gray.
vtkSmartPointer<vtkLookupTable> FieldColors(double low, double high, int bands = 20);
/// Returns the colors of errors: blue for negative values, red for positive values, white at 0.
vtkSmartPointer<vtkLookupTable> ErrorColors(double largest);
/// Returns the colors of ids from 0. Consecutive ids differ clearly; negative ids are gray.
vtkSmartPointer<vtkLookupTable> NumberColors(int count);

class ImageScene
{
public:
  /// Creates a grid of panels; width and height of a panel are in pixels. Panels are filled from
  /// left to right, from top to bottom.
  explicit ImageScene(int columns = 1, int rows = 1, int width = 300, int height = 240);

  /// Begins the next panel, to which all following actors are added.
  void AddPanel(const Viewpoint& view);

  /// Adds polygons in one color, or colored by a component of a point or cell array. Without a
  /// table, the array contains the colors.
  vtkActor* AddSurface(vtkPolyData* data, const Color& color = Clay);
  vtkActor* AddSurface(
    vtkPolyData* data, const std::string& array, vtkLookupTable* colors, int component = 0);

  /// Adds lines as tubes, colored in the same two ways.
  vtkActor* AddLines(vtkPolyData* data, double radius, const Color& color);
  vtkActor* AddLines(
    vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors);

  /// Adds points as spheres, colored in the same two ways.
  vtkActor* AddPoints(vtkPolyData* data, double radius, const Color& color);
  vtkActor* AddPoints(
    vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors);
  /// Adds the points of a surface that have these ids.
  vtkActor* AddPoints(
    vtkPolyData* data, const std::vector<vtkIdType>& ids, double radius, const Color& color);

  /// Adds isolines of a point array of a surface at n values, evenly spaced from `first` to `last`.
  vtkActor* AddContours(
    vtkPolyData* data, double radius, const std::string& array, double first, double last, int n);

  /// Adds the vectors of a point array as arrows, scaled by `length`.
  vtkActor* AddArrows(
    vtkPolyData* data, const std::string& vectors, double length, const Color& color);

  /// Draws the scene and compares it strictly with Testing/Baseline/<name>.png, see
  /// StrictImageComparison.h.
  void ExpectBaseline(const std::string& name);

private:
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Panel;
  int Columns;
  int Rows;
  int NumberOfPanels = 0;

  vtkActor* AddActor(vtkAlgorithmOutput* output, const Color& color);
  vtkActor* AddActor(vtkAlgorithmOutput* output, vtkLookupTable* colors);
};
}

#endif
