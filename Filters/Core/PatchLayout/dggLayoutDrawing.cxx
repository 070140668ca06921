// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLayoutDrawing.h"

#include "dggCurveMargin.h"
#include "dggDisjointSets.h"
#include "dggPathEdges.h"
#include "dggStatus.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
/// Returns the position of a neighbor in the fan of a vertex; for other vertices, the size of the
/// fan.
double PlaceInFan(const SurfaceMesh& mesh, Id vertex, Id neighbor)
{
  const Id* begin = mesh.FanBegin(vertex);
  const Id* end = mesh.FanEnd(vertex);
  const Id* place = end;
  for (const Id* g = begin; g != end; ++g)
  {
    place = mesh.Destination(*g) == neighbor ? g : place;
  }
  return static_cast<double>(place - begin);
}
}

Status LayoutDrawing::Begin()
{
  DGG_RETURN_IF_ERROR(this->CheckSurface());
  DGG_RETURN_IF_ERROR(this->CheckLandmarks());
  DGG_RETURN_IF_ERROR(this->Refine(nullptr, this->Surface.Refined));
  std::map<Id, std::size_t> landmarkAt;
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    const auto added = landmarkAt.emplace(this->Surface.Refined.Paths[l][0], l);
    if (!added.second)
    {
      return InvalidInput("Landmarks ", added.first->second, " and ", l, " of ", this->Name,
        " have the same position")
        .Fix("Move or remove one of them");
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
      return InvalidInput("The edge between points ", this->Mesh.Origin(h), " and ",
        this->Mesh.Destination(h), " of ", this->Name,
        this->Mesh.Twin(t) != h ? " has more than two faces"
                                : " shows that the surface cannot be oriented")
        .Fix("Use an orientable manifold: patches need a surface with two sides");
    }
  }
  return Status::Success();
}

Status LayoutDrawing::CheckLandmarks() const
{
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    DGG_RETURN_IF_ERROR(
      this->Landmarks[l].Check(this->Mesh).Of(JoinText("Landmark ", l, " of ", this->Name)));
    if (FindFaceOf(this->Mesh, this->Landmarks[l]) == NoId)
    {
      return InvalidInput("Landmark ", l, " of ", this->Name, " is a point that no face uses")
        .Fix("Move the landmark to a face");
    }
  }
  return Status::Success();
}

/// Splits the faces along the landmarks, the curves, and optionally one more path.
Status LayoutDrawing::Refine(const SurfacePath* more, SubMesh& refined) const
{
  std::vector<SurfacePath> paths(this->Landmarks.size());
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    paths[l].Points.push_back(this->Landmarks[l]);
  }
  for (const Id e : this->Surface.DrawnEdges)
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
  // A curve through a vertex with several fans would connect them.
  DGG_RETURN_IF_ERROR(CutAlongChains(this->Surface.Refined, this->Surface.Refined.Paths,
    this->Surface.Opened, PinchedVertices::Split));
  DGG_RETURN_IF_ERROR(this->Surface.Opened.Build(this->Mesh, this->Surface.OpenedMesh));
  this->Sectors = FindSectors(this->Surface, this->Edges);
  return Status::Success();
}

std::vector<Id> LayoutDrawing::FindBoundaryLoops() const
{
  DisjointSets sets(this->Surface.Refined.Points.size());
  std::vector<char> isOnBoundary(this->Surface.Refined.Points.size(), 0);
  for (Id h = 0; h < this->Surface.Refined.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Surface.Refined.Twin(h) == NoId)
    {
      const Id a = this->Surface.Refined.Origin(h);
      const Id b = this->Surface.Refined.Destination(h);
      isOnBoundary[a] = 1;
      isOnBoundary[b] = 1;
      sets.Join(a, b);
    }
  }
  std::vector<Id> loops;
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    const Id v = this->Surface.Refined.Paths[l][0];
    loops.push_back(isOnBoundary[v] ? sets.Find(v) : NoId);
  }
  return loops;
}

Status LayoutDrawing::Survey(const ProgressCallback& progress, std::vector<double>& lengths,
  std::vector<EdgeOrder>& orders) const
{
  std::vector<SurfacePath> paths(this->Edges.size());
  ExactPathFinder finder(this->Mesh);
  const auto count = static_cast<Id>(this->Landmarks.size());
  for (Id l = 0; l < count; ++l)
  {
    const auto part = [&](double fraction) {
      return !progress || progress((l + fraction) / static_cast<double>(count));
    };
    DGG_RETURN_IF_ERROR(this->FindPathsFrom(finder, l, part, paths));
  }
  lengths.clear();
  std::transform(paths.begin(), paths.end(), std::back_inserter(lengths),
    [](const SurfacePath& path) { return path.Length; });
  orders = this->FindOrders(paths);
  return Status::Success();
}

