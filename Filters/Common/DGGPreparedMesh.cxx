// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPreparedMesh.h"

#include "DGGCloudLocator.h"
#include "DGGPointCoordinates.h"
#include "DGGPolygonTriangulator.h"
#include "DGGSharedTable.h"
#include "DGGSurfaceLocator.h"

#include "dggBitHash.h"
#include "dggCapSplitting.h"
#include "dggInvalidInput.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkIncrementalOctreePointLocator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
/// Parts of a surface that are closer to each other than this fraction of the diagonal of the
/// bounding box are likely to be meant as one.
constexpr double SuspectGap = 1e-6;

/// Largest spacing of coordinates in single precision, in mean edge lengths, without a warning.
constexpr double LargestFloatSpacing = 1e-4;

/// Lexicographic order by coordinates; -0 equals +0 in comparisons.
struct ByCoordinates
{
  const double* Points;

  bool operator()(dgg::Id a, dgg::Id b) const
  {
    const double* p = this->Points + 3 * static_cast<std::size_t>(a);
    const double* q = this->Points + 3 * static_cast<std::size_t>(b);
    return std::lexicographical_compare(p, p + 3, q, q + 3);
  }
};

bool IsFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// Sort ids so that coincident points are neighbours, smallest id first, and call `visit(first,
/// last)` for each group of them.
template <typename Visitor>
void ForEachCoincidentGroup(const double* points, std::vector<dgg::Id>& ids, Visitor visit)
{
  const ByCoordinates before{ points };
  std::sort(ids.begin(), ids.end(),
    [&](dgg::Id a, dgg::Id b) { return before(a, b) || (!before(b, a) && a < b); });
  for (auto first = ids.begin(); first != ids.end();)
  {
    auto last = first + 1;
    while (last != ids.end() && !before(*first, *last))
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

/// The ids of points whose coordinates are finite.
std::vector<dgg::Id> CollectFinite(const double* points, vtkIdType numberOfPoints)
{
  std::vector<dgg::Id> ids;
  for (dgg::Id i = 0; i < numberOfPoints; ++i)
  {
    if (IsFinite(points + 3 * static_cast<std::size_t>(i)))
    {
      ids.push_back(i);
    }
  }
  return ids;
}

vtkBoundingBox BoundsOf(const double* points, const std::vector<dgg::Id>& ids)
{
  vtkBoundingBox box;
  for (const dgg::Id id : ids)
  {
    const double* p = points + 3 * static_cast<std::size_t>(id);
    box.AddPoint(p[0], p[1], p[2]);
  }
  return box;
}

/// For each of some points the one that it is taken as: in their order, the closest one within the
/// tolerance of those before it that are taken as themselves, else itself.
std::vector<dgg::Id> FindClosePoints(
  const double* points, const std::vector<dgg::Id>& ids, double tolerance)
{
  std::vector<dgg::Id> result;
  if (ids.empty())
  {
    return result;
  }
  double bounds[6];
  BoundsOf(points, ids).GetBounds(bounds);
  vtkNew<vtkPoints> kept;
  kept->SetDataTypeToDouble();
  vtkNew<vtkIncrementalOctreePointLocator> locator;
  locator->SetTolerance(tolerance);
  locator->InitPointInsertion(kept, bounds);
  std::vector<dgg::Id> keptIds;
  for (const dgg::Id id : ids)
  {
    vtkIdType place = 0;
    if (locator->InsertUniquePoint(points + 3 * static_cast<std::size_t>(id), place))
    {
      keptIds.push_back(id);
    }
    result.push_back(keptIds[place]);
  }
  return result;
}

/// The point of a cell is missing or not finite.
dgg::Status BadPoint(const double* points, vtkIdType numberOfPoints, vtkIdType cell, vtkIdType id)
{
  if (id < 0 || id >= numberOfPoints)
  {
    return dgg::InvalidInput("cell ", cell, " names point ", id, ", but the input has ",
      numberOfPoints, numberOfPoints == 1 ? " point" : " points", ": repair the cell");
  }
  const double* p = points + 3 * id;
  return dgg::InvalidInput("point ", id, " of cell ", cell, " has the coordinates (", p[0], ", ",
    p[1], ", ", p[2], "), which are not finite: repair the point or remove the cell");
}

dgg::Status CheckCell(const double* points, vtkIdType numberOfPoints, vtkIdType cell,
  vtkIdType size, const vtkIdType* ids)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints || !IsFinite(points + 3 * ids[i]))
    {
      return BadPoint(points, numberOfPoints, cell, ids[i]);
    }
  }
  return dgg::Status::Success();
}

