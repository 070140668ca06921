// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random pairs of points of a surface, with their exact distances.
#ifndef MeasuredPairs_h
#define MeasuredPairs_h

#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePoint.h" // for SurfacePoint

#include <cstddef> // for std::size_t
#include <tuple>   // for the order of recipes
#include <vector>  // for the pairs

/// Recipe of pairs of points.
struct PairRecipe
{
  int Count = 0;
  int PerStart = 1;        ///< number of successive pairs that share a start
  bool AtVertices = false; ///< otherwise uniformly distributed over the surface

  bool operator<(const PairRecipe& other) const
  {
    return std::tie(this->Count, this->PerStart, this->AtVertices) <
      std::tie(other.Count, other.PerStart, other.AtVertices);
  }
};

/// Returns random points of a surface, the same for the same `seed` on all systems.
std::vector<dgg::SurfacePoint> RandomPoints(
  const dgg::SurfaceMesh& surface, int count, bool atVertices, unsigned int seed);

class MeasuredPairs
{
public:
  /// The mesh must outlive the pairs.
  MeasuredPairs(const dgg::SurfaceMesh& surface, const PairRecipe& recipe);

  std::size_t GetCount() const { return this->Ends.size(); }
  const dgg::SurfacePoint& GetStart(std::size_t pair) const
  {
    return this->Starts[pair / this->PerStart];
  }
  const dgg::SurfacePoint& GetEnd(std::size_t pair) const { return this->Ends[pair]; }

  /// Returns exact distances of the pairs, computed once; Infinity for pairs that are not
  /// connected.
  const std::vector<double>& GetExactDistances();

private:
  const dgg::SurfaceMesh& Surface;
  std::size_t PerStart;
  std::vector<dgg::SurfacePoint> Starts;
  std::vector<dgg::SurfacePoint> Ends;
  std::vector<double> ExactDistances;
};

#endif
