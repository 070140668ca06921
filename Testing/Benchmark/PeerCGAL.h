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

  /// Why CGAL cannot hold the mesh (it wants an oriented manifold); empty when it can.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// Prepare a run from one source; leaves nothing of the run before.
  void SetSourceVertex(dgg::Id vertex);
  /// Source inside a face; coordinates in the order of the face's corners in the input.
  void SetSourceInFace(dgg::Id face, const std::array<double, 3>& barycentric);

  /// Distances of all vertices; infinity where there is no path.
  std::vector<double> ComputeDistances();

private:
  struct Solver;
  std::string Refusal;
  std::unique_ptr<Solver> State;
};

#endif
