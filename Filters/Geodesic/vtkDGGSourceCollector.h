// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From source ids and source points to sources of the kernel. Internal.
#ifndef vtkDGGSourceCollector_h
#define vtkDGGSourceCollector_h

#include "dggExactGeodesics.h" // for GeodesicSource

#include "vtkType.h" // for vtkIdType

#include <memory> // for the locator
#include <string> // for the names
#include <vector> // for the sources

class vtkDGGMeshAdapter;
class vtkDGGSurfaceLocator;
class vtkPoints;
class vtkPolyData;

/// Points of the surface as a user gives them: ids first, then the points of an input port.
struct vtkDGGSourceSet
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
std::vector<dgg::SurfacePoint> vtkDGGGetPlaces(const std::vector<dgg::GeodesicSource>& sources);

/// Collects the sources of a distance filter, or other points, projected onto the surface. Keeps
/// the search structure until the mesh changes.
class vtkDGGSourceCollector
{
public:
  vtkDGGSourceCollector();
  ~vtkDGGSourceCollector();
  vtkDGGSourceCollector(const vtkDGGSourceCollector&) = delete;
  vtkDGGSourceCollector& operator=(const vtkDGGSourceCollector&) = delete;

  /// What does not need the mesh: whether there is a point at all, ids within the range,
  /// coordinates and initial distances finite.
  static dgg::Status Check(const vtkDGGSourceSet& set, vtkIdType numberOfPoints);

  /// The points on a mesh; checked once more. `coordinates` are those of the mesh;
  /// `tolerance` is how far from the surface a point may be, as a fraction of the diagonal.
  dgg::Status Collect(const vtkDGGSourceSet& set, double tolerance,
    const vtkDGGMeshAdapter& adapter, vtkPoints* coordinates,
    std::vector<dgg::GeodesicSource>& sources);

  /// What to warn of: ids of points that no polygon uses. Empty when there are none. The set must
  /// have been checked.
  static std::string DescribeIsolatedIds(
    const vtkDGGSourceSet& set, const vtkDGGMeshAdapter& adapter);

private:
  std::unique_ptr<vtkDGGSurfaceLocator> Locator;
  vtkMTimeType LocatedMesh = 0; // its build time
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGSourceCollector.h
