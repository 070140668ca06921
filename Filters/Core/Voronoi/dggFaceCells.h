// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells within a face. Internal.
#ifndef dggFaceCells_h
#define dggFaceCells_h

#include "dggEdgeCuts.h"      // for the cuts
#include "dggSiteDistances.h" // for the distances
#include "dggVoronoi.h"       // for the diagram

#include <array>  // for coordinates
#include <vector> // for the polygons

namespace dgg
{
class BorderRefinement;

/// A point of a diagram and its position in a face.
struct CellPoint
{
  Id Number;
  std::array<double, 3> Place;
};

/// A region of a face that belongs to one site.
struct FaceCell
{
  Id Site;
  std::vector<CellPoint> Points;

  /// Returns the fraction of the face that the region covers.
  double GetFraction() const;
  /// Appends the region as a polygon.
  void AddTo(const SurfaceMesh& mesh, Id face, VoronoiDiagram& diagram) const;
};

/// Cuts faces along the borders of cells: for each site at the corners of a face, the face is
/// clipped by the lines on which the site and another one are equidistant. Crossings with the sides
/// of the face are taken from the cuts of the edges.
///
/// If all sites tie or a face is a needle, rounding may lead to inconsistent polygons. This is
/// detected, and the face is then cut by a simpler scheme: from the cuts of its sides to a point in
/// the middle.
class FaceCells
{
public:
  /// Polygons and border points are appended to the diagram. The refinement may be null.
  FaceCells(const SurfaceMesh& mesh, const SiteDistances& distances, const EdgeCuts& cuts,
    const BorderRefinement* refinement, VoronoiDiagram& diagram);

  /// Cuts a face, which must not be dropped (SurfaceMesh::IsDropped()).
  void Cut(Id face);

private:
  using Coordinates = std::array<double, 3>;

  /// A site and its squared distances at the corners, minus the term that is common to all sites.
  struct Site
  {
    Id Number;
    Coordinates Values;
  };

  /// A corner of a polygon, and the border on which the side that leaves it lies: the side of the
  /// face of that index or, from 3 on, the line between the site and site Border - 3 of the list.
  struct Corner
  {
    Coordinates Place;
    int Border;
  };
  using Polygon = std::vector<Corner>;

  void AddWhole(Id face);
  void CollectSites(Id face);
  void Clip(std::size_t site, Polygon& polygon) const;
  CellPoint PointOf(Id face, std::size_t site, int before, const Corner& corner);
  CellPoint PointOnSide(Id face, int side, Id site, Id other, const Coordinates& place) const;
  CellPoint PointInside(
    Id face, const std::array<Id, 3>& sites, Coordinates place, double squaredDistance);
  void CutByLines(Id face);
  void CutFromCenter(Id face);
  bool IsConsistent() const;
  void CheckBorders(Id face);
  void WalkAround(Id face);
  double MeasureAt(Id face, Id site, const Coordinates& place) const;
  void AddCell(Id site, const std::vector<CellPoint>& points);

  const SurfaceMesh& Mesh;
  const SiteDistances& Distances;
  const EdgeCuts& Cuts;
  const BorderRefinement* Refinement;
  VoronoiDiagram& Diagram;

  // State of the current face.
  std::array<std::vector<EdgeCut>, 3> Sides;
  std::vector<CellPoint> Around; ///< corners and cuts, in order around the face
  std::vector<Id> Owners;        ///< site of the segment from each of these points to the next
  std::vector<FaceCell> Cells;
  std::vector<Site> Sites;
  std::vector<CellPoint> Inside; ///< positions before refinement
  std::vector<CellPoint> Refined;
};
}

#endif
