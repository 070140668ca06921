// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRidges.h"

#include "dggBlockLoop.h"
#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggFaceRidges.h"
#include "dggPieceChains.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
constexpr Offset FacesInBlock = 512;
constexpr double DefaultTolerance = 1e-3; // in mean edge lengths
/// Smallest angles with windows, and with virtual sources.
constexpr double SmallestAngle = 0.1 * Pi / 180.0;
constexpr double SmallestAngleOfModels = 10.0 * Pi / 180.0;
constexpr double FacesDone = 0.9; // progress after the faces
/// Points that two faces find on their edge are merged within this distance, in edge lengths.
constexpr double MergeDistance = 1e-4;

/// Ridge segments and their connectivity. Nodes are points of a surface; arcs are polylines within
/// one face.
class RidgeGraph
{
public:
  RidgeGraph(const SurfaceMesh& mesh, double longestEdge)
    : Mesh(mesh)
    , NodeOfVertex(mesh.GetNumberOfVertices(), NoId)
    , NoAngle(longestEdge)
  {
  }

  /// Adds a node with its index among the nodes of its edge.
  Id AddNode(const SurfacePoint& point, Offset rank = 0)
  {
    Id own = NoId;
    Id& node = IsVertex(point) ? this->NodeOfVertex[point.Vertex] : own;
    if (node == NoId)
    {
      node = static_cast<Id>(this->Nodes.size());
      this->Nodes.push_back({ point, rank });
    }
    return node;
  }

  /// Adds an arc in a face, unless it is empty. Arcs of other processes only have ends.
  void AddArc(Id from, Id to, Id face, double angle, std::vector<SurfacePoint> between, bool isOwn)
  {
    if (from == to && between.empty())
    {
      return;
    }
    for (const Id node : { from, to })
    {
      ++(isOwn ? this->Nodes[node].OwnArcs : this->Nodes[node].OtherArcs);
    }
    if (isOwn)
    {
      this->Ends.push_back({ { from, to } });
      this->Arcs.push_back({ face, angle, std::move(between) });
    }
  }

  /// Joins arcs into polylines. A polyline ends at nodes that do not have exactly two arcs, or is
  /// closed.
  void MakeLines(Ridges& ridges) const
  {
    std::vector<std::array<Id, 2>> ends = this->Ends;
    for (std::size_t i = 0; i < 2 * ends.size(); ++i)
    {
      Id& end = ends[i / 2][i % 2];
      if (this->Nodes[end].OwnArcs == 2 && this->Nodes[end].OtherArcs > 0)
      {
        end = -1 - static_cast<Id>(i); // unique, so that no arcs are joined here
      }
    }
    for (const PieceChain& chain : JoinPieces(ends))
    {
      this->AddLine(chain, ridges);
    }
  }

private:
  struct Node
  {
    SurfacePoint Point;
    Offset Rank;
    ///@{
    // Number of arcs of this process and of other ones.
    Id OwnArcs = 0;
    Id OtherArcs = 0;
    ///@}
  };
  struct Arc
  {
    Id Face;
    double Angle;
    std::vector<SurfacePoint> Between;
  };

  Id EndOf(const PiecePassage& passage, bool isLast) const
  {
    return this->Ends[passage.Piece][passage.IsBackward == isLast ? 0 : 1];
  }

  /// Returns the joint at which the line that ends at a node continues.
  RidgePart::Joint MakeJoint(const Node& node) const
  {
    if (node.OwnArcs != 1 || node.OtherArcs != 1)
    {
      return { { NoId, NoId, NoId } };
    }
    if (IsVertex(node.Point))
    {
      return { { node.Point.Vertex, node.Point.Vertex, 0 } };
    }
    const Id from = this->Mesh.Origin(node.Point.HalfEdge);
    const Id to = this->Mesh.Destination(node.Point.HalfEdge);
    return { { std::min(from, to), std::max(from, to), node.Rank } };
  }

