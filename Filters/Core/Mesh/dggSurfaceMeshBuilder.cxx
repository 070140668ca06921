// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceMeshBuilder.h"

#include "dggCapSplitting.h"
#include "dggEdges.h"
#include "dggGroups.h"
#include "dggPoint3.h"
#include "dggStatus.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
/// Minimum relative slack of faces that were already lengthened in a parent mesh, where rounding
/// may have reduced their slack.
constexpr double LeastSlackOfParts = 0.5;
/// Relative tolerance between the lengths of both halves of an edge.
constexpr double LengthAgreement = 1e-9;
/// Rounding errors of lengths, as a fraction of the longest edge.
constexpr double LengthRounding = 1e-12;
/// Range of extents for which squares and products of four lengths do not overflow or underflow.
constexpr double SmallestExtent = 1e-70;
constexpr double LargestExtent = 1e70;

/// Returns the id of a half-edge after its face has been flipped (corners 1 and 2 swapped).
Id Turned(Id h)
{
  const Id k = h % 3;
  return h - k + (2 - k);
}
}

Status SurfaceMeshBuilder::TakeTriangles(
  Offset numberOfVertices, const Id* triangles, Offset numberOfTriangles)
{
  constexpr Offset limit = std::numeric_limits<Id>::max();
  if (numberOfVertices < 0 || numberOfTriangles < 0 || numberOfVertices > limit ||
    numberOfTriangles > limit / 3)
  {
    return InvalidInput(
      "A mesh of ", numberOfVertices, " points and ", numberOfTriangles, " triangles is too large")
      .Fix("Use at most ", limit, " points and ", limit / 3, " triangles");
  }
  const Id* const end = triangles + 3 * numberOfTriangles;
  const Id* const wrong = std::find_if(
    triangles, end, [numberOfVertices](Id v) { return v < 0 || v >= numberOfVertices; });
  if (wrong != end)
  {
    return InvalidInput(
      "Triangle ", (wrong - triangles) / 3, " refers to point ", *wrong, ", which does not exist")
      .Fix("Use ids from 0 to ", numberOfVertices - 1);
  }
  const auto n = static_cast<std::size_t>(numberOfVertices);
  const auto m = static_cast<std::size_t>(numberOfTriangles);
  this->Mesh = SurfaceMesh();
  this->Mesh.Origins.assign(triangles, triangles + 3 * m);
  this->Mesh.Twins.assign(3 * m, NoId);
  this->Mesh.Lengths.assign(3 * m, 0.0);
  this->Mesh.FaceFlags.assign(m, 0);
  this->Mesh.VertexFlags.assign(n, 0);
  return Status::Success();
}

void SurfaceMeshBuilder::DropRepeatedVertexFaces()
{
  for (Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    const auto t = this->Mesh.GetTriangle(f);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      this->Mesh.FaceFlags[f] |= SurfaceMesh::DroppedFlag;
    }
  }
}

/// Groups the half-edges of faces that are not dropped by their origins.
void SurfaceMeshBuilder::GroupByOrigin()
{
  const SurfaceMesh& mesh = this->Mesh;
  const bool isAnyDropped = std::any_of(mesh.FaceFlags.begin(), mesh.FaceFlags.end(),
    [](std::uint8_t flags) { return (flags & SurfaceMesh::DroppedFlag) != 0; });
  this->Outgoing = isAnyDropped
    ? MakeGroups(mesh.GetNumberOfHalfEdges(), mesh.GetNumberOfVertices(),
        [&](Id h) { return mesh.IsDropped(SurfaceMesh::Face(h)) ? NoId : mesh.Origin(h); })
    : MakeGroups(mesh.Origins, mesh.VertexFlags.size());
}

