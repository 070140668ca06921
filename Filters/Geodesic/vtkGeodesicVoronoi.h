// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicVoronoi
 * @brief   which of some sites is nearest along a surface
 *
 * <b>Input and output</b>. Sites are point ids and the points of the optional input port 1
 * (SetSiteConnection()), projected to the surface and numbered from 0, ids first. One in the place
 * of an earlier one has no cell. The graph is that on the input, or built here, see
 * vtkGeodesicAlgorithm. Outputs 1 to 3 are new geometry.
 *  - Output 0: the input with the point arrays `GeodesicSource` (int), the nearest site, the first
 *    one of several, and `GeodesicDistance` (double), the distance from it; -1 and UnreachedValue
 *    where no site reaches. With Centroidal the field array `Energy` (double), at the start and
 *    after each iteration.
 *  - Output 1 (GetBoundaries()): borders between cells as polylines; cell array `SiteId` (int, two
 *    components, the smaller one first), point array `GeodesicDistance`.
 *  - Output 2 (GetCells()): the surface cut into polygons along the borders, without gaps; cell
 *    arrays `SiteId` (int, -1 where no site reaches), `CellArea` (double), the area of the whole
 *    cell, `FaceId`. The first points are those of the input; point array `GeodesicDistance`.
 *  - Output 3 (GetSites()): the sites, moved, with verts; point arrays `SiteId`, `CellArea`,
 *    `vtkOriginalPointIds` (-1 for a site that is no point of the input), `FaceId`,
 *    `Barycentric`.
 *
 * Centroidal moves each site towards the mean of its cell (Lloyd's iteration) and so reduces the
 * energy: the sum over points of area times squared distance from the nearest site. It stops after
 * NumberOfIterations, or when no site would move by more than Tolerance, or energy does not fall.
 *
 * On a cloud, outputs 1 and 2 are empty and output 3 has no CellArea. Centroidal sites are points
 * of the cloud, each point counts the same, and Tolerance does nothing.
 *
 * <b>Guarantee and cost</b>. Distances at points of the input are within the accuracy of the graph,
 * if its rule has a guarantee. Borders are straight in each triangle, which is exact where the
 * surface is flat; RefineBoundaries improves them elsewhere, with limited work. Where triangles are
 * as large as cells, subdivide the surface first. Borders that pass a point within 1e-5 of an edge
 * pass through it. The search goes on into neighbouring cells as far as they may matter; not so
 * with GenerateCellsOff().
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - no site; a site id out of range; a site point that is not finite, or farther from the surface
 *    than ProjectionTolerance; a ProjectionTolerance or Tolerance that is negative or NaN; a
 *    negative NumberOfIterations; an array name that is empty or used twice;
 *  - an Accuracy outside [1e-6, 0.5]; a graph that takes more than MemoryLimit; Preview with
 *    Centroidal or on a cloud.
 *
 * @code
 * vtkNew<vtkGeodesicVoronoi> voronoi;
 * voronoi->SetInputConnection(reader->GetOutputPort());
 * voronoi->SetSiteIds({ 0, 1000, 2000 });
 * voronoi->CentroidalOn();
 * voronoi->Update();
 * vtkPolyData* cells = voronoi->GetCells(); // colour by SiteId
 * @endcode
 *
 * <b>Source</b>. Q. Du, V. Faber, M. Gunzburger, "Centroidal Voronoi tessellations", SIAM Rev.
 * 41(4), 1999, with distances in the graph of vtkDiscreteGeodesicGraph.
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

class DGGNewGeometry;
class DGGPropagation;
struct DGGSourceSet;
namespace dgg
{
}
struct DGGVoronoiResult;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicVoronoi : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicVoronoi* New();
  vtkTypeMacro(vtkGeodesicVoronoi, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sites by point id of the input. None by default; an id out of range is an error of the update.
   * A null list removes all; the i-th id is -1 where there is none.
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
   * Whether to move the sites to the middle of their cells. Default off.
   */
  vtkSetMacro(Centroidal, bool);
  vtkGetMacro(Centroidal, bool);
  vtkBooleanMacro(Centroidal, bool);
  ///@}

  ///@{
  /**
   * Most times that sites are moved. Default 20; not negative.
   */
  vtkSetMacro(NumberOfIterations, int);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Sites stop when none would move farther than this, as a fraction of the mean edge length.
   * Default 0.001; not negative.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Whether to make cells and borders. Off, outputs 1 and 2 are empty, there is no CellArea, and
   * labels come from a single search before distances are corrected: many times faster, but a point
   * about as far from two sites may get the other one. Default on.
   */
  vtkSetMacro(GenerateCells, bool);
  vtkGetMacro(GenerateCells, bool);
  vtkBooleanMacro(GenerateCells, bool);
  ///@}

  ///@{
  /**
   * Whether to label points at once, without a graph, by vtkVirtualSourceGeodesicDistance: nothing
   * bounds the errors of the distances, and points about as far from two sites may get the other
   * one. As with GenerateCellsOff(), outputs 1 and 2 are empty. An error with Centroidal and on
   * clouds. Default off.
   */
  vtkSetMacro(Preview, bool);
  vtkGetMacro(Preview, bool);
  vtkBooleanMacro(Preview, bool);
  ///@}

  ///@{
  /**
   * Whether border points whose place the triangles around do not determine well enough are linked
   * to the graph and moved. Takes longer the larger triangles are beside cells. Default on.
   */
  vtkSetMacro(RefineBoundaries, bool);
  vtkGetMacro(RefineBoundaries, bool);
  vtkBooleanMacro(RefineBoundaries, bool);
  ///@}

  ///@{
  /**
   * Whether the points of output 0, the cells of output 2 and the sites of output 3 also get the
   * point arrays of port 1, such as names of the sites: see
   * vtkGeodesicDistanceAlgorithm::SetPassSourceArrays(). Default off.
   */
  vtkSetMacro(PassSiteArrays, bool);
  vtkGetMacro(PassSiteArrays, bool);
  vtkBooleanMacro(PassSiteArrays, bool);
  ///@}

  ///@{
  /**
   * Distance of points that no site reaches. Default NaN; other numbers are marked as by
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
   * surface's bounding box; farther is an error. Default 0.01; not negative; 0 accepts points on
   * the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of one that is built, in [1e-6, 0.5],
   * default 0.01; whether a coarser one on the input is accepted without a warning, default off.
   * And numbers of the graph of the last update.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicVoronoi();
  ~vtkGeodesicVoronoi() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicVoronoi(const vtkGeodesicVoronoi&) = delete;
  void operator=(const vtkGeodesicVoronoi&) = delete;

  DGGSourceSet GetSiteSet(vtkInformationVector** inputVector) const;
  dgg::Status ComputePreview(const DGGContext& context, DGGVoronoiResult& result);
  dgg::Status Compute(const DGGContext& context, DGGVoronoiResult& result);
  void FillOutputs(const DGGContext& context, const DGGVoronoiResult& result,
    const DGGNewGeometry& geometry, vtkInformationVector* outputVector) const;
  void PassArrays(const DGGContext& context, const DGGVoronoiResult& result,
    const DGGSourceSet& set, vtkInformationVector* outputVector) const;

  std::vector<vtkIdType> SiteIds;
  bool Centroidal;
  int NumberOfIterations;
  double Tolerance;
  bool GenerateCells;
  bool Preview;
  bool RefineBoundaries;
  bool PassSiteArrays;
  double UnreachedValue;
  std::string DistanceArrayName;
  std::string SourceArrayName;
  double ProjectionTolerance;
  std::unique_ptr<DGGPropagation> PreviewSolver;
  std::unique_ptr<DGGGraphUser> GraphUser;
};

#endif
