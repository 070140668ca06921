// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest paths along the edges of the mesh by VTK.
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
  /// Builds the adjacency of the mesh, once.
  explicit PeerVTK(vtkPolyData* mesh);
  ~PeerVTK();

  /// Computes distances from one vertex to all.
  void Run(vtkIdType source);
  /// Returns the length of the path between two vertices, which must be connected; the search stops
  /// at the end vertex.
  double FindPath(vtkIdType from, vtkIdType to);
  /// Returns the distances of the last Run().
  std::vector<double> GetDistances();

private:
  vtkNew<vtkDijkstraGraphGeodesicPath> Filter;
};

#endif
