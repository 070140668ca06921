// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CandidateGraph.h"

#include "BenchmarkTools.h"
#include "dggCrossingBlocks.h"
#include "dggDirectionUnion.h"
#include "dggGraphAssembly.h"
#include "dggGraphBuilder.h"
#include "dggGraphPruning.h"
#include "dggGraphRules.h"
#include "dggGraphWindowTracer.h"
#include "dggRowStore.h"
#include "dggSurfaceOrder.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr dgg::Id PatchSize = 256;

/// Finds the candidates of each vertex, in the order of the table. Fails if a vertex has too many
/// windows.
dgg::Status FindCandidates(const dgg::UnfoldingTable& table, double accuracy, dgg::RowStore& rows)
{
  dgg::CrossingBlocks crossings(table);
  constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max() / 4; // avoids overflow
  dgg::GraphWindowTracer<dgg::CandidateRule> tracer(
    crossings, dgg::CandidateRule(accuracy), { dgg::DefaultWindowLimit, unlimited, unlimited });
  std::vector<dgg::RowEdge> row;
  for (dgg::Id source = 0; source < table.GetNumberOfVertices(); ++source)
  {
    row.clear();
    for (const dgg::FoundEdge& edge : tracer.TraceVertex(source))
    {
      row.push_back(
        { edge.Target, edge.Length, table.StoredAngle(source, edge.DepartureAngle(table.GetMesh())),
          table.StoredAngle(edge.Target, edge.ArrivalAngle(crossings)) });
    }
    if (tracer.ExceededLimit())
    {
      return dgg::InvalidInput("a vertex has too many windows");
    }
    rows.AppendRow(row.data(), row.data() + row.size());
  }
  return dgg::Status::Success();
}

void PruneAsPublished(dgg::RowStore& rows, double accuracy)
{
  const dgg::Id n = rows.GetNumberOfRows();
  std::vector<unsigned char> flags(static_cast<std::size_t>(rows.GetNumberOfEdges()), 0);
  std::vector<double> reach(static_cast<std::size_t>(n), dgg::Infinity);
  for (dgg::Id s = 0; s < n; ++s)
  {
    const auto forEachByRelay = [&](const auto& visit) {
      for (dgg::Offset i = rows.Begin(s); i < rows.End(s); ++i)
      {
        const dgg::Id r = rows.Target(i);
        for (dgg::Offset k = rows.Begin(r); k < rows.End(r); ++k)
        {
          visit(reach[rows.Target(k)], rows.Length(i) + rows.Length(k));
        }
      }
    };
    forEachByRelay([](double& best, double by) { best = std::min(best, by); });
    for (dgg::Offset i = rows.Begin(s); i < rows.End(s); ++i)
    {
      flags[i] = reach[rows.Target(i)] <= (1.0 + accuracy) * rows.Length(i);
    }
    forEachByRelay([](double& best, double) { best = dgg::Infinity; });
  }
  rows.Remove(0, flags);
}
}

dgg::Status BuildFromCandidates(const dgg::SurfaceMesh& mesh, double accuracy, PruningRule rule,
  dgg::GeodesicGraph& graph, CandidateStatistics& statistics)
{
  graph = dgg::GeodesicGraph();
  const dgg::UnfoldingTable table(mesh, dgg::ComputePatchOrder(mesh, PatchSize));
  DGG_RETURN_IF_ERROR(table.Check());
  const dgg::Id n = table.GetNumberOfVertices();
  const bool wide = dgg::NeedsWideLengths(accuracy);
  dgg::RowStore rows(wide);
  rows.ReserveRows(n);
  double start = CPUSeconds();
  DGG_RETURN_IF_ERROR(FindCandidates(table, accuracy, rows));
  statistics.FindingSeconds = CPUSeconds() - start;
  statistics.CandidatesPerVertex = static_cast<double>(rows.GetNumberOfEdges()) / n;
  start = CPUSeconds();
  if (rule == PruningRule::Progress)
  {
    DGG_RETURN_IF_ERROR(dgg::PruneCandidates(rows, accuracy, {}, {}));
  }
  else if (rule == PruningRule::Published)
  {
    PruneAsPublished(rows, accuracy);
  }
  statistics.PruningSeconds = CPUSeconds() - start;
  dgg::DirectionUnion(table.GetOrder()).Unite(rows, 0, {});
  DGG_RETURN_IF_ERROR(dgg::AssembleGraph(rows, table.GetOrder(), wide, {}, {}, graph));
  graph.Info.Construction = dgg::GraphConstruction::Indirect;
  graph.Info.Accuracy = accuracy;
  return dgg::Status::Success();
}
