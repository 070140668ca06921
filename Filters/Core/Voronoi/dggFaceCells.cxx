// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceCells.h"

#include "dggBorderRefinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
using Coordinates = std::array<double, 3>;

double Apply(const Coordinates& values, const Coordinates& place)
{
  return values[0] * place[0] + values[1] * place[1] + values[2] * place[2];
}

double Difference(const Coordinates& a, const Coordinates& b)
{
  return std::max(std::abs(a[0] - b[0]), std::max(std::abs(a[1] - b[1]), std::abs(a[2] - b[2])));
}

Coordinates Between(const Coordinates& a, const Coordinates& b, double t)
{
  return { { (1.0 - t) * a[0] + t * b[0], (1.0 - t) * a[1] + t * b[1],
    (1.0 - t) * a[2] + t * b[2] } };
}

/// Returns the term of the squared distance that all sites have in common: minus the sum of b_i b_j
/// l_ij^2 over i < j.
double CommonPart(const SurfaceMesh& mesh, Id face, const Coordinates& place)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double length = mesh.Length(3 * face + k);
    sum -= place[k] * place[(k + 1) % 3] * length * length;
  }
  return sum;
}
}

double FaceCell::GetFraction() const
{
  double fraction = 0.0;
  for (std::size_t i = 1; i + 1 < this->Points.size(); ++i)
  {
    const Coordinates& a = this->Points[0].Place;
    const Coordinates& b = this->Points[i].Place;
    const Coordinates& c = this->Points[i + 1].Place;
    fraction += (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  }
  return fraction;
}

void FaceCell::AddTo(const SurfaceMesh& mesh, Id face, VoronoiDiagram& diagram) const
{
  for (const CellPoint& point : this->Points)
  {
    diagram.PolygonPoints.push_back(point.Number);
  }
  const Id h = 3 * face;
  diagram.PolygonOffsets.push_back(static_cast<Offset>(diagram.PolygonPoints.size()));
  diagram.PolygonSites.push_back(this->Site);
  diagram.PolygonFaces.push_back(face);
  diagram.PolygonAreas.push_back(this->GetFraction() * 0.5 * mesh.Length(h) * mesh.ApexY(h));
}

FaceCells::FaceCells(const SurfaceMesh& mesh, const SiteDistances& distances, const EdgeCuts& cuts,
  const BorderRefinement* refinement, VoronoiDiagram& diagram)
  : Mesh(mesh)
  , Distances(distances)
  , Cuts(cuts)
  , Refinement(refinement)
  , Diagram(diagram)
{
}

void FaceCells::Cut(Id face)
{
  const std::array<Id, 3> corners = this->Mesh.GetTriangle(face);
  const std::vector<Id>& nearest = this->Diagram.NearestSites;
  if (nearest[corners[0]] == nearest[corners[1]] && nearest[corners[1]] == nearest[corners[2]])
  {
    this->AddWhole(face);
    return;
  }
  this->WalkAround(face);
  const std::size_t numberOfPoints = this->Diagram.BorderPoints.size();
  this->CutByLines(face);
  if (!this->IsConsistent())
  {
    this->Diagram.BorderPoints.resize(numberOfPoints);
    this->Diagram.BorderDistances.resize(numberOfPoints);
    this->CutFromCenter(face);
  }
  if (this->Refinement && !this->Diagram.AreBordersWrong)
  {
    this->CheckBorders(face);
  }
  for (const FaceCell& cell : this->Cells)
  {
    cell.AddTo(this->Mesh, face, this->Diagram);
  }
}

/// Collects the cuts of the sides, and the segments between them.
void FaceCells::WalkAround(Id face)
{
  this->Around.clear();
  this->Owners.clear();
  const auto add = [this](const CellPoint& point, Id owner) {
    if (!this->Around.empty() && this->Around.back().Number == point.Number)
    {
      this->Owners.back() = owner;
      return;
    }
    this->Around.push_back(point);
    this->Owners.push_back(owner);
  };
  for (int k = 0; k < 3; ++k)
  {
    this->Sides[k] = this->Cuts.Of(3 * face + k);
    const Id corner = this->Mesh.Origin(3 * face + k);
    add({ corner, CoordinatesOfCorner(k) }, this->Diagram.NearestSites[corner]);
    for (const EdgeCut& cut : this->Sides[k])
    {
      add({ cut.Point,
            Between(CoordinatesOfCorner(k), CoordinatesOfCorner((k + 1) % 3), cut.Parameter) },
        cut.After);
    }
  }
  if (this->Around.back().Number == this->Around.front().Number)
  {
    this->Around.pop_back();
    this->Owners.pop_back();
  }
}

void FaceCells::CutByLines(Id face)
{
  this->Inside.clear();
  this->Refined.clear();
  this->Cells.clear();
  this->CollectSites(face);
  for (std::size_t s = 0; s < this->Sites.size(); ++s)
  {
    Polygon polygon{ { CoordinatesOfCorner(0), 0 }, { CoordinatesOfCorner(1), 1 },
      { CoordinatesOfCorner(2), 2 } };
    this->Clip(s, polygon);
    std::vector<CellPoint> points;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const int before = polygon[(i + polygon.size() - 1) % polygon.size()].Border;
      points.push_back(this->PointOf(face, s, before, polygon[i]));
    }
    this->AddCell(this->Sites[s].Number, points);
  }
}

