// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along the graph of a surface that several processes have in pieces. Internal.
#ifndef dggPieceSearch_h
#define dggPieceSearch_h

#include "dggBucketQueue.h"     // for the queue
#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggGraphFans.h"       // for fans
#include "dggGraphSearch.h"     // for seeds
#include "dggLabelCorrection.h" // for estimates
#include "dggProcessGroup.h"    // for messages
#include "dggSearchLabels.h"    // for labels
#include "dggStoredGraph.h"     // for ghosts
#include "dggSurfacePieces.h"   // for the piece

#include <cstddef> // for std::size_t
#include <limits>  // for ids
#include <memory>  // for the correction
#include <vector>  // for the results

namespace dgg
{
/// A seed at a point with a global id; `Seed.Vertex` is not used.
struct PieceSeed
{
  Offset PointId = NoId;
  GraphSeed Seed;
};

/// Relay of a vertex (IsStraight()): a point of any process.
struct PieceRelay
{
  Offset PointId = NoId; ///< global
  /// Process that the point belongs to; NoId if the virtual source of the vertex is a source of the
  /// search.
  Id Process = NoId;
};

/// Vertex of a path, and the edge that leads there.
struct PieceStep
{
  Offset PointId; ///< global
  double Position[3];
  ///@{
  /// GraphView::Angles and the length of the edge; zeros at the start of the path.
  double Angle;
  double Length;
  ///@}
};

/// A path in the graph of all pieces.
struct PieceRoute
{
  double Length = Infinity;     ///< infinity if there is no path
  std::vector<PieceStep> Steps; ///< from the end to the start
};

/// Options of a search. They must be the same on all processes.
struct PieceSearchOptions
{
  /// Vertices farther than this distance are left unreached.
  double MaximumDistance = Infinity;
  /// If true, PieceDistances::Corrected is filled.
  bool Correct = false;
  /// If true, PieceDistances::NearestSource is filled.
  bool FindSources = false;
  /// If true, PieceDistances::Virtual and PieceDistances::Relays are filled.
  bool FindRelays = false;
  ProgressCallback Progress; ///< may be empty

  bool NeedsTree() const { return this->Correct || this->FindSources || this->FindRelays; }
};

/// Results at the points of a piece.
struct PieceDistances
{
  std::vector<double> Labels;    ///< SearchResult::Distances
  std::vector<double> Corrected; ///< SearchResult::Corrected; empty unless requested
  std::vector<Id> NearestSource; ///< GraphSeed::Source, or NoId; empty unless requested
  ///@{
  /// SearchResult::Virtual, and the relays; unspecified at unreached points, empty unless
  /// requested.
  VirtualSources Virtual;
  std::vector<PieceRelay> Relays;
  ///@}
};

/// Searches shortest paths in a graph of which each process has the rows of its piece (PieceGraph).
/// Every process searches its part, and sends improved labels of vertices that are ghosts
/// elsewhere, until no label improves. The results are those of GraphSearch::Run() in the entire
/// graph, bit by bit. All functions must be called by all processes.
class DGG_CORE_EXPORT PieceSearch
{
public:
  /// Prepares searches. The arrays must outlive this object. `isUsable` becomes false on all
  /// processes if the parts do not form one graph.
  Status Prepare(ProcessGroup& group, const SurfacePiece& piece, const GraphView& graph,
    const GhostVertices& ghosts, bool& isUsable);

  /// Computes distances from the nearest seed. The seeds must be the same on all processes. Seeds
  /// at points that no process has are ignored. `isUsable` becomes false on all processes if an
  /// edge does not lengthen a path because the path is too long, or if an edge is missing on one of
  /// its two processes.
  Status Run(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
    const PieceSearchOptions& options, PieceDistances& result, bool& isUsable);

