// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A coloured surface as vtkPolyData. Internal.
#ifndef DGGGraphicsOutput_h
#define DGGGraphicsOutput_h

#include "DGGNewGeometry.h" // for points

#include "dggGraphicsFragments.h" // for fragments
#include "dggVectorGraphics.h"    // for the results

#include <string> // for the name
#include <vector> // for values

class vtkPolyData;
struct DGGContext;

/// The outputs of vtkPoissonVectorGraphics.
class DGGGraphicsOutput
{
public:
  /// `name` is that of the array with the values.
  explicit DGGGraphicsOutput(const std::string& name)
    : Name(name)
  {
  }

  /// Whether an array of the output has a name besides that of the values.
  static bool IsTaken(const std::string& name);

  /// What is kept of a surface, which must live on, as must its mesh.
  dgg::Status Take(const DGGContext& context, int precision);

  /// About what a point of the output takes, with the two triangles that there are for it. After
  /// Take().
  double GetBytesPerPoint(int channels) const;

  /// Points, triangles and all arrays.
  void Fill(const dgg::SubMesh& cut, const dgg::GraphicsResult& result, int channels,
    vtkPolyData* output) const;

  /// Fragments as points with all arrays.
  void FillFragments(
    const dgg::GraphicsFragments& fragments, int channels, vtkPolyData* output) const;

  /// Values of points, all channels of one after each other, and what is shown of them.
  void AddColors(const std::vector<double>& values, int channels, vtkPolyData* output) const;
  /// What sources sum to, per component.
  void AddNetSources(const std::vector<double>& values, int channels, vtkPolyData* output) const;

private:
  void AddPoints(const std::vector<dgg::SurfacePoint>& places, vtkPolyData* output) const;
  void AddTriangles(const dgg::SubMesh& cut, vtkPolyData* output) const;

  std::string Name;
  vtkPolyData* Surface = nullptr;
  DGGNewGeometry Geometry;
};

#endif