  void AddLine(const PieceChain& chain, Ridges& ridges) const
  {
    SurfacePath line;
    RidgePart part;
    part.Angle = this->NoAngle;
    for (const PiecePassage& passage : chain.Passages)
    {
      const Arc& arc = this->Arcs[passage.Piece];
      if (line.Points.empty())
      {
        line.Points.push_back(this->Nodes[this->EndOf(passage, false)].Point);
      }
      const std::size_t count = arc.Between.size();
      for (std::size_t i = 0; i <= count; ++i)
      {
        const SurfacePoint& point = i == count ? this->Nodes[this->EndOf(passage, true)].Point
          : passage.IsBackward                 ? arc.Between[count - 1 - i]
                                               : arc.Between[i];
        const double length = line.Append(this->Mesh, point, arc.Face);
        if (length == 0.0)
        {
          // Duplicate point; keep the node, in either direction of the line.
          line.Points.erase(line.Points.end() - (i == count ? 2 : 1));
          line.Faces.pop_back();
        }
        else
        {
          part.Angle.Add(length, arc.Angle);
        }
      }
    }
    if (line.Length > 0.0)
    {
      part.Line = static_cast<Id>(ridges.Lines.size());
      ridges.Angles.push_back(part.Angle.GetMean());
      ridges.Lines.push_back(std::move(line));
    }
    part.Ends = { { this->MakeJoint(this->Nodes[this->EndOf(chain.Passages.front(), false)]),
      this->MakeJoint(this->Nodes[this->EndOf(chain.Passages.back(), true)]) } };
    if (part.Ends[0][0] != NoId || part.Ends[1][0] != NoId)
    {
      ridges.Parts.push_back(part);
    }
  }

  const SurfaceMesh& Mesh;
  std::vector<Id> NodeOfVertex;
  const RidgeAngleSum NoAngle;
  std::vector<Node> Nodes;
  std::vector<std::array<Id, 2>> Ends; // end nodes of the arcs
  std::vector<Arc> Arcs;
};

/// Connects the ridges of adjacent faces across their edges.
class EdgeJoiner
{
public:
  EdgeJoiner(const DistanceField& field, const RidgeOptions& options,
    const std::vector<FaceRidges>& faces, RidgeGraph& graph)
    : Mesh(*field.Mesh)
    , Field(field)
    , Options(options)
    , Faces(faces)
    , Graph(graph)
    , Left(field)
    , Right(field)
    , Nodes(faces.size())
  {
  }

  void Run();

private:
  /// A ridge end that a face found on the edge, or an end of the edge.
  struct Meeting
  {
    double X = 0.0; // abscissa from the origin of the first half-edge
    Id Face = NoId;
    Id End = NoId;    // index into the ends of the face
    Id Vertex = NoId; // otherwise the vertex
    Id Node = NoId;
  };

  void JoinEdge(Id h);
  void Collect(Id h, Id first, std::vector<Meeting>& meetings) const;
  void Merge(Id h, std::vector<Meeting>& meetings);
  void JoinAlong(Id h, Id twin, std::vector<Meeting>& meetings);
  bool IsRidge(double left, double right, bool isMirrored) const;
  double GradientAngle(FaceEnvelope& envelope, Id h, double x) const;
  void AddPieces(Id f);

  const SurfaceMesh& Mesh;
  const DistanceField& Field;
  const RidgeOptions Options;
  const std::vector<FaceRidges>& Faces;
  RidgeGraph& Graph;
  FaceEnvelope Left;
  FaceEnvelope Right;
  std::vector<std::vector<Id>> Nodes; // per face and end
};

void EdgeJoiner::Run()
{
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    this->Nodes[f].assign(this->Faces[f].Ends.size(), NoId);
  }
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Field.IsReached(SurfaceMesh::Face(h)))
    {
      this->JoinEdge(h);
    }
  }
  for (Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    this->AddPieces(f);
  }
}

