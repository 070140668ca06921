// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A graph that tasks search. Internal.
#ifndef dggPreparedGraph_h
#define dggPreparedGraph_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggGraphSearch.h"     // for GraphSearch
#include "dggPreparedSurface.h" // for the surface
#include "dggStoredGraph.h"     // for the graph

#include <cstdint> // for keys
#include <memory>  // for sharing
#include <vector>  // for keys

namespace dgg
{
/// A stored graph with the data that searches need. The object is immutable, so that tasks that
/// search the same arrays on the same surface share it, from any thread.
class DGG_CORE_EXPORT PreparedGraph
{
public:
  using Pointer = std::shared_ptr<const PreparedGraph>;
  /// Identity of the arrays of a graph.
  using Key = std::vector<std::uintptr_t>;

  /// Returns the graph in use with these arrays and this surface, or else a new one. The graph
  /// keeps the surface and `owner`, which owns the arrays, alive.
  static Pointer Make(const StoredGraph& graph, const Key& key,
    const std::shared_ptr<const void>& owner, const PreparedSurface& surface);

  /// Only called by Make().
  PreparedGraph(const StoredGraph& graph, Key key, std::shared_ptr<const void> owner,
    const PreparedSurface& surface);

  /// Returns the same graph on an equal surface.
  Pointer MoveTo(const PreparedSurface& surface) const
  {
    return Make(this->Graph, this->ArrayKey, this->Owner, surface);
  }

  const StoredGraph& GetGraph() const { return this->Graph; }
  const PreparedSurface& GetSurface() const { return *this->Surface; }
  /// Returns the summary of the graph, which remains valid after its arrays are released.
  const GraphSummary& GetSummary() const { return this->Summary; }
  /// Returns the search, which users of landmarks must copy.
  const GraphSearch& GetSearch() const { return this->Search; }

private:
  StoredGraph Graph;
  Key ArrayKey;
  std::shared_ptr<const void> Owner;
  PreparedSurface::Pointer Surface;
  GraphSummary Summary;
  GraphSearch Search;
};
}

#endif
