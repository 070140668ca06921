// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A window of straight lines from one source over the unfolded faces. Internal.
#ifndef dggGraphWindow_h
#define dggGraphWindow_h

#include "dggTypes.h"          // for Id
#include "dggUnfolding.h"      // for Point2
#include "dggUnfoldingTable.h" // for FaceCrossing

#include <cmath> // for std::abs

namespace dgg
{
/// A vertex through which a bounding ray of a window passes. The straight segment from the relay to
/// any point of the window behind the relay lies in the faces that the window has swept, so that
/// the segment is a path on the surface.
struct Relay
{
  Point2 Position;
  Point2 Unit;           ///< direction from the source
  double Distance = 0.0; ///< straight-line distance from the source
  double Cost = 0.0;     ///< cost of the path from the source, defined by the rule
  double Ratio = 0.0;    ///< Ratio and Weight: auxiliary values of the rule
  double Weight = 0.0;

  Relay(const Point2& position, double distance, double cost)
    : Position(position)
    , Unit{ position.X / distance, position.Y / distance }
    , Distance(distance)
    , Cost(cost)
  {
  }
};

/// A bundle of straight lines from the source, unfolded into the plane of the face through which
/// they left; the source is the origin of the plane. A window is cut at vertices only, so that each
/// of its bounding rays passes through a vertex.
struct GraphWindow
{
  /// The next edge to cross: Ends[0] is on the left as seen from the source, Ends[1] on the right.
  Point2 Ends[2];
  Point2 Axis; ///< unit vector from left to right
  Point2 Stop; ///< stop point, if the rule uses one
  /// Labels of the ends, if shorter than the straight line, otherwise Infinity. A path through an
  /// end can be shorter than the straight line only if its label is.
  double Labels[2] = { Infinity, Infinity };
  Id Relays[2] = { NoId, NoId }; ///< on the left and the right bounding ray
  /// A relay farther out on the same side that covers the relay on the ray, and is better at every
  /// point that the relay on the ray does not occlude; otherwise NoId.
  Id Outer[2] = { NoId, NoId };
  const FaceCrossing* Face = nullptr; ///< crossing of the face behind the edge
  Id Frame = NoId;                    ///< half-edge at the source along the x axis of the plane
  Id Number = NoId;                   ///< id in GraphWindowMemory, if in use
};

/// Returns the intersection of the ray through a point with the line of the window's edge.
inline Point2 MeetEdge(const GraphWindow& window, const Point2& ray)
{
  const double t = Cross(window.Ends[0], ray) / Cross(ray, window.Axis);
  return { window.Ends[0].X + t * window.Axis.X, window.Ends[0].Y + t * window.Axis.Y };
}

/// Returns the distance from the source to the interval of the edge that a window reaches.
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
