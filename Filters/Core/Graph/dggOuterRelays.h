// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What relays beside the bounding rays of a cone can do for it. Internal.
#ifndef dggOuterRelays_h
#define dggOuterRelays_h

#include "dggCone.h" // for Cone

#include <vector> // for the relays

namespace dgg
{
/// Whether a point lies between the bounding rays of a cone.
inline bool IsInside(const std::vector<Relay>& relays, const Cone& cone, const Point2& x)
{
  return Cross(x, relays[cone.Relays[0]].Position) > 0.0 &&
    Cross(relays[cone.Relays[1]].Position, x) > 0.0;
}

/// Whether the outer relay on a side sees a point of the cone past the vertex on the ray.
inline bool IsVisible(const std::vector<Relay>& relays, const Cone& cone, int side, const Point2& x)
{
  const Point2& outer = relays[cone.Outer[side]].Position;
  const Point2& hiding = relays[cone.Relays[side]].Position;
  const double turn =
    Cross({ hiding.X - outer.X, hiding.Y - outer.Y }, { x.X - outer.X, x.Y - outer.Y });
  return side == 0 ? turn < 0.0 : turn > 0.0;
}

/// Work out what ends a cone, with the outer relays if they see the stop point. That is enough: an
/// outer relay covers the vertex on the ray and the stop point, so by convexity all in between; and
/// what that vertex hides from it is behind points that it covers. False when the cone has ended
/// already.
template <typename Rule>
bool StartCone(const Rule& rule, const std::vector<Relay>& relays, Cone& cone)
{
  bool outer[2] = { cone.Outer[0] != NoId, cone.Outer[1] != NoId };
  while (outer[0] || outer[1])
  {
    const Relay& left = relays[outer[0] ? cone.Outer[0] : cone.Relays[0]];
    const Relay& right = relays[outer[1] ? cone.Outer[1] : cone.Relays[1]];
    if (!rule.Start(left, right, cone) || !IsInside(relays, cone, cone.Stop))
    {
      break;
    }
    const bool hides[2] = { outer[0] && !IsVisible(relays, cone, 0, cone.Stop),
      outer[1] && !IsVisible(relays, cone, 1, cone.Stop) };
    if (!hides[0] && !hides[1])
    {
      return true;
    }
    outer[0] = outer[0] && !hides[0];
    outer[1] = outer[1] && !hides[1];
  }
  return rule.Start(relays[cone.Relays[0]], relays[cone.Relays[1]], cone);
}
}

#endif
