// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Selects the neighbors of a point of a cloud that become edges. Internal.
#ifndef dggCloudPruning_h
#define dggCloudPruning_h

#include "dggCloudPairs.h" // for CloudPairs
#include "dggTypes.h"      // for Id

#include <cstdint> // for indices of relays
#include <vector>  // for edges

namespace dgg
{
/// Selects the edges of one point after another by the progress rule. A neighbor q of p is excluded
/// if an edge (p, r) was kept with w(p, r) / (1 + accuracy) + w(r, q) <= w(p, q), and r and q are
/// connected directly. No path then gets longer by more than the relative error `accuracy`; the
/// proof for meshes depends only on lengths. Each thread needs its own object.
class CloudPruning
{
public:
  /// An accuracy of 0 keeps all neighbors that are connected directly.
  CloudPruning(const CloudPairs& pairs, double accuracy);

  /// Appends the selected neighbors of p to `kept`. `neighbors` are in ascending order of distance
  /// from p, and `chords` holds these distances.
  void ChooseEdges(Id p, const std::vector<Id>& neighbors, const std::vector<double>& chords,
    std::vector<Id>& kept);

private:
  struct Relay
  {
    Id Point;
    std::int32_t Next; ///< previous relay in the same sector, or -1
    double Length;
  };

  bool IsCovered(Id q, double length, int sector);
  int SectorOf(const Point3& direction) const;
  void ChooseFrame(const Point3& normal);

  const CloudPairs& Pairs;
  double Kappa;
  int Sectors;
  Point3 AxisX;
  Point3 AxisY;
  std::vector<Relay> Relays;
  std::vector<std::int32_t> Last; ///< per sector, the relay kept last, or -1
};
}

#endif
