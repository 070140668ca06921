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
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace dgg
{
namespace
{
/// Bytes of a face: single precision, slots of its edges, labels and its share of vertices.
constexpr double BytesOfFace = 256.0;

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
  const Signature pieces = SumSignatures(signatures);
  bool isPrepared = this->Solver && this->Pieces == pieces;
  DGG_RETURN_IF_ERROR(group.Require(isPrepared));
  isUsable = true;
  if (isPrepared)
  {
    return Status::Success();
  }
  this->Solver.reset();
  this->Pieces = pieces;
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
  const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
  std::vector<int> owners;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    owners.push_back(this->Surface.GetOwner(f));
  }
  auto solver = std::make_unique<SourcePropagation>(mesh, this->Surface.GetMeanEdgeLength(),
    std::make_unique<PropagationPieces>(
      mesh, std::move(owners), this->Surface.GetTotalFaces(), group));
  DGG_RETURN_IF_ERROR(solver->Prepare(group, isUsable));
  if (isUsable)
  {
    this->Solver = std::move(solver);
  }
  return Status::Success();
}

Status PiecePropagation::Run(const TaskContext& context, ProcessGroup& group,
  const SourceCollection& sources, PropagationQuality quality, const DistanceRequest& request,
  DistanceOutput& output, bool& isDone) const
{
  DGG_RETURN_IF_ERROR(sources.Check(this->Surface.GetTotalPoints()));
  std::vector<GeodesicSource> here;
  std::vector<PlacedSource> all;
  DGG_RETURN_IF_ERROR(this->FindSources(group, sources, here, all, isDone));
  if (!isDone)
  {
    return Status::Success();
  }
  PropagationOptions options;
  options.Quality = quality;
  options.MaximumDistance = request.MaximumDistance;
  options.Parallel = context.Parallel;
  options.Progress = context.Progress;
  const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
  const double inUse = static_cast<double>(mesh.GetMemorySize()) +
    BytesOfFace * static_cast<double>(mesh.GetNumberOfFaces());
  PropagationResult result;
  DGG_RETURN_IF_ERROR(this->Solver->RunPiece(group, here, options, inUse, result));
  KeepAboveStraightLine(this->Surface.MakeContext(context), all, this->Surface.GetMeanEdgeLength(),
    options.MaximumDistance, result);
  DistanceResults results;
  results.MaximumDistance = request.MaximumDistance;
  results.Distances = this->Surface.ToPiece(result.Distances, this->NumberOfPoints, Infinity);
  output.QualityWarning = result.IsSettled || group.Here > 0 ? "" : UnsettledDistances;
  return WritePieceDistances(group, results, request, output);
}

/// Finds the sources on the surface of this process, and the positions of all of them.
Status PiecePropagation::FindSources(ProcessGroup& group, const SourceCollection& sources,
  std::vector<GeodesicSource>& here, std::vector<PlacedSource>& all, bool& areFound) const
{
  const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
  std::vector<SentSource> sent;
  for (std::size_t i = 0; i < sources.Ids.size(); ++i)
  {
    const Id v = this->Surface.GetVertexOf(sources.Ids[i]);
    here.push_back({ SurfacePoint::AtVertex(v), sources.GetInitialDistanceOfId(i) });
    if (v != NoId && mesh.FanBegin(v) != mesh.FanEnd(v))
    {
      const double* const p = this->Surface.GetPosition(v);
      sent.push_back({ i, { { p[0], p[1], p[2] } } });
    }
  }
  std::vector<std::vector<SentSource>> lists;
  DGG_RETURN_IF_ERROR(group.ShareList(sent, lists));
  all.resize(here.size());
  std::vector<char> isFound(here.size(), 0);
  for (const std::vector<SentSource>& list : lists)
  {
    for (const SentSource& source : list)
    {
      all[source.Index] = { here[source.Index].InitialDistance, source.Position };
      isFound[source.Index] = 1;
    }
  }
  areFound = std::find(isFound.begin(), isFound.end(), 0) == isFound.end();
  return Status::Success();
}
}
