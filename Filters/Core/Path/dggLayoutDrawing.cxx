// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLayoutDrawing.h"

#include "dggCurveMargin.h"
#include "dggExactPath.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

namespace dgg
{
namespace
{
std::pair<Id, Id> Unordered(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// A new edge among those that were drawn before.
void InsertIntoOrder(EdgeOrder& order, const LayoutDrawing::Sector& sector, Id edge)
{
  if (std::find(order.Edges.begin(), order.Edges.end(), edge) != order.Edges.end())
  {
    return; // known
  }
  auto place = order.Edges.end();
  if (sector.Begin != NoId)
  {
    place = std::find(order.Edges.begin(), order.Edges.end(), sector.Begin);
    place += place != order.Edges.end() ? 1 : 0;
  }
  else if (sector.End != NoId)
  {
    place = std::find(order.Edges.begin(), order.Edges.end(), sector.End);
  }
  order.HasGap = !sector.IsWhole && (sector.Begin == NoId || sector.End == NoId || order.HasGap);
  order.Edges.insert(place, edge);
}
}

Status LayoutDrawing::Begin()
{
  Status status = this->CheckSurface();
  if (status.IsOk())
  {
    status = this->CheckLandmarks();
  }
  if (status.IsOk())
  {
    status = this->Refine(nullptr, this->Refined);
  }
  if (!status.IsOk())
  {
    return status;
  }
  std::map<Id, std::size_t> landmarkAt;
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    const auto added = landmarkAt.emplace(this->Refined.Paths[l][0], l);
    if (!added.second)
    {
      std::ostringstream message;
      message << "landmarks " << added.first->second << " and " << l << " of " << this->Name
              << " are in the same place";
      return Status::Invalid(message.str());
    }
  }
  return this->Cut();
}

Status LayoutDrawing::CheckSurface() const
{
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = this->Mesh.IsDropped(SurfaceMesh::Face(h)) ? NoId : this->Mesh.Twin(h);
    if (t != NoId && (this->Mesh.Twin(t) != h || this->Mesh.Origin(t) != this->Mesh.Destination(h)))
    {
      std::ostringstream message;
      message << "the edge between points " << this->Mesh.Origin(h) << " and "
              << this->Mesh.Destination(h) << " of " << this->Name
              << (this->Mesh.Twin(t) != h ? " has more than two faces"
                                          : " shows that the surface cannot be oriented")
              << ": patches need a surface with two sides";
      return Status::Invalid(message.str());
    }
  }
  return Status::Success();
}

Status LayoutDrawing::CheckLandmarks() const
{
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    const Status status = this->Landmarks[l].Check(this->Mesh);
    std::ostringstream message;
    message << "landmark " << l << " of " << this->Name;
    if (!status.IsOk())
    {
      return Status::Invalid(message.str() + ": " + status.GetMessage());
    }
    if (FindFaceOf(this->Mesh, this->Landmarks[l]) == NoId)
    {
      return Status::Invalid(message.str() + " is a point that no face uses");
    }
  }
  return Status::Success();
}

/// Split the faces along the landmarks, the curves, and one more path if there is one.
Status LayoutDrawing::Refine(const SurfacePath* more, RefinedSurface& refined) const
{
  std::vector<SurfacePath> paths(this->Landmarks.size());
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    paths[l].Points.push_back(this->Landmarks[l]);
  }
  for (const Id e : this->DrawnEdges)
  {
    paths.push_back(this->Curves[e]);
  }
  if (more)
  {
    paths.push_back(*more);
  }
  return RefineAlongPaths(this->Mesh, paths, RefinementOptions(), refined);
}

Status LayoutDrawing::Cut()
{
  // A curve through a point where sheets touch would tie them together.
  Status status =
    CutAlongChains(this->Refined, this->Refined.Paths, this->Opened, PinchedVertices::Split);
  if (status.IsOk())
  {
    status = this->Opened.Build(this->Mesh, this->OpenedMesh);
  }
  if (status.IsOk())
  {
    this->FindSectors();
  }
  return status;
}

void LayoutDrawing::FindSectors()
{
  this->Sectors.clear();
  std::map<Id, Id> landmarkAt;
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    landmarkAt[this->Refined.Paths[l][0]] = static_cast<Id>(l);
  }
  for (Id v = 0; v < this->Opened.GetNumberOfVertices(); ++v)
  {
    const auto landmark = landmarkAt.find(this->Opened.VertexOf[v]);
    const Id* fan = this->OpenedMesh.FanBegin(v);
    if (landmark == landmarkAt.end() || fan == this->OpenedMesh.FanEnd(v))
    {
      continue;
    }
    Sector sector;
    sector.Landmark = landmark->second;
    sector.Vertex = v;
    sector.IsWhole = this->OpenedMesh.Twin(*fan) != NoId;
    if (!sector.IsWhole)
    {
      const Id last = SurfaceMesh::Previous(*(this->OpenedMesh.FanEnd(v) - 1));
      sector.Begin =
        this->FindCurve(sector.Landmark, this->Opened.VertexOf[this->OpenedMesh.Destination(*fan)]);
      sector.End =
        this->FindCurve(sector.Landmark, this->Opened.VertexOf[this->OpenedMesh.Origin(last)]);
    }
    this->Sectors.push_back(sector);
  }
}