void AddArray(dgg::BitHash& hash, vtkDataArray* array)
{
  const auto size = static_cast<std::size_t>(array->GetNumberOfValues()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  hash.Add(static_cast<const unsigned char*>(array->GetVoidPointer(0)), size);
}

/// The meshes that filters hold, by fingerprint.
DGGSharedTable<dgg::Signature, DGGPreparedMesh>& GetMeshesInUse()
{
  static DGGSharedTable<dgg::Signature, DGGPreparedMesh> meshes;
  return meshes;
}
}

//------------------------------------------------------------------------------
dgg::Signature DGGPreparedMesh::ComputeFingerprint(vtkPolyData* input, const DGGDomain& domain)
{
  const bool isCloud = domain.Kind == DGGDomain::Cloud;
  vtkPoints* points = input->GetPoints();
  const auto countCells = [isCloud](vtkIdType count) { return isCloud ? 0 : count; };
  const std::array<vtkIdType, 7> sizes = { { input->GetNumberOfPoints(),
    countCells(input->GetNumberOfVerts()), countCells(input->GetNumberOfLines()),
    countCells(input->GetNumberOfPolys()), countCells(input->GetNumberOfStrips()),
    static_cast<vtkIdType>(domain.Kind), points ? points->GetDataType() : VTK_VOID } };
  dgg::BitHash hash;
  hash.Add(sizes.data(), sizes.size());
  hash.Add(&domain.MergeTolerance, 1);
  const DGGPointCoordinates coordinates(points);
  hash.Add(coordinates.GetData(), 3 * static_cast<std::size_t>(input->GetNumberOfPoints()));
  if (isCloud)
  {
    return hash.Finish();
  }
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    if (cells && cells->GetNumberOfCells() > 0)
    {
      AddArray(hash, cells->GetOffsetsArray());
      AddArray(hash, cells->GetConnectivityArray());
    }
  }
  return hash.Finish();
}

//------------------------------------------------------------------------------
dgg::Status DGGPreparedMesh::Make(
  vtkPolyData* input, const DGGDomain& domain, const dgg::Signature& fingerprint, Pointer& prepared)
{
  prepared = GetMeshesInUse().Find(fingerprint);
  if (prepared)
  {
    return dgg::Status::Success();
  }
  const auto made = std::make_shared<DGGPreparedMesh>();
  made->Domain = domain;
  DGG_RETURN_IF_ERROR(made->Build(input));
  made->BuildTime.Modified();
  prepared = GetMeshesInUse().Add(fingerprint, made);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGPreparedMesh::CheckSurface(vtkPolyData* input)
{
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0)
  {
    return dgg::Status::Success();
  }
  const vtkIdType n = input->GetNumberOfPoints();
  return dgg::InvalidInput("the input has ", n, n == 1 ? " point" : " points",
    " but no polygons or triangle strips: connect a surface mesh. Distances on a point cloud need "
    "the graph that vtkPointCloudDGG makes, and a filter that searches it, as vtkDGGDistance or "
    "vtkDGGPath; vtkDGGFastMarchingDistance gives rough ones without");
}

