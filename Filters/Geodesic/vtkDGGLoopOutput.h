// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops and tapes as vtkPolyData. Internal.
#ifndef vtkDGGLoopOutput_h
#define vtkDGGLoopOutput_h

class vtkDGGNewGeometry;
class vtkPolyData;
struct vtkDGGLoopSet;

///@{
/// Make an output of polylines and arrays.
void vtkDGGWriteLoops(
  const vtkDGGLoopSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output);
void vtkDGGWriteTapes(
  const vtkDGGLoopSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output);
///@}

#endif
// VTK-HeaderTest-Exclude: vtkDGGLoopOutput.h
