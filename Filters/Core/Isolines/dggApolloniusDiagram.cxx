// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggApolloniusDiagram.h"

#include "dggTypes.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Relative tolerance of domination. A site is dominated if its advantage is below this fraction of
/// its distance to another site.
constexpr double DominationTolerance = 1e-9;
/// Difference below which angles are equal, radians.
constexpr double AngleTolerance = 1e-10;
/// Distance below which nodes are merged, relative to the longest side.
constexpr double MergeTolerance = 1e-8;
/// Minimum relative distance of a site from a side. Closer sites lie on the side, up to rounding.
constexpr double SmallestHeight = 1e-14;
}

void ApolloniusDiagram::Build(
  const std::array<Point2, 3>& corners, const std::vector<WeightedSite>& sites)
{
  this->Corners = corners;
  this->Sites = sites;
  this->Places.clear();
  this->Nodes.clear();
  this->Edges.clear();
  this->Scale = 0.0;
  for (int s = 0; s < 3; ++s)
  {
    const Point2 way = Difference(corners[(s + 1) % 3], corners[s]);
    this->Lengths[s] = Norm(way.X, way.Y);
    this->Axes[s] = { way.X / this->Lengths[s], way.Y / this->Lengths[s] };
    this->Scale = std::max(this->Scale, this->Lengths[s]);
  }
  for (const WeightedSite& site : sites)
  {
    this->Places.push_back(FromFrame(corners[site.Side], this->Axes[site.Side], { site.X, 0.0 }));
  }
  this->DropDominated();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (!this->IsDropped[i])
    {
      this->FollowCell(i);
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
}

void ApolloniusDiagram::DropDominated()
{
  const std::size_t n = this->Sites.size();
  this->IsDropped.assign(n, false);
  // In order of weights, a site can only be dominated by an earlier site. If the earlier site was
  // removed, the site that dominated it dominates the later site as well.
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return this->Sites[a].Weight < this->Sites[b].Weight; });
  for (std::size_t i = 1; i < n; ++i)
  {
    for (std::size_t j = 0; j < i && !this->IsDropped[order[i]]; ++j)
    {
      const double apart = Distance(this->Places[order[i]], this->Places[order[j]]);
      this->IsDropped[order[i]] = !this->IsDropped[order[j]] &&
        this->Sites[order[i]].Weight >=
          this->Sites[order[j]].Weight + (1.0 - DominationTolerance) * apart;
    }
  }
}

/// Collects the borders of a site with other sites and with the sides that do not contain it, in
/// the frame of the given axis.
void ApolloniusDiagram::CollectBorders(std::size_t i, const Point2& axis)
{
  this->Borders.clear();
  const Point2& place = this->Places[i];
  for (std::size_t j = 0; j < this->Sites.size(); ++j)
  {
    if (j == i || this->IsDropped[j])
    {
      continue;
    }
    const Point2 way = Difference(this->Places[j], place);
    const double later = this->Sites[j].Weight - this->Sites[i].Weight;
    const double apart = Norm(way.X, way.Y);
    const double factor = 2.0 / ((apart - later) * (apart + later));
    this->Borders.push_back({ { factor * Dot(axis, way), factor * Cross(axis, way) },
      factor * later, static_cast<int>(j) });
  }
  const int side = this->Sites[i].Side;
  for (int s = 0; s < 3; ++s)
  {
    if (s == side || (this->Sites[i].X <= 0.0 && s == (side + 2) % 3))
    {
      continue;
    }
    const Point2 outwards{ this->Axes[s].Y, -this->Axes[s].X };
    const double height = std::max(
      Dot(outwards, Difference(this->Corners[s], place)), SmallestHeight * this->Lengths[side]);
    this->Borders.push_back(
      { { Dot(axis, outwards) / height, Cross(axis, outwards) / height }, 0.0, ~s });
  }
}

/// Returns the nearest border in the direction of an angle, or directly after this direction.
std::size_t ApolloniusDiagram::FindOutermost(double angle) const
{
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  std::size_t best = 0;
  double bestValue = -Infinity;
  for (std::size_t b = 0; b < this->Borders.size(); ++b)
  {
    const Border& border = this->Borders[b];
    const double value = border.A.X * cosine + border.A.Y * sine - border.C;
    if (value > bestValue)
    {
      best = b;
      bestValue = value;
    }
  }
  return best;
}

