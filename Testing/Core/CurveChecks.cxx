// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveChecks.h"

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SubMesh;
using dgg::SurfaceCurve;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;
using Position = std::array<double, 3>;
using Edge = std::pair<Id, Id>;

/// Tolerance for snapping: points within 1e-9 of a vertex or edge in barycentric coordinates are
/// moved onto the vertex or edge, each coordinate by up to 1e-9. Crossings are computed after this
/// move.
constexpr double MoveTolerance = 1e-8;

double DistanceOf(const Position& a, const Position& b)
{
  return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
}

Edge Unordered(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Returns the number of faces per edge of a triangle list.
std::map<Edge, Id> CountFacesOfEdges(const std::vector<Id>& triangles)
{
  std::map<Edge, Id> edges;
  for (Id h = 0; h < static_cast<Id>(triangles.size()); ++h)
  {
    ++edges[Unordered(triangles[h], triangles[SurfaceMesh::Next(h)])];
  }
  return edges;
}

/// Returns twice the area of a face relative to the area of its parent.
double PartOf(const SurfaceMesh& mesh, const SubMesh& surface, Id face)
{
  std::array<double, 3> p[3];
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_TRUE(dgg::FindInFace(
      mesh, surface.Points[surface.Triangles[3 * face + k]], surface.Faces[face], p[k]));
  }
  return (p[1][1] - p[0][1]) * (p[2][2] - p[0][2]) - (p[1][2] - p[0][2]) * (p[2][1] - p[0][1]);
}

void ExpectFacesCovered(const SurfaceMesh& mesh, const SubMesh& surface)
{
  std::vector<double> parts(mesh.GetNumberOfFaces(), 0.0);
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    const double part = PartOf(mesh, surface, f);
    ASSERT_GT(part, 0.0) << "face " << f << " of parent " << surface.Faces[f];
    parts[surface.Faces[f]] += part;
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    ASSERT_NEAR(parts[f], mesh.IsDropped(f) ? 0.0 : 1.0, 1e-12) << "parent " << f;
  }
}

/// Returns the half-edge of the mesh on which both points lie; NoId if the edge between the points
/// is inside a face.
Id FindOldEdge(const SurfaceMesh& mesh, const SubMesh& surface, Id h)
{
  const Id face = surface.Faces[SurfaceMesh::Face(h)];
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  EXPECT_TRUE(dgg::FindInFace(mesh, surface.Points[surface.Triangles[h]], face, p));
  EXPECT_TRUE(
    dgg::FindInFace(mesh, surface.Points[surface.Triangles[SurfaceMesh::Next(h)]], face, q));
  for (int k = 0; k < 3; ++k)
  {
    if (p[k] == 0.0 && q[k] == 0.0)
    {
      return 3 * face + (k + 1) % 3;
    }
  }
  return NoId;
}

Id CountFacesAround(const std::function<Id(Id)>& twin, Id h)
{
  Id count = 1;
  for (Id e = twin(h); e != NoId && e != h; e = twin(e))
  {
    ++count;
  }
  return count;
}

bool HasDuplicateFaces(const SurfaceMesh& mesh)
{
  std::set<std::array<Id, 3>> faces;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    std::array<Id, 3> corners = mesh.GetTriangle(f);
    std::sort(corners.begin(), corners.end());
    if (!mesh.IsDropped(f) && !faces.insert(corners).second)
    {
      return true;
    }
  }
  return false;
}

/// Expects each edge to have the faces of its old edge, or two faces if the edge is inside a face.
void ExpectEdgesFit(const SurfaceMesh& mesh, const SubMesh& surface)
{
  const std::map<Edge, Id> edges = CountFacesOfEdges(surface.Triangles);
  const bool hasDuplicates = HasDuplicateFaces(mesh);
  for (Id h = 0; h < static_cast<Id>(surface.Triangles.size()); ++h)
  {
    const Id old = FindOldEdge(mesh, surface, h);
    const Id expected = old == NoId ? 2 : CountFacesAround([&](Id e) { return mesh.Twin(e); }, old);
    const Edge ends = Unordered(surface.Triangles[h], surface.Triangles[SurfaceMesh::Next(h)]);
    // Duplicate faces have inner edges that their end points do not distinguish.
    ASSERT_TRUE(hasDuplicates || edges.at(ends) == expected) << ends.first << " " << ends.second;
    ASSERT_EQ(CountFacesAround([&](Id e) { return surface.Twins[e]; }, h), expected);
  }
}

