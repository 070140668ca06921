// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the image tests draw with: panels with a camera each, surfaces, lines as tubes, points as
/// balls, arrows, and numbers as colours. Everything is drawn in the same style, so that a scene
/// says only what is in it and from where it is seen.
#ifndef ImageScene_h
#define ImageScene_h

#include "FilterTestTools.h"

#include "vtkLookupTable.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <string>

namespace dggtest
{
using Color = std::array<double, 3>;
constexpr Color Clay = { { 0.87, 0.86, 0.82 } };
constexpr Color Ink = { { 0.12, 0.12, 0.15 } };
constexpr Color Red = { { 0.82, 0.1, 0.14 } };
constexpr Color Blue = { { 0.1, 0.32, 0.68 } };
constexpr Color Orange = { { 0.95, 0.6, 0.1 } };

/// From where a panel is seen; z is up.
struct Viewpoint
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  double Angle; ///< of view, in degrees
};
/// Of MakeTerrain() and MakePebble().
constexpr Viewpoint TerrainView = { { { 0.15, -0.7, 2.0 } }, { { 0.54, 0.455, 0.0 } }, 29.5 };
constexpr Viewpoint PebbleView = { { { 2.2, -5.0, 3.0 } }, { { 0.17, 0.05, 0.06 } }, 26.0 };

/// A closed smooth surface without symmetry: a sphere with two bumps and a dent, of 20 * 4^level
/// triangles.
vtkSmartPointer<vtkPolyData> MakePebble(int level);

/// Colours of distances and other functions, in bands of equal width: yellow where they are low,
/// purple where they are high. NaN is grey.
vtkSmartPointer<vtkLookupTable> FieldColors(double low, double high, int bands = 20);
/// Colours of errors: blue where they are negative, red where they are positive, white at 0.
vtkSmartPointer<vtkLookupTable> ErrorColors(double largest);
/// Colours of ids from 0. Consecutive ids differ clearly; negative ids are grey.
vtkSmartPointer<vtkLookupTable> NumberColors(int count);

class ImageScene
{
public:
  /// Panels in rows, of some pixels each. They are filled from left to right, from top to bottom.
  explicit ImageScene(int columns = 1, int rows = 1, int width = 300, int height = 240);

  /// Begin the next panel: what is added from now on is in it.
  void AddPanel(const Viewpoint& view);

  /// Polygons in one colour, or coloured by a component of a point or cell array. Without a table,
  /// the array has the colours.
  vtkActor* AddSurface(vtkPolyData* data, const Color& color = Clay);
  vtkActor* AddSurface(
    vtkPolyData* data, const std::string& array, vtkLookupTable* colors, int component = 0);

  /// Lines as tubes, in the same two ways.
  vtkActor* AddLines(vtkPolyData* data, double radius, const Color& color);
  vtkActor* AddLines(
    vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors);

  /// Points as balls, in the same two ways.
  vtkActor* AddPoints(vtkPolyData* data, double radius, const Color& color);
  vtkActor* AddPoints(
    vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors);
  /// Those of a surface that have these ids.
  vtkActor* AddPoints(
    vtkPolyData* data, const std::vector<vtkIdType>& ids, double radius, const Color& color);

  /// Lines where a point array of a surface has n values, evenly from `first` to `last`.
  vtkActor* AddContours(
    vtkPolyData* data, double radius, const std::string& array, double first, double last, int n);

  /// The vectors of a point array, each as long as `length` times itself.
  vtkActor* AddArrows(
    vtkPolyData* data, const std::string& vectors, double length, const Color& color);

  /// Draw, and compare strictly with Testing/Baseline/<name>.png, see StrictImageComparison.h.
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
