// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceIsolines.h"

#include "dggLevelTurns.h"
#include "dggSurfacePoint.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dgg
{
namespace
{
/// Grid resolutions, tried in this order.
constexpr std::array<int, 5> CellsOfMarchingTriangles{ { 4, 8, 16, 32, 64 } };
/// Minimum number of lattice cells per seed (times two), except for the finest lattice.
constexpr double CellsPerSeed = 4.0;
/// Barycentric coordinate below which a source counts as on the boundary.
constexpr double OnRim = 1e-9;
/// Barycentric coordinate of the samples close to corners.
constexpr double NearCorner = 0.96;
/// Maximum recursion depth of the search for maxima.
constexpr int DeepestPeak = 4;

double LeastOf(const std::array<double, 3>& values)
{
  return std::min({ values[0], values[1], values[2] });
}
}

FaceIsolines::FaceIsolines(const DistanceField& field, const std::vector<double>& levels,
  double tolerance, const LevelCrossings& crossings)
  : Field(field)
  , Levels(levels)
  , Tolerance(tolerance)
  , Crossings(crossings)
  , Profile(field)
{
}

/// Returns true if the face may contain a source. The test is cheap and conservative.
bool FaceIsolines::MayHoldSource(Id f) const
{
  if (this->Field.HasWindows())
  {
    return !this->Field.Windows->Sources.empty();
  }
  if (!this->Field.HasSources())
  {
    return false;
  }
  const SurfaceMesh& mesh = *this->Field.Mesh;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    const double reach = std::max(mesh.Length(h), mesh.Length(SurfaceMesh::Previous(h)));
    if ((*this->Field.Sources)[mesh.Origin(h)].Length <= reach)
    {
      return true;
    }
  }
  return false;
}

Id FaceIsolines::Trace(Id f, std::vector<FaceCurve>& curves)
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  Id first = static_cast<Id>(this->Levels.size());
  Id last = -1;
  double nearest = Infinity;
  double farthest = -Infinity;
  double reach = 0.0; // reach of the nearest corner within the face
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * f + k;
    this->Edges[k] = FindEdge(mesh, h);
    this->NextCrossings[k] = this->Crossings.Offsets[this->Edges[k]];
    const Id end = this->Crossings.Offsets[this->Edges[k] + 1];
    if (this->NextCrossings[k] < end)
    {
      first = std::min(first, this->Crossings.Crossings[this->NextCrossings[k]].Level);
      last = std::max(last, this->Crossings.Crossings[end - 1].Level);
    }
    const double d = this->Field.Distances[mesh.Origin(h)];
    if (d < nearest)
    {
      nearest = d;
      reach = std::max(mesh.Length(h), mesh.Length(SurfaceMesh::Previous(h)));
    }
    farthest = std::max(farthest, d);
    longest = std::max(longest, mesh.Length(h));
  }
  const bool isLinear = !this->Field.HasWindows() && !this->Field.HasSources();
  const auto begin = this->Levels.begin();
  const auto end = this->Levels.end();
  if (!isLinear)
  {
    // Levels between the distance of a source inside the face and the distance of the path through
    // a corner.
    const auto above = std::upper_bound(begin, end, farthest);
    for (auto level = above; level != end && *level <= nearest + reach; ++level)
    {
      first = std::min(first, static_cast<Id>(level - begin));
      last = std::max(last, static_cast<Id>(level - begin));
    }
    const bool mayHold = this->MayHoldSource(f);
    const auto below = mayHold ? std::lower_bound(begin, end, nearest - longest) : end;
    if (below != end && *below <= nearest)
    {
      first = std::min(first, static_cast<Id>(below - begin));
      last = std::max(last, static_cast<Id>(std::upper_bound(below, end, nearest) - begin) - 1);
    }
  }
  if (first > last)
  {
    return 0;
  }
  this->Profile.Enter(f);
  this->Seeds.clear();
  if (!isLinear)
  {
    this->FindSeeds();
  }
  Id fallbacks = 0;
  for (Id level = first; level <= last; ++level)
  {
    this->CollectRim(level);
    this->SeedsOfLevel.clear();
    for (const Seed& seed : this->Seeds)
    {
      if ((seed.Distance < this->Levels[level]) != seed.IsPeak)
      {
        this->SeedsOfLevel.push_back(seed.Place);
      }
    }
    if (!this->SeedsOfLevel.empty() || this->Rim.CountCrossings() > 0)
    {
      fallbacks += this->TraceLevel(level, curves);
    }
  }
  return fallbacks;
}

