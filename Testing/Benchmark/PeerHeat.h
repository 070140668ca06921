// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's heat method (Heat_method_3: Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013),
/// with CGAL's own choice of sparse solver. Two factorizations first, then two solves per query.
/// CGAL's and Eigen's headers are included in the source file only.
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
    Direct,           ///< triangulation of the mesh
    IntrinsicDelaunay ///< flips edges first: CGAL's default, more accurate
  };

  PeerHeat(const MeshArrays& mesh, Triangulation triangulation);
  ~PeerHeat();
  PeerHeat(const PeerHeat&) = delete;
  PeerHeat& operator=(const PeerHeat&) = delete;

  /// Returns the reason why there are no results (CGAL requires an oriented manifold without
  /// degenerate faces); empty if there are.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// Releases the factorizations.
  void Clear();
  /// Runs all steps that precede a query.
  void Precompute();
  /// Computes distances from one vertex to all; calls Precompute() if necessary.
  void Run(dgg::Id source);
  /// Returns the distances of the last run.
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
