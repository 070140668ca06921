// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths as vtkPolyData. Internal.
#ifndef vtkDGGPathOutput_h
#define vtkDGGPathOutput_h

#include "dggPathFinder.h" // for FoundPath

#include "vtkType.h" // for vtkIdType

#include <vector> // for the paths

class vtkDGGNewGeometry;
class vtkDataSetAttributes;
class vtkPolyData;

/// What becomes a polyline.
struct vtkDGGPathSet
{
  const std::vector<dgg::FoundPath>& Paths;  ///< per pair
  vtkDataSetAttributes* CellData;            ///< to be handed on; may be null
  const std::vector<vtkIdType>& CellsOfLast; ///< tuples of CellData for the last pairs
};

/// The pairs that have no path.
std::vector<vtkIdType> vtkDGGFindUnconnected(const std::vector<dgg::FoundPath>& paths);

/// Make an output of polylines and arrays.
void vtkDGGWritePaths(
  const vtkDGGPathSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output);

#endif
// VTK-HeaderTest-Exclude: vtkDGGPathOutput.h
