// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of paths: polylines of an output, and the invariants of any path.
#ifndef PathTestTools_h
#define PathTestTools_h

#include "FilterTestTools.h"

#include "vtkDGGPath.h"

namespace dggtest
{
/// A polyline with its arrays in the output.
struct PathLine
{
  Points Positions;
  std::vector<vtkIdType> Faces;
  std::vector<vtkIdType> PointIds;
  std::vector<double> ArcLengths;
  double Length = 0.0;
  double GraphLength = 0.0;
  int Straightened = -1;
  vtkIdType Pair = -1;

  bool operator==(const PathLine& other) const;
};

/// Returns true if an output has polylines with the point data of a PathLine and these cell data; a
/// missing array fails the test.
bool HasPolylines(vtkPolyData* output, const std::vector<const char*>& cellArrays);
/// Reads the points of a polyline, their data and its length.
void ReadPolyline(vtkPolyData* output, vtkIdType line, PathLine& path);

/// Returns the polylines of the output; a missing array fails the test.
std::vector<PathLine> GetPaths(vtkDGGPath* filter);
std::vector<int> GetPathStatus(vtkDGGPath* filter);

/// Expects that every segment lies in the cell of the surface that FaceId names, that points with
/// an id coincide with that point, and that Length and ArcLength match the segments, all to 1e-9.
/// `slack` is the length that triangles without area may add.
void ExpectOnSurface(const PathLine& path, vtkPolyData* surface, double slack = 0.0);

/// Expects that both ends of every segment lie in the triangle of the surface that FaceId names, up
/// to 1e-9 of its diagonal. Returns the number of segments.
vtkIdType ExpectPiecesInTheirFaces(vtkPolyData* surface, vtkPolyData* lines);
/// Returns lines between points 0 and 1, 2 and 3, and so on.
vtkSmartPointer<vtkPolyData> MakePairs(const Points& ends);
}

#endif
