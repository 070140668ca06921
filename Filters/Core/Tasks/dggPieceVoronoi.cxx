// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceVoronoi.h"

#include "dggBorderRefinement.h"
#include "dggMeshQuality.h"
#include "dggPieceSites.h"
#include "dggPieceSurface.h"
#include "dggProgressPart.h"
#include "dggSourceCollection.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dgg
{
namespace
{
/// Layers of cells around a piece for the links of border points. Their number is doubled as long
/// as a link meets the rim.
constexpr int FirstLayers = 8;
/// Progress weight of distances.
constexpr double DistancesShare = 0.6;

/// Sums over pieces.
struct CellSums
{
  ReachedTriangles Reached;
  double Work = 0.0; // of links

  void Add(const CellSums& piece)
  {
    this->Reached.Add(piece.Reached);
    this->Work += piece.Work;
  }
};

/// Arrays at the points of the surface.
DistanceRequest MakeRequest(const VoronoiOptions& voronoi)
{
  DistanceRequest request;
  request.UnreachedValue = voronoi.UnreachedValue;
  request.WantNearestSource = true;
  request.Names = { voronoi.DistanceName, voronoi.SourceName, "" };
  return request;
}

/// Replaces areas in each piece by their sums.
Status ShareAreas(ProcessGroup& group, std::vector<double>& areas)
{
  std::vector<std::vector<double>> all;
  DGG_RETURN_IF_ERROR(group.ShareList(areas, all));
  std::fill(areas.begin(), areas.end(), 0.0);
  for (const std::vector<double>& ofPiece : all)
  {
    std::transform(areas.begin(), areas.end(), ofPiece.begin(), areas.begin(), std::plus<>());
  }
  return Status::Success();
}

/// Cells of the piece of this process.
class PieceCells
{
public:
  PieceCells(const TaskContext& context, ProcessGroup& group, const PieceVoronoiInput& input)
    : Context(context)
    , Group(group)
    , Input(input)
    , Surface(input.Surface)
    , IsRefined(input.Voronoi.IsRefined)
  {
  }

  /// Computes the diagram. For `isDone`, see FindPieceVoronoi().
  Status Find(bool& isDone)
  {
    isDone = !(this->IsRefined && this->Surface.HasLongTriangles());
    if (isDone)
    {
      DGG_RETURN_IF_ERROR(this->FindDistances(isDone));
    }
    int layers = FirstLayers;
    if (isDone && this->IsRefined && this->Surface.GetNumberOfLayers() < layers)
    {
      DGG_RETURN_IF_ERROR(this->Surface.Grow(
        this->Group, layers - this->Surface.GetNumberOfLayers(), this->GetMemorySize()));
    }
    for (bool isComplete = false; isDone && !isComplete; layers *= 2)
    {
      DGG_RETURN_IF_ERROR(this->CutFaces(isComplete, isDone));
      DGG_RETURN_IF_ERROR(this->Group.Require(isDone));
      DGG_RETURN_IF_ERROR(this->Group.Require(isComplete));
      if (isDone && !isComplete)
      {
        DGG_RETURN_IF_ERROR(this->Surface.Grow(this->Group, layers, this->GetMemorySize()));
      }
    }
    return Status::Success();
  }

  /// Writes everything except for sites, and finds the areas of all cells.
  Status Write(PieceVoronoiOutput& output, std::vector<double>& areas) const
  {
    const SourceCollection& sites = this->Input.Sites;
    const VoronoiDiagram& diagram = this->Result.Diagram;
    const Offset points = this->Input.Search.GetPointsHere();
    DistanceResults results;
    results.Distances = this->Surface.ToPiece(diagram.Distances, points, Infinity);
    results.NearestSource = this->Surface.ToPiece(diagram.NearestSites, points, NoId);
    DGG_RETURN_IF_ERROR(
      WritePieceDistances(this->Group, results, MakeRequest(this->Input.Voronoi), output.Labels));
    const std::string warning = sites.DescribeIsolated(this->Isolated, false);
    if (this->Group.Here == 0 && !warning.empty())
    {
      output.Labels.Warnings.push_back(warning);
    }
    areas = SumCellAreas(diagram, sites.Ids.size() + sites.GetNumberOfPositions());
    DGG_RETURN_IF_ERROR(ShareAreas(this->Group, areas));
    WriteVoronoiPiece(this->Surface.MakeContext(this->Context), this->Input.Voronoi, this->Result,
      areas, results.AreOthersUnreached, output.Borders, output.Cells);
    this->Surface.Renumber(output.Cells);
    return Status::Success();
  }

private:
  Status FindDistances(bool& isDone)
  {
    const PieceVoronoiInput& input = this->Input;
    std::vector<PieceSeed> seeds;
    DGG_RETURN_IF_ERROR(MakePieceSeeds(
      this->Group, input.Search, input.Links, input.Sites, input.Options, seeds, this->Isolated));
    std::vector<GraphSeed> ofSites;
    std::vector<Offset> points;
    for (const PieceSeed& seed : seeds)
    {
      ofSites.push_back(seed.Seed);
      points.push_back(seed.PointId);
    }
    std::vector<PieceSeed> kept;
    for (const std::size_t i : ListDistinctSeeds(ofSites, points))
    {
      kept.push_back(seeds[i]);
    }
    PieceSites finder(input.Search, this->Surface);
    return finder.Run(this->Group, kept, ProgressPart(this->Context.Progress, 0.0, DistancesShare),
      this->Entries, isDone);
  }

  /// Computes the diagram on the present surface. `isComplete` becomes false if links met the rim
  /// of the surface, and `isDone` if the diagram must not be used.
  Status CutFaces(bool& isComplete, bool& isDone)
  {
    PieceSites::Lists entries;
    DGG_RETURN_IF_ERROR(
      this->Surface.ExtendLists(this->Group, this->Entries, this->Input.Search.GetMemorySize(),
        [&](const auto* begin, const auto* end) { entries.Add(begin, end); }));
    SiteDistances distances;
    distances.Set(true, std::move(entries));
    const SurfaceMesh& mesh = this->Surface.Get().GetMesh();
    std::vector<SurfacePoint> sites;
    std::unique_ptr<BorderRefinement> refinement;
    if (this->IsRefined)
    {
      PiecePoints here;
      DGG_RETURN_IF_ERROR(
        this->Surface.Locate(this->Group, this->Input.Sites, this->Input.Options.Tolerance, here));
      DGG_RETURN_IF_ERROR(this->Surface.ShareAll(this->Group, here, sites));
      if (const GraphBuilder* builder = this->Surface.GetBuilder())
      {
        refinement = std::make_unique<BorderRefinement>(
          mesh, distances, *builder, this->Input.Options.Accuracy, sites);
        refinement->SetNumberOfFaces(this->Surface.GetTotalFaces());
      }
    }
    this->Result.Diagram = VoronoiDiagram();
    const Status status =
      ComputeCells(mesh, distances, refinement.get(), this->Surface.GetLayers().data(),
        ProgressPart(this->Context.Progress, DistancesShare, 1.0), this->Result.Diagram);
    DGG_RETURN_IF_ERROR(status.IsAborted() ? status : Status::Success());
    isComplete = !(refinement && refinement->HasMetRim());
    isDone = status.IsOk() && !this->Result.Diagram.AreBordersWrong;
    return this->IsRefined ? this->CheckBorders(refinement.get(), isDone) : Status::Success();
  }

  /// Returns an estimate of the size in bytes, without the surface.
  double GetMemorySize() const
  {
    return this->Input.Search.GetMemorySize() +
      static_cast<double>(this->Entries.Values.size() * sizeof(SiteDistances::Entry));
  }

  /// Makes `isDone` false if a single process would limit the work of links, or compute exact cells
  /// because of coarse triangles.
  Status CheckBorders(const BorderRefinement* refinement, bool& isDone)
  {
    const SurfaceMesh& mesh = this->Surface.Get().GetMeshWithoutAngles();
    CellSums sums;
    for (Id f = 0; f < mesh.GetNumberOfFaces() && isDone; ++f)
    {
      if (this->Surface.GetLayers()[f] == 0)
      {
        sums.Reached.Add(mesh, f, this->Result.Diagram.Distances);
      }
    }
    double limit = Infinity;
    if (refinement)
    {
      sums.Work = static_cast<double>(refinement->GetWork());
      limit = static_cast<double>(refinement->GetMostWork());
    }
    DGG_RETURN_IF_ERROR(this->Group.Sum(sums));
    isDone = isDone && sums.Work <= limit &&
      !sums.Reached.AreCoarse(this->Input.Options.Accuracy, (1.0 + SumMargin) * ErrorAtBorders);
    return Status::Success();
  }

  const TaskContext& Context;
  ProcessGroup& Group;
  const PieceVoronoiInput& Input;
  PieceSurface& Surface;
  bool IsRefined;
  std::vector<std::size_t> Isolated; // sites
  PieceSites::Lists Entries;         // per point of the piece, later of the region
  VoronoiResult Result;
};
}

Status FindPieceVoronoi(const TaskContext& context, ProcessGroup& group,
  const PieceVoronoiInput& input, PieceVoronoiOutput& output, bool& isDone)
{
  std::vector<double> areas;
  if (input.Voronoi.LabelsOnly)
  {
    DGG_RETURN_IF_ERROR(FindPieceDistances(context, group, input.Search, input.Links, nullptr,
      input.Sites, input.Options, MakeRequest(input.Voronoi), output.Labels, isDone));
  }
  else
  {
    PieceCells cells(context, group, input);
    DGG_RETURN_IF_ERROR(cells.Find(isDone));
    if (isDone)
    {
      DGG_RETURN_IF_ERROR(cells.Write(output, areas));
    }
  }
  if (!isDone)
  {
    return Status::Success();
  }
  output.Labels.PointScalars = input.Voronoi.SourceName;
  PiecePoints here;
  DGG_RETURN_IF_ERROR(input.Surface.Locate(group, input.Sites, input.Options.Tolerance, here));
  DGG_RETURN_IF_ERROR(input.Surface.WritePoints(context, group, here, output.Sites));
  AddSiteIds(output.Sites);
  if (!areas.empty())
  {
    AddCellAreas(areas, output.Sites);
  }
  return Status::Success();
}
}
