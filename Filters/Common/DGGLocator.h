// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The place of a surface or a cloud that is closest to a point in space. Internal.
#ifndef DGGLocator_h
#define DGGLocator_h

#include "dggSurfacePoint.h" // for SurfacePoint

#include <mutex> // for threads

/// Finds closest places. Searches share a workspace: threads take turns, by the mutex.
class DGGLocator
{
public:
  virtual ~DGGLocator() = default;

  /// The closest place, and its distance in the units of the points. False when there is none.
  virtual bool FindClosestPoint(
    const double position[3], dgg::SurfacePoint& place, double& distance) = 0;

  /// Diagonal of the bounding box.
  virtual double GetDiagonal() const = 0;

  /// Whether a point that far away from its closest place is treated as one of the surface, as are
  /// all that are no farther away than `farthest`.
  virtual bool IsClose(const dgg::SurfacePoint& place, double distance, double farthest) = 0;

  std::mutex& GetMutex() { return this->Mutex; }

private:
  std::mutex Mutex;
};

#endif
