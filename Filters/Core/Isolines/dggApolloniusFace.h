// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines by the published method, as a comparison. Internal.
#ifndef dggApolloniusFace_h
#define dggApolloniusFace_h

#include "dggApolloniusDiagram.h" // for ApolloniusDiagram
#include "dggDistanceField.h"     // for DistanceField
#include "dggFaceProfile.h"       // for FaceProfile
#include "dggHermiteEdge.h"       // for HermiteEdge
#include "dggIsolineParts.h"      // for FaceCurve

#include <array>      // for corners
#include <functional> // for CrossingFinder
#include <utility>    // for directed edges
#include <vector>     // for nodes

namespace dgg
{
class FaceTriangulation;

/// Number of the crossing of a level on an edge (its representative half-edge), between two
/// neighbouring nodes of it.
using CrossingFinder = std::function<Id(Id halfEdge, Id interval)>;

/// A face cut into triangles on which the distance is linear: their corners are the nodes of its
/// three edges (dggHermiteEdge.h) and the nodes of the Apollonius diagram of its sites, and the
/// edges of the diagram, straightened, are edges of triangles where they can be.
///
/// The distance at a node of the diagram is that of the field inside the face (dggFaceProfile.h):
/// that of the diagram is an over-estimate, as the way to the point need not start at a site.
/// An object can be moved from face to face, which saves allocations.
class ApolloniusFace
{
public:
  /// The field must have virtual sources, or windows, or else is linear inside.
  ApolloniusFace(const DistanceField& field, int steinerPoints);

  /// Look at a face, which must be reached (DistanceField::IsReached()).
  void Enter(Id f);

  /// Bounds of the distance in the face, as good as can be had from the rim.
  double GetSmallest() const { return this->Smallest; }
  double GetLargest() const { return this->Largest; }

  /// Append the curves on which the distance is `level`, the lower side on their left.
  void FindCurves(
    double level, Id number, const CrossingFinder& crossings, std::vector<FaceCurve>& curves);

private:
  /// A piece of the rim, as it is run through counter-clockwise.
  struct RimPiece
  {
    int Begin;
    int End;
    Id HalfEdge;
    Id Interval;
  };

  /// One edge of a triangle, directed.
  struct TriangleEdge
  {
    int Begin;
    int End;
    int Triangle;
    bool operator<(const TriangleEdge& other) const
    {
      return this->Begin != other.Begin ? this->Begin < other.Begin : this->End < other.End;
    }
  };

  void AddRim();
  void Build();
  void AddDiagram(FaceTriangulation& triangulation);
  int FindRimNode(int side, double x) const;
  int TriangleOf(int begin, int end) const;
  bool IsBelow(int node, double level) const { return this->Values[node] < level; }
  std::array<double, 3> PlaceBetween(int a, int b, double level) const;
  std::pair<int, int> Follow(int begin, int end, double level, FaceCurve& curve);

  const DistanceField& Field;
  int NumberOfSteinerPoints;
  HermiteEdge Edge;
  FaceProfile Profile;
  ApolloniusDiagram Diagram;
  Id Face = NoId;
  bool IsBuilt = false;
  double Smallest = 0.0;
  double Largest = 0.0;
  std::vector<std::array<double, 3>> Places;
  std::vector<double> Values;
  std::vector<WeightedSite> Sites;
  std::array<std::vector<std::pair<double, int>>, 3> Sides; // abscissa and node, sorted
  std::vector<RimPiece> Rim;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<TriangleEdge> TriangleEdges; // sorted
  std::vector<bool> IsDone;                // triangles that the level has been followed through
};

/// The isolines of increasing levels, edge by edge and face by face, from the Apollonius diagrams
/// of points on the rims of faces: cubics along edges, linear in the triangles that the diagrams
/// cut faces into. Along edges the distance is linear between the nodes of HermiteEdge.
///
/// Both ends of a curve are crossings of its level; each crossing is an end of one curve in each of
/// the faces of its edge that are reached, so no curve dangles. Points at the level count as above
/// it; the lower side is on the left of a curve as seen with the orientation of the face. Curves
/// are in order of faces and levels. The result does not depend on threads.
///
/// Directions come from Sources, which may be there besides windows. Where neither is there, they
/// are fitted to the distances (dggSourceFinding.h). Fails when stopped.
Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves);
}

#endif
