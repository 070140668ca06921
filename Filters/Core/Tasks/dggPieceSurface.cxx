// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSurface.h"

#include "dggCellCoordinates.h"
#include "dggEdges.h"
#include "dggMeshQuality.h"
#include "dggRowFinder.h"
#include "dggSourceCollection.h"
#include "dggSurfaceOutput.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <variant>

namespace dgg
{
namespace
{
constexpr int FirstLayers = 3;
/// Bytes of a point: its corners in polygons, its positions in input and output, and its values.
constexpr double BytesOfPoint = 256.0;
/// Bytes of a point of a surface that is gathered: polygons, mesh and search of paths.
constexpr double BytesOfNearPoint = 1024.0;

/// Range of the global ids of a piece.
struct IdRange
{
  Offset First = std::numeric_limits<Offset>::max();
  Offset Last = std::numeric_limits<Offset>::min();
  Offset Count = 0;

  void Add(Offset id)
  {
    this->First = std::min(this->First, id);
    this->Last = std::max(this->Last, id);
    ++this->Count;
  }
  void Add(const IdRange& other)
  {
    this->First = std::min(this->First, other.First);
    this->Last = std::max(this->Last, other.Last);
    this->Count += other.Count;
  }
  bool IsConsecutive() const
  {
    return this->Count > 0 && this->Last - this->First + 1 == this->Count;
  }
};

/// Properties of the faces of a piece.
struct PieceFaces
{
  LengthSum Edges;
  MeanAnisotropy Anisotropy;

  void Add(const PieceFaces& piece)
  {
    this->Edges.Add(piece.Edges);
    this->Anisotropy.Add(piece.Anisotropy);
  }
};

/// Numbers of points and cells of a piece.
struct PieceNumbers
{
  IdRange Points; // that belong to the process
  IdRange Cells;
  bool AreTriangles = true;

  void Add(const PieceNumbers& piece)
  {
    this->Points.Add(piece.Points);
    this->Cells.Add(piece.Cells);
    this->AreTriangles = this->AreTriangles && piece.AreTriangles;
  }
};

/// A point of one process for all others.
struct SharedPoint
{
  std::size_t Index;
  SurfacePoint Point; // with vertices, half-edges and faces of the sender
  Offset GlobalId;    // of the point at a vertex, otherwise of the cell
  Id Triangle;        // of the cell
};

/// Replaces the ids in an array by `idOf(id)`; NoId is kept.
template <typename IdOf>
void Replace(OutputArrays& arrays, const std::string& name, const IdOf& idOf)
{
  for (OutputArray& array : arrays)
  {
    if (array.Name == name)
    {
      auto& ids = std::get<Buffer<Offset>>(array.Values);
      std::transform(ids.begin(), ids.end(), ids.begin(),
        [&](Offset id) { return id == NoId ? NoId : idOf(id); });
    }
  }
}
}

Status PieceSurface::Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Start(group, piece, FirstLayers, isUsable));
  return isUsable ? this->MakeSurface() : Status::Success();
}

Status PieceSurface::Grow(ProcessGroup& group, int layers, double inUse)
{
  DGG_RETURN_IF_ERROR(this->Region.Grow(group, layers, true, inUse));
  this->NumberOfLayers += layers;
  this->MakeArrays();
  return this->MakeSurface();
}

const GraphBuilder* PieceSurface::GetBuilder()
{
  if (!this->Builder && !this->Layers.empty())
  {
    GraphRegion region;
    region.IsRim = this->Polygons.IsRim;
    for (const Id point : this->Polygons.Points)
    {
      region.PointIds.push_back(this->Region.GetPointId(point));
    }
    region.NumberOfFaces = this->TotalFaces;
    this->Builder = std::make_unique<const GraphBuilder>(this->Surface->GetMesh(), region);
  }
  return this->Builder.get();
}

