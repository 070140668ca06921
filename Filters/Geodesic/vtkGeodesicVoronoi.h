// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicVoronoi
 * @brief   nearest sites, and their cells, along a surface
 *
 * <b>Input and output</b>. Sites are point ids and the points of the optional input port 1
 * (SetSiteConnection()), projected to the surface and numbered from 0, ids first. A site at the
 * position of an earlier one has no cell. The graph is taken from the input or built by this
 * filter, see vtkGeodesicAlgorithm. Outputs 1 to 3 are new geometry.
 *  - Output 0: the input with the point arrays `GeodesicSource` (int), the nearest site (the
 *    first of several), and `GeodesicDistance` (double), its distance; -1 and UnreachedValue if
 *    no site reaches the point. With Centroidal also the field array `Energy` (double), see
 *    Centroidal.
 *  - Output 1 (GetBoundaries()): borders of cells as polylines; cell array `SiteId` (int, two
 *    components, the smaller first), point array `GeodesicDistance`.
 *  - Output 2 (GetCells()): the surface cut into polygons along the borders, without gaps. Cell
 *    arrays `SiteId` (int, -1 if unreached), `CellArea` (double; area of the cell of the site),
 *    `FaceId`; point array `GeodesicDistance`. The first points are the input points. A cell has
 *    one or more polygons in a triangle.
 *  - Output 3 (GetSites()): sites, after moves, with verts; point arrays `SiteId`, `CellArea`,
 *    `vtkOriginalPointIds` (-1 for a site that is no point of the input), `FaceId`, `Barycentric`.
 *
 * On a cloud, outputs 1 and 2 are empty and output 3 has no CellArea.
 *
 * <b>Guarantee and cost</b>. Distances at points of the input are within the accuracy of the graph,
 * if its rule has a guarantee. Borders are straight in each triangle and have no error bound; those
 * that pass a point within 1e-5 of an edge pass through it. Where the graph is not accurate enough
 * for borders, distances and borders are exact instead: see RefineBoundaries. Where more than three
 * cells meet, tiny borders may separate cells that touch in one point.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; no site; an id out of range; a site that is
 * not finite or beyond ProjectionTolerance; an array name that is empty or used twice; a graph
 * beyond MemoryLimit. The module page is Filters/Geodesic/Curves.md.
 * @sa vtkGeodesicSampler vtkDGGDistance
 */