void SurfaceMeshBuilder::GlueByVertices(const std::uint8_t* isRim)
{
  this->DropRepeatedVertexFaces();
  this->GroupByOrigin();
  this->AreAllLinked = true;
  const SurfaceMesh& mesh = this->Mesh;
  this->LastHalfEdges.assign(mesh.VertexFlags.size(), LastHalfEdge());
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    for (Offset i = this->Outgoing.Begins[v]; i < this->Outgoing.Begins[v + 1]; ++i)
    {
      const Id outgoing = this->Outgoing.Members[i];
      const Id incoming = SurfaceMesh::Previous(outgoing);
      const Id left = mesh.Origin(incoming);
      const Id right = mesh.Destination(outgoing);
      if (!isRim || !isRim[v] || !isRim[right])
      {
        this->Glue(v, right, outgoing, left);
      }
      if (!isRim || !isRim[v] || !isRim[left])
      {
        this->Glue(v, left, incoming, right);
      }
    }
  }
  std::vector<LastHalfEdge>().swap(this->LastHalfEdges);
  for (const Id edge : this->CrowdedEdges)
  {
    this->RelinkWithoutDuplicates(edge);
  }
  if (!this->Mesh.Duplicates.empty())
  {
    std::sort(this->Mesh.Duplicates.begin(), this->Mesh.Duplicates.end());
    this->GroupByOrigin();
  }
}

/// Appends half-edge h, between v and a larger neighbor, to the circular list of its edge. Must be
/// called vertex by vertex, in the order of half-edges.
void SurfaceMeshBuilder::Glue(Id v, Id neighbor, Id h, Id apex)
{
  if (neighbor < v)
  {
    return;
  }
  SurfaceMesh& mesh = this->Mesh;
  LastHalfEdge& last = this->LastHalfEdges[neighbor];
  if (last.Smaller == v)
  {
    const Id t = last.HalfEdge;
    const bool isSecond = mesh.Twins[t] == NoId;
    const Id first = isSecond ? t : mesh.Twins[t];
    // Once per edge for a third face, once for a duplicate of the first.
    if (isSecond ? last.Apex == apex : mesh.Twins[first] == t)
    {
      this->CrowdedEdges.push_back(h);
    }
    this->AreAllLinked = this->AreAllLinked && isSecond && mesh.Origin(t) != mesh.Origin(h);
    mesh.Twins[t] = h;
    mesh.Twins[h] = first;
  }
  last = { v, h, apex };
}

/// Drops duplicates on an edge: faces on the same edge with the same apex have the same three
/// vertices. Links the other faces.
void SurfaceMeshBuilder::RelinkWithoutDuplicates(Id edge)
{
  SurfaceMesh& mesh = this->Mesh;
  std::vector<Id> halfEdges;
  ForEachHalfEdge(mesh, edge, [&](Id h) { halfEdges.push_back(h); });
  std::vector<std::pair<Id, Id>> apexes;
  std::transform(halfEdges.begin(), halfEdges.end(), std::back_inserter(apexes),
    [&](Id h) { return std::make_pair(mesh.Apex(h), h); });
  std::sort(apexes.begin(), apexes.end());
  std::size_t original = 0;
  for (std::size_t i = 1; i < apexes.size(); ++i)
  {
    original = apexes[i].first == apexes[original].first ? original : i;
    const Id f = SurfaceMesh::Face(apexes[i].second);
    if (original != i && !mesh.IsDuplicate(f))
    {
      mesh.FaceFlags[f] |= SurfaceMesh::DroppedFlag | SurfaceMesh::DuplicateFlag;
      mesh.Duplicates.push_back({ { f, SurfaceMesh::Face(apexes[original].second) } });
    }
  }
  for (const Id h : halfEdges)
  {
    mesh.Twins[h] = NoId;
  }
  const auto isDropped = [&](Id h) { return mesh.IsDropped(SurfaceMesh::Face(h)); };
  halfEdges.erase(std::remove_if(halfEdges.begin(), halfEdges.end(), isDropped), halfEdges.end());
  for (std::size_t i = 0; halfEdges.size() > 1 && i < halfEdges.size(); ++i)
  {
    mesh.Twins[halfEdges[i]] = halfEdges[(i + 1) % halfEdges.size()];
  }
}