Status PieceSurface::PrepareToGather(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Start(group, piece, 1, isUsable)); // all cells at the points
  this->Polygons = RegionPolygons();
  return Status::Success();
}

Status PieceSurface::GatherNear(
  ProcessGroup& group, const std::function<bool(const double*)>& isNear, double inUse)
{
  DGG_RETURN_IF_ERROR(this->Region.GrowFirst(group, isNear, inUse));
  Status status;
  if (group.Here == 0)
  {
    this->MakeArrays(isNear);
    status = CheckMemory("The surface around paths",
      inUse + this->Region.GetMemorySize() +
        BytesOfNearPoint * static_cast<double>(this->Polygons.Points.size()),
      group.MemoryLimit, "Use fewer pairs at a time");
    status = status.IsOk() ? this->MakeSurface() : status;
  }
  return group.Agree(status);
}

Status PieceSurface::Start(
  ProcessGroup& group, const SurfacePiece& piece, int layers, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Region.Start(group, piece, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->Region.Grow(group, layers, true, 0.0));
  this->NumberOfLayers = layers;
  DGG_RETURN_IF_ERROR(this->CheckFaces(group, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  this->MakeArrays();
  return this->CheckIds(group, piece, isUsable);
}

void PieceSurface::MakeArrays(const std::function<bool(const double*)>& isNear)
{
  this->Polygons = this->Region.MakePolygons(isNear);
  this->Arrays.Points = this->Polygons.Positions.data();
  this->Arrays.NumberOfPoints = static_cast<Offset>(this->Polygons.Points.size());
  this->Arrays.Polygons = { static_cast<Offset>(this->Polygons.CellIds.size()),
    this->Polygons.Offsets.data(), this->Polygons.Corners.data(),
    static_cast<Offset>(this->Polygons.Corners.size()) };
}

Status PieceSurface::MakeSurface()
{
  this->Builder.reset();
  this->Surface = std::make_shared<const PreparedSurface>();
  this->Layers.clear();
  if (!this->Polygons.CellIds.empty())
  {
    DGG_RETURN_IF_ERROR(PreparedSurface::Make(this->Arrays, Domain(),
      PreparedSurface::ComputeFingerprint(this->Arrays, Domain()), this->Surface));
    const Id faces = this->Surface->GetMeshWithoutAngles().GetNumberOfFaces();
    for (Id f = 0; f < faces; ++f)
    {
      this->Layers.push_back(this->Polygons.Layers[this->Surface->GetCell(f)]);
    }
  }
  return Status::Success();
}

/// Checks the faces of all pieces, and measures the mean edge length.
Status PieceSurface::CheckFaces(ProcessGroup& group, bool& isUsable)
{
  RegionMesh region;
  this->Region.MakeMesh(region);
  SurfaceFacts facts = this->Region.MeasureFacts(region);
  const SurfaceMesh& mesh = region.Mesh;
  DGG_RETURN_IF_ERROR(facts.Share(group));
  this->TotalFaces = facts.NumberOfFaces;
  this->LongestEdge = facts.LongestEdge;
  PieceFaces faces{ LengthSum(facts.LongestEdge), {} };
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (region.CellIds[f] != NoId && !mesh.IsDropped(f))
    {
      faces.Anisotropy.Add(mesh, f);
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        faces.Edges.Add(mesh.Length(h), FindEdge(mesh, h) == h);
      }
    }
  }
  DGG_RETURN_IF_ERROR(group.Sum(faces));
  this->MeanEdgeLength = faces.Edges.GetMean();
  this->HasLong = MayHaveLongTriangles(faces.Anisotropy);
  isUsable = facts.IsRegular && facts.Defects.NonManifoldEdges == 0;
  return Status::Success();
}