/// Joins the ridges at an edge. Does nothing unless h is the first half-edge of the edge among
/// reached faces.
void EdgeJoiner::JoinEdge(Id h)
{
  std::vector<Id> halfEdges{ h };
  ForEachTwin(this->Mesh, h, [&](Id e) {
    if (this->Field.IsReached(SurfaceMesh::Face(e)))
    {
      halfEdges.push_back(e);
    }
  });
  if (*std::min_element(halfEdges.begin(), halfEdges.end()) < h)
  {
    return;
  }
  std::vector<Meeting> meetings;
  for (const Id e : halfEdges)
  {
    this->Collect(e, h, meetings);
  }
  this->Merge(h, meetings);
  if (halfEdges.size() == 2 && !this->Options.BetweenSources)
  {
    this->JoinAlong(h, halfEdges[1], meetings);
  }
}

void EdgeJoiner::Collect(Id h, Id first, std::vector<Meeting>& meetings) const
{
  const Id f = SurfaceMesh::Face(h);
  const std::vector<RidgeEnd>& ends = this->Faces[f].Ends;
  const bool isSame = this->Mesh.Origin(h) == this->Mesh.Origin(first);
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    if (ends[i].On == RidgeEnd::Support::Edge && ends[i].Side == h % 3)
    {
      Meeting meeting;
      meeting.X = isSame ? ends[i].X : this->Mesh.Length(first) - ends[i].X;
      meeting.Face = f;
      meeting.End = static_cast<Id>(i);
      meetings.push_back(meeting);
    }
  }
}

/// Merges ends that several faces found at one position into one node, at the position of the first
/// end. Leaves ends that only one face has found.
void EdgeJoiner::Merge(Id h, std::vector<Meeting>& meetings)
{
  const double length = this->Mesh.Length(h);
  std::stable_sort(
    meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) { return a.X < b.X; });
  std::vector<Meeting> alone;
  Offset rank = 0;
  std::vector<bool> isDone(meetings.size(), false);
  for (std::size_t i = 0; i < meetings.size(); ++i)
  {
    if (isDone[i])
    {
      continue;
    }
    std::vector<std::size_t> group{ i };
    for (std::size_t j = i + 1;
         j < meetings.size() && meetings[j].X - meetings[i].X <= MergeDistance * length; ++j)
    {
      const bool isNew = !isDone[j] && std::none_of(group.begin(), group.end(), [&](std::size_t g) {
        return meetings[g].Face == meetings[j].Face;
      });
      if (isNew)
      {
        group.push_back(j);
      }
    }
    const std::size_t first = *std::min_element(group.begin(), group.end(),
      [&](std::size_t a, std::size_t b) { return meetings[a].Face < meetings[b].Face; });
    const Id node =
      this->Graph.AddNode(SurfacePoint::OnEdge(this->Mesh, h, meetings[first].X / length), rank++);
    for (const std::size_t g : group)
    {
      isDone[g] = true;
      this->Nodes[meetings[g].Face][meetings[g].End] = node;
      meetings[g].Node = node;
    }
    if (group.size() == 1)
    {
      alone.push_back(meetings[i]);
    }
  }
  meetings.swap(alone);
}

