// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceRidges.h"

#include "dggSurfacePoint.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace dgg
{
namespace
{
/// Initial numbers of samples of the search for jumps.
constexpr int SamplesOfSide = 8;
constexpr int SamplesOfCorner = 2;
constexpr int SamplesOfCut = 6;
/// Bisection widths. At corners, smaller widths would reveal rounding.
constexpr double WidthOfSide = 1e-12;
constexpr double WidthOfCorner = 1e-4;
/// Tolerance between a jump and the tie, relative to the longest edge. The tolerance is larger on
/// the boundary, which is sampled slightly inside.
constexpr double RimSlack = 1e-4;
constexpr double CutSlack = 1e-6;
/// Minimum relative size of subregions that are divided further: where ridges meet, and where a
/// ridge ends because its angle decreases.
constexpr double SmallestPart = 1e-7;
constexpr double SmallestDeadEnd = 1e-2;
/// Fraction of the tolerance below which subregions are not divided either.
constexpr double SmallShare = 0.1;
/// Position and rotation of cuts: arbitrary values, which do not coincide with symmetries of
/// regular meshes.
constexpr double CutPlace = 0.4871;
constexpr double CutTurn = 0.1373;
/// Relative step from a tie to a point at which a single source is nearest.
constexpr double TieStep = 1e-6;
constexpr int MaximumDepth = 12;
/// Minimum number of bisections of a curve whose ends belong to different sources.
constexpr int MinimumDepth = 2;

/// Returns true if a point lies inside a convex polygon, up to `slack`.
template <typename Polygon>
bool IsInside(const Polygon& polygon, double slack, const Point2& place)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& p = polygon[i].Place;
    const Point2 side = Difference(polygon[(i + 1) % polygon.size()].Place, p);
    if (Cross(side, Difference(place, p)) < -slack * Norm(side.X, side.Y))
    {
      return false;
    }
  }
  return true;
}

bool HavePair(const FieldSample& a, const FieldSample& b, const FieldSample& c,
  const FieldSample& d, double length)
{
  return (HaveOneSource(a, c, length) && HaveOneSource(b, d, length)) ||
    (HaveOneSource(a, d, length) && HaveOneSource(b, c, length));
}
}

FaceRidgeFinder::FaceRidgeFinder(const DistanceField& field, const RidgeOptions& options)
  : Field(field)
  , Options(options)
  , Envelope(field)
  , Edge(field)
  , Jumps(Envelope, options.MinimumAngle, options.BetweenSources)
{
}

void FaceRidgeFinder::Find(Id f, FaceRidges& found)
{
  this->Found = &found;
  this->Envelope.Enter(f);
  if (this->Options.BetweenSources && !this->Envelope.MayHaveSeveralSources())
  {
    return;
  }
  this->Crossings.clear();
  this->Jumps.Restart();
  this->Size = std::max({ this->Field.Mesh->Length(3 * f), this->Field.Mesh->Length(3 * f + 1),
    this->Field.Mesh->Length(3 * f + 2) });
  this->Hidden.clear();
  if (this->Options.BetweenSources)
  {
    const std::vector<FieldSample>& sources = this->Envelope.GetSources();
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(this->Hidden),
      [&](const FieldSample& s) { return this->Envelope.SampleAt(s.Image).Source == s.Source; });
  }
  const Rim rim = this->MakeRim();
  this->Reveal(this->Envelope.SampleAt(rim[0].Place).Source);
  this->Connect(rim);
}

