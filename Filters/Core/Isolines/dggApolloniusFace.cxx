// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggApolloniusFace.h"

#include "dggFaceTriangulation.h"
#include "dggSurfacePoint.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Tolerance between a diagram node on a side and a node of the edge, relative to the edge length.
constexpr double RimTolerance = 1e-6;
/// Minimum distance of interior nodes from the sides, in barycentric coordinates.
constexpr double InnerDistance = 1e-7;
}

ApolloniusFace::ApolloniusFace(const DistanceField& field, int steinerPoints)
  : Field(field)
  , NumberOfSteinerPoints(steinerPoints)
  , Edge(field, steinerPoints)
  , Profile(field)
{
}

void ApolloniusFace::Enter(Id f)
{
  this->Face = f;
  this->Profile.Enter(f);
  this->Places = { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } };
  this->Values.clear();
  for (int k = 0; k < 3; ++k)
  {
    this->Values.push_back(this->Profile.GetCornerDistance(k));
  }
  this->AddRim();
  this->IsBuilt = false;
  const auto range = std::minmax_element(this->Values.begin(), this->Values.end());
  // Upper bound of the distance from any point to the boundary, and from a boundary point to a
  // node.
  double around = 0.0;
  double longest = 0.0;
  const SurfaceMesh& mesh = *this->Field.Mesh;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    around += mesh.Length(h);
    longest = std::max(longest, mesh.Length(h));
  }
  const double inradius = mesh.Length(3 * f) * mesh.ApexY(3 * f) / around;
  const double reach = inradius + longest / (this->NumberOfSteinerPoints + 1);
  this->Smallest = *range.first - reach;
  this->Largest = *range.second + reach;
}

/// Builds the triangles. They are only needed if a level crosses the face.
void ApolloniusFace::Build()
{
  this->IsBuilt = true;
  FaceTriangulation triangulation(this->Profile.GetCorners());
  for (std::size_t n = 3; n < this->Places.size(); ++n)
  {
    triangulation.AddPoint(GridPoint::FromBarycentric(this->Places[n]));
  }
  this->Diagram.Build(this->Profile.GetCorners(), this->Sites);
  this->AddDiagram(triangulation);
  triangulation.MakeDelaunay();
  this->Triangles = triangulation.GetTriangles();
  this->TriangleEdges.clear();
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->TriangleEdges.push_back(
        { this->Triangles[t][k], this->Triangles[t][(k + 1) % 3], static_cast<int>(t) });
    }
  }
  std::sort(this->TriangleEdges.begin(), this->TriangleEdges.end());
  std::sort(this->Rim.begin(), this->Rim.end(), [](const RimPiece& a, const RimPiece& b) {
    return a.Begin < b.Begin; // each node starts one segment
  });
}

/// Adds the nodes of the three edges, in order around the face.
void ApolloniusFace::AddRim()
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  this->Rim.clear();
  this->Sites.clear();
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * this->Face + k;
    this->Edge.Enter(h);
    const std::vector<RimNode>& nodes = this->Edge.GetNodes();
    const double length = this->Edge.GetLength();
    const bool isSame = mesh.Origin(this->Edge.GetHalfEdge()) == mesh.Origin(h);
    std::vector<std::pair<double, int>>& side = this->Sides[k];
    side.clear();
    this->Sites.push_back({ k, 0.0, this->Values[k] });
    int last = k;
    side.emplace_back(0.0, k);
    for (std::size_t i = 1; i < nodes.size(); ++i)
    {
      const std::size_t index = isSame ? i : nodes.size() - 1 - i;
      const RimNode& node = nodes[index];
      const double x = isSame ? node.X : length - node.X;
      int number = (k + 1) % 3;
      if (i + 1 < nodes.size())
      {
        number = static_cast<int>(this->Values.size());
        this->Places.push_back(CoordinatesOnEdge(k, x / length));
        this->Values.push_back(node.Value);
        if (node.IsSite)
        {
          this->Sites.push_back({ k, x, node.Value });
        }
      }
      side.emplace_back(x, number);
      this->Rim.push_back(
        { last, number, this->Edge.GetHalfEdge(), static_cast<Id>(isSame ? i - 1 : index) });
      last = number;
    }
  }
}

int ApolloniusFace::FindRimNode(int side, double x) const
{
  const double length = this->Field.Mesh->Length(3 * this->Face + side);
  int best = -1;
  double bestDistance = RimTolerance * length;
  for (const std::pair<double, int>& node : this->Sides[side])
  {
    if (std::abs(node.first - x) <= bestDistance)
    {
      best = node.second;
      bestDistance = std::abs(node.first - x);
    }
  }
  return best;
}

