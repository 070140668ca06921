// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distance field of the kernel from the arrays of a vtkPolyData. Internal.
#ifndef DGGFieldInput_h
#define DGGFieldInput_h

#include "dggDistanceField.h" // for DistanceField

#include <limits> // for NaN
#include <string> // for names and warnings
#include <vector> // for the distances

class vtkDataArray;
class vtkInformation;
class vtkPolyData;
namespace dgg
{
class PreparedSurface;
}
struct DGGContext;

/// Reads a point array of distances and the data that determine distances inside faces: windows in
/// the field data (DGGWindowArrays), or else virtual sources in the point data, or else virtual
/// sources that are fitted to the distances. Values that are too steep for distances are
/// interpolated linearly, with a warning; further checks are not made.
class DGGFieldInput
{
public:
  /// Finds the point array that a filter uses: the array of its SetInputArrayToProcess(), or else
  /// the array that its property names; the active scalars if that name is empty. There is no
  /// fallback to another array: fails, with the names of existing arrays, if the array is missing
  /// or does not have one number per point. `filter` is the information object of the filter.
  static dgg::Status FindDistances(vtkInformation* filter, const std::string& property,
    vtkPolyData* surface, vtkDataArray*& distances);

  /// Returns the base name of result arrays: the name of the distances, or "GeodesicDistance" if
  /// they have no name.
  static std::string GetName(vtkDataArray* distances);
  /// Same if FindDistances() has not been called.
  static std::string GetName(vtkInformation* filter, const std::string& property);

  /// Sets the value, besides NaN and infinity, that marks unreached points. Default NaN: the points
  /// that the array DGGUnreachedArray of the distances marks.
  void SetUnreachedValue(double value) { this->UnreachedValue = value; }

  /// Reads distances only, for linear interpolation. Fails if a distance is minus infinity.
  dgg::Status ReadDistances(const DGGContext& context, vtkDataArray* distances);

  /// Reads distances and the windows or virtual sources that belong to them. Reports a part of the
  /// progress.
  dgg::Status Read(const DGGContext& context, vtkDataArray* distances,
    const std::string& virtualSources, const dgg::ProgressCallback& progress);

  /// Returns true if virtual sources were fitted to the distances.
  bool HasFittedSources() const { return this->IsFitted; }
  /// Valid as long as this object and the mesh exist.
  const dgg::DistanceField& GetField() const { return this->Field; }
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// Returns warnings about arrays that exist but cannot be used and distances that are too steep;
  /// empty if there are none.
  const std::string& GetWarning() const { return this->Warning; }
  /// Returns a warning if distances inside triangles may be far off, otherwise an empty text.
  std::string DescribeQuality(const dgg::PreparedSurface& surface) const;

private:
  void ReadWindows(const DGGContext& context, vtkDataArray* distances);
  void ReadSources(const DGGContext& context, const std::string& name);
  bool HasSourcesOfDistances(const dgg::SurfaceMesh& mesh) const;
  dgg::Status FitSources(const DGGContext& context, const dgg::ProgressCallback& progress);
  void Warn(const std::string& text);

  std::vector<double> Distances; // per vertex
  dgg::EdgeWindows Windows;
  dgg::VirtualSources Sources;
  dgg::DistanceField Field;
  std::string Warning;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  bool IsFitted = false;
};

#endif
