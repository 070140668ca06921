// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the direction to the source changes all at once. Internal.
#ifndef dggFieldJumps_h
#define dggFieldJumps_h

#include "dggDistanceField.h" // for FieldSample
#include "dggFaceProfile.h"   // for FaceProfile

#include <vector> // for the jumps

namespace dgg
{
/// A point between two samples of which the gradients differ.
struct FieldJump
{
  Point2 Place;
  FieldSample Before;
  FieldSample After;
};

/// The angle between two gradients, in [0, pi].
double AngleBetween(const FieldSample& a, const FieldSample& b);

/// Whether two samples belong to the same source, up to rounding; `length` is that of an edge.
bool HaveOneSource(const FieldSample& a, const FieldSample& b, double length);

/// The distance from the source of a sample to a point.
double DistanceFromSource(const FieldSample& sample, const Point2& p);

/// Move a point along a direction (of unit length), by at most `limit`, to where it is as far from
/// both sources. False when there is no such point, and when the sources are not known.
bool MoveToTie(
  const FieldSample& a, const FieldSample& b, const Point2& direction, double limit, Point2& p);

/// Move a point to where it is as far from three sources.
bool MoveToTie(const FieldSample& a, const FieldSample& b, const FieldSample& c, Point2& p);

/// Finds jumps of the gradient along segments in a face.
class FieldJumpFinder
{
public:
  /// `angle` is the smallest jump to be found.
  FieldJumpFinder(const FaceProfile& profile, double angle)
    : Profile(profile)
    , Angle(angle)
  {
  }

  /// Look at so many places only until the next call, as for a face: where numbers are so large
  /// that the gradient is rounding there would be jumps everywhere.
  void Restart() const { this->SamplesLeft = MostSamples; }
  /// Whether that has been too few, and jumps may be missing.
  bool IsExhausted() const { return this->SamplesLeft <= 0; }

  /// Append the jumps on the way from p to q, first seen in samples at `count` + 1 places and then
  /// bisected until they are found to `width`, a part of the way. The gradients point at each
  /// other: where they point apart, there is a source.
  void Find(
    const Point2& p, const Point2& q, int count, double width, std::vector<FieldJump>& jumps) const;

private:
  struct Way
  {
    Point2 From;
    Point2 To;
    double Length;
    double Width;
    std::vector<FieldJump>* Jumps;

    Point2 At(double t) const
    {
      return { (1.0 - t) * From.X + t * To.X, (1.0 - t) * From.Y + t * To.Y };
    }
  };

  void Search(const Way& way, double begin, const FieldSample& atBegin, double end,
    const FieldSample& atEnd) const;
  bool SearchTie(const Way& way, double begin, const FieldSample& atBegin, double end,
    const FieldSample& atEnd) const;
  void Add(const Way& way, double t, const FieldSample& before, const FieldSample& after) const;

  /// A jump takes some 40 of them, a face with ridges some thousand.
  static constexpr int MostSamples = 20000;

  const FaceProfile& Profile;
  const double Angle;
  mutable int SamplesLeft = MostSamples;
};
}

#endif
