// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The shape of one isoline inside one face. Internal.
#ifndef dggLevelArc_h
#define dggLevelArc_h

#include "dggFaceEnvelope.h" // for FaceEnvelope

#include <vector> // for the points

namespace dgg
{
/// A point of an isoline, with the field at the point. At a corner of the isoline there are two
/// such points, with the field on either side.
struct LevelPoint
{
  Point2 Place;
  FieldSample Sample;
  bool IsOnLevel = false; ///< true if at the level, up to rounding
};

/// Refines an isoline until it approximates the level set within the tolerance. Level sets are
/// circular arcs around images of sources, which meet in corners; arcs and corners are computed
/// exactly. If the field is merely smooth, points are found by Newton's method.
///
/// Isolines have the lower distance on their left, so that they turn left around sources.
class LevelArc
{
public:
  /// Prepares refinement of the isolines of a level. `tolerance` is the largest distance of the
  /// curve from the level set.
  LevelArc(const FaceEnvelope& envelope, double level, double tolerance);

  /// Returns the field at a point.
  LevelPoint Evaluate(const Point2& place) const;
  bool IsInside(const Point2& place) const;

  /// Returns the point at the level between a point below and a point above. IsOnLevel is false if
  /// the field does not attain the level between these points.
  LevelPoint FindBetween(const LevelPoint& below, const LevelPoint& above) const;

  /// Appends the points between two points of the isoline. Returns false if the tolerance may be
  /// exceeded.
  bool Refine(const LevelPoint& from, const LevelPoint& to, std::vector<Point2>& points) const
  {
    return this->RefineChord(from, to, 0, points);
  }

private:
  bool RefineChord(
    const LevelPoint& from, const LevelPoint& to, int depth, std::vector<Point2>& points) const;
  bool AddArc(const LevelPoint& from, const LevelPoint& to, std::vector<Point2>& points) const;
  bool IsSamePiece(const LevelPoint& a, const LevelPoint& b) const;
  bool MayTurn(const LevelPoint& a, const LevelPoint& b) const;
  bool FindCorner(
    const LevelPoint& from, const LevelPoint& to, LevelPoint& before, LevelPoint& after) const;
  bool MeetCandidates(const LevelPoint& from, const LevelPoint& to, Point2& corner) const;
  LevelPoint Project(const LevelPoint& from, const LevelPoint& to) const;

  const FaceEnvelope& Envelope;
  double Level;
  double Tolerance;
  double Size;  // size of the face
  double Close; // tolerance for points at the level
};
}

#endif
