// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance along one edge as a cubic, and the points at which it is sampled. Internal.
#ifndef dggHermiteEdge_h
#define dggHermiteEdge_h

#include "dggCornerModel.h"   // for the models of the ends
#include "dggDistanceField.h" // for DistanceField

#include <array>  // for the ends
#include <vector> // for the nodes

namespace dgg
{
/// A point of an edge at which the published method samples the distance.
struct RimNode
{
  double X = 0.0;      ///< abscissa
  double Value = 0.0;  ///< distance
  bool IsSite = false; ///< true for ends and Steiner points; false for ties of neighboring sites
};

/// The distance along one edge as a cubic that interpolates the values and slopes at the ends of
/// the edge. The slopes follow from the directions of the virtual sources, with or without windows.
/// An end without a virtual source takes the slope of the chord.
///
/// If the shortest paths to the two ends take different routes, a cubic would smooth the ridge
/// between them. In this case the distance is the minimum of the distances from the virtual sources
/// of the two ends.
///
/// The result depends only on the edge, not on the face from which it is computed.
class HermiteEdge
{
public:
  HermiteEdge(const DistanceField& field, int steinerPoints)
    : Field(field)
    , NumberOfSteinerPoints(steinerPoints)
  {
  }

  /// Selects the edge of a half-edge, whose ends must be reached.
  void Enter(Id h);

  /// Returns the half-edge that represents the edge. Abscissae run from its origin to its
  /// destination.
  Id GetHalfEdge() const { return this->HalfEdge; }
  double GetLength() const { return this->Length; }

  /// Returns the distance at an abscissa. At the ends, the result is the distance of the vertex.
  double At(double x) const;

  /// Returns the ends, the evenly spaced Steiner points and the ties of neighboring sites, without
  /// sites that are nearest at no point; in order of strictly increasing abscissae.
  const std::vector<RimNode>& GetNodes() const { return this->Nodes; }

private:
  void SetUpEnds();
  void PlaceNodes();

  const DistanceField& Field;
  int NumberOfSteinerPoints;
  Id HalfEdge = NoId;
  double Length = 0.0;
  std::array<double, 2> Ends{ { 0.0, 0.0 } };
  std::array<double, 2> Rises{ { 0.0, 0.0 } }; // slope times length, towards the destination
  std::array<CornerModel, 2> Models;
  std::array<double, 2> PolarAngles{ { 0.0, 0.0 } }; // polar angles of the edge at its ends
  bool IsSplit = false;
  std::vector<RimNode> Nodes;
  std::vector<RimNode> Kept; // sites that are nearest somewhere on the edge
};
}

#endif
