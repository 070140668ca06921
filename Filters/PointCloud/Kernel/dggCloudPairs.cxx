// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudPairs.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Maximum angle between a chord and the tangent planes at its ends, in radians. A pair is rejected
/// if both angles exceed it.
constexpr double SteepestChord = Pi / 3.0;
/// Oriented normals are opposite if the cosine of the angle between them is below this value.
const double OppositeNormals = std::cos(100.0 / 180.0 * Pi);
/// Maximum turning angle of an arc, in radians. Beyond it, the path follows points.
constexpr double LargestTurn = 0.35;
/// Maximum distance of the surface from its expected position, relative to the local spacing.
constexpr double Tolerance = 0.6;
/// Number of pieces per local spacing, and maximum number of pieces, of a path that follows points.
/// More pieces would follow the unknown surface between the points; fewer would miss points.
constexpr double PiecesPerSpacing = 1.15;
constexpr int MostPieces = 64;
/// Maximum ratio of path length to chord length. A longer path does not run along the chord. Across
/// a right-angled edge the ratio is at most 1.41.
constexpr double LongestWay = 1.5;
/// Minimum length of a step through a ball, relative to the ball radius. A shorter step means that
/// the segment leaves the ball.
constexpr double LeastStep = 1e-3;
/// Minimum cosine of the angle between a normal and the direction in which heights are measured.
constexpr double LeastCosine = 0.35;
}

/// Geometry of the segment between two points, always starting from the point with the smaller id,
/// so that results are bitwise symmetric.
struct CloudPairs::Seen
{
  Seen(const CloudPairs& pairs, Id first, Id second, double chord)
    : P(std::min(first, second))
    , Q(std::max(first, second))
    , Chord(chord)
    , Segment(pairs.Points[Q] - pairs.Points[P])
  {
    const Point3& a = pairs.Normals[P];
    const Point3& b = pairs.Normals[Q];
    this->Angles = MeasureChord(this->Segment, chord, a, b);
    const bool isArc = pairs.IsSmooth[P] && pairs.IsSmooth[Q] && Angles.GetTurn() <= LargestTurn;
    this->Follows = pairs.UsesArcs && !isArc;
    this->IsFine = pairs.FindNearestPoint && (pairs.IsFine(P) || pairs.IsFine(Q));
  }

  /// Sets Up, the direction in which heights are measured: perpendicular to the segment, away from
  /// the surface. Returns false if there is no such direction.
  bool FindUp(const CloudPairs& pairs)
  {
    const Point3& a = pairs.Normals[this->P];
    const Point3& b = pairs.Normals[this->Q];
    this->Up = Dot(a, b) < 0.0 ? a - b : a + b;
    this->Up =
      this->Up - (Dot(this->Up, this->Segment) / (this->Chord * this->Chord)) * this->Segment;
    const double length = Norm(this->Up);
    if (!(length > LeastCosine))
    {
      return false;
    }
    this->Up = (1.0 / length) * this->Up;
    return true;
  }

  Id P;
  Id Q;
  double Chord;
  Point3 Segment;
  Point3 Up;
  ChordAngles Angles;
  bool Follows; ///< true if the path follows points rather than an arc
  bool IsFine;  ///< true if voxels are too coarse for the segment
};

double CloudPairs::Length(Id p, Id q, double chord) const
{
  Seen seen(*this, p, q, chord);
  if (!this->IsLikely(seen))
  {
    return Infinity;
  }
  if (!this->UsesArcs)
  {
    return chord;
  }
  return seen.Follows ? this->FollowPoints(seen) : chord * ArcFactor(seen.Angles);
}

bool CloudPairs::IsDirect(Id p, Id q, double chord) const
{
  Seen seen(*this, p, q, chord);
  if (!this->IsLikely(seen))
  {
    return false;
  }
  // For a path that follows points, Length() includes this check and returns Infinity.
  if (!seen.Follows && !this->Nearest.empty() &&
    chord > std::min(this->Spacings[p], this->Spacings[q]) && seen.FindUp(*this))
  {
    for (const double t : { 0.5, 0.25, 0.75 })
    {
      const Point3 place = this->Points[seen.P] + t * seen.Segment;
      const Id nearest = this->FindNearest(seen, place);
      if (nearest != NoId &&
        this->IsFarFrom(nearest, place, seen.Up, chord * ArcHeight(seen.Angles, t)))
      {
        return false;
      }
    }
  }
  return seen.IsFine ? this->IsInBalls(seen) : this->IsInBand(seen);
}

bool CloudPairs::IsInBand(const Seen& seen) const
{
  // The ends of the segment lie in the band as long as they are inside the balls of the two points.
  // The radii are reduced by one voxel to allow for rounding to voxels.
  const double size = this->Band.GetVoxelSize();
  const double first = std::max(0.0, this->Radii[seen.P] - size);
  const double second = std::max(0.0, this->Radii[seen.Q] - size);
  if (first + second >= seen.Chord)
  {
    return true;
  }
  return this->Band.ContainsSegment(
    this->Band.ToGrid(this->Points[seen.P] + (first / seen.Chord) * seen.Segment),
    this->Band.ToGrid(this->Points[seen.Q] - (second / seen.Chord) * seen.Segment));
}