void ExpectSoundChain(const TestMesh& input, const SurfaceMesh& mesh,
  const std::vector<SurfaceCurve>& curves, std::size_t number, const SubMesh& surface,
  const std::map<Edge, Id>& edges)
{
  const SurfaceCurve& curve = curves[number];
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, number);
  const double tolerance = MoveTolerance * mesh.GetMaximumEdgeLength();
  const double* points = input.Points.data();
  auto positionOf = [&](
                      Id vertex) { return dgg::PositionOf(mesh, surface.Points[vertex], points); };
  ASSERT_EQ(chain.Vertices.empty(), curve.Path.Points.empty());
  ASSERT_EQ(chain.Parameters.size(), chain.Vertices.size());
  ASSERT_TRUE(std::is_sorted(chain.Parameters.begin(), chain.Parameters.end()));
  const std::vector<double>& places = surface.Places[number];
  for (std::size_t i = 0; i < chain.Vertices.size(); ++i)
  {
    const auto piece = std::min(static_cast<std::size_t>(places[i]), curve.Path.Points.size() - 1);
    const SurfacePoint on = piece >= curve.Path.Faces.size()
      ? curve.Path.Points.back()
      : Between(mesh, curve.Path.Points[piece], curve.Path.Points[piece + 1],
          curve.Path.Faces[piece], places[i] - static_cast<double>(piece));
    ASSERT_LE(
      DistanceOf(positionOf(chain.Vertices[i]), dgg::PositionOf(mesh, on, points)), tolerance)
      << "curve " << number << ", vertex " << i;
    if (i > 0)
    {
      ASSERT_EQ(edges.count(Unordered(chain.Vertices[i - 1], chain.Vertices[i])), 1u)
        << "curve " << number << ", vertex " << i;
      ASSERT_LT(places[i - 1], places[i]);
    }
  }
  // The embedded chain contains all points of the curve, including its crossings.
  for (std::size_t k = 0; k < curve.Path.Points.size(); ++k)
  {
    const auto beyond = std::upper_bound(places.begin(), places.end(), static_cast<double>(k));
    ASSERT_NE(beyond, places.begin());
    const Id vertex = chain.Vertices[beyond - places.begin() - 1];
    ASSERT_LE(DistanceOf(positionOf(vertex), dgg::PositionOf(mesh, curve.Path.Points[k], points)),
      tolerance)
      << "curve " << number << ", point " << k;
  }
  ASSERT_EQ(chain.GivenPoints.size(), curve.GivenPoints.size());
  for (std::size_t i = 0; i < chain.GivenPoints.size(); ++i)
  {
    const SurfacePoint& given = curve.Path.Points[curve.GivenPoints[i]];
    const Id vertex = chain.Vertices[chain.GivenPoints[i]];
    ASSERT_LE(DistanceOf(positionOf(vertex), dgg::PositionOf(mesh, given, points)), tolerance);
    ASSERT_LE(chain.Parameters[chain.GivenPoints[i]], static_cast<double>(i));
  }
  if (curve.IsClosed && !chain.Vertices.empty())
  {
    ASSERT_EQ(chain.Vertices.front(), chain.Vertices.back());
  }
}

