// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMeshAdapter.h"

#include "vtkDGGPointCoordinates.h"
#include "vtkDGGPolygonTriangulator.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
/// Later of the cell array's own time and that of its parts.
vtkMTimeType TimeOf(vtkCellArray* cells)
{
  return cells ? std::max({ cells->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
                   cells->GetConnectivityArray()->GetMTime() })
               : 0;
}

vtkMTimeType AddressOf(const void* object)
{
  return static_cast<vtkMTimeType>(reinterpret_cast<std::uintptr_t>(object));
}

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
}

//------------------------------------------------------------------------------
vtkDGGMeshAdapter::Key vtkDGGMeshAdapter::MakeKey(vtkPolyData* input, bool mergeCoincidentPoints)
{
  vtkPoints* points = input->GetPoints();
  return { { AddressOf(points), points ? points->GetMTime() : 0, AddressOf(input->GetPolys()),
    TimeOf(input->GetPolys()), AddressOf(input->GetStrips()), TimeOf(input->GetStrips()),
    static_cast<vtkMTimeType>(mergeCoincidentPoints) } };
}

//------------------------------------------------------------------------------
bool vtkDGGMeshAdapter::IsUpToDate(vtkPolyData* input, bool mergeCoincidentPoints)
{
  // After a change in place Modified() is often called on the data object alone. Another object
  // with the very same points and polygons is no change.
  const vtkMTimeType object = AddressOf(input);
  const vtkMTimeType time = input->vtkObject::GetMTime();
  const bool modified = object == this->Object && time != this->ObjectTime;
  this->Object = object;
  this->ObjectTime = time;
  return this->IsBuilt && !modified && this->BuiltFrom == MakeKey(input, mergeCoincidentPoints);
}

