// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of loops share: surfaces around which there are loops, loops of an output, and
/// what must hold for any of them.
#ifndef LoopTestTools_h
#define LoopTestTools_h

#include "PathTestTools.h"

#include "vtkDGGLoop.h"

#include <vector>

namespace dggtest
{
/// Returns the triangulated side of a prism over a regular polygon: `sides` times `rows` unit
/// squares. Point i of row j has the id j * sides + i.
vtkSmartPointer<vtkPolyData> MakePrism(int sides, int rows);
/// Radii 1 and 0.4; point i around the hole of row j has the id j * nu + i; it starts outside.
vtkSmartPointer<vtkPolyData> MakeTorus(int nu, int nv);
/// The lengths of its shortest loops around the tube and around the hole (nv even).
double GetTubeLength(int nu, int nv);
double GetHoleLength(int nu);

/// A loop, or a rim of the tape, with its arrays. A closed polyline repeats its first point at the
/// end; the ArcLength of the repeated point is the total length.
struct LoopLine
{
  PathLine Line;
  bool IsClosed = false;
  vtkIdType Loop = -1;
  double Angle = -1.0;
  int Kinked = -1;

  bool operator==(const LoopLine& other) const;
};

/// The polylines of the outputs; an array that is missing fails the test.
std::vector<LoopLine> GetLoops(vtkDGGLoop* filter);
std::vector<LoopLine> GetRims(vtkDGGLoop* filter);
std::vector<int> GetLoopStatus(vtkDGGLoop* filter);

/// Expect that a closed polyline passes straight over the edges of triangles, in its start as well
/// when `isSmoothAtStart`. What it does at points of the surface is not looked at.
void ExpectStraight(const LoopLine& loop, vtkPolyData* surface, bool isSmoothAtStart = true);
}

#endif
