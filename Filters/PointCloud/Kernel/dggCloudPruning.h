// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of the neighbours of a point of a cloud become edges. Internal.
#ifndef dggCloudPruning_h
#define dggCloudPruning_h

#include "dggCloudPairs.h" // for CloudPairs
#include "dggTypes.h"      // for Id

#include <cstdint> // for places of relays
#include <vector>  // for edges

namespace dgg
{
/// Chooses the edges of one point after the other by the progress rule: a neighbour q of p is left
/// out when an edge (p, r) was kept with w(p, r) / (1 + accuracy) + w(r, q) <= w(p, q), and r and q
/// are connected directly. Then no path gets longer by more than the accuracy: the proof for meshes
/// uses nothing but lengths. One per thread.
class CloudPruning
{
public:
  /// With an accuracy of 0 all neighbours that are connected directly are kept.
  CloudPruning(const CloudPairs& pairs, double accuracy);

  /// `neighbors` are in the order of their distance from p, `chords` are these distances. Appends
  /// the neighbours that are kept to `kept`.
  void ChooseEdges(Id p, const std::vector<Id>& neighbors, const std::vector<double>& chords,
    std::vector<Id>& kept);

private:
  struct Relay
  {
    Id Point;
    std::int32_t Next; ///< the one kept before it in the same direction
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
  std::vector<std::int32_t> Last; ///< per sector, the relay kept last
};
}

#endif