/// Finds the points around which isolines may be closed within the face. The source of a corner may
/// be such a point even if its model has a small deficit, as with the rounded angles of graphs; the
/// distance at the source decides.
void FaceIsolines::FindSeeds()
{
  for (const FieldSample& source : this->Profile.GetSources())
  {
    this->AddSource(source);
  }
  std::array<LevelPoint, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 3> b{};
    b.fill(0.5 * (1.0 - NearCorner));
    b[k] = NearCorner;
    corners[k].Place = this->Profile.PlaceOf(b);
    corners[k].Sample = this->Profile.SampleAt(corners[k].Place);
    if (this->Field.HasSources())
    {
      this->AddSource(corners[k].Sample);
    }
  }
  LevelPoint middle;
  middle.Place = this->Profile.PlaceOf({ { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
  middle.Sample = this->Profile.SampleAt(middle.Place);
  this->FindPeaks({ { &corners[0], &corners[1], &corners[2] } }, 0);
  for (int k = 0; k < 3; ++k)
  {
    this->FindPeaks({ { &corners[k], &corners[(k + 1) % 3], &middle } }, 0);
  }
}

void FaceIsolines::AddSource(const FieldSample& sample)
{
  const Point2& place = sample.Image;
  if (!(LeastOf(this->Profile.BarycentricOf(place)) > OnRim))
  {
    return;
  }
  const std::array<Point2, 3>& corners = this->Profile.GetCorners();
  const double close = 1e-6 * Distance(corners[0], corners[1]);
  const double distance = this->Profile.At(place);
  if (!this->Levels.empty() && !(distance < this->Levels.back()))
  {
    return; // all levels are below
  }
  for (const Seed& seed : this->Seeds)
  {
    if (Distance(seed.Place, place) <= close)
    {
      return;
    }
  }
  this->Seeds.push_back({ place, distance, false });
}

/// Finds the maxima between three points, around which isolines may be closed: points at which the
/// wavefronts of the points meet from all sides. If another wavefront is shorter at such a point,
/// searches between this point and each two of the others.
void FaceIsolines::FindPeaks(const std::array<const LevelPoint*, 3>& points, int depth)
{
  LevelPoint meeting;
  if (!FindMeeting(points, meeting.Place))
  {
    return;
  }
  meeting.Sample = this->Profile.SampleAt(meeting.Place);
  const auto isNearest = [&](const LevelPoint* point) {
    return point->Sample.Candidate == meeting.Sample.Candidate;
  };
  if (std::any_of(points.begin(), points.end(), isNearest))
  {
    std::array<Point2, 3> away;
    for (int k = 0; k < 3; ++k)
    {
      away[k] = Difference(meeting.Place, points[k]->Sample.Image);
    }
    const double turn = Cross(away[0], away[1]);
    if (turn * Cross(away[1], away[2]) > 0.0 && turn * Cross(away[2], away[0]) > 0.0)
    {
      this->Seeds.push_back({ meeting.Place, meeting.Sample.Distance, true });
    }
    return;
  }
  for (int k = 0; k < 3 && depth < DeepestPeak; ++k)
  {
    std::array<const LevelPoint*, 3> part = points;
    part[k] = &meeting;
    this->FindPeaks(part, depth + 1);
  }
}

/// Collects the crossings of one level. Levels must be visited in increasing order.
void FaceIsolines::CollectRim(Id level)
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const std::vector<LevelCrossing>& crossings = this->Crossings.Crossings;
  this->Rim.Clear();
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * this->Profile.GetFace() + k;
    const Id edge = this->Edges[k];
    const bool isSame = mesh.Origin(edge) == mesh.Origin(h);
    std::vector<RimCrossing>& side = this->Rim.Sides[k];
    Id& next = this->NextCrossings[k];
    for (; next < this->Crossings.Offsets[edge + 1] && crossings[next].Level <= level; ++next)
    {
      if (crossings[next].Level == level)
      {
        const double t = crossings[next].X / mesh.Length(edge);
        side.push_back({ isSame ? t : 1.0 - t, next });
      }
    }
    if (!isSame)
    {
      std::reverse(side.begin(), side.end());
    }
    this->Rim.IsAbove[k] = this->Profile.GetCornerDistance(k) >= this->Levels[level];
  }
}

