// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphBuild.h"

#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"

#include <algorithm>
#include <sstream>

namespace
{
dgg::Status TooMuchMemory(
  const dgg::GraphOptions& options, const dgg::GraphEstimate& estimate, vtkTypeUInt64 limit)
{
  std::ostringstream message;
  message << "the graph would take about " << vtkDGGFormatBytes(estimate.Memory) << ", and "
          << vtkDGGFormatBytes(estimate.Peak) << " while it is built, more than the limit of "
          << vtkDGGFormatBytes(static_cast<double>(limit)) << ": ";
  if (options.Construction == dgg::GraphConstruction::SaddleVertexGraph)
  {
    message << "use a smaller NumberOfNeighbors (it is " << options.NumberOfNeighbors << ")";
  }
  else
  {
    message << "use a larger Accuracy (it is " << options.Accuracy << ")";
  }
  message << ", or a higher MemoryLimit";
  return dgg::Status::Invalid(message.str());
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGBuildGraph(const dgg::GraphBuilder& builder, const vtkDGGMeshAdapter& mesh,
  dgg::GraphOptions options, vtkTypeUInt64 memoryLimit, dgg::GeodesicGraph& graph,
  dgg::GraphEstimate& estimate)
{
  options.Parallel = vtkDGGMakeParallelFor();
  dgg::Status status = builder.Estimate(options, estimate);
  if (!status.IsOk())
  {
    return status;
  }
  const vtkTypeUInt64 limit = vtkDGGGetMemoryLimit(memoryLimit);
  if (std::max(estimate.Peak, estimate.Memory) > static_cast<double>(limit))
  {
    return TooMuchMemory(options, estimate, limit);
  }
  status = builder.Build(options, graph);
  graph.Info.Surface = mesh.GetSignature();
  return status;
}
