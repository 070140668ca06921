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
/// A point of an edge at which the published isolines know the distance.
struct RimNode
{
  double X = 0.0;      ///< abscissa
  double Value = 0.0;  ///< distance
  bool IsSite = false; ///< an end or a Steiner point; else a tie of two neighbouring sites
};

/// The distance along an edge as a cubic with the values and slopes of its ends. The slopes follow
/// from the directions of the virtual sources, whether the field has windows or not; an end without
/// one takes the slope of the chord.
///
/// Where the ends get their distance on different ways, a cubic would smooth the ridge between
/// them: there the distance is the smaller one of what the virtual sources of the ends say.
///
/// All of it depends on the edge and not on the face that it is looked at from.
class HermiteEdge
{
public:
  HermiteEdge(const DistanceField& field, int steinerPoints)
    : Field(field)
    , NumberOfSteinerPoints(steinerPoints)
  {
  }

  /// Look at the edge of a half-edge, whose ends must be reached.
  void Enter(Id h);

  /// The half-edge that represents the edge. Abscissae run from its origin to its destination.
  Id GetHalfEdge() const { return this->HalfEdge; }
  double GetLength() const { return this->Length; }

  /// The distance at an abscissa. At the ends it is that of the vertex.
  double At(double x) const;

  /// The ends, the Steiner points, evenly spaced, and the ties of neighbouring sites, those not
  /// counted that another site comes before everywhere; in order of abscissae, all different.
  const std::vector<RimNode>& GetNodes() const { return this->Nodes; }

private:
  void SetUpEnds();
  void PlaceNodes();

  const DistanceField& Field;
  int NumberOfSteinerPoints;
  Id HalfEdge = NoId;
  double Length = 0.0;
  std::array<double, 2> Ends{ { 0.0, 0.0 } };
  std::array<double, 2> Rises{ { 0.0, 0.0 } }; // slope times length, from the origin on
  std::array<CornerModel, 2> Models;
  std::array<double, 2> PolarAngles{ { 0.0, 0.0 } }; // of the edge at its ends
  bool IsSplit = false;
  std::vector<RimNode> Nodes;
  std::vector<RimNode> Kept; // sites that are nearest somewhere on the edge
};
}

#endif
