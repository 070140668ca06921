// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceRegion.h"

#include "dggCapSplitting.h"
#include "dggPolygonTriangulator.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
constexpr int Polygons = 2; // kinds of cells, see NumberOfCellKinds
constexpr int Strips = 3;

/// Margin of the slack of faces that no process treats as degenerate: the largest tolerance of
/// SplitCaps(), which exceeds that of SurfaceMesh, with a margin.
constexpr double SlackMargin = 4.0 * DegeneracySlack;
/// Lengths in this range, and sums of as many of them as there are faces, are floats.
constexpr double ShortestLength = 1e-25;
constexpr double LongestPath = 1e37;

/// Bytes of a point of a region: its id, position and holders, and its entry in the map of points.
constexpr double BytesOfPoint = sizeof(Offset) + 3 * sizeof(double) + sizeof(Id) + 56;

/// Copy of a point that a process has sent.
struct SentPoint
{
  Offset Id;
  int Process;
  std::array<double, 3> Position;

  bool operator<(const SentPoint& other) const
  {
    return std::tie(this->Id, this->Process) < std::tie(other.Id, other.Process);
  }
};

/// Returns the process that compares all copies of an element.
std::size_t GetRegistrar(const ProcessGroup& group, Offset id)
{
  return static_cast<std::uint64_t>(id) % static_cast<std::uint64_t>(group.Count);
}

/// Returns the difference between the sum of two edges of a face and the third edge, without loss
/// of accuracy.
double GetSlack(const SurfaceMesh& mesh, Id face)
{
  std::array<double, 3> lengths{ mesh.Length(3 * face), mesh.Length(3 * face + 1),
    mesh.Length(3 * face + 2) };
  std::sort(lengths.begin(), lengths.end());
  return lengths[0] - (lengths[2] - lengths[1]);
}

/// Returns true if the piece has what a region needs.
bool IsValid(const SurfacePiece& piece)
{
  return piece.Check().IsOk() && piece.Cells[Strips].NumberOfCells == 0 &&
    (piece.PointIds || piece.NumberOfPoints == 0) &&
    (piece.CellIds || piece.GetNumberOfCells() == 0) &&
    std::all_of(piece.Points, piece.Points + 3 * piece.NumberOfPoints,
      [](double coordinate) { return std::isfinite(coordinate); });
}

template <typename T>
void AppendTo(std::vector<T>& all, const std::vector<T>& more)
{
  all.insert(all.end(), more.begin(), more.end());
}
}

