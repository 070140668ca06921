// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Colored surface as vtkPolyData. Internal.
#ifndef DGGGraphicsOutput_h
#define DGGGraphicsOutput_h

#include "DGGNewGeometry.h" // for points

#include "dggGraphicsFragments.h" // for fragments
#include "dggVectorGraphics.h"    // for the results

#include <string> // for the name
#include <vector> // for values

class vtkPolyData;
struct DGGContext;

/// Writes the outputs of vtkPoissonVectorGraphics.
class DGGGraphicsOutput
{
public:
  /// `name` is the name of the array with the values.
  explicit DGGGraphicsOutput(const std::string& name)
    : Name(name)
  {
  }

  /// Returns true if an array of the output other than the values has this name.
  static bool IsTaken(const std::string& name);

  /// Stores references to a surface and its mesh, which must outlive this object.
  dgg::Status Take(const DGGContext& context, int precision);

  /// Returns the approximate number of bytes per point of the output, including two triangles per
  /// point. Call Take() first.
  double GetBytesPerPoint(int channels) const;

  /// Writes points, triangles and all arrays.
  void Fill(const dgg::SubMesh& cut, const dgg::GraphicsResult& result, int channels,
    vtkPolyData* output) const;

  /// Writes fragments as points with all arrays.
  void FillFragments(
    const dgg::GraphicsFragments& fragments, int channels, vtkPolyData* output) const;

  /// Adds the values of points, all channels of a point in succession, and their colors for
  /// display.
  void AddColors(const std::vector<double>& values, int channels, vtkPolyData* output) const;
  /// Adds the net source of each component.
  void AddNetSources(const std::vector<double>& values, int channels, vtkPolyData* output) const;

private:
  void AddPoints(const std::vector<dgg::SurfacePoint>& places, vtkPolyData* output) const;
  void AddTriangles(const dgg::SubMesh& cut, vtkPolyData* output) const;

  std::string Name;
  vtkPolyData* Surface = nullptr;
  DGGNewGeometry Geometry;
};

#endif
