// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines by the published method of Apollonius diagrams, for comparison. Internal.
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

/// Function that returns the index of the crossing of a level on an edge (its representative
/// half-edge), between two neighboring nodes of the edge.
using CrossingFinder = std::function<Id(Id halfEdge, Id interval)>;

/// A face subdivided into triangles on which the distance is linear: their corners are the nodes of
/// the three edges (dggHermiteEdge.h) and the nodes of the Apollonius diagram of the sites. Edges
/// of the diagram, straightened, are edges of triangles where possible.
///
/// The distance at a node of the diagram is that of the field inside the face (dggFaceProfile.h).
/// The distance of the diagram is an overestimate, because the path to the point need not start at
/// a site. An object can be reused for other faces, which saves allocations.
class ApolloniusFace
{
public:
  /// Prepares subdivisions for a field. A field with neither virtual sources nor windows is linear
  /// inside faces.
  ApolloniusFace(const DistanceField& field, int steinerPoints);

  /// Selects a face, which must be reached (DistanceField::IsReached()).
  void Enter(Id f);

  /// Returns the bounds of the distance in the face, as tight as values on its boundary allow.
  double GetSmallest() const { return this->Smallest; }
  double GetLargest() const { return this->Largest; }

  /// Appends the curves on which the distance is `level`, with the lower side on their left.
  void FindCurves(
    double level, Id number, const CrossingFinder& crossings, std::vector<FaceCurve>& curves);

private:
  /// A segment of the boundary of the face, counter-clockwise.
  struct RimPiece
  {
    int Begin;
    int End;
    Id HalfEdge;
    Id Interval;
  };

  /// A directed edge of a triangle.
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
  std::vector<bool> IsDone;                // per triangle, true if the isoline has visited it
};

/// Finds the isolines of increasing levels, edge by edge and face by face, from the Apollonius
/// diagrams of points on the boundaries of faces. The distance is a cubic along edges, and linear
/// in the triangles into which the diagrams subdivide faces. Along edges the distance is linear
/// between the nodes of HermiteEdge.
///
/// Both ends of a curve are crossings of its level. Each crossing is an end of exactly one curve in
/// each reached face of its edge, so that no curve dangles. Points at the level count as above. The
/// lower side is on the left of a curve with respect to the orientation of the face. Curves are
/// sorted by face and level. The result does not depend on the number of threads.
///
/// Directions are taken from Sources, which may be set in addition to windows. If neither is set,
/// directions are fitted to the distances (dggSourceFinding.h). Fails when stopped.
Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves);
}

#endif
