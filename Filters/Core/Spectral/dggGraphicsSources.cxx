// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsSources.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
std::pair<Id, Id> Unordered(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Half-edges of faces of a set that have another face on the other side.
std::vector<Id> FindRim(const RefinedSurface& surface, const std::vector<Id>& faces)
{
  std::vector<char> isInside(surface.Faces.size(), 0);
  for (const Id f : faces)
  {
    isInside[f] = 1;
  }
  std::vector<Id> rim;
  for (const Id f : faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      bool isRim = false;
      for (Id e = surface.Twins[h]; e != NoId && e != h; e = surface.Twins[e])
      {
        isRim = isRim || !isInside[SurfaceMesh::Face(e)];
      }
      if (isRim)
      {
        rim.push_back(h);
      }
    }
  }
  return rim;
}
}

Status FindFacesOnLeft(
  const RefinedSurface& surface, const CurveChain& chain, bool isClosed, std::vector<Id>& faces)
{
  faces.clear();
  if (!isClosed)
  {
    return Status::Invalid("it is open, but a region needs a closed one: close it");
  }
  RefinedSurface uncut = surface;
  uncut.Paths = { chain.Vertices };
  uncut.Places.clear();
  CurveCut cut;
  Status status = CutAlongCurves(uncut, cut);
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<char> isFound(surface.Faces.size(), 0);
  std::vector<Id> waiting;
  const auto find = [&](Id f) {
    if (f != NoId && !isFound[f])
    {
      isFound[f] = 1;
      faces.push_back(f);
      waiting.push_back(f);
    }
  };
  for (const EdgeSide& edge : cut.Sides[0].Left)
  {
    find(edge.Face);
  }
  while (!waiting.empty())
  {
    const Id f = waiting.back();
    waiting.pop_back();
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      for (Id e = cut.Surface.Twins[h]; e != NoId && e != h; e = cut.Surface.Twins[e])
      {
        find(SurfaceMesh::Face(e));
      }
    }
  }
  for (const EdgeSide& edge : cut.Sides[0].Right)
  {
    if (edge.Face != NoId && isFound[edge.Face])
    {
      return Status::Invalid("it does not separate its left from its right, so that there is no "
                             "region on its left: close it around one, without crossing itself");
    }
  }
  return status;
}

void AddRegion(const SurfaceMesh& mesh, const CutSurface& surface, const std::vector<Id>& faces,
  const std::vector<double>& strength, std::vector<std::vector<double>>& loads)
{
  const auto areaOf = [&](Id f) { return 0.5 * mesh.Length(3 * f) * mesh.ApexY(3 * f); };
  double area = 0.0;
  for (const Id f : faces)
  {
    area += areaOf(f);
  }
  const std::vector<Id> rim = FindRim(surface, faces);
  double length = 0.0;
  for (const Id h : rim)
  {
    length += surface.Lengths[h];
  }
  for (std::size_t c = 0; c < loads.size() && area > 0.0; ++c)
  {
    const double density = 4.0 * Pi * strength[c] / area;
    for (const Id f : faces)
    {
      for (int k = 0; k < 3; ++k)
      {
        loads[c][surface.Triangles[3 * f + k]] += density * areaOf(f) / 3.0;
      }
    }
    for (const Id h : rim)
    {
      const double half = 0.5 * density * area * surface.Lengths[h] / length;
      loads[c][surface.Triangles[h]] -= half;
      loads[c][surface.Triangles[SurfaceMesh::Next(h)]] -= half;
    }
  }
}

std::vector<double> MeasureChain(const RefinedSurface& surface, const CurveChain& chain)
{
  std::map<std::pair<Id, Id>, double> lengths;
  for (std::size_t i = 0; i + 1 < chain.Vertices.size(); ++i)
  {
    lengths[Unordered(chain.Vertices[i], chain.Vertices[i + 1])] = 0.0;
  }
  for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
  {
    const auto edge = lengths.find(
      Unordered(surface.Triangles[h], surface.Triangles[SurfaceMesh::Next(static_cast<Id>(h))]));
    if (edge != lengths.end())
    {
      edge->second = surface.Lengths[h];
    }
  }
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < chain.Vertices.size(); ++i)
  {
    result.push_back(lengths[Unordered(chain.Vertices[i], chain.Vertices[i + 1])]);
  }
  return result;
}

void AddLineSource(const CurveChain& chain, const std::vector<double>& lengths,
  const GraphicsCurve& curve, std::vector<std::vector<double>>& loads)
{
  const auto channels = static_cast<int>(loads.size());
  std::vector<double> begin(loads.size());
  std::vector<double> end(loads.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    InterpolateOnCurve(curve.Left, channels, curve.IsClosed, chain.Parameters[i], begin.data());
    InterpolateOnCurve(curve.Left, channels, curve.IsClosed, chain.Parameters[i + 1], end.data());
    for (std::size_t c = 0; c < loads.size(); ++c)
    {
      loads[c][chain.Vertices[i]] += lengths[i] / 6.0 * (2.0 * begin[c] + end[c]);
      loads[c][chain.Vertices[i + 1]] += lengths[i] / 6.0 * (begin[c] + 2.0 * end[c]);
    }
  }
}
}