/// Collects the path edges with two faces in `cuts` and returns their number per end vertex.
std::map<Id, Id> CountCutsAt(const SubMesh& surface, std::set<Edge>& cuts)
{
  const std::map<Edge, Id> edges = CountFacesOfEdges(surface.Triangles);
  std::map<Id, Id> cutsAt;
  for (const std::vector<Id>& path : surface.Paths)
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Edge edge = Unordered(path[i], path[i + 1]);
      if (edges.at(edge) == 2 && cuts.insert(edge).second)
      {
        ++cutsAt[edge.first];
        ++cutsAt[edge.second];
      }
    }
  }
  return cutsAt;
}

/// Expects one copy of a vertex per sector between cuts, and edges with one or two faces.
void ExpectSoundCopies(const SubMesh& surface, const dgg::SubMesh& cut)
{
  std::set<Edge> cuts;
  const std::map<Id, Id> cutsAt = CountCutsAt(surface, cuts);
  const std::map<Edge, Id> edges = CountFacesOfEdges(surface.Triangles);
  std::vector<char> isBoundary(surface.Points.size(), 0);
  for (const auto& edge : edges)
  {
    if (edge.second == 1)
    {
      isBoundary[edge.first.first] = 1;
      isBoundary[edge.first.second] = 1;
    }
  }
  std::vector<Id> copies(surface.Points.size(), 0);
  for (std::size_t v = 0; v < cut.VertexOf.size(); ++v)
  {
    ASSERT_TRUE(v >= surface.Points.size() || cut.VertexOf[v] == static_cast<Id>(v));
    ++copies[cut.VertexOf[v]];
  }
  Id more = 0;
  for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
  {
    const auto found = cutsAt.find(v);
    const Id count = found == cutsAt.end() ? 0 : found->second;
    const Id expected = isBoundary[v] ? count + 1 : std::max(count, 1);
    ASSERT_EQ(copies[v], expected) << "vertex " << v;
    more += expected - 1;
  }
  ASSERT_EQ(cut.Triangles.size(), surface.Triangles.size());
  ASSERT_EQ(cut.Faces, surface.Faces);
  std::set<Edge> directed;
  std::map<Id, Id> openAt;
  for (Id h = 0; h < static_cast<Id>(cut.Triangles.size()); ++h)
  {
    ASSERT_EQ(cut.VertexOf[cut.Triangles[h]], surface.Triangles[h]);
    ASSERT_TRUE(directed.emplace(cut.Triangles[h], cut.Triangles[SurfaceMesh::Next(h)]).second);
  }
  // Edges are not identified by their end points: both sides of a path of one edge have the same
  // ones.
  std::size_t halfEdges = 0; // two per edge
  for (Id h = 0; h < static_cast<Id>(cut.Triangles.size()); ++h)
  {
    const Id from = cut.Triangles[h];
    const Id to = cut.Triangles[SurfaceMesh::Next(h)];
    const Id twin = cut.Twins[h];
    halfEdges += twin == NoId ? 2 : 1;
    if (twin == NoId)
    {
      ++openAt[from];
      ++openAt[to];
      continue;
    }
    ASSERT_EQ(cut.Twins[twin], h);
    ASSERT_EQ(cut.Triangles[twin], to);
    ASSERT_EQ(cut.Triangles[SurfaceMesh::Next(twin)], from);
  }
  for (const auto& open : openAt)
  {
    ASSERT_EQ(open.second, 2) << "vertex " << open.first;
  }
  ASSERT_EQ(halfEdges, 2 * (edges.size() + cuts.size()));
  ASSERT_EQ(cut.VertexOf.size(), surface.Points.size() + static_cast<std::size_t>(more));
}

void ExpectSoundSide(
  const dgg::SubMesh& cut, const dgg::EdgeSide& side, const Edge& edge, bool isLeft)
{
  ASSERT_GE(side.Face, 0);
  ASSERT_EQ(cut.VertexOf[side.From], edge.first);
  ASSERT_EQ(cut.VertexOf[side.To], edge.second);
  const Id from = isLeft ? side.From : side.To;
  const Id to = isLeft ? side.To : side.From;
  bool isFound = false;
  for (Id h = 3 * side.Face; h < 3 * side.Face + 3; ++h)
  {
    isFound = isFound || (cut.Triangles[h] == from && cut.Triangles[SurfaceMesh::Next(h)] == to);
  }
  ASSERT_TRUE(isFound) << edge.first << " " << edge.second;
}
}

