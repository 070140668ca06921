// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergingEngine.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Largest gap between windows that are adjacent, relative to the length of the edge.
constexpr double Touching = 1e-9;
/// Number of parts of an interval in which the difference of two windows is bounded.
constexpr int Parts = 8;

/// Returns the derivative of the distance along the axis.
double Slope(const dgg::Window& w, double x)
{
  return (x - w.Image.X) / dgg::DistanceToAxis(w.Image, x);
}

/// Returns an upper bound for the difference of two windows on the interval of the second one.
/// Slopes increase along the axis, so those at both ends of a part bound the slope of the
/// difference in between.
double LargestDifference(const dgg::Window& merged, const dgg::Window& part)
{
  double largest = 0.0;
  double before = part.Begin;
  for (int k = 0; k <= Parts; ++k)
  {
    const double x = part.Begin + k * (part.End - part.Begin) / Parts;
    const double slope = std::max(std::abs(Slope(merged, x) - Slope(part, before)),
      std::abs(Slope(merged, before) - Slope(part, x)));
    largest = std::max(largest,
      0.5 *
        (std::abs(merged.DistanceAt(before) - part.DistanceAt(before)) +
          std::abs(merged.DistanceAt(x) - part.DistanceAt(x)) + slope * (x - before)));
    before = x;
  }
  return largest;
}
}

void MergingEngine::Reset()
{
  TriangleEngine::Reset();
  this->EdgeErrors.assign(static_cast<std::size_t>(this->Mesh.GetNumberOfHalfEdges()), 0.0);
  this->VertexErrors.assign(static_cast<std::size_t>(this->Mesh.GetNumberOfVertices()), 0.0);
  this->NumberOfMerged = 0;
}

/// Adds the errors of a pseudo-source and its neighbors, because the shortest path to the
/// pseudo-source may follow an edge that has not lowered its label.
void MergingEngine::Receive(dgg::Id h, const dgg::Window& window)
{
  if (window.Root >= 0)
  {
    double& error = this->EdgeErrors[h];
    error = std::max(error, this->VertexErrors[window.Root]);
    for (const dgg::Id* g = this->Mesh.FanBegin(window.Root); g != this->Mesh.FanEnd(window.Root);
         ++g)
    {
      // Both neighbors, because the last one at a boundary has no half-edge that leaves the
      // pseudo-source.
      error = std::max({ error, this->VertexErrors[this->Mesh.Destination(*g)],
        this->VertexErrors[this->Mesh.Origin(dgg::SurfaceMesh::Previous(*g))] });
    }
  }
  TriangleEngine::Receive(h, window);
}

void MergingEngine::LabelDropped(dgg::Id v)
{
  const dgg::Predecessor& p = this->Result->Predecessors[v];
  if (p.HalfEdge == dgg::NoId && p.Root >= 0)
  {
    this->VertexErrors[v] = std::max(this->VertexErrors[v], this->VertexErrors[p.Root]);
  }
  TriangleEngine::LabelDropped(v);
}

void MergingEngine::Simplify(dgg::Id h, dgg::WindowList& list)
{
  const double before = this->EdgeErrors[h];
  double added = 0.0; // error added to the last window
  double most = 0.0;
  std::size_t size = 0;
  for (const dgg::Window& w : list)
  {
    dgg::Window merged;
    if (size > 0 && this->Merge(list[size - 1], w, this->Mesh.Length(h), merged))
    {
      const double error =
        std::max(LargestDifference(merged, list[size - 1]), LargestDifference(merged, w));
      if (before + added + error <= this->Tolerance * merged.MinimumDistance())
      {
        added += error;
        most = std::max(most, added);
        list[size - 1] = merged;
        continue;
      }
    }
    list[size++] = w;
    added = 0.0;
  }
  this->NumberOfMerged += list.size() - size;
  list.resize(size);
  // Windows that propagate from here have the same error.
  const double error = before + most;
  this->EdgeErrors[h] = error;
  double& atApex = this->VertexErrors[this->Mesh.Apex(h)];
  atApex = std::max(atApex, error);
  for (const dgg::Id exit : { dgg::SurfaceMesh::Previous(h), dgg::SurfaceMesh::Next(h) })
  {
    for (dgg::Id e = this->Mesh.Twin(exit); e != dgg::NoId && e != exit; e = this->Mesh.Twin(e))
    {
      this->EdgeErrors[e] = std::max(this->EdgeErrors[e], error);
    }
  }
}

/// Merges two windows. Of all images that reproduce the distances at both ends, uses the farthest
/// one whose rays at the ends cover the region that the two windows see. The rays diverge at least
/// as the slopes at the ends do; a closer image has more divergent rays. Returns false if there is
/// no such image.
bool MergingEngine::Merge(
  const dgg::Window& first, const dgg::Window& second, double length, dgg::Window& merged) const
{
  const double width = second.End - first.Begin;
  const double rise = second.DistanceAtEnd - first.DistanceAtBegin;
  const double product = (width - rise) * (width + rise);
  if (second.Begin - first.End > Touching * length || !(product > 0.0))
  {
    return false;
  }
  // Distance of the image from the beginning, by the law of cosines with the slopes at the
  // beginning and at the end.
  double reach = first.DistanceAtBegin - std::min(first.Sigma, second.Sigma);
  const double bendAtBegin = rise - Slope(first, first.Begin) * width;
  const double bendAtEnd = Slope(second, second.End) * width - rise;
  if (bendAtBegin > 0.0)
  {
    reach = std::min(reach, 0.5 * product / bendAtBegin);
  }
  if (bendAtEnd > 0.0)
  {
    reach = std::min(reach, 0.5 * product / bendAtEnd - rise);
  }
  if (!(reach > 0.0 && reach + rise > 0.0 && reach + (reach + rise) > width))
  {
    return false;
  }
  const dgg::Point2 image = dgg::LayOut(width, reach, reach + rise);
  merged = first;
  merged.Image = { first.Begin + image.X, -image.Y };
  merged.Sigma = first.DistanceAtBegin - reach;
  merged.SetInterval(first.Begin, second.End);
  // The image is not at a vertex, so no label can make the window stale.
  merged.Root = ~this->SourceOf(first.Root);
  merged.HasScattered = first.HasScattered || second.HasScattered;
  return merged.FacesEdge(length);
}
