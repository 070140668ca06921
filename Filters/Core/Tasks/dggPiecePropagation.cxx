// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPiecePropagation.h"

#include "dggDistanceMethods.h"
#include "dggDistanceOutput.h"
#include "dggMeshQuality.h"
#include "dggPieceDistances.h"
#include "dggPieceGraph.h"
#include "dggPropagationPieces.h"
#include "dggSourceCollection.h"
#include "dggSurfacePath.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace dgg
{
namespace
{
/// Bytes per face: mesh, PropagationFace, slots of its edges, labels and half a vertex.
constexpr double BytesOfFace = 400.0;
constexpr const char* MemoryRemedy = "Use more processes";

/// A source with the position of its point.
struct SentSource
{
  std::size_t Index;
  std::array<double, 3> Position;
};
}

Status PiecePropagation::Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  std::vector<Signature> signatures;
  DGG_RETURN_IF_ERROR(group.Share(ComputeSignature(piece), signatures));
  bool isPrepared = this->Solver && this->Pieces == signatures;
  DGG_RETURN_IF_ERROR(group.Require(isPrepared));
  isUsable = true;
  if (isPrepared)
  {
    return Status::Success();
  }
  this->Solver.reset();
  this->Pieces = std::move(signatures);
  return this->PrepareSurface(group, piece, isUsable);
}

Status PiecePropagation::PrepareSurface(
  ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  this->NumberOfPoints = piece.NumberOfPoints;
  DGG_RETURN_IF_ERROR(this->Surface.Prepare(group, piece, isUsable));
  isUsable = isUsable && !this->Surface.HasLongTriangles();
  if (!isUsable)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(group.Agree(
    CheckMemory("Propagation", this->GetMemorySize(), group.MemoryLimit, MemoryRemedy)));
  const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
  std::vector<int> owners;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    owners.push_back(this->Surface.GetOwner(f));
  }
  auto pieces = std::make_unique<PropagationPieces>(
    mesh, std::move(owners), this->Surface.GetTotalFaces(), group);
  std::vector<char> isMissed; // distances are known at corners of faces of this process
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    isMissed.push_back(mesh.FanBegin(v) != mesh.FanEnd(v) && !pieces->HasVertex(v) ? 1 : 0);
  }
  isMissed = this->Surface.ToPiece(isMissed, this->NumberOfPoints, '\0');
  isUsable = std::find(isMissed.begin(), isMissed.end(), 1) == isMissed.end();
  DGG_RETURN_IF_ERROR(group.Require(isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  auto solver =
    std::make_unique<SourcePropagation>(mesh, this->Surface.GetMeanEdgeLength(), std::move(pieces));
  DGG_RETURN_IF_ERROR(solver->Prepare(group, isUsable));
  if (isUsable)
  {
    this->Solver = std::move(solver);
  }
  return Status::Success();
}

Status PiecePropagation::Run(const TaskContext& context, ProcessGroup& group,
  const SourceCollection& sources, double tolerance, PropagationQuality quality,
  const DistanceRequest& request, DistanceOutput& output, bool& isDone) const
{
  DGG_RETURN_IF_ERROR(sources.Check(this->Surface.GetTotalPoints()));
  std::vector<GeodesicSource> points;
  std::vector<PlacedSource> positions;
  DGG_RETURN_IF_ERROR(this->FindSources(group, sources, tolerance, points, positions, isDone));
  if (!isDone)
  {
    return Status::Success();
  }
  PropagationOptions options;
  options.Quality = quality;
  options.MaximumDistance = request.MaximumDistance;
  options.Parallel = context.Parallel;
  options.Progress = context.Progress;
  PropagationResult result;
  DGG_RETURN_IF_ERROR(
    this->Solver->RunPiece(group, points, options, this->GetMemorySize(), result));
  KeepAboveStraightLine(this->Surface.MakeContext(context), positions,
    this->Surface.GetMeanEdgeLength(), options.MaximumDistance, result);
  DistanceResults results;
  results.MaximumDistance = request.MaximumDistance;
  results.Distances = this->Surface.ToPiece(result.Distances, this->NumberOfPoints, Infinity);
  output.QualityWarning = result.IsSettled ? "" : UnsettledDistances;
  return WritePieceDistances(group, results, request, output);
}

/// Returns an estimate of the size in bytes during a propagation.
double PiecePropagation::GetMemorySize() const
{
  return BytesOfFace * static_cast<double>(this->Surface.GetLayers().size());
}

/// Finds the points of all sources on the surface of this process, and their positions. `areFound`
/// becomes false if a source has no cells.
Status PiecePropagation::FindSources(ProcessGroup& group, const SourceCollection& sources,
  double tolerance, std::vector<GeodesicSource>& points, std::vector<PlacedSource>& positions,
  bool& areFound) const
{
  PiecePoints here;
  DGG_RETURN_IF_ERROR(this->Surface.Locate(group, sources, tolerance, here));
  std::vector<SurfacePoint> all;
  DGG_RETURN_IF_ERROR(this->Surface.ShareAll(group, here, all));
  const std::size_t ids = sources.Ids.size();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    points.push_back({ all[i],
      i < ids ? sources.GetInitialDistanceOfId(i)
              : sources.GetInitialDistanceOfPosition(i - ids) });
  }
  const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
  std::vector<SentSource> sent;
  areFound = true;
  for (std::size_t k = 0; k < here.Points.size(); ++k)
  {
    const SurfacePoint& point = here.Points[k];
    areFound =
      areFound && !(IsVertex(point) && mesh.FanBegin(point.Vertex) == mesh.FanEnd(point.Vertex));
    sent.push_back(
      { here.Indices[k], PositionOf(mesh, point, this->Surface.Get().GetPositions()) });
  }
  DGG_RETURN_IF_ERROR(group.JoinLists(sent));
  positions.resize(points.size());
  for (const SentSource& source : sent)
  {
    positions[source.Index] = { points[source.Index].InitialDistance, source.Position };
  }
  return group.Require(areFound);
}
}