Status SurfaceMeshBuilder::GlueByTwins(const Id* twins)
{
  const SurfaceMesh& mesh = this->Mesh;
  const Id halfEdges = mesh.GetNumberOfHalfEdges();
  std::vector<Id> entries(halfEdges, 0);
  for (Id h = 0; h < halfEdges; ++h)
  {
    const Id t = twins[h];
    if (t == NoId)
    {
      continue;
    }
    const bool inRange = t >= 0 && t < halfEdges && t != h;
    const bool joins = inRange &&
      ((mesh.Origin(t) == mesh.Destination(h) && mesh.Destination(t) == mesh.Origin(h)) ||
        (mesh.Origin(t) == mesh.Origin(h) && mesh.Destination(t) == mesh.Destination(h)));
    if (!joins || ++entries[t] > 1)
    {
      return InvalidInput("Half-edge ", h, " cannot be the twin of half-edge ", t)
        .Fix("Use other half-edges between the same vertices, in closed lists");
    }
  }
  for (Id h = 0; h < halfEdges; ++h)
  {
    if ((twins[h] == NoId) != (entries[h] == 0))
    {
      return InvalidInput("Half-edge ", h, " has a twin in one direction only");
    }
  }
  this->Mesh.Twins.assign(twins, twins + halfEdges);
  this->GroupByOrigin();
  return Status::Success();
}

Status SurfaceMeshBuilder::CheckExtent(double extent, const char* what) const
{
  return extent >= SmallestExtent && extent <= LargestExtent
    ? Status::Success()
    : InvalidInput(what, " is ", extent, extent == 0.0 ? ": all triangles are single points" : "")
        .Fix(extent == 0.0 ? "Correct the points"
                           : JoinText("Scale the mesh so that it is between ", SmallestExtent,
                               " and ", LargestExtent));
}

/// Returns the error of the first triangle with a point that is not finite.
Status SurfaceMeshBuilder::DescribeNotFinite(const double* points) const
{
  const SurfaceMesh& mesh = this->Mesh;
  Id h = 0;
  while (mesh.IsDropped(SurfaceMesh::Face(h)) || IsFinite(PointAt(points, mesh.Origin(h))))
  {
    ++h;
  }
  return InvalidInput("Point ", mesh.Origin(h), " of triangle ", SurfaceMesh::Face(h),
    " has a coordinate that is not finite")
    .Fix("Correct the point or remove the triangle");
}

Status SurfaceMeshBuilder::MeasureLengths(const double* points)
{
  SurfaceMesh& mesh = this->Mesh;
  Point3 low{ Infinity, Infinity, Infinity };
  Point3 high{ -Infinity, -Infinity, -Infinity };
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (this->Outgoing.Begins[v] == this->Outgoing.Begins[v + 1])
    {
      continue;
    }
    const Point3 p = PointAt(points, v);
    if (!IsFinite(p))
    {
      return this->DescribeNotFinite(points);
    }
    low = { std::min(low.X, p.X), std::min(low.Y, p.Y), std::min(low.Z, p.Z) };
    high = { std::max(high.X, p.X), std::max(high.Y, p.Y), std::max(high.Z, p.Z) };
  }
  if (high.X < low.X)
  {
    return Status::Success(); // all faces are dropped
  }
  const Point3 size = high - low;
  DGG_RETURN_IF_ERROR(
    this->CheckExtent(std::max({ size.X, size.Y, size.Z }), "The largest extent of the mesh"));
  double longest = 0.0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (mesh.IsDropped(f))
    {
      continue;
    }
    const std::array<Id, 3> triangle = mesh.GetTriangle(f);
    const std::array<Point3, 3> corners{ { PointAt(points, triangle[0]),
      PointAt(points, triangle[1]), PointAt(points, triangle[2]) } };
    for (int k = 0; k < 3; ++k)
    {
      // Bitwise identical for both halves of an edge.
      const double length = Norm(corners[(k + 1) % 3] - corners[k]);
      mesh.Lengths[3 * f + k] = length;
      longest = std::max(longest, length);
    }
  }
  mesh.MaximumEdgeLength = longest;
  // Triangles that degenerate to points may be far from each other.
  return this->CheckExtent(longest, "The longest edge");
}

Status SurfaceMeshBuilder::TakeLengths(const double* lengths)
{
  SurfaceMesh& mesh = this->Mesh;
  double longest = 0.0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      continue;
    }
    double length = lengths[h];
    double shortest = lengths[h];
    ForEachTwin(mesh, h, [&](Id g) {
      length = std::max(length, lengths[g]);
      shortest = std::min(shortest, lengths[g]);
    });
    if (!std::isfinite(lengths[h]) || lengths[h] < 0.0 ||
      length - shortest > LengthAgreement * length)
    {
      return InvalidInput("Half-edge ", h, " has the length ", lengths[h])
        .Fix("Use lengths that are finite, not negative, and equal on all halves of an edge");
    }
    mesh.Lengths[h] = length;
    longest = std::max(longest, length);
  }
  mesh.MaximumEdgeLength = longest;
  const bool isEmpty = std::all_of(mesh.FaceFlags.begin(), mesh.FaceFlags.end(),
    [](std::uint8_t flags) { return (flags & SurfaceMesh::DroppedFlag) != 0; });
  return isEmpty ? Status::Success() : this->CheckExtent(longest, "The longest edge");
}

