// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEdgeCuts.h"

#include "dggBorderRefinement.h"
#include "dggEdges.h"
#include "dggProgressPart.h"
#include "dggVoronoi.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Half-edges between two progress reports: some milliseconds, more with refinement.
constexpr Id ProgressInterval = 8192;

/// A site along an edge: squared distances at both ends, minus the term in between that is common
/// to all sites.
struct Line
{
  Id Site;
  double Start;
  double End;
};

double Square(double x)
{
  return x * x;
}

/// Returns the sites that are known at both ends, and the nearest sites of both ends.
std::vector<Line> LinesOf(const SiteDistances& distances, Id origin, Id destination, double length)
{
  std::vector<Line> lines;
  for (const SiteDistances::Entry* a = distances.Begin(origin); a != distances.End(origin); ++a)
  {
    if (const SiteDistances::Entry* b = distances.Find(destination, a->Site))
    {
      lines.push_back({ a->Site, Square(a->Distance), Square(b->Distance) });
    }
  }
  // Because of rounding and shortcuts of the search, the nearest site of one end may be unknown at
  // the other end; its distance there is at most that along the edge.
  const SiteDistances::Entry& first = *distances.Nearest(origin);
  const SiteDistances::Entry& last = *distances.Nearest(destination);
  if (!distances.Find(destination, first.Site))
  {
    lines.push_back({ first.Site, Square(first.Distance), Square(first.Distance + length) });
  }
  if (!distances.Find(origin, last.Site))
  {
    lines.push_back({ last.Site, Square(last.Distance + length), Square(last.Distance) });
  }
  return lines;
}

double DistanceOn(const Line& line, double t, double length)
{
  return std::sqrt(
    std::max(0.0, (1.0 - t) * line.Start + t * line.End - t * (1.0 - t) * length * length));
}
}

Status EdgeCuts::Run(const SiteDistances& distances, const BorderRefinement* refinement,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  const Id size = this->Mesh.GetNumberOfHalfEdges();
  for (Id h = 0; h < size; ++h)
  {
    if (h % ProgressInterval == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(h) / size));
    }
    this->Offsets.push_back(static_cast<Offset>(this->Cuts.size()));
    if (this->Mesh.IsDropped(SurfaceMesh::Face(h)) || FindEdge(this->Mesh, h) != h ||
      !this->IsNeeded(h))
    {
      continue;
    }
    this->Cut(h, distances, diagram);
    if (refinement)
    {
      this->Refine(h, *refinement, diagram);
    }
  }
  this->Offsets.push_back(static_cast<Offset>(this->Cuts.size()));
  return Status::Success();
}

/// Returns true if a face of the edge is in the piece or in the first layer around the piece.
bool EdgeCuts::IsNeeded(Id halfEdge) const
{
  bool isNeeded = !this->Layers || this->Layers[SurfaceMesh::Face(halfEdge)] <= 1;
  ForEachFaceBehind(this->Mesh, halfEdge, false,
    [&](Id behind, bool) { isNeeded = isNeeded || this->Layers[SurfaceMesh::Face(behind)] <= 1; });
  return isNeeded;
}

/// Refines the cuts of the most recent edge, each between its neighbors.
void EdgeCuts::Refine(Id halfEdge, const BorderRefinement& refinement, VoronoiDiagram& diagram)
{
  const auto n = static_cast<Id>(diagram.Distances.size());
  const auto begin = static_cast<std::size_t>(this->Offsets[halfEdge]);
  for (std::size_t i = begin; i < this->Cuts.size(); ++i)
  {
    EdgeCut& cut = this->Cuts[i];
    const bool isShared = (i > begin && this->Cuts[i - 1].Point == cut.Point) ||
      (i + 1 < this->Cuts.size() && this->Cuts[i + 1].Point == cut.Point);
    if (cut.Point < n || isShared)
    {
      continue;
    }
    const double low = i > begin ? this->Cuts[i - 1].Parameter : 0.0;
    const double high = i + 1 < this->Cuts.size() ? this->Cuts[i + 1].Parameter : 1.0;
    refinement.Balance(halfEdge, { { cut.Before, cut.After } }, low, high, cut.Parameter,
      diagram.BorderDistances[cut.Point - n]);
    diagram.BorderPoints[cut.Point - n] = SurfacePoint::OnEdge(this->Mesh, halfEdge, cut.Parameter);
  }
}

void EdgeCuts::Cut(Id halfEdge, const SiteDistances& distances, VoronoiDiagram& diagram)
{
  const Id origin = this->Mesh.Origin(halfEdge);
  const Id destination = this->Mesh.Destination(halfEdge);
  const Id first = diagram.NearestSites[origin];
  const Id last = diagram.NearestSites[destination];
  if (first == last)
  {
    return; // a line above another one at both ends is above it in between
  }
  // Follows the lower envelope from line to line.
  const std::vector<Line> lines =
    LinesOf(distances, origin, destination, this->Mesh.Length(halfEdge));
  const auto find = [&lines](Id site) {
    return std::find_if(
      lines.begin(), lines.end(), [site](const Line& line) { return line.Site == site; });
  };
  auto current = find(first);
  const auto end = find(last);
  double before = -1.0;
  while (current->Site != last)
  {
    auto next = lines.end();
    double parameter = 1.0;
    for (auto line = lines.begin(); line != lines.end(); ++line)
    {
      const double ahead = line->Start - current->Start;
      const double behind = current->End - line->End;
      if (!(behind > 0.0))
      {
        continue;
      }
      const double t = ahead > 0.0 ? ahead / (ahead + behind) : 0.0;
      if (next == lines.end() || t < parameter || (t == parameter && line->End < next->End))
      {
        next = line;
        parameter = t;
      }
    }
    next = next == lines.end() ? end : next; // tied at the end, with a smaller index
    const bool isSame = before >= 0.0 && parameter - before < SamePlace;
    Id point = NoId;
    if (isSame)
    {
      point = this->Cuts.back().Point;
      parameter = before;
    }
    else if (parameter < SamePlace || parameter > 1.0 - SamePlace)
    {
      parameter = parameter < 0.5 ? 0.0 : 1.0;
      point = parameter < 0.5 ? origin : destination;
    }
    else
    {
      point = static_cast<Id>(diagram.Distances.size() + diagram.BorderPoints.size());
      diagram.BorderPoints.push_back(SurfacePoint::OnEdge(this->Mesh, halfEdge, parameter));
      diagram.BorderDistances.push_back(DistanceOn(*next, parameter, this->Mesh.Length(halfEdge)));
    }
    this->Cuts.push_back({ parameter, current->Site, next->Site, point });
    before = parameter;
    current = next;
  }
}

std::vector<EdgeCut> EdgeCuts::Of(Id halfEdge) const
{
  const Id first = FindEdge(this->Mesh, halfEdge);
  std::vector<EdgeCut> cuts(
    this->Cuts.begin() + this->Offsets[first], this->Cuts.begin() + this->Offsets[first + 1]);
  if (this->Mesh.Origin(first) != this->Mesh.Origin(halfEdge))
  {
    std::reverse(cuts.begin(), cuts.end());
    for (EdgeCut& cut : cuts)
    {
      cut.Parameter = 1.0 - cut.Parameter;
      std::swap(cut.Before, cut.After);
    }
  }
  return cuts;
}
}