Status SurfaceRegion::Start(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  *this = SurfaceRegion();
  this->Here = group.Here;
  isUsable = IsValid(piece) && this->AddPiece(piece);
  DGG_RETURN_IF_ERROR(group.Require(isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  this->IsSent.resize(static_cast<std::size_t>(group.Count));
  this->IsPointSent.resize(static_cast<std::size_t>(group.Count));
  DGG_RETURN_IF_ERROR(this->FindHolders(group, isUsable));
  for (Id point = 0; point < this->GetNumberOfPoints(); ++point)
  {
    this->AddToRim(point);
  }
  return group.Require(isUsable);
}

/// Adds the points and polygons of the piece. Returns false if two points have the same id.
bool SurfaceRegion::AddPiece(const SurfacePiece& piece)
{
  const Id onlyHere = this->GetSet({ this->Here });
  for (Offset i = 0; i < piece.NumberOfPoints; ++i)
  {
    if (this->AddPoint(piece.PointIds[i], piece.Points + 3 * i, onlyHere) != i)
    {
      return false;
    }
  }
  const CellArrays& polygons = piece.Cells[Polygons];
  const Offset first = piece.Cells[0].NumberOfCells + piece.Cells[1].NumberOfCells;
  std::vector<Id> cellOfCorners;
  this->Cells.reserve(static_cast<std::size_t>(polygons.NumberOfCells));
  this->Corners.reserve(static_cast<std::size_t>(polygons.NumberOfIds));
  for (Offset i = 0; i < polygons.NumberOfCells; ++i)
  {
    const auto size = static_cast<std::size_t>(polygons.End(i) - polygons.Begin(i));
    this->Cells.push_back({ piece.CellIds[first + i], this->Corners.size(), size, this->Here });
    this->Corners.insert(this->Corners.end(), polygons.Begin(i), polygons.End(i));
    cellOfCorners.insert(cellOfCorners.end(), size, static_cast<Id>(i));
  }
  this->NumberOfOwnCells = this->Cells.size();
  this->CellsOfPoints = MakeGroups(this->Corners, this->PointIds.size());
  for (Id& member : this->CellsOfPoints.Members)
  {
    member = cellOfCorners[member];
  }
  return true;
}

/// Finds the processes that use the points of the piece. Every id is registered at one process,
/// which compares its copies.
Status SurfaceRegion::FindHolders(ProcessGroup& group, bool& isUnique)
{
  const auto count = static_cast<std::size_t>(group.Count);
  std::vector<std::vector<Offset>> ids(count);
  std::vector<std::vector<double>> positions(count);
  std::vector<std::vector<Offset>> cells(count);
  for (std::size_t i = 0; i < this->PointIds.size(); ++i)
  {
    const std::size_t process = GetRegistrar(group, this->PointIds[i]);
    ids[process].push_back(this->PointIds[i]);
    positions[process].insert(positions[process].end(), this->Positions.begin() + 3 * i,
      this->Positions.begin() + 3 * i + 3);
  }
  for (const Cell& cell : this->Cells)
  {
    cells[GetRegistrar(group, cell.GlobalId)].push_back(cell.GlobalId);
  }
  std::vector<Message> messages(count);
  for (std::size_t process = 0; process < count; ++process)
  {
    Append(messages[process], ids[process]);
    Append(messages[process], positions[process]);
    Append(messages[process], cells[process]);
  }
  DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize()));

  std::vector<SentPoint> points;
  std::vector<Offset> allCells;
  for (int process = 0; process < group.Count; ++process)
  {
    MessageReader reader(messages[process]);
    const std::vector<Offset> sent = reader.Take<Offset>();
    const std::vector<double> at = reader.Take<double>();
    for (std::size_t i = 0; i < sent.size(); ++i)
    {
      points.push_back({ sent[i], process, { at[3 * i], at[3 * i + 1], at[3 * i + 2] } });
    }
    AppendTo(allCells, reader.Take<Offset>());
    messages[process].clear();
  }
  std::sort(allCells.begin(), allCells.end());
  isUnique = std::adjacent_find(allCells.begin(), allCells.end()) == allCells.end();
  std::sort(points.begin(), points.end());
  std::vector<std::vector<Offset>> shared(count); // id, number of processes, processes
  for (auto begin = points.begin(); begin != points.end();)
  {
    auto end = begin + 1;
    for (; end != points.end() && end->Id == begin->Id; ++end)
    {
      isUnique = isUnique && end->Position == begin->Position;
    }
    for (auto to = begin; to != end && end - begin > 1; ++to)
    {
      shared[to->Process].insert(shared[to->Process].end(), { begin->Id, end - begin });
      std::for_each(
        begin, end, [&](const SentPoint& copy) { shared[to->Process].push_back(copy.Process); });
    }
    begin = end;
  }
  for (std::size_t process = 0; process < count; ++process)
  {
    Append(messages[process], shared[process]);
  }
  DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize()));
  for (const Message& message : messages)
  {
    const std::vector<Offset> list = MessageReader(message).Take<Offset>();
    for (std::size_t i = 0; i < list.size(); i += 2 + static_cast<std::size_t>(list[i + 1]))
    {
      const auto begin = list.begin() + static_cast<std::ptrdiff_t>(i) + 2;
      this->Holders[this->Points.at(list[i])] =
        this->GetSet(std::vector<int>(begin, begin + list[i + 1]));
    }
  }
  return Status::Success();
}

Id SurfaceRegion::AddVertex(Offset globalId, int owner)
{
  constexpr double nowhere[3] = { 0.0, 0.0, 0.0 };
  return this->AddPoint(globalId, nowhere, this->GetSet({ owner }));
}

