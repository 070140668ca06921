// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEdgeSplitting.h"

#include "dggEdges.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
/// Minimum distance of midpoints from sides: twice the snapping distance of points.
constexpr double SmallestCoordinate = 2e-9;

class EdgeSplitter
{
public:
  EdgeSplitter(const SurfaceMesh& oldMesh, const std::vector<char>& isSplit, SubMesh& surface)
    : OldMesh(oldMesh)
    , Old(surface)
    , New(surface)
    , Middles(surface.Triangles.size(), NoId)
  {
    this->New.Triangles.clear();
    this->New.Lengths.clear();
    this->New.Faces.clear();
    for (std::size_t h = 0; h < isSplit.size(); ++h)
    {
      if (isSplit[h])
      {
        this->AddMiddle(static_cast<Id>(h));
      }
    }
    this->Reserve();
  }

  void Run(SubMesh& surface, std::vector<Id>* parents)
  {
    for (Id f = 0; f < this->Old.GetNumberOfFaces(); ++f)
    {
      this->SplitFace(f);
    }
    this->New.Glue(this->OldPlaces);
    this->SplitPaths();
    surface = std::move(this->New);
    if (parents)
    {
      *parents = std::move(this->Parents);
    }
  }

private:
  /// A corner of a face or, from 3 on, the midpoint of side (node - 3).
  using Node = int;

  void AddMiddle(Id h)
  {
    if (this->Middles[h] != NoId)
    {
      return;
    }
    const auto middle = static_cast<Id>(this->New.Points.size());
    this->New.Points.push_back(
      this->Old.ToParent(this->OldMesh, SurfaceMesh::Face(h), CoordinatesOnEdge(h, 0.5)));
    this->Middles[h] = middle;
    for (Id e = this->Old.Twins[h]; e != NoId && e != h; e = this->Old.Twins[e])
    {
      this->Middles[e] = middle;
    }
  }

  /// Reserves the arrays: each split side adds one part. Growing arrays would take up to three
  /// times as much memory.
  void Reserve()
  {
    const auto whole = std::count(this->Middles.begin(), this->Middles.end(), NoId);
    const std::size_t faces =
      this->Old.Faces.size() + this->Middles.size() - static_cast<std::size_t>(whole);
    this->New.Triangles.reserve(3 * faces);
    this->New.Lengths.reserve(3 * faces);
    this->New.Faces.reserve(faces);
    this->OldPlaces.reserve(3 * faces);
    this->Parents.reserve(faces);
  }

