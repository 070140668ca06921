// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rules of the graph construction, which decide which vertices become edges and where a window
/// ends. Internal.
///
/// A rule defines
/// - the cost of an edge and of a relay (MakeRelay(), CostOfEdge(), CostBehind()), and whether a
///   vertex is covered at a given cost;
/// - Start(): computes the data that will end a window with new relays; returns false if the window
///   has already ended;
/// - Ends(): returns true if nothing behind the edge of a window needs to be explored;
/// - StartsLate: windows end between vertices, so that Start() and Ends() are only needed after a
///   face has been crossed without finding a vertex;
/// - EndsBesideCovered: if one relay covers a vertex, the window between their rays has ended;
/// - KeepsOuterRelays: a relay that covers the vertex on the bounding ray remains in use where it
///   is visible past that vertex;
/// - ByDistance: windows must be processed in order of distance.
#ifndef dggGraphRules_h
#define dggGraphRules_h

#include "dggGraphWindow.h" // for GraphWindow

#include <algorithm> // for std::min
#include <cmath>     // for std::sqrt
#include <vector>    // for relays

namespace dgg
{
/// Returns true if the window ends at its edge, because the stop point lies on the near side of the
/// edge. A relay covers the points in direction e from a certain distance on; this distance grows
/// with the angle between the relay and e. A window ends as soon as every point of its edge is
/// covered, since all points behind the edge are then covered too, through the edge. The left relay
/// covers an interval from the left end of the edge, the right relay an interval from the right
/// end. The intervals cover the entire edge iff they overlap, that is, iff the direction in which
/// both relays need the same distance is covered. This direction and distance do not depend on the
/// edge. They define a point in the plane, the stop point of the pair of relays.
inline bool HasPassedStopPoint(const GraphWindow& window)
{
  return Cross(window.Axis,
           { window.Stop.X - window.Ends[0].X, window.Stop.Y - window.Ends[0].Y }) <= 0.0;
}

/// Sets the stop point in direction e. The distance is clamped to a value that exceeds any surface.
inline void SetStopPoint(const Point2& e, double distance, GraphWindow& window)
{
  constexpr double farAway = 1e100;
  const double reach = distance < farAway ? distance : farAway;
  window.Stop = { reach * e.X, reach * e.Y };
}

/// Returns the unit vector e with w.e = k, where w.e grows from left to right. Of the two
/// solutions, the one to the left of w is returned.
inline Point2 SolveDirection(const Point2& w, double k)
{
  const double scale = 1.0 / Dot(w, w);
  const double along = k * scale;
  const double across = std::sqrt(std::max(0.0, Dot(w, w) - k * k)) * scale;
  return { along * w.X - across * w.Y, along * w.Y + across * w.X };
}

/// The progress rule. A relay p has a cost c, an upper bound of kappa w(s,r) + d(r,p), where (s,r)
/// is an edge of the graph and kappa = 1/(1 + accuracy). The relay covers x if c + |px| <= |sx|. If
/// each vertex that is visible from the source along a straight line is an edge or covered, then no
/// graph distance exceeds (1 + accuracy) times the exact distance. The proof is by induction over
/// the distances, since the path through r leaves at most D - kappa w(s,r) of the distance D: the
/// argument of Yao graphs, carried over to surfaces.
struct ProgressRule
{
  static constexpr bool StartsLate = true;
  static constexpr bool EndsBesideCovered = true;
  static constexpr bool KeepsOuterRelays = true;
  static constexpr bool ByDistance = false;

  explicit ProgressRule(double accuracy)
    : Kappa(1.0 / (1.0 + accuracy))
  {
  }

  double CostOfEdge(double length) const { return this->Kappa * length; }
  static double CostBehind(const Relay& relay, double behind) { return relay.Cost + behind; }
  static bool Covers(double cost, double distance) { return cost <= distance; }
  static Relay MakeRelay(const Point2& position, double distance, double cost)
  {
    // The straight line makes no progress, but is a valid path.
    Relay relay(position, distance, std::min(cost, distance));
    relay.Ratio = relay.Cost / distance;
    relay.Weight = (distance - relay.Cost) * (1.0 + relay.Ratio);
    return relay;
  }

