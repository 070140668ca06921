// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the windows of one source find: edges, and labels of vertices. Internal.
#ifndef dggVertexStates_h
#define dggVertexStates_h

#include "dggUnfolding.h"      // for Point2
#include "dggUnfoldingTable.h" // for polar angles

#include <cmath>  // for std::atan2
#include <vector> // for the states

namespace dgg
{
/// An edge found from a source, with what it takes to know its directions.
struct FoundEdge
{
  Id Target = NoId; ///< id of the table
  double Length = 0.0;
  Point2 Departure;  ///< the target, in the plane of the source
  Id Frame = NoId;   ///< half-edge along the x axis of the plane: leaves the source, or is one of
                     ///< the face that it lies in
  Point2 Reference;  ///< direction of the half-edge of arrival, in the plane
  Id Arrival = NoId; ///< that half-edge, leaving the target
  bool IsMirrored = false; ///< the face of arrival is seen in its mirror image

  /// Polar angle at the source, towards the target.
  double DepartureAngle(const UnfoldingTable& table) const
  {
    return table.PolarAngle(this->Frame) + std::atan2(this->Departure.Y, this->Departure.X);
  }
  /// Polar angle at the target, towards the source.
  double ArrivalAngle(const UnfoldingTable& table) const
  {
    const Point2 back{ -this->Departure.X, -this->Departure.Y };
    const double turn = std::atan2(Cross(this->Reference, back), Dot(this->Reference, back));
    return table.PolarAngle(this->Arrival) + (this->IsMirrored ? -turn : turn);
  }
};

/// Kept from source to source; only what a source has touched is reset.
class VertexStates
{
public:
  struct State
  {
    double Label = Infinity; ///< length of a path from the source
    double Cost = Infinity;  ///< as a relay
    Id Edge = NoId;          ///< index into the edges found
    bool IsTouched = false;
  };

  explicit VertexStates(Id numberOfVertices)
    : States(numberOfVertices)
  {
  }

  const State& operator[](Id v) const { return this->States[v]; }
  State& Touch(Id v)
  {
    State& state = this->States[v];
    if (!state.IsTouched)
    {
      state.IsTouched = true;
      this->Touched.push_back(v);
    }
    return state;
  }

  void Reset()
  {
    for (const Id v : this->Touched)
    {
      this->States[v] = State();
    }
    this->Touched.clear();
  }

private:
  std::vector<State> States;
  std::vector<Id> Touched;
};
}

#endif
