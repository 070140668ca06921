// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceSubdivision.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
/// Splits the faces of one surface once.
class Subdivider
{
public:
  Subdivider(const SurfaceMesh& mesh, const RefinedSurface& surface)
    : Mesh(mesh)
    , Old(surface)
    , MiddleOf(surface.Triangles.size(), NoId)
    , FirstPart(surface.Triangles.size(), NoId)
    , LastPart(surface.Triangles.size(), NoId)
  {
  }

  Status Run(const std::vector<std::uint8_t>& isMeant, Offset mostFaces, RefinedSurface& surface);

private:
  /// Part of a face: its corners, and for each side the old half-edge that it lies on, or NoId.
  struct Part
  {
    std::array<Id, 3> Corners;
    std::array<Id, 3> Sides;
  };

  Id From(Id h) const { return this->Old.Triangles[h]; }
  Id To(Id h) const { return this->Old.Triangles[SurfaceMesh::Next(h)]; }
  Id FindLongest(Id f) const;
  void HalveEdge(Id h);
  void ChooseEdges(const std::vector<std::uint8_t>& isMeant);
  void SplitFace(Id f);
  void AddParts(Id f, const std::vector<Part>& parts);
  double Measure(Id f, Id a, Id b) const;
  void GlueSides();
  void SplitPaths();

  const SurfaceMesh& Mesh;
  const RefinedSurface& Old;
  RefinedSurface New;
  std::vector<Id> MiddleOf; // per old half-edge
  std::vector<Id> Waiting;  // half-edges of edges that were halved
  // Per old half-edge, the new ones on it, at its origin and at its destination.
  std::vector<Id> FirstPart;
  std::vector<Id> LastPart;
};

Id Subdivider::FindLongest(Id f) const
{
  Id longest = 3 * f;
  for (Id h = 3 * f + 1; h < 3 * f + 3; ++h)
  {
    longest = this->Old.Lengths[h] > this->Old.Lengths[longest] ? h : longest;
  }
  return longest;
}

/// Put a vertex in the middle of an edge, for all faces around it.
void Subdivider::HalveEdge(Id h)
{
  if (this->MiddleOf[h] != NoId)
  {
    return;
  }
  const Id middle = this->New.GetNumberOfVertices();
  std::array<double, 3> b{ { 0.5, 0.5, 0.5 } };
  b[(h + 2) % 3] = 0.0;
  this->New.Points.push_back(this->Old.ToOldMesh(this->Mesh, SurfaceMesh::Face(h), b));
  Id e = h;
  do
  {
    this->MiddleOf[e] = middle;
    this->Waiting.push_back(e);
    e = this->Old.Twins[e];
  } while (e != NoId && e != h);
}

void Subdivider::ChooseEdges(const std::vector<std::uint8_t>& isMeant)
{
  for (Id f = 0; f < this->Old.GetNumberOfFaces(); ++f)
  {
    for (Id h = 3 * f; h < 3 * f + 3 && isMeant[f]; ++h)
    {
      this->HalveEdge(h);
    }
  }
  while (!this->Waiting.empty())
  {
    const Id h = this->Waiting.back();
    this->Waiting.pop_back();
    this->HalveEdge(this->FindLongest(SurfaceMesh::Face(h)));
  }
}

void Subdivider::SplitFace(Id f)
{
  const Id h0 = this->FindLongest(f);
  const Id h1 = SurfaceMesh::Next(h0);
  const Id h2 = SurfaceMesh::Next(h1);
  const Id v0 = this->From(h0);
  const Id v1 = this->From(h1);
  const Id v2 = this->From(h2);
  const Id m0 = this->MiddleOf[h0];
  const Id m1 = this->MiddleOf[h1];
  const Id m2 = this->MiddleOf[h2];
  std::vector<Part> parts;
  if (m0 == NoId)
  {
    // As it was, with its corners in their order.
    const Id h = 3 * f;
    parts.push_back(
      { { { this->From(h), this->From(h + 1), this->From(h + 2) } }, { { h, h + 1, h + 2 } } });
  }
  else
  {
    if (m2 == NoId)
    {
      parts.push_back({ { { v0, m0, v2 } }, { { h0, NoId, h2 } } });
    }
    else
    {
      parts.push_back({ { { v0, m0, m2 } }, { { h0, NoId, h2 } } });
      parts.push_back({ { { m0, v2, m2 } }, { { NoId, h2, NoId } } });
    }
    if (m1 == NoId)
    {
      parts.push_back({ { { m0, v1, v2 } }, { { h0, h1, NoId } } });
    }
    else
    {
      parts.push_back({ { { m0, v1, m1 } }, { { h0, h1, NoId } } });
      parts.push_back({ { { m0, m1, v2 } }, { { NoId, h1, NoId } } });
    }
  }
  this->AddParts(f, parts);
}

/// Distance of two vertices in the plane of an old face.
double Subdivider::Measure(Id f, Id a, Id b) const
{
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  FindInFace(this->Mesh, this->New.Points[a], this->Old.Faces[f], p);
  FindInFace(this->Mesh, this->New.Points[b], this->Old.Faces[f], q);
  return DistanceInFace(this->Mesh, this->Old.Faces[f], p, q);
}