/// Finds shortest paths to the other ends of the edges that leave a landmark.
Status LayoutDrawing::FindPathsFrom(ExactPathFinder& finder, Id landmark,
  const ProgressCallback& progress, std::vector<SurfacePath>& paths) const
{
  std::vector<Id> leaving;
  std::vector<SurfacePoint> to;
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    if (this->Edges[e][0] == landmark)
    {
      leaving.push_back(static_cast<Id>(e));
      to.push_back(this->Landmarks[this->Edges[e][1]]);
    }
  }
  std::vector<SurfacePath> found;
  if (!to.empty())
  {
    DGG_RETURN_IF_ERROR(finder.Find(this->Landmarks[landmark], to, progress, found));
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].IsEmpty())
    {
      return this->Refuse(leaving[i], "the landmarks are not connected");
    }
    paths[leaving[i]] = std::move(found[i]);
  }
  return Status::Success();
}

/// Finds the order in which paths, one for each edge, leave the landmarks. Landmarks whose order
/// cannot be determined have no edges: the order is only a hint.
std::vector<EdgeOrder> LayoutDrawing::FindOrders(const std::vector<SurfacePath>& paths) const
{
  std::vector<EdgeOrder> orders(this->Landmarks.size());
  SubMesh crossed;
  SurfaceMesh mesh;
  RefinementOptions options;
  options.InsertCrossings = true;
  if (!RefineAlongPaths(this->Mesh, paths, options, crossed).IsOk() ||
    !crossed.Build(this->Mesh, mesh).IsOk())
  {
    return orders;
  }
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    for (const int end : { 0, 1 })
    {
      if (crossed.Paths[e].size() >= 2)
      {
        orders[this->Edges[e][end]].Edges.push_back(static_cast<Id>(e));
      }
    }
  }
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    std::map<Id, double> place; // position of an edge in the fan
    for (const Id e : orders[l].Edges)
    {
      const std::vector<Id>& chain = crossed.Paths[e];
      const bool leaves = this->Edges[e][0] == static_cast<Id>(l);
      place[e] = PlaceInFan(
        mesh, leaves ? chain.front() : chain.back(), leaves ? chain[1] : chain[chain.size() - 2]);
    }
    std::stable_sort(orders[l].Edges.begin(), orders[l].Edges.end(),
      [&](Id a, Id b) { return place[a] < place[b]; });
  }
  return orders;
}

Status LayoutDrawing::Draw(
  Id edge, std::vector<EdgeOrder>& orders, const ProgressCallback& progress)
{
  const Id a = this->Edges[edge][0];
  const Id b = this->Edges[edge][1];
  const std::vector<LayoutSector> from =
    FindAllowedSectors(this->Sectors, this->Surface, a, orders[a], edge);
  const std::vector<LayoutSector> to =
    FindAllowedSectors(this->Sectors, this->Surface, b, orders[b], edge);
  if (from.empty() || to.empty())
  {
    return this->Refuse(edge,
      JoinText("the order of the edges around landmark ", from.empty() ? a : b, " leaves no room"));
  }
  Connection connection;
  DGG_RETURN_IF_ERROR(this->Connect(from, to, progress, connection));
  if (connection.Path.IsEmpty())
  {
    return this->Refuse(edge,
      this->Surface.DrawnEdges.empty() ? "the landmarks are not connected"
                                       : "other edges separate the landmarks");
  }
  SubMesh refined;
  DGG_RETURN_IF_ERROR(this->KeepClear(edge, progress, connection, refined));
  InsertIntoOrder(orders[a], connection.From, edge);
  InsertIntoOrder(orders[b], connection.To, edge);
  this->Curves[edge] = std::move(connection.Path);
  this->Surface.IsDrawn[edge] = 1;
  this->Surface.DrawnEdges.push_back(edge);
  this->Surface.Refined = std::move(refined);
  return this->Cut();
}

/// Finds the shortest path from any of the first sectors to any of the second ones. Empty if there
/// is none.
Status LayoutDrawing::Connect(const std::vector<LayoutSector>& from,
  const std::vector<LayoutSector>& to, const ProgressCallback& progress,
  Connection& connection) const
{
  for (const LayoutSector& start : from)
  {
    SurfacePath path;
    std::size_t reached = 0;
    DGG_RETURN_IF_ERROR(this->Trace(start, to, progress, path, reached));
    if (!path.IsEmpty() && (connection.Path.IsEmpty() || path.Length < connection.Path.Length))
    {
      connection = { std::move(path), start, to[reached] };
    }
  }
  return Status::Success();
}

/// Splits the surface along the path as well. A path that touches other curves, or itself, is
/// replaced by a path at a distance from all curves.
Status LayoutDrawing::KeepClear(
  Id edge, const ProgressCallback& progress, Connection& connection, SubMesh& refined) const
{
  if (this->Refine(&connection.Path, refined).IsOk() && this->KeepsClear(refined))
  {
    return Status::Success();
  }
  SurfacePath clear;
  DGG_RETURN_IF_ERROR(this->TraceClear(connection.From, connection.To, progress, clear));
  if (clear.IsEmpty() || !this->Refine(&clear, refined).IsOk() || !this->KeepsClear(refined))
  {
    return this->Refuse(edge, "there is no room between the other edges");
  }
  connection.Path = std::move(clear);
  return Status::Success();
}

