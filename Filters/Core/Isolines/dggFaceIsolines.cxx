// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceIsolines.h"

#include "dggFieldJumps.h"
#include "dggSurfacePoint.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

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
/// Barycentric distance of samples from the boundary.
constexpr double Inset = 1e-3;
/// Tolerance of the distance at a meeting point, relative to an edge length.
constexpr double TieTolerance = 1e-9;
/// Maximum number of wavefronts in the search for maxima.
constexpr std::size_t MostWaves = 24;

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
  , Envelope(field)
  , Edge(field)
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
  this->Envelope.Enter(f);
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
  std::vector<FieldSample> waves;
  waves.reserve(MostWaves); // references to waves remain valid
  for (const FieldSample& source : this->Envelope.GetSources())
  {
    this->AddSource(source);
    this->AddWave(source, waves);
  }
  const bool mayHavePeak = this->Envelope.MayHavePeak();
  for (int k = 0; k < 3; ++k)
  {
    // Each wavefront enters through a side, unless its source is inside.
    std::vector<double> places;
    if (mayHavePeak)
    {
      places = this->Edge.FindPlacesBetweenBreaks(3 * this->Envelope.GetFace() + k);
    }
    if (this->Field.HasSources())
    {
      places.push_back(0.0);
    }
    for (const double t : places)
    {
      std::array<double, 3> b = CoordinatesOnEdge(k, t);
      for (double& coordinate : b)
      {
        coordinate = Inset + (1.0 - 3.0 * Inset) * coordinate;
      }
      const FieldSample sample = this->Envelope.SampleAt(this->Envelope.PlaceOf(b));
      this->AddSource(sample);
      this->AddWave(sample, waves);
    }
  }
  for (std::size_t c = 2; mayHavePeak && c < waves.size(); ++c)
  {
    for (std::size_t b = 1; b < c; ++b)
    {
      for (std::size_t a = 0; a < b; ++a)
      {
        this->AddPeak(waves[a], waves[b], waves[c], waves);
      }
    }
  }
}

void FaceIsolines::AddSource(const FieldSample& sample)
{
  const Point2& place = sample.Image;
  if (!(LeastOf(this->Envelope.BarycentricOf(place)) > OnRim))
  {
    return;
  }
  const double distance = this->Envelope.At(place);
  if (!this->Levels.empty() && !(distance < this->Levels.back()))
  {
    return; // all levels are below
  }
  this->AddSeed({ place, distance, false });
}

/// Adds a seed unless one exists at its position.
void FaceIsolines::AddSeed(const Seed& seed)
{
  const double close = 1e-6 * this->Field.Mesh->Length(3 * this->Envelope.GetFace());
  if (std::none_of(this->Seeds.begin(), this->Seeds.end(),
        [&](const Seed& known) { return Distance(known.Place, seed.Place) <= close; }))
  {
    this->Seeds.push_back(seed);
  }
}

/// Adds a wavefront unless its source is known. A source may be visible through several windows.
void FaceIsolines::AddWave(const FieldSample& wave, std::vector<FieldSample>& waves) const
{
  const double length = this->Field.Mesh->Length(3 * this->Envelope.GetFace());
  const bool isKnown = std::any_of(waves.begin(), waves.end(),
    [&](const FieldSample& known) { return HaveOneSource(known, wave, length); });
  if (!isKnown && wave.HasImage && waves.size() < MostWaves)
  {
    waves.push_back(wave);
  }
}

