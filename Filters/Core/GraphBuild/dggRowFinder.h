// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the edges of a graph, row by row. Internal.
#ifndef dggRowFinder_h
#define dggRowFinder_h

#include "dggCrossingBlocks.h" // for the crossings
#include "dggGraphBuilder.h"   // for the options
#include "dggRowStore.h"       // for RowEdge
#include "dggUnfoldingTable.h" // for the order of the rows

#include <atomic>     // for the work of all threads
#include <cstddef>    // for std::size_t
#include <cstdint>    // for flags
#include <functional> // for the receiver of rows
#include <limits>     // for rows without edges
#include <optional>   // for temporary crossings
#include <string>     // for messages
#include <vector>     // for rows

namespace dgg
{
struct WindowLimits;

/// Surroundings of some vertices of a larger mesh, whose edges several finders find together.
struct GraphRegion
{
  std::vector<Id> Sources;         ///< vertices whose edges are found
  std::vector<std::uint8_t> IsRim; ///< per vertex; see SurfaceMesh::FromPoints()
  std::vector<Offset> PointIds;    ///< per vertex, its id in error messages
  Offset NumberOfFaces = 0;        ///< of the larger mesh
  bool HasBranches = false;        ///< true if the larger mesh has edges with more than two faces
};

/// Rows built by one thread.
struct RowBlock
{
  Id LimitExceeded = NoId;        ///< first row whose limit was exceeded
  std::vector<std::size_t> Sizes; ///< number of edges per row; RimReached if unknown
  std::vector<RowEdge> Edges;
  static constexpr std::size_t RimReached = std::numeric_limits<std::size_t>::max();
};

/// Finds the edges of the vertices of a mesh, which must outlive the finder. A row has the edges of
/// one vertex, before both directions of the edges are united. Rows and their targets are in the
/// order of the table.
class RowFinder
{
public:
  /// Finds all rows. See GraphBuilder.
  RowFinder(const SurfaceMesh& mesh, std::size_t windowLimit);
  /// Finds the rows of the sources of a region.
  RowFinder(const SurfaceMesh& mesh, const GraphRegion& region);

  const UnfoldingTable& GetTable() const { return this->Table; }
  /// Returns crossings that are kept until the finder is destroyed.
  CrossingBlocks& GetCrossings() const { return this->Crossings; }
  /// Returns the vertex of the table to which row i belongs.
  Id GetRow(Id i) const { return this->HasRegion ? this->Rows[i] : i; }

  /// See GraphBuilder::Estimate().
  Status Estimate(const GraphOptions& options, GraphEstimate& estimate) const;

  /// Receives consecutive rows, of which the first is row `first`.
  using Receiver = std::function<void(const std::vector<RowBlock>& blocks, Id first)>;
  /// Finds the edges of all rows and adds to the statistics, which do not depend on Parallel. Fails
  /// if the work exceeds the limit.
  Status Find(
    const GraphOptions& options, GraphStatistics& statistics, const Receiver& receive) const;

  /// Fails if the total work of the finders of all regions exceeds the limit.
  static Status CheckWork(const GraphOptions& options, const GraphRegion& region, std::size_t work);

  /// Returns the limits of one source.
  WindowLimits LimitWindows(const GraphOptions& options) const;
  /// Returns the error of an exceeded limit; `source` describes the origin of the windows.
  Status LimitExceeded(const std::string& source, const GraphOptions& options) const;
  /// Returns true if lengths must be stored as double.
  bool NeedsWide(const GraphOptions& options) const;

private:
  struct Sample;

  Id GetNumberOfRows() const
  {
    return this->HasRegion ? static_cast<Id>(this->Rows.size()) : this->Table.GetNumberOfVertices();
  }
  bool CanMultiply() const { return this->HasBranches || this->Table.HasDegenerateFaces(); }
  CrossingBlocks& ChooseCrossings(std::optional<CrossingBlocks>& temporary) const;
  template <typename Rule>
  Status SampleRows(const Rule& rule, const GraphOptions& options, Sample& sample) const;
  template <typename Rule>
  Status FindRows(const Rule& rule, const GraphOptions& options, GraphStatistics& statistics,
    const Receiver& receive) const;
  template <typename Tracer>
  void FillBlock(Tracer& tracer, CrossingBlocks& crossings, Id begin, Id end, std::size_t mostWork,
    std::atomic<std::size_t>& work, RowBlock& block) const;
  Status VertexLimitExceeded(Id row, const GraphOptions& options) const;

  const SurfaceMesh& Mesh;
  std::size_t GraphWindowLimit;
  Offset NumberOfFaces; // of the mesh that contains the region
  UnfoldingTable Table;
  mutable CrossingBlocks Crossings;
  bool HasBranches;             // true if that mesh has edges with more than two faces
  std::vector<Offset> PointIds; // per vertex; empty without a region
  bool HasRegion = false;
  std::vector<Id> Rows; // rows to build, sorted; all without a region
};
}

#endif
