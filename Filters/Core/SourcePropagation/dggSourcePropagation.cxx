// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourcePropagation.h"

#include "dggProgressPart.h"
#include "dggPropagation.h"
#include "dggPropagationFaces.h"
#include "dggPropagationPieces.h"
#include "dggRoundTeam.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace dgg
{
namespace
{
/// Maximum initial distance above the smallest one, in mean edge lengths. The range of single
/// precision ends at 3e38.
constexpr double LargestOffset = 1e30;
constexpr Offset VerticesPerBlock = 4096;
/// Minimum number of faces per thread; on smaller meshes fronts are too short for more threads.
constexpr Id FacesPerThread = 10000;
/// Error of distances from a nearby source due to single precision, relative.
constexpr double SeedSlack = 1e-5;

/// Calls visit(vertex, source, distance, place) for the corners of the faces that contain sources.
template <typename Visit>
void ForEachPlace(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, const Visit& visit)
{
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const SurfacePoint& point = sources[k].Point;
    const auto root = static_cast<Id>(k);
    const double offset = sources[k].InitialDistance;
    if (IsVertex(point))
    {
      if (point.Vertex != NoId)
      {
        visit(point.Vertex, root, offset, VirtualPlace());
      }
      continue;
    }
    ForEachFaceAround(mesh, point, [&](Id f, const std::array<double, 3>& b) {
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Point2 place = PlaceInFrame(mesh, h, b);
        const double length = DistanceToCorner(mesh, f, b, h % 3);
        visit(mesh.Origin(h), root, offset + length, { length, h, std::atan2(place.Y, place.X) });
      }
    });
  }
}

/// The results of a propagation of virtual sources, in the units of the mesh.
class PropagationOutput
{
public:
  /// Relative tolerance at the maximum distance.
  static constexpr double LimitSlack = 1e-6;

  /// `shift` is the smallest initial distance.
  PropagationOutput(const SurfaceMesh& mesh, const PropagationOptions& options, double shift,
    PropagationResult& result);

  bool WantsLabels() const
  {
    return this->Options.WantNearestSource || this->Options.WantVirtualSource;
  }
  /// Sets the distance of a vertex. Returns false if it is beyond the maximum distance. Several
  /// threads may set different vertices.
  bool SetDistance(Id v, double distance);
  /// Returns true if the distance of a vertex was set to this value.
  bool IsAt(Id v, double distance) const
  {
    return this->Result.Distances[v] == std::min(distance, this->Options.MaximumDistance);
  }
  void SetSource(Id v, Id root, const VirtualPlace& place);
  Id GetNearest(Id v) const
  {
    return this->Options.WantNearestSource ? this->Result.NearestSource[v] : NoId;
  }
  /// Sets the exact distances of the sources and of the corners of their faces, which no label has
  /// reached.
  void TakeSources(const std::vector<GeodesicSource>& sources);

private:
  const SurfaceMesh& Mesh;
  const PropagationOptions& Options;
  const double Shift;
  PropagationResult& Result;
};

PropagationOutput::PropagationOutput(const SurfaceMesh& mesh, const PropagationOptions& options,
  double shift, PropagationResult& result)
  : Mesh(mesh)
  , Options(options)
  , Shift(shift)
  , Result(result)
{
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  result.Distances.assign(n, Infinity);
  if (options.WantNearestSource)
  {
    result.NearestSource.assign(n, NoId);
  }
  if (options.WantVirtualSource)
  {
    result.Virtual.assign(n, {});
  }
}

bool PropagationOutput::SetDistance(Id v, double distance)
{
  const double maximum = this->Options.MaximumDistance;
  if (!(distance <= maximum + LimitSlack * (maximum - this->Shift)))
  {
    return false;
  }
  this->Result.Distances[v] = std::min(distance, maximum);
  return true;
}

void PropagationOutput::SetSource(Id v, Id root, const VirtualPlace& place)
{
  if (this->Options.WantNearestSource)
  {
    this->Result.NearestSource[v] = root;
  }
  if (this->Options.WantVirtualSource)
  {
    this->Result.Virtual[v] = { this->Result.Distances[v] - place.Length, place.Length,
      place.HalfEdge == NoId ? 0.0 : this->Mesh.PolarAngle(place.HalfEdge) + place.Angle };
  }
}

void PropagationOutput::TakeSources(const std::vector<GeodesicSource>& sources)
{
  const double maximum = this->Options.MaximumDistance;
  std::vector<double>& distances = this->Result.Distances;
  // If a source is as near as the stored distance, the nearest source decides; on ties the first
  // one.
  ForEachPlace(this->Mesh, sources, [&](Id v, Id, double distance, const VirtualPlace&) {
    if (distance <= distances[v] + SeedSlack * (distance - this->Shift) && distance <= maximum)
    {
      distances[v] = Infinity;
    }
  });
  ForEachPlace(this->Mesh, sources, [&](Id v, Id root, double distance, const VirtualPlace& place) {
    if (distance < distances[v] && distance <= maximum)
    {
      distances[v] = distance;
      this->SetSource(v, root, place);
    }
  });
}