/// Returns the same as IsInBand(), but without voxels. Passes from ball to ball: the next ball is
/// around the point nearest to the position where the segment leaves the last one, until the ball
/// at the other end is reached.
bool CloudPairs::IsInBalls(const Seen& seen) const
{
  const Point3 direction = (1.0 / seen.Chord) * seen.Segment;
  const double end = seen.Chord - this->Radii[seen.Q];
  double along = this->Radii[seen.P];
  while (along < end)
  {
    const Point3 place = this->Points[seen.P] + along * direction;
    const Id nearest = this->FindNearestPoint(place);
    const Point3 toCentre = this->Points[nearest] - place;
    const double radius = this->Radii[nearest];
    const double across = Dot(toCentre, direction);
    const double half = radius * radius - Dot(toCentre, toCentre) + across * across;
    const double step = across + std::sqrt(std::max(0.0, half));
    if (Dot(toCentre, toCentre) > radius * radius || !(step > LeastStep * radius))
    {
      return false;
    }
    along += step;
  }
  return true;
}

/// Returns true if the normals do not rule out a path along the segment.
bool CloudPairs::IsLikely(const Seen& seen) const
{
  if (std::abs(seen.Angles.First) > SteepestChord && std::abs(seen.Angles.Second) > SteepestChord)
  {
    return false;
  }
  return this->IsOriented.empty() || !this->IsOriented[seen.P] || !this->IsOriented[seen.Q] ||
    !(Dot(this->Normals[seen.P], this->Normals[seen.Q]) < OppositeNormals);
}

/// Returns the point nearest to a position on the segment, by voxels where they are fine enough;
/// NoId if there is none.
Id CloudPairs::FindNearest(const Seen& seen, const Point3& place) const
{
  if (seen.IsFine)
  {
    return this->FindNearestPoint(place);
  }
  const Voxel voxel = VoxelBand::VoxelOf(this->Band.ToGrid(place));
  const std::int64_t brick = this->Band.FindBrick(VoxelBand::BrickKey(voxel));
  const Id nearest = brick < 0 ? NoId : this->Nearest[VoxelBand::PlaceOf(brick, voxel)];
  return nearest != NoId && this->FindNearestPoint && this->IsFine(nearest)
    ? this->FindNearestPoint(place)
    : nearest;
}

/// Returns true if the surface at the point `nearest` is too far from its expected position, at the
/// given height over `place` in the direction `up`.
bool CloudPairs::IsFarFrom(Id nearest, const Point3& place, const Point3& up, double height) const
{
  const Point3 expected = place + height * up;
  const double off = Dot(this->Normals[nearest], this->Points[nearest] - expected);
  return std::abs(off) > Tolerance * this->Spacings[nearest];
}

/// Returns the length of a polyline over the points nearest to the segment, each moved within its
/// tangent plane to the plane spanned by the segment and Up. Returns Infinity if a point is too far
/// from its expected position, or if the polyline is too long compared to the chord.
double CloudPairs::FollowPoints(Seen& seen) const
{
  const double spacing =
    0.5 * (static_cast<double>(this->Spacings[seen.P]) + this->Spacings[seen.Q]);
  const int pieces = spacing > 0.0 ? static_cast<int>(std::min<double>(MostPieces,
                                       std::round(PiecesPerSpacing * seen.Chord / spacing)))
                                   : 1;
  if (pieces < 2 || this->Nearest.empty() || !seen.FindUp(*this))
  {
    return seen.Chord;
  }
  const double piece = seen.Chord / pieces;
  double last = 0.0;
  int lastPiece = 0;
  double sum = 0.0;
  for (int i = 1; i < pieces; ++i)
  {
    const double t = static_cast<double>(i) / pieces;
    const Point3 place = this->Points[seen.P] + t * seen.Segment;
    const Id nearest = this->FindNearest(seen, place);
    if (nearest == NoId)
    {
      continue;
    }
    if (this->IsFarFrom(nearest, place, seen.Up, seen.Chord * ArcHeight(seen.Angles, t)))
    {
      return Infinity;
    }
    const double cosine = Dot(this->Normals[nearest], seen.Up);
    if (std::abs(cosine) < LeastCosine)
    {
      continue;
    }
    const double height = Dot(this->Normals[nearest], this->Points[nearest] - place) / cosine;
    const double along = (i - lastPiece) * piece;
    sum += std::sqrt(along * along + (height - last) * (height - last));
    last = height;
    lastPiece = i;
  }
  const double along = (pieces - lastPiece) * piece;
  const double length = sum + std::sqrt(along * along + last * last);
  return length > LongestWay * seen.Chord ? Infinity : std::max(seen.Chord, length);
}
}