/// Returns the boundary of the search region. The boundary is the hexagon that remains after
/// cutting the corners off, with the ridge points that leave between its corners.
FaceRidgeFinder::Rim FaceRidgeFinder::MakeRim()
{
  std::array<std::array<Point2, 2>, 3> ends;
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 2; ++i)
    {
      std::array<double, 3> b{};
      b[(k + 2) % 3] = RimInset;
      b[(k + 1 - i) % 3] = CornerInset;
      b[(k + i) % 3] = 1.0 - CornerInset - RimInset;
      ends[k][i] = this->Envelope.PlaceOf(b);
      const FieldSample sample = this->Envelope.SampleAt(ends[k][i]);
      const Point2 axis =
        Difference(this->Envelope.GetCorners()[(k + 1) % 3], this->Envelope.GetCorners()[k]);
      this->Found->RimAngles[k][i] =
        static_cast<float>(std::atan2(Cross(axis, sample.Gradient), Dot(axis, sample.Gradient)));
    }
  }
  Rim rim;
  for (int k = 0; k < 3; ++k)
  {
    rim.push_back({ ends[k][0], NoId });
    this->AddSide(k, ends[k][0], ends[k][1], rim);
    rim.push_back({ ends[k][1], NoId });
    this->AddCorner((k + 1) % 3, ends[k][1], ends[(k + 1) % 3][0], rim);
  }
  return rim;
}

/// Adds the ridges that leave through an edge, located at the tie on the edge itself.
void FaceRidgeFinder::AddSide(int k, const Point2& from, const Point2& to, Rim& rim)
{
  std::vector<FieldJump> jumps;
  if (this->Options.BetweenSources)
  {
    this->Jumps.Find(from, to, this->Edge.FindPlacesBetweenBreaks(3 * this->Envelope.GetFace() + k),
      WidthOfSide, jumps);
  }
  else
  {
    this->Jumps.Find(from, to, SamplesOfSide, WidthOfSide, jumps);
  }
  const double length = this->Field.Mesh->Length(3 * this->Envelope.GetFace() + k);
  const Point2& origin = this->Envelope.GetCorners()[k];
  const Point2& end = this->Envelope.GetCorners()[(k + 1) % 3];
  const Point2 axis{ (end.X - origin.X) / length, (end.Y - origin.Y) / length };
  auto abscissa = [&](const Point2& p) { return Dot(axis, Difference(p, origin)); };
  for (const FieldJump& jump : jumps)
  {
    const double x = abscissa(jump.Place);
    Point2 place{ origin.X + x * axis.X, origin.Y + x * axis.Y };
    RidgeEnd ridgeEnd;
    ridgeEnd.On = RidgeEnd::Support::Edge;
    ridgeEnd.Side = k;
    ridgeEnd.X = x;
    Point2 tie = place;
    if (MoveToTie(jump.Before, jump.After, axis, RimSlack * length, tie) && abscissa(tie) > 0.0 &&
      abscissa(tie) < length)
    {
      place = tie;
      ridgeEnd.X = abscissa(tie);
    }
    rim.push_back({ jump.Place, this->AddEnd(ridgeEnd, { place, jump.Before, jump.After }) });
  }
}

/// Adds the ridges that end at a corner or pass it.
void FaceRidgeFinder::AddCorner(int k, const Point2& from, const Point2& to, Rim& rim)
{
  std::vector<FieldJump> jumps;
  this->Jumps.Find(from, to, SamplesOfCorner, WidthOfCorner, jumps);
  for (const FieldJump& jump : jumps)
  {
    RidgeEnd end;
    end.On = RidgeEnd::Support::Vertex;
    end.Side = k;
    rim.push_back({ jump.Place,
      this->AddEnd(end, { this->Envelope.GetCorners()[k], jump.Before, jump.After }) });
  }
}

Id FaceRidgeFinder::AddEnd(const RidgeEnd& end, const Crossing& crossing)
{
  this->Found->Ends.push_back(end);
  this->Found->Ends.back().Angle = AngleBetween(crossing.Before, crossing.After);
  this->Crossings.push_back(crossing);
  this->Reveal(crossing.Before.Source);
  this->Reveal(crossing.After.Source);
  return static_cast<Id>(this->Crossings.size()) - 1;
}

