// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Propagation of virtual sources on a surface that several processes have in pieces. Internal.
#ifndef dggPropagationPieces_h
#define dggPropagationPieces_h

#include "dggProcessGroup.h"     // for messages
#include "dggPropagationLabel.h" // for labels
#include "dggSurfaceMesh.h"      // for SurfaceMesh

#include <atomic>  // for distances
#include <cstddef> // for std::size_t
#include <cstdint> // for flags
#include <vector>  // for lists

namespace dgg
{
/// Numbers of labels of a round: all, and those of slots that have been propagated before.
struct PropagationCounts
{
  std::size_t Labels = 0;
  std::size_t Known = 0;

  void Add(const PropagationCounts& other)
  {
    this->Labels += other.Labels;
    this->Known += other.Known;
  }
};

/// Communication of a propagation with those of other processes. Each process propagates the labels
/// of its own faces. All processes have the same rounds: they exchange the distances of shared
/// vertices before the labels of a round are propagated, and the labels that enter faces of other
/// processes after the round. Vertices and faces of the mesh are in the order of global ids, so
/// that two processes list shared vertices and edges in the same order.
class PropagationPieces
{
public:
  /// `owners` are the processes to which the faces belong. The mesh has all faces around the
  /// vertices of the faces of this process. `numberOfFaces` is that of the entire surface.
  PropagationPieces(const SurfaceMesh& mesh, std::vector<int> owners, Offset numberOfFaces,
    const ProcessGroup& group);

  bool IsHere(Id f) const { return this->Owners[f] == this->Here; }
  /// Returns true if the vertex is a corner of a face of this process.
  bool HasVertex(Id v) const { return this->IsUsed[v] != 0; }
  Offset GetNumberOfFaces() const { return this->NumberOfFaces; }

  /// Starts a propagation. `inUse` are the bytes in use already.
  void Start(ProcessGroup& group, double inUse);

  ///@{
  /// These functions must be called by all processes.
  /// Replaces a value by the smallest one of all processes.
  Status FindLeast(double& value) const;
  Status Sum(PropagationCounts& counts) const { return this->Group->Sum(counts); }
  /// Lowers the distances of shared vertices to those of other processes, and appends the lowered
  /// vertices. `isOver` becomes true if no process has sent a distance.
  Status ShareDistances(std::atomic<float>* distances, std::vector<Id>& lowered, bool& isOver);
  /// Sends labels that enter faces of other processes, and replaces them by those that enter faces
  /// of this process.
  Status ExchangeLabels(std::vector<PropagationLabel>& labels) const;
  ///@}

private:
  int Here;
  Offset NumberOfFaces;
  std::vector<int> Owners;
  std::vector<std::uint8_t> IsUsed; // per vertex
  ///@{
  // Per process, in ascending order.
  std::vector<std::vector<Id>> Vertices; // shared
  std::vector<std::vector<Id>> Exits;    // half-edges of its faces behind faces of this process
  std::vector<std::vector<Id>> Entries;  // half-edges of faces of this process behind its faces
  ///@}
  std::vector<std::vector<float>> LastSent; // distances of Vertices last sent or received
  ProcessGroup* Group = nullptr;
  double InUse = 0.0;
};
}

#endif
