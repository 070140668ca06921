// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Plane geometry of unfolding, shared by all window code: the position of the apex of a triangle,
/// the transfer of images and intervals to the next edge, ties between windows.
///
/// The frame of a half-edge h: Origin(h) is (0,0), Destination(h) is (Length(h),0), the face of h
/// lies in y > 0 and the image of the source in y < 0.
#ifndef dggUnfolding_h
#define dggUnfolding_h

#include <algorithm> // for std::max
#include <cmath>     // for std::sqrt
#include <utility>   // for std::swap

namespace dgg
{
struct Point2
{
  double X = 0.0;
  double Y = 0.0;
};

inline double Norm(double x, double y)
{
  return std::sqrt(x * x + y * y);
}

inline double Dot(const Point2& a, const Point2& b)
{
  return a.X * b.X + a.Y * b.Y;
}

/// Returns the cross product, which is positive if b lies to the left of a.
inline double Cross(const Point2& a, const Point2& b)
{
  return a.X * b.Y - a.Y * b.X;
}

/// Returns the vector from b to a.
inline Point2 Difference(const Point2& a, const Point2& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

inline double Distance(const Point2& a, const Point2& b)
{
  return Norm(a.X - b.X, a.Y - b.Y);
}

/// Returns a point converted from the frame with the given origin and x axis (unit vector).
inline Point2 FromFrame(const Point2& origin, const Point2& axis, const Point2& p)
{
  return { origin.X + p.X * axis.X - p.Y * axis.Y, origin.Y + p.X * axis.Y + p.Y * axis.X };
}

/// Returns a direction converted from the frame with the given x axis (unit vector).
inline Point2 Turned(const Point2& axis, const Point2& direction)
{
  return { direction.X * axis.X - direction.Y * axis.Y,
    direction.X * axis.Y + direction.Y * axis.X };
}

/// Returns the area of a triangle from its edge lengths, accurate for slivers (Kahan,
/// "Miscalculating area and angles of a needle-like triangle", 2014).
inline double TriangleArea(double a, double b, double c)
{
  if (a < b)
  {
    std::swap(a, b);
  }
  if (b < c)
  {
    std::swap(b, c);
  }
  if (a < b)
  {
    std::swap(a, b);
  }
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return 0.25 * std::sqrt(std::max(0.0, product));
}

/// Returns the abscissa of a point at distances `fromOrigin` and `fromEnd` from the ends of a
/// segment on the x axis. The law of cosines has equivalent forms, whose accuracy depends on the
/// shortest edge of the triangle: lengths that are close to each other must be subtracted first.
inline double FootOnEdge(double length, double fromOrigin, double fromEnd)
{
  if (fromOrigin <= fromEnd && fromOrigin <= length)
  {
    return 0.5 * (fromOrigin * fromOrigin + (length - fromEnd) * (length + fromEnd)) / length;
  }
  if (fromEnd <= length)
  {
    return length -
      0.5 * (fromEnd * fromEnd + (length - fromOrigin) * (length + fromOrigin)) / length;
  }
  return 0.5 * (length + (fromOrigin - fromEnd) * (fromOrigin + fromEnd) / length);
}

/// Returns the corner of a triangle laid out above the x axis; `fromOrigin` and `fromEnd` are its
/// distances from the ends of the segment.
inline Point2 LayOut(double length, double fromOrigin, double fromEnd)
{
  return { FootOnEdge(length, fromOrigin, fromEnd),
    2.0 * TriangleArea(length, fromOrigin, fromEnd) / length };
}

/// Returns the distance from an image to the point x on the axis.
inline double DistanceToAxis(const Point2& image, double x)
{
  return Norm(x - image.X, image.Y);
}

/// Returns the abscissa at which the segment from the image (below the axis) to `target` (above the
/// axis) crosses the axis.
inline double Crossing(const Point2& image, const Point2& target)
{
  return image.X + (target.X - image.X) * (-image.Y) / (target.Y - image.Y);
}

/// A triangle laid out above the x axis, entered through the edge on the axis. Windows continue
/// through its left edge, from the origin to the apex, or its right edge, from the apex to the end
/// of the axis. On a consistently oriented mesh, these are the directions of the half-edges that
/// are entered next.
class FaceUnfolding
{
public:
  FaceUnfolding(double base, const Point2& apex, double left, double right)
    : Base(base)
    , Left(left)
    , Right(right)
    , Apex(apex)
    , LeftCosine(apex.X / left)
    , LeftSine(apex.Y / left)
    , RightCosine(FootOnEdge(base, right, left) / right) // not base - apex.X, for needles
    , RightSine(apex.Y / right)
  {
  }

  double GetBase() const { return this->Base; }
  double GetLeft() const { return this->Left; }
  double GetRight() const { return this->Right; }
  const Point2& GetApex() const { return this->Apex; }
  /// Returns the direction of the left edge, from the origin to the apex: (cosine, sine).
  double GetLeftCosine() const { return this->LeftCosine; }
  double GetLeftSine() const { return this->LeftSine; }
  /// Returns the direction of the right edge, from the apex to the end of the axis: (cosine,
  /// -sine).
  double GetRightCosine() const { return this->RightCosine; }
  double GetRightSine() const { return this->RightSine; }

  /// Returns the image in the frame of the left edge.
  Point2 ImageInLeft(const Point2& image) const
  {
    return { this->LeftCosine * image.X + this->LeftSine * image.Y,
      this->LeftCosine * image.Y - this->LeftSine * image.X };
  }

  /// Returns the image in the frame of the right edge.
  Point2 ImageInRight(const Point2& image) const
  {
    const double x = this->Base - image.X; // mirrored: the edge leaves the axis at its end
    return { this->Right - (this->RightCosine * x + this->RightSine * image.Y),
      this->RightCosine * image.Y - this->RightSine * x };
  }

  /// Returns the position, measured from the origin, at which the ray from the image through x on
  /// the axis meets the left edge. `depth` is the distance of the image below the left edge, minus
  /// the Y of ImageInLeft().
  double OnLeft(const Point2& image, double depth, double x) const
  {
    return Meet(x, -image.Y, depth, this->LeftSine, this->Left);
  }

  /// Returns the position, measured from the apex, at which the ray from the image through x on the
  /// axis meets the right edge.
  double OnRight(const Point2& image, double depth, double x) const
  {
    return this->Right - Meet(this->Base - x, -image.Y, depth, this->RightSine, this->Right);
  }

private:
  /// Returns, by similar triangles, the distance from the corner on the axis at which a ray meets
  /// the edge. The ray passes the axis at the distance `x` from this corner. The result is clamped
  /// to the apex if the ray misses the edge.
  static double Meet(double x, double height, double depth, double sine, double length)
  {
    const double denominator = depth - sine * x;
    const double numerator = x * height;
    return numerator < length * denominator ? (std::max)(0.0, numerator / denominator) : length;
  }

  double Base;
  double Left;
  double Right;
  Point2 Apex;
  double LeftCosine;
  double LeftSine;
  double RightCosine;
  double RightSine;
};
}

#endif
