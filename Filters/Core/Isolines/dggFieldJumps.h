// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Discontinuities of the gradient: points at which the direction to the source jumps. Internal.
#ifndef dggFieldJumps_h
#define dggFieldJumps_h

#include "dggDistanceField.h" // for FieldSample
#include "dggFaceEnvelope.h"  // for FaceEnvelope

#include <vector> // for the jumps

namespace dgg
{
/// A point between two samples with different gradients.
struct FieldJump
{
  Point2 Place;
  FieldSample Before;
  FieldSample After;
};

/// Returns the angle between two gradients, in [0, pi].
double AngleBetween(const FieldSample& a, const FieldSample& b);

/// Returns true if two samples belong to the same source, up to rounding; `length` is an edge
/// length.
bool HaveOneSource(const FieldSample& a, const FieldSample& b, double length);

/// Returns the distance of a point from the source of a sample.
double DistanceFromSource(const FieldSample& sample, const Point2& p);

/// Moves a point along a unit direction, by at most `limit`, to the position at which its distances
/// from both sources are equal. Returns false if no such position exists, or if the sources are
/// unknown.
bool MoveToTie(
  const FieldSample& a, const FieldSample& b, const Point2& direction, double limit, Point2& p);

/// Moves a point to the position at which its distances from three sources are equal. Returns false
/// if no such position is found.
bool MoveToTie(const FieldSample& a, const FieldSample& b, const FieldSample& c, Point2& p);

/// Finds jumps along segments in a face: of the gradient, or from one nearest source to another.
class FieldJumpFinder
{
public:
  /// Prepares the search in a face. `angle` is the smallest jump of the gradient that is detected,
  /// in radians. If `betweenSources` is true, the jumps are changes of FieldSample::Source instead,
  /// without slits: windows that are too narrow are not stored (dggEdgeWindows.h).
  FieldJumpFinder(const FaceEnvelope& envelope, double angle, bool betweenSources = false)
    : Envelope(envelope)
    , Angle(angle)
    , BetweenSources(betweenSources)
  {
  }

  /// Resets the sample budget; must be called for each face. The budget is needed because with very
  /// large coordinates the gradient is dominated by rounding, and the search would find jumps
  /// everywhere.
  void Restart() const { this->SamplesLeft = MostSamples; }
  /// Returns true if the sample budget was exhausted, so that jumps may be missing.
  bool IsExhausted() const { return this->SamplesLeft <= 0; }

  /// Appends the jumps on the segment from p to q. Jumps are detected between `count` + 1 samples
  /// and bisected to `width`, a fraction of the segment. Only converging gradients count, because a
  /// source lies between diverging gradients.
  void Find(
    const Point2& p, const Point2& q, int count, double width, std::vector<FieldJump>& jumps) const;
  /// The same with samples at p, q and `places` between them, increasing fractions of the segment.
  void Find(const Point2& p, const Point2& q, const std::vector<double>& places, double width,
    std::vector<FieldJump>& jumps) const;

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

  bool MayJump(const FieldSample& a, const FieldSample& b, double length) const;
  bool IsJump(const Way& way, const FieldSample& before, const FieldSample& after) const;
  void RemoveSlits(const Way& way, std::size_t first) const;
  void Search(const Way& way, double begin, const FieldSample& atBegin, double end,
    const FieldSample& atEnd) const;
  bool SearchTie(const Way& way, double begin, const FieldSample& atBegin, double end,
    const FieldSample& atEnd) const;
  void Add(const Way& way, double t, const FieldSample& before, const FieldSample& after) const;

  /// Sample budget: a jump takes about 40 samples, a face with ridges about a thousand.
  static constexpr int MostSamples = 20000;

  const FaceEnvelope& Envelope;
  const double Angle;
  const bool BetweenSources;
  mutable int SamplesLeft = MostSamples;
};
}

#endif
