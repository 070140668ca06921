// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Propagation of virtual sources in synchronous rounds. Internal.
#ifndef dggPropagation_h
#define dggPropagation_h

#include "dggGeodesicSource.h"    // for sources
#include "dggPropagationFaces.h"  // for the faces
#include "dggPropagationLabel.h"  // for labels
#include "dggPropagationPieces.h" // for other processes
#include "dggPropagationRounds.h" // for the slots
#include "dggRoundTeam.h"         // for the threads

#include <atomic>  // for distances
#include <cstddef> // for std::size_t
#include <memory>  // for the arrays
#include <vector>  // for chunks

namespace dgg
{
/// A chunk of the work of a round.
struct alignas(64) PropagationChunk
{
  int Thread = 0;                         ///< thread that processes the chunk
  std::vector<PropagationLabel> Labels;   ///< labels of faces or edges
  std::vector<PropagationLabel> Vertices; ///< labels of vertices; Entry is the vertex
  /// Labels of non-manifold edges, by the half-edge through which they leave.
  std::vector<PropagationLabel> Edges;
  /// Labels that enter faces of other processes.
  std::vector<PropagationLabel> Crossing;
  std::size_t Known = 0; ///< number of slots that have been propagated before
  /// Shortcuts found, to be applied after the round.
  std::vector<PropagationShortcut> Shortcuts;

  std::size_t GetNumberOfLabels() const
  {
    return this->Labels.size() + this->Vertices.size() + this->Edges.size();
  }
};

/// One propagation. In `High` quality there is one slot per edge, at its smallest half-edge,
/// otherwise one per face.
template <bool High>
class Propagation
{
public:
  /// `pieces` is null for an entire surface.
  Propagation(const SurfaceMesh& mesh, const PropagationFaces& faces, PropagationPieces* pieces,
    double shift, float radius, const ParallelFor& parallel, int threads);

  void Start(const std::vector<GeodesicSource>& sources, bool wantsLabels);
  /// Performs some rounds. IsDone() holds when no work is left. Fails only if another process does.
  Status Advance(RoundTeam& team);
  bool IsDone() const { return this->HasEnded; }
  /// Returns false if the search ended before labels settled.
  bool IsSettled() const { return this->Propagated <= this->MaximumCount(); }
  double GetProgress() const;

  /// Relaxes the remaining shortcuts; must be called once, after all rounds. Fails only if another
  /// process does.
  Status FindShortcuts(const ParallelFor& parallel);
  /// Returns the shortcuts that define vertex distances, nearest first, if labels are requested.
  const std::vector<PropagationShortcut>& GetShortcuts() const { return this->Shortcuts; }

  double GetDistance(Id v) const
  {
    return this->Distances[v] * this->Faces.GetUnit() + this->Shift;
  }
  bool IsReached(Id v) const { return this->Distances[v] < UnreachedKey; }
  /// Finds the label of a face or edge at a vertex that gives its shortest distance. Returns false
  /// if there is none.
  bool FindLabel(Id v, PropagationLabel& label, VirtualPlace& place) const;
  /// Returns the path from a label that has entered a face at the vertex.
  Way SeeFrom(Id v, const PropagationLabel& label, VirtualPlace& place) const;

private:
  /// Returns the number of faces of the entire surface.
  Offset GetNumberOfFaces() const
  {
    return this->Pieces ? this->Pieces->GetNumberOfFaces() : this->Mesh.GetNumberOfFaces();
  }
  /// Returns the approximate number of labels, for progress; the actual number may differ.
  double CountExpected() const;
  /// Returns the largest number of labels to propagate.
  std::size_t MaximumCount() const;
  Id SlotOf(Id entry) const;
  /// Returns true if a face belongs to this process.
  bool IsHere(Id f) const { return !this->Pieces || this->Pieces->IsHere(f); }
  bool IsSlotHere(Id entry) const;
  Status ExchangeLabels(std::vector<PropagationLabel>& crossing);
  void Radiate(const PropagationLabel& from, Id v, PropagationChunk& chunk);
  void EnterAllBehind(Id exit, const PropagationLabel& label, PropagationChunk& chunk);
  void ReachHub(Id v, float distance, Id root, PropagationChunk& chunk);
  void Collect(
    const BucketQueue::Entry* begin, const BucketQueue::Entry* end, PropagationChunk& chunk);
  void Propagate(PropagationChunk& chunk);
  DGG_INLINE void Leave(const PropagationLabel& label, int side, PropagationChunk& chunk);
  DGG_INLINE void Cross(Id exit, PropagationLabel label, PropagationChunk& chunk);
  DGG_INLINE void Enter(PropagationLabel label, PropagationChunk& chunk);
  DGG_INLINE void Offer(float key, const PropagationLabel& label, Id id, PropagationChunk& chunk);
  void TakeShortcuts(PropagationChunk& chunk);
  Status RelaxEdges(const ParallelFor& parallel);
  void CollectShortcutsFrom(
    Id h, const std::vector<float>& before, std::vector<PropagationShortcut>& found) const;
  float Load(Id v) const { return this->Distances[v].load(std::memory_order_relaxed); }
  void Lose(Id id, const PropagationLabel& label, PropagationChunk& chunk) const;

  const SurfaceMesh& Mesh;
  const PropagationFaces& Faces;
  PropagationPieces* const Pieces;
  const double Shift;
  const float Radius;
  const Id FirstHub; ///< first slot of hubs
  bool HasRivals =
    false; ///< true for several sources; labels of a single source hardly differ within a face
  bool WantsLabels = false; ///< if true, shortcuts are stored
  std::unique_ptr<PropagationSlot[]> Slots;
  /// Lengths of the shortest paths found to the vertices.
  std::unique_ptr<std::atomic<float>[]> Distances;
  PropagationRounds Rounds;
  std::vector<std::vector<BucketQueue::Entry>> Entries; ///< entries of a round, per thread
  std::vector<std::vector<PropagationChunk>> Chunks; ///< entries of a round in chunks, per thread
  std::vector<PropagationShortcut> Shortcuts;        ///< shortcuts of all rounds
  bool IsShared = false;
  bool HasEnded = false;
  std::size_t Propagated = 0; ///< number of labels propagated
};
}

#endif
