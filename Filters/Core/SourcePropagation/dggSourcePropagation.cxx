// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourcePropagation.h"

#include "dggPropagation.h"
#include "dggPropagationFaces.h"
#include "dggPropagationOutput.h"
#include "dggRoundTeam.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

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

/// Runs the propagation with either quality.
template <bool High>
Status RunPropagation(const SurfaceMesh& mesh, const PropagationFaces& faces,
  const std::vector<GeodesicSource>& sources, const PropagationOptions& options,
  PropagationResult& result)
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
  Propagation<High> propagation(mesh, faces, shift, limit, parallel, parallel ? threads : 1);
  propagation.Start(sources, options.WantNearestSource || options.WantVirtualSource);
  while (!propagation.IsDone())
  {
    RoundTeam::Run(parallel, threads, [&](RoundTeam& team) { propagation.Advance(team); });
    // Not while other threads wait for the leader, because observers may run loops of their own.
    if (options.Progress && !options.Progress(propagation.GetProgress()))
    {
      return Status::Abort();
    }
  }
  result.IsSettled = propagation.IsSettled();
  PropagationOutput output(mesh, options, shift, result);
  const auto& shortcuts = propagation.FindShortcuts(parallel);
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
  for (const PropagationShortcut& way : shortcuts)
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

SourcePropagation::~SourcePropagation() = default;

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
    ? RunPropagation<true>(this->Mesh, *this->Faces, sources, options, result)
    : RunPropagation<false>(this->Mesh, *this->Faces, sources, options, result);
}
}
