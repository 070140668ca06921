// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIntrinsicTriangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dgg
{
namespace
{
/// Minimum slack of the triangle inequality of a flipped face, relative to its longest edge.
constexpr double SmallestSlack = 1e-14;

bool HasArea(double a, double b, double c)
{
  const double longest = std::max({ a, b, c });
  const double shortest = std::min({ a, b, c });
  const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  return shortest - (longest - middle) > SmallestSlack * longest;
}

constexpr Offset FlipsPerEdge = 100;
/// Steps between two progress reports.
constexpr Offset StepsPerReport = Offset(1) << 16;

/// Returns true if the edge violates the Delaunay condition by more than rounding: cotangents of
/// slivers are large.
bool WantsFlip(const IntrinsicTriangulation& triangulation, Id h)
{
  const double here = triangulation.Cotangent(SurfaceMesh::Previous(h));
  const double there = triangulation.Cotangent(SurfaceMesh::Previous(triangulation.Twin(h)));
  return here + there < -1e-12 - 1e-14 * (std::abs(here) + std::abs(there));
}
}

IntrinsicTriangulation::IntrinsicTriangulation(const SurfaceMesh& mesh)
  : NumberOfVertices(mesh.GetNumberOfVertices())
{
  std::vector<Id> newFaces(mesh.GetNumberOfFaces(), NoId);
  Id count = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    newFaces[f] = mesh.IsDropped(f) ? NoId : count++;
  }
  const auto size = 3 * static_cast<std::size_t>(count);
  this->Origins.reserve(size);
  this->Twins.reserve(size);
  this->Lengths.reserve(size);
  this->RunsAlong.reserve(size);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      continue;
    }
    const Id t = mesh.Twin(h);
    const bool isLoop = mesh.Origin(h) == mesh.Destination(h);
    this->Origins.push_back(mesh.Origin(h));
    this->Twins.push_back(t == NoId ? NoId : 3 * newFaces[SurfaceMesh::Face(t)] + t % 3);
    this->Lengths.push_back(mesh.Length(h));
    this->RunsAlong.push_back(t != NoId && !isLoop && mesh.Origin(t) == mesh.Origin(h) ? 1 : 0);
  }
}

Id IntrinsicTriangulation::FirstOfEdge(Id h) const
{
  Id first = h;
  for (Id g = this->Twins[h]; g != NoId && g != h; g = this->Twins[g])
  {
    first = std::min(first, g);
  }
  return first;
}

Point2 IntrinsicTriangulation::Apex(Id face) const
{
  const Id h = 3 * face;
  return LayOut(this->Lengths[h], this->Lengths[h + 2], this->Lengths[h + 1]);
}

double IntrinsicTriangulation::Cotangent(Id h) const
{
  const Point2 apex = LayOut(
    this->Lengths[h], this->Lengths[SurfaceMesh::Previous(h)], this->Lengths[SurfaceMesh::Next(h)]);
  return apex.X / apex.Y;
}

double IntrinsicTriangulation::Area(Id face) const
{
  return TriangleArea(
    this->Lengths[3 * face], this->Lengths[3 * face + 1], this->Lengths[3 * face + 2]);
}

bool IntrinsicTriangulation::IsPair(Id h) const
{
  const Id t = this->Twins[h];
  return t != NoId && this->Twins[t] == h;
}

bool IntrinsicTriangulation::IsFlippable(Id h) const
{
  return this->IsPair(h) && SurfaceMesh::Face(this->Twins[h]) != SurfaceMesh::Face(h);
}

Id IntrinsicTriangulation::FindPredecessor(Id h) const
{
  if (this->Twins[h] == NoId)
  {
    return NoId;
  }
  Id g = h;
  while (this->Twins[g] != h)
  {
    g = this->Twins[g];
  }
  return g;
}

void IntrinsicTriangulation::TurnOver(Id face)
{
  const Id a = 3 * face;
  const Id c = a + 2;
  for (Id h = a; h <= c; ++h)
  {
    const Id t = this->Twins[h];
    if (this->IsPair(h) && SurfaceMesh::Face(t) != face)
    {
      this->RunsAlong[h] ^= 1;
      this->RunsAlong[t] ^= 1;
    }
  }
  // The edges between corners 0 and 1 and between corners 2 and 0 swap their half-edges.
  const auto renamed = [&](Id h) { return h == a ? c : (h == c ? a : h); };
  const Id beforeA = this->FindPredecessor(a);
  const Id beforeC = this->FindPredecessor(c);
  const Id afterA = this->Twins[a];
  const Id afterC = this->Twins[c];
  this->Twins[c] = renamed(afterA);
  this->Twins[a] = renamed(afterC);
  if (beforeA != NoId)
  {
    this->Twins[renamed(beforeA)] = c;
  }
  if (beforeC != NoId)
  {
    this->Twins[renamed(beforeC)] = a;
  }
  std::swap(this->Origins[a + 1], this->Origins[c]);
  std::swap(this->Lengths[a], this->Lengths[c]);
  std::swap(this->RunsAlong[a], this->RunsAlong[c]);
}

