// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPreparedSurface.h"

#include "dggBitHash.h"
#include "dggBoxTree.h"
#include "dggCoincidentPoints.h"
#include "dggCounted.h"
#include "dggLocator.h"
#include "dggPoint3.h"
#include "dggPolygonTriangulator.h"
#include "dggSharedTable.h"
#include "dggStatus.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace dgg
{
namespace
{
/// Parts of a surface that are closer to each other than this fraction of the diagonal of the
/// bounding box are probably meant to be connected.
constexpr double SuspectGap = 1e-6;

/// Largest spacing of coordinates in single precision, in mean edge lengths, without a warning.
constexpr double LargestFloatSpacing = 1e-4;

const double* At(const double* points, Offset i)
{
  return points + 3 * i;
}

/// Returns the ids of points with finite coordinates.
std::vector<Id> CollectFinite(const std::vector<double>& points)
{
  std::vector<Id> ids;
  for (Id i = 0; i < static_cast<Id>(points.size() / 3); ++i)
  {
    if (IsFinite(PointAt(points.data(), i)))
    {
      ids.push_back(i);
    }
  }
  return ids;
}

double GetDiagonal(const std::vector<double>& points, const std::vector<Id>& ids)
{
  Box box;
  for (const Id id : ids)
  {
    box.Add(At(points.data(), id));
  }
  return box.GetDiagonal();
}

void AddCells(BitHash& hash, const CellArrays& cells)
{
  if (cells.NumberOfCells > 0)
  {
    hash.Add(cells.Offsets, static_cast<std::size_t>(cells.NumberOfCells) + 1);
    hash.Add(cells.Ids, static_cast<std::size_t>(cells.NumberOfIds));
  }
}

/// Returns the surfaces in use, by fingerprint.
SharedTable<Signature, PreparedSurface>& GetSurfacesInUse()
{
  static SharedTable<Signature, PreparedSurface> surfaces;
  return surfaces;
}
}

//------------------------------------------------------------------------------
PreparedSurface::PreparedSurface() = default;
PreparedSurface::~PreparedSurface() = default;

//------------------------------------------------------------------------------
Signature PreparedSurface::ComputeFingerprint(const SurfaceArrays& input, const Domain& domain)
{
  BitHash hash;
  const std::array<Offset, 6> sizes{ { input.NumberOfPoints, input.Polygons.NumberOfCells,
    input.Strips.NumberOfCells, input.FirstCell, static_cast<Offset>(domain.Kind),
    input.AreFromFloats ? 1 : 0 } };
  hash.Add(sizes.data(), sizes.size());
  hash.Add(&domain.MergeTolerance, 1);
  hash.Add(input.Points, 3 * static_cast<std::size_t>(input.NumberOfPoints));
  AddCells(hash, input.Polygons);
  AddCells(hash, input.Strips);
  return hash.Finish();
}

//------------------------------------------------------------------------------
Status PreparedSurface::Make(
  const SurfaceArrays& input, const Domain& domain, const Signature& fingerprint, Pointer& prepared)
{
  static std::atomic<std::uint64_t> numberOfBuilds{ 0 };
  prepared = GetSurfacesInUse().Find(fingerprint);
  if (prepared)
  {
    return Status::Success();
  }
  const auto made = std::make_shared<PreparedSurface>();
  made->InputDomain = domain;
  DGG_RETURN_IF_ERROR(made->Build(input));
  made->BuildNumber = ++numberOfBuilds;
  prepared = GetSurfacesInUse().Add(fingerprint, made);
  return Status::Success();
}

//------------------------------------------------------------------------------
Status PreparedSurface::Build(const SurfaceArrays& input)
{
  const Offset n = input.NumberOfPoints;
  if (n > std::numeric_limits<Id>::max())
  {
    return InvalidInput("The input has ", n, " points, more than ", std::numeric_limits<Id>::max())
      .Fix("Decimate or split the input");
  }
  this->Positions.assign(input.Points, input.Points + 3 * n);
  const double* points = this->Positions.data();
  if (this->IsCloud())
  {
    this->MeshSignature = ComputeSignature(points, n, nullptr, 0);
    return SurfaceMesh::FromPointsWithoutAngles(points, n, nullptr, 0, this->Mesh);
  }
  if (this->InputDomain.Kind == Domain::MergedSurface)
  {
    this->MergeCoincidentPoints();
  }
  std::vector<Id> triangles;
  DGG_RETURN_IF_ERROR(this->Triangulate(input, triangles));
  std::vector<Id> parents;
  this->Caps = SplitCaps(points, triangles, parents);
  if (this->Caps.NumberOfCaps > 0)
  {
    std::vector<Offset> cells(parents.size());
    std::transform(parents.begin(), parents.end(), cells.begin(),
      [this](Id triangle) { return this->Cells[triangle]; });
    this->Cells.swap(cells);
  }
  this->NumberOfOrderedFaces = static_cast<std::size_t>(
    std::is_sorted_until(this->Cells.begin(), this->Cells.end()) - this->Cells.begin());
  this->FirstCell = this->Cells.empty() ? 0 : this->Cells.front();
  if (std::adjacent_find(this->Cells.begin(), this->Cells.end(),
        [](Offset a, Offset b) { return b != a + 1; }) == this->Cells.end())
  {
    std::vector<Offset>().swap(this->Cells);
    this->HasInputCells = this->Vertices.empty() && this->Caps.NumberOfCaps == 0 &&
      input.Strips.NumberOfCells == 0 &&
      input.Polygons.NumberOfIds == static_cast<Offset>(triangles.size()) &&
      input.Polygons.NumberOfCells == static_cast<Offset>(triangles.size() / 3);
  }
  const auto numberOfTriangles = static_cast<Offset>(triangles.size() / 3);
  DGG_RETURN_IF_ERROR(SurfaceMesh::FromPointsWithoutAngles(
    points, n, triangles.data(), numberOfTriangles, this->Mesh));
  this->MeshSignature = ComputeSignature(points, n, triangles.data(), numberOfTriangles);
  this->NumberOfCoincidentPoints = CountCoincidentPoints(points, n);
  if (this->InputDomain.Kind == Domain::Surface)
  {
    this->CountCoincidentBoundaryPoints();
  }
  this->CollectWarnings();
  if (input.AreFromFloats)
  {
    this->CheckPrecision();
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status PreparedSurface::CheckCells(const CellArrays& cells, Offset firstCell, bool areFinite) const
{
  const auto n = static_cast<Offset>(this->Positions.size() / 3);
  DGG_RETURN_IF_ERROR(cells.Check(firstCell, n, "the input"));
  const Offset* end = cells.Ids + cells.NumberOfIds;
  const Offset* wrong = areFinite ? end : std::find_if(cells.Ids, end, [this](Offset id) {
    return !IsFinite(PointAt(this->Positions.data(), static_cast<Id>(id)));
  });
  if (wrong == end)
  {
    return Status::Success();
  }
  const Point3 p = PointAt(this->Positions.data(), static_cast<Id>(*wrong));
  return InvalidInput("Point ", *wrong, " of cell ", firstCell + cells.FindCell(wrong - cells.Ids),
    " has the coordinates (", p.X, ", ", p.Y, ", ", p.Z, "), which are not finite")
    .Fix("Repair the point or remove the cell");
}

//------------------------------------------------------------------------------
Status PreparedSurface::Triangulate(const SurfaceArrays& input, std::vector<Id>& triangles)
{
  triangles.reserve(3 * static_cast<std::size_t>(input.Polygons.NumberOfCells));
  this->Cells.reserve(static_cast<std::size_t>(input.Polygons.NumberOfCells));
  const bool areFinite = std::all_of(this->Positions.begin(), this->Positions.end(),
    [](double coordinate) { return std::isfinite(coordinate); });
  const Offset firstStrip = input.FirstCell + input.Polygons.NumberOfCells;
  DGG_RETURN_IF_ERROR(this->CheckCells(input.Polygons, input.FirstCell, areFinite));
  DGG_RETURN_IF_ERROR(this->CheckCells(input.Strips, firstStrip, areFinite));
  this->TriangulateCells(input.Polygons, false, input.FirstCell, triangles);
  this->TriangulateCells(input.Strips, true, firstStrip, triangles);
  if (!triangles.empty())
  {
    return Status::Success();
  }
  if (this->InputDomain.MergeTolerance > 0.0 && this->NumberOfMergedPoints > 0)
  {
    return InvalidInput("No polygon has three distinct points after a {MergeTolerance} of ",
      this->InputDomain.MergeTolerance, " merged ", Counted(this->NumberOfMergedPoints, "point"),
      " with others")
      .At("MergeTolerance")
      .Fix("Use a smaller {MergeTolerance}");
  }
  return InvalidInput("The input has ",
    Counted(this->NumberOfDroppedCells, "polygon or strip", "polygons or strips"),
    ", but none with three distinct points")
    .Fix("Use a surface mesh");
}

//------------------------------------------------------------------------------
void PreparedSurface::TriangulateCells(
  const CellArrays& cells, bool areStrips, Offset firstCell, std::vector<Id>& triangles)
{
  PolygonTriangulator triangulator(this->Positions.data());
  std::vector<Id> corners;
  for (Offset i = 0; i < cells.NumberOfCells; ++i)
  {
    const Offset* ids = cells.Ids + cells.Offsets[i];
    const Offset size = cells.Offsets[i + 1] - cells.Offsets[i];
    const std::size_t before = this->Cells.size();
    if (areStrips || size == 3)
    {
      for (Offset k = 0; k + 2 < size; ++k)
      {
        const Offset odd = k % 2; // every second triangle of a strip is turned over
        if (PolygonTriangulator::Append(this->GetVertex(ids[k]), this->GetVertex(ids[k + 1 + odd]),
              this->GetVertex(ids[k + 2 - odd]), triangles))
        {
          this->Cells.push_back(firstCell + i);
        }
      }
    }
    else
    {
      corners.resize(static_cast<std::size_t>(size));
      std::transform(
        ids, ids + size, corners.begin(), [this](Offset id) { return this->GetVertex(id); });
      const Id added = triangulator.Triangulate(corners, triangles);
      this->Cells.insert(this->Cells.end(), static_cast<std::size_t>(added), firstCell + i);
    }
    this->NumberOfDroppedCells += this->Cells.size() == before ? 1 : 0;
  }
  this->NumberOfFans += triangulator.GetNumberOfFans();
}

//------------------------------------------------------------------------------
void PreparedSurface::MergeCoincidentPoints()
{
  const std::vector<Id> ids = CollectFinite(this->Positions);
  const double tolerance = this->InputDomain.MergeTolerance * GetDiagonal(this->Positions, ids);
  const std::vector<Id> representatives =
    FindRepresentatives(this->Positions.data(), ids, tolerance);
  this->Vertices.resize(this->Positions.size() / 3);
  std::iota(this->Vertices.begin(), this->Vertices.end(), 0);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    this->Vertices[ids[i]] = representatives[i];
    this->NumberOfMergedPoints += representatives[i] != ids[i] ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
std::vector<Id> PreparedSurface::CollectBoundary() const
{
  std::vector<Id> ids;
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Mesh.Twin(h) == NoId && !this->Mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      ids.push_back(this->Mesh.Origin(h));
      ids.push_back(this->Mesh.Destination(h));
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

//------------------------------------------------------------------------------
void PreparedSurface::CountCoincidentBoundaryPoints()
{
  if (this->NumberOfCoincidentPoints == 0)
  {
    return;
  }
  const std::vector<Id> boundary = this->CollectBoundary();
  std::vector<Id> first = FindRepresentatives(this->Positions.data(), boundary, 0.0);
  std::sort(first.begin(), first.end());
  for (auto begin = first.begin(); begin != first.end();)
  {
    const auto end = std::upper_bound(begin, first.end(), *begin);
    this->NumberOfCoincidentBoundaryPoints += end - begin > 1 ? end - begin : 0;
    begin = end;
  }
}

//------------------------------------------------------------------------------
/// Adds a warning if the spacing of floats at the largest coordinate exceeds LargestFloatSpacing
/// mean edge lengths.
void PreparedSurface::CheckPrecision()
{
  float largest = 0.0F;
  for (Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Mesh.FanBegin(v) != this->Mesh.FanEnd(v))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        largest =
          std::max(largest, static_cast<float>(std::abs(At(this->Positions.data(), v)[axis])));
      }
    }
  }
  const double spacing = std::nextafter(largest, std::numeric_limits<float>::max()) - largest;
  const double edge = this->Mesh.GetMeanEdgeLength();
  if (spacing > LargestFloatSpacing * edge)
  {
    this->Warnings.push_back(JoinText(
      "Coordinates are stored in single precision, where numbers around ", largest, " are ",
      spacing, " apart, more than ", LargestFloatSpacing, " of the mean edge length ", edge,
      ". Translate the mesh to the origin before writing it, or use a reader that keeps doubles, "
      "such as vtkDGGPLYReader or vtkdgg.read"));
  }
}

//------------------------------------------------------------------------------
/// Returns true if no vertex is irregular and no face is excluded.
bool PreparedSurface::IsRegular() const
{
  const SurfaceMesh& mesh = this->Mesh;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsIrregular(v))
    {
      return false;
    }
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (mesh.IsDropped(f))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void PreparedSurface::CollectWarnings()
{
  // The report of a regular mesh, which takes longer, contains no defects.
  const MeshReport report = this->IsRegular() ? MeshReport() : this->GetReport();
  this->Warnings =
    DescribeDefects({ report.NonManifoldEdges, report.NonManifoldVertices, report.InconsistentEdges,
      this->NumberOfDroppedCells, this->NumberOfFans, report.DuplicateFaces });
  const auto warn = [this](Offset count, const char* noun, const std::string& what) {
    if (count > 0)
    {
      this->Warnings.push_back(JoinText("The mesh has ", Counted(count, noun), what));
    }
  };
  warn(this->Caps.NumberOfCaps, "triangle",
    JoinText(" without area (height at most ", this->Caps.LargestHeight,
      "). Such triangles are ignored, and their neighbors are split where they meet"));
  warn(this->Mesh.GetNumberOfDegenerateFaces(), "triangle",
    JoinText(" without area, whose edges are lengthened by ", this->Mesh.GetMollification()));
  warn(this->NumberOfCoincidentBoundaryPoints, "point",
    " of the boundary with the same coordinates as another one. Turn on {MergeCoincidentPoints} if "
    "they are the two sides of a seam rather than of a slit");
}

//------------------------------------------------------------------------------
const SurfaceMesh& PreparedSurface::GetMesh() const
{
  std::call_once(this->AnglesOnce, [this] { this->Mesh.MeasureAngles(); });
  return this->Mesh;
}

//------------------------------------------------------------------------------
std::vector<Id> PreparedSurface::GetFaces(Offset cell) const
{
  if (this->Cells.empty())
  {
    const Offset face = cell - this->FirstCell;
    return face >= 0 && face < this->Mesh.GetNumberOfFaces()
      ? std::vector<Id>{ static_cast<Id>(face) }
      : std::vector<Id>();
  }
  std::vector<Id> faces;
  const auto end = this->Cells.begin() + static_cast<std::ptrdiff_t>(this->NumberOfOrderedFaces);
  const auto range = std::equal_range(this->Cells.begin(), end, cell);
  for (auto face = range.first; face != range.second; ++face)
  {
    faces.push_back(static_cast<Id>(face - this->Cells.begin()));
  }
  for (std::size_t face = this->NumberOfOrderedFaces; face < this->Cells.size(); ++face)
  {
    if (this->Cells[face] == cell)
    {
      faces.push_back(static_cast<Id>(face));
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
const MeshReport& PreparedSurface::GetReport() const
{
  std::call_once(this->ReportOnce, [this] {
    this->Report = InspectMesh(this->Mesh);
    this->Report.CoincidentPoints = this->NumberOfCoincidentPoints;
    this->Report.DegenerateFaces += this->Caps.NumberOfCaps;
  });
  return this->Report;
}

//------------------------------------------------------------------------------
double PreparedSurface::GetMeanAnisotropy() const
{
  std::call_once(this->AnisotropyOnce,
    [this] { this->MeanAnisotropy = MeasureMeanAnisotropy(this->Mesh).Get(); });
  return this->MeanAnisotropy;
}

//------------------------------------------------------------------------------
std::vector<ReportItem> PreparedSurface::ListReport() const
{
  const MeshReport& report = this->GetReport();
  const auto item = [](const char* name, const char* words, auto value) {
    return ReportItem{ name, words, static_cast<double>(value), JoinText(value) };
  };
  return {
    item("NumberOfPoints", "points", report.Vertices),
    item("NumberOfTriangles", "triangles", report.Faces),
    item("NumberOfComponents", "components", report.Components),
    item("NumberOfBoundaryLoops", "boundary loops", report.BoundaryLoops),
    item("NumberOfBoundaryEdges", "boundary edges", report.BoundaryEdges),
    { "Orientable", "orientable", report.Orientable ? 1.0 : 0.0, report.Orientable ? "yes" : "no" },
    { "Genus", "genus", static_cast<double>(report.Genus),
      report.Genus < 0 ? "undefined" : std::to_string(report.Genus) },
    item("NumberOfNonManifoldEdges", "non-manifold edges", report.NonManifoldEdges),
    item("NumberOfNonManifoldVertices", "non-manifold vertices", report.NonManifoldVertices),
    item("NumberOfDroppedFaces", "dropped faces", this->NumberOfDroppedCells),
    item("NumberOfDegenerateFaces", "degenerate faces", report.DegenerateFaces),
    item("NumberOfDuplicateFaces", "duplicate faces", report.DuplicateFaces),
    item("NumberOfIsolatedPoints", "isolated points", this->GetNumberOfIsolatedPoints()),
    item("NumberOfCoincidentPoints", "coincident points", report.CoincidentPoints),
    item("NumberOfCoincidentBoundaryPoints", "coincident boundary points",
      this->NumberOfCoincidentBoundaryPoints),
    item("NumberOfMergedPoints", "merged points", this->NumberOfMergedPoints),
    item("Mollification", "length added to degenerate faces", report.Mollification),
    item("LargestCapHeight", "height of removed degenerate faces", this->GetLargestCapHeight()),
    item("Area", "area", report.Area),
    item("MeanAnisotropy", "mean anisotropy", report.MeanAnisotropy),
    item("MedianAnisotropy", "median anisotropy", report.MedianAnisotropy),
  };
}

//------------------------------------------------------------------------------
const Locator& PreparedSurface::GetLocator() const
{
  std::call_once(this->LocatorOnce, [this] {
    if (this->IsCloud())
    {
      this->ClosestPoints =
        std::make_unique<CloudLocator>(this->GetPositions(), this->Mesh.GetNumberOfVertices());
    }
    else
    {
      this->ClosestPoints = std::make_unique<SurfaceLocator>(this->Mesh, this->GetPositions());
    }
  });
  return *this->ClosestPoints;
}

//------------------------------------------------------------------------------
std::string PreparedSurface::DescribeGaps(const std::vector<bool>& isReached) const
{
  if (this->NumberOfCoincidentBoundaryPoints > 0 || this->GetReport().Components < 2)
  {
    return std::string(); // a warning of the mesh has named the remedy, or there are no parts
  }
  Id count = 0;
  const std::vector<Id> components = this->Mesh.ComputeComponents(count);
  std::vector<bool> isConnected(static_cast<std::size_t>(count));
  for (std::size_t v = 0; v < isReached.size(); ++v)
  {
    isConnected[components[v]] = isConnected[components[v]] || isReached[v];
  }
  Offset used = 0;
  Offset connected = 0;
  for (Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Mesh.FanBegin(v) != this->Mesh.FanEnd(v))
    {
      ++used;
      connected += isConnected[components[v]] ? 1 : 0;
    }
  }
  if (2 * connected >= used)
  {
    return std::string();
  }
  const double* points = this->Positions.data();
  const std::vector<Id> boundary = this->CollectBoundary();
  const std::vector<Id> close = FindRepresentatives(
    points, boundary, SuspectGap * GetDiagonal(this->Positions, CollectFinite(this->Positions)));
  Offset numberOfPoints = 0;
  double gap = 0.0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    if (components[boundary[i]] != components[close[i]])
    {
      const double* p = At(points, boundary[i]);
      const double* q = At(points, close[i]);
      gap = std::max(gap, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      ++numberOfPoints;
    }
  }
  if (numberOfPoints == 0)
  {
    return std::string();
  }
  return JoinText("Only ", connected, " of ", Counted(used, "point"),
    " are connected to a source, with ", Counted(numberOfPoints, "point"),
    " of the boundary no more than ", gap, " away from a point of another component. ",
    this->InputDomain.Kind == Domain::MergedSurface
      ? "Raise {MergeTolerance} to "
      : "Turn on {MergeCoincidentPoints} with a {MergeTolerance} of ",
    SuspectGap, " if the components belong together");
}
}
