// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVoronoiTask.h"

#include "dggDistanceMethods.h"
#include "dggDistanceOutput.h"
#include "dggExactGeodesics.h"
#include "dggGraphSession.h"
#include "dggMeshQuality.h"
#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggPropagationSession.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"
#include "dggSurfaceOutput.h"
#include "dggWindowCells.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Progress weight of moving the sites, after the graph.
constexpr double MovingShare = 0.9;
/// Progress weights of the first of two attempts, and of exact distances in exact cells.
constexpr double FirstShare = 0.5;
constexpr double ExactShare = 0.5;
/// Largest distance of segments from exact borders, in mean edges times the accuracy, and in mean
/// edges.
constexpr double ChordShare = 0.01;
constexpr double LargestChord = 2.5e-4;

/// Returns true if there are neither cells nor borders.
bool HasLabelsOnly(const TaskContext& context, const VoronoiOptions& options)
{
  return options.LabelsOnly || options.IsPreview || context.Surface.IsCloud();
}

/// Moves the sites to the centers of their cells.
Status MoveSites(const TaskContext& context, GraphSession& graph, const VoronoiOptions& options,
  const ProgressCallback& progress, VoronoiResult& result)
{
  const PreparedSurface& surface = context.Surface;
  std::vector<SurfacePoint> places = GetPoints(result.Sites);
  CentroidalOptions moving = options.Moving;
  moving.Progress = progress;
  DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context));
  DGG_RETURN_IF_ERROR(surface.IsCloud()
      ? MoveToCloudCenters(
          graph.GetSearch(), surface.GetPositions(), moving, places, result.Energies)
      : MoveToCenters(graph.GetSearch(), surface.GetMesh(), graph.GetBuilder(),
          graph.GetLinkAccuracy(), moving, places, result.Energies));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.Sites[i].Point = places[i];
  }
  return Status::Success();
}

/// Computes the diagram of exact distances, and sets `isDone` to true if this succeeds. Otherwise
/// keeps the diagram of the result and sets its warning. Fails only if aborted.
Status FindExactCells(const TaskContext& context, double accuracy, const ProgressCallback& progress,
  VoronoiResult& result, bool& isDone)
{
  TaskContext exact = context;
  exact.Progress = ProgressPart(progress, 0.0, ExactShare);
  DistanceTask task{ {}, result.Sites };
  Status status = FindExactDistances(exact, ExactEngine::Triangle, true, task);
  VoronoiDiagram diagram;
  if (status.IsOk())
  {
    const SurfaceMesh& mesh = context.Surface.GetMesh();
    const DistanceField field{ &mesh, task.Distances.data(), &task.Windows, nullptr,
      task.NearestSource.data() };
    status = ComputeWindowCells(field,
      std::min(LargestChord, ChordShare * accuracy) * mesh.GetMeanEdgeLength(), context.Parallel,
      ProgressPart(progress, ExactShare, 1.0), diagram);
  }
  isDone = status.IsOk();
  if (isDone)
  {
    result.Diagram = std::move(diagram);
  }
  else
  {
    result.QualityWarning = DescribeMissingWindows(
      context.Surface, accuracy, result.Diagram.Distances, ErrorAtBorders, status);
  }
  return status.IsAborted() ? status : Status::Success();
}

/// Makes the outputs of a diagram.
class VoronoiWriter
{
public:
  VoronoiWriter(const TaskContext& context, const VoronoiOptions& options,
    const VoronoiResult& result, const std::vector<double>& areas)
    : Context(context)
    , Options(options)
    , Result(result)
    , Areas(areas)
    , Diagram(result.Diagram)
    , NumberOfVertices(static_cast<Id>(result.Diagram.Distances.size()))
  {
  }

