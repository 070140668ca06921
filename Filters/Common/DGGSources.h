// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts source ids and points of input ports to the arrays of the kernel. Internal.
#ifndef DGGSources_h
#define DGGSources_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggGeodesicSource.h"         // for GeodesicSource

#include "vtkType.h" // for vtkIdType

#include <cstddef> // for std::size_t
#include <string>  // for the names
#include <vector>  // for the sources

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkObject;
class vtkPolyData;
struct DGGContext;
namespace dgg
{
struct SourceCollection;
}

/// Points of a surface or a cloud as specified by the user: ids, then the points of an input port.
/// The point arrays `FaceId`, `Barycentric` and `vtkOriginalPointIds` of the port identify points
/// as dgg::SourceCollection describes.
struct VTKDGGFILTERSCOMMON_EXPORT DGGSourceSet
{
  const std::vector<vtkIdType>& Ids;
  vtkPolyData* Points;              ///< may be null
  int Port;                         ///< input port of Points
  std::string Role;                 ///< name of a point in messages
  std::string Property;             ///< property of ids; empty if there is none
  std::string InitialDistanceArray; ///< array of Points; empty for no initial distances
  /// Per id; null for zeros.
  const std::vector<double>* InitialDistances = nullptr;
  /// Ids of the points of the port that are used, in this order; null for all.
  const std::vector<vtkIdType>* PointIds = nullptr;
  /// True if the points are starts and ends of pairs in turn.
  bool ArePairs = false;
  /// Name of the surface in messages, if there are several.
  std::string Surface = "input";

  /// Returns the number of points of the port that are used.
  std::size_t CountPoints() const;
  /// Returns the index at the port of the i-th point that is used.
  vtkIdType GetPointId(std::size_t i) const;
  bool IsEmpty() const { return this->Ids.empty() && this->CountPoints() == 0; }
};

/// Copies the points of a set. Fails if an array of the port has a wrong size or type.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGCollect(
  const DGGSourceSet& set, dgg::SourceCollection& sources);

///@{
/// Locates the points of a set on the surface, or near the points of a cloud: see
/// dgg::SourceCollection::Locate(). `filter`, if not null, warns about points that no polygon uses.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGLocate(const DGGContext& context, const DGGSourceSet& set,
  double tolerance, std::vector<dgg::GeodesicSource>& sources, vtkObject* filter = nullptr);
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGLocate(const DGGContext& context, const DGGSourceSet& set,
  double tolerance, std::vector<dgg::SurfacePoint>& points, vtkObject* filter = nullptr);
///@}

/// Adds the cell arrays of the lines of `data`, which may be null, to an output: its cell i has the
/// values of line `lines[i] - first`, and zeros if there is none.
VTKDGGFILTERSCOMMON_EXPORT void DGGPassLineArrays(vtkPolyData* data,
  const std::vector<dgg::Offset>& lines, vtkIdType first, vtkDataSetAttributes* output);

/// Adds the point arrays of the port to `output`; each tuple is that of the nearest source. All
/// points of the port must be used: `PointIds` is null. If the nearest source is an id, or if there
/// is none, the value is NaN, 0 or the empty string. Arrays of the output with the same names are
/// kept.
VTKDGGFILTERSCOMMON_EXPORT void DGGPassArrays(
  const DGGSourceSet& set, const std::vector<dgg::Id>& nearest, vtkDataSetAttributes* output);

#endif
