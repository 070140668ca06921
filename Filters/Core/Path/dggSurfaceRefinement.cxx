// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceRefinement.h"

#include "dggEdges.h"
#include "dggFaceTriangulation.h"
#include "dggPieceSplitter.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <tuple>

namespace dgg
{
namespace
{
/// Faces between two reports, and the share of the progress when all are split.
constexpr Id ProgressInterval = 1024;
constexpr double FacesDone = 0.8;

/// The points that paths pass become nodes, the paths chains of straight pieces between them, which
/// are split where they meet; then each face with nodes is triangulated on its own.
class Refiner
{
public:
  Refiner(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
    const RefinementOptions& options, RefinedSurface& refined)
    : Mesh(mesh)
    , Paths(paths)
    , Options(options)
    , Refined(refined)
    , Nodes(mesh)
  {
  }

  Status Run();

private:
  bool Goes(double done) const { return !this->Options.Progress || this->Options.Progress(done); }
  Status CheckPaths() const;
  void MakePieces();
  Status AddFace(Id f);
  bool IsWhole(Id f) const;
  void AddWholeFace(Id f);
  Status Triangulate(Id f);
  void AddTriangle(Id f, const std::array<Id, 3>& nodes);
  void MakeTwinsAndLengths();
  void MakeChains();

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePath>& Paths;
  const RefinementOptions& Options;
  RefinedSurface& Refined;

  PathNodes Nodes;
  std::vector<PathPiece> Pieces;                   // of the paths, one after the other
  std::map<Id, std::vector<std::size_t>> PiecesIn; // per face
};

Status Refiner::Run()
{
  this->Refined = RefinedSurface();
  Status status = this->CheckPaths();
  if (!status.IsOk())
  {
    return status;
  }
  this->Nodes.AddPointsOnEdges(this->Paths);
  this->MakePieces();
  const Id faces = this->Mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; ++f)
  {
    if (f % ProgressInterval == 0 && !this->Goes(FacesDone * f / faces))
    {
      status = Status::Abort();
    }
    else if (!this->Mesh.IsDropped(f))
    {
      status = this->AddFace(f);
    }
    if (!status.IsOk())
    {
      this->Refined = RefinedSurface();
      return status;
    }
  }
  if (!this->Goes(FacesDone))
  {
    this->Refined = RefinedSurface();
    return Status::Abort();
  }
  this->MakeTwinsAndLengths();
  this->Refined.Points = this->Nodes.MakePoints();
  this->MakeChains();
  return Status::Success();
}

Status Refiner::CheckPaths() const
{
  Status corners = CheckCorners(this->Mesh);
  if (!corners.IsOk())
  {
    return corners;
  }
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    const SurfacePath& path = this->Paths[p];
    Status status;
    for (const SurfacePoint& point : path.Points)
    {
      status = status.IsOk() ? point.Check(this->Mesh) : status;
    }
    status = status.IsOk() ? CheckPath(this->Mesh, path) : status;
    if (!status.IsOk())
    {
      std::ostringstream message;
      message << "path " << p << ": " << status.GetMessage();
      return Status::Invalid(message.str());
    }
  }
  return Status::Success();
}

void Refiner::MakePieces()
{
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    const SurfacePath& path = this->Paths[p];
    if (path.Points.empty())
    {
      continue;
    }
    Id from = this->Nodes.NodeOf(path.Points[0]);
    for (std::size_t i = 0; i < path.Faces.size(); ++i)
    {
      const Id to = this->Nodes.NodeOf(path.Points[i + 1]);
      if (to != from)
      {
        this->PiecesIn[path.Faces[i]].push_back(this->Pieces.size());
        this->Pieces.push_back({ static_cast<Id>(p), { from, to } });
      }
      from = to;
    }
  }
}

Status Refiner::AddFace(Id f)
{
  if (this->IsWhole(f))
  {
    this->AddWholeFace(f);
    return Status::Success();
  }
  const auto pieces = this->PiecesIn.find(f);
  Status status;
  if (pieces != this->PiecesIn.end())
  {
    status = PieceSplitter(this->Nodes, this->Pieces, this->Options.InsertCrossings)
               .Split(f, pieces->second);
  }
  return status.IsOk() ? this->Triangulate(f) : status;
}

/// Whether nothing passes it.
bool Refiner::IsWhole(Id f) const
{
  bool isWhole = !this->Nodes.FindInFace(f) && this->PiecesIn.find(f) == this->PiecesIn.end();
  for (Id h = 3 * f; h < 3 * f + 3 && isWhole; ++h)
  {
    isWhole = !this->Nodes.FindOnEdge(h);
  }
  return isWhole;
}

void Refiner::AddWholeFace(Id f)
{
  this->AddTriangle(f, this->Mesh.GetTriangle(f));
}

