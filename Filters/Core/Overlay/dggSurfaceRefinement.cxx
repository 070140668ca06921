// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceRefinement.h"

#include "dggEdges.h"
#include "dggFaceTriangulation.h"
#include "dggPieceSplitter.h"
#include "dggStatus.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
/// Faces, or points or segments within a face, between two progress reports.
constexpr Id ProgressInterval = 1024;
/// Progress after splitting all faces; progress within a face after splitting its pieces and after
/// triangulating its points.
constexpr double FacesDone = 0.8;
constexpr double PiecesDone = 0.3;
constexpr double PointsDone = 0.7;

/// Points on paths become nodes, and paths become chains of straight pieces between them, which are
/// split where they meet; then each face with nodes is triangulated separately.
class Refiner
{
public:
  Refiner(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
    const RefinementOptions& options, SubMesh& refined)
    : Mesh(mesh)
    , Paths(paths)
    , Options(options)
    , Refined(refined)
    , Nodes(mesh)
  {
  }

  Status Run();

private:
  /// A segment of a path, by the indices of points of a triangulation.
  struct Segment
  {
    int From;
    int To;
    Id Path;
  };

  bool ShouldContinue(double done) const
  {
    return !this->Options.Progress || this->Options.Progress(done);
  }
  bool ShouldContinueInFace(std::size_t work, double done) const;
  Status CheckPaths() const;
  void MakePieces();
  Status AddFace(Id f);
  bool IsWhole(Id f) const;
  Status Triangulate(Id f, std::size_t work);
  std::vector<Segment> SegmentsOf(
    const std::vector<std::size_t>& places, Id f, const std::vector<Id>& nodes) const;
  void AddTriangle(Id f, const std::array<Id, 3>& nodes);
  void MakeTwinsAndLengths();
  void MakeChains();
  void AddPlaces(const PathPiece& piece, std::vector<double>& places) const;

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePath>& Paths;
  const RefinementOptions& Options;
  SubMesh& Refined;

  PathNodes Nodes;
  std::vector<PathPiece> Pieces;                   // pieces of all paths, concatenated
  std::map<Id, std::vector<std::size_t>> PiecesIn; // per face
  std::size_t WorkDone = 0;                        // number of processed faces and pieces in them
};

Status Refiner::Run()
{
  this->Refined = SubMesh();
  DGG_RETURN_IF_ERROR(this->CheckPaths());
  this->Nodes.AddPointsOnEdges(this->Paths);
  this->MakePieces();
  const Id faces = this->Mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; ++f)
  {
    if (f % ProgressInterval == 0 && !this->ShouldContinueInFace(0, 0.0))
    {
      return Status::Abort();
    }
    if (!this->Mesh.IsDropped(f))
    {
      DGG_RETURN_IF_ERROR(this->AddFace(f));
    }
    ++this->WorkDone;
  }
  if (!this->ShouldContinue(FacesDone))
  {
    return Status::Abort();
  }
  this->MakeTwinsAndLengths();
  this->Refined.Points = this->Nodes.MakePoints();
  this->MakeChains();
  return Status::Success();
}

/// Reports progress within a face, given the completed fraction of its work.
bool Refiner::ShouldContinueInFace(std::size_t work, double done) const
{
  const auto whole =
    static_cast<double>(this->Pieces.size()) + static_cast<double>(this->Mesh.GetNumberOfFaces());
  return this->ShouldContinue(
    FacesDone * (static_cast<double>(this->WorkDone) + done * static_cast<double>(work)) / whole);
}

Status Refiner::CheckPaths() const
{
  DGG_RETURN_IF_ERROR(CheckCorners(this->Mesh));
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    const SurfacePath& path = this->Paths[p];
    const std::string name = JoinText("Path ", p);
    for (const SurfacePoint& point : path.Points)
    {
      DGG_RETURN_IF_ERROR(point.Check(this->Mesh).Of(name));
    }
    DGG_RETURN_IF_ERROR(CheckPath(this->Mesh, path).Of(name));
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
        this->Pieces.push_back({ static_cast<Id>(p), { from, to }, i });
      }
      from = to;
    }
  }
}

