// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A window: an interval of an edge that one source reaches in one unfolding.
#ifndef dggWindow_h
#define dggWindow_h

#include "dggTypes.h"     // for Id
#include "dggUnfolding.h" // for Point2

#include <algorithm> // for std::min

namespace dgg
{
/// Two path lengths this close, relatively, count as equal.
constexpr double LengthTolerance = 1e-12;
/// Intervals narrower than this are dropped; relative, see Window::Tolerance().
constexpr double IntervalTolerance = 1e-10;
/// A point this close to an end of a window counts as seen, by the way through that end; relative,
/// see Window::Tolerance(). So no point on the seam between two windows is missed: lengths are
/// compared to LengthTolerance, so the place where they are equal is known to the root of that.
constexpr double SeenTolerance = 2e-6;
/// An image closer to the axis than this, relative to its edge, and beside the window sees the edge
/// edge-on and reaches nothing.
constexpr double EdgeOnTolerance = 1e-14;

/// Some roundings of a position on an edge, relative to the edge.
constexpr double PositionRounding = 4e-15;

/// Paths on their way into the face of a half-edge, in the frame of that half-edge
/// (dggUnfolding.h). The image of the pseudo-source is kept rather than two end distances: it is
/// accurate when the image is nearly in line with the edge. The distances at the ends are a cache.
struct Window
{
  double Begin = 0.0; ///< of the interval, 0 <= Begin < End <= length of the half-edge
  double End = 0.0;
  Point2 Image;       ///< of the pseudo-source, Y < 0
  double Sigma = 0.0; ///< distance at the pseudo-source, initial distance included
  double DistanceAtBegin = 0.0;
  double DistanceAtEnd = 0.0;
  Id Root = NoId; ///< the pseudo-source: a vertex, or ~k for source k inside a face or an edge
  /// Has gone through an edge with more than two faces, or a face without area.
  bool HasScattered = false;
  bool IsKnown = false; ///< has passed here before (WindowMemory)

  /// Distance at a point of the axis.
  double DistanceAt(double x) const { return this->Sigma + DistanceToAxis(this->Image, x); }

  /// Distance at a point above the axis, along a straight line.
  double DistanceTo(const Point2& p) const
  {
    return this->Sigma + Norm(p.X - this->Image.X, p.Y - this->Image.Y);
  }

  /// The same for a point that is seen through x on the axis. When that is beyond an end of the
  /// window, the way bends there: a straight line may be shorter than any path, and such a label
  /// would trim windows that pass close by.
  double DistanceThrough(double x, const Point2& p) const
  {
    const double straight = this->DistanceTo(p);
    if (x >= this->Begin && x <= this->End)
    {
      return straight;
    }
    const double bend = x < this->Begin ? this->Begin : this->End;
    const double bent = this->DistanceAt(bend) + Norm(p.X - bend, p.Y);
    return bent <= straight * (1.0 + LengthTolerance) ? straight : bent;
  }

  /// Smallest distance on the interval.
  double MinimumDistance() const
  {
    if (this->Image.X <= this->Begin)
    {
      return this->DistanceAtBegin;
    }
    return this->Image.X >= this->End ? this->DistanceAtEnd : this->Sigma - this->Image.Y;
  }

  void SetInterval(double begin, double end)
  {
    this->Begin = begin;
    this->End = end;
    this->DistanceAtBegin = this->DistanceAt(begin);
    this->DistanceAtEnd = this->DistanceAt(end);
  }

  /// A tolerance for widths on an edge of the given length. What counts is the angle: close to its
  /// image a window that is narrow for its edge may reach half of the surface. Rounding of
  /// positions on the edge sets the floor. Windows that have scattered may come from as close by as
  /// faces without area are narrow, without meaning anything, and in any number of slivers: there
  /// the edge counts.
  double Tolerance(double relative, double length) const
  {
    const double scale = this->HasScattered ? length : std::min(length, -this->Image.Y);
    return std::max(1e-15 * length, relative * scale);
  }

  /// Whether too narrow for an edge of the given length to be kept.
  bool IsTooNarrow(double length) const
  {
    return this->End - this->Begin < this->Tolerance(IntervalTolerance, length);
  }

  /// False when the image sees the edge edge-on. An image in the window itself does not, however
  /// close: as after faces without area it is on the edge, and reaches all that is behind. Then it
  /// is put where it has a side.
  bool FacesEdge(double length)
  {
    const double closest = -EdgeOnTolerance * length;
    if (this->Image.Y <= closest)
    {
      return true;
    }
    if (!(this->Image.X > this->Begin && this->Image.X < this->End))
    {
      return false;
    }
    this->Image.Y = closest;
    this->SetInterval(this->Begin, this->End);
    return true;
  }

  bool HasSameOrigin(const Window& other) const
  {
    return this->Root == other.Root && this->Sigma == other.Sigma &&
      this->Image.X == other.Image.X && this->Image.Y == other.Image.Y;
  }
};
}

#endif