#ifndef vtkGeodesicVoronoi_h
#define vtkGeodesicVoronoi_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <limits> // For UnreachedValue
#include <string> // For array names
#include <vector> // For site ids

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicVoronoi : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicVoronoi* New();
  vtkTypeMacro(vtkGeodesicVoronoi, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sites by point id of the input. None by default; an id out of range is an error of the update.
   * A null list removes all; the i-th id is -1 if there is none.
   */
  vtkDGGIdsMacro(Site);
  ///@}

  /**
   * Remove the site ids and disconnect input port 1.
   */
  void RemoveAllSites();

  ///@{
  /**
   * Sites anywhere on the surface: the points of a vtkPolyData on input port 1. Null removes them.
   */
  void SetSiteConnection(vtkAlgorithmOutput* output);
  void SetSiteData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * If on, each site moves toward the mean of its cell (Lloyd's iteration: Q. Du, V. Faber, M.
   * Gunzburger, "Centroidal Voronoi tessellations", SIAM Rev. 41(4), 1999). This reduces the
   * energy: the sum over points of area times squared distance from the nearest site. The field
   * array `Energy` (double) of output 0 contains it at the start and after each iteration. On
   * clouds sites are points and each point has the same weight. Default off.
   */
  vtkSetMacro(Centroidal, bool);
  vtkGetMacro(Centroidal, bool);
  vtkBooleanMacro(Centroidal, bool);
  ///@}

  ///@{
  /**
   * Largest number of moves of the sites. Default 20; not negative. Moves also stop when the energy
   * no longer decreases.
   */
  vtkSetMacro(NumberOfIterations, int);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Sites stop if none would move farther than this, as a fraction of the mean edge length. Default
   * 0.001; not negative. Not used on clouds.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * If on, make cells and borders. If off, outputs 1 and 2 are empty, there is no CellArea, and
   * labels come from a single search before distances are corrected. This is many times faster, but
   * a point at nearly the same distance from two sites may get the other site. Default on.
   */
  vtkSetMacro(GenerateCells, bool);
  vtkGetMacro(GenerateCells, bool);
  vtkBooleanMacro(GenerateCells, bool);
  ///@}

  ///@{
  /**
   * If on, points are labeled immediately and without a graph by vtkVirtualSourceGeodesicDistance.
   * Errors of distances have no bound, and a point at nearly the same distance from two sites may
   * get the other site. As with GenerateCellsOff(), outputs 1 and 2 are empty. The update fails
   * with Centroidal and on clouds. Default off.
   */
  vtkSetMacro(Preview, bool);
  vtkGetMacro(Preview, bool);
  vtkBooleanMacro(Preview, bool);
  ///@}

  ///@{
  /**
   * If on, refine inaccurate borders. Border points that the surrounding triangles do not determine
   * accurately are linked to the graph and moved, with limited work. Distances and borders are
   * exact instead, and cells may have curved sides in triangles, if GetMeanAnisotropy() is above 2,
   * if accuracy times the largest distance is less than a quarter of the mean edge (weighted by
   * area), or if the distances from two sites differ by more than 1.5 times the accuracy in the
   * middle of a border segment. This takes longer than a vtkExactGeodesicDistance from the sites.
   * If windows exceed MemoryLimit, the filter warns and uses the graph. Without cells, and to move
   * sites (Centroidal), distances are always those of the graph. Default on.
   */
  vtkSetMacro(RefineBoundaries, bool);
  vtkGetMacro(RefineBoundaries, bool);
  vtkBooleanMacro(RefineBoundaries, bool);
  ///@}

  ///@{
  /**
   * If on, points of output 0, cells of output 2 and sites of output 3 also get the point arrays of
   * port 1, such as names of the sites: see vtkGeodesicDistanceAlgorithm::SetPassSourceArrays().
   * Default off.
   */
  vtkSetMacro(PassSiteArrays, bool);
  vtkGetMacro(PassSiteArrays, bool);
  vtkBooleanMacro(PassSiteArrays, bool);
  ///@}

  ///@{
  /**
   * Distance of points that no site reaches. Default NaN; finite values are marked as in
   * vtkGeodesicDistanceAlgorithm.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances. Default "GeodesicDistance".
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the nearest sites. Default "GeodesicSource".
   */
  vtkDGGStringMacro(SourceArrayName);
  ///@}

  ///@{
  /**
   * Return the outputs other than GetOutput().
   */
  vtkPolyData* GetBoundaries();
  vtkPolyData* GetCells();
  vtkPolyData* GetSites();
  vtkAlgorithmOutput* GetBoundariesPort() { return this->GetOutputPort(1); }
  vtkAlgorithmOutput* GetCellsPort() { return this->GetOutputPort(2); }
  vtkAlgorithmOutput* GetSitesPort() { return this->GetOutputPort(3); }
  ///@}

  ///@{
  /**
   * Largest distance of a point of port 1 from the surface, as a fraction of the diagonal of the
   * surface's bounding box; a farther point is an error. Default 0.01; not negative. 0 accepts
   * points on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of a graph that is built (default 0.01;
   * outside [1e-6, 0.5] an error), AcceptCoarserGraph (default off), and values of the graph of the
   * last update.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicVoronoi();
  ~vtkGeodesicVoronoi() override = default;

private:
  vtkGeodesicVoronoi(const vtkGeodesicVoronoi&) = delete;
  void operator=(const vtkGeodesicVoronoi&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  std::vector<vtkIdType> SiteIds;
  bool Centroidal = false;
  int NumberOfIterations = 20;
  double Tolerance = 1e-3;
  bool GenerateCells = true;
  bool Preview = false;
  bool RefineBoundaries = true;
  bool PassSiteArrays = false;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  std::string DistanceArrayName = "GeodesicDistance";
  std::string SourceArrayName = "GeodesicSource";
  double ProjectionTolerance = 0.01;
};

#endif