  ///@{
  /// Incremental search: ClearLabels() removes all labels, AddSeeds() lowers labels by further
  /// seeds. GetLabels() has one per vertex of this part of the graph. Run() replaces the labels.
  void ClearLabels();
  Status AddSeeds(ProcessGroup& group, const std::vector<PieceSeed>& seeds);
  const std::vector<double>& GetLabels() const { return this->Distances; }
  ///@}
  /// Returns the vertices with edges that belong to this process, in the order of their global ids.
  std::vector<Id> ListConnected() const;
  /// Returns the global ids of the vertices.
  const std::vector<Offset>& GetIds() const { return this->Ids; }
  ///@{
  /// The graph of this process, and its correction.
  const GraphView& GetGraph() const { return this->Graph; }
  const LabelCorrection& GetCorrection() const { return *this->Correction; }
  /// Returns the number of points of the piece, which are the first vertices.
  Id GetPointsHere() const { return this->PointsHere; }
  /// Returns true if a vertex belongs to this process.
  bool IsHere(Id v) const { return this->Ghosts.Owners[v] == GhostVertices::Here; }
  /// Returns, per process p, the vertices of this process that p has as well, and the vertices of p
  /// that this process has. Both processes have them in the same order.
  const std::vector<std::vector<Id>>& GetSent() const { return this->Sent; }
  const std::vector<std::vector<Id>>& GetReceived() const { return this->Received; }
  ///@}
  /// Replaces the values of vertices of other processes by the values there.
  template <typename Value>
  Status TakeFromOwners(ProcessGroup& group, std::vector<Value>& values) const
  {
    std::vector<std::vector<Value>> lists(this->Sent.size());
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      for (const Id v : this->Sent[process])
      {
        lists[process].push_back(values[v]);
      }
    }
    DGG_RETURN_IF_ERROR(group.ExchangeLists(lists, this->GetMemorySize()));
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      for (std::size_t k = 0; k < lists[process].size(); ++k)
      {
        values[this->Received[process][k]] = lists[process][k];
      }
    }
    return Status::Success();
  }
  /// Returns the seeds at vertices of this process and its ghosts.
  std::vector<GraphSeed> TakeSeeds(const std::vector<PieceSeed>& seeds) const;

  /// Finds the paths of the last Run() to points of the graph, given by their global ids. They are
  /// the paths that GraphSearch::Between() finds. `piece` is that of Prepare(). `isUsable` becomes
  /// false on all processes for the reasons of Run().
  Status FollowBack(ProcessGroup& group, const SurfacePiece& piece, const std::vector<Offset>& ends,
    std::vector<PieceRoute>& routes, bool& isUsable) const;

  /// Finds the seeds, by their indices, at points without edges.
  Status FindIsolated(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
    std::vector<std::size_t>& isolated) const;

  /// Returns the number of points of all pieces.
  Offset GetNumberOfPoints() const { return this->NumberOfPoints; }
  ///@{
  /// Returns true if the global ids are consecutive numbers, and the first of them.
  bool HasConsecutiveIds() const
  {
    return this->NumberOfPoints > 0 &&
      this->LargestId - this->SmallestId + 1 == this->NumberOfPoints;
  }
  Offset GetFirstId() const { return this->SmallestId; }
  ///@}
  /// Returns an estimate of the size in bytes during a search.
  double GetMemorySize() const;

private:
  /// Path to a vertex, and the resulting estimate.
  struct Estimated
  {
    LabelCorrection::Estimate Estimate;
    Id Source = NoId; ///< GraphSeed::Source; NoId until the arrival is known
  };
  struct Arrival : Estimated
  {
    PieceRelay Relay;
  };
  struct Tree;

  Status FindReaders(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);
  Status MeasureAngles(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);
  Status CountPoints(ProcessGroup& group, Offset& edges);
  Id FindVertex(Offset id) const;
  Status FindLabels(ProcessGroup& group, std::vector<GraphSeed> seeds,
    const PieceSearchOptions& options, bool areFirst);
  bool LowerLabels(const std::vector<GraphSeed>& seeds, bool areFirst, SearchLabels& labels,
    const ProgressCallback& progress);
  void CollectLowered(std::vector<Message>& messages);
  std::vector<GraphSeed> ReadLowered(const std::vector<Message>& messages) const;
  Status FollowTree(ProcessGroup& group, const std::vector<GraphSeed>& seeds, double smallestOffset,
    const PieceSearchOptions& options, std::vector<Arrival>& arrivals, bool& isUsable);
  Status PrepareTree(ProcessGroup& group, Tree& tree, bool& isUsable);
  bool HasTailOf(Id v, std::size_t process) const;
  bool SetTail(Id v, Id tail);
  bool ReadArrivals(const std::vector<Message>& messages, std::vector<Arrival>& arrivals) const;
  std::vector<TreeStep> FindSteps(Tree& tree, const std::vector<Arrival>& arrivals) const;
  void Descend(const std::vector<GraphSeed>& seeds, double smallestOffset, Tree& tree,
    std::vector<Arrival>& arrivals) const;
  void CollectArrivals(
    const std::vector<Arrival>& arrivals, Tree& tree, std::vector<Message>& messages) const;

  int Process = 0; // this process
  GraphView Graph;
  GhostVertices Ghosts;
  std::vector<Offset> Ids; // global, per vertex
  std::vector<Id> ById;    // vertices in the order of their global ids
  Id PointsHere = 0;       // points of the piece
  Offset NumberOfPoints = 0;
  Offset SmallestId = std::numeric_limits<Offset>::max();
  Offset LargestId = std::numeric_limits<Offset>::min();
  double BucketWidth = 0.0;
  std::vector<std::vector<Id>> Sent;
  std::vector<std::vector<Id>> Received;
  std::vector<std::vector<double>> LastSent; // labels, per vertex of Sent
  std::unique_ptr<const GraphFans> Fans;     // null if rows are short
  std::unique_ptr<const LabelCorrection> Correction;

  std::vector<double> Distances;
  std::vector<LabelOrigin> Origins;
  std::vector<Id> Touched;
  std::vector<Id> Lowered;
  BucketQueue Queue;
};
}

#endif