  void SplitFace(Id f)
  {
    std::array<int, 3> split{}; // sides, in order
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (this->Middles[3 * f + k] != NoId)
      {
        split[count++] = k;
      }
    }
    if (count == 0)
    {
      this->AddTriangle(f, { { 0, 1, 2 } });
      return;
    }
    this->LayOutFace(f);
    if (count == 1)
    {
      const int k = split[0];
      this->AddTriangle(f, { { k, 3 + k, (k + 2) % 3 } });
      this->AddTriangle(f, { { 3 + k, (k + 1) % 3, (k + 2) % 3 } });
    }
    else if (count == 2)
    {
      const int k = 3 - split[0] - split[1]; // the third side
      const Node a = k;
      const Node b = (k + 1) % 3;
      const Node beyondB = 3 + b;
      const Node beforeA = 3 + (k + 2) % 3;
      this->AddTriangle(f, { { beyondB, (k + 2) % 3, beforeA } });
      if (this->Measure(a, beyondB) <= this->Measure(b, beforeA))
      {
        this->AddTriangle(f, { { a, b, beyondB } });
        this->AddTriangle(f, { { a, beyondB, beforeA } });
      }
      else
      {
        this->AddTriangle(f, { { a, b, beforeA } });
        this->AddTriangle(f, { { b, beyondB, beforeA } });
      }
    }
    else
    {
      this->AddTriangle(f, { { 0, 3, 5 } });
      this->AddTriangle(f, { { 3, 1, 4 } });
      this->AddTriangle(f, { { 5, 4, 2 } });
      this->AddTriangle(f, { { 3, 4, 5 } });
    }
  }

  void LayOutFace(Id f)
  {
    const double* lengths = this->Old.Lengths.data() + 3 * static_cast<std::size_t>(f);
    this->Places[0] = { 0.0, 0.0 };
    this->Places[1] = { lengths[0], 0.0 };
    this->Places[2] = LayOut(lengths[0], lengths[2], lengths[1]);
    for (int k = 0; k < 3; ++k)
    {
      const Point2& a = this->Places[k];
      const Point2& b = this->Places[(k + 1) % 3];
      this->Places[3 + k] = { 0.5 * (a.X + b.X), 0.5 * (a.Y + b.Y) };
    }
  }

  double Measure(Node a, Node b) const { return Distance(this->Places[a], this->Places[b]); }

  /// Returns the side that contains two nodes; -1 if there is none.
  static int SideOf(Node a, Node b)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto isOn = [k](Node n) { return n == k || n == (k + 1) % 3 || n == 3 + k; };
      if (isOn(a) && isOn(b))
      {
        return k;
      }
    }
    return -1;
  }

  void AddTriangle(Id f, const std::array<Node, 3>& nodes)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Node a = nodes[k];
      const Node b = nodes[(k + 1) % 3];
      const int side = SideOf(a, b);
      Offset where = static_cast<Offset>(this->Old.Triangles.size()) + f;
      double length = 0.0;
      if (side >= 0)
      {
        // Bitwise identical in all faces of the edge.
        where = FindEdge(this->Old, 3 * f + side);
        length = (a < 3 && b < 3 ? 1.0 : 0.5) * this->Old.Lengths[3 * f + side];
      }
      else
      {
        length = this->Measure(a, b);
      }
      this->OldPlaces.push_back(where);
      this->New.Triangles.push_back(
        a < 3 ? this->Old.Triangles[3 * f + a] : this->Middles[3 * f + a - 3]);
      this->New.Lengths.push_back(length);
    }
    this->New.Faces.push_back(this->Old.Faces[f]);
    this->Parents.push_back(f);
  }

  void SplitPaths()
  {
    std::map<std::pair<Id, Id>, Id> middles;
    for (std::size_t h = 0; h < this->Middles.size(); ++h)
    {
      if (this->Middles[h] != NoId)
      {
        const auto edge = static_cast<Id>(h);
        middles.emplace(
          std::minmax(this->Old.Origin(edge), this->Old.Destination(edge)), this->Middles[h]);
      }
    }
    for (std::size_t p = 0; p < this->New.Paths.size(); ++p)
    {
      std::vector<Id>& chain = this->New.Paths[p];
      std::vector<double>& places = this->New.Places[p];
      std::vector<Id> longer;
      std::vector<double> longerPlaces;
      for (std::size_t i = 0; i < chain.size(); ++i)
      {
        if (i > 0)
        {
          const auto middle = middles.find(std::minmax(chain[i - 1], chain[i]));
          if (middle != middles.end())
          {
            longer.push_back(middle->second);
            // The segment may start after the first position, if previous segments have no length.
            const double start = std::max(places[i - 1], std::ceil(places[i]) - 1.0);
            longerPlaces.push_back(0.5 * (start + places[i]));
          }
        }
        longer.push_back(chain[i]);
        longerPlaces.push_back(places[i]);
      }
      chain.swap(longer);
      places.swap(longerPlaces);
    }
  }

  const SurfaceMesh& OldMesh;
  const SubMesh Old; // a copy: the surface itself is replaced
  SubMesh New;
  std::vector<Id> Middles;        // per half-edge
  std::vector<Id> Parents;        // per new face
  std::vector<Offset> OldPlaces;  // per new half-edge, the old edge or face that contains it
  std::array<Point2, 6> Places{}; // positions of the nodes of the current face
};
}

bool HasMiddle(const SurfaceMesh& oldMesh, const SubMesh& surface, Id halfEdge)
{
  const Id face = surface.Faces[SurfaceMesh::Face(halfEdge)];
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  FindInFace(oldMesh, surface.Points[surface.Triangles[halfEdge]], face, p);
  FindInFace(oldMesh, surface.Points[surface.Triangles[SurfaceMesh::Next(halfEdge)]], face, q);
  bool isClear = true;
  for (int k = 0; k < 3; ++k)
  {
    const double sum = p[k] + q[k];
    isClear = isClear && (sum == 0.0 || sum >= 2.0 * SmallestCoordinate);
  }
  return isClear;
}

void SplitEdges(const SurfaceMesh& oldMesh, const std::vector<char>& isSplit, SubMesh& surface,
  std::vector<Id>* parents)
{
  EdgeSplitter(oldMesh, isSplit, surface).Run(surface, parents);
}
}
