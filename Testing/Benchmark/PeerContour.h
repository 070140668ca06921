// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The isolines that VTK itself offers, linear in triangles: vtkContourFilter.
#ifndef PeerContour_h
#define PeerContour_h

#include "IsolineStatistics.h" // for IsolineSegment
#include "MeshArrays.h"        // for MeshArrays

#include <vtkNew.h>          // for the filter
#include <vtkSmartPointer.h> // for the mesh

#include <vector> // for levels

class vtkContourFilter;
class vtkPolyData;

class PeerContour
{
public:
  /// The mesh is copied; distances that are not finite must fill whole components.
  PeerContour(const MeshArrays& mesh, const std::vector<double>& distances,
    const std::vector<double>& levels);
  ~PeerContour();

  void Run();
  /// The result of the last Run(), where it lies in faces.
  std::vector<IsolineSegment> GetSegments(const dgg::SurfaceMesh& surface) const;

private:
  /// The level that an interpolated value stands for.
  double FindLevel(double value) const;

  const MeshArrays& Arrays;
  std::vector<double> Levels;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkContourFilter> Filter;
};

#endif
