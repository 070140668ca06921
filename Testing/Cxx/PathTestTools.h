// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of paths share: polylines of an output, and what must hold for any of them.
#ifndef PathTestTools_h
#define PathTestTools_h

#include "FilterTestTools.h"

#include "vtkDGGPath.h"

#include <vector>

namespace dggtest
{
/// A polyline with what the filter says of it.
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

/// Whether an output has polylines with the point data of a PathLine and these cell data; an array
/// that is missing fails the test.
bool HasPolylines(vtkPolyData* output, const std::vector<const char*>& cellArrays);
/// The points of a polyline, their data and its length.
void ReadPolyline(vtkPolyData* output, vtkIdType line, PathLine& path);

/// The polylines of the output; an array that is missing fails the test.
std::vector<PathLine> GetPaths(vtkDGGPath* filter);
std::vector<int> GetPathStatus(vtkDGGPath* filter);

/// Expect that every piece lies in the cell of the surface that FaceId names, that points with an
/// id are that point, and that Length and ArcLength are those of the pieces; all of it to 1e-9.
/// `slack` is what triangles without area add to lengths.
void ExpectOnSurface(const PathLine& path, vtkPolyData* surface, double slack = 0.0);

/// Expects that both ends of every piece of the lines lie in the triangle of the surface that
/// FaceId names, up to 1e-9 of its diagonal. Returns the number of pieces.
vtkIdType ExpectPiecesInTheirFaces(vtkPolyData* surface, vtkPolyData* lines);
/// Returns lines between points 0 and 1, 2 and 3, and so on.
vtkSmartPointer<vtkPolyData> MakePairs(const Points& ends);
}

#endif
