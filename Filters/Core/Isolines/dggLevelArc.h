// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The shape of one isoline inside one face. Internal.
#ifndef dggLevelArc_h
#define dggLevelArc_h

#include "dggFaceProfile.h" // for FaceProfile

#include <vector> // for the points

namespace dgg
{
/// A point on the way of an isoline, and the field there. At a corner of the isoline there are two
/// of them, with the field on either side.
struct LevelPoint
{
  Point2 Place;
  FieldSample Sample;
  bool IsOnLevel = false; ///< up to rounding
};

/// Puts points between those of an isoline until it is as close to the level set as is wished.
/// Level sets are arcs of circles around images of sources, which meet in corners; both are found
/// exactly. Where the field is no more than smooth, points are found by Newton's method.
///
/// Isolines have the lower distance on their left, so that they turn left around sources.
class LevelArc
{
public:
  /// The curve is to be as close as `tolerance` to the level set.
  LevelArc(const FaceProfile& profile, double level, double tolerance);

  /// The field at a point.
  LevelPoint Look(const Point2& place) const;
  bool IsInside(const Point2& place) const;

  /// The point of the level between a place below it and one above it. Not on the level when the
  /// field does not take it in between.
  LevelPoint FindBetween(const LevelPoint& below, const LevelPoint& above) const;

  /// Append the points between two points of the isoline. False when it may be farther from the
  /// level than wished.
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
  bool MeetCircles(const LevelPoint& from, const LevelPoint& to, Point2& corner) const;
  bool MeetCandidates(const LevelPoint& from, const LevelPoint& to, Point2& corner) const;
  LevelPoint Project(const LevelPoint& from, const LevelPoint& to) const;

  const FaceProfile& Profile;
  double Level;
  double Tolerance;
  double Size;  // of the face
  double Close; // what counts as on the level
};
}

#endif