Status SurfaceMeshBuilder::CheckTriangleInequalities() const
{
  // A small face that was cut out of a large face has the rounding errors of the large face.
  const std::vector<double>& lengths = this->Mesh.Lengths;
  const double rounding =
    lengths.empty() ? 0.0 : LengthRounding * *std::max_element(lengths.begin(), lengths.end());
  for (Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    const Id h = 3 * f;
    const double a = this->Mesh.Length(h);
    const double b = this->Mesh.Length(h + 1);
    const double c = this->Mesh.Length(h + 2);
    const double longest = std::max({ a, b, c });
    if (!this->Mesh.IsDropped(f) &&
      2.0 * longest - (a + b + c) > std::max(LengthAgreement * longest, rounding))
    {
      return InvalidInput("Face ", f, " has edges of the lengths ", a, ", ", b, " and ", c,
        ", which violate the triangle inequality")
        .Fix("Correct the lengths");
    }
  }
  return Status::Success();
}

/// Returns true if the edge of h has two half-edges that run in opposite directions.
bool SurfaceMeshBuilder::IsLinked(Id h) const
{
  const SurfaceMesh& mesh = this->Mesh;
  const Id t = mesh.Twin(h);
  return t != NoId &&
    (this->AreAllLinked || (mesh.Twin(t) == h && mesh.Origin(t) == mesh.Destination(h)));
}

/// Sets AreAllLinked. Returns false if a manifold edge has half-edges that run in the same
/// direction.
bool SurfaceMeshBuilder::FindLinks()
{
  const SurfaceMesh& mesh = this->Mesh;
  bool isOriented = true;
  bool areAllLinked = true;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = mesh.Twin(h);
    const bool isLinked = this->IsLinked(h);
    isOriented = isOriented && (isLinked || t == NoId || mesh.Twin(t) != h);
    areAllLinked = areAllLinked && (isLinked || t == NoId);
  }
  this->AreAllLinked = areAllLinked;
  return isOriented;
}

void SurfaceMeshBuilder::Orient()
{
  SurfaceMesh& mesh = this->Mesh;
  if (this->AreAllLinked || this->FindLinks())
  {
    return;
  }
  const Id faces = mesh.GetNumberOfFaces();
  std::vector<std::uint8_t> seen(faces, 0);
  std::vector<std::uint8_t> turn(faces, 0);
  std::vector<Id> component;
  for (Id seed = 0; seed < faces; ++seed)
  {
    if (seen[seed] || mesh.IsDropped(seed))
    {
      continue;
    }
    component.assign(1, seed);
    seen[seed] = 1;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      const Id f = component[i];
      turned += turn[f];
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Id t = mesh.Twin(h);
        if (t == NoId || mesh.Twin(t) != h)
        {
          continue; // only manifold edges propagate the orientation
        }
        const Id g = SurfaceMesh::Face(t);
        const bool opposed = mesh.Origin(t) == mesh.Destination(h);
        if (!seen[g])
        {
          seen[g] = 1;
          turn[g] = opposed ? turn[f] : 1 - turn[f];
          component.push_back(g);
        }
      }
    }
    // An edge from a vertex to itself is glued with opposite half-edges; flipping only one of its
    // faces would change that.
    const bool keeps = std::all_of(component.begin(), component.end(), [&](Id f) {
      bool same = true;
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Id t = mesh.Twin(h);
        same = same &&
          (t == NoId || mesh.Origin(h) != mesh.Destination(h) ||
            turn[SurfaceMesh::Face(t)] == turn[f]);
      }
      return same;
    });
    if (!keeps)
    {
      for (const Id f : component)
      {
        turn[f] = 0;
      }
    }
    else if (2 * turned > component.size())
    {
      for (const Id f : component)
      {
        turn[f] = 1 - turn[f];
      }
    }
  }

  auto renamed = [&](Id h) { return h != NoId && turn[SurfaceMesh::Face(h)] ? Turned(h) : h; };
  std::vector<Id> twins(mesh.Twins.size());
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    twins[renamed(h)] = renamed(mesh.Twins[h]);
  }
  mesh.Twins.swap(twins);
  for (Id f = 0; f < faces; ++f)
  {
    if (turn[f])
    {
      const Id h = 3 * f;
      std::swap(mesh.Origins[h + 1], mesh.Origins[h + 2]);
      std::swap(mesh.Lengths[h], mesh.Lengths[h + 2]);
      mesh.FaceFlags[f] |= SurfaceMesh::FlippedFlag;
    }
  }
  this->GroupByOrigin();
  this->FindLinks();
}

