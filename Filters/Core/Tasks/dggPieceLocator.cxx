// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceLocator.h"

#include "dggSourceCollection.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

namespace dgg
{
namespace
{
/// Number of positions about which processes exchange messages at a time.
constexpr std::size_t BlockSize = 65536;

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

Status PieceLocator::Prepare(ProcessGroup& group, const SurfaceMesh& mesh, const double* positions,
  const std::vector<Offset>& cellIds)
{
  this->Mesh = &mesh;
  this->CellIds = &cellIds;
  std::vector<Box> boxes;
  DGG_RETURN_IF_ERROR(group.Share(SurfaceLocator::MeasureBox(mesh, positions), boxes));
  this->SurfaceBox = Box();
  for (const Box& box : boxes)
  {
    this->SurfaceBox.Add(box);
  }
  this->ClosestPoints.reset();
  if (mesh.GetNumberOfFaces() > 0)
  {
    this->ClosestPoints = std::make_unique<const SurfaceLocator>(mesh, positions, this->SurfaceBox);
  }
  return Status::Success();
}

Status PieceLocator::Locate(
  ProcessGroup& group, const SourceCollection& sources, double tolerance, PiecePoints& here) const
{
  const std::size_t count = sources.GetNumberOfPositions();
  const double diagonal = this->SurfaceBox.GetDiagonal();
  std::size_t firstFar = count; // of the positions here that are too far away
  double farDistance = 0.0;
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    const std::size_t size = std::min(BlockSize, count - begin);
    std::vector<Candidate> candidates(size);
    std::vector<SurfacePoint> closest(size);
    for (std::size_t i = 0; i < size && this->ClosestPoints; ++i)
    {
      double distance = Infinity;
      // Not found if the squared distance overflows.
      if (this->ClosestPoints->FindClosestPoint(
            sources.GetPosition(begin + i).data(), closest[i], distance))
      {
        const Offset cell = (*this->CellIds)[GetFirstFace(*this->Mesh, closest[i])];
        candidates[i] = cell == NoId ? Candidate() : Candidate{ distance, cell };
      }
    }
    std::vector<std::vector<Candidate>> all;
    DGG_RETURN_IF_ERROR(group.ShareList(candidates, all));
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto best = std::min_element(
        all.begin(), all.end(), [&](const auto& a, const auto& b) { return a[i] < b[i]; });
      if (best - all.begin() != group.Here)
      {
        continue;
      }
      here.Add(begin + i, closest[i]);
      const double distance = (*best)[i].Distance;
      const bool isClose =
        distance < Infinity && this->ClosestPoints->IsClose({}, distance, tolerance * diagonal);
      if (!isClose && firstFar == count)
      {
        firstFar = begin + i;
        farDistance = distance;
      }
    }
  }
  std::vector<std::size_t> far;
  DGG_RETURN_IF_ERROR(group.Share(firstFar, far));
  const bool isFirst =
    firstFar < count && firstFar == *std::min_element(far.begin(), far.end()); // of all processes
  return group.Agree(isFirst ? sources.RefuseDistant(firstFar, farDistance, tolerance, diagonal)
                             : Status::Success());
}

SurfacePoint PieceLocator::FindClosestPoint(const std::array<double, 3>& position) const
{
  SurfacePoint point;
  double distance = 0.0;
  this->ClosestPoints->FindClosestPoint(position.data(), point, distance);
  return point;
}
}
