// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A window: an interval of an edge that is reached from one pseudo-source in one unfolding.
#ifndef dggWindow_h
#define dggWindow_h

#include "dggTypes.h"     // for Id
#include "dggUnfolding.h" // for Point2

#include <algorithm> // for std::min

namespace dgg
{
/// Relative tolerance within which two path lengths are equal.
constexpr double LengthTolerance = 1e-12;
/// Windows narrower than this are discarded; relative, see Window::Tolerance().
constexpr double IntervalTolerance = 1e-10;
/// A point this close to an end of a window counts as visible, by the path through that end;
/// relative, see Window::Tolerance(). Thus no point on the seam between two windows is missed:
/// lengths are compared to LengthTolerance, so the tie point is only accurate to its square root.
constexpr double SeenTolerance = 2e-6;
/// An image beside the window that is closer to the axis than this, relative to the edge length,
/// sees the edge edge-on and reaches nothing.
constexpr double EdgeOnTolerance = 1e-14;

/// Rounding error of a position on an edge, relative to the edge length (some ulps).
constexpr double PositionRounding = 4e-15;

/// A bundle of paths that enter the face of a half-edge, in the frame of that half-edge
/// (dggUnfolding.h). The window stores the image of the pseudo-source rather than two end
/// distances, because the image remains accurate when it is nearly collinear with the edge. The
/// distances at the ends are cached.
struct Window
{
  double Begin = 0.0; ///< 0 <= Begin < End <= length of the half-edge
  double End = 0.0;
  Point2 Image;       ///< unfolded position of the pseudo-source, Y < 0
  double Sigma = 0.0; ///< distance of the pseudo-source, including the initial distance
  double DistanceAtBegin = 0.0;
  double DistanceAtEnd = 0.0;
  Id Root = NoId; ///< the pseudo-source: a vertex, or ~k for source k inside a face or an edge
  /// True if an ancestor passed a non-manifold edge or a degenerate face.
  bool HasScattered = false;
  bool IsKnown = false; ///< already recorded in WindowMemory

  /// Returns the distance at a point of the axis.
  double DistanceAt(double x) const { return this->Sigma + DistanceToAxis(this->Image, x); }

  /// Returns the distance at a point above the axis, along a straight line.
  double DistanceTo(const Point2& p) const
  {
    return this->Sigma + Norm(p.X - this->Image.X, p.Y - this->Image.Y);
  }

  /// Returns the distance at a point that is seen through x on the axis. If x lies beyond an end of
  /// the window, the path bends at that end: the straight line may be shorter than any path, and a
  /// label that is too small would trim nearby windows.
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

  /// Returns the smallest distance on the interval.
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

  /// Returns the tolerance for interval widths on an edge of the given length. The relevant measure
  /// is the visual angle: close to its image, a window that is narrow for its edge may reach half
  /// of the surface. The rounding error of positions on the edge is the lower limit. Windows that
  /// have scattered may start arbitrarily close to their image, since degenerate faces are
  /// arbitrarily narrow, and in any number of slivers; for these the edge length is used.
  double Tolerance(double relative, double length) const
  {
    const double scale = this->HasScattered ? length : std::min(length, -this->Image.Y);
    return std::max(1e-15 * length, relative * scale);
  }

  /// Returns true if the window is too narrow to be stored on an edge of the given length.
  bool IsTooNarrow(double length) const
  {
    return this->End - this->Begin < this->Tolerance(IntervalTolerance, length);
  }

  /// Returns false if the image sees the edge edge-on. An image inside the interval never does,
  /// however close: after degenerate faces it lies on the edge and reaches everything behind the
  /// edge. Such an image is moved off the edge to the near side.
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