/// Finds the shortest path on the surface cut open, from one sector to the nearest of others. Empty
/// if there is none.
Status LayoutDrawing::Trace(const LayoutSector& from, const std::vector<LayoutSector>& to,
  const ProgressCallback& progress, SurfacePath& path, std::size_t& reached) const
{
  std::vector<SurfacePoint> targets;
  targets.reserve(to.size());
  for (const LayoutSector& sector : to)
  {
    targets.push_back(SurfacePoint::AtVertex(sector.Vertex));
  }
  std::vector<SurfacePath> paths;
  ExactPathFinder finder(this->Surface.OpenedMesh);
  Status status = finder.Find(SurfacePoint::AtVertex(from.Vertex), targets, progress, paths);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (!paths[i].IsEmpty() && (path.IsEmpty() || paths[i].Length < path.Length))
    {
      path = this->Surface.Opened.ToParent(this->Mesh, this->Surface.OpenedMesh, paths[i]);
      reached = i;
    }
  }
  return status;
}

/// Like Trace() to one sector, at a distance from curves and other landmarks.
Status LayoutDrawing::TraceClear(const LayoutSector& from, const LayoutSector& to,
  const ProgressCallback& progress, SurfacePath& path) const
{
  std::vector<char> isBlocked;
  std::vector<char> isCut;
  this->MarkObstacles(from.Vertex, to.Vertex, isBlocked, isCut);
  SubMesh rest;
  RemoveMargin(this->Mesh, this->Surface.Opened, isBlocked, isCut, rest);
  SurfaceMesh mesh;
  DGG_RETURN_IF_ERROR(rest.Build(this->Mesh, mesh));
  std::vector<SurfacePath> paths;
  DGG_RETURN_IF_ERROR(ExactPathFinder(mesh).Find(
    SurfacePoint::AtVertex(from.Vertex), { SurfacePoint::AtVertex(to.Vertex) }, progress, paths));
  if (!paths[0].IsEmpty())
  {
    path = rest.ToParent(this->Mesh, mesh, paths[0]);
  }
  return Status::Success();
}

/// Marks vertices that a path between two landmarks must not touch, and half-edges on curves.
void LayoutDrawing::MarkObstacles(
  Id from, Id to, std::vector<char>& isBlocked, std::vector<char>& isCut) const
{
  std::vector<char> isTaken(this->Surface.Refined.Points.size(), 0);
  for (const std::vector<Id>& chain : this->Surface.Refined.Paths)
  {
    for (const Id v : chain)
    {
      isTaken[v] = 1;
    }
  }
  isBlocked.assign(this->Surface.Opened.Points.size(), 0);
  for (Id v = 0; v < this->Surface.Opened.GetNumberOfVertices(); ++v)
  {
    isBlocked[v] = isTaken[this->Surface.Opened.VertexOf[v]] && v != from && v != to ? 1 : 0;
  }
  const PathEdges curves(this->Surface.Refined, this->Surface.Refined.Paths);
  const Id halfEdges = this->Surface.Refined.GetNumberOfHalfEdges();
  isCut.assign(halfEdges, 0);
  for (Id h = 0; h < halfEdges; ++h)
  {
    isCut[h] = curves.IsOnPath(h) ? 1 : 0; // The cut has not changed the ids of half-edges.
  }
}

/// Returns true if the last path meets the others, and itself, only at its ends.
bool LayoutDrawing::KeepsClear(const SubMesh& refined) const
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

void LayoutDrawing::FindParts(
  std::vector<LayoutSector>& sectors, std::vector<Id>& characteristics) const
{
  Id count = 0;
  const std::vector<Id> parts = this->Surface.OpenedMesh.ComputeComponents(count);
  characteristics.assign(count, 0);
  for (Id v = 0; v < this->Surface.OpenedMesh.GetNumberOfVertices(); ++v)
  {
    characteristics[parts[v]] +=
      this->Surface.OpenedMesh.FanBegin(v) != this->Surface.OpenedMesh.FanEnd(v) ? 1 : 0;
  }
  for (Id h = 0; h < this->Surface.OpenedMesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id part = parts[this->Surface.OpenedMesh.Origin(h)];
    characteristics[part] -= this->Surface.OpenedMesh.Twin(h) < h ? 1 : 0; // edges, NoId included
    characteristics[part] += h % 3 == 0 ? 1 : 0;                           // faces
  }
  sectors = this->Sectors;
  for (LayoutSector& sector : sectors)
  {
    sector.Part = parts[sector.Vertex];
  }
}

Status LayoutDrawing::Refuse(Id edge, const std::string& reason) const
{
  return InvalidInput("The layout edge between landmarks ", this->Edges[edge][0], " and ",
    this->Edges[edge][1], " cannot be drawn on ", this->Name, ": ", reason)
    .Fix("Check that the landmarks correspond, reverse patches, or refine the mesh");
}
}