/// Joins ridges that run along the edge. Such a ridge connects ends that only one face has found,
/// or ends of the edge.
void EdgeJoiner::JoinAlong(Id h, Id twin, std::vector<Meeting>& meetings)
{
  const bool isMirrored = this->Mesh.Origin(twin) == this->Mesh.Origin(h);
  const auto& left = this->Faces[SurfaceMesh::Face(h)].RimAngles[h % 3];
  const auto& right = this->Faces[SurfaceMesh::Face(twin)].RimAngles[twin % 3];
  const double length = this->Mesh.Length(h);
  for (int i = 0; i < 2; ++i)
  {
    if (this->IsRidge(left[i], right[isMirrored ? i : 1 - i], isMirrored))
    {
      Meeting meeting;
      meeting.X = i == 0 ? 0.0 : length;
      meeting.Vertex = i == 0 ? this->Mesh.Origin(h) : this->Mesh.Destination(h);
      meetings.insert(i == 0 ? meetings.begin() : meetings.end(), meeting);
    }
  }
  for (std::size_t i = 0; i + 1 < meetings.size(); ++i)
  {
    const double x = 0.5 * (meetings[i].X + meetings[i + 1].X);
    this->Left.Enter(SurfaceMesh::Face(h));
    this->Right.Enter(SurfaceMesh::Face(twin));
    const double atLeft = this->GradientAngle(this->Left, h, x);
    const double atRight = this->GradientAngle(this->Right, twin, isMirrored ? x : length - x);
    if (this->IsRidge(atLeft, atRight, isMirrored))
    {
      std::array<Id, 2> nodes{};
      for (std::size_t k = 0; k < 2; ++k)
      {
        const Meeting& meeting = meetings[i + k];
        nodes[k] = meeting.Vertex != NoId
          ? this->Graph.AddNode(SurfacePoint::AtVertex(meeting.Vertex))
          : meeting.Node;
      }
      const double opposite = isMirrored ? -atRight : atRight + Pi;
      this->Graph.AddArc(nodes[0], nodes[1], SurfaceMesh::Face(h),
        std::abs(std::remainder(atLeft - opposite, 2.0 * Pi)), {},
        this->Field.IsTraced(SurfaceMesh::Face(h)));
      ++i;
    }
  }
}

/// Returns true if the gradients on both sides of an edge, in the frames of its half-edges, point
/// at each other with at least the minimum angle.
bool EdgeJoiner::IsRidge(double left, double right, bool isMirrored) const
{
  const double opposite = isMirrored ? -right : right + Pi;
  return std::abs(std::remainder(left - opposite, 2.0 * Pi)) >= this->Options.MinimumAngle &&
    std::sin(left) < std::sin(opposite);
}

/// Returns the polar angle of the gradient near an edge, within the face.
double EdgeJoiner::GradientAngle(FaceEnvelope& envelope, Id h, double x) const
{
  const int k = h % 3;
  std::array<double, 3> b{};
  const double t = x / this->Mesh.Length(h);
  b[(k + 2) % 3] = FaceRidgeFinder::RimInset;
  b[(k + 1) % 3] = t * (1.0 - FaceRidgeFinder::RimInset);
  b[k] = (1.0 - t) * (1.0 - FaceRidgeFinder::RimInset);
  const Point2 gradient = envelope.SampleAt(envelope.PlaceOf(b)).Gradient;
  const Point2 axis = Difference(envelope.GetCorners()[(k + 1) % 3], envelope.GetCorners()[k]);
  return std::atan2(Cross(axis, gradient), Dot(axis, gradient));
}

void EdgeJoiner::AddPieces(Id f)
{
  const FaceRidges& face = this->Faces[f];
  auto point = [&](const std::array<double, 3>& b) {
    return SurfacePoint::InTriangle(this->Mesh, f, b);
  };
  std::vector<Id>& nodes = this->Nodes[f];
  for (std::size_t i = 0; i < face.Ends.size(); ++i)
  {
    const RidgeEnd& end = face.Ends[i];
    if (end.On == RidgeEnd::Support::Vertex)
    {
      nodes[i] = this->Graph.AddNode(SurfacePoint::AtVertex(this->Mesh.Origin(3 * f + end.Side)));
    }
    else if (end.On == RidgeEnd::Support::Face)
    {
      nodes[i] = this->Graph.AddNode(point(end.Barycentric));
    }
  }
  for (const RidgePiece& piece : face.Pieces)
  {
    std::vector<SurfacePoint> between;
    between.reserve(piece.Points.size());
    for (const std::array<double, 3>& b : piece.Points)
    {
      between.push_back(point(b));
    }
    this->Graph.AddArc(nodes[piece.From], nodes[piece.To], f,
      0.5 * (face.Ends[piece.From].Angle + face.Ends[piece.To].Angle), std::move(between),
      this->Field.IsTraced(f));
  }
}

