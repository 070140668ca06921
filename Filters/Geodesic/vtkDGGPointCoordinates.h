// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points as flat doubles. Internal.
#ifndef vtkDGGPointCoordinates_h
#define vtkDGGPointCoordinates_h

#include "dggTypes.h" // for Status

#include "vtkType.h" // for vtkIdType

#include <vector> // for the copy

class vtkPoints;

/// x y z per point as doubles: a view of the points when they are stored like that, a copy if not.
/// The points must outlive it.
class vtkDGGPointCoordinates
{
public:
  /// `points` may be null.
  explicit vtkDGGPointCoordinates(vtkPoints* points);
  vtkDGGPointCoordinates(const vtkDGGPointCoordinates&) = delete;
  vtkDGGPointCoordinates& operator=(const vtkDGGPointCoordinates&) = delete;

  const double* GetData() const { return this->Data; }

private:
  std::vector<double> Copy;
  const double* Data = nullptr;
};

/// The points of a surface, copied before the first report of progress: observers may change those
/// of the input. Fails when there are not as many as the mesh has vertices.
dgg::Status vtkDGGCopyPoints(vtkPoints* points, vtkIdType numberOfVertices, vtkPoints* copy);

#endif
// VTK-HeaderTest-Exclude: vtkDGGPointCoordinates.h
