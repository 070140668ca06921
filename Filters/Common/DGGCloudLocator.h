// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The point of a cloud that is closest to a point in space. Internal.
#ifndef DGGCloudLocator_h
#define DGGCloudLocator_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "DGGLocator.h"                // for the base class

#include "dggCloudFrame.h" // for CloudFrame

#include "vtkIdList.h"             // for the search's workspace
#include "vtkNew.h"                // for vtkNew
#include "vtkPolyData.h"           // for the located points
#include "vtkStaticPointLocator.h" // for the search

#include <vector> // for the map

/// Finds closest points of a cloud, of those that are finite. Coordinates are taken from the middle
/// of the cloud and scaled by a power of two for the search, so that any scale gives the same
/// answer, bit by bit. The few that are far off all others (dggOutliers.h) are
/// looked at one by one: in the frame of all points the others would lose their digits, and share
/// one bucket of the search.
class VTKDGGFILTERSCOMMON_EXPORT DGGCloudLocator : public DGGLocator
{
public:
  /// `positions`, x y z per point, must outlive the locator.
  DGGCloudLocator(const double* positions, dgg::Id numberOfPoints);

  /// The place as seen from the closest point of the cloud, of several the one with the smallest
  /// id, and its distance from it in the units of the points. False when there is none, or none
  /// at a distance in the range of double.
  bool FindClosestPoint(
    const double position[3], dgg::SurfacePoint& place, double& distance) override;

  /// Of the finite points, without those far off all others.
  double GetDiagonal() const override { return this->Frame.GetDiagonal(); }

  /// Places that are among the points of the cloud are close as well.
  bool IsClose(const dgg::SurfacePoint& place, double distance, double farthest) override
  {
    return distance <= farthest || distance <= this->GetReach(place);
  }

private:
  void ToLocal(const double position[3], double local[3]) const;
  double GetDistance(dgg::Id point, const double position[3]) const;
  void FindCandidates(const double position[3]);
  /// How far the nearest points of the cloud around a place are from its point. 0 when there are
  /// too few. Points far off all others have only each other around them.
  double GetReach(const dgg::SurfacePoint& place);

  const double* Positions;
  dgg::CloudFrame Frame;    // of the points that are searched
  std::vector<dgg::Id> Ids; // of the cloud, per point of Points
  std::vector<dgg::Id> Far; // of the cloud, one in each place
  std::vector<dgg::Id> Candidates;
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkStaticPointLocator> Locator;
  vtkNew<vtkIdList> Close;
};

#endif
