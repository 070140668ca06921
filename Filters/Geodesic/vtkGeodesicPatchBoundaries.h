// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicPatchBoundaries
 * @brief   the same layout of curves on two surfaces
 *
 * Given two surfaces, landmarks that correspond, and a layout of patches between the landmarks,
 * draws the boundaries of the patches on both: the first step of a map from one surface to the
 * other. The curves on the two surfaces correspond one by one. They meet at landmarks only, leave
 * each landmark in the same order, and divide both surfaces alike, so that every patch is a disk on
 * both. Points with the same ArcFraction correspond.
 *
 * Curves are drawn one by one, short ones first, those of a spanning tree before all others, each
 * as an exact shortest path on the surface cut open along the earlier ones, in the sectors of its
 * landmarks that the order demands (after Praun, Sweldens and Schroeder, "Consistent mesh
 * parameterizations", 2001). Where it would touch an earlier curve or another landmark it keeps a
 * small distance, 0.3 of the length of the (already split) edges there.
 *
 * <b>Inputs.</b>
 *  - Port 0 takes the first surface, port 1 the second one (SetSecondSurfaceConnection(),
 *    SetSecondSurfaceData()). Either may be a mirror image of the other, or inside out.
 *  - Landmarks are given on each surface by ids of its points (AddFirstLandmarkId(),
 *    SetFirstLandmarkIds() and the same for the second one), and by the points of a vtkPolyData on
 *    the optional ports 2 (first surface) and 3 (second surface), which may lie anywhere on the
 *    surface and are projected to it (SetFirstLandmarkConnection(), SetFirstLandmarkData() and so
 *    on). They are numbered from 0: ids first, then the points of the port. Landmarks of the same
 *    number correspond, so that there must be as many on both; how they are given may differ.
 *  - Port 4 takes the layout (SetLayoutConnection(), SetLayoutData()): a vtkPolyData whose polygons
 *    and lines name landmarks by their numbers; its points are not used, and it needs none. Without
 *    it the cells of port 2 are the layout. They name landmarks by their numbers, too, which are
 *    those of the points of port 2 as long as there are no ids for the first surface.
 *
 * <b>The layout.</b> Polygons are patches, their sides the curves. All patches must turn the same
 * way, as the faces of a closed surface do. Which way that is on each surface is found out from the
 * order of the shortest ways between landmarks; where this says nothing, as with a single patch on
 * an open surface, both ways are tried. Lines are curves besides, a polyline a chain of them (none
 * for a line of one point); with lines alone, the order of the curves around each landmark is taken
 * as it comes on the first surface, and imposed on the second one. Between two landmarks there is
 * one curve at most.
 *
 * <b>Outputs.</b> Port 0 has the curves on the first surface, port 1 those on the second one: a
 * polyline each, in the same order, from the same landmark to the same. Both are new geometry, see
 * vtkGeodesicAlgorithm.
 *  - Cell data: `LayoutEdge` (the numbers of the two landmarks), `Length` (double).
 *  - Point data: `ArcLength`, the length of the curve up to the point; `ArcFraction` (double), the
 *    part of the whole curve that this is, from 0 to 1: points with the same one correspond;
 *    `FaceId`, the cell of the surface that the piece after the point lies in (that before it for
 *    the last point); `vtkOriginalPointIds`, the point of the surface where the curve is at one,
 *    else -1. Points of a curve may lie inside polygons of the surface.
 *
 * The reports on the mesh are about the first surface.
 *
 * <b>What is promised.</b> That the curves correspond as said: it is checked in the end. Curves are
 * locally shortest where they are not pushed aside; which ones push and are pushed depends on the
 * order in which they are drawn, and as a whole they are not the shortest possible. On surfaces
 * with handles a layout with few landmarks may wind around a handle differently on the two; then
 * it is an error.
 *
 * <b>Time.</b> About that of an exact distance field and of two copies of the surface for each
 * curve and each surface.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm, which hold for both surfaces:
 *  - no second surface, landmarks or layout; different numbers of landmarks on the two; an id out
 *    of range; a point that is not finite, or farther from the surface than ProjectionTolerance;
 *  - two landmarks in the same place, or, if they are to be joined, not connected;
 *  - a cell of the layout that names a landmark that does not exist, or one twice in a row; a line
 *    that occurs twice; a side that more than two patches share, or two in the same direction;
 *  - an edge with more than two triangles; a surface that cannot be oriented;
 *  - a layout that cannot be drawn: the message names the surface and the curve or patch.
 *
 * @code
 * vtkNew<vtkGeodesicPatchBoundaries> boundaries;
 * boundaries->SetInputConnection(0, first->GetOutputPort());
 * boundaries->SetInputConnection(1, second->GetOutputPort());
 * boundaries->SetFirstLandmarkIds({ 5, 120, 77, 301 });
 * boundaries->SetSecondLandmarkIds({ 9, 44, 310, 256 });
 * boundaries->SetLayoutData(tetrahedron); // polygons on the points 0 to 3
 * boundaries->Update();
 * vtkPolyData* onSecond = boundaries->GetOutput(1);
 * @endcode
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkExactGeodesicDistance
 */

#ifndef vtkGeodesicPatchBoundaries_h
#define vtkGeodesicPatchBoundaries_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the second surface
#include <vector> // For ids

struct vtkDGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicPatchBoundaries : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicPatchBoundaries* New();
  vtkTypeMacro(vtkGeodesicPatchBoundaries, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Landmarks by point id of the first surface. Ids are copied; none by default. An id outside
   * [0, number of points - 1] is an error of the update. A null list removes all ids.
   */
  vtkDGGIdsMacro(FirstLandmark);
  ///@}

  ///@{
  /**
   * The same for the second surface.
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
   * the points of a vtkPolyData. Null removes them.
   */
  void SetFirstLandmarkConnection(vtkAlgorithmOutput* output);
  void SetFirstLandmarkData(vtkPolyData* points);
  void SetSecondLandmarkConnection(vtkAlgorithmOutput* output);
  void SetSecondLandmarkData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * The layout: input port 4. Null removes it; then the cells of input port 2 are the layout.
   */
  void SetLayoutConnection(vtkAlgorithmOutput* output);
  void SetLayoutData(vtkPolyData* layout);
  ///@}

  ///@{
  /**
   * How far from the surface a landmark of port 2 or 3 may be, as a fraction of the diagonal of the
   * bounding box of its surface. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicPatchBoundaries();
  ~vtkGeodesicPatchBoundaries() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicPatchBoundaries(const vtkGeodesicPatchBoundaries&) = delete;
  void operator=(const vtkGeodesicPatchBoundaries&) = delete;

  vtkDGGSourceSet GetLandmarks(int surface, vtkInformationVector** inputVector) const;
  dgg::Status PrepareSecondMesh(vtkPolyData* surface);

  std::vector<vtkIdType> FirstLandmarkIds;
  std::vector<vtkIdType> SecondLandmarkIds;
  double ProjectionTolerance;
  std::unique_ptr<vtkDGGMeshAdapter> SecondMesh;
};

#endif