Status Refiner::AddFace(Id f)
{
  if (this->IsWhole(f))
  {
    this->AddTriangle(f, this->Mesh.GetTriangle(f));
    return Status::Success();
  }
  const auto pieces = this->PiecesIn.find(f);
  const std::size_t work = pieces == this->PiecesIn.end() ? 0 : pieces->second.size();
  if (pieces != this->PiecesIn.end())
  {
    DGG_RETURN_IF_ERROR(
      SplitPieces(this->Nodes, this->Pieces, this->Options.InsertCrossings, f, pieces->second,
        [&](double done) { return this->ShouldContinueInFace(work, PiecesDone * done); }));
  }
  DGG_RETURN_IF_ERROR(this->Triangulate(f, work));
  this->WorkDone += work;
  return Status::Success();
}

/// Returns true if no path passes the face.
bool Refiner::IsWhole(Id f) const
{
  bool isWhole = !this->Nodes.FindInFace(f) && this->PiecesIn.find(f) == this->PiecesIn.end();
  for (Id h = 3 * f; h < 3 * f + 3 && isWhole; ++h)
  {
    isWhole = !this->Nodes.FindOnEdge(h);
  }
  return isWhole;
}

Status Refiner::Triangulate(Id f, std::size_t work)
{
  const Id h = 3 * f;
  // The nodes with their positions: first the corners, then the others in a fast insertion order.
  std::vector<std::pair<GridPoint, Id>> found;
  auto add = [&](const std::vector<Id>* more) {
    for (std::size_t i = 0; more && i < more->size(); ++i)
    {
      found.emplace_back(this->Nodes.PlaceOf((*more)[i], f), (*more)[i]);
    }
  };
  for (Id e = h; e < h + 3; ++e)
  {
    add(this->Nodes.FindOnEdge(e));
  }
  add(this->Nodes.FindInFace(f));
  std::vector<GridPoint> points;
  points.reserve(found.size());
  for (const std::pair<GridPoint, Id>& node : found)
  {
    points.push_back(node.first);
  }
  FaceTriangulation triangulation(CornersInFrame(this->Mesh, h));
  std::vector<Id> nodes{ this->Mesh.Origin(h), this->Mesh.Origin(h + 1), this->Mesh.Origin(h + 2) };
  auto shouldContinue = [&](std::size_t i, std::size_t count, double from, double to) {
    return i % ProgressInterval != ProgressInterval - 1 ||
      this->ShouldContinueInFace(
        work, from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  };
  for (const std::size_t i : MakeInsertionOrder(points))
  {
    if (!shouldContinue(nodes.size(), points.size() + 3, PiecesDone, PointsDone))
    {
      return Status::Abort();
    }
    triangulation.AddPoint(points[i]);
    nodes.push_back(found[i].second);
  }
  const auto pieces = this->PiecesIn.find(f);
  if (pieces != this->PiecesIn.end())
  {
    const std::vector<Segment> segments = this->SegmentsOf(pieces->second, f, nodes);
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      if (!shouldContinue(i, segments.size(), PointsDone, 1.0))
      {
        return Status::Abort();
      }
      if (!triangulation.AddSegment(segments[i].From, segments[i].To))
      {
        return InvalidInput("Face ", f, " cannot be split along path ", segments[i].Path);
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

/// Returns the segments of pieces in a face, in a fast insertion order; `nodes` is ordered like the
/// points of the triangulation.
std::vector<Refiner::Segment> Refiner::SegmentsOf(
  const std::vector<std::size_t>& places, Id f, const std::vector<Id>& nodes) const
{
  std::vector<std::pair<Id, int>> indices;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    indices.emplace_back(nodes[i], static_cast<int>(i));
  }
  std::sort(indices.begin(), indices.end());
  auto indexOf = [&](Id node) {
    return std::lower_bound(indices.begin(), indices.end(), std::make_pair(node, 0))->second;
  };
  std::vector<Segment> segments;
  std::vector<GridPoint> middles;
  for (const std::size_t p : places)
  {
    const PathPiece& piece = this->Pieces[p];
    for (std::size_t i = 0; i + 1 < piece.Nodes.size(); ++i)
    {
      segments.push_back({ indexOf(piece.Nodes[i]), indexOf(piece.Nodes[i + 1]), piece.Path });
      const GridPoint from = this->Nodes.PlaceOf(piece.Nodes[i], f);
      const GridPoint to = this->Nodes.PlaceOf(piece.Nodes[i + 1], f);
      middles.push_back({ (from.X + to.X) / 2, (from.Y + to.Y) / 2 });
    }
  }
  std::vector<Segment> ordered;
  for (const std::size_t i : MakeInsertionOrder(middles))
  {
    ordered.push_back(segments[i]);
  }
  return ordered;
}

void Refiner::AddTriangle(Id f, const std::array<Id, 3>& nodes)
{
  this->Refined.Triangles.insert(this->Refined.Triangles.end(), nodes.begin(), nodes.end());
  this->Refined.Faces.push_back(f);
}

/// Glues edges that are parts of the same old edge, or lie within the same old face.
void Refiner::MakeTwinsAndLengths()
{
  std::vector<Offset> places;
  places.reserve(this->Refined.Triangles.size());
  for (Id h = 0; h < this->Refined.GetNumberOfHalfEdges(); ++h)
  {
    const Id f = this->Refined.Faces[SurfaceMesh::Face(h)];
    const Id a = this->Refined.Origin(h);
    const Id b = this->Refined.Destination(h);
    int side = 0;
    places.push_back(this->Nodes.AreOnOneSide(a, b, f, side)
        ? FindEdge(this->Mesh, 3 * f + side)
        : static_cast<Offset>(this->Mesh.GetNumberOfHalfEdges()) + f);
    this->Refined.Lengths.push_back(this->Nodes.Measure(a, b, f));
  }
  this->Refined.Glue(places);
}

void Refiner::MakeChains()
{
  std::vector<std::vector<Id>>& chains = this->Refined.Paths;
  std::vector<std::vector<double>>& places = this->Refined.Places;
  chains.resize(this->Paths.size());
  places.resize(this->Paths.size());
  for (const PathPiece& piece : this->Pieces)
  {
    std::vector<Id>& chain = chains[piece.Path];
    if (chain.empty())
    {
      chain.push_back(piece.Nodes.front());
      places[piece.Path].push_back(0.0);
    }
    chain.insert(chain.end(), piece.Nodes.begin() + 1, piece.Nodes.end());
    this->AddPlaces(piece, places[piece.Path]);
  }
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    if (chains[p].empty() && !this->Paths[p].Points.empty())
    {
      chains[p].push_back(this->Nodes.NodeOf(this->Paths[p].Points[0])); // a single point
      places[p].push_back(0.0);
    }
  }
}

/// Adds the positions along the path of the nodes of a piece, except the first. Ratios of lengths
/// along a straight line are equal in grid units and in model units, which may vanish in needles.
/// The ratios are accumulated from node to node, so that positions increase even if nodes were
/// moved.
void Refiner::AddPlaces(const PathPiece& piece, std::vector<double>& places) const
{
  const Id face = this->Paths[piece.Path].Faces[piece.Number];
  std::vector<double> behind{ 0.0 };
  GridPoint last = this->Nodes.PlaceOf(piece.Nodes[0], face);
  for (std::size_t i = 1; i < piece.Nodes.size(); ++i)
  {
    const GridPoint next = this->Nodes.PlaceOf(piece.Nodes[i], face);
    behind.push_back(behind.back() +
      Norm(static_cast<double>(next.X - last.X), static_cast<double>(next.Y - last.Y)));
    last = next;
  }
  for (std::size_t i = 1; i + 1 < behind.size(); ++i)
  {
    places.push_back(static_cast<double>(piece.Number) + behind[i] / behind.back());
  }
  places.push_back(static_cast<double>(piece.Number + 1));
}
}

Status RefineAlongPaths(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
  const RefinementOptions& options, SubMesh& refined)
{
  refined = SubMesh();
  Status status = Refiner(mesh, paths, options, refined).Run();
  if (!status.IsOk())
  {
    refined = SubMesh();
  }
  return status;
}
}
