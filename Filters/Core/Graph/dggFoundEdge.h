// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An edge as the light of one source finds it. Internal.
#ifndef dggFoundEdge_h
#define dggFoundEdge_h

#include "dggUnfolding.h"      // for Point2
#include "dggUnfoldingTable.h" // for polar angles

#include <cmath> // for std::atan2

namespace dgg
{
/// An edge found from a source, with what it takes to know its directions.
struct FoundEdge
{
  Id Target = NoId; ///< id of the table
  double Length = 0.0;
  Point2 Departure;  ///< the target, in the plane of the source
  Id Frame = NoId;   ///< half-edge along the x axis of the plane: leaves the source, or is one of
                     ///< the face that it lies in
  Point2 Reference;  ///< direction of the half-edge of arrival, in the plane
  Id Arrival = NoId; ///< that half-edge, leaving the target
  bool IsMirrored = false; ///< the face of arrival is seen in its mirror image

  /// Polar angle at the source, towards the target.
  double DepartureAngle(const UnfoldingTable& table) const
  {
    return table.PolarAngle(this->Frame) + std::atan2(this->Departure.Y, this->Departure.X);
  }
  /// Polar angle at the target, towards the source.
  double ArrivalAngle(const UnfoldingTable& table) const
  {
    const Point2 back{ -this->Departure.X, -this->Departure.Y };
    const double turn = std::atan2(Cross(this->Reference, back), Dot(this->Reference, back));
    return table.PolarAngle(this->Arrival) + (this->IsMirrored ? -turn : turn);
  }
};
}

#endif