/// Finds the points of the region that belong to each other process, and the global ids of the
/// points of this process that each other process requests.
Status SurfaceRegion::RequestFromOwners(ProcessGroup& group, std::vector<std::vector<Id>>& points,
  std::vector<std::vector<Offset>>& requested, double inUse) const
{
  points.resize(static_cast<std::size_t>(group.Count));
  requested.resize(points.size());
  for (Id point = 0; point < this->GetNumberOfPoints(); ++point)
  {
    const int owner = this->GetOwner(point);
    if (owner != group.Here)
    {
      points[owner].push_back(point);
      requested[owner].push_back(this->PointIds[point]);
    }
  }
  return group.ExchangeLists(requested, this->GetMemorySize() + inUse);
}

Status SurfaceRegion::TakeFromOwners(
  ProcessGroup& group, int components, std::vector<double>& values, double inUse) const
{
  const auto count = static_cast<std::size_t>(group.Count);
  std::vector<std::vector<Id>> points;
  std::vector<std::vector<Offset>> ids;
  inUse += static_cast<double>(values.size() * sizeof(double));
  DGG_RETURN_IF_ERROR(this->RequestFromOwners(group, points, ids, inUse));
  inUse += this->GetMemorySize();
  std::vector<std::vector<double>> lists(count);
  for (std::size_t process = 0; process < count; ++process)
  {
    for (const Offset id : ids[process])
    {
      const auto begin = values.begin() + components * static_cast<Offset>(this->GetPoint(id));
      lists[process].insert(lists[process].end(), begin, begin + components);
    }
  }
  DGG_RETURN_IF_ERROR(group.ExchangeLists(lists, inUse));
  for (std::size_t process = 0; process < count; ++process)
  {
    auto next = lists[process].begin();
    for (const Id point : points[process])
    {
      std::copy_n(next, components, values.begin() + components * static_cast<Offset>(point));
      next += components;
    }
  }
  return Status::Success();
}

/// Adds a point unless it is in the region already. Returns its index.
Id SurfaceRegion::AddPoint(Offset globalId, const double* position, Id holders)
{
  const auto added = this->Points.emplace(globalId, this->GetNumberOfPoints());
  if (added.second)
  {
    this->PointIds.push_back(globalId);
    this->Positions.insert(this->Positions.end(), position, position + 3);
    this->Holders.push_back(holders);
  }
  return added.first->second;
}

/// Returns the index of a set of processes in Sets.
Id SurfaceRegion::GetSet(const std::vector<int>& holders)
{
  const auto added = this->IndexOfSet.try_emplace(holders, static_cast<Id>(this->Sets.size()));
  if (added.second)
  {
    this->Sets.push_back(holders);
  }
  return added.first->second;
}

/// Adds a new point to the rim if other processes have cells at the point.
void SurfaceRegion::AddToRim(Id point)
{
  const std::vector<int>& holders = this->GetHolders(point);
  if (holders.size() > 1 || holders.front() != this->Here)
  {
    this->Rim.push_back(point);
  }
}

Status SurfaceRegion::Grow(ProcessGroup& group, int layers, bool isNeeded, double inUse)
{
  const auto count = static_cast<std::size_t>(group.Count);
  std::vector<Message> messages(count);
  bool isComplete = false; // all regions
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<std::vector<Offset>> requested(count);
    for (const Id point : this->Rim)
    {
      for (const int process : this->GetHolders(point))
      {
        if (isNeeded && process != group.Here)
        {
          requested[process].push_back(this->PointIds[point]);
        }
      }
    }
    for (std::size_t process = 0; process < count; ++process)
    {
      messages[process].clear();
      AppendIfAny(messages[process], requested[process]);
    }
    DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize() + inUse, &isComplete));
    if (isComplete)
    {
      return Status::Success();
    }
    for (std::size_t process = 0; process < count; ++process)
    {
      const std::vector<Offset> ids = MessageReader(messages[process]).Take<Offset>();
      messages[process].clear();
      this->Answer(process, ids, messages[process]);
    }
    DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize() + inUse));
    if (isNeeded)
    {
      this->Rim.clear();
    }
    this->LayerBegins.push_back(this->Cells.size());
    this->AddCells(messages);
  }
  return Status::Success();
}