//------------------------------------------------------------------------------
dgg::Status DGGPreparedMesh::Build(vtkPolyData* input)
{
  const vtkIdType n = input->GetNumberOfPoints();
  if (n > std::numeric_limits<dgg::Id>::max())
  {
    return dgg::InvalidInput("the input has ", n, " points; at most ",
      std::numeric_limits<dgg::Id>::max(), " are supported: decimate or split it");
  }
  if (this->Domain.Kind == DGGDomain::Cloud)
  {
    return this->BuildCloud(input);
  }
  DGG_RETURN_IF_ERROR(CheckSurface(input));
  const bool mergeCoincidentPoints = this->Domain.Kind == DGGDomain::MergedSurface;
  const DGGPointCoordinates coordinates(input->GetPoints());
  if (mergeCoincidentPoints)
  {
    this->MergeCoincidentPoints(coordinates.GetData(), n);
  }
  std::vector<dgg::Id> triangles;
  DGG_RETURN_IF_ERROR(this->Triangulate(input, coordinates.GetData(), triangles));
  std::vector<dgg::Id> parents;
  this->Caps = dgg::SplitCaps(coordinates.GetData(), triangles, parents);
  if (this->Caps.NumberOfCaps > 0)
  {
    std::vector<vtkIdType> cells(parents.size());
    std::transform(parents.begin(), parents.end(), cells.begin(),
      [this](dgg::Id triangle) { return this->Cells[triangle]; });
    this->Cells.swap(cells);
  }
  this->NumberOfOrderedFaces = static_cast<std::size_t>(
    std::is_sorted_until(this->Cells.begin(), this->Cells.end()) - this->Cells.begin());
  DGG_RETURN_IF_ERROR(dgg::SurfaceMesh::FromPointsWithoutAngles(coordinates.GetData(), n,
    triangles.data(), static_cast<dgg::Offset>(triangles.size() / 3), this->Mesh));
  this->Signature = dgg::ComputeSignature(
    coordinates.GetData(), n, triangles.data(), static_cast<dgg::Offset>(triangles.size() / 3));
  this->NumberOfCoincidentPoints = dgg::CountCoincidentPoints(coordinates.GetData(), n);
  if (!mergeCoincidentPoints)
  {
    this->CountCoincidentBoundaryPoints(coordinates.GetData());
  }
  this->CollectWarnings();
  if (input->GetPoints()->GetDataType() == VTK_FLOAT)
  {
    this->CheckPrecision(coordinates.GetData());
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGPreparedMesh::BuildCloud(vtkPolyData* input)
{
  const vtkIdType n = input->GetNumberOfPoints();
  const DGGPointCoordinates coordinates(input->GetPoints());
  this->Signature = dgg::ComputeSignature(coordinates.GetData(), n, nullptr, 0);
  DGG_RETURN_IF_ERROR(
    dgg::SurfaceMesh::FromPointsWithoutAngles(coordinates.GetData(), n, nullptr, 0, this->Mesh));
  this->GetPositions(input->GetPoints());
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGPreparedMesh::Triangulate(
  vtkPolyData* input, const double* points, std::vector<dgg::Id>& triangles)
{
  const vtkIdType n = input->GetNumberOfPoints();
  DGGPolygonTriangulator triangulator;
  std::vector<dgg::Id> corners;
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = cell + input->GetNumberOfPolys();
  if (input->GetNumberOfPolys() > 0)
  {
    triangles.reserve(3 * static_cast<std::size_t>(input->GetNumberOfPolys()));
    this->Cells.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  }
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    if (!cells || cells->GetNumberOfCells() == 0)
    {
      continue;
    }
    if (!cells->IsValid())
    {
      return dgg::Status::Invalid("the offsets and the connectivity of the input's polygons or "
                                  "strips contradict each other: build the cell array anew");
    }
    const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
         iterator->GoToNextCell(), ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      DGG_RETURN_IF_ERROR(CheckCell(points, n, cell, size, ids));
      dgg::Id added = 0;
      if (cell < firstStrip)
      {
        corners.resize(size);
        std::transform(
          ids, ids + size, corners.begin(), [this](vtkIdType id) { return this->GetVertex(id); });
        added = triangulator.Triangulate(points, corners, triangles);
      }
      else
      {
        for (vtkIdType i = 0; i + 2 < size; ++i)
        {
          const vtkIdType odd = i % 2; // every second triangle of a strip is turned over
          corners = { this->GetVertex(ids[i]), this->GetVertex(ids[i + 1 + odd]),
            this->GetVertex(ids[i + 2 - odd]) };
          added += triangulator.Triangulate(points, corners, triangles);
        }
      }
      this->NumberOfDroppedCells += added == 0 ? 1 : 0;
      for (; added > 0; --added)
      {
        this->Cells.push_back(cell);
      }
    }
  }
  this->NumberOfFans = triangulator.GetNumberOfFans();
  if (triangles.empty())
  {
    if (this->Domain.MergeTolerance > 0.0 && this->NumberOfMergedPoints > 0)
    {
      return dgg::InvalidInput("no polygon is left with three distinct points: MergeTolerance is ",
        this->Domain.MergeTolerance, ", which has merged ", this->NumberOfMergedPoints,
        " points with others; make it smaller");
    }
    return dgg::InvalidInput("none of the ", this->NumberOfDroppedCells,
      " polygons and strips of the input has three distinct points: connect a surface mesh");
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGPreparedMesh::MergeCoincidentPoints(const double* points, vtkIdType numberOfPoints)
{
  std::vector<dgg::Id> ids = CollectFinite(points, numberOfPoints);
  this->Vertices.resize(numberOfPoints);
  std::iota(this->Vertices.begin(), this->Vertices.end(), 0);
  if (this->Domain.MergeTolerance > 0.0)
  {
    const double tolerance =
      this->Domain.MergeTolerance * BoundsOf(points, ids).GetDiagonalLength();
    const std::vector<dgg::Id> close = FindClosePoints(points, ids, tolerance);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      this->Vertices[ids[i]] = close[i];
      this->NumberOfMergedPoints += close[i] != ids[i] ? 1 : 0;
    }
    return;
  }
  ForEachCoincidentGroup(points, ids, [this](auto first, auto last) {
    for (auto id = first + 1; id != last; ++id)
    {
      this->Vertices[*id] = *first;
      ++this->NumberOfMergedPoints;
    }
  });
}

//------------------------------------------------------------------------------
std::vector<dgg::Id> DGGPreparedMesh::CollectBoundary() const
{
  std::vector<dgg::Id> ids;
  for (dgg::Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Mesh.Twin(h) == dgg::NoId && !this->Mesh.IsDropped(dgg::SurfaceMesh::Face(h)))
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
void DGGPreparedMesh::CountCoincidentBoundaryPoints(const double* points)
{
  if (this->NumberOfCoincidentPoints == 0)
  {
    return;
  }
  std::vector<dgg::Id> ids = this->CollectBoundary();
  ForEachCoincidentGroup(points, ids, [this](auto first, auto last) {
    if (last - first > 1)
    {
      this->NumberOfCoincidentBoundaryPoints += last - first;
    }
  });
}

//------------------------------------------------------------------------------
/// Adds a warning if the spacing of floats at the largest coordinate exceeds LargestFloatSpacing
/// mean edge lengths.
void DGGPreparedMesh::CheckPrecision(const double* points)
{
  float largest = 0.0F;
  for (dgg::Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Mesh.FanBegin(v) != this->Mesh.FanEnd(v))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        largest =
          std::max(largest, static_cast<float>(std::abs(points[dgg::Offset{ 3 } * v + axis])));
      }
    }
  }
  const double spacing = std::nextafter(largest, std::numeric_limits<float>::max()) - largest;
  const double edge = this->Mesh.GetMeanEdgeLength();
  if (spacing > LargestFloatSpacing * edge)
  {
    this->Warnings.push_back(dgg::JoinText("coordinates are stored in single precision, where "
                                           "numbers around ",
      largest, " are ", spacing, " apart, more than ", LargestFloatSpacing,
      " of the mean edge length, which is ", edge,
      ". Translate the mesh to the origin before it is "
      "written, or read it with a reader that keeps doubles, such as vtkDGGPLYReader or "
      "vtkdgg.read"));
  }
}

