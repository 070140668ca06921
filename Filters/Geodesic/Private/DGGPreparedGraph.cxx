// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPreparedGraph.h"

#include "DGGSharedTable.h"

#include <utility>

namespace
{
/// Arrays, and the time of the surface that they were found to fit.
using GraphKey = std::pair<DGGGraphArrays::Key, vtkMTimeType>;

/// The graphs that filters hold.
DGGSharedTable<GraphKey, DGGPreparedGraph>& GetGraphsInUse()
{
  static DGGSharedTable<GraphKey, DGGPreparedGraph> graphs;
  return graphs;
}
}

//------------------------------------------------------------------------------
DGGPreparedGraph::DGGPreparedGraph(const DGGGraphArrays& arrays, const DGGPreparedMesh& surface)
  : Arrays(arrays)
  , Surface(surface.shared_from_this())
  , Summary(arrays.GetView())
  , Search(arrays.GetView(), surface.IsCloud() ? nullptr : &surface.GetMesh())
{
}

//------------------------------------------------------------------------------
DGGPreparedGraph::Pointer DGGPreparedGraph::Make(
  const DGGGraphArrays& arrays, const DGGPreparedMesh& surface)
{
  const GraphKey key(arrays.GetKey(), surface.GetBuildTime());
  Pointer graph = GetGraphsInUse().Find(key);
  if (!graph)
  {
    graph = GetGraphsInUse().Add(key, std::make_shared<const DGGPreparedGraph>(arrays, surface));
  }
  return graph;
}
