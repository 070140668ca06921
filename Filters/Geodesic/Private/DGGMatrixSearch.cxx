// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGMatrixSearch.h"

#include "DGGGraphUser.h"
#include "DGGThreads.h"

#include "dggProgressPart.h"

#include <algorithm>

namespace
{
/// Shares of the progress.
constexpr double SourcesLinked = 0.05;
constexpr double TargetsLinked = 0.1;

/// Points that a thread links between two looks at the progress.
constexpr std::size_t LinkBlock = 16;

/// Indices of the points that are vertices, or of those that are not.
std::vector<std::size_t> FindPoints(const DGGMatrixSearch::Points& points, bool vertices)
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (dgg::IsVertex(points[i]) == vertices)
    {
      found.push_back(i);
    }
  }
  return found;
}

/// A vertex is linked to itself; the other points have no links yet.
void LinkVertices(const DGGMatrixSearch::Points& points, DGGMatrixSearch::Links& links)
{
  constexpr double noDirection = -1.0;
  links.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (dgg::IsVertex(points[i]))
    {
      links[i] = { { points[i].Vertex, 0.0, noDirection } };
    }
  }
}
}

//------------------------------------------------------------------------------
DGGMatrixSearch::DGGMatrixSearch(const DGGContext& context, DGGGraphUser& graph,
  const Points& sources, const Points& targets, const DGGMatrixEntries& distances)
  : Context(context)
  , Graph(graph)
  , Sources(sources)
  , Targets(targets)
  , Distances(distances)
  , Progress(graph.GetRemainingProgress(context))
{
}

//------------------------------------------------------------------------------
/// Links of points on one side. Straight ways to those on the other side that are no vertices
/// either are lengths of ways as well.
template <typename EntryType>
dgg::Status DGGMatrixSearch::LinkPoints(
  const Points& points, const Points& others, double end, Links& links, EntryType entry)
{
  const std::vector<std::size_t> unlinked = FindPoints(points, false);
  LinkVertices(points, links);
  if (unlinked.empty())
  {
    return dgg::Status::Success();
  }
  const std::vector<std::size_t> aims = FindPoints(others, false);
  Points aimPoints;
  for (const std::size_t i : aims)
  {
    aimPoints.push_back(others[i]);
  }
  const double start = this->Done;
  this->Done = end;
  return DGGForEach(unlinked.size(), LinkBlock, dgg::ProgressPart(this->Progress, start, end),
    [&](std::size_t k, const dgg::ProgressCallback&) {
      const std::size_t i = unlinked[k];
      std::vector<double> direct;
      const dgg::Status status = this->Graph.Link(points[i], aimPoints, links[i], direct);
      for (std::size_t a = 0; a < aims.size() && status.IsOk(); ++a)
      {
        double& distance = entry(i, aims[a]);
        distance = std::min(distance, direct[a]);
      }
      return status;
    });
}

//------------------------------------------------------------------------------
dgg::Status DGGMatrixSearch::Run(bool symmetric, double radius)
{
  this->IsSymmetric = symmetric;
  const bool areVertices = std::all_of(this->Sources.begin(), this->Sources.end(), dgg::IsVertex) &&
    std::all_of(this->Targets.begin(), this->Targets.end(), dgg::IsVertex);
  DGG_RETURN_IF_ERROR(this->Graph.PrepareBuilder(this->Context, !areVertices));
  DGG_RETURN_IF_ERROR(
    this->LinkPoints(this->Sources, this->Targets, SourcesLinked, this->SourceLinks,
      [this](std::size_t i, std::size_t j) -> double& { return this->Distances(i, j); }));
  if (symmetric)
  {
    this->TargetLinks = this->SourceLinks;
  }
  else
  {
    // Straight ways once more: seen from the other end they need not be among the windows, and the
    // answer should not depend on which end they are seen from.
    DGG_RETURN_IF_ERROR(
      this->LinkPoints(this->Targets, this->Sources, TargetsLinked, this->TargetLinks,
        [this](std::size_t j, std::size_t i) -> double& { return this->Distances(i, j); }));
  }
  DGG_RETURN_IF_ERROR(this->Search(radius));
  if (symmetric)
  {
    this->Mirror();
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGMatrixSearch::Search(double radius)
{
  std::vector<std::vector<dgg::GraphSeed>> seeds(this->Sources.size());
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    for (const dgg::GraphLink& link : this->SourceLinks[i])
    {
      seeds[i].push_back({ link.Vertex, link.Length, 0.0, 0, link.ArrivalAngle });
    }
  }
  dgg::ManyOptions options;
  options.MaximumDistance = radius;
  for (const std::vector<dgg::GraphLink>& links : this->TargetLinks)
  {
    for (const dgg::GraphLink& link : links)
    {
      options.Targets.push_back(link.Vertex);
    }
  }
  return this->Graph.GetSearch().Many(seeds, options, this->Context.Parallel,
    dgg::ProgressPart(this->Progress, this->Done, 1.0),
    [this](std::size_t source, const double* field, const std::vector<dgg::Id>&) {
      this->LookAtTargets(source, field);
    });
}

//------------------------------------------------------------------------------
void DGGMatrixSearch::LookAtTargets(std::size_t source, const double* field) const
{
  for (std::size_t j = this->IsSymmetric ? source + 1 : 0; j < this->Targets.size(); ++j)
  {
    double& distance = this->Distances(source, j);
    for (const dgg::GraphLink& link : this->TargetLinks[j])
    {
      distance = std::min(distance, field[link.Vertex] + link.Length);
    }
  }
}

//------------------------------------------------------------------------------
void DGGMatrixSearch::Mirror() const
{
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    this->Distances(i, i) = 0.0;
    for (std::size_t j = i + 1; j < this->Sources.size(); ++j)
    {
      const double distance = std::min(this->Distances(i, j), this->Distances(j, i));
      this->Distances(i, j) = distance;
      this->Distances(j, i) = distance;
    }
  }
}