//------------------------------------------------------------------------------
/// Whether no vertex is irregular and no face left out.
bool DGGPreparedMesh::IsPlain() const
{
  const dgg::SurfaceMesh& mesh = this->Mesh;
  for (dgg::Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsIrregular(v))
    {
      return false;
    }
  }
  for (dgg::Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (mesh.IsDropped(f))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void DGGPreparedMesh::CollectWarnings()
{
  // A plain mesh has none of what a report would warn of.
  const dgg::MeshReport report = this->IsPlain() ? dgg::MeshReport() : this->GetReport();
  auto warn = [this](vtkIdType count, const std::string& what) {
    if (count > 0)
    {
      this->Warnings.push_back("the mesh has " + std::to_string(count) + " " + what);
    }
  };
  warn(report.NonManifoldEdges,
    "edges with more than two triangles, each of which is connected with every other one there");
  warn(report.NonManifoldVertices, "points where separate sheets touch, which are connected there");
  warn(report.InconsistentEdges,
    "edges across which no choice of orientation is consistent, as on a Moebius strip. Distances "
    "do not depend on orientation");
  warn(this->NumberOfDroppedCells,
    "polygons with fewer than three distinct points, which are left out");
  warn(this->NumberOfFans,
    "polygons that cross or touch themselves. They are cut into fans around their first points, "
    "which need not be what they are meant to be: triangulate them first");
  warn(report.DuplicateFaces,
    "triangles on the same three points as an earlier one, which are left out");
  warn(this->Caps.NumberOfCaps,
    dgg::JoinText("triangles without area, no higher than ", this->Caps.LargestHeight,
      ", that are left out: their neighbours are split where they meet"));
  warn(this->Mesh.GetNumberOfDegenerateFaces(),
    dgg::JoinText("triangles without area, whose edges are taken to be longer by ",
      this->Mesh.GetMollification()));
  warn(this->NumberOfCoincidentBoundaryPoints,
    "points of the boundary with the same coordinates as another one. If they are the two sides of "
    "a seam rather than of a slit, turn MergeCoincidentPoints on");
}

//------------------------------------------------------------------------------
const dgg::SurfaceMesh& DGGPreparedMesh::GetMesh() const
{
  std::call_once(this->AnglesOnce, [this] { this->Mesh.MeasureAngles(); });
  return this->Mesh;
}

//------------------------------------------------------------------------------
std::vector<dgg::Id> DGGPreparedMesh::GetFaces(vtkIdType cell) const
{
  std::vector<dgg::Id> faces;
  const auto end = this->Cells.begin() + static_cast<std::ptrdiff_t>(this->NumberOfOrderedFaces);
  const auto range = std::equal_range(this->Cells.begin(), end, cell);
  for (auto face = range.first; face != range.second; ++face)
  {
    faces.push_back(static_cast<dgg::Id>(face - this->Cells.begin()));
  }
  for (std::size_t face = this->NumberOfOrderedFaces; face < this->Cells.size(); ++face)
  {
    if (this->Cells[face] == cell)
    {
      faces.push_back(static_cast<dgg::Id>(face));
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
const dgg::MeshReport& DGGPreparedMesh::GetReport() const
{
  std::call_once(this->ReportOnce, [this] {
    this->Report = dgg::InspectMesh(this->Mesh);
    this->Report.CoincidentPoints = this->NumberOfCoincidentPoints;
    this->Report.DegenerateFaces += this->Caps.NumberOfCaps;
  });
  return this->Report;
}

//------------------------------------------------------------------------------
const dgg::Anisotropy& DGGPreparedMesh::GetAnisotropy() const
{
  std::call_once(
    this->AnisotropyOnce, [this] { this->Anisotropy = dgg::MeasureAnisotropy(this->Mesh); });
  return this->Anisotropy;
}

//------------------------------------------------------------------------------
const double* DGGPreparedMesh::GetPositions(vtkPoints* points) const
{
  std::call_once(this->PositionsOnce, [&] {
    const DGGPointCoordinates coordinates(points);
    const std::size_t size = 3 * static_cast<std::size_t>(this->Mesh.GetNumberOfVertices());
    this->Positions.assign(coordinates.GetData(), coordinates.GetData() + size);
  });
  return this->Positions.data();
}

//------------------------------------------------------------------------------
DGGLocator& DGGPreparedMesh::GetLocator(vtkPoints* points) const
{
  std::call_once(this->LocatorOnce, [&] {
    if (this->IsCloud())
    {
      this->Locator =
        std::make_unique<DGGCloudLocator>(this->Positions.data(), this->Mesh.GetNumberOfVertices());
    }
    else
    {
      this->Locator = std::make_unique<DGGSurfaceLocator>(this->Mesh, points);
    }
  });
  return *this->Locator;
}

//------------------------------------------------------------------------------
std::string DGGPreparedMesh::DescribeGaps(
  vtkPolyData* input, const std::vector<bool>& isReached) const
{
  if (this->NumberOfCoincidentBoundaryPoints > 0 || this->GetReport().Components < 2)
  {
    return std::string(); // a warning of the mesh has named the remedy, or there are no parts
  }
  dgg::Id count = 0;
  const std::vector<dgg::Id> components = this->Mesh.ComputeComponents(count);
  std::vector<bool> isConnected(static_cast<std::size_t>(count));
  for (std::size_t v = 0; v < isReached.size(); ++v)
  {
    isConnected[components[v]] = isConnected[components[v]] || isReached[v];
  }
  vtkIdType used = 0;
  vtkIdType connected = 0;
  for (dgg::Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
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
  const DGGPointCoordinates coordinates(input->GetPoints());
  const double* points = coordinates.GetData();
  const vtkBoundingBox box =
    BoundsOf(points, CollectFinite(points, this->Mesh.GetNumberOfVertices()));
  const std::vector<dgg::Id> boundary = this->CollectBoundary();
  const std::vector<dgg::Id> close =
    FindClosePoints(points, boundary, SuspectGap * box.GetDiagonalLength());
  vtkIdType numberOfPoints = 0;
  double gap = 0.0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    if (components[boundary[i]] != components[close[i]])
    {
      const double* p = points + 3 * static_cast<std::size_t>(boundary[i]);
      const double* q = points + 3 * static_cast<std::size_t>(close[i]);
      gap = std::max(gap, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      ++numberOfPoints;
    }
  }
  if (numberOfPoints == 0)
  {
    return std::string();
  }
  return dgg::JoinText("only ", connected, " of ", used,
    " points are connected with a source, but ", numberOfPoints,
    " points of the boundary are no more than ", gap,
    " away from one of another part of the surface. If the parts belong together, ",
    this->Domain.Kind == DGGDomain::MergedSurface
      ? "raise MergeTolerance to "
      : "turn MergeCoincidentPoints on, with a MergeTolerance of ",
    SuspectGap);
}
