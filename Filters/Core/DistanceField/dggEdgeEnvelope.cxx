// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEdgeEnvelope.h"

#include "dggEdges.h"
#include "dggRootFinding.h"
#include "dggSurfacePoint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace dgg
{
namespace
{
/// Tolerance of visibility through a window: a point this close to the end of a window is visible
/// through the window. Relative (dggWindow.h).
constexpr double WindowSlack = 1e-9;
/// Number of intervals into which an edge is divided to find extrema between models.
constexpr int NumberOfModelBreaks = 8;
/// Finite-difference step for slopes, relative to the search interval of a crest, and width of an
/// interval that is considered converged, relative to the edge length.
constexpr double SlopeStep = 1e-3;
constexpr double NarrowestCrest = 1e-10;
/// Upper bound, with a margin, of the rounding error of a model, relative to the edge length and to
/// the distance.
constexpr double SlackOfLength = 1e-9;
constexpr double SlackOfDistance = 1e-12;
/// Stopping criteria of the search for a root: relative difference from the level, and the number
/// of steps that bisection needs.
constexpr double Rounding = 4e-16;
constexpr int MaximumSteps = 80;
/// Distance from the ends of an interval, relative to its length, at which the shortest piece is
/// determined.
constexpr double InsetOfChanges = 1e-6;
/// Largest number of changes per piece; more are rounding.
constexpr std::size_t MostChanges = 8;
}

void EdgeEnvelope::Enter(Id h)
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const Id representative = FindEdge(mesh, h);
  if (representative == this->HalfEdge)
  {
    return;
  }
  this->HalfEdge = representative;
  this->Length = mesh.Length(representative);
  this->Ends = { { this->Field.Distances[mesh.Origin(representative)],
    this->Field.Distances[mesh.Destination(representative)] } };
  this->Breaks.clear();
  if (this->Field.HasWindows())
  {
    this->Pieces.clear();
    ForEachHalfEdge(mesh, representative, [&](Id e) {
      this->CollectWindows(e);
      this->CollectSources(e);
    });
    if (mesh.Twin(representative) == NoId)
    {
      this->CollectThroughFace(representative); // outgoing boundary windows are not stored
    }
    this->FindWindowBreaks();
  }
  else
  {
    this->SetUpFaces();
    const int count = this->Field.HasSources() ? NumberOfModelBreaks : 1;
    for (int i = 0; i <= count; ++i)
    {
      this->Breaks.push_back(i == count ? this->Length : this->Length * i / count);
    }
  }
  // A model changes at most as fast as the distance from its source plus the amount by which the
  // model is raised, a linear field by its slope, and exact distances as fast as the distance.
  double raise = std::max(0.0, std::abs(this->Ends[1] - this->Ends[0]) - this->Length);
  for (std::size_t i = 0; i < this->NumberOfFaces; ++i)
  {
    raise = std::max(raise, this->Faces[i].Envelope.GetLargestRaise());
  }
  this->Steepness = 1.0 + raise / this->Length;
  BreakState state;
  state.IsSearched = this->Field.HasWindows(); // then breaks separate extrema
  this->BreakStates.assign(this->Breaks.size(), state);
}

std::vector<double> EdgeEnvelope::FindPlacesBetweenBreaks(Id h)
{
  this->Enter(h);
  std::vector<double> breaks = this->Breaks;
  const bool isSame = this->Field.Mesh->Origin(h) == this->Field.Mesh->Origin(this->HalfEdge);
  for (double& x : breaks)
  {
    x = isSame ? x / this->Length : 1.0 - x / this->Length;
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> places;
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    places.push_back(0.5 * (breaks[i - 1] + breaks[i]));
  }
  return places;
}

void EdgeEnvelope::CollectWindows(Id h)
{
  const bool isSame = this->Field.Mesh->Origin(h) == this->Field.Mesh->Origin(this->HalfEdge);
  for (const EdgeWindow* w = this->Field.Windows->Begin(h); w != this->Field.Windows->End(h); ++w)
  {
    Piece piece{ w->Begin, w->End, w->Image, w->Offset,
      std::max(1e-15 * this->Length, WindowSlack * std::min(this->Length, -w->Image.Y)) };
    if (!isSame)
    {
      piece.Begin = this->Length - w->End;
      piece.End = this->Length - w->Begin;
      piece.Image.X = this->Length - w->Image.X;
    }
    this->Pieces.push_back(piece);
  }
}