  /// Adds the arrays of labels, distances and energies.
  void WriteSurface(Output& output) const
  {
    const std::vector<Id> nearest = GetNearestSites(this->Context, this->Result);
    std::vector<Id> points(nearest.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i] = this->Context.Surface.GetVertex(static_cast<Offset>(i));
    }
    this->WriteDistances(points, false, output);
    std::int32_t* const sites =
      output.PointData.Add<std::int32_t>(this->Options.SourceName, nearest.size());
    std::copy(nearest.begin(), nearest.end(), sites);
    output.PointScalars = this->Options.SourceName;
    if (!this->Result.Energies.empty())
    {
      double* const energies = output.FieldData.Add<double>("Energy", this->Result.Energies.size());
      std::copy(this->Result.Energies.begin(), this->Result.Energies.end(), energies);
    }
  }

  void WriteBorders(Output& output) const
  {
    const std::vector<Id> used = ListUsed(this->Diagram.CurvePoints);
    this->WritePoints(used, false, output);
    const std::size_t count = this->Diagram.GetNumberOfCurves();
    output.Lines.Offsets = Buffer<Offset>(count + 1);
    output.Lines.Points = Buffer<Offset>(this->Diagram.CurvePoints.size());
    output.Lines.Offsets[0] = 0;
    std::copy(this->Diagram.CurveOffsets.begin(), this->Diagram.CurveOffsets.end(),
      output.Lines.Offsets.begin());
    std::transform(this->Diagram.CurvePoints.begin(), this->Diagram.CurvePoints.end(),
      output.Lines.Points.begin(), [&](Id point) { return IndexIn(used, point); });
    std::int32_t* const sites = output.CellData.Add<std::int32_t>("SiteId", count, 2);
    for (std::size_t k = 0; k < count; ++k)
    {
      sites[2 * k] = this->Diagram.CurveSites[k][0];
      sites[2 * k + 1] = this->Diagram.CurveSites[k][1];
    }
  }

  /// Writes polygons with the listed points, in ascending order.
  void WriteCells(const std::vector<Id>& points, bool areOthersUnreached, Output& output) const
  {
    this->WritePoints(points, areOthersUnreached, output);
    const std::size_t count = this->Diagram.GetNumberOfPolygons();
    output.Polygons.Offsets = Buffer<Offset>(count + 1);
    output.Polygons.Points = Buffer<Offset>(this->Diagram.PolygonPoints.size());
    output.Polygons.Offsets[0] = 0;
    std::int32_t* const sites = output.CellData.Add<std::int32_t>("SiteId", count);
    double* const cellAreas = output.CellData.Add<double>("CellArea", count);
    Offset* const faces = output.CellData.Add<Offset>("FaceId", count);
    for (std::size_t k = 0; k < count; ++k)
    {
      const Id* const begin = this->Diagram.PolygonPoints.data() + this->Diagram.PolygonOffsets[k];
      const Id* const end =
        this->Diagram.PolygonPoints.data() + this->Diagram.PolygonOffsets[k + 1];
      Offset* const corners = output.Polygons.Points.Data() + this->Diagram.PolygonOffsets[k];
      const Id face = this->Diagram.PolygonFaces[k];
      if (this->Context.Surface.GetMesh().IsFlipped(face))
      {
        std::reverse_copy(begin, end, corners); // same orientation as in the input
      }
      else
      {
        std::copy(begin, end, corners);
      }
      output.Polygons.Offsets[k + 1] = this->Diagram.PolygonOffsets[k + 1];
      if (points.size() < this->GetNumberOfPoints())
      {
        std::transform(corners, corners + (end - begin), corners,
          [&](Offset point) { return IndexIn(points, static_cast<Id>(point)); });
      }
      sites[k] = this->Diagram.PolygonSites[k];
      cellAreas[k] = sites[k] == NoId ? this->Areas.back() : this->Areas[sites[k]];
      faces[k] = GetOriginalCell(this->Context.Surface, face);
    }
    output.CellScalars = "SiteId";
  }

  std::size_t GetNumberOfPoints() const
  {
    return this->Diagram.Distances.size() + this->Diagram.BorderPoints.size();
  }

  /// Returns the points in a list, ascending, each once.
  static std::vector<Id> ListUsed(std::vector<Id> points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

private:
  SurfacePoint GetPlace(Id point) const
  {
    return point < this->NumberOfVertices
      ? SurfacePoint::AtVertex(point)
      : this->Diagram.BorderPoints[point - this->NumberOfVertices];
  }

  static Offset IndexIn(const std::vector<Id>& used, Id point)
  {
    return std::lower_bound(used.begin(), used.end(), point) - used.begin();
  }

  /// Writes positions and distances of points of the diagram.
  void WritePoints(const std::vector<Id>& points, bool areOthersUnreached, Output& output) const
  {
    std::vector<SurfacePoint> places;
    places.reserve(points.size());
    for (const Id point : points)
    {
      places.push_back(this->GetPlace(point));
    }
    WritePositions(this->Context.Surface, places, output);
    this->WriteDistances(points, areOthersUnreached, output);
  }

  void WriteDistances(const std::vector<Id>& points, bool areOthersUnreached, Output& output) const
  {
    std::vector<double> distances;
    distances.reserve(points.size());
    for (const Id point : points)
    {
      distances.push_back(point < this->NumberOfVertices
          ? this->Diagram.Distances[point]
          : this->Diagram.BorderDistances[point - this->NumberOfVertices]);
    }
    AddDistances(this->Options.DistanceName, distances, this->Options.UnreachedValue,
      output.PointData, areOthersUnreached);
  }

  const TaskContext& Context;
  const VoronoiOptions& Options;
  const VoronoiResult& Result;
  const std::vector<double>& Areas;
  const VoronoiDiagram& Diagram;
  Id NumberOfVertices;
};
}