Status Refiner::Triangulate(Id f)
{
  const Id h = 3 * f;
  FaceTriangulation triangulation({ { { 0.0, 0.0 }, { this->Mesh.Length(h), 0.0 },
    { this->Mesh.ApexX(h), this->Mesh.ApexY(h) } } });
  std::vector<Id> nodes{ this->Mesh.Origin(h), this->Mesh.Origin(h + 1), this->Mesh.Origin(h + 2) };
  auto add = [&](const std::vector<Id>* more) {
    for (std::size_t i = 0; more && i < more->size(); ++i)
    {
      const Id node = (*more)[i];
      triangulation.AddPoint(this->Nodes.PlaceOf(node, f));
      nodes.push_back(node);
    }
  };
  for (Id e = h; e < h + 3; ++e)
  {
    add(this->Nodes.FindOnEdge(e));
  }
  add(this->Nodes.FindInFace(f));
  const auto pieces = this->PiecesIn.find(f);
  if (pieces != this->PiecesIn.end())
  {
    std::map<Id, int> indices;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      indices[nodes[i]] = static_cast<int>(i);
    }
    for (const std::size_t p : pieces->second)
    {
      const std::vector<Id>& chain = this->Pieces[p].Nodes;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      {
        if (!triangulation.AddSegment(indices[chain[i]], indices[chain[i + 1]]))
        {
          std::ostringstream message;
          message << "face " << f << " cannot be split along path " << this->Pieces[p].Path;
          return Status::Invalid(message.str());
        }
      }
    }
  }
  triangulation.MakeDelaunay();
  for (const std::array<int, 3>& t : triangulation.GetTriangles())
  {
    this->AddTriangle(f, { { nodes[t[0]], nodes[t[1]], nodes[t[2]] } });
  }
  return Status::Success();
}

void Refiner::AddTriangle(Id f, const std::array<Id, 3>& nodes)
{
  this->Refined.Triangles.insert(this->Refined.Triangles.end(), nodes.begin(), nodes.end());
  this->Refined.Faces.push_back(f);
}

/// Edges are glued where they are parts of the same old edge, or within the same old face.
void Refiner::MakeTwinsAndLengths()
{
  const auto halfEdges = static_cast<Id>(this->Refined.Triangles.size());
  const Id oldHalfEdges = this->Mesh.GetNumberOfHalfEdges();
  this->Refined.Twins.assign(halfEdges, NoId);
  this->Refined.Lengths.resize(halfEdges);
  using Key = std::tuple<Offset, Id, Id, Id>; // where, ends, half-edge
  std::vector<Key> keys;
  keys.reserve(halfEdges);
  for (Id e = 0; e < halfEdges; ++e)
  {
    const Id f = this->Refined.Faces[SurfaceMesh::Face(e)];
    const Id a = this->Refined.Triangles[e];
    const Id b = this->Refined.Triangles[SurfaceMesh::Next(e)];
    int side = 0;
    const Offset where = this->Nodes.AreOnOneSide(a, b, f, side)
      ? FindEdge(this->Mesh, 3 * f + side)
      : static_cast<Offset>(oldHalfEdges) + f;
    keys.emplace_back(where, std::min(a, b), std::max(a, b), e);
    this->Refined.Lengths[e] = this->Nodes.Measure(a, b, f);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t begin = 0; begin < keys.size();)
  {
    std::size_t end = begin + 1;
    while (end < keys.size() && std::get<0>(keys[end]) == std::get<0>(keys[begin]) &&
      std::get<1>(keys[end]) == std::get<1>(keys[begin]) &&
      std::get<2>(keys[end]) == std::get<2>(keys[begin]))
    {
      ++end;
    }
    for (std::size_t i = begin; i < end && end - begin > 1; ++i)
    {
      this->Refined.Twins[std::get<3>(keys[i])] = std::get<3>(keys[i + 1 == end ? begin : i + 1]);
    }
    begin = end;
  }
}

void Refiner::MakeChains()
{
  std::vector<std::vector<Id>>& chains = this->Refined.Paths;
  chains.resize(this->Paths.size());
  for (const PathPiece& piece : this->Pieces)
  {
    std::vector<Id>& chain = chains[piece.Path];
    chain.insert(chain.end(), piece.Nodes.begin() + (chain.empty() ? 0 : 1), piece.Nodes.end());
  }
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    if (chains[p].empty() && !this->Paths[p].Points.empty())
    {
      chains[p].push_back(this->Nodes.NodeOf(this->Paths[p].Points[0])); // a single point
    }
  }
}
}

Status RefineAlongPaths(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
  const RefinementOptions& options, RefinedSurface& refined)
{
  return Refiner(mesh, paths, options, refined).Run();
}
}
