// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVoronoi.h"

#include "dggBorderCurves.h"
#include "dggEdgeCuts.h"
#include "dggFaceCells.h"
#include "dggSiteDistances.h"

#include <string>

namespace dgg
{
namespace
{
/// Share of the progress that the distances take.
constexpr double DistancesShare = 0.8;
/// Faces between two reports: some milliseconds.
constexpr Id ProgressInterval = 65536;

Status CheckSites(const std::vector<GraphSeed>& seeds)
{
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    if (seeds[i].Source < 0 || seeds[i].InitialDistance != 0.0 || seeds[i].Distance < 0.0 ||
      (seeds[i].ArrivalAngle < 0.0 && seeds[i].Distance != 0.0))
    {
      return Status::Invalid("source " + std::to_string(i) +
        " has no number or an initial distance, which sites must not have");
    }
  }
  return Status::Success();
}

Status Fill(const GraphSearch& search, const SurfaceMesh& mesh, const std::vector<GraphSeed>& seeds,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  Status status = CheckSites(seeds);
  SiteDistances distances;
  if (status.IsOk())
  {
    ProgressCallback share;
    if (progress)
    {
      share = [&progress](double done) { return progress(DistancesShare * done); };
    }
    status = distances.Run(search, mesh, seeds, share);
  }
  if (!status.IsOk())
  {
    return status;
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const SiteDistances::Entry* nearest = distances.Nearest(v);
    diagram.NearestSites.push_back(nearest ? nearest->Site : NoId);
    diagram.Distances.push_back(nearest ? nearest->Distance : Infinity);
  }
  const EdgeCuts cuts(mesh, distances, diagram);
  FaceCells cells(mesh, distances, cuts, diagram);
  diagram.PolygonOffsets.push_back(0);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const double done = static_cast<double>(f) / mesh.GetNumberOfFaces();
    if (f % ProgressInterval == 0 && progress &&
      !progress(DistancesShare + (1.0 - DistancesShare) * done))
    {
      return Status::Abort();
    }
    if (!mesh.IsDropped(f))
    {
      cells.Cut(f);
    }
  }
  diagram.CurveOffsets.push_back(0);
  std::vector<BorderPiece> pieces = cells.TakePieces();
  JoinBorderPieces(pieces, diagram);
  return status;
}
}

Status ComputeVoronoi(const GraphSearch& search, const SurfaceMesh& mesh,
  const std::vector<GraphSeed>& seeds, const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  diagram = VoronoiDiagram();
  const Status status = Fill(search, mesh, seeds, progress, diagram);
  if (!status.IsOk())
  {
    diagram = VoronoiDiagram();
  }
  return status;
}
}
