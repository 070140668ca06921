// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results of tracing one source: edges found, and vertex labels. Internal.
#ifndef dggVertexStates_h
#define dggVertexStates_h

#include "dggCrossingBlocks.h" // for polar angles
#include "dggEdges.h"          // for faces behind an edge
#include "dggSurfacePoint.h"   // for sources that are no vertices
#include "dggUnfolding.h"      // for Point2

#include <cmath>  // for std::atan2
#include <vector> // for the states

namespace dgg
{
/// An edge found from a source, with the data from which its directions are computed.
struct FoundEdge
{
  Id Target = NoId; ///< id of the table
  double Length = 0.0;
  Point2 Departure;  ///< the target, in the plane of the source
  Id Frame = NoId;   ///< half-edge along the x axis of the plane: leaves the source, or belongs to
                     ///< the face that contains the source
  Point2 Reference;  ///< direction of the half-edge of arrival, in the plane
  Id Arrival = NoId; ///< half-edge of arrival, leaving the target
  bool IsMirrored = false; ///< true if the face of arrival is unfolded as its mirror image

  /// Returns the polar angle at the source, towards the target, radians.
  double DepartureAngle(const SurfaceMesh& mesh) const
  {
    return mesh.PolarAngle(this->Frame) + std::atan2(this->Departure.Y, this->Departure.X);
  }
  /// Returns the polar angle at the target, towards the source, radians.
  double ArrivalAngle(CrossingBlocks& crossings) const
  {
    const Point2 back{ -this->Departure.X, -this->Departure.Y };
    const double turn = std::atan2(Cross(this->Reference, back), Dot(this->Reference, back));
    return crossings.PolarAngle(this->Arrival) + (this->IsMirrored ? -turn : turn);
  }
};

/// Returns the direction of an edge from a point that is not a vertex, in the frame of its face.
inline double DepartureAngle(
  const SurfaceMesh& mesh, const SurfacePoint& point, const FoundEdge& edge)
{
  Id frame = edge.Frame;
  Point2 direction = edge.Departure;
  if (SurfaceMesh::Face(frame) != point.Face)
  {
    ForEachFaceBehind(mesh, point.HalfEdge, false, [&](Id e, bool isMirrored) {
      if (frame != point.HalfEdge && SurfaceMesh::Face(e) == SurfaceMesh::Face(frame))
      {
        direction = DirectionInFrame(mesh, frame, e, direction);
        direction = { isMirrored ? direction.X : -direction.X, -direction.Y };
        frame = point.HalfEdge;
      }
    });
  }
  direction = DirectionInFrame(mesh, frame, 3 * point.Face, direction);
  return std::atan2(direction.Y, direction.X);
}

/// Vertex states, reused from source to source: Reset() visits touched vertices only.
class VertexStates
{
public:
  struct State
  {
    double Label = Infinity; ///< length of a path from the source
    double Cost = Infinity;  ///< cost as a relay
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
