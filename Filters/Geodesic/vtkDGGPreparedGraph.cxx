// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPreparedGraph.h"

#include "vtkDGGSharedTable.h"

#include <utility>

namespace
{
/// Arrays, and the time of the surface that they were found to fit.
using GraphKey = std::pair<vtkDGGGraphArrays::Key, vtkMTimeType>;

/// The graphs that filters hold.
vtkDGGSharedTable<GraphKey, vtkDGGPreparedGraph>& GetGraphsInUse()
{
  static vtkDGGSharedTable<GraphKey, vtkDGGPreparedGraph> graphs;
  return graphs;
}
}

//------------------------------------------------------------------------------
vtkDGGPreparedGraph::vtkDGGPreparedGraph(
  const vtkDGGGraphArrays& arrays, const vtkDGGPreparedMesh& surface)
  : Arrays(arrays)
  , Surface(surface.shared_from_this())
  , Summary(arrays.GetView())
  , Search(arrays.GetView(), surface.IsCloud() ? nullptr : &surface.GetMesh())
{
}

//------------------------------------------------------------------------------
vtkDGGPreparedGraph::Pointer vtkDGGPreparedGraph::Make(
  const vtkDGGGraphArrays& arrays, const vtkDGGPreparedMesh& surface)
{
  const GraphKey key(arrays.GetKey(), surface.GetBuildTime());
  Pointer graph = GetGraphsInUse().Find(key);
  if (!graph)
  {
    graph = std::make_shared<const vtkDGGPreparedGraph>(arrays, surface);
    GetGraphsInUse().Add(key, graph);
  }
  return graph;
}