/// Adds the interior nodes of the diagram, and its edges. If an edge ends on the boundary at a tie
/// of two sites of different sides, the end has no node, because the adjacent face would not have
/// this node; such an edge is omitted.
void ApolloniusFace::AddDiagram(FaceTriangulation& triangulation)
{
  std::vector<int> numbers;
  for (const ApolloniusNode& node : this->Diagram.GetNodes())
  {
    int number = -1;
    if (node.Side >= 0)
    {
      number = this->FindRimNode(node.Side, node.X);
    }
    else
    {
      const std::array<double, 3> b = this->Profile.BarycentricOf(node.Place);
      const double value = this->Profile.At(node.Place); // not finite on overflow
      if (std::min(b[0], std::min(b[1], b[2])) > InnerDistance && std::isfinite(value))
      {
        number = static_cast<int>(this->Values.size());
        triangulation.AddPoint(GridPoint::FromBarycentric(b));
        this->Places.push_back(b);
        this->Values.push_back(value);
      }
    }
    numbers.push_back(number);
  }
  for (const std::pair<int, int>& edge : this->Diagram.GetEdges())
  {
    const int a = numbers[edge.first];
    const int b = numbers[edge.second];
    if (a >= 0 && b >= 0 && a != b)
    {
      triangulation.AddSegment(a, b); // may fail: arcs replaced by segments may cross
    }
  }
}

/// Returns the triangle on the left of a directed edge; -1 if no triangle is on the left.
int ApolloniusFace::TriangleOf(int begin, int end) const
{
  const TriangleEdge wanted{ begin, end, 0 };
  const auto found =
    std::lower_bound(this->TriangleEdges.begin(), this->TriangleEdges.end(), wanted);
  return found != this->TriangleEdges.end() && !(wanted < *found) ? found->Triangle : -1;
}

/// Returns the point between two nodes at which the distance attains a level.
std::array<double, 3> ApolloniusFace::PlaceBetween(int a, int b, double level) const
{
  const double below = 0.5 * this->Values[a]; // halved, because differences may overflow
  const double t = (0.5 * level - below) / (0.5 * this->Values[b] - below);
  std::array<double, 3> place{};
  for (int k = 0; k < 3; ++k)
  {
    place[k] = (1.0 - t) * this->Places[a][k] + t * this->Places[b][k];
  }
  return place;
}

/// Follows an isoline from a directed edge, which crosses the level upward, through triangles to
/// the boundary or back to its start. Adds the points on crossed edges. Returns the exit edge,
/// directed as in its triangle.
std::pair<int, int> ApolloniusFace::Follow(int begin, int end, double level, FaceCurve& curve)
{
  std::pair<int, int> exit{ end, begin };
  for (int t = this->TriangleOf(begin, end); t >= 0 && !this->IsDone[t];)
  {
    this->IsDone[t] = true;
    const std::array<int, 3>& corners = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      if (!this->IsBelow(corners[k], level) && this->IsBelow(corners[(k + 1) % 3], level))
      {
        exit = { corners[k], corners[(k + 1) % 3] };
      }
    }
    t = this->TriangleOf(exit.second, exit.first);
    if (t >= 0)
    {
      curve.Points.push_back(this->PlaceBetween(exit.second, exit.first, level));
    }
  }
  return exit;
}

void ApolloniusFace::FindCurves(
  double level, Id number, const CrossingFinder& crossings, std::vector<FaceCurve>& curves)
{
  if (!this->IsBuilt)
  {
    this->Build();
  }
  this->IsDone.assign(this->Triangles.size(), false);
  auto crossingOf = [&](int begin) {
    const auto piece = std::lower_bound(this->Rim.begin(), this->Rim.end(), begin,
      [](const RimPiece& p, int node) { return p.Begin < node; });
    return crossings(piece->HalfEdge, piece->Interval);
  };
  for (const RimPiece& piece : this->Rim)
  {
    if (this->IsBelow(piece.Begin, level) && !this->IsBelow(piece.End, level))
    {
      FaceCurve curve;
      curve.Face = this->Face;
      curve.Level = number;
      curve.First = crossingOf(piece.Begin);
      curve.Last = crossingOf(this->Follow(piece.Begin, piece.End, level, curve).first);
      curves.push_back(std::move(curve));
    }
  }
  // The remaining isolines are closed within the face.
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int k = 0; k < 3 && !this->IsDone[t]; ++k)
    {
      const int begin = this->Triangles[t][k];
      const int end = this->Triangles[t][(k + 1) % 3];
      if (this->IsBelow(begin, level) && !this->IsBelow(end, level))
      {
        FaceCurve curve;
        curve.Face = this->Face;
        curve.Level = number;
        this->Follow(begin, end, level, curve);
        curves.push_back(std::move(curve));
      }
    }
  }
}
}
