// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of Voronoi cells within a face. Internal.
#ifndef dggFaceCells_h
#define dggFaceCells_h

#include "dggBorderCurves.h"  // for borders
#include "dggEdgeCuts.h"      // for the cuts
#include "dggSiteDistances.h" // for the distances
#include "dggVoronoi.h"       // for the diagram

#include <array>  // for coordinates
#include <vector> // for the polygons

namespace dgg
{
class BorderRefinement;

/// Cuts faces along the borders of cells: for each site that a face knows, the face is clipped by
/// the lines on which the site is as near as another one. What crosses the sides of the face is
/// taken from the cuts of the edges.
///
/// Where all is tied or a face is a needle, rounding may let the polygons of a face contradict each
/// other. This is noticed, and the face is cut in a plainer way: from the cuts of its sides to a
/// point in the middle.
class FaceCells
{
public:
  /// Appends polygons and border points to the diagram, and what separates cells to the borders.
  /// The refinement may be null.
  FaceCells(const SurfaceMesh& mesh, const SiteDistances& distances, const EdgeCuts& cuts,
    const BorderRefinement* refinement, VoronoiDiagram& diagram, BorderCurves& borders);

  /// One face that has not been dropped.
  void Cut(Id face);

private:
  using Coordinates = std::array<double, 3>;

  /// A site and its squared distances at the corners, less the part that all sites have in common.
  struct Site
  {
    Id Number;
    Coordinates Values;
  };

  /// A corner of a polygon, and what the side that leaves it lies on: the side of the face of that
  /// number, or, from 3 on, the line between the site and that of number Border - 3 in the list.
  struct Corner
  {
    Coordinates Place;
    int Border;
  };
  using Polygon = std::vector<Corner>;

  /// A point of the diagram and its place in the face.
  struct Point
  {
    Id Number;
    Coordinates Place;
  };

  /// The part of the face that belongs to a site.
  struct Cell
  {
    Id Site;
    std::vector<Point> Points;
  };

  void AddWhole(Id face);
  void CollectSites(Id face);
  void Clip(std::size_t site, Polygon& polygon) const;
  Point PointOf(Id face, std::size_t site, int before, const Corner& corner);
  Point PointOnSide(Id face, int side, Id site, Id other, const Coordinates& place) const;
  Point PointInside(
    Id face, const std::array<Id, 3>& sites, Coordinates place, double squaredDistance);
  void CutByLines(Id face);
  void CutPlainly(Id face);
  bool IsConsistent() const;
  static double PartOf(const Cell& cell);
  void WalkAround(Id face);
  void AddPieces();
  void AddCell(Id site, const std::vector<Point>& points);
  void AddPolygon(Id face, const Cell& cell);

  const SurfaceMesh& Mesh;
  const SiteDistances& Distances;
  const EdgeCuts& Cuts;
  const BorderRefinement* Refinement;
  VoronoiDiagram& Diagram;
  BorderCurves& Borders;

  // Of the face at work.
  std::array<std::vector<EdgeCut>, 3> Sides;
  std::vector<Point> Around; ///< corners and cuts, in order
  std::vector<Id> Owners;    ///< site of the way from each of these to the next
  std::vector<Id> HalfEdges; ///< that it lies on
  std::vector<Cell> Cells;
  std::vector<Site> Sites;
  std::vector<Point> Inside; ///< places before refinement
  std::vector<Point> Refined;
};
}

#endif
