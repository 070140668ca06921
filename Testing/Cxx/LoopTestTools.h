// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of loops: surfaces with non-trivial loops, loops of an output, and the
/// invariants of any loop.
#ifndef LoopTestTools_h
#define LoopTestTools_h

#include "PathTestTools.h"

#include "vtkDGGLoop.h"

namespace dggtest
{
/// Returns the triangulated side of a prism over a regular polygon: `sides` times `rows` unit
/// squares. Point i of row j has the id j * sides + i.
vtkSmartPointer<vtkPolyData> MakePrism(int sides, int rows);
/// Returns a torus of radii 1 and 0.4. Point i (around the hole) of row j has the id j * nu + i;
/// row 0 is the outermost one.
vtkSmartPointer<vtkPolyData> MakeTorus(int nu, int nv);
/// Return the lengths of the shortest loops of the torus around the tube and around the hole (nv
/// even).
double GetTubeLength(int nu, int nv);
double GetHoleLength(int nu);

/// A loop, or an edge of the tape, with its arrays. A closed polyline repeats its first point at
/// the end; the ArcLength of the repeated point is the total length.
struct LoopLine
{
  PathLine Line;
  bool IsClosed = false;
  vtkIdType Loop = -1;
  double Angle = -1.0;
  int Kinked = -1;

  bool operator==(const LoopLine& other) const;
};

/// Returns the polylines of the outputs; a missing array fails the test.
std::vector<LoopLine> GetLoops(vtkDGGLoop* filter);
std::vector<LoopLine> GetRims(vtkDGGLoop* filter);
std::vector<int> GetLoopStatus(vtkDGGLoop* filter);
}

#endif
