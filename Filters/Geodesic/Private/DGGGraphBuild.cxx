// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphBuild.h"

#include "DGGContext.h"
#include "DGGFreeMemory.h"

#include "dggInvalidInput.h"
#include "dggMemoryLimit.h"
#include "dggPreparedSurface.h"
#include "dggUnfoldingTable.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
dgg::Status TooMuchMemory(
  const dgg::GraphOptions& options, const dgg::GraphEstimate& estimate, vtkTypeUInt64 limit)
{
  return dgg::InvalidInput("the graph would take about ", dgg::FormatBytes(estimate.Memory),
    ", and ", dgg::FormatBytes(estimate.Peak), " while it is built, more than the limit of ",
    dgg::FormatBytes(static_cast<double>(limit)), ": ",
    options.Construction == dgg::GraphConstruction::SaddleVertexGraph
      ? dgg::JoinText("use a smaller NumberOfNeighbors (it is ", options.NumberOfNeighbors, ")")
      : dgg::JoinText("use a larger Accuracy (it is ", options.Accuracy, ")"),
    ", or a higher MemoryLimit");
}
}

//------------------------------------------------------------------------------
void DGGUseThreads(const DGGContext& context, dgg::GraphOptions& options)
{
  options.Parallel = context.Parallel;
  options.NumberOfThreads = vtkSMPTools::GetEstimatedNumberOfThreads();
}

//------------------------------------------------------------------------------
dgg::Status DGGBuildGraph(const DGGContext& context, const dgg::GraphBuilder& builder,
  dgg::GraphOptions options, dgg::GeodesicGraph& graph, dgg::GraphEstimate& estimate)
{
  DGGUseThreads(context, options);
  DGG_RETURN_IF_ERROR(builder.Estimate(options, estimate));
  const vtkTypeUInt64 limit = DGGGetMemoryLimit(context.MemoryLimit);
  if (std::max(estimate.Peak, estimate.Memory) > static_cast<double>(limit))
  {
    return TooMuchMemory(options, estimate, limit);
  }
  const dgg::Status status = builder.Build(options, graph);
  graph.Info.Surface = context.Surface.GetSignature();
  return status;
}

//------------------------------------------------------------------------------
std::size_t DGGEstimateBuilder(const dgg::PreparedSurface& mesh)
{
  // The table of all crossings of faces; twice where faces cannot be oriented consistently.
  const dgg::MeshReport& report = mesh.GetReport();
  const std::size_t perHalfEdge = sizeof(dgg::FaceCrossing) + sizeof(double);
  const std::size_t copies = report.InconsistentEdges + report.NonManifoldEdges > 0 ? 2 : 1;
  const std::size_t perVertex = 2 * sizeof(double) + 2 * sizeof(dgg::Id);
  return static_cast<std::size_t>(report.Faces) * (3 * copies * perHalfEdge + sizeof(dgg::Id)) +
    static_cast<std::size_t>(report.Vertices) * perVertex;
}
