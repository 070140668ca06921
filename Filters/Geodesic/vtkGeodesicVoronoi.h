// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicVoronoi
 * @brief   which of some sites is nearest along a surface
 *
 * Computes the geodesic Voronoi diagram of sites on a surface: the nearest site of every point, the
 * borders of the cells, which cross faces, and the cells as polygons. With Centroidal, the sites
 * are moved to the middle of their cells first. The distances are those of a discrete geodesic
 * graph, which is taken from the input, or built and kept, as in vtkDGGDistance; they are corrected
 * as there.
 *
 * Input port 0 takes the surface. Sites are points of the surface given by id (AddSiteId(),
 * SetSiteIds()) and the points of a vtkPolyData on the optional input port 1 (SetSiteConnection(),
 * SetSiteData()), which may lie anywhere on the surface and are projected to it. Sites are numbered
 * from 0: ids first, then the points of port 1. A site at the place of an earlier one has no cell.
 *
 * There are four outputs; all but the first one are new geometry, see vtkGeodesicAlgorithm.
 *  - Port 0 (GetOutput()): the input with the point arrays `GeodesicSource` (int), the number of
 * the nearest site, of several at the same distance the first one, and `GeodesicDistance` (double),
 *    the distance from it. Points that no site reaches get -1 and UnreachedValue. With Centroidal,
 *    the field array `Energy`, see below.
 *  - Port 1 (GetBoundaries()): the borders between cells as polylines on the surface, with the cell
 *    array `SiteId` (int, two components, the smaller number first) and the point array
 *    `GeodesicDistance`, from either site. A polyline goes on as long as the two cells do; where
 *    they meet all around, it is closed.
 *  - Port 2 (GetCells()): the surface cut into polygons along the borders. Their cell arrays
 *    are `SiteId` (int; -1 where no site reaches), `CellArea` (double), the area of the whole cell
 *    that the polygon is a part of, and `FaceId`, the cell of the input. The first points are those
 *    of the input, in their order; the point array is `GeodesicDistance`.
 *  - Port 3 (GetSites()): the sites as points with verts, after they have been moved, with the
 * point arrays `SiteId`, `CellArea`, `vtkOriginalPointIds` (-1 for a site that is no point of the
 *    input) and `FaceId`, as in vtkGeodesicSampler.
 *
 * Borders and cells have no gaps and do not overlap: neighbouring polygons share points. Borders
 * that pass a point of the surface within 1e-5 of an edge pass through it, so that polygons have no
 * needless slivers there and can be triangulated.
 *
 * <b>What is promised.</b> Distances at points of the input are within the accuracy of the graph of
 * the exact ones, unless its rule has no guarantee. Inside a triangle, the square of the distance
 * from a site is taken for that of a point in its plane, so borders are straight within triangles.
 * This is exact where the surface is flat. With
 * RefineBoundaries, border points where it is in doubt, in triangles that are large compared to
 * cells and behind points where geodesics bend, are linked to the graph and moved. The distances of
 * a border point from its sites then differ by a small part of the accuracy on average, and by less
 * than twice the accuracy but for few points close to where three cells meet. Where triangles are
 * about as large as cells, subdivide the surface first. Among non-manifold edges and triangles of
 * near-zero area its work is limited, to some twenty times that on a clean mesh of that size, and
 * border points after that stay where they were. Cells that are smaller than triangles are found
 * where triangles have corners in different cells. The result does not depend on the number of
 * threads.
 *
 * <b>Centroidal diagrams.</b> Lloyd's iteration makes the energy smaller, the sum over all points
 * of area times squared distance from the nearest site, where a point has a third of the area of
 * its triangles. It moves every site along the surface towards the mean of its cell, as seen from
 * the site, and stops after NumberOfIterations, when no site would move by more than Tolerance, or
 * when the energy does not get smaller any more. The field array `Energy` has the energy at the
 * start and after each iteration; it decreases.
 *
 * <b>Point clouds.</b> On a cloud with the graph of vtkPointCloudDGG, output 0 is as above, with
 * the distances in that graph. There are no faces, so outputs 1 and 2 are empty and port 3 has no
 * CellArea, whatever GenerateCells says. With Centroidal, sites are points of the cloud from the
 * start on; the energy is the sum of the squared distances of all points, which count equally, so
 * that sites gather where points do; each site moves to the point of its cell that is closest to
 * the mean of the cell, as seen from the site. Tolerance, Accuracy and AcceptCoarserGraph do
 * nothing.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no site; a site id out of range; a site point that is not finite, or farther from the surface
 *    than ProjectionTolerance; a ProjectionTolerance or Tolerance that is negative or not a number;
 *    a negative NumberOfIterations; a missing or repeated array name;
 *  - an Accuracy outside [1e-6, 0.5]; a graph that would take more memory than MemoryLimit.
 *
 * @code
 * vtkNew<vtkGeodesicVoronoi> voronoi;
 * voronoi->SetInputConnection(reader->GetOutputPort());
 * voronoi->SetSiteIds({ 0, 1000, 2000 });
 * voronoi->Update();
 * vtkPolyData* cells = voronoi->GetCells(); // colour by SiteId
 * @endcode
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkGeodesicSampler vtkDGGDistance
 */

