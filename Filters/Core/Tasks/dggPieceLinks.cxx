// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceLinks.h"

#include "dggGraphSeeds.h"
#include "dggRowFinder.h"
#include "dggSourceCollection.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Layers of cells around a piece at first. Their number is doubled as long as a link meets the
/// rim.
constexpr int FirstLayers = 8;
}

Status PieceLinks::Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Region.Start(group, piece, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  this->NextLayers = FirstLayers;
  DGG_RETURN_IF_ERROR(this->Region.Grow(group, this->NextLayers, true, 0.0));
  return this->MakeMesh(group);
}

Status PieceLinks::MakeMesh(ProcessGroup& group)
{
  this->Builder.reset();
  this->Region.MakeMesh(this->Mesh);
  SurfaceFacts facts = this->Region.MeasureFacts(this->Mesh);
  DGG_RETURN_IF_ERROR(facts.Share(group));
  const SurfaceMesh& mesh = this->Mesh.Mesh;
  DGG_RETURN_IF_ERROR(
    this->Locator.Prepare(group, mesh, this->Mesh.Positions.data(), this->Mesh.CellIds));
  this->PointIds.clear();
  for (const Id point : this->Mesh.Points)
  {
    this->PointIds.push_back(this->Region.GetPointId(point));
  }
  if (mesh.GetNumberOfFaces() > 0)
  {
    GraphRegion region;
    region.IsRim = this->Mesh.IsRim;
    region.PointIds = this->PointIds;
    region.NumberOfFaces = facts.NumberOfFaces;
    region.HasBranches = facts.Defects.NonManifoldEdges > 0;
    this->Builder = std::make_unique<const GraphBuilder>(mesh, region);
  }
  return Status::Success();
}

Status PieceLinks::Find(ProcessGroup& group, const SourceCollection& sources, double tolerance,
  double accuracy, std::vector<PieceSeed>& seeds)
{
  PiecePoints located;
  DGG_RETURN_IF_ERROR(this->Locator.Locate(group, sources, tolerance, located));
  std::vector<std::size_t> here = located.Indices; // positions without links
  std::vector<PositionLink> links;
  for (;;)
  {
    DGG_RETURN_IF_ERROR(this->LinkHere(sources, accuracy, here, links));
    const bool isNeeded = !here.empty();
    bool isDone = !isNeeded;
    DGG_RETURN_IF_ERROR(group.Require(isDone));
    if (isDone)
    {
      break;
    }
    DGG_RETURN_IF_ERROR(this->Region.Grow(group, this->NextLayers, isNeeded, 0.0));
    this->NextLayers *= 2;
    DGG_RETURN_IF_ERROR(this->MakeMesh(group));
  }
  DGG_RETURN_IF_ERROR(group.JoinLists(links));
  std::stable_sort(links.begin(), links.end(),
    [](const PositionLink& a, const PositionLink& b) { return a.Position < b.Position; });
  for (const PositionLink& link : links)
  {
    const double offset = sources.GetInitialDistanceOfPosition(link.Position);
    const auto source = static_cast<Id>(sources.Ids.size() + link.Position);
    seeds.push_back(
      { link.PointId, { NoId, offset + link.Length, offset, source, link.ArrivalAngle } });
  }
  return Status::Success();
}

/// Links positions, and removes those whose links are complete.
Status PieceLinks::LinkHere(const SourceCollection& sources, double accuracy,
  std::vector<std::size_t>& here, std::vector<PositionLink>& links) const
{
  std::vector<std::size_t> left;
  for (const std::size_t i : here)
  {
    const SurfacePoint point = this->Locator.FindClosestPoint(sources.GetPosition(i));
    std::vector<GraphLink> found{ LinkOfVertex(point.Vertex) };
    std::vector<double> none;
    bool meetsRim = false;
    if (!IsVertex(point))
    {
      DGG_RETURN_IF_ERROR(
        this->Builder->Link(point, accuracy, {}, found, none, nullptr, &meetsRim));
    }
    if (meetsRim)
    {
      left.push_back(i);
      continue;
    }
    for (const GraphLink& link : found)
    {
      links.push_back({ i, this->PointIds[link.Vertex], link.Length, link.ArrivalAngle });
    }
  }
  here.swap(left);
  return Status::Success();
}
}
