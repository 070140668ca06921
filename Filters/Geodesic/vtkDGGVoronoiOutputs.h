// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi diagrams, and points of surfaces, as vtkPolyData. Internal.
#ifndef vtkDGGVoronoiOutputs_h
#define vtkDGGVoronoiOutputs_h

#include "dggCentroidal.h"     // for CentroidalOptions
#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggVoronoi.h"        // for VoronoiDiagram

#include <string> // for names
#include <vector> // for the results

class vtkDGGMeshAdapter;
class vtkDGGNewGeometry;
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

/// Makes the outputs of a diagram on one surface.
class vtkDGGVoronoiOutputs
{
public:
  /// Everything must outlive the object.
  vtkDGGVoronoiOutputs(const vtkDGGVoronoiResult& result, const vtkDGGMeshAdapter& mesh,
    const vtkDGGNewGeometry& geometry, const std::string& distanceName, double unreachedValue);

  /// Add the arrays of labels, distances and energies to a copy of the input.
  void AddToSurface(const std::string& sourceName, vtkPolyData* output) const;
  void FillBoundaries(vtkPolyData* output) const;
  void FillCells(vtkPolyData* output) const;
  void FillSites(vtkPolyData* output) const;

private:
  std::vector<double> SumAreas() const;
  double GetTrueDistance(dgg::Id point) const;
  double GetDistance(dgg::Id point) const;
  dgg::SurfacePoint GetPlace(dgg::Id point) const;

  const vtkDGGVoronoiResult& Result;
  const vtkDGGMeshAdapter& Mesh;
  const vtkDGGNewGeometry& Geometry;
  const std::string& DistanceName;
  double UnreachedValue;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGVoronoiOutputs.h
