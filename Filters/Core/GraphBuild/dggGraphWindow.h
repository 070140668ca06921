// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A window of straight lines from one source, on its way over the unfolded faces. Internal.
#ifndef dggGraphWindow_h
#define dggGraphWindow_h

#include "dggTypes.h"     // for Id
#include "dggUnfolding.h" // for Point2

#include <cmath> // for std::abs

namespace dgg
{
/// A vertex through which a bounding ray of a window passes. The straight segment from it to any
/// point of the window behind it lies in the faces that the window has swept, so that it is a path
/// on the surface.
struct Relay
{
  Point2 Position;
  Point2 Unit;           ///< its direction
  double Distance = 0.0; ///< from the source, straight
  double Cost = 0.0;     ///< what the rule in use makes of the way from the source
  double Ratio = 0.0;    ///< what else it needs to know
  double Weight = 0.0;

  Relay(const Point2& position, double distance, double cost)
    : Position(position)
    , Unit{ position.X / distance, position.Y / distance }
    , Distance(distance)
    , Cost(cost)
  {
  }
};

/// Straight lines from the source, unfolded into the plane of the face that it left through: the
/// source is the origin of the plane. Only straight lines: a window ends at vertices and is never
/// cut elsewhere, so each of its bounding rays passes through a vertex.
struct GraphWindow
{
  /// The edge that it is about to cross, from Ends[0] on the left, seen from the source, to
  /// Ends[1].
  Point2 Ends[2];
  Point2 Axis; ///< unit vector from left to right
  Point2 Stop; ///< where the window ends, if the rule in use needs a point for that
  /// Labels of the ends where they are shorter than the straight line: only then can the way
  /// through them be shorter than the straight line. Else Infinity.
  double Labels[2] = { Infinity, Infinity };
  Id Relays[2] = { NoId, NoId }; ///< on the left and the right bounding ray
  /// A relay farther out on that side that covers the one on the ray, and is better wherever the
  /// latter does not hide the source from it; else NoId.
  Id Outer[2] = { NoId, NoId };
  Id Entry = NoId;  ///< crossing of the face behind the edge
  Id Frame = NoId;  ///< half-edge at the source along the x axis of the plane
  Id Number = NoId; ///< in the memory of windows, where there is one
};

/// Where the ray through a point meets the edge of a window.
inline Point2 MeetEdge(const GraphWindow& window, const Point2& ray)
{
  const double t = Cross(window.Ends[0], ray) / Cross(ray, window.Axis);
  return { window.Ends[0].X + t * window.Axis.X, window.Ends[0].Y + t * window.Axis.Y };
}

/// Distance from the source to the part of its edge that a window reaches.
inline double DistanceOfEdge(const Relay& left, const Relay& right, const GraphWindow& window)
{
  const Point2 l = MeetEdge(window, left.Position);
  const Point2 r = MeetEdge(window, right.Position);
  const double fromLeft = Dot(l, window.Axis);
  const double fromRight = Dot(r, window.Axis);
  if (fromLeft < 0.0 && fromRight > 0.0)
  {
    return std::abs(Cross(window.Ends[0], window.Axis));
  }
  return fromLeft >= 0.0 ? Norm(l.X, l.Y) : Norm(r.X, r.Y);
}
}

#endif
