// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From source ids and source points to sources of the kernel. Internal.
#ifndef DGGSourceCollector_h
#define DGGSourceCollector_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggGeodesicSource.h"         // for GeodesicSource
#include "dggSurfacePoint.h"           // for places

#include "vtkType.h" // for vtkIdType

#include <string> // for the names
#include <vector> // for the sources

class vtkDataSetAttributes;
class vtkObject;
class vtkPolyData;
struct DGGContext;

/// Points of a surface or a cloud as a user gives them: ids first, then the points of an input
/// port.
struct DGGSourceSet
{
  const std::vector<vtkIdType>& Ids;
  vtkPolyData* Points;              ///< may be null
  int Port;                         ///< where Points come from
  std::string Role;                 ///< what messages call them
  std::string Remedy;               ///< how to give ids
  std::string InitialDistanceArray; ///< of Points; empty when there are no initial distances
  /// Of the ids, one for each; null when they all start with 0.
  const std::vector<double>* InitialDistances = nullptr;
  /// Those of Points that are meant, in this order; null for all.
  const std::vector<vtkIdType>* PointIds = nullptr;
  /// What messages call the surface, where there are several.
  std::string Surface = "input";
};

/// The places of sources.
VTKDGGFILTERSCOMMON_EXPORT std::vector<dgg::SurfacePoint> DGGGetPlaces(
  const std::vector<dgg::GeodesicSource>& sources);

/// Collects the sources of a distance filter, or other points, projected onto the surface.
class VTKDGGFILTERSCOMMON_EXPORT DGGSourceCollector
{
public:
  /// What does not need the mesh: whether there is a point at all, ids within the range,
  /// coordinates and initial distances finite.
  static dgg::Status Check(const DGGSourceSet& set, vtkIdType numberOfPoints);

  /// The points on the surface, or near those of a cloud, after Check(). Point arrays identify them
  /// where several layers of the surface coincide, in this order:
  ///  - `FaceId` and `Barycentric` (3 components) together: a triangle of the input and coordinates
  ///    with respect to its corners. The position of the point is ignored;
  ///  - `vtkOriginalPointIds`: a point of the input, where the point lies there.
  /// Outputs of filters have all three; then the first two count only where the point lies there.
  /// Other points are moved to the closest point of the surface. `tolerance` is how far from the
  /// surface a point may be, as a fraction of the diagonal. Where a cloud is sparser than that,
  /// positions between its points are accepted.
  static dgg::Status Collect(const DGGContext& context, const DGGSourceSet& set, double tolerance,
    std::vector<dgg::GeodesicSource>& sources);

  /// Add the point arrays of Points to `output`; each tuple is that of the nearest source. Where
  /// that is an id, or there is none: NaN, 0 or the empty string. Arrays of the output stay, where
  /// names are the same.
  static void PassArrays(
    const DGGSourceSet& set, const std::vector<dgg::Id>& nearest, vtkDataSetAttributes* output);

  /// Makes a filter warn of points collected from `set` that no polygon uses; in clouds, of points
  /// that are not finite.
  static void WarnAboutIsolated(const DGGContext& context, const DGGSourceSet& set,
    const std::vector<dgg::GeodesicSource>& sources, vtkObject* filter);
};

#endif