//------------------------------------------------------------------------------
Status VoronoiOptions::Check() const
{
  DGG_RETURN_IF_ERROR(CheckLengths({ { "Tolerance", this->Moving.Tolerance } }));
  if (this->Moving.NumberOfIterations < 0)
  {
    return InvalidValue("NumberOfIterations", this->Moving.NumberOfIterations)
      .Fix("Use a number of at least 0");
  }
  DGG_RETURN_IF_ERROR(CheckNames(
    { { "DistanceArrayName", this->DistanceName }, { "SourceArrayName", this->SourceName } }));
  return this->IsPreview && this->IsCentroidal ? InvalidInput("{Preview} does not move sites")
                                                   .At("Preview")
                                                   .Fix("Turn off {Preview} or {Centroidal}")
                                               : Status::Success();
}

//------------------------------------------------------------------------------
Status FindVoronoiCells(const TaskContext& context, GraphSession& graph,
  const VoronoiOptions& options, VoronoiResult& result)
{
  const ProgressCallback progress = graph.GetRemainingProgress(context);
  if (options.IsCentroidal)
  {
    DGG_RETURN_IF_ERROR(
      MoveSites(context, graph, options, ProgressPart(progress, 0.0, MovingShare), result));
  }
  const ProgressCallback rest =
    ProgressPart(progress, options.IsCentroidal ? MovingShare : 0.0, 1.0);
  VoronoiInput input;
  input.LabelsOnly = HasLabelsOnly(context, options);
  const bool isRefined = options.IsRefined && !input.LabelsOnly;
  const bool isLong = isRefined && HasLongTriangles(context.Surface);
  const double accuracy = graph.GetLinkAccuracy();
  bool isDone = false;
  if (isLong)
  {
    DGG_RETURN_IF_ERROR(
      FindExactCells(context, accuracy, ProgressPart(rest, 0.0, FirstShare), result, isDone));
  }
  if (isDone)
  {
    return ReportTo(rest, 1.0);
  }
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, result.Sites, input.Seeds));
  if (isRefined)
  {
    DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context));
    input.Builder = &graph.GetBuilder();
    input.Accuracy = accuracy;
  }
  input.Places = GetPoints(result.Sites);
  const double begin = isLong ? FirstShare : 0.0;
  DGG_RETURN_IF_ERROR(ComputeVoronoi(graph.GetSearch(), context.Surface.GetMesh(), input,
    ProgressPart(rest, begin, isRefined ? FirstShare + begin : 1.0), result.Diagram));
  if (isRefined && !isLong &&
    (result.Diagram.AreBordersWrong ||
      HasCoarseTriangles(context.Surface, accuracy, result.Diagram.Distances, ErrorAtBorders)))
  {
    DGG_RETURN_IF_ERROR(
      FindExactCells(context, accuracy, ProgressPart(rest, FirstShare, 1.0), result, isDone));
  }
  return ReportTo(rest, 1.0);
}

