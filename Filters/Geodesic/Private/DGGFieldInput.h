// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A distance field of the kernel from the arrays of a vtkPolyData. Internal.
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

/// Reads a point array of distances, and what there is beside it that gives the distance inside of
/// faces: windows in the field data (DGGWindowArrays), or else virtual sources in the point
/// data, or else virtual sources that are fitted to the distances. Values that rise too steeply for
/// distances are taken as linear, with a warning; that they are distances is the user's word.
class DGGFieldInput
{
public:
  /// The point array that a filter takes: the one that its SetInputArrayToProcess() says, or else
  /// the one that its property names; the active scalars when that name is empty. No other is taken
  /// in its place: fails, with the names that there are, when it is missing, and when it is not of
  /// one number per point. `filter` is the information of the filter.
  static dgg::Status FindDistances(vtkInformation* filter, const std::string& property,
    vtkPolyData* surface, vtkDataArray*& distances);

  /// The name that arrays of results have: that of the distances, or "GeodesicDistance" when they
  /// have none.
  static std::string GetName(vtkDataArray* distances);
  /// The same where FindDistances() was not asked.
  static std::string GetName(vtkInformation* filter, const std::string& property);

  /// The number that marks points that are not reached, besides NaN and infinity; NaN for the
  /// points that the array beside the distances names (DGGUnreachedArray), which is the default.
  void SetUnreachedValue(double value) { this->UnreachedValue = value; }

  /// The distances alone, to be taken as linear. Fails when a distance is minus infinity.
  dgg::Status ReadDistances(const DGGContext& context, vtkDataArray* distances);

  /// And what there is beside them, with a part of the progress.
  dgg::Status Read(const DGGContext& context, vtkDataArray* distances,
    const std::string& virtualSources, const dgg::ProgressCallback& progress);

  /// Whether virtual sources are those that have been fitted.
  bool HasFittedSources() const { return this->IsFitted; }
  /// Good as long as this and the mesh live.
  const dgg::DistanceField& GetField() const { return this->Field; }
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// Arrays that were there and could not be used, distances that are too steep; empty when all is
  /// well.
  const std::string& GetWarning() const { return this->Warning; }
  /// Returns a warning if distances inside triangles may be far off, otherwise an empty text.
  std::string DescribeQuality(const dgg::PreparedSurface& surface) const;

private:
  void ReadWindows(const DGGContext& context, vtkDataArray* distances);
  void ReadSources(const DGGContext& context, const std::string& name);
  bool HasSourcesOfDistances(const dgg::SurfaceMesh& mesh) const;
  dgg::Status FitSources(const dgg::SurfaceMesh& mesh, const dgg::ProgressCallback& progress);
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