  /// Computes the stop point. In direction e, at an angle of cosine u.e to its own direction u, a
  /// relay at distance d covers points from weight / (2 (u.e - ratio)) on, if this value is
  /// positive, where ratio = c/d and weight = (d^2 - c^2) / d. In its own direction the relay
  /// covers points from (d + c) / 2 on, also if c = d.
  static bool Start(const Relay& left, const Relay& right, GraphWindow& window)
  {
    // If one relay covers, in the direction of the other relay, every point that the other relay
    // covers in this direction, then the first relay also covers every point in between: the window
    // has ended.
    const double cosine = Dot(left.Unit, right.Unit);
    const double rightAtLeft = cosine - right.Ratio;
    const double leftAtRight = cosine - left.Ratio;
    if ((left.Distance + left.Cost) * rightAtLeft >= right.Weight ||
      (right.Distance + right.Cost) * leftAtRight >= left.Weight)
    {
      return false;
    }
    // Both relays need the same distance where w.e = k.
    const Point2 w{ left.Weight * right.Unit.X - right.Weight * left.Unit.X,
      left.Weight * right.Unit.Y - right.Weight * left.Unit.Y };
    const double k = left.Weight * right.Ratio - right.Weight * left.Ratio;
    const Point2 e = SolveDirection(w, k);
    const double l = Dot(left.Unit, e) - left.Ratio;
    const double r = Dot(right.Unit, e) - right.Ratio;
    if (l > 0.0 && r > 0.0)
    {
      // If the two distances differ by rounding, the larger one is safe.
      const bool byLeft = left.Weight * r >= right.Weight * l;
      SetStopPoint(e, byLeft ? 0.5 * left.Weight / l : 0.5 * right.Weight / r, window);
    }
    else if (left.Ratio > right.Ratio)
    {
      // The left relay covers only points straight behind it; the right relay has to cover the
      // remaining points.
      SetStopPoint(
        left.Unit, rightAtLeft > 0.0 ? 0.5 * right.Weight / rightAtLeft : Infinity, window);
    }
    else
    {
      SetStopPoint(
        right.Unit, leftAtRight > 0.0 ? 0.5 * left.Weight / leftAtRight : Infinity, window);
    }
    return true;
  }
  static bool Ends(const Relay& /*left*/, const Relay& /*right*/, GraphWindow& window)
  {
    return HasPassedStopPoint(window);
  }

  double Kappa;
};

/// The published direct rule (Fang, "Discrete geodesic graphs", 2019, sec. 5.1, as far as specified
/// in the paper). A relay p covers x if |sp| + |px| <= (1 + accuracy) |sx|, whether p is an edge or
/// is itself covered. Errors accumulate from relay to relay, so that the maximum error is
/// unbounded.
struct OneRelayRule
{
  static constexpr bool StartsLate = true;
  static constexpr bool EndsBesideCovered = true;
  static constexpr bool KeepsOuterRelays = false;
  static constexpr bool ByDistance = false;

  explicit OneRelayRule(double accuracy)
    : Stretch(1.0 + accuracy)
    , Scale(2.0 / (accuracy * (2.0 + accuracy)))
  {
  }

  static double CostOfEdge(double length) { return length; }
  static double CostBehind(const Relay& relay, double behind) { return relay.Distance + behind; }
  bool Covers(double cost, double distance) const { return cost <= this->Stretch * distance; }
  static Relay MakeRelay(const Point2& position, double distance, double /*cost*/)
  {
    return { position, distance, distance };
  }

  /// Computes the stop point. In direction e, a relay at distance d covers points from 2 ((1+a) d -
  /// p.e) / (a (2+a)) on.
  bool Start(const Relay& left, const Relay& right, GraphWindow& window) const
  {
    const Point2& l = left.Position;
    const Point2& r = right.Position;
    const Point2 w{ r.X - l.X, r.Y - l.Y };
    const double k = this->Stretch * (right.Distance - left.Distance);
    if (Dot(w, l) >= k * left.Distance || Dot(w, r) <= k * right.Distance)
    {
      return false;
    }
    const Point2 e = SolveDirection(w, k);
    SetStopPoint(e,
      this->Scale *
        std::max(
          this->Stretch * left.Distance - Dot(l, e), this->Stretch * right.Distance - Dot(r, e)),
      window);
    return true;
  }
  static bool Ends(const Relay& /*left*/, const Relay& /*right*/, GraphWindow& window)
  {
    return HasPassedStopPoint(window);
  }

  double Stretch;
  double Scale;
};

/// Base of the rules in which relays do not cover points: all vertices reached are candidates.
struct AllReachedRule
{
  static constexpr bool StartsLate = false;
  static constexpr bool EndsBesideCovered = false;
  static constexpr bool KeepsOuterRelays = false;

  static double CostOfEdge(double length) { return length; }
  static double CostBehind(const Relay& /*relay*/, double /*behind*/) { return Infinity; }
  static bool Covers(double /*cost*/, double /*distance*/) { return false; }
  static Relay MakeRelay(const Point2& position, double distance, double cost)
  {
    return { position, distance, cost };
  }
  static bool Start(const Relay& /*left*/, const Relay& /*right*/, GraphWindow& /*window*/)
  {
    return true;
  }
};

/// The first step of the published indirect construction (Fang 2019, sec. 3.2): every vertex
/// reached is a candidate. A window ends beyond a bound on the distance. Beyond this bound, a path
/// through an edge that the window has crossed can be deflected through an end of the edge at a
/// relative cost of at most the accuracy.
///
/// With pruning by progress, each candidate t of s is an edge or covered, as the theorem of the
/// progress rule requires. Points beyond the windows are not covered by the theorem. For a point t
/// beyond the windows, the bound gives |sv| + |vt| <= (1 + accuracy) |st| for an end v, in the
/// plane and regardless of obstacles. The theorem requires an edge (s,r) that is kept in the graph,
/// with kappa w(s,r) + d(r,t) <= d(s,t). If v is kept, v is such an r from a certain distance on.
/// But v may be pruned: then some r is kept with kappa w(s,r) + w(r,v) = c <= w(s,v), and c may be
/// as large as w(s,v). The path through v then gives c + d(v,t), which is at most d(s,t) only if t
/// is straight behind v. Hence, as long as the kept candidates are unknown, no finite distance
/// exists beyond which the ends of an edge cover every point. The maximum error is not strictly
/// bounded, though no graph has been observed to exceed the accuracy.
struct CandidateRule : AllReachedRule
{
  static constexpr bool ByDistance = false;

