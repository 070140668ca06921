// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFunnel.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// A path this close to a vertex, as an angle, touches it.
constexpr double TouchAngle = 1e-13;

/// Whether the shortest path from a to c bends around b, or at least touches it, b being on the
/// given side of the strip. Vertices that are only touched count: the other side of them may be
/// shorter.
bool BendsAround(const Point2& a, const Point2& b, const Point2& c, int side)
{
  const Point2 in = Difference(b, a);
  const Point2 out = Difference(c, b);
  const double turn = side == StripUnfolding::Left ? Cross(in, out) : -Cross(in, out);
  const double product = Dot(in, in) * Dot(out, out);
  return turn * turn <= TouchAngle * TouchAngle * product ? Dot(in, out) > 0.0 : turn > 0.0;
}
}

double Funnel::Run(const StripUnfolding& strip, std::vector<StripBend>& bends)
{
  const std::size_t count = strip.Portals.size();
  this->Nodes.clear();
  this->Deque.resize(2 * count + 5);
  this->First = this->Apex = this->Last = count + 2;
  this->Nodes.push_back({ { 0, StripUnfolding::Left, strip.Start }, 0 });
  this->Deque[this->Apex] = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const int side : { StripUnfolding::Left, StripUnfolding::Right })
    {
      const Portal& portal = strip.Portals[i];
      if (i == 0 || portal.Vertices[side] != strip.Portals[i - 1].Vertices[side])
      {
        this->Attach(side, { i, side, portal.Ends[side] });
      }
    }
  }
  std::size_t node = this->Attach(StripUnfolding::Left, { count, StripUnfolding::Left, strip.End });
  bends.clear();
  double length = 0.0;
  while (node != 0)
  {
    const std::size_t parent = this->Nodes[node].Parent;
    length += Distance(this->Nodes[node].Bend.Position, this->Nodes[parent].Bend.Position);
    if (parent != 0)
    {
      bends.push_back(this->Nodes[parent].Bend);
    }
    node = parent;
  }
  std::reverse(bends.begin(), bends.end());
  return length;
}

/// The next point on one side of the strip: the chain on that side is shortened as far as it is not
/// needed any more to get around, and beyond the apex, where the point hides behind the other
/// chain, the way to it bends around that.
std::size_t Funnel::Attach(int side, const StripBend& point)
{
  const bool isLeft = side == StripUnfolding::Left;
  const auto inwards = [isLeft](std::size_t place) { return isLeft ? place + 1 : place - 1; };
  std::size_t& end = this->End(side);
  const std::size_t otherEnd = this->End(1 - side);
  while (end != this->Apex &&
    !BendsAround(this->Position(inwards(end)), this->Position(end), point.Position, side))
  {
    end = inwards(end);
  }
  if (end == this->Apex)
  {
    while (end != otherEnd &&
      BendsAround(this->Position(end), this->Position(inwards(end)), point.Position, 1 - side))
    {
      end = inwards(end);
    }
    this->Apex = end;
  }
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ point, this->Deque[end] });
  end = isLeft ? end - 1 : end + 1;
  this->Deque[end] = node;
  return node;
}
}