/// Connects the ridges that leave a convex subregion.
void FaceRidgeFinder::Connect(const Rim& rim)
{
  std::vector<Id> ridges;
  double size = 0.0;
  for (const RimPoint& point : rim)
  {
    if (point.Ridge != NoId)
    {
      ridges.push_back(point.Ridge);
    }
    size = std::max(size, Distance(point.Place, rim[0].Place));
  }
  const double share = this->Options.BetweenSources ? 0.0 : SmallShare;
  const double smallest = std::max(SmallestPart * this->Size, share * this->Options.ChordTolerance);
  Point2 junction;
  if (size > smallest && this->HidesSource(rim))
  {
    this->Divide(rim);
    return;
  }
  if (ridges.empty())
  {
    return;
  }
  if (ridges.size() == 2)
  {
    // If no ridge point is found in between, the two ends do not belong to one line: two ridges
    // end, or further ridges have smaller angles.
    if (!this->AddPiece(ridges[0], ridges[1], size <= SmallestDeadEnd * this->Size))
    {
      this->Divide(rim);
    }
  }
  else if (ridges.size() > 2 && this->FindJunction(ridges, rim, junction))
  {
    this->MakeJunction(ridges, junction);
  }
  else if (ridges.size() > 2 && size <= smallest)
  {
    this->MakeJunction(ridges, this->MeanOf(ridges));
  }
  else if (size > (ridges.size() == 1 ? SmallestDeadEnd * this->Size : smallest))
  {
    this->Divide(rim);
  }
}

/// Returns true if a subregion contains a source whose cell is not on any boundary so far.
bool FaceRidgeFinder::HidesSource(const Rim& rim) const
{
  return std::any_of(this->Hidden.begin(), this->Hidden.end(),
    [&](const FieldSample& source) { return IsInside(rim, 0.0, source.Image); });
}

/// Notes that the cell of a source is on a boundary.
void FaceRidgeFinder::Reveal(Id source)
{
  this->Hidden.erase(std::remove_if(this->Hidden.begin(), this->Hidden.end(),
                       [source](const FieldSample& sample) { return sample.Source == source; }),
    this->Hidden.end());
}

/// Divides a subregion across its longest diagonal.
void FaceRidgeFinder::Divide(const Rim& rim)
{
  if (this->Jumps.IsExhausted())
  {
    ++this->Fallbacks;
    return;
  }
  std::size_t first = 0;
  std::size_t second = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    for (std::size_t j = i + 1; j < rim.size(); ++j)
    {
      const double length = Distance(rim[i].Place, rim[j].Place);
      if (length > longest)
      {
        longest = length;
        first = i;
        second = j;
      }
    }
  }
  const Point2 way = Difference(rim[second].Place, rim[first].Place);
  const Point2 through{ rim[first].Place.X + CutPlace * way.X,
    rim[first].Place.Y + CutPlace * way.Y };
  const Point2 across{ way.X - CutTurn * way.Y, way.Y + CutTurn * way.X };
  auto height = [&](std::size_t i) {
    return Dot(across, Difference(rim[i % rim.size()].Place, through));
  };
  std::vector<std::size_t> cuts; // each cut is before the point of this index
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    if ((height(i) < 0.0) != (height(i + 1) < 0.0))
    {
      cuts.push_back(i);
    }
  }
  if (cuts.size() != 2)
  {
    return;
  }
  std::array<Point2, 2> places;
  for (int c = 0; c < 2; ++c)
  {
    const Point2& p = rim[cuts[c]].Place;
    const Point2& q = rim[(cuts[c] + 1) % rim.size()].Place;
    const double t = height(cuts[c]) / (height(cuts[c]) - height(cuts[c] + 1));
    places[c] = { p.X + t * (q.X - p.X), p.Y + t * (q.Y - p.Y) };
  }
  std::vector<FieldJump> jumps;
  this->Jumps.Find(places[0], places[1], SamplesOfCut, WidthOfSide, jumps);
  const double length = Distance(places[0], places[1]);
  const Point2 axis{ (places[1].X - places[0].X) / length, (places[1].Y - places[0].Y) / length };
  Rim cut;
  cut.push_back({ places[0], NoId });
  for (const FieldJump& jump : jumps)
  {
    Point2 place = jump.Place;
    MoveToTie(jump.Before, jump.After, axis, CutSlack * length, place);
    RidgeEnd end;
    end.Barycentric = ClampedToFace(this->Envelope.BarycentricOf(place));
    cut.push_back({ jump.Place, this->AddEnd(end, { place, jump.Before, jump.After }) });
  }
  cut.push_back({ places[1], NoId });
  // Parts: the region between the cuts, and the remainder.
  Rim part(rim.begin() + static_cast<std::ptrdiff_t>(cuts[0]) + 1,
    rim.begin() + static_cast<std::ptrdiff_t>(cuts[1]) + 1);
  part.insert(part.end(), cut.rbegin(), cut.rend());
  this->Connect(part);
  part.assign(rim.begin() + static_cast<std::ptrdiff_t>(cuts[1]) + 1, rim.end());
  part.insert(part.end(), rim.begin(), rim.begin() + static_cast<std::ptrdiff_t>(cuts[0]) + 1);
  part.insert(part.end(), cut.begin(), cut.end());
  this->Connect(part);
}