void ExpectSoundCurve(
  const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, const SurfaceCurve& curve)
{
  ASSERT_TRUE(Ok(dgg::CheckPath(mesh, curve.Path)));
  ASSERT_EQ(curve.Parameters.size(), curve.Path.Points.size());
  ASSERT_EQ(curve.GivenPoints.size(), points.size());
  ASSERT_TRUE(std::is_sorted(curve.Parameters.begin(), curve.Parameters.end()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const dgg::Offset place = curve.GivenPoints[i];
    ASSERT_TRUE(dgg::IsSamePoint(curve.Path.Points[place], points[i]));
    ASSERT_EQ(curve.Parameters[place], static_cast<double>(i));
  }
  if (curve.IsClosed && !points.empty())
  {
    ASSERT_TRUE(dgg::IsSamePoint(curve.Path.Points.back(), points[0]));
    ASSERT_EQ(
      curve.Parameters.back(), points.size() > 1 ? static_cast<double>(points.size()) : 0.0);
  }
}

void ExpectSoundEmbedding(const TestMesh& input, const SurfaceMesh& mesh,
  const std::vector<SurfaceCurve>& curves, const SubMesh& surface)
{
  ASSERT_EQ(surface.Triangles.size(), 3 * surface.Faces.size());
  ASSERT_EQ(surface.Paths.size(), curves.size());
  ASSERT_EQ(surface.Places.size(), curves.size());
  ASSERT_GE(surface.GetNumberOfVertices(), mesh.GetNumberOfVertices());
  for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
  {
    ASSERT_TRUE(surface.Points[v].Check(mesh).IsOk());
    ASSERT_EQ(dgg::IsVertex(surface.Points[v]), v < mesh.GetNumberOfVertices());
    ASSERT_TRUE(v >= mesh.GetNumberOfVertices() || surface.Points[v].Vertex == v);
  }
  ExpectFacesCovered(mesh, surface);
  ExpectEdgesFit(mesh, surface);
  const std::map<Edge, Id> edges = CountFacesOfEdges(surface.Triangles);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    ExpectSoundChain(input, mesh, curves, c, surface, edges);
  }
}

void ExpectSoundCut(const SubMesh& surface, const dgg::CurveCut& cut)
{
  ExpectSoundCopies(surface, cut.Surface);
  const std::map<Edge, Id> edges = CountFacesOfEdges(surface.Triangles);
  ASSERT_EQ(cut.Sides.size(), surface.Paths.size());
  for (std::size_t p = 0; p < surface.Paths.size(); ++p)
  {
    const std::vector<Id>& path = surface.Paths[p];
    ASSERT_EQ(cut.Sides[p].Left.size(), path.empty() ? 0 : path.size() - 1);
    ASSERT_EQ(cut.Sides[p].Right.size(), cut.Sides[p].Left.size());
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Edge edge{ path[i], path[i + 1] };
      const dgg::EdgeSide& left = cut.Sides[p].Left[i];
      const dgg::EdgeSide& right = cut.Sides[p].Right[i];
      const Id sides = (left.Face != NoId ? 1 : 0) + (right.Face != NoId ? 1 : 0);
      ASSERT_EQ(sides, edges.at(Unordered(path[i], path[i + 1])));
      if (left.Face != NoId)
      {
        ExpectSoundSide(cut.Surface, left, edge, true);
      }
      if (right.Face != NoId)
      {
        ExpectSoundSide(cut.Surface, right, edge, false);
      }
    }
  }
}

using dgg::NoId;
using dgg::SubMesh;
using dgg::SurfaceCurve;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;

SurfacePoint PointIn(const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  std::array<double, 3> b = barycentric;
  if (mesh.IsFlipped(face))
  {
    std::swap(b[1], b[2]);
  }
  return SurfacePoint::InFace(mesh, face, b);
}

