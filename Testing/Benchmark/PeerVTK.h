// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What VTK itself offers: shortest paths along the edges of the mesh.
#ifndef PeerVTK_h
#define PeerVTK_h

#include <vtkNew.h>  // for the filter
#include <vtkType.h> // for vtkIdType

#include <vector> // for the distances

class vtkDijkstraGraphGeodesicPath;
class vtkPolyData;

class PeerVTK
{
public:
  /// The adjacency of the mesh is built here, once.
  explicit PeerVTK(vtkPolyData* mesh);
  ~PeerVTK();

  /// Run from one vertex to all.
  void Run(vtkIdType source);
  /// Length of the path from one vertex to another one, which must be connected with it; the search
  /// stops there.
  double FindPath(vtkIdType from, vtkIdType to);
  /// Distances of the last Run().
  std::vector<double> GetDistances();

private:
  vtkNew<vtkDijkstraGraphGeodesicPath> Filter;
};

#endif
