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
 * both. Points with the same ArcLength correspond.
 *
 * Curves are drawn one by one, short ones first, those of a spanning tree before all others, each
 * as an exact shortest path on the surface cut open along the earlier ones, in the sectors of its
 * landmarks that the order demands (after Praun, Sweldens and Schroeder, "Consistent mesh
 * parameterizations", 2001). Where it would touch an earlier curve or another landmark it keeps a
 * small distance, 0.3 of the length of the (already split) edges there.
 *
 * Input port 0 takes the first surface and port 1 the second one. Landmarks are given by id
 * (SetFirstLandmarkIds(), SetSecondLandmarkIds()) and as the points of a vtkPolyData on ports 2
 * (first surface) and 3 (second surface), which are projected to the surface; ids come first. Both
 * must be in the same order.
 *
 * Port 4 takes the layout: a vtkPolyData whose cells name landmarks by their numbers; its points
 * are not used. Without it the cells of port 2 are the layout. Polygons are patches, their sides
 * the curves. All patches must turn the same way, as the faces of a closed surface do. Lines are
 * curves besides; with lines alone, the order of the curves around each landmark is taken as it
 * comes on the first surface, and imposed on the second one. Either surface may be a mirror image
 * of the other, or inside out. Between two landmarks there is one curve at most.
 *
 * Output port 0 has the curves on the first surface, port 1 those on the second one: a polyline
 * each, in the same order, from the same landmark to the same. Cell data: LayoutEdge (the two
 * landmarks), Length (double). Point data: ArcLength (double, from 0 to 1), FaceId (cell of the
 * surface that the piece from this point on lies in; at the end, the piece before),
 * vtkOriginalPointIds (point of the surface, or -1). Points of a curve may lie inside polygons of
 * the surface. The reports on the mesh are about the first surface.
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

#include <initializer_list> // For ids
#include <memory>           // For the internals
#include <vector>           // For ids

class vtkIdList;
struct vtkDGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicPatchBoundaries : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicPatchBoundaries* New();
  vtkTypeMacro(vtkGeodesicPatchBoundaries, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Landmarks that are points of the surfaces, by id. Ids are copied; none by default. A null list
   * removes all ids.
   */
  void SetFirstLandmarkIds(vtkIdList* ids);
  void SetFirstLandmarkIds(const std::vector<vtkIdType>& ids);
  void SetSecondLandmarkIds(vtkIdList* ids);
  void SetSecondLandmarkIds(const std::vector<vtkIdType>& ids);
#ifndef __VTK_WRAP__
  void SetFirstLandmarkIds(std::initializer_list<vtkIdType> ids); // or {0} would be a null list
  void SetSecondLandmarkIds(std::initializer_list<vtkIdType> ids);
#endif
  vtkIdType GetNumberOfFirstLandmarkIds() const;
  vtkIdType GetNumberOfSecondLandmarkIds() const;
  ///@}

  ///@{
  /**
   * The second surface (port 1), landmarks anywhere on the surfaces (ports 2 and 3), and the layout
   * (port 4). Null removes them.
   */
  void SetSecondSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSecondSurfaceData(vtkPolyData* surface);
  void SetFirstLandmarksConnection(vtkAlgorithmOutput* output);
  void SetFirstLandmarksData(vtkPolyData* landmarks);
  void SetSecondLandmarksConnection(vtkAlgorithmOutput* output);
  void SetSecondLandmarksData(vtkPolyData* landmarks);
  void SetLayoutConnection(vtkAlgorithmOutput* output);
  void SetLayoutData(vtkPolyData* layout);
  ///@}

  ///@{
  /**
   * How far from the surface a landmark of port 2 or 3 may be, as a fraction of the diagonal of the
   * bounding box of its surface. Default 0.01; must not be negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicPatchBoundaries();
  ~vtkGeodesicPatchBoundaries() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(vtkPolyData* surface, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(vtkPolyData* surface, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicPatchBoundaries(const vtkGeodesicPatchBoundaries&) = delete;
  void operator=(const vtkGeodesicPatchBoundaries&) = delete;

  vtkDGGSourceSet GetLandmarks(int surface, vtkInformationVector** inputVector) const;
  dgg::Status PrepareSecondMesh(vtkPolyData* surface);

  std::vector<vtkIdType> FirstLandmarkIds;
  std::vector<vtkIdType> SecondLandmarkIds;
  double ProjectionTolerance;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