  explicit CandidateRule(double accuracy)
    : Accuracy(accuracy)
  {
  }

  /// Returns true if the edge is beyond the bound. The bound is inherited and tightened from edge
  /// to edge; Stop.X stores its inverse.
  bool Ends(const Relay& left, const Relay& right, GraphWindow& window) const
  {
    const double length = Distance(window.Ends[0], window.Ends[1]);
    const double a = Norm(window.Ends[0].X, window.Ends[0].Y);
    const double b = Norm(window.Ends[1].X, window.Ends[1].Y);
    const double near = std::min(a, b) - 0.5 * length;
    if (near > 0.0)
    {
      const double bound =
        length * length / (8.0 * this->Accuracy * near) + 0.5 * length + std::max(a, b);
      window.Stop.X = std::max(window.Stop.X, 1.0 / bound);
    }
    return DistanceOfEdge(left, right, window) * window.Stop.X > 1.0;
  }

  double Accuracy;
};

/// The saddle vertex graph (Ying, Wang and He, "Saddle vertex graph (SVG): a novel solution to the
/// discrete geodesic problem", 2013). Edges lead to the vertices among the K nearest ones that are
/// reached by a straight line. The search ends when K vertices are final.
struct NearestRule : AllReachedRule
{
  static constexpr bool ByDistance = true;

  explicit NearestRule(Id count)
    : Count(count)
  {
  }

  static bool Ends(const Relay& /*left*/, const Relay& /*right*/, GraphWindow& /*window*/)
  {
    return false;
  }

  Id Count;
};

/// Returns true if a point lies between the bounding rays of a window.
inline bool IsInside(const std::vector<Relay>& relays, const GraphWindow& window, const Point2& x)
{
  return Cross(x, relays[window.Relays[0]].Position) > 0.0 &&
    Cross(relays[window.Relays[1]].Position, x) > 0.0;
}

/// Returns true if a window between an apex and a relay is too narrow. Up to the square of the
/// limit, the points that such windows reach are on the border of neighboring windows.
inline bool IsNarrow(const Point2& apex, double distance, const Relay& relay)
{
  constexpr double narrowest = 1e-12; // sine of the angle, also small for a window of nearly pi
  return std::abs(Cross(apex, relay.Unit)) <= narrowest * distance && Dot(apex, relay.Unit) > 0.0;
}

/// Returns true if a point of the window is visible from the outer relay on a side, past the vertex
/// on the bounding ray.
inline bool IsVisible(
  const std::vector<Relay>& relays, const GraphWindow& window, int side, const Point2& x)
{
  const Point2& outer = relays[window.Outer[side]].Position;
  const Point2& hiding = relays[window.Relays[side]].Position;
  const double turn =
    Cross({ hiding.X - outer.X, hiding.Y - outer.Y }, { x.X - outer.X, x.Y - outer.Y });
  return side == 0 ? turn < 0.0 : turn > 0.0;
}

/// Computes the stop data of a window, using the outer relays if the stop point is visible from
/// them. Outer relays suffice in this case: an outer relay covers the vertex on the ray and the
/// stop point, hence by convexity every point in between; and points that the vertex hides from the
/// outer relay are behind points that the outer relay covers. Returns false if the window has
/// already ended.
template <typename Rule>
bool StartWindow(const Rule& rule, const std::vector<Relay>& relays, GraphWindow& window)
{
  bool outer[2] = { window.Outer[0] != NoId, window.Outer[1] != NoId };
  while (outer[0] || outer[1])
  {
    const Relay& left = relays[outer[0] ? window.Outer[0] : window.Relays[0]];
    const Relay& right = relays[outer[1] ? window.Outer[1] : window.Relays[1]];
    if (!rule.Start(left, right, window) || !IsInside(relays, window, window.Stop))
    {
      break;
    }
    const bool hides[2] = { outer[0] && !IsVisible(relays, window, 0, window.Stop),
      outer[1] && !IsVisible(relays, window, 1, window.Stop) };
    if (!hides[0] && !hides[1])
    {
      return true;
    }
    outer[0] = outer[0] && !hides[0];
    outer[1] = outer[1] && !hides[1];
  }
  return rule.Start(relays[window.Relays[0]], relays[window.Relays[1]], window);
}
}

#endif