/// Checks that ids number the points and cells of all pieces.
Status PieceSurface::CheckIds(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  PieceNumbers here;
  here.AreTriangles = CellCoordinates::AreAllTriangles(this->Arrays);
  for (Id point = 0; point < this->Region.GetNumberOfPoints(); ++point)
  {
    if (this->Region.GetOwner(point) == group.Here)
    {
      here.Points.Add(this->Region.GetPointId(point));
    }
  }
  for (std::size_t i = 0; i < this->Polygons.CellIds.size(); ++i)
  {
    if (this->Polygons.Layers[i] == 0)
    {
      here.Cells.Add(this->Polygons.CellIds[i]);
    }
  }
  PieceNumbers all = here;
  DGG_RETURN_IF_ERROR(group.Sum(all));
  this->TotalPoints = all.Points.Count;
  this->FirstPoint = all.Points.First;
  this->FirstCell = all.Cells.First;
  isUsable = all.Points.IsConsecutive() && all.Cells.IsConsecutive() &&
    here.AreTriangles == all.AreTriangles && here.Cells.Count == piece.GetNumberOfCells() &&
    (here.Points.Count == 0 || !this->Polygons.CellIds.empty());
  return group.Require(isUsable);
}

TaskContext PieceSurface::MakeContext(const TaskContext& context) const
{
  return { *this->Surface, context.Memory, context.NumberOfThreads, context.Progress,
    context.Parallel, [this]() -> const SurfaceArrays& { return this->Arrays; } };
}

FieldPieces PieceSurface::MakeFieldPieces(ProcessGroup& group) const
{
  return { group, this->MeanEdgeLength, this->LongestEdge,
    [this](Id v) { return this->Region.GetPointId(this->Polygons.Points[v]); },
    [this](Id f) { return this->Polygons.CellIds[this->Surface->GetCell(f)]; } };
}

Status PieceSurface::Extend(ProcessGroup& group, int components, std::vector<double>& values) const
{
  const double inUse = static_cast<double>(this->Surface->GetMeshWithoutAngles().GetMemorySize()) +
    BytesOfPoint * static_cast<double>(this->Polygons.Points.size());
  const auto size = static_cast<std::size_t>(components);
  values.resize(size * this->Polygons.Points.size());
  DGG_RETURN_IF_ERROR(this->Region.TakeFromOwners(group, components, values, inUse));
  std::vector<double> sorted;
  sorted.reserve(values.size());
  for (const Id point : this->Polygons.Points)
  {
    const auto at = values.begin() + components * static_cast<Offset>(point);
    sorted.insert(sorted.end(), at, at + components);
  }
  values.swap(sorted);
  return Status::Success();
}

Status PieceSurface::Locate(
  ProcessGroup& group, const SourceCollection& sources, double tolerance, PiecePoints& here) const
{
  const std::size_t ids = sources.Ids.size();
  for (std::size_t i = 0; i < ids; ++i)
  {
    this->AddVertex(sources.Ids[i], i, group.Here, here);
  }
  if (sources.GetNumberOfPositions() == 0)
  {
    return Status::Success();
  }
  std::vector<Offset> cells; // of the piece
  for (std::size_t f = 0; f < this->Layers.size(); ++f)
  {
    const Offset cell = this->Surface->GetCell(static_cast<Id>(f));
    cells.push_back(this->Layers[f] > 0 ? NoId : this->Polygons.CellIds[cell]);
  }
  PieceLocator locator;
  DGG_RETURN_IF_ERROR(locator.Prepare(
    group, this->Surface->GetMeshWithoutAngles(), this->Surface->GetPositions(), cells));
  PiecePoints located;
  DGG_RETURN_IF_ERROR(locator.Locate(group, sources, tolerance, located));
  for (std::size_t k = 0; k < located.Points.size(); ++k)
  {
    here.Add(ids + located.Indices[k], located.Points[k]);
  }
  return Status::Success();
}

