// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphBuildTask.h"

#include "dggInvalidInput.h"
#include "dggPreparedSurface.h"
#include "dggTaskContext.h"
#include "dggUnfoldingTable.h"

#include <algorithm>

namespace dgg
{
namespace
{
Status TooMuchMemory(const GraphOptions& options, const GraphEstimate& estimate, double limit)
{
  return InvalidInput("the graph would take about ", FormatBytes(estimate.Memory), ", and ",
    FormatBytes(estimate.Peak), " while it is built, more than the limit of ", FormatBytes(limit),
    ": ",
    options.Construction == GraphConstruction::SaddleVertexGraph
      ? JoinText("use a smaller NumberOfNeighbors (it is ", options.NumberOfNeighbors, ")")
      : JoinText("use a larger Accuracy (it is ", options.Accuracy, ")"),
    ", or a higher MemoryLimit");
}
}

void UseThreads(const TaskContext& context, GraphOptions& options)
{
  options.Parallel = context.Parallel;
  options.NumberOfThreads = context.NumberOfThreads;
}

Status BuildGraph(const TaskContext& context, const GraphBuilder& builder, GraphOptions options,
  GeodesicGraph& graph, GraphEstimate& estimate)
{
  UseThreads(context, options);
  DGG_RETURN_IF_ERROR(builder.Estimate(options, estimate));
  const double limit = context.Memory.GetBytes();
  if (std::max(estimate.Peak, estimate.Memory) > limit)
  {
    return TooMuchMemory(options, estimate, limit);
  }
  const Status status = builder.Build(options, graph);
  graph.Info.Surface = context.Surface.GetSignature();
  return status;
}

std::size_t EstimateBuilder(const PreparedSurface& surface)
{
  // The table of face crossings, twice if faces cannot be oriented consistently.
  const MeshReport& report = surface.GetReport();
  const std::size_t perHalfEdge = sizeof(FaceCrossing) + sizeof(double);
  const std::size_t copies = report.InconsistentEdges + report.NonManifoldEdges > 0 ? 2 : 1;
  const std::size_t perVertex = 2 * sizeof(double) + 2 * sizeof(Id);
  return static_cast<std::size_t>(report.Faces) * (3 * copies * perHalfEdge + sizeof(Id)) +
    static_cast<std::size_t>(report.Vertices) * perVertex;
}
}
