// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi diagrams, and points of surfaces, as vtkPolyData. Internal.
#ifndef vtkDGGVoronoiOutputs_h
#define vtkDGGVoronoiOutputs_h

#include "dggCentroidal.h"     // for CentroidalOptions
#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggVoronoi.h"        // for VoronoiDiagram

#include <array>  // for positions
#include <string> // for names
#include <vector> // for the results

class vtkDGGMeshAdapter;
class vtkPoints;
class vtkPolyData;

/// What vtkGeodesicVoronoi computes.
struct vtkDGGVoronoiResult
{
  std::vector<dgg::GeodesicSource> Sites;
  dgg::VoronoiDiagram Diagram;
  std::vector<double> Energies; ///< empty unless sites have been moved
  bool LabelsOnly = false;      ///< whether there are neither cells nor boundaries
  ///@{
  /// What was asked for.
  bool IsCentroidal = false;
  bool IsRefined = false;
  dgg::CentroidalOptions Moving;
  ///@}
};

/// Surface points as points with verts, and the point arrays `vtkOriginalPointIds` and `FaceId`:
/// the id of the point of the input, or -1, and a cell of the input, or -1. `coordinates`, those of
/// the mesh, may be null when there are no surface points.
void vtkDGGFillSurfacePoints(const std::vector<dgg::SurfacePoint>& places,
  const vtkDGGMeshAdapter& mesh, vtkPoints* coordinates, vtkPolyData* output);

/// Makes the outputs of a diagram on one surface.
class vtkDGGVoronoiOutputs
{
public:
  /// `coordinates` are those of the mesh; null for one without points. Everything must outlive the
  /// object.
  vtkDGGVoronoiOutputs(const vtkDGGVoronoiResult& result, const vtkDGGMeshAdapter& mesh,
    vtkPoints* coordinates, const std::string& distanceName, double unreachedValue);

  /// Add the arrays of labels, distances and energies to a copy of the input.
  void AddToSurface(const std::string& sourceName, vtkPolyData* output) const;
  void FillBoundaries(vtkPolyData* output) const;
  void FillCells(vtkPolyData* output) const;
  void FillSites(vtkPolyData* output) const;

private:
  std::vector<double> SumAreas() const;
  double GetDistance(dgg::Id point) const;
  std::array<double, 3> GetPosition(dgg::Id point, const double* positions) const;

  const vtkDGGVoronoiResult& Result;
  const vtkDGGMeshAdapter& Mesh;
  vtkPoints* Coordinates;
  const std::string& DistanceName;
  double UnreachedValue;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGVoronoiOutputs.h
