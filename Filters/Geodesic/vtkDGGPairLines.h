// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pairs of points that are given as lines. Internal.
#ifndef vtkDGGPairLines_h
#define vtkDGGPairLines_h

#include "dggTypes.h" // for Status

#include "vtkType.h" // for vtkIdType

#include <vector> // for the ends

class vtkPolyData;

/// The lines of a vtkPolyData, each of which stands for the pair of its first and last point.
struct vtkDGGPairLines
{
  std::vector<vtkIdType> Ends;  ///< points, two for each line
  std::vector<vtkIdType> Cells; ///< per line, the cell

  /// Read what is connected to input port 1; may be null. Fails when there are points but no lines,
  /// nothing at all although it `isNeeded`, or a line is not valid.
  dgg::Status Read(vtkPolyData* lines, bool isNeeded);
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGPairLines.h