/// Returns true if every side of a cell is also a side of another cell, or a segment of the
/// boundary.
bool FaceCells::IsConsistent() const
{
  using Side = std::pair<Id, Id>;
  std::vector<Side> sides;
  for (const FaceCell& cell : this->Cells)
  {
    for (std::size_t i = 0; i < cell.Points.size(); ++i)
    {
      sides.emplace_back(cell.Points[i].Number, cell.Points[(i + 1) % cell.Points.size()].Number);
    }
  }
  for (std::size_t i = 0; i < this->Around.size(); ++i)
  {
    sides.emplace_back(this->Around[(i + 1) % this->Around.size()].Number, this->Around[i].Number);
  }
  std::vector<Side> opposite;
  opposite.reserve(sides.size());
  for (const Side& side : sides)
  {
    opposite.emplace_back(side.second, side.first);
  }
  std::sort(sides.begin(), sides.end());
  std::sort(opposite.begin(), opposite.end());
  // After refinement cells need not be convex, but must not be inverted.
  return sides == opposite && std::adjacent_find(sides.begin(), sides.end()) == sides.end() &&
    std::all_of(this->Cells.begin(), this->Cells.end(),
      [](const FaceCell& cell) { return cell.GetFraction() >= -1e-12; });
}

/// Checks the borders between two cells halfway between their ends.
void FaceCells::CheckBorders(Id face)
{
  struct Side
  {
    std::array<Id, 2> Ends; // in ascending order
    Coordinates Middle;
    const FaceCell* Cell;
  };
  std::vector<Side> sides;
  for (const FaceCell& cell : this->Cells)
  {
    const CellPoint* before = &cell.Points.back();
    for (const CellPoint& point : cell.Points)
    {
      const auto [first, last] = std::minmax(before->Number, point.Number);
      sides.push_back({ { { first, last } }, Between(before->Place, point.Place, 0.5), &cell });
      before = &point;
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.Ends, a.Cell->Site) < std::tie(b.Ends, b.Cell->Site);
  });
  for (std::size_t i = 0; i + 1 < sides.size() && !this->Diagram.AreBordersWrong; ++i)
  {
    const Side& side = sides[i];
    if (side.Ends == sides[i + 1].Ends) // not on the boundary of the face
    {
      const std::array<Id, 2> sites{ { side.Cell->Site, sides[i + 1].Cell->Site } };
      this->Diagram.AreBordersWrong = this->Refinement->IsWrong(
        face, sites, side.Middle, this->MeasureAt(face, sites[0], side.Middle));
    }
  }
}

void FaceCells::CutFromCenter(Id face)
{
  this->Inside.clear();
  this->Refined.clear();
  this->Cells.clear();
  const std::size_t size = this->Around.size();
  std::vector<std::size_t> changes; // indices where the owner changes
  Coordinates middle{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 0; i < size; ++i)
  {
    if (this->Owners[i] != this->Owners[(i + size - 1) % size])
    {
      changes.push_back(i);
      for (int k = 0; k < 3; ++k)
      {
        middle[k] += this->Around[i].Place[k];
      }
    }
  }
  if (changes.size() < 2)
  {
    this->AddCell(this->Owners[0], this->Around);
    return;
  }
  CellPoint hub = this->Around[changes[1]];
  if (changes.size() > 2)
  {
    double squaredDistance = Infinity;
    for (double& coordinate : middle)
    {
      coordinate /= static_cast<double>(changes.size());
    }
    for (const Site& site : this->Sites)
    {
      squaredDistance = std::min(squaredDistance, Apply(site.Values, middle));
    }
    std::array<Id, 3> owners{ { this->Owners[changes[0]], this->Owners[changes[1]],
      this->Owners[changes[2]] } };
    std::sort(owners.begin(), owners.end());
    hub = this->PointInside(face, changes.size() == 3 ? owners : std::array<Id, 3>{}, middle,
      squaredDistance + CommonPart(this->Mesh, face, middle));
  }
  for (std::size_t c = 0; c < changes.size(); ++c)
  {
    const std::size_t begin = changes[c];
    const std::size_t end = changes[(c + 1) % changes.size()];
    std::vector<CellPoint> points{ this->Around[begin] };
    for (std::size_t i = begin; i != end;)
    {
      i = i + 1 < size ? i + 1 : 0;
      points.push_back(this->Around[i]);
    }
    points.push_back(hub);
    this->AddCell(this->Owners[begin], points);
  }
}