/// Replaces the angles of lines that continue in other parts by those of the entire ridges.
Status JoinParts(FieldPieces& pieces, Ridges& ridges)
{
  std::vector<RidgePart> parts = ridges.Parts;
  std::size_t firstHere = 0;
  for (RidgePart& part : parts)
  {
    for (RidgePart::Joint& joint : part.Ends)
    {
      for (int k = 0; k < 2 && joint[0] != NoId; ++k)
      {
        joint[k] = pieces.GetPointId(static_cast<Id>(joint[k]));
      }
    }
  }
  DGG_RETURN_IF_ERROR(pieces.Group.JoinLists(parts, &firstHere));
  std::vector<std::pair<RidgePart::Joint, Id>> ends;
  for (std::size_t i = 0; i < 2 * parts.size(); ++i)
  {
    if (parts[i / 2].Ends[i % 2][0] != NoId)
    {
      ends.emplace_back(parts[i / 2].Ends[i % 2], static_cast<Id>(i / 2));
    }
  }
  std::sort(ends.begin(), ends.end());
  DisjointSets sets(parts.size());
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    if (ends[i].first == ends[i - 1].first)
    {
      sets.Join(ends[i].second, ends[i - 1].second);
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Id first = sets.Find(static_cast<Id>(i)); // the smallest index
    if (first != static_cast<Id>(i))
    {
      parts[first].Angle.Add(parts[i].Angle);
    }
  }
  for (std::size_t i = 0; i < ridges.Parts.size(); ++i)
  {
    if (ridges.Parts[i].Line != NoId)
    {
      const Id first = sets.Find(static_cast<Id>(firstHere + i));
      ridges.Angles[ridges.Parts[i].Line] = parts[first].Angle.GetMean();
    }
  }
  return Status::Success();
}
}

Status FindRidges(const DistanceField& field, const RidgeOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, Ridges& ridges,
  FieldPieces* pieces)
{
  ridges = Ridges();
  DGG_RETURN_IF_ERROR(CheckCorners(*field.Mesh));
  RidgeOptions limited = options;
  limited.MinimumAngle =
    std::max(field.HasWindows() ? SmallestAngle : SmallestAngleOfModels, options.MinimumAngle);
  if (options.ChordTolerance == 0.0)
  {
    limited.ChordTolerance = DefaultTolerance * field.Mesh->GetMeanEdgeLength();
  }
  const Offset count = field.Mesh->GetNumberOfFaces();
  std::vector<FaceRidges> faces(count);
  std::vector<Id> fallbacks((count + FacesInBlock - 1) / FacesInBlock, 0);
  DGG_RETURN_IF_ERROR(ForBlocks(
    count, FacesInBlock, parallel, ProgressPart(progress, 0.0, FacesDone),
    [&] { return FaceRidgeFinder(field, limited); },
    [&](FaceRidgeFinder& finder, Offset block, Offset begin, Offset end) {
      for (Id f = static_cast<Id>(begin); f < static_cast<Id>(end); ++f)
      {
        if (field.IsTraced(f, 1)) // all faces at the points of the piece
        {
          const Id before = finder.GetNumberOfFallbacks();
          finder.Find(f, faces[f]);
          fallbacks[block] += field.IsTraced(f) ? finder.GetNumberOfFallbacks() - before : 0;
        }
      }
    }));
  RidgeGraph graph(*field.Mesh, pieces ? pieces->LongestEdge : field.Mesh->GetMaximumEdgeLength());
  EdgeJoiner(field, limited, faces, graph).Run();
  graph.MakeLines(ridges);
  if (pieces)
  {
    DGG_RETURN_IF_ERROR(JoinParts(*pieces, ridges));
  }
  for (const Id number : fallbacks)
  {
    ridges.Fallbacks += number;
  }
  return ReportTo(progress, 1.0);
}
}
