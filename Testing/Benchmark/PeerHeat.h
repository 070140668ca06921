// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's heat method (Heat_method_3: Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013),
/// with CGAL's own choice of sparse solver. Two factorisations first, then two solves per query.
/// CGAL's and Eigen's headers stay inside the source file.
#ifndef PeerHeat_h
#define PeerHeat_h

#include "MeshArrays.h" // for MeshArrays

#include <memory> // for the implementation
#include <string> // for the reason of a refusal
#include <vector> // for the distances

class PeerHeat
{
public:
  enum class Triangulation
  {
    Direct,           ///< that of the mesh
    IntrinsicDelaunay ///< edges flipped first: CGAL's default, more accurate
  };

  PeerHeat(const MeshArrays& mesh, Triangulation triangulation);
  ~PeerHeat();
  PeerHeat(const PeerHeat&) = delete;
  PeerHeat& operator=(const PeerHeat&) = delete;

  /// Why there are no answers: CGAL wants an oriented manifold without degenerate faces. Empty when
  /// there are.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// Drop the factorisations.
  void Clear();
  /// Everything that comes before a query.
  void Precompute();
  /// Run from one vertex to all; precomputes if that has not been done.
  void Run(dgg::Id source);
  /// Distances of the last run.
  std::vector<double> GetDistances() const;

private:
  template <class Work>
  void Try(Work&& work);

  struct Implementation;
  std::string Refusal;
  Triangulation Mode;
  std::unique_ptr<Implementation> Internals;
};

#endif
