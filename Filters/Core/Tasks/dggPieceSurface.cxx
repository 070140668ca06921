// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSurface.h"

#include "dggCellCoordinates.h"
#include "dggEdges.h"
#include "dggMeshQuality.h"
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
constexpr int NumberOfLayers = 3;
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
  DGG_RETURN_IF_ERROR(this->Start(group, piece, NumberOfLayers, isUsable));
  return isUsable ? this->MakeSurface() : Status::Success();
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
  std::vector<Offset> cells; // of the piece
  for (std::size_t f = 0; f < this->Layers.size(); ++f)
  {
    const Offset cell = this->Surface->GetCell(static_cast<Id>(f));
    cells.push_back(this->Layers[f] > 0 ? NoId : this->Polygons.CellIds[cell]);
  }
  PieceLocator locator;
  DGG_RETURN_IF_ERROR(locator.Prepare(
    group, this->Surface->GetMeshWithoutAngles(), this->Surface->GetPositions(), cells));
  return locator.Locate(group, sources, tolerance, here);
}

void PieceSurface::AddVertex(Offset point, std::size_t index, int process, PiecePoints& here) const
{
  const Id v = this->FindVertex(this->FirstPoint + point);
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

std::vector<double> PieceSurface::ToPiece(
  const std::vector<double>& values, Offset numberOfPoints) const
{
  std::vector<double> ofPiece(static_cast<std::size_t>(numberOfPoints), Infinity);
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Id point = this->Polygons.Points[v];
    if (point < numberOfPoints)
    {
      ofPiece[point] = values[v];
    }
  }
  return ofPiece;
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