void SurfaceMeshBuilder::TakeOrigin(const PartOfMesh& origin)
{
  this->Parent = origin.Parent;
  if (!origin.Parent)
  {
    return;
  }
  for (Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    const Id old = origin.Faces[f];
    if (!this->Mesh.IsDropped(f) && origin.Parent->IsMollified(old))
    {
      this->Mesh.FaceFlags[f] |= SurfaceMesh::MollifiedFlag;
      this->Mesh.FaceFlags[f] |= origin.Parent->IsDegenerate(old) ? SurfaceMesh::DegenerateFlag : 0;
      this->Mesh.Mollification = origin.Parent->GetMollification();
    }
  }
}

void SurfaceMeshBuilder::MeasureMeanEdge()
{
  SurfaceMesh& mesh = this->Mesh;
  LengthSum sum(mesh.MaximumEdgeLength);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (mesh.IsDropped(f))
    {
      continue;
    }
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      // Counts each edge once. Branchless, because branches would be unpredictable. NoId becomes
      // the largest number, so that boundary edges count.
      const bool counts = this->AreAllLinked
        ? static_cast<std::uint32_t>(mesh.Twin(h)) > static_cast<std::uint32_t>(h)
        : FindEdge(mesh, h) == h;
      sum.Add(mesh.Lengths[h], counts);
    }
  }
  mesh.MeanEdgeLength = sum.GetMean();
}

/// Returns the largest violation of the triangle inequality over the corners of a face; 0 if there
/// is none.
double SurfaceMeshBuilder::TriangleInequalityViolation(Id f) const
{
  const SurfaceMesh& mesh = this->Mesh;
  const double a = mesh.Lengths[3 * f];
  const double b = mesh.Lengths[3 * f + 1];
  const double c = mesh.Lengths[3 * f + 2];
  const double longest = std::max({ a, b, c });
  const double mean = this->Parent ? this->Parent->GetMeanEdgeLength() : mesh.MeanEdgeLength;
  const double tau = DegeneracySlack * std::max(mean, longest);
  // The two shorter edges minus the longest; the closest lengths are subtracted first.
  const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  const double shortest = std::min({ a, b, c });
  const double slack = shortest - (longest - middle);
  return slack < (this->Parent ? LeastSlackOfParts : 1.0) * tau ? tau - slack : 0.0;
}

void SurfaceMeshBuilder::Mollify()
{
  SurfaceMesh& mesh = this->Mesh;
  this->MeasureMeanEdge();
  double delta = 0.0;
  std::vector<Id> concerned;
  std::vector<std::uint8_t> isConcerned(mesh.GetNumberOfFaces(), 0);
  const auto concern = [&](Id f) {
    isConcerned[f] = 1;
    concerned.push_back(f);
    mesh.FaceFlags[f] |= SurfaceMesh::MollifiedFlag;
  };
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      const double violation = this->TriangleInequalityViolation(f);
      if (violation > 0.0)
      {
        delta = std::max(delta, violation);
        mesh.FaceFlags[f] |= SurfaceMesh::DegenerateFlag;
        concern(f);
      }
    }
  }
  mesh.Mollification = std::max(mesh.Mollification, delta);
  if (mesh.Mollification == 0.0)
  {
    return; // no face is degenerate, not even in the parent mesh
  }
  // Lengthen the edges of these faces. A neighbor that becomes degenerate by a longer edge is
  // added.
  std::vector<std::uint8_t> lengthened(concerned.empty() ? 0 : mesh.Lengths.size(), 0);
  // NOLINTNEXTLINE(modernize-loop-convert): the list grows during the loop
  for (std::size_t i = 0; i < concerned.size(); ++i)
  {
    for (Id h = 3 * concerned[i]; h < 3 * concerned[i] + 3; ++h)
    {
      if (lengthened[h])
      {
        continue;
      }
      ForEachHalfEdge(mesh, h, [&](Id g) {
        lengthened[g] = 1;
        mesh.Lengths[g] += delta;
      });
      ForEachTwin(mesh, h, [&](Id g) {
        const Id f = SurfaceMesh::Face(g);
        if (!isConcerned[f] && this->TriangleInequalityViolation(f) > 0.0)
        {
          concern(f);
        }
      });
    }
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    mesh.NumberOfDegenerateFaces += mesh.IsDegenerate(f) ? 1 : 0;
    mesh.NumberOfMollifiedFaces += mesh.IsMollified(f) ? 1 : 0;
  }
}