LevelPoint FaceIsolines::LookAtRim(const LevelArc& arc, Id crossing) const
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const LevelCrossing& c = this->Crossings.Crossings[crossing];
  const auto side = std::find(this->Edges.begin(), this->Edges.end(), c.HalfEdge);
  const auto k = static_cast<int>(side - this->Edges.begin());
  const double t = c.X / mesh.Length(c.HalfEdge);
  const bool isSame = mesh.Origin(c.HalfEdge) == mesh.Origin(3 * this->Profile.GetFace() + k);
  return arc.Evaluate(this->Profile.PlaceOf(CoordinatesOnEdge(k, isSame ? t : 1.0 - t)));
}

Id FaceIsolines::TraceLevel(Id level, std::vector<FaceCurve>& curves)
{
  const double value = this->Levels[level];
  const LevelArc arc(this->Profile, value, this->Tolerance);
  const std::size_t size = curves.size();
  if (this->SeedsOfLevel.empty() && this->Rim.CountCrossings() == 2 &&
    this->TraceDirectly(arc, level, curves))
  {
    return 0;
  }
  Id failures = 0;
  const auto seeds = static_cast<double>(this->SeedsOfLevel.size());
  for (const int cells : CellsOfMarchingTriangles)
  {
    if (cells < CellsOfMarchingTriangles.back() && cells * cells < CellsPerSeed * seeds)
    {
      continue; // triangles between seeds would be slivers
    }
    failures = 0;
    curves.resize(size);
    this->Triangles.Build(this->Profile, arc, value, this->Rim, cells, this->SeedsOfLevel);
    for (const LevelChain& chain : this->Triangles.GetChains())
    {
      FaceCurve curve;
      failures += this->TraceChain(arc, chain, level, curve) ? 0 : 1;
      if (curve.First != NoId || curve.Points.size() > 1)
      {
        curves.push_back(std::move(curve));
      }
    }
    if (failures == 0)
    {
      break;
    }
  }
  return failures;
}

/// Traces a single curve between two crossings. Returns false if a single curve is not sufficient.
bool FaceIsolines::TraceDirectly(const LevelArc& arc, Id level, std::vector<FaceCurve>& curves)
{
  LevelChain chain;
  for (int k = 0; k < 3; ++k)
  {
    bool isAbove = this->Rim.IsAbove[k];
    for (const RimCrossing& crossing : this->Rim.Sides[k])
    {
      (isAbove ? chain.Last : chain.First) = crossing.Index;
      isAbove = !isAbove;
    }
  }
  FaceCurve curve;
  const bool isGood = this->TraceChain(arc, chain, level, curve);
  if (isGood)
  {
    curves.push_back(std::move(curve));
  }
  return isGood;
}

/// Traces a chain, skipping points that are not at the level, except for crossings on the boundary.
/// Returns true if the curve is within the tolerance of the level set.
bool FaceIsolines::TraceChain(
  const LevelArc& arc, const LevelChain& chain, Id level, FaceCurve& curve)
{
  curve.Face = this->Profile.GetFace();
  curve.Level = level;
  curve.First = chain.First;
  curve.Last = chain.Last;
  this->Curve.clear();
  if (chain.First != NoId)
  {
    this->Curve.push_back(this->LookAtRim(arc, chain.First));
  }
  std::copy_if(chain.Points.begin(), chain.Points.end(), std::back_inserter(this->Curve),
    [](const LevelPoint& point) { return point.IsOnLevel; });
  this->Points.clear();
  if (chain.First != NoId)
  {
    this->Curve.push_back(this->LookAtRim(arc, chain.Last));
  }
  else if (!this->Curve.empty())
  {
    this->Points.push_back(this->Curve.front().Place);
    this->Curve.emplace_back(this->Curve.front());
  }
  bool isGood = true;
  for (std::size_t i = 1; i < this->Curve.size(); ++i)
  {
    const LevelPoint& from = this->Curve[i - 1];
    const LevelPoint& to = this->Curve[i];
    const bool isClose = arc.Refine(from, to, this->Points);
    isGood = isGood && (isClose || !from.IsOnLevel || !to.IsOnLevel);
    if (i + 1 < this->Curve.size())
    {
      this->Points.push_back(to.Place);
    }
  }
  curve.Points.reserve(this->Points.size());
  for (const Point2& place : this->Points)
  {
    curve.Points.push_back(this->Profile.BarycentricOf(place));
  }
  return isGood;
}
}