/// Finds the point where all ridges meet, with three shortest paths or, by symmetry, more. Returns
/// false if there is not one source between each two ridges, or the point does not lie inside.
bool FaceRidgeFinder::FindJunction(
  const std::vector<Id>& ridges, const Rim& rim, Point2& place) const
{
  std::vector<FieldSample> sources;
  for (const Id ridge : ridges)
  {
    for (const FieldSample* sample :
      { &this->Crossings[ridge].Before, &this->Crossings[ridge].After })
    {
      const bool isKnown = std::any_of(sources.begin(), sources.end(),
        [&](const FieldSample& s) { return HaveOneSource(s, *sample, this->Size); });
      if (!isKnown)
      {
        sources.push_back(*sample);
      }
    }
  }
  if (sources.size() != ridges.size())
  {
    return false;
  }
  place = this->MeanOf(ridges);
  if (!MoveToTie(sources[0], sources[1], sources[2], place))
  {
    return false;
  }
  // The point must lie inside the subregion, up to the inset of the boundary.
  return IsInside(rim, CornerInset * this->Size, place) &&
    std::all_of(sources.begin(), sources.end(),
      [&](const FieldSample& source) { return this->IsNearest(source, place); });
}

Point2 FaceRidgeFinder::MeanOf(const std::vector<Id>& ridges) const
{
  Point2 mean;
  for (const Id ridge : ridges)
  {
    mean.X += this->Crossings[ridge].Place.X / static_cast<double>(ridges.size());
    mean.Y += this->Crossings[ridge].Place.Y / static_cast<double>(ridges.size());
  }
  return mean;
}

void FaceRidgeFinder::MakeJunction(const std::vector<Id>& ridges, const Point2& place)
{
  RidgeEnd end;
  end.Barycentric = ClampedToFace(this->Envelope.BarycentricOf(place));
  const Crossing first = this->Crossings[ridges[0]];
  const Id junction = this->AddEnd(end, { place, first.Before, first.After });
  for (const Id ridge : ridges)
  {
    // Use the same sources at both ends, so that the curve between them is found directly.
    this->Crossings[junction].Before = this->Crossings[ridge].Before;
    this->Crossings[junction].After = this->Crossings[ridge].After;
    this->AddPiece(ridge, junction, true);
  }
}

/// Adds a ridge segment between two points. If no ridge is found between them, adds the segment
/// nevertheless if `mayFail` is true, and returns false otherwise.
bool FaceRidgeFinder::AddPiece(Id from, Id to, bool mayFail)
{
  RidgePiece piece;
  piece.From = from;
  piece.To = to;
  if (!this->Refine(this->Crossings[from], this->Crossings[to], 0, piece.Points))
  {
    if (!mayFail)
    {
      return false;
    }
    ++this->Fallbacks;
  }
  this->Found->Pieces.push_back(std::move(piece));
  return true;
}

