// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceCollection.h"

#include "dggCellCoordinates.h"
#include "dggCounted.h"
#include "dggLocator.h"
#include "dggPoint3.h"
#include "dggStatus.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
/// Rounding errors of positions, relative to the largest coordinate. Outputs of filters, which
/// identify points of inputs in double precision, may be in single precision.
constexpr double RoundingOfDoubles = 8.0 * std::numeric_limits<double>::epsilon();
constexpr double RoundingOfFloats = std::numeric_limits<float>::epsilon();

std::string Capitalize(std::string text)
{
  std::transform(text.begin(), text.begin() + (text.empty() ? 0 : 1), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

Status RefuseInitialDistance(const std::string& point, double distance)
{
  return InvalidInput(point, " has the initial distance ", distance)
    .At("InitialDistance")
    .Fix("Use a finite number");
}

/// Returns the point that an array names if it is at a position, otherwise NoId.
Offset FindOriginal(
  double id, const std::array<double, 3>& position, double rounding, const PreparedSurface& surface)
{
  const Id count = surface.GetMeshWithoutAngles().GetNumberOfVertices();
  if (!(id >= 0.0 && id < static_cast<double>(count)))
  {
    return NoId;
  }
  const auto point = static_cast<Offset>(id);
  const double* p = surface.GetPositions() + 3 * point;
  const double largest = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  const bool isThere = std::equal(p, p + 3, position.begin(),
    [&](double a, double b) { return std::abs(a - b) <= rounding * largest; });
  return isThere ? point : NoId;
}
}

//------------------------------------------------------------------------------
SourceCollection::Position SourceCollection::GetPosition(std::size_t i) const
{
  return { { this->Positions[3 * i], this->Positions[3 * i + 1], this->Positions[3 * i + 2] } };
}

//------------------------------------------------------------------------------
double SourceCollection::GetInitialDistanceOfId(std::size_t i) const
{
  return this->InitialDistancesOfIds.empty() ? 0.0 : this->InitialDistancesOfIds[i];
}

//------------------------------------------------------------------------------
double SourceCollection::GetInitialDistanceOfPosition(std::size_t i) const
{
  return this->InitialDistances.empty() ? 0.0 : this->InitialDistances[i];
}

//------------------------------------------------------------------------------
/// Returns a name such as "Source 3" or "End of pair 1".
std::string SourceCollection::Describe(std::size_t i) const
{
  const std::size_t end = this->Ids.size() + i;
  return this->ArePairs ? JoinText(end % 2 == 0 ? "Start" : "End", " of pair ", end / 2)
                        : JoinText(Capitalize(this->Role), " ",
                            this->Indices.empty() ? static_cast<Offset>(i) : this->Indices[i]);
}

//------------------------------------------------------------------------------
/// Returns a name such as "Source 3, at (x, y, z),".
std::string SourceCollection::DescribeWithPosition(std::size_t i) const
{
  const Position p = this->GetPosition(i);
  return JoinText(this->Describe(i), ", at (", p[0], ", ", p[1], ", ", p[2], "),");
}

//------------------------------------------------------------------------------
Status SourceCollection::Check(Offset numberOfPoints) const
{
  if (this->Ids.empty() && this->Positions.empty())
  {
    const Status status = InvalidInput(
      "There is no ", this->Role, this->IsConnected ? ": " + this->Input + " has no points" : "")
                            .At(this->Property);
    const bool hasIds = !this->Property.empty();
    return this->Input.empty()
      ? status.Fix("Set {", this->Property, "}")
      : status.Fix(hasIds ? "Set {" + this->Property + "}, or " : "",
          this->IsConnected ? (hasIds ? "add" : "Add") : (hasIds ? "connect" : "Connect"),
          " points to ", this->Input);
  }
  for (std::size_t i = 0; i < this->Ids.size(); ++i)
  {
    const Offset id = this->Ids[i];
    const double distance = this->GetInitialDistanceOfId(i);
    const bool isInRange = id >= 0 && id < numberOfPoints;
    if (isInRange && std::isfinite(distance))
    {
      continue;
    }
    const std::string name = JoinText(Capitalize(this->Role), " id ", id);
    return isInRange ? RefuseInitialDistance(name, distance)
                     : InvalidInput(name, " is out of range: the ", this->Surface, " has ",
                         Counted(numberOfPoints, "point"))
                         .At(this->Property, id)
                         .Fix("Use ids from 0 to ", numberOfPoints - 1);
  }
  for (std::size_t i = 0; i < this->GetNumberOfPositions(); ++i)
  {
    const double distance = this->GetInitialDistanceOfPosition(i);
    if (!IsFinite(PointAt(this->Positions.data(), static_cast<Id>(i))))
    {
      return InvalidInput(this->DescribeWithPosition(i), " has coordinates that are not finite")
        .At("", static_cast<Offset>(i))
        .Fix("Move or remove the point");
    }
    if (!std::isfinite(distance))
    {
      return RefuseInitialDistance(this->Describe(i), distance);
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status SourceCollection::Locate(const SurfaceArrays& input, const PreparedSurface& surface,
  double tolerance, std::vector<GeodesicSource>& sources) const
{
  sources.clear();
  DGG_RETURN_IF_ERROR(this->Check(surface.GetMeshWithoutAngles().GetNumberOfVertices()));
  for (std::size_t i = 0; i < this->Ids.size(); ++i)
  {
    sources.push_back(
      { SurfacePoint::AtVertex(surface.GetVertex(this->Ids[i])), this->GetInitialDistanceOfId(i) });
  }
  const CellCoordinates cells(input, surface);
  for (std::size_t i = 0; i < this->GetNumberOfPositions(); ++i)
  {
    Position position = this->GetPosition(i);
    GeodesicSource source{ {}, this->GetInitialDistanceOfPosition(i) };
    bool isFound = false;
    DGG_RETURN_IF_ERROR(this->Identify(i, cells, surface, position, source.Point, isFound));
    DGG_RETURN_IF_ERROR(isFound ? Status::Success()
                                : this->FindClosest(i, surface, tolerance, position, source.Point));
    sources.push_back(source);
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status SourceCollection::Locate(const TaskContext& context, double tolerance,
  std::vector<GeodesicSource>& sources, std::vector<std::string>* warnings) const
{
  const SurfaceArrays none;
  const SurfaceArrays& cells = this->Barycentric.empty() ? none : context.GetCells();
  DGG_RETURN_IF_ERROR(this->Locate(cells, context.Surface, tolerance, sources));
  const std::string warning =
    warnings ? this->DescribeIsolated(context.Surface, sources) : std::string();
  if (!warning.empty())
  {
    warnings->push_back(warning);
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status SourceCollection::Locate(const TaskContext& context, double tolerance,
  std::vector<SurfacePoint>& points, std::vector<std::string>* warnings) const
{
  std::vector<GeodesicSource> sources;
  DGG_RETURN_IF_ERROR(this->Locate(context, tolerance, sources, warnings));
  points = GetPoints(sources);
  return Status::Success();
}

//------------------------------------------------------------------------------
/// Finds the surface point that the arrays identify and sets `isFound`. If the cell has no area,
/// moves `position` to the point in the cell.
Status SourceCollection::Identify(std::size_t i, const CellCoordinates& cells,
  const PreparedSurface& surface, Position& position, SurfacePoint& point, bool& isFound) const
{
  const double rounding = this->AreRounded ? RoundingOfFloats : RoundingOfDoubles;
  const bool hasIds = !this->OriginalIds.empty();
  if (!this->Cells.empty() && !this->Barycentric.empty())
  {
    const Position weights = { { this->Barycentric[3 * i], this->Barycentric[3 * i + 1],
      this->Barycentric[3 * i + 2] } };
    const Status status = cells.Check(this->Cells[i], weights);
    if (!hasIds && !status.IsOk())
    {
      return status.Of(this->Describe(i));
    }
    const auto cell = static_cast<Offset>(status.IsOk() ? this->Cells[i] : 0.0);
    if (status.IsOk() && (!hasIds || cells.IsAt(cell, weights, position, rounding)))
    {
      isFound = cells.FindPoint(cell, weights, point);
      position = cells.GetPosition(cell, weights);
      return Status::Success();
    }
  }
  const Offset original =
    hasIds ? FindOriginal(this->OriginalIds[i], position, rounding, surface) : NoId;
  if (original != NoId)
  {
    point = SurfacePoint::AtVertex(surface.GetVertex(original));
    isFound = true;
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status SourceCollection::FindClosest(std::size_t i, const PreparedSurface& surface,
  double tolerance, const Position& position, SurfacePoint& point) const
{
  const Locator& locator = surface.GetLocator();
  const double farthest = tolerance * locator.GetDiagonal();
  double distance = Infinity;
  if (locator.FindClosestPoint(position.data(), point, distance) &&
    locator.IsClose(point, distance, farthest))
  {
    return Status::Success();
  }
  return this->RefuseDistant(i, distance, tolerance, locator.GetDiagonal(),
    surface.IsCloud()            ? "cloud"
      : this->Surface == "input" ? "surface"
                                 : this->Surface);
}

//------------------------------------------------------------------------------
Status SourceCollection::RefuseDistant(std::size_t i, double distance, double tolerance,
  double diagonal, const std::string& surface) const
{
  return InvalidInput(this->DescribeWithPosition(i), " is ", distance, " away from the ", surface,
    ", farther than ", tolerance * diagonal, " ({ProjectionTolerance} ", tolerance,
    " times the diagonal ", diagonal, ")")
    .At("", static_cast<Offset>(i))
    .Fix("Move the point, or raise {ProjectionTolerance}");
}

//------------------------------------------------------------------------------
std::string SourceCollection::DescribeIsolated(
  const PreparedSurface& surface, const std::vector<GeodesicSource>& sources) const
{
  const SurfaceMesh& mesh = surface.GetMeshWithoutAngles();
  std::vector<std::size_t> isolated;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const Id vertex = sources[i].Point.Vertex;
    if (IsVertex(sources[i].Point) &&
      (surface.IsCloud() ? !IsFinite(PointAt(surface.GetPositions(), vertex))
                         : mesh.FanBegin(vertex) == mesh.FanEnd(vertex)))
    {
      isolated.push_back(i);
    }
  }
  return this->DescribeIsolated(isolated, surface.IsCloud());
}

//------------------------------------------------------------------------------
std::string SourceCollection::DescribeIsolated(
  const std::vector<std::size_t>& isolated, bool isCloud) const
{
  if (isolated.empty())
  {
    return {};
  }
  const std::size_t ids = this->Ids.size();
  const std::size_t first = isolated.front();
  const std::string point = first < ids ? JoinText(Capitalize(this->Role), " id ", this->Ids[first])
                                        : this->Describe(first - ids);
  return point +
    (isolated.size() == 1 ? " is a point"
                          : JoinText(" and ", isolated.size() - 1, " more are points")) +
    (isCloud ? " with coordinates that are not finite. Such points reach no other point. Choose "
               "points with finite coordinates"
             : " that no polygon uses. Such points reach no other point. Choose points "
               "of polygons");
}

//------------------------------------------------------------------------------
std::vector<SurfacePoint> GetPoints(const std::vector<GeodesicSource>& sources)
{
  std::vector<SurfacePoint> points;
  points.reserve(sources.size());
  for (const GeodesicSource& source : sources)
  {
    points.push_back(source.Point);
  }
  return points;
}
}
