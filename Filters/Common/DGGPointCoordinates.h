// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points as flat doubles. Internal.
#ifndef DGGPointCoordinates_h
#define DGGPointCoordinates_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include <vector>                      // for the copy

class vtkPoints;

/// x y z per point as doubles: a view of the points when they are stored like that, a copy if not.
/// The points must outlive it.
class VTKDGGFILTERSCOMMON_EXPORT DGGPointCoordinates
{
public:
  /// `points` may be null.
  explicit DGGPointCoordinates(vtkPoints* points);
  DGGPointCoordinates(const DGGPointCoordinates&) = delete;
  DGGPointCoordinates& operator=(const DGGPointCoordinates&) = delete;

  const double* GetData() const { return this->Data; }

private:
  std::vector<double> Copy;
  const double* Data = nullptr;
};

#endif