/// Adds the maximum, around which isolines may be closed, at which three wavefronts meet from all
/// sides. If another wavefront is shorter at the meeting point, adds this wavefront instead.
void FaceIsolines::AddPeak(const FieldSample& first, const FieldSample& second,
  const FieldSample& third, std::vector<FieldSample>& waves)
{
  // The maximum lies inside the triangle of the images, which must therefore overlap the face.
  const std::array<Point2, 3> images{ { first.Image, second.Image, third.Image } };
  const double turn = Cross(Difference(images[1], images[0]), Difference(images[2], images[0]));
  const auto isInside = [&](int k, const Point2& p) {
    return turn * Cross(Difference(images[(k + 1) % 3], images[k]), Difference(p, images[k])) > 0.0;
  };
  const std::array<Point2, 3>& corners = this->Envelope.GetCorners();
  const std::array<std::array<double, 3>, 3> b{ { this->Envelope.BarycentricOf(images[0]),
    this->Envelope.BarycentricOf(images[1]), this->Envelope.BarycentricOf(images[2]) } };
  for (int k = 0; k < 3; ++k)
  {
    if (std::max({ b[0][k], b[1][k], b[2][k] }) <= OnRim ||
      (!isInside(k, corners[0]) && !isInside(k, corners[1]) && !isInside(k, corners[2])))
    {
      return;
    }
  }
  Point2 place = this->Envelope.PlaceOf({ { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
  if (!MoveToTie(first, second, third, place) || !isInside(0, place) || !isInside(1, place) ||
    !isInside(2, place) || !(LeastOf(this->Envelope.BarycentricOf(place)) > OnRim))
  {
    return;
  }
  const FieldSample nearest = this->Envelope.SampleAt(place);
  const double tolerance = TieTolerance * Distance(corners[0], corners[1]);
  if (nearest.Distance < DistanceFromSource(first, place) - tolerance)
  {
    this->AddWave(nearest, waves);
  }
  else
  {
    this->AddSeed({ place, nearest.Distance, true });
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
    const Id h = 3 * this->Envelope.GetFace() + k;
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
    this->Rim.IsAbove[k] = this->Envelope.GetCornerDistance(k) >= this->Levels[level];
  }
}

LevelPoint FaceIsolines::EvaluateCrossing(const LevelArc& arc, Id crossing) const
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const LevelCrossing& c = this->Crossings.Crossings[crossing];
  const auto side = std::find(this->Edges.begin(), this->Edges.end(), c.HalfEdge);
  const auto k = static_cast<int>(side - this->Edges.begin());
  const double t = c.X / mesh.Length(c.HalfEdge);
  const bool isSame = mesh.Origin(c.HalfEdge) == mesh.Origin(3 * this->Envelope.GetFace() + k);
  return arc.Evaluate(this->Envelope.PlaceOf(CoordinatesOnEdge(k, isSame ? t : 1.0 - t)));
}

Id FaceIsolines::TraceLevel(Id level, std::vector<FaceCurve>& curves)
{
  const double value = this->Levels[level];
  const LevelArc arc(this->Envelope, value, this->Tolerance);
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
    this->Triangles.Build(this->Envelope, arc, value, this->Rim, cells, this->SeedsOfLevel);
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
  const bool isWithinTolerance = this->TraceChain(arc, chain, level, curve);
  if (isWithinTolerance)
  {
    curves.push_back(std::move(curve));
  }
  return isWithinTolerance;
}

/// Traces a chain, skipping points that are not at the level, except for crossings on the boundary.
/// Returns true if the curve is within the tolerance of the level set.
bool FaceIsolines::TraceChain(
  const LevelArc& arc, const LevelChain& chain, Id level, FaceCurve& curve)
{
  curve.Face = this->Envelope.GetFace();
  curve.Level = level;
  curve.First = chain.First;
  curve.Last = chain.Last;
  this->Curve.clear();
  if (chain.First != NoId)
  {
    this->Curve.push_back(this->EvaluateCrossing(arc, chain.First));
  }
  std::copy_if(chain.Points.begin(), chain.Points.end(), std::back_inserter(this->Curve),
    [](const LevelPoint& point) { return point.IsOnLevel; });
  this->Points.clear();
  if (chain.First != NoId)
  {
    this->Curve.push_back(this->EvaluateCrossing(arc, chain.Last));
  }
  else if (!this->Curve.empty())
  {
    this->Points.push_back(this->Curve.front().Place);
    this->Curve.emplace_back(this->Curve.front());
  }
  bool isWithinTolerance = true;
  for (std::size_t i = 1; i < this->Curve.size(); ++i)
  {
    const LevelPoint& from = this->Curve[i - 1];
    const LevelPoint& to = this->Curve[i];
    const bool isClose = arc.Refine(from, to, this->Points);
    isWithinTolerance = isWithinTolerance && (isClose || !from.IsOnLevel || !to.IsOnLevel);
    if (i + 1 < this->Curve.size())
    {
      this->Points.push_back(to.Place);
    }
  }
  curve.Points.reserve(this->Points.size());
  for (const Point2& place : this->Points)
  {
    curve.Points.push_back(this->Envelope.BarycentricOf(place));
  }
  return isWithinTolerance;
}
}