/// Adds points between two ridge points by bisection. Returns false if some points were not found.
bool FaceRidgeFinder::Refine(
  const Crossing& from, const Crossing& to, int depth, std::vector<std::array<double, 3>>& points)
{
  const double length = Distance(from.Place, to.Place);
  if (depth >= MaximumDepth || length <= this->Options.ChordTolerance)
  {
    return true;
  }
  Crossing between;
  if (!this->FindBetween(from, to, between))
  {
    return false;
  }
  const Point2 middle{ 0.5 * (from.Place.X + to.Place.X), 0.5 * (from.Place.Y + to.Place.Y) };
  const bool isSmooth = HavePair(from.Before, from.After, to.Before, to.After, this->Size);
  if (Distance(middle, between.Place) <= this->Options.ChordTolerance &&
    (isSmooth || depth >= MinimumDepth))
  {
    return true;
  }
  const bool isFound = this->Refine(from, between, depth + 1, points);
  points.push_back(ClampedToFace(this->Envelope.BarycentricOf(between.Place)));
  return this->Refine(between, to, depth + 1, points) && isFound;
}

/// Finds the point at which the ridge crosses the perpendicular through the middle of a chord. The
/// point is at the tie of the sources of an end, otherwise it is found by a new search. Returns
/// false if no point is found.
bool FaceRidgeFinder::FindBetween(const Crossing& from, const Crossing& to, Crossing& between) const
{
  const double length = Distance(from.Place, to.Place);
  const Point2 normal{ (from.Place.Y - to.Place.Y) / length, (to.Place.X - from.Place.X) / length };
  const Point2 middle{ 0.5 * (from.Place.X + to.Place.X), 0.5 * (from.Place.Y + to.Place.Y) };
  for (const Crossing* end : { &from, &to })
  {
    between = { middle, end->Before, end->After };
    if (MoveToTie(end->Before, end->After, normal, length, between.Place) && this->IsTie(between))
    {
      return true;
    }
  }
  // Search the perpendicular of the chord, within the face.
  const std::array<double, 3> here = this->Envelope.BarycentricOf(middle);
  const std::array<double, 3> there =
    this->Envelope.BarycentricOf({ middle.X + normal.X, middle.Y + normal.Y });
  double begin = -0.5 * length;
  double end = 0.5 * length;
  for (int k = 0; k < 3; ++k)
  {
    const double rise = there[k] - here[k];
    if (rise > 0.0)
    {
      begin = std::max(begin, -here[k] / rise);
    }
    else if (rise < 0.0)
    {
      end = std::min(end, -here[k] / rise);
    }
  }
  if (!(begin < end))
  {
    return false;
  }
  std::vector<FieldJump> jumps;
  this->Jumps.Find({ middle.X + begin * normal.X, middle.Y + begin * normal.Y },
    { middle.X + end * normal.X, middle.Y + end * normal.Y }, SamplesOfCut, WidthOfSide, jumps);
  if (jumps.empty())
  {
    return false;
  }
  const FieldJump& best =
    *std::min_element(jumps.begin(), jumps.end(), [&](const FieldJump& a, const FieldJump& b) {
      return Distance(a.Place, middle) < Distance(b.Place, middle);
    });
  between = { best.Place, best.Before, best.After };
  MoveToTie(best.Before, best.After, normal, CutSlack * this->Size, between.Place);
  return true;
}

/// Returns true if both sources of a crossing are nearest at its point.
bool FaceRidgeFinder::IsTie(const Crossing& crossing) const
{
  const std::array<double, 3> b = this->Envelope.BarycentricOf(crossing.Place);
  if (!(std::min({ b[0], b[1], b[2] }) >= -RimInset))
  {
    return false;
  }
  return this->IsNearest(crossing.Before, crossing.Place) &&
    this->IsNearest(crossing.After, crossing.Place);
}

/// Returns true if a source is nearest at a point, possibly tied. After a step towards the source,
/// the source must be the only nearest one.
bool FaceRidgeFinder::IsNearest(const FieldSample& source, const Point2& p) const
{
  const Point2 way = Difference(source.Image, p);
  const double length = Norm(way.X, way.Y);
  const double step = std::min(1.0, TieStep * this->Size / length);
  return length > 0.0 &&
    HaveOneSource(
      source, this->Envelope.SampleAt({ p.X + step * way.X, p.Y + step * way.Y }), this->Size);
}
}
