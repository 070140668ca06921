// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudPairs.h"

#include <cmath>

namespace dgg
{
namespace
{
/// The steepest angle between a chord and the tangent planes at both of its ends.
constexpr double SteepestChord = Pi / 3.0;
/// Sides that normals point to are opposite when the cosine between them is below that.
const double OppositeNormals = std::cos(100.0 / 180.0 * Pi);
/// The turn that an arc may make, in radians. Beyond it, points are followed.
constexpr double LargestTurn = 0.35;
/// How far the surface may be from where it is expected, by the local spacing.
constexpr double Tolerance = 0.6;
/// Pieces of a way that follows points, per local spacing, and at most: more would follow what is
/// between the points, which is guessed, fewer would miss points.
constexpr double PiecesPerSpacing = 1.15;
constexpr int MostPieces = 64;
/// A way that is longer by that than its chord does not go along it. Over a right angle it is
/// longer by 1.41.
constexpr double LongestWay = 1.5;
/// A way leaves a ball, rather than going through it, when what is left of it is that short, by the
/// radius.
constexpr double LeastStep = 1e-3;
/// Cosine between a normal and the direction that heights are measured in, at least.
constexpr double LeastCosine = 0.35;
}

/// What a segment between two points looks like, seen from the point with the smaller number, so
/// that it is the same, bit by bit, both ways round.
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

  /// The direction that heights are measured in: across the segment, away from the surface. False
  /// when there is none.
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
  bool Follows; ///< whether points are followed, rather than an arc
  bool IsFine;  ///< whether voxels are too coarse for it
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
  // Where points are followed, the length is infinite when they are not where they should be.
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
  // What lies in the balls at both ends, a voxel less for what rounding does to them, is in the
  // band.
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

/// The same without voxels: from the ball of the point that is nearest to where the last one ends
/// to that of the next, until the other end is reached.
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

/// Whether normals do not speak against a way.
bool CloudPairs::IsLikely(const Seen& seen) const
{
  if (std::abs(seen.Angles.First) > SteepestChord && std::abs(seen.Angles.Second) > SteepestChord)
  {
    return false;
  }
  return this->IsOriented.empty() || !this->IsOriented[seen.P] || !this->IsOriented[seen.Q] ||
    !(Dot(this->Normals[seen.P], this->Normals[seen.Q]) < OppositeNormals);
}

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

/// Whether the surface at a point near a place is not where it should be: at a height over it.
bool CloudPairs::IsFarFrom(Id nearest, const Point3& place, const Point3& up, double height) const
{
  const Point3 expected = place + height * up;
  const double off = Dot(this->Normals[nearest], this->Points[nearest] - expected);
  return std::abs(off) > Tolerance * this->Spacings[nearest];
}

/// A polyline over the points that are nearest to the segment, each moved in its tangent plane to
/// the plane of segment and up.
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