/// The curve that leaves a landmark for a neighbour.
Id LayoutDrawing::FindCurve(Id landmark, Id neighbour) const
{
  for (std::size_t i = 0; i < this->DrawnEdges.size(); ++i)
  {
    const Id e = this->DrawnEdges[i];
    const std::vector<Id>& chain = this->Refined.Paths[this->Landmarks.size() + i];
    if ((this->Edges[e][0] == landmark && chain[1] == neighbour) ||
      (this->Edges[e][1] == landmark && chain[chain.size() - 2] == neighbour))
    {
      return e;
    }
  }
  return NoId;
}

std::vector<Id> LayoutDrawing::FindBoundaryLoops() const
{
  std::vector<Id> parent(this->Refined.Points.size());
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](Id v) {
    while (parent[v] != v)
    {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  std::vector<char> isOnBoundary(parent.size(), 0);
  for (std::size_t h = 0; h < this->Refined.Triangles.size(); ++h)
  {
    if (this->Refined.Twins[h] == NoId)
    {
      const Id a = this->Refined.Triangles[h];
      const Id b = this->Refined.Triangles[SurfaceMesh::Next(static_cast<Id>(h))];
      isOnBoundary[a] = 1;
      isOnBoundary[b] = 1;
      parent[root(a)] = root(b);
    }
  }
  std::vector<Id> loops;
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    const Id v = this->Refined.Paths[l][0];
    loops.push_back(isOnBoundary[v] ? root(v) : NoId);
  }
  return loops;
}

Status LayoutDrawing::Survey(const ProgressCallback& progress, std::vector<double>& lengths,
  std::vector<EdgeOrder>& orders) const
{
  lengths.assign(this->Edges.size(), Infinity);
  orders.assign(this->Landmarks.size(), EdgeOrder());
  std::vector<SurfacePath> paths(this->Edges.size());
  ExactPathFinder finder(this->Mesh);
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    std::vector<Id> leaving;
    std::vector<SurfacePoint> to;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->Edges[e][0] == static_cast<Id>(l))
      {
        leaving.push_back(static_cast<Id>(e));
        to.push_back(this->Landmarks[this->Edges[e][1]]);
      }
    }
    if (to.empty())
    {
      continue;
    }
    std::vector<SurfacePath> found;
    Status status = finder.Find(this->Landmarks[l], to,
      progress ? ProgressCallback([&](double fraction) {
        return progress((static_cast<double>(l) + fraction) / this->Landmarks.size());
      })
               : progress,
      found);
    if (!status.IsOk())
    {
      return status;
    }
    for (std::size_t i = 0; i < leaving.size(); ++i)
    {
      if (found[i].IsEmpty())
      {
        return this->Refuse(leaving[i], "they are not connected");
      }
      lengths[leaving[i]] = found[i].Length;
      paths[leaving[i]] = found[i];
    }
  }

  // In which order they leave.
  RefinedSurface crossed;
  SurfaceMesh mesh;
  RefinementOptions options;
  options.InsertCrossings = true;
  if (!RefineAlongPaths(this->Mesh, paths, options, crossed).IsOk() ||
    !crossed.Build(this->Mesh, mesh).IsOk())
  {
    return Status::Success(); // a hint less
  }
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    const std::vector<Id>& chain = crossed.Paths[e];
    for (const int end : { 0, 1 })
    {
      if (chain.size() >= 2)
      {
        orders[this->Edges[e][end]].Edges.push_back(static_cast<Id>(e));
      }
    }
  }
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    std::map<Id, double> place; // of an edge in the fan
    for (const Id e : orders[l].Edges)
    {
      const std::vector<Id>& chain = crossed.Paths[e];
      const bool leaves = this->Edges[e][0] == static_cast<Id>(l);
      const Id v = leaves ? chain.front() : chain.back();
      const Id neighbour = leaves ? chain[1] : chain[chain.size() - 2];
      double position = 0.0;
      place[e] = static_cast<double>(mesh.FanEnd(v) - mesh.FanBegin(v));
      for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g, position += 1.0)
      {
        if (mesh.Destination(*g) == neighbour)
        {
          place[e] = position;
        }
      }
    }
    std::stable_sort(orders[l].Edges.begin(), orders[l].Edges.end(),
      [&](Id a, Id b) { return place[a] < place[b]; });
  }
  return Status::Success();
}