/// Collects the sources in the face of the half-edge, which are visible from the entire edge.
void EdgeEnvelope::CollectSources(Id h)
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const std::vector<FaceSource>& sources = this->Field.Windows->Sources;
  const Id f = SurfaceMesh::Face(h);
  auto source = std::lower_bound(
    sources.begin(), sources.end(), f, [](const FaceSource& s, Id face) { return s.Face < face; });
  for (; source != sources.end() && source->Face == f; ++source)
  {
    Point2 image = PlaceInFrame(mesh, h, source->Barycentric);
    if (mesh.Origin(h) != mesh.Origin(this->HalfEdge))
    {
      image.X = this->Length - image.X;
    }
    this->Pieces.push_back({ 0.0, this->Length, image, source->Offset, 0.0 });
  }
}

/// Collects the pieces that reach a boundary edge from within its face: the path through the apex,
/// and the windows of the other two sides.
void EdgeEnvelope::CollectThroughFace(Id h)
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const Point2 apex = ApexOf(mesh, h);
  this->Pieces.push_back({ 0.0, this->Length, apex, this->Field.Distances[mesh.Apex(h)], 0.0 });
  for (const Id side : { SurfaceMesh::Next(h), SurfaceMesh::Previous(h) })
  {
    const Point2 from = side == SurfaceMesh::Next(h) ? Point2{ this->Length, 0.0 } : apex;
    const Point2 to = side == SurfaceMesh::Next(h) ? apex : Point2{};
    const double length = mesh.Length(side);
    const Point2 axis{ (to.X - from.X) / length, (to.Y - from.Y) / length };
    for (const EdgeWindow* w = this->Field.Windows->Begin(side);
         w != this->Field.Windows->End(side); ++w)
    {
      const Point2 image = FromFrame(from, axis, w->Image);
      // Returns the intersection of the ray through a point of the side with the edge. The ray may
      // diverge from the edge.
      auto meet = [&](double x) {
        const Point2 p = FromFrame(from, axis, { x, 0.0 });
        const double fall = image.Y - p.Y;
        const double away = side == SurfaceMesh::Next(h) ? 0.0 : this->Length;
        const double reach = fall > 0.0 ? image.X + (p.X - image.X) * (image.Y / fall) : away;
        return std::min(this->Length, std::max(0.0, reach));
      };
      // Abscissae run from the destination of h towards its origin, in the direction of the sides.
      const double end = meet(w->Begin);
      const double begin = meet(w->End);
      if (begin < end)
      {
        this->Pieces.push_back({ begin, end, image, w->Offset,
          std::max(1e-15 * this->Length, WindowSlack * std::min(this->Length, image.Y)) });
      }
    }
  }
}

/// Divides the edge so that between two breaks a single window or source, or the path along the
/// edge from a single end, is the shortest and monotone.
void EdgeEnvelope::FindWindowBreaks()
{
  const std::vector<Piece> paths{ { 0.0, this->Length, {}, this->Ends[0], 0.0 },
    { 0.0, this->Length, { this->Length, 0.0 }, this->Ends[1], 0.0 } };
  std::vector<double> ends{ 0.0, this->Length };
  for (const Piece& piece : this->Pieces)
  {
    ends.push_back(std::max(0.0, piece.Begin));
    ends.push_back(std::min(this->Length, piece.End));
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  this->Breaks = ends;
  std::vector<Piece> pieces;
  std::vector<double> inside;
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    pieces = paths;
    inside.clear();
    std::copy_if(this->Pieces.begin(), this->Pieces.end(), std::back_inserter(pieces),
      [&](const Piece& piece) { return piece.Begin <= ends[i - 1] && piece.End >= ends[i]; });
    this->Divide(pieces, ends[i - 1], ends[i], inside);
    this->Breaks.insert(this->Breaks.end(), inside.begin(), inside.end());
  }
  for (const Piece& piece : this->Pieces)
  {
    if (piece.Image.X > piece.Begin && piece.Image.X < piece.End)
    {
      this->Breaks.push_back(piece.Image.X);
    }
  }
  std::sort(this->Breaks.begin(), this->Breaks.end());
  this->Breaks.erase(std::unique(this->Breaks.begin(), this->Breaks.end()), this->Breaks.end());
}