void FaceCells::AddWhole(Id face)
{
  std::vector<CellPoint> points;
  points.reserve(3);
  for (int k = 0; k < 3; ++k)
  {
    points.push_back({ this->Mesh.Origin(3 * face + k), CoordinatesOfCorner(k) });
  }
  FaceCell{ this->Diagram.NearestSites[points[0].Number], points }.AddTo(
    this->Mesh, face, this->Diagram);
}

/// Collects all sites that are known at every corner, and those on the sides.
void FaceCells::CollectSites(Id face)
{
  std::vector<Id> numbers;
  for (int k = 0; k < 3; ++k)
  {
    const Id v = this->Mesh.Origin(3 * face + k);
    for (const SiteDistances::Entry* e = this->Distances.Begin(v); e != this->Distances.End(v); ++e)
    {
      numbers.push_back(e->Site);
    }
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  this->Sites.clear();
  for (const Id number : numbers)
  {
    Coordinates distances{ { Infinity, Infinity, Infinity } };
    int known = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Id v = this->Mesh.Origin(3 * face + k);
      const SiteDistances::Entry* entry = this->Distances.Find(v, number);
      distances[k] = entry ? entry->Distance : Infinity;
      known += entry ? 1 : 0;
    }
    bool isOnSide = false;
    for (const std::vector<EdgeCut>& side : this->Sides)
    {
      for (const EdgeCut& cut : side)
      {
        isOnSide = isOnSide || cut.Before == number || cut.After == number;
      }
    }
    if (known < 3 && !isOnSide)
    {
      continue; // too far away, see SiteDistances
    }
    Coordinates values{};
    for (int k = 0; k < 3; ++k)
    {
      const double along = std::min(distances[(k + 1) % 3] + this->Mesh.Length(3 * face + k),
        distances[(k + 2) % 3] + this->Mesh.Length(3 * face + (k + 2) % 3));
      const double distance = distances[k] < Infinity ? distances[k] : along;
      values[k] = distance * distance;
    }
    this->Sites.push_back({ number, values });
  }
}

/// Clips a polygon to the region where a site is nearest (Sutherland and Hodgman, "Reentrant
/// polygon clipping", 1974).
void FaceCells::Clip(std::size_t site, Polygon& polygon) const
{
  const Coordinates& own = this->Sites[site].Values;
  Polygon kept;
  for (std::size_t other = 0; other < this->Sites.size() && !polygon.empty(); ++other)
  {
    if (other == site)
    {
      continue;
    }
    const Coordinates& values = this->Sites[other].Values;
    const Coordinates ahead{ { values[0] - own[0], values[1] - own[1], values[2] - own[2] } };
    if (ahead == Coordinates{ { 0.0, 0.0, 0.0 } })
    {
      if (other < site)
      {
        polygon.clear(); // equal distances everywhere
      }
      continue;
    }
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Corner& from = polygon[i];
      const Corner& to = polygon[(i + 1) % polygon.size()];
      const double start = Apply(ahead, from.Place);
      const double end = Apply(ahead, to.Place);
      const int border = 3 + static_cast<int>(other);
      if (start >= 0.0)
      {
        kept.push_back(from);
        if (end < 0.0 && start > 0.0)
        {
          kept.push_back({ Between(from.Place, to.Place, start / (start - end)), border });
        }
        else if (end < 0.0)
        {
          kept.back().Border = border; // leaves at the corner itself
        }
      }
      else if (end > 0.0)
      {
        kept.push_back({ Between(from.Place, to.Place, start / (start - end)), from.Border });
      }
    }
    polygon.swap(kept);
  }
}