//------------------------------------------------------------------------------
void vtkDGGMeshAdapter::Clear()
{
  this->Mesh = dgg::SurfaceMesh();
  this->Report = dgg::MeshReport();
  this->Vertices.clear();
  this->Cells.clear();
  this->NumberOfDroppedCells = 0;
  this->NumberOfFans = 0;
  this->NumberOfMergedPoints = 0;
  this->NumberOfCoincidentBoundaryPoints = 0;
  this->Warnings.clear();
  this->IsBuilt = false;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::Update(vtkPolyData* input, bool mergeCoincidentPoints)
{
  this->Clear();
  const dgg::Status status = this->Build(input, mergeCoincidentPoints);
  if (!status.IsOk())
  {
    this->Clear();
    return status;
  }
  this->BuiltFrom = MakeKey(input, mergeCoincidentPoints);
  this->IsBuilt = true;
  this->BuildTime.Modified();
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::Build(vtkPolyData* input, bool mergeCoincidentPoints)
{
  const vtkIdType n = input->GetNumberOfPoints();
  if (n > std::numeric_limits<dgg::Id>::max())
  {
    std::ostringstream message;
    message << "the input has " << n << " points; at most " << std::numeric_limits<dgg::Id>::max()
            << " are supported: decimate or split it";
    return dgg::Status::Invalid(message.str());
  }
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    std::ostringstream message;
    message << "the input has " << n << " points but no polygons or triangle strips: connect a "
            << "surface mesh";
    return dgg::Status::Invalid(message.str());
  }

  const vtkDGGPointCoordinates coordinates(input->GetPoints());
  if (mergeCoincidentPoints)
  {
    this->MergeCoincidentPoints(coordinates.GetData(), n);
  }
  std::vector<dgg::Id> triangles;
  dgg::Status status = this->Triangulate(input, coordinates.GetData(), triangles);
  if (!status.IsOk())
  {
    return status;
  }
  status = dgg::SurfaceMesh::FromPoints(coordinates.GetData(), n, triangles.data(),
    static_cast<dgg::Offset>(triangles.size() / 3), this->Mesh);
  if (!status.IsOk())
  {
    return status;
  }
  this->Signature = dgg::ComputeSignature(
    coordinates.GetData(), n, triangles.data(), static_cast<dgg::Offset>(triangles.size() / 3));
  this->Report = dgg::InspectMesh(this->Mesh, coordinates.GetData());
  if (!mergeCoincidentPoints)
  {
    this->CountCoincidentBoundaryPoints(coordinates.GetData());
  }
  this->CollectWarnings();
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::CheckCell(const double* points, vtkIdType numberOfPoints,
  vtkIdType cell, vtkIdType size, const vtkIdType* ids) const
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::ostringstream message;
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      message << "cell " << cell << " names point " << ids[i] << ", but the input has "
              << numberOfPoints << " points: repair the cell";
      return dgg::Status::Invalid(message.str());
    }
    const double* p = points + 3 * ids[i];
    if (!IsFinite(p))
    {
      message << "point " << ids[i] << " of cell " << cell << " has the coordinates (" << p[0]
              << ", " << p[1] << ", " << p[2] << "), which are not finite: repair the point or "
              << "remove the cell";
      return dgg::Status::Invalid(message.str());
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::Triangulate(
  vtkPolyData* input, const double* points, std::vector<dgg::Id>& triangles)
{
  const vtkIdType n = input->GetNumberOfPoints();
  vtkDGGPolygonTriangulator triangulator;
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
      const dgg::Status status = this->CheckCell(points, n, cell, size, ids);
      if (!status.IsOk())
      {
        return status;
      }
      dgg::Id added = 0;
      if (cell < firstStrip)
      {
        corners.clear();
        std::transform(ids, ids + size, std::back_inserter(corners),
          [this](vtkIdType id) { return this->GetVertex(id); });
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
      this->Cells.insert(this->Cells.end(), added, cell);
    }
  }
  this->NumberOfFans = triangulator.GetNumberOfFans();
  if (triangles.empty())
  {
    std::ostringstream message;
    message << "none of the " << this->NumberOfDroppedCells
            << " polygons and strips of the input has three distinct points: connect a surface "
            << "mesh";
    return dgg::Status::Invalid(message.str());
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDGGMeshAdapter::MergeCoincidentPoints(const double* points, vtkIdType numberOfPoints)
{
  std::vector<dgg::Id> ids;
  this->Vertices.resize(numberOfPoints);
  for (dgg::Id i = 0; i < numberOfPoints; ++i)
  {
    this->Vertices[i] = i;
    if (IsFinite(points + 3 * static_cast<std::size_t>(i)))
    {
      ids.push_back(i);
    }
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
void vtkDGGMeshAdapter::CountCoincidentBoundaryPoints(const double* points)
{
  if (this->Report.CoincidentPoints == 0)
  {
    return;
  }
  std::vector<dgg::Id> ids;
  for (dgg::Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Mesh.Twin(h) == dgg::NoId)
    {
      ids.push_back(this->Mesh.Origin(h));
      ids.push_back(this->Mesh.Destination(h));
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  ForEachCoincidentGroup(points, ids, [this](auto first, auto last) {
    if (last - first > 1)
    {
      this->NumberOfCoincidentBoundaryPoints += last - first;
    }
  });
}

//------------------------------------------------------------------------------
void vtkDGGMeshAdapter::CollectWarnings()
{
  const dgg::MeshReport& report = this->Report;
  auto warn = [this](vtkIdType count, const std::string& what) {
    if (count > 0)
    {
      this->Warnings.push_back("the mesh has " + std::to_string(count) + " " + what);
    }
  };
  warn(report.NonManifoldEdges,
    "edges with more than two triangles. Distances pass through them into every triangle");
  warn(report.NonManifoldVertices,
    "points where separate sheets touch. Distances pass through them into every sheet");
  warn(report.InconsistentEdges,
    "edges across which no choice of orientation is consistent, as on a Moebius strip. Distances "
    "do "
    "not depend on orientation");
  warn(this->NumberOfDroppedCells,
    "polygons with fewer than three distinct points, which are left out");
  warn(this->NumberOfFans,
    "polygons that cross or touch themselves. They are cut into fans around their first points, "
    "which "
    "need not be what they are meant to be: triangulate them first");
  std::ostringstream length;
  length << report.Mollification;
  warn(report.DegenerateFaces,
    "triangles without area, whose edges are taken to be longer by " + length.str());
  warn(this->NumberOfCoincidentBoundaryPoints,
    "points of the boundary with the same coordinates as another one. If they are the two sides of "
    "a "
    "seam rather than of a slit, turn MergeCoincidentPoints on");
}