double EdgeEnvelope::DistanceOf(const Piece& piece, double x)
{
  return piece.Offset + DistanceToAxis(piece.Image, x);
}

const EdgeEnvelope::Piece& EdgeEnvelope::ShortestOf(
  const std::vector<Piece>& pieces, double x) const
{
  return *std::min_element(pieces.begin(), pieces.end(),
    [&](const Piece& a, const Piece& b) { return DistanceOf(a, x) < DistanceOf(b, x); });
}

/// Finds the changes between two abscissae on pieces that cover the interval between them.
void EdgeEnvelope::Divide(
  const std::vector<Piece>& pieces, double begin, double end, std::vector<double>& changes) const
{
  const double inset = InsetOfChanges * (end - begin); // pieces may end at ties
  const Piece& first = this->ShortestOf(pieces, begin + inset);
  const Piece& last = this->ShortestOf(pieces, end - inset);
  const double rounding = SlackOfDistance * (DistanceOf(first, begin) + DistanceOf(last, end));
  double change = begin;
  if (DistanceOf(first, end - inset) > DistanceOf(last, end - inset) + rounding)
  {
    change = Bisect(begin, end, 0.0, MaximumSteps,
      [&](double x) { return DistanceOf(first, x) < DistanceOf(last, x); });
  }
  else
  {
    // A third piece may be shorter in between. The difference of two distances is extreme on the
    // line through both images, and monotone on both sides.
    double least = -rounding;
    for (const Piece& piece : pieces)
    {
      const double y = std::abs(first.Image.Y);
      const double rise = std::abs(piece.Image.Y) - y;
      const double x = first.Image.X - (piece.Image.X - first.Image.X) * y / rise;
      const double gain = x > begin && x < end ? DistanceOf(piece, x) - DistanceOf(first, x) : 0.0;
      if (gain < least)
      {
        least = gain;
        change = x;
      }
    }
  }
  const bool isRounding = changes.size() > MostChanges * pieces.size();
  if (change > begin + inset && change < end - inset && !isRounding)
  {
    changes.push_back(change);
    this->Divide(pieces, begin, change, changes);
    this->Divide(pieces, change, end, changes);
  }
}

/// Sets up the reached faces of the edge, through which wavefronts arrive.
void EdgeEnvelope::SetUpFaces()
{
  this->NumberOfFaces = 0;
  if (!this->Field.HasSources())
  {
    return;
  }
  const SurfaceMesh& mesh = *this->Field.Mesh;
  ForEachHalfEdge(mesh, this->HalfEdge, [&](Id e) {
    const Id f = SurfaceMesh::Face(e);
    if (this->Field.IsReached(f))
    {
      if (this->NumberOfFaces == this->Faces.size())
      {
        this->Faces.push_back({ FaceEnvelope(this->Field), {}, {} });
      }
      FaceOfEdge& face = this->Faces[this->NumberOfFaces++];
      face.Envelope.Enter(f);
      const int k = static_cast<int>(e - 3 * f);
      const bool isSame = mesh.Origin(e) == mesh.Origin(this->HalfEdge);
      face.From = face.Envelope.GetCorners()[isSame ? k : (k + 1) % 3];
      face.To = face.Envelope.GetCorners()[isSame ? (k + 1) % 3 : k];
    }
  });
}

double EdgeEnvelope::AtBreak(std::size_t i)
{
  BreakState& state = this->BreakStates[i];
  if (!state.HasDistance)
  {
    state.Distance = this->At(this->Breaks[i]);
    state.HasDistance = true;
  }
  return state.Distance;
}

