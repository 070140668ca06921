// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPreparedGraph.h"

#include "dggSharedTable.h"

#include <utility>

namespace
{
/// Arrays, and the time of the surface that they were found to fit.
using GraphKey = std::pair<DGGGraphArrays::Key, std::uint64_t>;

/// The graphs that filters hold.
dgg::SharedTable<GraphKey, DGGPreparedGraph>& GetGraphsInUse()
{
  static dgg::SharedTable<GraphKey, DGGPreparedGraph> graphs;
  return graphs;
}
}

//------------------------------------------------------------------------------
DGGPreparedGraph::DGGPreparedGraph(
  const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface)
  : Arrays(arrays)
  , Surface(surface.shared_from_this())
  , Summary(arrays.GetView())
  , Search(arrays.GetView(), surface.IsCloud() ? nullptr : &surface.GetMesh())
{
}

//------------------------------------------------------------------------------
DGGPreparedGraph::Pointer DGGPreparedGraph::Make(
  const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface)
{
  const GraphKey key(arrays.GetKey(), surface.GetBuildNumber());
  Pointer graph = GetGraphsInUse().Find(key);
  if (!graph)
  {
    graph = GetGraphsInUse().Add(key, std::make_shared<const DGGPreparedGraph>(arrays, surface));
  }
  return graph;
}