void SurfaceMeshBuilder::Finish()
{
  this->LayOutFaces();
  this->OrderFans();
}

void SurfaceMeshBuilder::LayOutFaces()
{
  SurfaceMesh& mesh = this->Mesh;
  mesh.ApexXs.assign(mesh.Lengths.size(), 0.0);
  mesh.ApexYs.assign(mesh.Lengths.size(), 0.0);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (mesh.IsDropped(f))
    {
      continue;
    }
    const double* lengths = &mesh.Lengths[3 * f];
    const double area = TriangleArea(lengths[0], lengths[1], lengths[2]);
    for (int k = 0; k < 3; ++k)
    {
      mesh.ApexXs[3 * f + k] = FootOnEdge(lengths[k], lengths[(k + 2) % 3], lengths[(k + 1) % 3]);
      mesh.ApexYs[3 * f + k] = 2.0 * area / lengths[k];
    }
  }
}

void SurfaceMeshBuilder::OrderFans()
{
  SurfaceMesh& mesh = this->Mesh;
  const std::vector<Id>& outgoing = this->Outgoing.Members;
  mesh.FanOffsets = std::move(this->Outgoing.Begins);
  mesh.Fans.resize(outgoing.size());
  std::vector<std::uint8_t> placed; // per half-edge, only for vertices with several fans
  const bool isRegular = this->AreAllLinked && mesh.NumberOfMollifiedFaces == 0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Offset begin = mesh.FanOffsets[v];
    const Offset end = mesh.FanOffsets[v + 1];
    Offset out = begin;
    Id fans = 0;
    const auto walk = [&](Id start) {
      ++fans;
      Id h = start;
      do
      {
        mesh.Fans[out++] = h;
        const Id incoming = SurfaceMesh::Previous(h);
        h = this->IsLinked(incoming) ? mesh.Twin(incoming) : NoId;
      } while (h != NoId && h != start);
    };
    if (begin < end)
    {
      walk(outgoing[begin]);
    }
    if (out < end) // more than one fan, or an open one
    {
      out = begin;
      fans = 0;
      for (Offset i = begin; i < end; ++i)
      {
        if (!this->IsLinked(outgoing[i]))
        {
          walk(outgoing[i]); // clockwise-most: no face on its right side
        }
      }
    }
    if (out < end) // closed fans after others
    {
      placed.resize(mesh.Lengths.size(), 0);
      Offset marked = begin;
      for (Offset i = begin; out < end; ++i)
      {
        for (; marked < out; ++marked)
        {
          placed[mesh.Fans[marked]] = 1;
        }
        if (!placed[outgoing[i]])
        {
          walk(outgoing[i]);
        }
      }
    }
    if (fans > 1 || !(isRegular || this->IsRegular(v)))
    {
      mesh.VertexFlags[v] |= SurfaceMesh::IrregularFlag;
    }
  }
}

/// Returns true if all faces and edges around the vertex are regular.
bool SurfaceMeshBuilder::IsRegular(Id v) const
{
  const SurfaceMesh& mesh = this->Mesh;
  return std::all_of(mesh.FanBegin(v), mesh.FanEnd(v), [&](Id h) {
    const Id incoming = SurfaceMesh::Previous(h);
    return !mesh.IsMollified(SurfaceMesh::Face(h)) && (this->IsLinked(h) || mesh.Twin(h) == NoId) &&
      (this->IsLinked(incoming) || mesh.Twin(incoming) == NoId);
  });
}
}
