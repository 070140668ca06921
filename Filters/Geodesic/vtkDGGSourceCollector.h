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

/// Collects the sources of a distance filter: point ids first, then the points of a second input,
/// projected onto the surface. Keeps the search structure until Forget().
class vtkDGGSourceCollector
{
public:
  vtkDGGSourceCollector();
  ~vtkDGGSourceCollector();
  vtkDGGSourceCollector(const vtkDGGSourceCollector&) = delete;
  vtkDGGSourceCollector& operator=(const vtkDGGSourceCollector&) = delete;

  /// What does not need the mesh: whether there is a source at all, ids within the range,
  /// coordinates and initial distances finite. `points` may be null.
  static dgg::Status Check(const std::vector<vtkIdType>& ids, vtkPolyData* points,
    const std::string& initialDistanceName, vtkIdType numberOfPoints);

  /// The sources on a mesh, after a successful Check(). `coordinates` are those of the mesh;
  /// `tolerance` is how far from the surface a point may be, as a fraction of the diagonal.
  dgg::Status Collect(const std::vector<vtkIdType>& ids, vtkPolyData* points,
    const std::string& initialDistanceName, double tolerance, const vtkDGGMeshAdapter& adapter,
    vtkPoints* coordinates, std::vector<dgg::GeodesicSource>& sources);

  /// The mesh has changed.
  void Forget();

private:
  std::unique_ptr<vtkDGGSurfaceLocator> Locator;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGSourceCollector.h
