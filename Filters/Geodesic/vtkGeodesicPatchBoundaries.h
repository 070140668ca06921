// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicPatchBoundaries
 * @brief   the same layout of curves on two surfaces
 *
 * Draws the boundaries of patches between corresponding landmarks on two surfaces, the first step
 * of a map from one to the other.
 *
 * <b>Input and output</b>. Port 0 takes the first surface, port 1 the second, which may be mirrored
 * or inside out. Landmarks of the same index correspond: ids of points of each surface, then the
 * points of the optional ports 2 and 3. Port 4 takes the layout. Mesh reports describe the
 * first surface. Outputs 0 and 1 are new geometry, the curves on either surface as polylines in the
 * same order and direction. Points of equal `ArcFraction` correspond.
 *  - Cell data: `LayoutEdge` (indices of two landmarks), `Length` (double).
 *  - Point data: `ArcLength`, `ArcFraction` (double, from 0 to 1), `FaceId`, `Barycentric`,
 *    `vtkOriginalPointIds`.
 *
 * <b>Guarantee and cost</b>. Curves meet at landmarks only, in the same order around each, and
 * every patch is a disk on both surfaces; this is verified at the end. A curve is locally shortest,
 * to 0.3 of the edge length, where earlier curves and landmarks do not obstruct it; the total
 * length is not minimal. A curve takes about an exact distance field and two copies of its surface.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm, for both surfaces; also missing inputs;
 * different numbers of landmarks; an id out of range; a landmark that is not finite or beyond
 * ProjectionTolerance; two landmarks at the same position, or unconnected although a curve joins
 * them; edges with more than two triangles; a surface that cannot be oriented; an invalid layout
 * (SetLayoutData()), or one that cannot be drawn, as around handles with few landmarks. The module
 * page is Filters/Geodesic/Curves.md.
 *
 * <b>Source</b>. E. Praun, W. Sweldens, P. Schroeder, "Consistent mesh parameterizations", SIGGRAPH
 * 2001: short curves first, curves of a spanning tree before all others.
 * @sa vtkExactGeodesicDistance vtkDGGLoop
 */

#ifndef vtkGeodesicPatchBoundaries_h
#define vtkGeodesicPatchBoundaries_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <vector> // For ids

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicPatchBoundaries : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicPatchBoundaries* New();
  vtkTypeMacro(vtkGeodesicPatchBoundaries, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Landmarks by point id of the first surface. None by default; an id out of range is an error of
   * the update. A null list removes all; the i-th id is -1 if there is none.
   */
  vtkDGGIdsMacro(FirstLandmark);
  ///@}

  ///@{
  /**
   * Landmarks by point id of the second surface, as for the first.
   */
  vtkDGGIdsMacro(SecondLandmark);
  ///@}

  /**
   * Remove the ids for both surfaces and disconnect input ports 2 and 3.
   */
  void RemoveAllLandmarks();

  ///@{
  /**
   * The second surface: input port 1. Null removes it.
   */
  void SetSecondSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSecondSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /**
   * Landmarks anywhere on the first surface (input port 2) and on the second one (input port 3):
   * points of a vtkPolyData. Null removes them.
   */
  void SetFirstLandmarkConnection(vtkAlgorithmOutput* output);
  void SetFirstLandmarkData(vtkPolyData* points);
  void SetSecondLandmarkConnection(vtkAlgorithmOutput* output);
  void SetSecondLandmarkData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * The layout on input port 4: a vtkPolyData whose polygons and lines name landmarks by index; its
   * points are not used. Null removes it; then the cells of input port 2 are the layout. Polygons
   * are patches, oriented consistently like the faces of a closed surface; their sides are curves.
   * Lines are further curves, a polyline is a chain of them. Two landmarks have at most one curve.
   * With lines only, the first surface determines the order of curves around landmarks. Errors: a
   * cell with a missing landmark, or one twice in succession; a line that occurs twice; a side of
   * more than two patches, or of two in the same direction.
   */
  void SetLayoutConnection(vtkAlgorithmOutput* output);
  void SetLayoutData(vtkPolyData* layout);
  ///@}

  ///@{
  /**
   * Largest distance of a landmark of port 2 or 3 from its surface, as a fraction of the diagonal
   * of the surface's bounding box; a farther landmark is an error. Default 0.01; not negative. 0
   * accepts points on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicPatchBoundaries();
  ~vtkGeodesicPatchBoundaries() override = default;

private:
  vtkGeodesicPatchBoundaries(const vtkGeodesicPatchBoundaries&) = delete;
  void operator=(const vtkGeodesicPatchBoundaries&) = delete;

  class vtkInternals;

  std::vector<vtkIdType> FirstLandmarkIds;
  std::vector<vtkIdType> SecondLandmarkIds;
  double ProjectionTolerance = 0.01;
};

#endif
