// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceLinks.h"

#include "dggGraphSeeds.h"
#include "dggRowFinder.h"
#include "dggSourceCollection.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

namespace dgg
{
namespace
{
/// Layers of cells around a piece at first. Their number is doubled as long as a link meets the
/// rim.
constexpr int FirstLayers = 8;

/// Closest point of a position, if it is in a cell of this process.
struct Candidate
{
  double Distance = Infinity;
  Offset CellId = NoId; // global

  bool operator<(const Candidate& other) const
  {
    return std::tie(this->Distance, this->CellId) < std::tie(other.Distance, other.CellId);
  }
};

/// Returns the first face at a point.
Id GetFirstFace(const SurfaceMesh& mesh, const SurfacePoint& point)
{
  Id first = std::numeric_limits<Id>::max();
  ForEachFaceAround(
    mesh, point, [&](Id face, const std::array<double, 3>&) { first = std::min(first, face); });
  return first;
}
}

Status PieceLinks::Prepare(const ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Region.Start(group, piece, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  this->Layers = FirstLayers;
  DGG_RETURN_IF_ERROR(this->Region.Grow(group, this->Layers, true));
  return this->MakeMesh(group);
}

Status PieceLinks::MakeMesh(const ProcessGroup& group)
{
  this->ClosestPoints.reset();
  this->Builder.reset();
  SurfaceFacts facts;
  DGG_RETURN_IF_ERROR(this->Region.MakeMesh(group, this->Mesh, facts));
  this->Whole = Box();
  for (const Box& box :
    group.Share(SurfaceLocator::MeasureBox(this->Mesh.Mesh, this->Mesh.Positions.data())))
  {
    this->Whole.Add(box);
  }
  return group.Run([&] {
    const std::vector<Id> order = this->Region.GetOrder();
    this->PointIds.resize(order.size());
    std::transform(order.begin(), order.end(), this->PointIds.begin(),
      [&](Id point) { return this->Region.GetPointId(point); });
    if (this->Mesh.Mesh.GetNumberOfFaces() > 0)
    {
      this->ClosestPoints = std::make_unique<const SurfaceLocator>(
        this->Mesh.Mesh, this->Mesh.Positions.data(), this->Whole);
      GraphRegion region;
      region.IsRim = this->Mesh.IsRim;
      region.PointIds = this->PointIds;
      region.NumberOfFaces = facts.NumberOfFaces;
      region.HasBranches = facts.HasBranches;
      this->Builder = std::make_unique<const GraphBuilder>(this->Mesh.Mesh, region);
    }
    return Status::Success();
  });
}

Status PieceLinks::Find(const ProcessGroup& group, const SourceCollection& sources,
  double tolerance, double accuracy, std::vector<PieceSeed>& seeds)
{
  std::vector<std::size_t> here; // positions whose closest points are in this region
  DGG_RETURN_IF_ERROR(this->ChooseHere(group, sources, tolerance, here));
  std::vector<PositionLink> links;
  for (;;)
  {
    DGG_RETURN_IF_ERROR(group.Run([&] { return this->LinkHere(sources, accuracy, here, links); }));
    if (group.Holds(here.empty()))
    {
      break;
    }
    DGG_RETURN_IF_ERROR(this->Region.Grow(group, this->Layers, !here.empty()));
    this->Layers *= 2;
    DGG_RETURN_IF_ERROR(this->MakeMesh(group));
  }
  std::vector<PositionLink> all;
  for (const std::vector<PositionLink>& part : group.ShareList(links))
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  std::stable_sort(all.begin(), all.end(),
    [](const PositionLink& a, const PositionLink& b) { return a.Position < b.Position; });
  for (const PositionLink& link : all)
  {
    const double offset = sources.GetInitialDistanceOfPosition(link.Position);
    const auto source = static_cast<Id>(sources.Ids.size() + link.Position);
    seeds.push_back(
      { link.PointId, { NoId, offset + link.Length, offset, source, link.ArrivalAngle } });
  }
  return Status::Success();
}

/// Finds the positions whose closest points are in cells of this process. Of several closest cells,
/// the one with the smallest id counts. The cells around those of the piece are in the region, so
/// that each process finds the same point as a single one.
Status PieceLinks::ChooseHere(const ProcessGroup& group, const SourceCollection& sources,
  double tolerance, std::vector<std::size_t>& here) const
{
  const std::size_t count = sources.GetNumberOfPositions();
  std::vector<Candidate> candidates(count);
  for (std::size_t i = 0; i < count && this->ClosestPoints; ++i)
  {
    SurfacePoint point;
    double distance = Infinity;
    this->ClosestPoints->FindClosestPoint(sources.GetPosition(i).data(), point, distance);
    const Offset cell = this->Mesh.CellIds[GetFirstFace(this->Mesh.Mesh, point)];
    if (cell != NoId)
    {
      candidates[i] = { distance, cell };
    }
  }
  const std::vector<std::vector<Candidate>> all = group.ShareList(candidates);
  Status status;
  for (std::size_t i = 0; i < count && status.IsOk(); ++i)
  {
    const auto best = std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return a[i] < b[i]; });
    const double distance = (*best)[i].Distance;
    const double diagonal = this->Whole.GetDiagonal();
    if (best - all.begin() != group.Here)
    {
      continue;
    }
    here.push_back(i);
    if (!this->ClosestPoints || !this->ClosestPoints->IsClose({}, distance, tolerance * diagonal))
    {
      status = sources.RefuseDistant(i, distance, tolerance, diagonal);
    }
  }
  return group.Agree(status);
}

/// Links positions, and removes those whose links are complete.
Status PieceLinks::LinkHere(const SourceCollection& sources, double accuracy,
  std::vector<std::size_t>& here, std::vector<PositionLink>& links) const
{
  std::vector<std::size_t> left;
  for (const std::size_t i : here)
  {
    SurfacePoint point;
    double distance = 0.0;
    this->ClosestPoints->FindClosestPoint(sources.GetPosition(i).data(), point, distance);
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