Status SurfaceRegion::GrowFirst(
  ProcessGroup& group, const std::function<bool(const double*)>& isNear, double inUse)
{
  std::vector<Message> messages(static_cast<std::size_t>(group.Count));
  if (group.Here != 0)
  {
    std::vector<Offset> near;
    for (std::size_t point = 0; point + 1 < this->CellsOfPoints.Begins.size(); ++point)
    {
      if (isNear(this->Positions.data() + 3 * point))
      {
        near.push_back(this->PointIds[point]);
      }
    }
    this->Answer(0, near, messages.front());
  }
  DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize() + inUse));
  this->AddCells(messages);
  return Status::Success();
}

/// Sends a process the polygons of the piece at the requested points, each polygon and point once.
void SurfaceRegion::Answer(
  std::size_t process, const std::vector<Offset>& requested, Message& answer)
{
  std::vector<Offset> cellIds;
  std::vector<Offset> sizes;
  std::vector<Offset> corners;
  std::vector<Offset> pointIds;
  std::vector<double> positions;
  std::vector<int> holders; // their number, then the processes
  if (!requested.empty())
  {
    this->IsSent[process].resize(this->NumberOfOwnCells);
    this->IsPointSent[process].resize(this->CellsOfPoints.Begins.size());
  }
  for (const Offset id : requested)
  {
    const Id point = this->Points.at(id);
    const auto end = this->CellsOfPoints.Begins[point + 1];
    for (Offset i = this->CellsOfPoints.Begins[point]; i < end; ++i)
    {
      const Id c = this->CellsOfPoints.Members[i];
      if (this->IsSent[process][c])
      {
        continue;
      }
      this->IsSent[process][c] = true;
      const Cell& cell = this->Cells[c];
      cellIds.push_back(cell.GlobalId);
      sizes.push_back(static_cast<Offset>(cell.Size));
      for (std::size_t k = cell.Begin; k < cell.Begin + cell.Size; ++k)
      {
        const Id corner = this->Corners[k];
        corners.push_back(this->PointIds[corner]);
        if (!this->IsPointSent[process][corner])
        {
          this->IsPointSent[process][corner] = true;
          pointIds.push_back(this->PointIds[corner]);
          const double* const at = this->Positions.data() + 3 * static_cast<Offset>(corner);
          positions.insert(positions.end(), at, at + 3);
          const std::vector<int>& ofCorner = this->GetHolders(corner);
          holders.push_back(static_cast<int>(ofCorner.size()));
          AppendTo(holders, ofCorner);
        }
      }
    }
  }
  Append(answer, cellIds);
  Append(answer, sizes);
  Append(answer, corners);
  Append(answer, pointIds);
  Append(answer, positions);
  Append(answer, holders);
}

/// Adds the cells and points of an answer.
void SurfaceRegion::AddCells(const std::vector<Message>& messages)
{
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    MessageReader reader(messages[process]);
    const auto cellIds = reader.Take<Offset>();
    const auto sizes = reader.Take<Offset>();
    const auto corners = reader.Take<Offset>();
    const auto pointIds = reader.Take<Offset>();
    const auto positions = reader.Take<double>();
    const auto holders = reader.Take<int>();
    auto next = holders.begin();
    for (std::size_t i = 0; i < pointIds.size(); ++i)
    {
      const auto end = next + 1 + *next;
      const Id before = this->GetNumberOfPoints();
      const Id point = this->AddPoint(
        pointIds[i], positions.data() + 3 * i, this->GetSet(std::vector<int>(next + 1, end)));
      if (point == before)
      {
        this->AddToRim(point);
      }
      next = end;
    }
    auto corner = corners.begin();
    for (std::size_t i = 0; i < cellIds.size(); ++i)
    {
      this->Cells.push_back({ cellIds[i], this->Corners.size(), static_cast<std::size_t>(sizes[i]),
        static_cast<int>(process) });
      for (const auto end = corner + sizes[i]; corner != end; ++corner)
      {
        this->Corners.push_back(this->Points.at(*corner));
      }
    }
  }
}

