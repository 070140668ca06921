// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves and regions of a drawing as specified by the user. Internal.
#ifndef DGGGraphicsInput_h
#define DGGGraphicsInput_h

#include "dggVectorGraphics.h" // for curves and regions

#include "vtkType.h" // for vtkIdType

#include <string> // for names
#include <vector> // for curves

namespace dgg
{
class PreparedSurface;
}
class vtkPolyData;

/// Names of arrays, and the default width.
struct DGGGraphicsNames
{
  std::string CurveType;
  std::string LeftColor;
  std::string RightColor;
  std::string Strength;
  std::string RightStrength;
  std::string Width;
  std::string Region;         ///< cell array of the surface
  std::string RegionStrength; ///< cell array of the surface
  std::string Refinement;     ///< cell array of the surface
  double DefaultWidth = 0.0;
};

/// Lines with their parameters, and regions with their strengths.
class DGGGraphicsInput
{
public:
  /// Copies the input; `curves` may be null. Fails if an array is missing or has the wrong number
  /// of components, or if a number is not finite; the message names the defect.
  dgg::Status Read(vtkPolyData* curves, vtkPolyData* surface, const DGGGraphicsNames& names);

  /// Returns the cells of regions as faces of the mesh.
  std::vector<dgg::GraphicsRegion> MakeRegions(const dgg::PreparedSurface& mesh) const;

  /// Finds the faces of cells that are refined. Fails if the array is missing or has a NaN.
  static dgg::Status FindRefinedFaces(vtkPolyData* surface, const DGGGraphicsNames& names,
    const dgg::PreparedSurface& mesh, std::vector<dgg::Id>& faces);

  int GetNumberOfChannels() const { return this->NumberOfChannels; }
  const std::vector<dgg::GraphicsCurve>& GetCurves() const { return this->Curves; }
  /// Returns the points of each curve. The first point of a closed curve is not repeated at the
  /// end.
  const std::vector<std::vector<vtkIdType>>& GetPointIds() const { return this->PointIds; }

private:
  void CollectLines(vtkPolyData* curves);
  void ChooseChannels(vtkPolyData* curves, vtkPolyData* surface, const DGGGraphicsNames& names);
  void ReadType(vtkPolyData* curves, const DGGGraphicsNames& names, std::size_t k);
  void ReadCurve(vtkPolyData* curves, const DGGGraphicsNames& names, std::size_t k);
  void ReadRegions(vtkPolyData* surface, const DGGGraphicsNames& names);
  std::vector<double> ReadTuples(vtkPolyData* curves, const std::string& name, std::size_t k,
    int channels, bool mayBeSingle) const;

  int NumberOfChannels = 3;
  std::vector<dgg::GraphicsCurve> Curves;
  std::vector<std::vector<vtkIdType>> PointIds;
  std::vector<vtkIdType> Cells; // per curve
  std::vector<std::size_t> RegionOfCell;
  std::vector<std::vector<double>> RegionStrengths;
};

#endif
