// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Remembers the cones that have crossed non-manifold edges. Internal.
#ifndef dggConeMemory_h
#define dggConeMemory_h

#include "dggCone.h" // for Cone

#include <cstddef>       // for std::size_t
#include <unordered_map> // for the lists
#include <vector>        // for the lists

namespace dgg
{
/// A non-manifold edge sends a copy of every cone into each further face. Copies meet again behind
/// the next such edge, and would go on multiplying; but of cones from one source that enter the
/// same face through the same part of an edge only the shortest can matter.
class ConeMemory
{
public:
  /// Whether a cone that enters a face through half-edge h is anywhere shorter than each of those
  /// that entered before; if so it is remembered. `reversed` when the edge of the cone runs against
  /// the half-edge.
  bool Admit(Id h, bool reversed, const Relay& left, const Relay& right, const Cone& cone);

  void Clear();
  /// The most bytes it ever took: they are given back when it is cleared.
  std::size_t GetMemorySize() const;

private:
  struct Light
  {
    double Begin; ///< lit part of the half-edge, from its origin
    double End;
    double AtBegin; ///< distances there
    double AtEnd;
    double Foot; ///< image of the source: abscissa on the edge, distance from its line
    double Depth;

    double DistanceAt(double x) const { return Norm(x - this->Foot, this->Depth); }
  };

  std::size_t GetCurrentSize() const;

  std::unordered_map<Id, std::vector<Light>> Entered; // per half-edge
  std::size_t LargestSize = 0;                        // before it was cleared
};
}

#endif