/// Whether the order puts an edge into a sector.
bool LayoutDrawing::Allows(const Sector& sector, const EdgeOrder& order, Id edge) const
{
  const auto place = std::find(order.Edges.begin(), order.Edges.end(), edge);
  if (sector.IsWhole || place == order.Edges.end())
  {
    return true;
  }
  // The nearest edges before and after it that are drawn.
  const auto size = static_cast<std::ptrdiff_t>(order.Edges.size());
  const std::ptrdiff_t index = place - order.Edges.begin();
  Id before = NoId;
  Id after = NoId;
  bool isFirst = true;
  bool isLast = true;
  for (std::ptrdiff_t step = size - 1; step > 0; --step)
  {
    const Id next = order.Edges[(index + step) % size];
    if (this->IsDrawn[next])
    {
      after = next;
      isLast = isLast && index + step >= size;
    }
    const Id previous = order.Edges[(index - step + size) % size];
    if (this->IsDrawn[previous])
    {
      before = previous;
      isFirst = isFirst && index - step < 0;
    }
  }
  if (sector.Begin != NoId && sector.End != NoId)
  {
    return sector.Begin == before && sector.End == after;
  }
  if (sector.Begin == NoId && sector.End == NoId)
  {
    return before == NoId;
  }
  // Beside the boundary of the surface.
  return sector.Begin == NoId ? sector.End == after && (isFirst || !order.HasGap)
                              : sector.Begin == before && (isLast || !order.HasGap);
}

std::vector<LayoutDrawing::Sector> LayoutDrawing::FindAllowed(
  Id landmark, const EdgeOrder& order, Id edge) const
{
  std::vector<Sector> allowed;
  for (const Sector& sector : this->Sectors)
  {
    if (sector.Landmark == landmark && this->Allows(sector, order, edge))
    {
      allowed.push_back(sector);
    }
  }
  return allowed;
}

Status LayoutDrawing::Draw(
  Id edge, std::vector<EdgeOrder>& orders, const ProgressCallback& progress)
{
  const Id a = this->Edges[edge][0];
  const Id b = this->Edges[edge][1];
  const std::vector<Sector> from = this->FindAllowed(a, orders[a], edge);
  const std::vector<Sector> to = this->FindAllowed(b, orders[b], edge);
  if (from.empty() || to.empty())
  {
    return this->Refuse(edge,
      "the order of the edges around landmark " + std::to_string(from.empty() ? a : b) +
        " leaves no room for it");
  }
  SurfacePath best;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    SurfacePath path;
    std::size_t reached = 0;
    Status status = this->Trace(from[i], to, progress, path, reached);
    if (!status.IsOk())
    {
      return status;
    }
    if (!path.IsEmpty() && (best.IsEmpty() || path.Length < best.Length))
    {
      best = path;
      first = i;
      last = reached;
    }
  }
  if (best.IsEmpty())
  {
    return this->Refuse(edge,
      this->DrawnEdges.empty()
        ? "they are not connected"
        : "the other edges separate them. Check that the landmarks correspond, or turn patches "
          "the other way");
  }
  RefinedSurface refined;
  if (!this->Refine(&best, refined).IsOk() || !this->KeepsClear(refined))
  {
    // Once more, at a distance from everything.
    SurfacePath clear;
    Status status = this->TraceClear(from[first], to[last], progress, clear);
    if (!status.IsOk())
    {
      return status;
    }
    const Status fits = clear.IsEmpty() ? Status::Success() : this->Refine(&clear, refined);
    if (clear.IsEmpty() || !fits.IsOk() || !this->KeepsClear(refined))
    {
      return this->Refuse(edge, "there is no room between the other edges: refine the mesh");
    }
    best = clear;
  }
  InsertIntoOrder(orders[a], from[first], edge);
  InsertIntoOrder(orders[b], to[last], edge);
  this->Curves[edge] = std::move(best);
  this->IsDrawn[edge] = 1;
  this->DrawnEdges.push_back(edge);
  this->Refined = std::move(refined);
  return this->Cut();
}

/// Shortest path on the surface cut open, from one sector to the nearest of others. Empty when
/// there is none.
Status LayoutDrawing::Trace(const Sector& from, const std::vector<Sector>& to,
  const ProgressCallback& progress, SurfacePath& path, std::size_t& reached) const
{
  std::vector<SurfacePoint> targets;
  targets.reserve(to.size());
  for (const Sector& sector : to)
  {
    targets.push_back(SurfacePoint::AtVertex(sector.Vertex));
  }
  std::vector<SurfacePath> paths;
  ExactPathFinder finder(this->OpenedMesh);
  Status status = finder.Find(SurfacePoint::AtVertex(from.Vertex), targets, progress, paths);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (!paths[i].IsEmpty() && (path.IsEmpty() || paths[i].Length < path.Length))
    {
      path = this->Opened.ToOldMesh(this->Mesh, this->OpenedMesh, paths[i]);
      reached = i;
    }
  }
  return status;
}