/// Sides inside of the face are glued and measured here; for those on old edges it is noted which
/// they are.
void Subdivider::AddParts(Id f, const std::vector<Part>& parts)
{
  const auto begin = static_cast<Id>(this->New.Triangles.size());
  for (const Part& part : parts)
  {
    this->New.Faces.push_back(this->Old.Faces[f]);
    for (int k = 0; k < 3; ++k)
    {
      const auto h = static_cast<Id>(this->New.Triangles.size());
      const Id old = part.Sides[k];
      const Id from = part.Corners[k];
      const Id to = part.Corners[(k + 1) % 3];
      double length = 0.0;
      if (old != NoId)
      {
        this->FirstPart[old] = from == this->From(old) ? h : this->FirstPart[old];
        this->LastPart[old] = to == this->To(old) ? h : this->LastPart[old];
        length = (this->MiddleOf[old] == NoId ? 1.0 : 0.5) * this->Old.Lengths[old];
      }
      this->New.Triangles.push_back(from);
      this->New.Twins.push_back(NoId);
      this->New.Lengths.push_back(length);
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id a = parts[i].Corners[k];
      const Id b = parts[i].Corners[(k + 1) % 3];
      for (std::size_t j = i + 1; j < parts.size() && parts[i].Sides[k] == NoId; ++j)
      {
        for (int l = 0; l < 3; ++l)
        {
          if (parts[j].Corners[l] == b && parts[j].Corners[(l + 1) % 3] == a)
          {
            const Id h = begin + static_cast<Id>(3 * i) + k;
            const Id e = begin + static_cast<Id>(3 * j) + l;
            this->New.Twins[h] = e;
            this->New.Twins[e] = h;
            this->New.Lengths[h] = this->Measure(f, a, b);
            this->New.Lengths[e] = this->New.Lengths[h];
          }
        }
      }
    }
  }
}

/// Parts of edges are glued as the edges were.
void Subdivider::GlueSides()
{
  for (Id h = 0; h < static_cast<Id>(this->Old.Triangles.size()); ++h)
  {
    const Id t = this->Old.Twins[h];
    if (t != NoId)
    {
      const bool along = this->From(h) == this->From(t);
      this->New.Twins[this->FirstPart[h]] = along ? this->FirstPart[t] : this->LastPart[t];
      this->New.Twins[this->LastPart[h]] = along ? this->LastPart[t] : this->FirstPart[t];
    }
  }
}

void Subdivider::SplitPaths()
{
  const auto edgeOf = [](Id a, Id b) { return std::make_pair(std::min(a, b), std::max(a, b)); };
  std::map<std::pair<Id, Id>, Id> middles;
  for (const std::vector<Id>& path : this->Old.Paths)
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      middles[edgeOf(path[i], path[i + 1])] = NoId;
    }
  }
  for (Id h = 0; h < static_cast<Id>(this->Old.Triangles.size()) && !middles.empty(); ++h)
  {
    const auto edge = middles.find(edgeOf(this->From(h), this->To(h)));
    if (edge != middles.end())
    {
      edge->second = this->MiddleOf[h];
    }
  }
  for (std::size_t p = 0; p < this->Old.Paths.size(); ++p)
  {
    const std::vector<Id>& path = this->Old.Paths[p];
    const std::vector<double>& places = this->Old.Places[p];
    std::vector<Id> split;
    std::vector<double> splitPlaces;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      const Id middle = i == 0 ? NoId : middles[edgeOf(path[i - 1], path[i])];
      if (middle != NoId)
      {
        split.push_back(middle);
        splitPlaces.push_back(0.5 * (places[i - 1] + places[i]));
      }
      split.push_back(path[i]);
      splitPlaces.push_back(places[i]);
    }
    this->New.Paths.push_back(std::move(split));
    this->New.Places.push_back(std::move(splitPlaces));
  }
}

Status Subdivider::Run(
  const std::vector<std::uint8_t>& isMeant, Offset mostFaces, RefinedSurface& surface)
{
  this->New.Points = this->Old.Points;
  this->ChooseEdges(isMeant);
  Offset faces = this->Old.GetNumberOfFaces();
  for (const Id middle : this->MiddleOf)
  {
    faces += middle == NoId ? 0 : 1; // every halved side makes one face more
  }
  if (faces > mostFaces)
  {
    return Status::Invalid("there would be " + std::to_string(faces) + " faces, and at most " +
      std::to_string(mostFaces) + " are wanted");
  }
  for (Id f = 0; f < this->Old.GetNumberOfFaces(); ++f)
  {
    this->SplitFace(f);
  }
  this->GlueSides();
  this->SplitPaths();
  surface = std::move(this->New);
  return Status::Success();
}
}

Status SubdivideFaces(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& isMeant,
  Offset mostFaces, RefinedSurface& surface)
{
  if (isMeant.size() != surface.Faces.size())
  {
    return Status::Invalid("there are " + std::to_string(isMeant.size()) + " flags for " +
      std::to_string(surface.Faces.size()) + " faces: give one for each");
  }
  return Subdivider(mesh, surface).Run(isMeant, mostFaces, surface);
}

}
