// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphBuildTask.h"

#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggStatus.h"
#include "dggTaskContext.h"
#include "dggUnfoldingTable.h"

#include <algorithm>

namespace dgg
{
namespace
{
Status TooMuchMemory(const GraphOptions& options, const GraphEstimate& estimate, double limit)
{
  return Status(Status::Code::OutOfMemory,
    JoinText("The graph needs about ", FormatBytes(estimate.Memory), ", and ",
      FormatBytes(estimate.Peak), " while it is built, more than the limit of ",
      FormatBytes(limit)))
    .At("MemoryLimit")
    .Fix(options.Construction == GraphConstruction::SaddleVertexGraph
        ? JoinText("Use a smaller {NumberOfNeighbors} (now ", options.NumberOfNeighbors, ")")
        : JoinText("Use a larger {Accuracy} (now ", options.Accuracy, ")"),
      ", or raise {MemoryLimit}");
}
}

void UseThreads(const TaskContext& context, GraphOptions& options)
{
  options.Parallel = context.Parallel;
  options.NumberOfThreads = context.NumberOfThreads;
}

std::string DescribeReplacement(const std::string& problem, const GraphOptions& options)
{
  const std::string parameter = options.Construction == GraphConstruction::SaddleVertexGraph
    ? JoinText("{NumberOfNeighbors} ", options.NumberOfNeighbors)
    : JoinText("{Accuracy} ", options.Accuracy);
  return problem + ". A graph with " + parameter + " replaces it";
}

std::string DescribeAccuracy(const GraphInfo& graph, double accuracy, bool canAccept)
{
  if (graph.IsGuaranteed() && graph.Accuracy <= accuracy)
  {
    return std::string();
  }
  return JoinText("The graph {InArrays} ",
    graph.IsGuaranteed() ? JoinText("has the accuracy ", graph.Accuracy) : "guarantees no accuracy",
    ", but {Accuracy} is ", accuracy, ". Build a graph with this {Accuracy}",
    canAccept ? ", remove the graph, or turn on {AcceptCoarserGraph}" : ", or remove the graph");
}

Status RequireCloudGraph(const std::string& problem)
{
  return InvalidInput(problem).Fix("Compute the graph of these points with vtkPointCloudDGG");
}

Status CheckGraphMemory(double limit, const GraphOptions& options, const GraphEstimate& estimate)
{
  return std::max(estimate.Peak, estimate.Memory) > limit ? TooMuchMemory(options, estimate, limit)
                                                          : Status::Success();
}

Status BuildGraph(const TaskContext& context, const GraphBuilder& builder, GraphOptions options,
  GeodesicGraph& graph, GraphEstimate& estimate)
{
  UseThreads(context, options);
  DGG_RETURN_IF_ERROR(builder.Estimate(options, estimate));
  DGG_RETURN_IF_ERROR(CheckGraphMemory(context.Memory.GetBytes(), options, estimate));
  const Status status = builder.Build(options, graph);
  graph.Info.Surface = context.Surface.GetSignature();
  return status;
}

std::size_t EstimateBuilder(const PreparedSurface& surface)
{
  // All face crossings, twice if faces cannot be oriented consistently. Few links need fewer.
  const MeshReport& report = surface.GetReport();
  const std::size_t perHalfEdge = sizeof(FaceCrossing) + sizeof(double);
  const std::size_t copies = report.InconsistentEdges + report.NonManifoldEdges > 0 ? 2 : 1;
  const std::size_t perVertex = sizeof(float) + 2 * sizeof(Id);
  return static_cast<std::size_t>(report.Faces) * (3 * copies * perHalfEdge + sizeof(Id)) +
    static_cast<std::size_t>(report.Vertices) * perVertex;
}

Status WriteGraphLines(const TaskContext& context, const GraphView& graph,
  const ProgressCallback& progress, Output& output)
{
  constexpr Id rowsInBlock = 4096; // rows between two reports of progress
  std::size_t count = 0;           // not half of the edges if the graph was altered
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    count += std::count_if(graph.Targets + graph.Offsets[v], graph.Targets + graph.Offsets[v + 1],
      [v](Id target) { return v < target; });
  }
  DGG_RETURN_IF_ERROR(context.Memory.Check("The output of the edges as lines",
    static_cast<double>(count) * (3.0 * sizeof(Offset) + sizeof(double)),
    "Turn off {GenerateGraphLines}"));
  output.Lines.Offsets = Buffer<Offset>(count + 1);
  output.Lines.Points = Buffer<Offset>(2 * count);
  double* const lengths = output.CellData.Add<double>("Length", count);
  output.CellScalars = "Length";
  std::size_t line = 0;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (v % rowsInBlock == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(v) / graph.NumberOfVertices));
    }
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      if (v < graph.Targets[e])
      {
        output.Lines.Offsets[line] = static_cast<Offset>(2 * line);
        output.Lines.Points[2 * line] = v;
        output.Lines.Points[2 * line + 1] = graph.Targets[e];
        lengths[line++] = graph.Length(e);
      }
    }
  }
  output.Lines.Offsets[count] = static_cast<Offset>(2 * count);
  return Status::Success();
}
}