/// The same to one sector, keeping clear of curves and other landmarks.
Status LayoutDrawing::TraceClear(
  const Sector& from, const Sector& to, const ProgressCallback& progress, SurfacePath& path) const
{
  std::vector<char> isBlocked;
  std::vector<char> isCut;
  this->MarkObstacles(from.Vertex, to.Vertex, isBlocked, isCut);
  RefinedSurface rest;
  RemoveMargin(this->Mesh, this->Opened, isBlocked, isCut, rest);
  SurfaceMesh mesh;
  Status status = rest.Build(this->Mesh, mesh);
  std::vector<SurfacePath> paths;
  if (status.IsOk())
  {
    ExactPathFinder finder(mesh);
    status = finder.Find(
      SurfacePoint::AtVertex(from.Vertex), { SurfacePoint::AtVertex(to.Vertex) }, progress, paths);
  }
  if (status.IsOk() && !paths[0].IsEmpty())
  {
    path = rest.ToOldMesh(this->Mesh, mesh, paths[0]);
  }
  return status;
}

/// Vertices that a path between two of them must not touch, and half-edges on curves.
void LayoutDrawing::MarkObstacles(
  Id from, Id to, std::vector<char>& isBlocked, std::vector<char>& isCut) const
{
  std::vector<char> isTaken(this->Refined.Points.size(), 0);
  std::set<std::pair<Id, Id>> onCurves;
  for (const std::vector<Id>& chain : this->Refined.Paths)
  {
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      isTaken[chain[i]] = 1;
      if (i > 0)
      {
        onCurves.insert(Unordered(chain[i - 1], chain[i]));
      }
    }
  }
  isBlocked.assign(this->Opened.Points.size(), 0);
  for (Id v = 0; v < this->Opened.GetNumberOfVertices(); ++v)
  {
    isBlocked[v] = isTaken[this->Opened.VertexOf[v]] && v != from && v != to ? 1 : 0;
  }
  const auto halfEdges = static_cast<Id>(this->Opened.Triangles.size());
  isCut.assign(halfEdges, 0);
  for (Id h = 0; h < halfEdges; ++h)
  {
    const Id a = this->Opened.VertexOf[this->Opened.Triangles[h]];
    const Id b = this->Opened.VertexOf[this->Opened.Triangles[SurfaceMesh::Next(h)]];
    isCut[h] = isTaken[a] && isTaken[b] && onCurves.count(Unordered(a, b)) > 0 ? 1 : 0;
  }
}

/// Whether the last path meets the others, and itself, at its ends only.
bool LayoutDrawing::KeepsClear(const RefinedSurface& refined) const
{
  std::vector<char> isTaken(refined.Points.size(), 0);
  for (std::size_t p = 0; p + 1 < refined.Paths.size(); ++p)
  {
    for (const Id v : refined.Paths[p])
    {
      isTaken[v] = 1;
    }
  }
  const std::vector<Id>& chain = refined.Paths.back();
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const bool isEnd = i == 0 || i + 1 == chain.size();
    if (isEnd ? isTaken[chain[i]] != 1 : isTaken[chain[i]] != 0)
    {
      return false;
    }
    isTaken[chain[i]] = isEnd ? 1 : 2;
  }
  return chain.size() >= 2;
}

void LayoutDrawing::FindParts(std::vector<Sector>& sectors, std::vector<Id>& characteristics) const
{
  Id count = 0;
  const std::vector<Id> parts = this->OpenedMesh.ComputeComponents(count);
  characteristics.assign(count, 0);
  for (Id v = 0; v < this->OpenedMesh.GetNumberOfVertices(); ++v)
  {
    characteristics[parts[v]] += this->OpenedMesh.FanBegin(v) != this->OpenedMesh.FanEnd(v) ? 1 : 0;
  }
  for (Id h = 0; h < this->OpenedMesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id part = parts[this->OpenedMesh.Origin(h)];
    characteristics[part] -= this->OpenedMesh.Twin(h) < h ? 1 : 0; // edges, NoId included
    characteristics[part] += h % 3 == 0 ? 1 : 0;                   // faces
  }
  sectors = this->Sectors;
  for (Sector& sector : sectors)
  {
    sector.Part = parts[sector.Vertex];
  }
}

Status LayoutDrawing::Refuse(Id edge, const std::string& reason) const
{
  std::ostringstream message;
  message << "the layout edge between landmarks " << this->Edges[edge][0] << " and "
          << this->Edges[edge][1] << " cannot be drawn on " << this->Name << ": " << reason;
  return Status::Invalid(message.str());
}
}