double SurfaceRegion::GetMemorySize() const
{
  const auto points = static_cast<double>(this->PointIds.capacity());
  double bits = 0.0;
  for (std::size_t process = 0; process < this->IsSent.size(); ++process)
  {
    bits += static_cast<double>(this->IsSent[process].size() + this->IsPointSent[process].size());
  }
  return BytesOfPoint * points + static_cast<double>(this->Cells.capacity() * sizeof(Cell)) +
    static_cast<double>(sizeof(Id) *
      (this->Corners.capacity() + this->CellsOfPoints.Members.size() + this->Rim.capacity())) +
    bits / 8.0;
}

std::vector<Id> SurfaceRegion::GetOrder() const
{
  std::vector<Id> order(this->PointIds.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [this](Id a, Id b) { return this->PointIds[a] < this->PointIds[b]; });
  return order;
}

/// Returns the cells in the order of global ids.
std::vector<std::size_t> SurfaceRegion::GetOrderOfCells() const
{
  std::vector<std::size_t> cells(this->Cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  std::sort(cells.begin(), cells.end(), [this](std::size_t a, std::size_t b) {
    return this->Cells[a].GlobalId < this->Cells[b].GlobalId;
  });
  return cells;
}

RegionPolygons SurfaceRegion::MakePolygons(const std::function<bool(const double*)>& isNear) const
{
  RegionPolygons polygons;
  std::vector<Id> order = this->GetOrder();
  std::vector<std::size_t> cells = this->GetOrderOfCells();
  std::vector<std::uint8_t> isFar(order.size());
  for (const Id point : this->Rim)
  {
    isFar[point] = 1;
  }
  if (isNear)
  {
    std::vector<std::uint8_t> isUsed(order.size(), 0);
    for (const Id point : order)
    {
      isFar[point] = isNear(this->Positions.data() + 3 * static_cast<Offset>(point)) ? 0 : 1;
    }
    const auto isUnused = [&](std::size_t c) {
      const auto begin = this->Corners.begin() + static_cast<Offset>(this->Cells[c].Begin);
      const auto end = begin + static_cast<Offset>(this->Cells[c].Size);
      const bool areFar = std::all_of(begin, end, [&](Id corner) { return isFar[corner] != 0; });
      std::for_each(begin, end, [&](Id corner) { isUsed[corner] |= areFar ? 0 : 1; });
      return areFar;
    };
    cells.erase(std::remove_if(cells.begin(), cells.end(), isUnused), cells.end());
    order.erase(
      std::remove_if(order.begin(), order.end(), [&](Id p) { return !isUsed[p]; }), order.end());
  }
  std::vector<Offset> rank(this->PointIds.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<Offset>(i);
    const auto at = this->Positions.begin() + 3 * static_cast<Offset>(order[i]);
    polygons.Positions.insert(polygons.Positions.end(), at, at + 3);
    polygons.IsRim.push_back(isFar[order[i]]);
  }
  polygons.Points = std::move(order);
  polygons.Offsets.push_back(0);
  for (const std::size_t c : cells)
  {
    const Cell& cell = this->Cells[c];
    std::transform(this->Corners.begin() + static_cast<Offset>(cell.Begin),
      this->Corners.begin() + static_cast<Offset>(cell.Begin + cell.Size),
      std::back_inserter(polygons.Corners), [&](Id corner) { return rank[corner]; });
    polygons.Offsets.push_back(static_cast<Offset>(polygons.Corners.size()));
    polygons.CellIds.push_back(cell.GlobalId);
    polygons.Owners.push_back(cell.Owner);
    const auto next = std::upper_bound(this->LayerBegins.begin(), this->LayerBegins.end(), c);
    polygons.Layers.push_back(static_cast<std::uint8_t>(std::min<Offset>(
      next - this->LayerBegins.begin(), std::numeric_limits<std::uint8_t>::max())));
  }
  return polygons;
}

Status SurfaceFacts::Share(ProcessGroup& group)
{
  std::vector<SurfaceFacts> parts;
  DGG_RETURN_IF_ERROR(group.Share(*this, parts));
  *this = SurfaceFacts();
  for (const SurfaceFacts& part : parts)
  {
    this->IsRegular = this->IsRegular && part.IsRegular;
    this->Defects.NonManifoldEdges += part.Defects.NonManifoldEdges;
    this->Defects.NonManifoldVertices += part.Defects.NonManifoldVertices;
    this->Defects.DroppedCells += part.Defects.DroppedCells;
    this->Defects.Fans += part.Defects.Fans;
    this->Defects.DuplicateFaces += part.Defects.DuplicateFaces;
    this->NumberOfFaces += part.NumberOfFaces;
    this->LongestEdge = std::max(this->LongestEdge, part.LongestEdge);
    this->ShortestEdge = std::min(this->ShortestEdge, part.ShortestEdge);
    this->SmallestSlack = std::min(this->SmallestSlack, part.SmallestSlack);
  }
  this->IsRegular = this->IsRegular && this->NumberOfFaces > 0 &&
    this->SmallestSlack >= SlackMargin * this->LongestEdge &&
    this->ShortestEdge >= ShortestLength &&
    this->LongestEdge * static_cast<double>(this->NumberOfFaces) <= LongestPath;
  return Status::Success();
}

void SurfaceRegion::MakeMesh(RegionMesh& region) const
{
  region = RegionMesh();
  region.Points = this->GetOrder();
  const std::vector<Id>& order = region.Points;
  std::vector<double>& positions = region.Positions;
  std::vector<Id> rank(order.size());
  positions.resize(3 * order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<Id>(i);
    std::copy_n(this->Positions.begin() + 3 * static_cast<Offset>(order[i]), 3,
      positions.begin() + 3 * static_cast<Offset>(i));
  }
  region.IsRim.assign(this->Rim.empty() ? 0 : order.size(), 0);
  for (const Id point : this->Rim)
  {
    region.IsRim[rank[point]] = 1;
  }
  PolygonTriangulator triangulator(positions.data());
  std::vector<Id> triangles;
  std::vector<Id> corners;
  for (const std::size_t c : this->GetOrderOfCells())
  {
    const Cell& cell = this->Cells[c];
    corners.clear();
    for (std::size_t k = cell.Begin; k < cell.Begin + cell.Size; ++k)
    {
      corners.push_back(rank[this->Corners[k]]);
    }
    const Offset fans = triangulator.GetNumberOfFans();
    const Id added = triangulator.Triangulate(corners, triangles);
    const bool isOwn = c < this->NumberOfOwnCells;
    if (isOwn)
    {
      region.OwnFaces += added;
      region.DroppedCells += added == 0 ? 1 : 0;
      region.Fans += triangulator.GetNumberOfFans() - fans;
    }
    region.CellIds.insert(
      region.CellIds.end(), static_cast<std::size_t>(added), isOwn ? cell.GlobalId : NoId);
  }
  region.IsValid = SurfaceMesh::FromPoints(positions.data(), static_cast<Offset>(order.size()),
    triangles.data(), static_cast<Offset>(triangles.size() / 3), region.Mesh,
    region.IsRim.empty() ? nullptr : region.IsRim.data())
                     .IsOk();
}

SurfaceFacts SurfaceRegion::MeasureFacts(const RegionMesh& region) const
{
  const SurfaceMesh& mesh = region.Mesh;
  SurfaceFacts facts;
  facts.IsRegular = region.IsValid;
  facts.NumberOfFaces = region.OwnFaces;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges() && facts.IsRegular; ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      continue;
    }
    const Id twin = mesh.Twin(h);
    facts.IsRegular = !mesh.IsFlipped(SurfaceMesh::Face(h)) &&
      (mesh.IsNonManifold(h) || twin == NoId || mesh.Origin(twin) == mesh.Destination(h));
    facts.LongestEdge = std::max(facts.LongestEdge, mesh.Length(h));
    facts.ShortestEdge = std::min(facts.ShortestEdge, mesh.Length(h));
    facts.SmallestSlack = std::min(facts.SmallestSlack, GetSlack(mesh, SurfaceMesh::Face(h)));
  }
  if (facts.IsRegular)
  {
    facts.Defects =
      CountDefects(mesh, [&](Id v) { return this->GetOwner(region.Points[v]) == this->Here; });
    facts.Defects.DroppedCells = region.DroppedCells;
    facts.Defects.Fans = region.Fans;
  }
  return facts;
}
}
