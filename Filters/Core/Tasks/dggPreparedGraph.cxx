// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPreparedGraph.h"

#include "dggSharedTable.h"

#include <utility>

namespace dgg
{
namespace
{
/// The arrays, and the build number of the surface.
using GraphKey = std::pair<PreparedGraph::Key, std::uint64_t>;

SharedTable<GraphKey, PreparedGraph>& GetGraphsInUse()
{
  static SharedTable<GraphKey, PreparedGraph> graphs;
  return graphs;
}
}

PreparedGraph::PreparedGraph(const StoredGraph& graph, Key key, std::shared_ptr<const void> owner,
  const PreparedSurface& surface)
  : Graph(graph)
  , ArrayKey(std::move(key))
  , Owner(std::move(owner))
  , Surface(surface.shared_from_this())
  , Summary(graph.GetView())
  , Search(graph.GetView(), surface.IsCloud() ? nullptr : &surface.GetMesh())
{
}

PreparedGraph::Pointer PreparedGraph::Make(const StoredGraph& graph, const Key& key,
  const std::shared_ptr<const void>& owner, const PreparedSurface& surface)
{
  const GraphKey tableKey(key, surface.GetBuildNumber());
  Pointer prepared = GetGraphsInUse().Find(tableKey);
  return prepared ? prepared
                  : GetGraphsInUse().Add(
                      tableKey, std::make_shared<const PreparedGraph>(graph, key, owner, surface));
}
}