/// Finds and returns the crest between a break and the next one, where two wavefronts meet and the
/// distance rises from either side.
const EdgeEnvelope::BreakState& EdgeEnvelope::FindCrest(std::size_t i)
{
  BreakState& state = this->BreakStates[i];
  if (state.IsSearched)
  {
    return state;
  }
  state.IsSearched = true;
  double begin = this->Breaks[i];
  double end = this->Breaks[i + 1];
  const double first = SlopeStep * (end - begin);
  if (!(first > NarrowestCrest * this->Length) || !(this->At(begin + first) > this->AtBreak(i)) ||
    !(this->At(end - first) > this->AtBreak(i + 1)))
  {
    return state;
  }
  while (end - begin > NarrowestCrest * this->Length)
  {
    const double middle = 0.5 * (begin + end);
    const bool isRising = this->At(middle + SlopeStep * (end - begin)) > this->At(middle);
    (isRising ? begin : end) = middle;
  }
  state.Crest = 0.5 * (begin + end);
  state.HasCrest = true;
  return state;
}

double EdgeEnvelope::At(double x) const
{
  if (x <= 0.0 || x >= this->Length)
  {
    return this->Ends[x > 0.0 ? 1 : 0];
  }
  const double t = x / this->Length;
  double least = Infinity;
  if (this->Field.HasWindows())
  {
    least = std::min(this->Ends[0] + x, this->Ends[1] + (this->Length - x));
  }
  else if (this->NumberOfFaces == 0) // linear
  {
    least = (1.0 - t) * this->Ends[0] + t * this->Ends[1];
  }
  for (const Piece& piece : this->Pieces)
  {
    if (x >= piece.Begin - piece.Slack && x <= piece.End + piece.Slack)
    {
      least = std::min(least, DistanceOf(piece, x));
    }
  }
  for (std::size_t i = 0; i < this->NumberOfFaces; ++i)
  {
    const FaceOfEdge& face = this->Faces[i];
    least = std::min(least,
      face.Envelope.At(
        { (1.0 - t) * face.From.X + t * face.To.X, (1.0 - t) * face.From.Y + t * face.To.Y }));
  }
  return least;
}

void EdgeEnvelope::FindCrossings(double level, std::vector<double>& crossings)
{
  this->CrossBetweenBreaks(level, 0, this->Breaks.size() - 1, crossings);
}

/// Bisects the interval between two breaks. Skips subintervals that cannot reach the
/// level, which make up most of an edge.
void EdgeEnvelope::CrossBetweenBreaks(
  double level, std::size_t first, std::size_t last, std::vector<double>& crossings)
{
  const Probe begin{ this->Breaks[first], this->AtBreak(first) - level };
  const Probe end{ this->Breaks[last], this->AtBreak(last) - level };
  const double change = this->Steepness * (end.X - begin.X) + SlackOfLength * this->Length +
    SlackOfDistance * std::abs(level);
  if ((begin.Height >= 0.0) == (end.Height >= 0.0) && std::abs(begin.Height + end.Height) > change)
  {
    return;
  }
  if (last - first > 1)
  {
    const std::size_t middle = (first + last) / 2;
    this->CrossBetweenBreaks(level, first, middle, crossings);
    this->CrossBetweenBreaks(level, middle, last, crossings);
    return;
  }
  const BreakState& state = this->FindCrest(first);
  if (!state.HasCrest)
  {
    this->Cross(level, begin, end, crossings);
    return;
  }
  const Probe crest{ state.Crest, this->At(state.Crest) - level };
  this->Cross(level, begin, crest, crossings);
  this->Cross(level, crest, end, crossings);
}

void EdgeEnvelope::Cross(
  double level, const Probe& begin, const Probe& end, std::vector<double>& crossings) const
{
  if ((begin.Height >= 0.0) != (end.Height >= 0.0))
  {
    const auto evaluate = [&](double x) { return Probe{ x, this->At(x) - level }; };
    crossings.push_back(FindRoot(begin, end, Rounding * std::abs(level), MaximumSteps, evaluate).X);
  }
}
}