Status PieceSurface::ShareAll(
  ProcessGroup& group, const PiecePoints& here, std::vector<SurfacePoint>& points) const
{
  std::vector<SharedPoint> shared;
  for (std::size_t i = 0; i < here.Points.size(); ++i)
  {
    SharedPoint point{ here.Indices[i], here.Points[i], NoId, 0 };
    if (IsVertex(point.Point))
    {
      point.GlobalId = this->Region.GetPointId(this->Polygons.Points[point.Point.Vertex]);
    }
    else
    {
      point.GlobalId = this->Polygons.CellIds[this->Surface->GetCell(point.Point.Face)];
      point.Triangle = point.Point.Face - this->FindFace(point.GlobalId);
    }
    shared.push_back(point);
  }
  DGG_RETURN_IF_ERROR(group.JoinLists(shared));
  points.assign(shared.size(), SurfacePoint());
  for (const SharedPoint& found : shared)
  {
    SurfacePoint point = found.Point;
    if (IsVertex(point))
    {
      point = SurfacePoint::AtVertex(this->FindVertex(found.GlobalId));
    }
    else
    {
      const Id first = this->FindFace(found.GlobalId);
      const Id face = first + found.Triangle;
      point.HalfEdge = point.HalfEdge == NoId ? NoId : 3 * face + point.HalfEdge % 3;
      point.Face = face;
      point = first == NoId ? SurfacePoint() : point;
    }
    points[found.Index] = point;
  }
  return Status::Success();
}

/// Returns the first face of a cell with a global id; NoId if the cell is not on the surface.
Id PieceSurface::FindFace(Offset cellId) const
{
  const auto faces = static_cast<Id>(this->Layers.size());
  Id first = 0;
  for (Id end = faces; first < end;)
  {
    const Id middle = first + (end - first) / 2;
    const bool isBefore = this->Polygons.CellIds[this->Surface->GetCell(middle)] < cellId;
    (isBefore ? first : end) = isBefore ? middle + 1 : middle;
  }
  return first < faces && this->Polygons.CellIds[this->Surface->GetCell(first)] == cellId ? first
                                                                                          : NoId;
}

void PieceSurface::AddVertex(Offset point, std::size_t index, int process, PiecePoints& here) const
{
  const Id v = this->GetVertexOf(point);
  if (v != NoId && this->Region.GetOwner(this->Polygons.Points[v]) == process)
  {
    here.Add(index, SurfacePoint::AtVertex(v));
  }
}

Id PieceSurface::FindVertex(Offset globalId) const
{
  const std::vector<Id>& points = this->Polygons.Points;
  const auto found = std::lower_bound(points.begin(), points.end(), globalId,
    [this](Id p, Offset wanted) { return this->Region.GetPointId(p) < wanted; });
  return found != points.end() && this->Region.GetPointId(*found) == globalId
    ? static_cast<Id>(found - points.begin())
    : NoId;
}

Status PieceSurface::WritePoints(
  const TaskContext& context, ProcessGroup& group, const PiecePoints& here, Output& output) const
{
  WriteSurfacePoints(this->MakeContext(context), here.Points, output);
  this->Renumber(output);
  DGG_RETURN_IF_ERROR(group.Gather(here.Indices, 3, output.Points));
  for (OutputArray& array : output.PointData)
  {
    DGG_RETURN_IF_ERROR(std::visit(
      [&](auto& values) { return group.Gather(here.Indices, array.NumberOfComponents, values); },
      array.Values));
  }
  WriteVerts(output.Points.Size() / 3, output);
  return Status::Success();
}

void PieceSurface::Renumber(Output& output) const
{
  Replace(output.PointData, "vtkOriginalPointIds", [this](Offset point) {
    return this->Region.GetPointId(this->Polygons.Points[point]) - this->FirstPoint;
  });
  for (OutputArrays* arrays : { &output.PointData, &output.CellData })
  {
    Replace(*arrays, "FaceId",
      [this](Offset cell) { return this->Polygons.CellIds[cell] - this->FirstCell; });
  }
}
}