/// Finds the angle at which another border becomes nearer than the current one, after `angle` and
/// not after `end`. Returns false if no border becomes nearer.
bool ApolloniusDiagram::FindNext(
  std::size_t current, double angle, double end, std::size_t& next, double& at) const
{
  at = end;
  bool isFound = false;
  const Border& from = this->Borders[current];
  for (std::size_t b = 0; b < this->Borders.size(); ++b)
  {
    if (b == current)
    {
      continue;
    }
    // The other border is nearer at angles from the middle whose cosine exceeds the ratio.
    const Border& to = this->Borders[b];
    const Point2 way = Difference(to.A, from.A);
    const double size = Norm(way.X, way.Y);
    const double lead = to.C - from.C;
    if (lead >= size)
    {
      continue;
    }
    const double half = lead <= -size ? Pi : std::acos(lead / size);
    const double middle = std::atan2(way.Y, way.X);
    double begin = std::remainder(middle - half - angle, 2.0 * Pi);
    if (begin < 0.0)
    {
      // The other border is already nearer, or becomes nearer only after a full turn, which is too
      // late.
      begin = begin + 2.0 * half > AngleTolerance ? 0.0 : begin + 2.0 * Pi;
    }
    if (angle + begin < at)
    {
      at = angle + begin;
      next = b;
      isFound = true;
    }
  }
  return isFound;
}

int ApolloniusDiagram::AddNode(const Point2& place, double distance, int side)
{
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    if (this->Nodes[n].Side == side &&
      dgg::Distance(this->Nodes[n].Place, place) <= MergeTolerance * this->Scale)
    {
      return static_cast<int>(n);
    }
  }
  ApolloniusNode node{ place, distance, side, 0.0 };
  if (side >= 0)
  {
    node.X = Dot(this->Axes[side], Difference(place, this->Corners[side]));
  }
  this->Nodes.push_back(node);
  return static_cast<int>(this->Nodes.size()) - 1;
}

void ApolloniusDiagram::FollowCell(std::size_t i)
{
  const WeightedSite& site = this->Sites[i];
  const int before = (site.Side + 2) % 3;
  const Point2& axis = this->Axes[site.Side];
  const Point2 back{ -this->Axes[before].X, -this->Axes[before].Y };
  const bool isCorner = site.X <= 0.0;
  const double span = isCorner ? std::atan2(Cross(axis, back), Dot(axis, back)) : Pi;
  this->CollectBorders(i, axis);
  if (this->Borders.empty())
  {
    return;
  }
  auto addNode = [&](const Border& border, double angle, int side) {
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const double reach = 1.0 / (border.A.X * cosine + border.A.Y * sine - border.C);
    return this->AddNode(FromFrame(this->Places[i], axis, { reach * cosine, reach * sine }),
      site.Weight + reach, side);
  };
  double angle = 0.0;
  std::size_t current = this->FindOutermost(angle);
  int node =
    this->Borders[current].Name >= 0 ? addNode(this->Borders[current], 0.0, site.Side) : -1;
  // Each pair of borders is swapped at most twice.
  for (std::size_t step = 0; step < 4 * this->Borders.size() + 4; ++step)
  {
    const Border& border = this->Borders[current];
    std::size_t next = current;
    double at = span;
    const bool goesOn = this->FindNext(current, angle, span, next, at);
    int end = -1;
    if (!goesOn)
    {
      end = border.Name >= 0 ? addNode(border, span, isCorner ? before : site.Side) : -1;
    }
    else
    {
      const int other = this->Borders[next].Name;
      if (border.Name >= 0 || other >= 0)
      {
        end = addNode(border.Name >= 0 ? border : this->Borders[next], at,
          std::max(-1, std::max(~border.Name, ~other)));
      }
    }
    if (border.Name > static_cast<int>(i) && node >= 0 && end >= 0 && node != end)
    {
      this->Edges.emplace_back(std::min(node, end), std::max(node, end));
    }
    if (!goesOn)
    {
      return;
    }
    node = end;
    current = next;
    angle = at;
  }
}
}
