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
  this->ClosestPoints.reset();
  this->Builder.reset();
  this->Region.MakeMesh(this->Mesh);
  SurfaceFacts facts = this->Region.MeasureFacts(this->Mesh);
  DGG_RETURN_IF_ERROR(facts.Share(group));
  const SurfaceMesh& mesh = this->Mesh.Mesh;
  const double* const positions = this->Mesh.Positions.data();
  std::vector<Box> boxes;
  DGG_RETURN_IF_ERROR(group.Share(SurfaceLocator::MeasureBox(mesh, positions), boxes));
  this->SurfaceBox = Box();
  for (const Box& box : boxes)
  {
    this->SurfaceBox.Add(box);
  }
  this->PointIds.clear();
  for (const Id point : this->Mesh.Points)
  {
    this->PointIds.push_back(this->Region.GetPointId(point));
  }
  if (mesh.GetNumberOfFaces() > 0)
  {
    this->ClosestPoints = std::make_unique<const SurfaceLocator>(mesh, positions, this->SurfaceBox);
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
  std::vector<std::size_t> here; // positions that are linked by this process
  DGG_RETURN_IF_ERROR(this->ChooseHere(group, sources, tolerance, here));
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
  std::vector<std::vector<PositionLink>> lists;
  DGG_RETURN_IF_ERROR(group.ShareList(links, lists));
  std::vector<PositionLink> all;
  for (const std::vector<PositionLink>& list : lists)
  {
    all.insert(all.end(), list.begin(), list.end());
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
Status PieceLinks::ChooseHere(ProcessGroup& group, const SourceCollection& sources,
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
  std::vector<std::vector<Candidate>> all;
  DGG_RETURN_IF_ERROR(group.ShareList(candidates, all));
  const double diagonal = this->SurfaceBox.GetDiagonal();
  std::size_t firstFar = count; // of the positions here that are too far away
  double farDistance = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto best = std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return a[i] < b[i]; });
    if (best - all.begin() != group.Here)
    {
      continue;
    }
    here.push_back(i);
    const double distance = (*best)[i].Distance;
    const bool isClose =
      this->ClosestPoints && this->ClosestPoints->IsClose({}, distance, tolerance * diagonal);
    if (!isClose && firstFar == count)
    {
      firstFar = i;
      farDistance = distance;
    }
  }
  std::vector<std::size_t> far;
  DGG_RETURN_IF_ERROR(group.Share(firstFar, far));
  return firstFar < count && firstFar == *std::min_element(far.begin(), far.end())
    ? sources.RefuseDistant(firstFar, farDistance, tolerance, diagonal)
    : Status::Success();
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