bool IntrinsicTriangulation::Flip(Id h)
{
  if (!this->IsFlippable(h))
  {
    return false;
  }
  // The faces i j k, of h, and j i l, of its twin, become i l k and j k l.
  const Id pair = this->Twins[h];
  const bool along = this->RunsAlong[h] != 0;
  const Id toL = along ? SurfaceMesh::Previous(pair) : SurfaceMesh::Next(pair);
  const Id fromL = along ? SurfaceMesh::Next(pair) : SurfaceMesh::Previous(pair);
  const Id toK = SurfaceMesh::Next(h);
  const Id fromK = SurfaceMesh::Previous(h);
  const Point2 k = LayOut(this->Lengths[h], this->Lengths[fromK], this->Lengths[toK]);
  const Point2 l = LayOut(this->Lengths[h], this->Lengths[toL], this->Lengths[fromL]);
  const double length = Norm(k.X - l.X, k.Y + l.Y);
  if (!HasArea(this->Lengths[toL], length, this->Lengths[fromK]) ||
    !HasArea(this->Lengths[toK], length, this->Lengths[fromL]))
  {
    return false;
  }
  if (along)
  {
    this->TurnOver(SurfaceMesh::Face(pair));
  }
  const Id t = this->Twins[h];
  const Id hNext = SurfaceMesh::Next(h);
  const Id tNext = SurfaceMesh::Next(t);
  // The edge j k moves from hNext to t, the edge i l from tNext to h; the other two stay.
  const auto renamed = [&](Id x) { return x == hNext ? t : (x == tNext ? h : x); };
  const Id beforeH = this->FindPredecessor(hNext);
  const Id beforeT = this->FindPredecessor(tNext);
  const Id afterH = this->Twins[hNext];
  const Id afterT = this->Twins[tNext];
  const std::uint8_t alongH = this->RunsAlong[hNext];
  const std::uint8_t alongT = this->RunsAlong[tNext];
  this->Twins[t] = renamed(afterH);
  this->Twins[h] = renamed(afterT);
  if (beforeH != NoId)
  {
    this->Twins[renamed(beforeH)] = t;
  }
  if (beforeT != NoId)
  {
    this->Twins[renamed(beforeT)] = h;
  }
  this->Twins[hNext] = tNext;
  this->Twins[tNext] = hNext;
  this->RunsAlong[t] = alongH;
  this->RunsAlong[h] = alongT;
  this->RunsAlong[hNext] = 0;
  this->RunsAlong[tNext] = 0;
  this->Lengths[t] = this->Lengths[hNext];
  this->Lengths[h] = this->Lengths[tNext];
  this->Lengths[hNext] = length;
  this->Lengths[tNext] = length;
  this->Origins[hNext] = this->Origins[SurfaceMesh::Previous(t)];
  this->Origins[tNext] = this->Origins[SurfaceMesh::Previous(h)];
  return true;
}

Status MakeDelaunay(
  IntrinsicTriangulation& triangulation, const ProgressCallback& progress, Offset& flips)
{
  flips = 0;
  const Id size = triangulation.GetNumberOfHalfEdges();
  const Offset bound = FlipsPerEdge * (size / 2 + 1);
  // Half-edges represent their edges. A flip renames some neighboring half-edges, so that all four
  // sides of the two faces are checked again.
  std::vector<Id> stack;
  std::vector<std::uint8_t> isWaiting(size, 0);
  const auto push = [&](Id h) {
    if (!isWaiting[h])
    {
      isWaiting[h] = 1;
      stack.push_back(h);
    }
  };
  for (Id h = size - 1; h >= 0; --h)
  {
    if (triangulation.IsFlippable(h) && h < triangulation.Twin(h))
    {
      push(h);
    }
  }
  const auto total = static_cast<double>(stack.size() + 1);
  double reached = 0.0;
  Offset steps = 0;
  while (!stack.empty())
  {
    if (progress && steps++ % StepsPerReport == 0)
    {
      reached = std::max(reached, 1.0 - static_cast<double>(stack.size()) / total);
      if (!progress(reached))
      {
        return Status::Abort();
      }
    }
    const Id h = stack.back();
    stack.pop_back();
    isWaiting[h] = 0;
    if (!triangulation.IsFlippable(h) || !WantsFlip(triangulation, h))
    {
      continue;
    }
    if (flips >= bound)
    {
      break;
    }
    if (!triangulation.Flip(h))
    {
      continue;
    }
    ++flips;
    // The new edge follows h.
    const Id diagonal = SurfaceMesh::Next(h);
    const Id other = triangulation.Twin(diagonal);
    push(SurfaceMesh::Next(diagonal));
    push(SurfaceMesh::Previous(diagonal));
    push(SurfaceMesh::Next(other));
    push(SurfaceMesh::Previous(other));
  }
  return Status::Success();
}
}