/// Runs the propagation with either quality. `pieces` is null for an entire surface.
template <bool High>
Status RunPropagation(const SurfaceMesh& mesh, const PropagationFaces& faces,
  PropagationPieces* pieces, const std::vector<GeodesicSource>& sources,
  const PropagationOptions& options, PropagationResult& result)
{
  // Distances are measured relative to the smallest initial one, so that large initial distances do
  // not cause rounding errors.
  double shift = Infinity;
  for (const GeodesicSource& source : sources)
  {
    shift = std::min(shift, source.InitialDistance);
  }
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if ((sources[k].InitialDistance - shift) / faces.GetUnit() > LargestOffset)
    {
      return InvalidInput("Source ", k,
        " has an initial distance of more than 1e30 mean edges above the smallest one, which "
        "exceeds single precision")
        .At("InitialDistance", static_cast<Offset>(k))
        .Fix("Use smaller initial distances, or exact distances");
    }
  }
  const double radius = (options.MaximumDistance - shift) / faces.GetUnit();
  // Single-precision comparisons must not lose vertices exactly at the maximum distance.
  const auto limit =
    static_cast<float>(std::min(radius * (1.0 + PropagationOutput::LimitSlack), 1e37));
  const int threads =
    std::min(mesh.GetNumberOfFaces() / FacesPerThread, static_cast<Id>(RoundTeam::LargestTeam));
  const ParallelFor parallel = threads > 1 ? options.Parallel : ParallelFor();
  Propagation<High> propagation(
    mesh, faces, pieces, shift, limit, parallel, parallel ? threads : 1);
  propagation.Start(sources, options.WantNearestSource || options.WantVirtualSource);
  while (!propagation.IsDone())
  {
    Status status;
    RoundTeam::Run(parallel, threads, [&](RoundTeam& team) { status = propagation.Advance(team); });
    DGG_RETURN_IF_ERROR(status);
    // Not while other threads wait for the leader, because observers may run loops of their own.
    DGG_RETURN_IF_ERROR(ReportTo(options.Progress, propagation.GetProgress()));
  }
  result.IsSettled = propagation.IsSettled();
  PropagationOutput output(mesh, options, shift, result);
  DGG_RETURN_IF_ERROR(propagation.FindShortcuts(parallel));
  ForRange(parallel, mesh.GetNumberOfVertices(), VerticesPerBlock, [&](Offset begin, Offset end) {
    for (auto v = static_cast<Id>(begin); v < end; ++v)
    {
      PropagationLabel label{};
      VirtualPlace place;
      if (propagation.IsReached(v) && output.SetDistance(v, propagation.GetDistance(v)) &&
        output.WantsLabels() && propagation.FindLabel(v, label, place))
      {
        output.SetSource(v, label.Root, place);
      }
    }
  });
  output.TakeSources(sources);
  for (const PropagationShortcut& way : propagation.GetShortcuts())
  {
    if (output.WantsLabels() && output.IsAt(way.Vertex, propagation.GetDistance(way.Vertex)))
    {
      VirtualPlace place;
      propagation.SeeFrom(way.Vertex, way.Label, place);
      const Id root = way.Label.Root;
      output.SetSource(
        way.Vertex, root == NoId ? output.GetNearest(mesh.Origin(way.Label.Entry)) : root, place);
    }
  }
  return Status::Success();
}
}

SourcePropagation::SourcePropagation(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Faces(std::make_unique<PropagationFaces>(mesh))
{
}

SourcePropagation::SourcePropagation(
  const SurfaceMesh& mesh, double meanEdgeLength, std::unique_ptr<PropagationPieces> pieces)
  : Mesh(mesh)
  , Pieces(std::move(pieces))
  , Faces(std::make_unique<PropagationFaces>(mesh, meanEdgeLength, this->Pieces.get()))
{
}

SourcePropagation::~SourcePropagation() = default;

Status SourcePropagation::Prepare(ProcessGroup& group, bool& isUsable)
{
  bool isFlat = !this->Faces->HasShadows();
  DGG_RETURN_IF_ERROR(group.Require(isFlat));
  this->Faces->SetShadows(!isFlat);
  isUsable = this->Faces->GetNumberOfHubs() == 0;
  return group.Require(isUsable);
}

Status SourcePropagation::RunPiece(ProcessGroup& group, const std::vector<GeodesicSource>& sources,
  const PropagationOptions& options, double inUse, PropagationResult& result) const
{
  result = PropagationResult();
  this->Pieces->Start(group, inUse);
  return options.Quality == PropagationQuality::High
    ? RunPropagation<true>(this->Mesh, *this->Faces, this->Pieces.get(), sources, options, result)
    : RunPropagation<false>(this->Mesh, *this->Faces, this->Pieces.get(), sources, options, result);
}

Status SourcePropagation::Run(const std::vector<GeodesicSource>& sources,
  const PropagationOptions& options, PropagationResult& result) const
{
  result = PropagationResult();
  DGG_RETURN_IF_ERROR(CheckSources(this->Mesh, sources));
  if (std::isnan(options.MaximumDistance))
  {
    return InvalidValue("MaximumDistance", options.MaximumDistance).Fix("Use a number or infinity");
  }
  return options.Quality == PropagationQuality::High
    ? RunPropagation<true>(this->Mesh, *this->Faces, nullptr, sources, options, result)
    : RunPropagation<false>(this->Mesh, *this->Faces, nullptr, sources, options, result);
}
}