/// Returns the point of the diagram at a corner of a polygon, between two of its sides.
CellPoint FaceCells::PointOf(Id face, std::size_t site, int before, const Corner& corner)
{
  const int after = corner.Border;
  const Id number = this->Sites[site].Number;
  if (before < 3 && after < 3)
  {
    if ((before + 1) % 3 == after)
    {
      return { this->Mesh.Origin(3 * face + after), CoordinatesOfCorner(after) };
    }
  }
  else if (before < 3 || after < 3)
  {
    const int side = std::min(before, after);
    const Id other = this->Sites[std::max(before, after) - 3].Number;
    return this->PointOnSide(face, side, number, other, corner.Place);
  }
  const double squaredDistance =
    Apply(this->Sites[site].Values, corner.Place) + CommonPart(this->Mesh, face, corner.Place);
  const Id first = this->Sites[std::max(before, 3) - 3].Number;
  const Id second = this->Sites[std::max(after, 3) - 3].Number;
  std::array<Id, 3> sites{ { number, first, second } };
  std::sort(sites.begin(), sites.end());
  return this->PointInside(face, sites, corner.Place, squaredDistance);
}

/// Returns the cut of a side between two sites; if rounding has removed it, the nearest cut of that
/// side.
CellPoint FaceCells::PointOnSide(
  Id face, int side, Id site, Id other, const Coordinates& place) const
{
  const double parameter = place[(side + 1) % 3];
  CellPoint best{ this->Mesh.Origin(3 * face + side), CoordinatesOfCorner(side) };
  double miss = parameter;
  const auto offer = [&](Id number, double t, double distance) {
    if (distance < miss)
    {
      miss = distance;
      best = { number, Between(CoordinatesOfCorner(side), CoordinatesOfCorner((side + 1) % 3), t) };
    }
  };
  offer(this->Mesh.Destination(3 * face + side), 1.0, 1.0 - parameter);
  for (const EdgeCut& cut : this->Sides[side])
  {
    const bool isBorder =
      (cut.Before == site && cut.After == other) || (cut.Before == other && cut.After == site);
    offer(cut.Point, cut.Parameter, isBorder ? -1.0 : std::abs(cut.Parameter - parameter));
  }
  return best;
}

/// Returns a point in a face: an existing one at the same position, otherwise a new one.
CellPoint FaceCells::PointInside(
  Id face, const std::array<Id, 3>& sites, Coordinates place, double squaredDistance)
{
  for (int k = 0; k < 3; ++k)
  {
    if (Difference(place, CoordinatesOfCorner(k)) < SamePlace)
    {
      return { this->Mesh.Origin(3 * face + k), CoordinatesOfCorner(k) };
    }
    for (const EdgeCut& cut : this->Sides[k])
    {
      const Coordinates there =
        Between(CoordinatesOfCorner(k), CoordinatesOfCorner((k + 1) % 3), cut.Parameter);
      if (Difference(place, there) < SamePlace)
      {
        return { cut.Point, there };
      }
    }
  }
  for (std::size_t i = 0; i < this->Inside.size(); ++i)
  {
    if (Difference(place, this->Inside[i].Place) < SamePlace)
    {
      return this->Refined[i];
    }
  }
  const auto number =
    static_cast<Id>(this->Diagram.Distances.size() + this->Diagram.BorderPoints.size());
  this->Inside.push_back({ number, place });
  double distance = std::sqrt(std::max(0.0, squaredDistance));
  const bool isTriple = sites[0] != sites[1] && sites[1] != sites[2];
  if (this->Refinement && isTriple)
  {
    this->Refinement->Balance(face, sites, place, distance);
  }
  this->Diagram.BorderPoints.push_back(SurfacePoint::InTriangle(this->Mesh, face, place));
  this->Diagram.BorderDistances.push_back(distance);
  this->Refined.push_back({ number, place });
  return this->Refined.back();
}

/// Returns the interpolated distance of a point in the face from a site.
double FaceCells::MeasureAt(Id face, Id site, const Coordinates& place) const
{
  const auto found = std::find_if(this->Sites.begin(), this->Sites.end(),
    [site](const Site& candidate) { return candidate.Number == site; });
  const double common = CommonPart(this->Mesh, face, place);
  return found == this->Sites.end()
    ? Infinity
    : std::sqrt(std::max(0.0, Apply(found->Values, place) + common));
}

/// Adds a cell with the given points, without consecutive duplicates. Skipped if it has no area.
void FaceCells::AddCell(Id site, const std::vector<CellPoint>& points)
{
  std::vector<CellPoint> distinct;
  for (const CellPoint& point : points)
  {
    if (distinct.empty() || distinct.back().Number != point.Number)
    {
      distinct.push_back(point);
    }
  }
  while (distinct.size() > 1 && distinct.front().Number == distinct.back().Number)
  {
    distinct.pop_back();
  }
  if (distinct.size() >= 3)
  {
    this->Cells.push_back({ site, distinct });
  }
}
}
