// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVoronoi.h"

#include "dggBorderCurves.h"
#include "dggBorderRefinement.h"
#include "dggEdgeCuts.h"
#include "dggFaceCells.h"
#include "dggProgressPart.h"
#include "dggSiteDistances.h"

#include <memory>
#include <utility>

namespace dgg
{
namespace
{
/// Progress after the distances, and then after the cuts of edges.
constexpr double DistancesDone = 0.4;
constexpr double CutsDone = 0.7;
/// Faces between two progress reports: some milliseconds.
constexpr Id ProgressInterval = 8192;

Status CheckSites(const VoronoiInput& input)
{
  const std::vector<GraphSeed>& seeds = input.Seeds;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    if (seeds[i].Source < 0 || seeds[i].InitialDistance != 0.0 || seeds[i].Distance < 0.0 ||
      (seeds[i].ArrivalAngle < 0.0 && seeds[i].Distance != 0.0))
    {
      return InvalidInput("Source ", i, " has no site index, or has an initial distance")
        .Fix("Give it a site and no initial distance");
    }
    if (input.Builder && seeds[i].Source >= static_cast<Offset>(input.Places.size()))
    {
      return InvalidInput("Source ", i, " belongs to a site without a position")
        .Fix("Pass the positions of all sites");
    }
  }
  return Status::Success();
}

/// Computes only the nearest site of each vertex.
Status FillLabels(const GraphSearch& search, const VoronoiInput& input,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  SearchOptions options;
  options.Correct = true;
  options.Progress = progress;
  SearchResult result;
  Status status = search.Run(input.Seeds, options, result);
  for (const Id seed : result.Seeds)
  {
    diagram.NearestSites.push_back(seed == NoId ? NoId : input.Seeds[seed].Source);
  }
  diagram.Distances = result.Corrected.empty() ? result.Distances : result.Corrected;
  return status;
}

/// Fails if a graph with too few edges reaches a vertex but not its neighbor: then the region
/// between them is undefined.
Status CheckNeighbors(const SurfaceMesh& mesh, const SiteDistances& distances)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id a = mesh.Origin(h);
    const Id b = mesh.Destination(h);
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) &&
      (distances.Nearest(a) == nullptr) != (distances.Nearest(b) == nullptr))
    {
      return InvalidInput("The graph does not connect the adjacent vertices ", a, " and ", b,
        ": it has too few edges for cells")
        .Fix("Set {Construction} to Guaranteed, or use a larger {NumberOfNeighbors}");
    }
  }
  return Status::Success();
}

/// Removes the polygons of faces outside of the piece.
void RemoveOtherPolygons(const std::uint8_t* layers, VoronoiDiagram& diagram)
{
  std::vector<Id> points;
  std::size_t size = 0;
  for (std::size_t i = 0; i < diagram.GetNumberOfPolygons(); ++i)
  {
    if (layers[diagram.PolygonFaces[i]] == 0)
    {
      points.insert(points.end(), diagram.PolygonPoints.begin() + diagram.PolygonOffsets[i],
        diagram.PolygonPoints.begin() + diagram.PolygonOffsets[i + 1]);
      diagram.PolygonSites[size] = diagram.PolygonSites[i];
      diagram.PolygonFaces[size] = diagram.PolygonFaces[i];
      diagram.PolygonAreas[size] = diagram.PolygonAreas[i];
      diagram.PolygonOffsets[++size] = static_cast<Offset>(points.size());
    }
  }
  diagram.PolygonPoints = std::move(points);
  diagram.PolygonOffsets.resize(size + 1);
  diagram.PolygonSites.resize(size);
  diagram.PolygonFaces.resize(size);
  diagram.PolygonAreas.resize(size);
}

Status Fill(const GraphSearch& search, const SurfaceMesh& mesh, const VoronoiInput& input,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  DGG_RETURN_IF_ERROR(CheckSites(input));
  if (input.LabelsOnly)
  {
    return FillLabels(search, input, progress, diagram);
  }
  SiteDistances distances;
  DGG_RETURN_IF_ERROR(
    distances.Run(search, mesh, input.Seeds, ProgressPart(progress, 0.0, DistancesDone)));
  std::unique_ptr<BorderRefinement> refinement;
  if (input.Builder && distances.HasVirtualSources())
  {
    refinement = std::make_unique<BorderRefinement>(
      mesh, distances, *input.Builder, input.Accuracy, input.Places);
  }
  return ComputeCells(mesh, distances, refinement.get(), nullptr,
    ProgressPart(progress, DistancesDone, 1.0), diagram);
}
}

Status ComputeCells(const SurfaceMesh& mesh, const SiteDistances& distances,
  const BorderRefinement* refinement, const std::uint8_t* layers, const ProgressCallback& progress,
  VoronoiDiagram& diagram)
{
  DGG_RETURN_IF_ERROR(CheckNeighbors(mesh, distances));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const SiteDistances::Entry* nearest = distances.Nearest(v);
    diagram.NearestSites.push_back(nearest ? nearest->Site : NoId);
    diagram.Distances.push_back(nearest ? nearest->Distance : Infinity);
  }
  EdgeCuts cuts(mesh, layers);
  DGG_RETURN_IF_ERROR(
    cuts.Run(distances, refinement, ProgressPart(progress, 0.0, CutsDone), diagram));
  FaceCells cells(mesh, distances, cuts, refinement, diagram);
  diagram.PolygonOffsets.push_back(0);
  const ProgressCallback rest = ProgressPart(progress, CutsDone, 1.0);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (f % ProgressInterval == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(rest, static_cast<double>(f) / mesh.GetNumberOfFaces()));
    }
    if (!mesh.IsDropped(f) && !(layers && layers[f] > 1))
    {
      cells.Cut(f);
    }
  }
  AddBorderCurves(layers, diagram);
  if (layers)
  {
    RemoveOtherPolygons(layers, diagram);
  }
  return Status::Success();
}

Status ComputeVoronoi(const GraphSearch& search, const SurfaceMesh& mesh, const VoronoiInput& input,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  diagram = VoronoiDiagram();
  Status status = Fill(search, mesh, input, progress, diagram);
  if (!status.IsOk())
  {
    diagram = VoronoiDiagram();
  }
  return status;
}
}
