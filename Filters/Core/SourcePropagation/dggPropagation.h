// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One propagation of virtual sources, round by round. Internal.
#ifndef dggPropagation_h
#define dggPropagation_h

#include "dggGeodesicSource.h"       // for sources
#include "dggPropagationFaces.h"     // for the faces
#include "dggPropagationLabel.h"     // for labels
#include "dggPropagationOutput.h"    // for VirtualPlace
#include "dggPropagationRounds.h"    // for the slots
#include "dggPropagationShortcuts.h" // for shortcuts
#include "dggRoundTeam.h"            // for the threads

#include <atomic>  // for distances
#include <cstddef> // for std::size_t
#include <memory>  // for the arrays
#include <vector>  // for chunks

namespace dgg
{
/// A part of a round.
struct alignas(64) PropagationChunk
{
  int Thread = 0;                         ///< that works on it
  std::vector<PropagationLabel> Labels;   ///< of faces or edges
  std::vector<PropagationLabel> Vertices; ///< of vertices, which are the entries
  /// Of edges of many faces, by the half-edge that they leave through.
  std::vector<PropagationLabel> Edges;
  std::size_t Known = 0; ///< slots that have been propagated before
  /// That were found, to be taken after the round.
  std::vector<PropagationShortcut> Shortcuts;

  std::size_t GetNumberOfLabels() const
  {
    return this->Labels.size() + this->Vertices.size() + this->Edges.size();
  }
};

/// One propagation. In `High` quality each edge has a slot, at its smallest half-edge, else each
/// face.
template <bool High>
class Propagation
{
public:
  Propagation(const SurfaceMesh& mesh, const PropagationFaces& faces, double shift, float radius,
    const ParallelFor& parallel, int threads);

  void Start(const std::vector<GeodesicSource>& sources, bool wantsLabels);
  /// Some rounds. Nothing is left to do when IsDone() holds.
  void Advance(RoundTeam& team);
  bool IsDone() const { return this->HasEnded; }
  /// Returns false if the search ended before labels settled.
  bool IsSettled() const { return this->Propagated <= this->MaximumCount(); }
  double GetProgress() const;

  /// Mends what is missing then; to be called once. Returns the ways that vertices have their
  /// distances from, nearest first, if labels are wanted.
  const std::vector<PropagationShortcut>& FindShortcuts(const ParallelFor& parallel);

  double GetDistance(Id v) const
  {
    return this->Distances[v] * this->Faces.GetUnit() + this->Shift;
  }
  bool IsReached(Id v) const { return this->Distances[v] < UnreachedKey; }
  /// The label around a vertex that reaches it first; false without one.
  bool FindLabel(Id v, PropagationLabel& label, VirtualPlace& place) const;
  /// The same of one label that has entered a face at the vertex.
  Way SeeFrom(Id v, const PropagationLabel& label, VirtualPlace& place) const;

private:
  /// Labels, about; it takes as many as it takes.
  double CountExpected() const;
  /// Returns the largest number of labels to propagate.
  std::size_t MaximumCount() const;
  Id SlotOf(Id entry) const;
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
  void Lose(Id id, const PropagationLabel& label, PropagationChunk& chunk) const;

  const SurfaceMesh& Mesh;
  const PropagationFaces& Faces;
  const double Shift;
  const float Radius;
  const Id FirstHub;        ///< slots from here on are those of hubs
  bool HasRivals = false;   ///< several sources; of one all labels of a face are about as good
  bool WantsLabels = false; ///< then shortcuts are kept
  std::unique_ptr<PropagationSlot[]> Slots;
  /// Lengths of ways to the vertices.
  std::unique_ptr<std::atomic<float>[]> Distances;
  PropagationRounds Rounds;
  std::vector<std::vector<BucketQueue::Entry>> Entries; ///< of a round, by threads
  std::vector<std::vector<PropagationChunk>> Chunks;    ///< the same in parts
  std::vector<PropagationShortcut> Shortcuts;           ///< of all rounds
  bool IsShared = false;
  bool HasEnded = false;
  std::size_t Propagated = 0; ///< labels
};
}

#endif