SurfacePoint Between(
  const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b, Id face, double t)
{
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  EXPECT_TRUE(dgg::FindInFace(mesh, a, face, p));
  EXPECT_TRUE(dgg::FindInFace(mesh, b, face, q));
  for (int k = 0; k < 3; ++k)
  {
    p[k] = (1.0 - t) * p[k] + t * q[k];
  }
  return PointIn(mesh, face, p);
}

std::vector<SurfacePoint> RandomCurvePoints(const SurfaceMesh& mesh, Id count, Random& random)
{
  std::vector<SurfacePoint> points;
  auto randomFace = [&]() {
    Id face = 0;
    do
    {
      face = random.Index(mesh.GetNumberOfFaces());
    } while (mesh.IsDropped(face));
    return face;
  };
  auto inFace = [&](Id face) {
    const double a = -std::log(1.0 - random.Uniform());
    const double b = -std::log(1.0 - random.Uniform());
    const double c = -std::log(1.0 - random.Uniform()) + 1e-9;
    const double sum = a + b + c;
    return PointIn(mesh, face, { { a / sum, b / sum, c / sum } });
  };
  points.push_back(inFace(randomFace()));
  while (static_cast<Id>(points.size()) < count)
  {
    const SurfacePoint last = points.back();
    const Id face = dgg::FindFaceOf(mesh, last);
    std::array<double, 3> b{};
    EXPECT_TRUE(dgg::FindInFace(mesh, last, face, b));
    const Id k = random.Index(3);
    switch (random.Index(10))
    {
      case 0:
        points.push_back(last);
        break;
      case 1: // an earlier point
        points.push_back(points[random.Index(static_cast<Id>(points.size()))]);
        break;
      case 2: // a corner of the face
        points.push_back(SurfacePoint::AtVertex(mesh.Origin(3 * face + k)));
        break;
      case 3: // a point on a side of the face
        points.push_back(SurfacePoint::OnEdge(mesh, 3 * face + k, random.Uniform()));
        break;
      case 4: // a tiny step
      {
        const double step = std::pow(10.0, -random.Uniform(1.0, 13.0)) * random.Uniform();
        for (int c = 0; c < 3; ++c)
        {
          b[c] = (1.0 - step) * b[c] + (c == k ? step : 0.0);
        }
        points.push_back(PointIn(mesh, face, b));
        break;
      }
      case 5: // a point on the straight line between two points of one face
      {
        const SurfacePoint& other = points[random.Index(static_cast<Id>(points.size()))];
        const Id common = dgg::FindCommonFace(mesh, last, other);
        if (common != NoId)
        {
          points.push_back(Between(mesh, last, other, common, random.Uniform()));
        }
        break;
      }
      case 6: {
        const Id twin = mesh.Twin(3 * face + k);
        points.push_back(inFace(twin == NoId ? face : SurfaceMesh::Face(twin)));
        break;
      }
      case 7:
        points.push_back(SurfacePoint::AtVertex(mesh.Origin(3 * randomFace())));
        break;
      case 8:
        points.push_back(
          SurfacePoint::OnEdge(mesh, 3 * randomFace() + k, random.Uniform(1e-10, 1.0)));
        break;
      default:
        points.push_back(inFace(randomFace()));
    }
  }
  return points;
}

SurfaceCurve Curve(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, bool isClosed)
{
  SurfaceCurve curve;
  EXPECT_TRUE(Ok(dgg::JoinPoints(mesh, points, isClosed, nullptr, curve)));
  return curve;
}

SubMesh Embed(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves)
{
  SubMesh surface;
  EXPECT_TRUE(Ok(dgg::EmbedCurves(mesh, curves, nullptr, surface)));
  return surface;
}

dgg::CurveCut CutOpen(const SubMesh& surface)
{
  dgg::CurveCut cut;
  EXPECT_TRUE(Ok(dgg::CutAlongCurves(surface, surface.Paths, cut)));
  return cut;
}
}
