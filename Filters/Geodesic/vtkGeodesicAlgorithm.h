// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   base class of filters that work on the surface of a mesh
 *
 * <b>Input and output</b>. Port 0 takes a surface (vtkPolyData) with any polygons and strips; verts
 * and lines are passed through and not used. Lengths are in units of the coordinates. Outputs are
 * the input with arrays added, or new geometry: double points on the surface
 * (OutputPointsPrecision) with the field data of the input except its graph and windows.
 *
 * <b>Arrays of new geometry</b>. `vtkOriginalPointIds`: id of the surface point at this position,
 * otherwise -1. `FaceId`: id of the cell that contains the point, -1 if there is none; on a
 * polyline, the cell of the segment after the point, at the last point the cell of the segment
 * before. `Barycentric` (3 components, if all polygons are triangles): coordinates with respect to
 * the corners of `FaceId`, 0 where that is -1. `ArcLength`: length of the polyline up to the point.
 * Each segment lies in one triangle.
 *
 * <b>Graphs</b>. vtkDGGDistance, vtkDGGPath, vtkDGGLoop, vtkGeodesicSampler, vtkGeodesicVoronoi and
 * vtkGeodesicDistanceMatrix search the graph on the input. Without one they build a graph with
 * their Accuracy and keep it until the mesh or Accuracy changes. A damaged graph, or one of
 * another surface, is replaced with a warning. All but vtkDGGLoop also search graphs of
 * vtkPointCloudDGG: a missing, damaged or outdated graph is an error, cells are not used, the mesh
 * report is empty, and Accuracy and AcceptCoarserGraph have no effect.
 *
 * <b>Guarantee and cost</b>. Results are bitwise identical for any number of threads. The prepared
 * mesh is kept until points, polygons or strips change, and shared by the filters of a chain.
 * Changes in place need Modified() of the coordinates, of the vtkCellArray or of the vtkPolyData.
 * Inputs and properties must not change during an update.
 *
 * <b>Errors</b>. vtkErrorMacro names the problem and the remedy; the output is then empty and
 * GetErrorCode() is not zero. An abort (AbortExecute) empties the output with error code zero.
 * Pages of Filters/Geodesic: README.md (sources), Input.md (limits and bad input), Processes.md
 * (pieces and blocks). Only classes of this project may be derived from this one.
 * @sa vtkGeodesicDistanceAlgorithm vtkDiscreteGeodesicGraph
 */

#ifndef vtkGeodesicAlgorithm_h
#define vtkGeodesicAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For names
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the internals
#include <string> // For the report

class DGGFilterInternals;
class vtkMultiProcessController;
class vtkTable;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * If on, points with the same coordinates are treated as one, as along texture seams or in
   * triangle soups. The output keeps all points. Default off: a warning counts coincident boundary
   * points. Not used on clouds.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Largest distance of points that MergeCoincidentPoints treats as one, as a fraction of the
   * diagonal of the bounding box. Default 0: equal coordinates; not negative. Each point is merged
   * with the closest earlier unmerged point within the tolerance. Choose a value larger than the
   * gaps and much smaller than the triangles: a triangle with two merged corners is skipped.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Precision of the points of new geometry, one of vtkAlgorithm::DesiredOutputPrecision. Default
   * DOUBLE_PRECISION: points lie on the surface up to 1e-9 of the size of their triangles.
   * DEFAULT_PRECISION uses the precision of the input. SINGLE_PRECISION is an error for coordinates
   * beyond the range of floats.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Set/Get the controller of the processes that have pieces of the surface. Default: the global
   * controller at the time of construction.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Largest number of points, over all inputs, that the first process gathers; more are an error.
   * Default 100 million. A point takes about 200 bytes, plus twice the size of its arrays.
   */
  vtkSetMacro(GatherLimit, vtkIdType);
  vtkGetMacro(GatherLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Largest number of bytes that an update may allocate for graphs, factorizations, gathered pieces
   * and other large buffers that a filter documents. A larger need is an error before allocation.
   * Not negative. Default 0: 70 % of the free memory at that time, for buffers that do not exist
   * yet.
   */
  vtkSetMacro(MemoryLimit, vtkTypeInt64);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  /**
   * Returns the size, defects and quality of the surface of the last update as text, one item per
   * line.
   */
  std::string GetMeshReport() const;

  /**
   * Returns the items of the mesh report as a table with one row; without a surface, the items of
   * an empty mesh. The next call replaces the table. Columns:
   *  - NumberOfPoints, NumberOfTriangles: triangles are those in use;
   *  - NumberOfComponents: connected through shared points;
   *  - NumberOfBoundaryEdges, NumberOfBoundaryLoops: loops are closed chains of edges with one
   *    triangle;
   *  - Orientable: 1 if the surface can be oriented consistently, else 0;
   *  - Genus: total of the components; -1 with non-manifold edges or without an orientation;
   *  - NumberOfNonManifoldEdges, with more than two triangles; NumberOfNonManifoldVertices, with
   *    several fans and no such edge;
   *  - NumberOfDroppedFaces, with fewer than three distinct points; NumberOfDegenerateFaces, of
   *    near-zero area; NumberOfDuplicateFaces, on the points of an earlier face;
   *  - NumberOfIsolatedPoints, which no triangle uses; NumberOfCoincidentPoints, with the
   *    coordinates of an earlier point; NumberOfCoincidentBoundaryPoints, see
   *    MergeCoincidentPoints; NumberOfMergedPoints;
   *  - Mollification: length added to edges of triangles of near-zero area, in units of the
   *    coordinates;
   *  - LargestCapHeight: largest height of removed triangles of near-zero area, summed over stacked
   *    triangles, in units of the coordinates. The surface has moved by at most this height;
   *  - Area: sum over the triangles, without those of near-zero area;
   *  - MeanAnisotropy, MedianAnisotropy: see GetMeanAnisotropy().
   */
  vtkTable* GetMeshReportTable();

  /**
   * Returns the area-weighted mean of longest edge * perimeter / (4 sqrt(3) area) over the
   * triangles: 1 if all are equilateral. Above 2, much of the surface is covered by long triangles.
   */
  double GetMeanAnisotropy() const;

  /**
   * Returns the time stamp of the mesh that is kept between updates.
   */
  vtkMTimeType GetMeshBuildTime() const;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkGeodesicAlgorithm();
  ~vtkGeodesicAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Private implementation, set by the constructors of subclasses.
   */
  std::unique_ptr<DGGFilterInternals> Internals;

  vtkTypeInt64 MemoryLimit = 0; ///< signed, since ParaView has no unsigned 64-bit properties

private:
  vtkGeodesicAlgorithm(const vtkGeodesicAlgorithm&) = delete;
  void operator=(const vtkGeodesicAlgorithm&) = delete;

  friend class DGGFilterInternals;
  void MakeSurfaceOutput(vtkDataObject* input, vtkInformation* outInfo) const;

  bool MergeCoincidentPoints = false;
  double MergeTolerance = 0.0;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  vtkMultiProcessController* Controller = nullptr;
  vtkIdType GatherLimit = 100000000;
};

#endif