#ifndef vtkGeodesicVoronoi_h
#define vtkGeodesicVoronoi_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <string> // For array names
#include <vector> // For site ids

class vtkDGGNewGeometry;
struct vtkDGGSourceSet;
struct vtkDGGVoronoiResult;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicVoronoi : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicVoronoi* New();
  vtkTypeMacro(vtkGeodesicVoronoi, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sites by point id of the input. Ids are copied; none by default. An id outside
   * [0, number of points - 1] is an error of the update. A null list removes all ids. The
   * i-th id is -1 when there is none.
   */
  vtkDGGIdsMacro(Site);
  ///@}

  /**
   * Remove the site ids and disconnect input port 1.
   */
  void RemoveAllSites();

  ///@{
  /**
   * Sites anywhere on the surface: the points of a vtkPolyData on input port 1, as from a
   * vtkGeodesicSampler; its cells are not used. Null removes them.
   */
  void SetSiteConnection(vtkAlgorithmOutput* output);
  void SetSiteData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Whether to move the sites to the middle of their cells. Default off.
   */
  vtkSetMacro(Centroidal, bool);
  vtkGetMacro(Centroidal, bool);
  vtkBooleanMacro(Centroidal, bool);
  ///@}

  ///@{
  /**
   * How often the sites are moved at most. Default 20; must not be negative.
   */
  vtkSetMacro(NumberOfIterations, int);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Sites are moved no more when none of them would move farther than this, as a part of the mean
   * edge length. Default 0.001; must not be negative.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Whether to make cells and boundaries. When off, outputs 1 and 2 are empty, and port 3 has no
   * CellArea. The labels of the points then come from a single search, which is many times faster:
   * they are those of the nearest sites in the graph, before distances are corrected, so that a
   * point about as far from two sites may get the other one. Default on.
   */
  vtkSetMacro(GenerateCells, bool);
  vtkGetMacro(GenerateCells, bool);
  vtkBooleanMacro(GenerateCells, bool);
  ///@}

  ///@{
  /**
   * Whether border points of which the triangles around do not give the place well enough are
   * linked to the graph and moved, see above. Takes the longer the larger triangles are compared to
   * cells. Default on.
   */
  vtkSetMacro(RefineBoundaries, bool);
  vtkGetMacro(RefineBoundaries, bool);
  vtkBooleanMacro(RefineBoundaries, bool);
  ///@}

  ///@{
  /**
   * Distance given to points that no site reaches. Default NaN. With another number a point array
   * marks them, as with distance filters (vtkGeodesicDistanceAlgorithm::SetUnreachedValue()).
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
   * The outputs besides GetOutput().
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
   * How far from the surface a point of port 1 may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Properties of the graph, which all filters that search one have, and numbers of it.
   *
   * - Accuracy: largest relative error of the graph that is built when the input has none, in
   *   [1e-6, 0.5]. Default 0.01. Another value is an error of the update even when the graph on the
   *   input is used.
   * - AcceptCoarserGraph: whether a graph on the input that promises less than an Accuracy that was
   *   set is used without a warning. Default off.
   * - MemoryLimit: most bytes that building a graph may take, or preparing to link points that are
   *   not vertices (some 250 bytes per triangle). Default 0, which stands for 70 % of the memory
   *   that is free at that time.
   * - Of the graph of the last update, zero when there is none: whether it is that on the input,
   *   its accuracy (0 for a SaddleVertexGraph), number of directed edges, and about the bytes with
   *   what searches and links need; they stay what they were when its arrays are changed later.
   *   Whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicVoronoi();
  ~vtkGeodesicVoronoi() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicVoronoi(const vtkGeodesicVoronoi&) = delete;
  void operator=(const vtkGeodesicVoronoi&) = delete;

  vtkDGGSourceSet GetSiteSet(vtkInformationVector** inputVector) const;
  dgg::Status Compute(const vtkDGGContext& context, vtkDGGVoronoiResult& result);
  void FillOutputs(const vtkDGGContext& context, const vtkDGGVoronoiResult& result,
    const vtkDGGNewGeometry& geometry, vtkInformationVector* outputVector) const;

  std::vector<vtkIdType> SiteIds;
  bool Centroidal;
  int NumberOfIterations;
  double Tolerance;
  bool GenerateCells;
  bool RefineBoundaries;
  double UnreachedValue;
  std::string DistanceArrayName;
  std::string SourceArrayName;
  double ProjectionTolerance;
  std::unique_ptr<vtkDGGGraphUser> GraphUser;
};

#endif
