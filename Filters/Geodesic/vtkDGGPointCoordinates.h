// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points as flat doubles. Internal.
#ifndef vtkDGGPointCoordinates_h
#define vtkDGGPointCoordinates_h

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

#endif
// VTK-HeaderTest-Exclude: vtkDGGPointCoordinates.h
