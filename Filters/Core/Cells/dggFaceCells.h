// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of Voronoi cells within a face. Internal.
#ifndef dggFaceCells_h
#define dggFaceCells_h

#include "dggEdgeCuts.h"      // for the cuts
#include "dggSiteDistances.h" // for the distances
#include "dggVoronoi.h"       // for the diagram

#include <array>  // for coordinates
#include <vector> // for the polygons

namespace dgg
{
/// A piece of the border between two cells.
struct BorderPiece
{
  std::array<Id, 2> Sites; ///< the smaller one first
  std::array<Id, 2> Points;
};

/// Cuts faces along the borders of cells: for each site that a face knows, the face is clipped by
/// the lines on which the site is as near as another one. What crosses the sides of the face is
/// taken from the cuts of the edges.
class FaceCells
{
public:
  /// Appends polygons, border points and pieces.
  FaceCells(const SurfaceMesh& mesh, const SiteDistances& distances, const EdgeCuts& cuts,
    VoronoiDiagram& diagram, std::vector<BorderPiece>& pieces);

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

  void AddWhole(Id face);
  void CollectSites(Id face);
  void Clip(std::size_t site, Polygon& polygon) const;
  Point PointOf(Id face, std::size_t site, int before, const Corner& corner);
  Point PointOnSide(Id face, int side, Id site, Id other, const Coordinates& place) const;
  Point PointInside(Id face, const Coordinates& place, double squaredDistance);
  void AddPieces(
    Id face, std::size_t site, const Polygon& polygon, const std::vector<Point>& points);
  void AddPiece(Id site, Id other, Id a, Id b);
  void AddPolygon(Id face, Id site, const std::vector<Point>& points);

  const SurfaceMesh& Mesh;
  const SiteDistances& Distances;
  const EdgeCuts& Cuts;
  VoronoiDiagram& Diagram;
  std::vector<BorderPiece>& Pieces;

  // Of the face at work.
  std::array<std::vector<EdgeCut>, 3> Sides;
  std::vector<Site> Sites;
  std::vector<Point> Inside;
  std::vector<BorderPiece> FacePieces;
};
}

#endif
