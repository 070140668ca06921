// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphBuilder.h"

#include "dggDirectionUnion.h"
#include "dggGraphAssembly.h"
#include "dggGraphPruning.h"
#include "dggGraphRules.h"
#include "dggGraphWindowTracer.h"
#include "dggProgressPart.h"
#include "dggRowFinder.h"
#include "dggStatus.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace dgg
{
namespace
{
/// Measured progress weights of the steps.
struct ShareOfSteps
{
  double Rows;
  double Pruning;
};
ShareOfSteps SharesOf(GraphConstruction construction)
{
  return construction == GraphConstruction::Indirect ? ShareOfSteps{ 0.6, 0.37 }
                                                     : ShareOfSteps{ 0.9, 0.0 };
}
}

class GraphBuilder::Implementation
{
public:
  Implementation(const SurfaceMesh& mesh, std::size_t windowLimit)
    : Mesh(mesh)
    , Finder(mesh, windowLimit)
  {
  }
  Implementation(const SurfaceMesh& mesh, const GraphRegion& region)
    : Mesh(mesh)
    , Finder(mesh, region)
  {
  }

  Status Build(
    const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const;
  Status Link(const SurfacePoint& point, const GraphOptions& options,
    const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
    std::vector<double>& direct, std::size_t& work, bool& meetsRim) const;

  const SurfaceMesh& Mesh;
  RowFinder Finder;
  mutable WorkspacePool<GraphWindowTracer<ProgressRule>> Linkers;
};

//------------------------------------------------------------------------------
GraphBuilder::GraphBuilder(const SurfaceMesh& mesh, std::size_t windowLimit)
  : Internals(std::make_unique<Implementation>(mesh, windowLimit))
{
}

GraphBuilder::GraphBuilder(const SurfaceMesh& mesh, const GraphRegion& region)
  : Internals(std::make_unique<Implementation>(mesh, region))
{
}

GraphBuilder::~GraphBuilder() = default;

GraphOptions MakeOptions(const GraphInfo& graph)
{
  GraphOptions options;
  options.Construction = graph.Construction;
  options.Accuracy = graph.Accuracy;
  options.NumberOfNeighbors = graph.NumberOfNeighbors;
  return options;
}

bool IsBuiltWith(const GraphInfo& graph, const GraphOptions& options)
{
  const bool hasAccuracy = options.Construction != GraphConstruction::SaddleVertexGraph;
  return graph.Construction == options.Construction &&
    (hasAccuracy ? graph.Accuracy == options.Accuracy
                 : graph.NumberOfNeighbors == options.NumberOfNeighbors);
}

Status GraphBuilder::Check(const GraphOptions& options)
{
  if (options.Construction > GraphConstruction::SaddleVertexGraph)
  {
    return InvalidInput("{Construction} is a construction of point clouds")
      .At("Construction")
      .Fix("Choose a construction of meshes");
  }
  if (options.Construction == GraphConstruction::SaddleVertexGraph)
  {
    if (options.NumberOfNeighbors < 1)
    {
      return InvalidValue("NumberOfNeighbors", options.NumberOfNeighbors)
        .Fix("Use a number of at least 1");
    }
  }
  else if (!(options.Accuracy >= MinimumAccuracy && options.Accuracy <= MaximumAccuracy))
  {
    return InvalidValue("Accuracy", options.Accuracy)
      .Fix("Use a number from ", MinimumAccuracy, " to ", MaximumAccuracy);
  }
  return Status::Success();
}

Status GraphBuilder::Estimate(const GraphOptions& options, GraphEstimate& estimate) const
{
  estimate = GraphEstimate();
  DGG_RETURN_IF_ERROR(Check(options));
  return this->Internals->Finder.Estimate(options, estimate);
}

Status GraphBuilder::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics* statistics) const
{
  graph = GeodesicGraph();
  GraphStatistics unused;
  GraphStatistics& wanted = statistics ? *statistics : unused;
  wanted = GraphStatistics();
  DGG_RETURN_IF_ERROR(Check(options));
  Status status = this->Internals->Build(options, graph, wanted);
  if (!status.IsOk())
  {
    graph = GeodesicGraph();
  }
  return status;
}

Status GraphBuilder::Link(const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct, std::size_t* work, bool* meetsRim) const
{
  std::size_t unused = 0;
  bool unusedRim = false;
  links.clear();
  direct.clear();
  GraphOptions options;
  options.Accuracy = accuracy;
  DGG_RETURN_IF_ERROR(Check(options));
  Status status = this->Internals->Link(point, options, targets, links, direct,
    work ? *work : unused, meetsRim ? *meetsRim : unusedRim);
  if (!status.IsOk())
  {
    links.clear();
    direct.clear();
  }
  return status;
}

//------------------------------------------------------------------------------
Status GraphBuilder::Implementation::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const
{
  const UnfoldingTable& table = this->Finder.GetTable();
  DGG_RETURN_IF_ERROR(table.Check());
  const bool wide = this->Finder.NeedsWide(options);
  const bool isIndirect = options.Construction == GraphConstruction::Indirect;
  const ShareOfSteps shares = SharesOf(options.Construction);
  RowStore rows(wide);
  rows.ReserveRows(table.GetNumberOfVertices());
  DirectionUnion directions(table.GetOrder());
  GraphOptions forRows = options;
  forRows.Progress = ProgressPart(options.Progress, 0.0, shares.Rows);
  DGG_RETURN_IF_ERROR(
    this->Finder.Find(forRows, statistics, [&](const std::vector<RowBlock>& blocks, Id first) {
      for (const RowBlock& block : blocks)
      {
        const RowEdge* next = block.Edges.data();
        for (const std::size_t size : block.Sizes)
        {
          rows.AppendRow(next, next + size);
          next += size;
        }
      }
      if (!isIndirect)
      {
        directions.Unite(rows, first, options.Parallel);
      }
    }));
  if (isIndirect)
  {
    DGG_RETURN_IF_ERROR(PruneCandidates(rows, options.Accuracy, options.Parallel,
      ProgressPart(options.Progress, shares.Rows, shares.Rows + shares.Pruning)));
    directions.Unite(rows, 0, options.Parallel);
  }
  const double done = shares.Rows + shares.Pruning;
  DGG_RETURN_IF_ERROR(AssembleGraph(rows, table.GetOrder(), wide, options.Parallel,
    ProgressPart(options.Progress, done, 1.0), graph));
  graph.Info.Kind = GraphKind::Mesh;
  graph.Info.Construction = options.Construction;
  const bool isByNumber = options.Construction == GraphConstruction::SaddleVertexGraph;
  graph.Info.Accuracy = isByNumber ? 0.0 : options.Accuracy;
  graph.Info.NumberOfNeighbors = isByNumber ? options.NumberOfNeighbors : 0;
  return Status::Success();
}

Status GraphBuilder::Implementation::Link(const SurfacePoint& point, const GraphOptions& options,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct, std::size_t& work, bool& meetsRim) const
{
  const UnfoldingTable& table = this->Finder.GetTable();
  DGG_RETURN_IF_ERROR(table.Check());
  DGG_RETURN_IF_ERROR(point.Check(this->Mesh));
  for (const SurfacePoint& target : targets)
  {
    DGG_RETURN_IF_ERROR(target.Check(this->Mesh));
  }
  direct.assign(targets.size(), Infinity);
  if (point.On == SurfacePoint::Support::Vertex)
  {
    links.push_back({ point.Vertex, 0.0, 0.0, 0.0 });
    return Status::Success();
  }
  std::vector<std::pair<Id, std::array<double, 3>>> positions;
  ForEachFaceAround(
    this->Mesh, point, [&](Id f, const std::array<double, 3>& b) { positions.emplace_back(f, b); });
  std::vector<GraphWindowTarget> windowTargets;
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    if (targets[t].On != SurfacePoint::Support::Vertex)
    {
      ForEachFaceAround(this->Mesh, targets[t], [&](Id f, const std::array<double, 3>& b) {
        windowTargets.push_back({ f, t, b });
      });
    }
  }
  std::stable_sort(windowTargets.begin(), windowTargets.end(),
    [](const GraphWindowTarget& a, const GraphWindowTarget& b) { return a.Face < b.Face; });

  const ProgressRule rule(options.Accuracy);
  const auto tracer = this->Linkers.Borrow(
    std::ref(this->Finder.GetCrossings()), rule, this->Finder.LimitWindows(options));
  tracer->SetRule(rule);
  const std::vector<FoundEdge>& edges =
    tracer->TracePoint(positions, GraphWindowTargets(this->Mesh, windowTargets, direct));
  work += tracer->GetWork();
  meetsRim = tracer->HasReachedRim();
  if (tracer->ExceededLimit())
  {
    return this->Finder.LimitExceeded("the surface point", options);
  }
  for (const FoundEdge& edge : edges)
  {
    links.push_back({ table.OldVertex(edge.Target), edge.Length,
      table.StoredAngle(edge.Target, edge.ArrivalAngle(this->Finder.GetCrossings())),
      DepartureAngle(this->Mesh, point, edge) });
  }
  std::sort(links.begin(), links.end(),
    [](const GraphLink& a, const GraphLink& b) { return a.Vertex < b.Vertex; });
  return Status::Success();
}
}