//------------------------------------------------------------------------------
Status FindVoronoiPreview(
  const TaskContext& context, PropagationSession& session, VoronoiResult& result)
{
  if (context.Surface.IsCloud())
  {
    return InvalidInput("{Preview} needs a surface, but the input is a point cloud")
      .At("Preview")
      .Fix("Turn off {Preview}");
  }
  PropagationOptions options;
  options.Quality = PropagationSession::Choose(context.Surface);
  options.WantNearestSource = true;
  PropagationResult found;
  DGG_RETURN_IF_ERROR(
    session.Run(context, result.Sites, options, found).Of("{Preview}, which can be turned off"));
  result.QualityWarning = JoinReasons({ DescribeLongTriangles(context.Surface,
                                          "cells of {Preview} may be wrong. Turn off {Preview}, or "
                                          "remesh the surface"),
    found.IsSettled ? ""
                    : "Distances of {Preview} did not settle on triangles this irregular, so "
                      "cells may be wrong. Turn off {Preview}" });
  result.Diagram.NearestSites = std::move(found.NearestSource);
  result.Diagram.Distances = std::move(found.Distances);
  return Status::Success();
}

//------------------------------------------------------------------------------
std::vector<Id> GetNearestSites(const TaskContext& context, const VoronoiResult& result)
{
  std::vector<Id> nearest(result.Diagram.NearestSites.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    nearest[i] = result.Diagram.NearestSites[context.Surface.GetVertex(static_cast<Offset>(i))];
  }
  return nearest;
}

//------------------------------------------------------------------------------
void WriteVoronoi(const TaskContext& context, const VoronoiOptions& options,
  const VoronoiResult& result, Output& surface, Output& borders, Output& cells, Output& sites)
{
  const std::vector<double> areas = SumCellAreas(result.Diagram, result.Sites.size());
  const VoronoiWriter writer(context, options, result, areas);
  writer.WriteSurface(surface);
  WriteSurfacePoints(context, GetPoints(result.Sites), sites);
  AddSiteIds(sites);
  if (!HasLabelsOnly(context, options))
  {
    std::vector<Id> points(writer.GetNumberOfPoints());
    std::iota(points.begin(), points.end(), 0);
    writer.WriteBorders(borders);
    writer.WriteCells(points, false, cells);
    AddCellAreas(areas, sites);
  }
}

//------------------------------------------------------------------------------
void WriteVoronoiPiece(const TaskContext& context, const VoronoiOptions& options,
  const VoronoiResult& result, const std::vector<double>& areas, bool areOthersUnreached,
  Output& borders, Output& cells)
{
  const VoronoiWriter writer(context, options, result, areas);
  writer.WriteBorders(borders);
  writer.WriteCells(
    VoronoiWriter::ListUsed(result.Diagram.PolygonPoints), areOthersUnreached, cells);
}

//------------------------------------------------------------------------------
std::vector<double> SumCellAreas(const VoronoiDiagram& diagram, std::size_t numberOfSites)
{
  std::vector<double> areas(numberOfSites + 1, 0.0);
  for (std::size_t i = 0; i < diagram.GetNumberOfPolygons(); ++i)
  {
    const Id site = diagram.PolygonSites[i];
    (site == NoId ? areas.back() : areas[site]) += diagram.PolygonAreas[i];
  }
  return areas;
}

//------------------------------------------------------------------------------
void AddSiteIds(Output& sites)
{
  const std::size_t count = sites.Points.Size() / 3;
  std::int32_t* const ids = sites.PointData.Add<std::int32_t>("SiteId", count);
  std::iota(ids, ids + count, 0);
}

//------------------------------------------------------------------------------
void AddCellAreas(const std::vector<double>& areas, Output& sites)
{
  const std::size_t count = sites.Points.Size() / 3;
  std::copy_n(areas.begin(), count, sites.PointData.Add<double>("CellArea", count));
}
}
