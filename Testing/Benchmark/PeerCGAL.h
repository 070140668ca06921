// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's exact geodesics (Surface_mesh_shortest_path: Xin and Wang's variant of Chen and Han's
/// algorithm), an implementation independent of ours. CGAL's headers stay inside the source file.
#ifndef PeerCGAL_h
#define PeerCGAL_h

#include "MeshArrays.h" // for MeshArrays

#include <array>  // for barycentric coordinates
#include <memory> // for the implementation
#include <string> // for the reason of a refusal
#include <vector> // for the distances

class PeerCGAL
{
public:
  explicit PeerCGAL(const MeshArrays& mesh);
  ~PeerCGAL();
  PeerCGAL(const PeerCGAL&) = delete;
  PeerCGAL& operator=(const PeerCGAL&) = delete;

  /// Returns the reason why CGAL cannot represent the mesh (it requires an oriented manifold);
  /// empty if it can.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// Prepares a run from one source; discards the previous run.
  void SetSourceVertex(dgg::Id vertex);
  /// Sets a source inside a face; coordinates are in the order of the face's corners in the input.
  void SetSourceInFace(dgg::Id face, const std::array<double, 3>& barycentric);

  /// Returns the distances of all vertices; infinity if there is no path.
  std::vector<double> ComputeDistances();

private:
  struct Solver;
  std::string Refusal;
  std::unique_ptr<Solver> State;
};

#endif
