// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of vertices from sites other than the nearest one. Internal.
#ifndef dggFartherSites_h
#define dggFartherSites_h

#include "dggGraphSearch.h"     // for GraphSeed
#include "dggHeap.h"            // for the queue
#include "dggLabelCorrection.h" // for estimates
#include "dggVirtualSources.h"  // for VirtualSources

#include <cstdint>       // for keys
#include <unordered_map> // for the labels of vertices with many sites
#include <vector>        // for labels

namespace dgg
{
/// The nearest site of each vertex.
struct NearestSites
{
  std::vector<Id> Sites;         ///< NoId if unreached
  std::vector<double> Labels;    ///< see SearchResult::Distances
  std::vector<double> Distances; ///< estimates, see SearchResult::Corrected
  VirtualSources Sources;        ///< unspecified without a correction

  LabelCorrection::Estimate GetEstimate(Id v) const
  {
    return { this->Sources[v], this->Distances[v] };
  }
};

/// Returns the longest edge of the faces around each vertex and its neighbors, because paths may
/// pass vertices whose own faces are smaller.
std::vector<double> MeasureReach(const SurfaceMesh& mesh);

/// Labels of sites other than the nearest one, up to a limit per vertex. They depend neither on the
/// order in which labels are lowered nor on the division of the graph among processes. Of several
/// paths of equal length, a seed comes first, then the path with the smallest tail (see
/// SearchLabels::IsPreferred()).
class FartherSites
{
public:
  /// A distance from a site.
  struct Label
  {
    double Distance;
    LabelCorrection::Estimate Estimate; ///< distance Infinity until known
    Offset Edge;                        ///< edge to the vertex; -1 for a seed
    Id Site;
    Id Vertex;
    Id Tail;      ///< tail of the edge; index of the seed if there is no edge
    Id TailLabel; ///< label at the tail; NoId for the label of the nearest site
    Id Next;      ///< next label of the same vertex, or NoId
  };

  /// Labels that exceed `limits` (per vertex) are not computed. `correction` may be null. `ids` are
  /// the global ids of vertices; null if vertices are in their order. All arguments must outlive
  /// this object.
  FartherSites(const GraphView& graph, const LabelCorrection* correction,
    const NearestSites& nearest, const std::vector<GraphSeed>& seeds, std::vector<double> limits,
    const Offset* ids = nullptr);

  /// Finds all labels that follow from seeds, labels of nearest sites, and labels of Receive().
  /// Fails if aborted.
  Status Run(const ProgressCallback& progress);
  /// Returns the labels that have become final in the last Run(), in ascending order of distances.
  const std::vector<Id>& GetSettled() const { return this->Settled; }
  const std::vector<Label>& GetLabels() const { return this->Labels; }

  /// Finds the estimate of a final label. Returns false if the estimate at the tail is unknown.
  bool Estimate(Id label);

  ///@{
  /// Labels of vertices of other processes, regardless of their limits: lowers a label; sets the
  /// estimate of a label.
  void Receive(Id v, Id site, double distance);
  void ReceiveEstimate(Id v, Id site, const LabelCorrection::Estimate& estimate);
  ///@}

  /// Calls `use(site, estimate)` for the labels of a vertex, in no particular order.
  template <typename Use>
  void ForEach(Id v, const Use& use) const
  {
    for (Id i = this->Heads[v]; i != NoId; i = this->Labels[i].Next)
    {
      use(this->Labels[i].Site, this->Labels[i].Estimate);
    }
  }

private:
  void Start();
  void Relax(Id v, Id site, double distance, Id label);
  void Offer(Id v, Id site, double distance, Offset edge, Id tail, Id tailLabel);
  bool IsPreferred(const Label& present, Offset edge, Id tail, Id tailLabel) const;
  Id Find(Id v, Id site) const;
  Id FindOrAdd(Id v, Id site);

  const GraphView& Graph;
  const LabelCorrection* Correction;
  const NearestSites& Nearest;
  const std::vector<GraphSeed>& Seeds;
  const Offset* Ids;
  bool IsStarted = false;
  std::vector<Id> Heads; // per vertex, its first label
  std::vector<double> Limits;
  std::vector<Label> Labels;
  std::vector<Id> Counts; // per vertex, number of its labels
  // Labels of vertices with many labels.
  std::unordered_map<std::uint64_t, Id> Places;
  MinimumHeap Heap; // queue of labels
  std::vector<Id> Settled;
};
}

#endif
