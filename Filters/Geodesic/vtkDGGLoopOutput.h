// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops and tapes as vtkPolyData. Internal.
#ifndef vtkDGGLoopOutput_h
#define vtkDGGLoopOutput_h

class vtkDGGMeshAdapter;
class vtkPolyData;
struct vtkDGGLoopSet;

///@{
/// Put polylines and arrays into an output, which has no points, cells, point or cell data.
/// `positions` are those of the vertices.
void vtkDGGWriteLoops(const vtkDGGLoopSet& set, const vtkDGGMeshAdapter& mesh,
  const double* positions, vtkPolyData* output);
void vtkDGGWriteTapes(const vtkDGGLoopSet& set, const vtkDGGMeshAdapter& mesh,
  const double* positions, vtkPolyData* output);
///@}

#endif
// VTK-HeaderTest-Exclude: vtkDGGLoopOutput.h
