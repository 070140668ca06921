// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicPatchBoundaries
 * @brief   the same layout of curves on two surfaces
 *
 * Draws the boundaries of patches between corresponding landmarks on two surfaces, the first step
 * of a map from one to the other.
 *
 * <b>Input and output</b>. Port 0 takes the first surface, port 1 the second one, which may be a
 * mirror image, or inside out. Landmarks of each are ids of its points and the points of the
 * optional ports 2 and 3, projected to it; ids come first. Those of the same number correspond.
 * Port 4 takes the layout, a vtkPolyData whose polygons and lines name landmarks by number; its
 * points are not used. Without it the cells of port 2 are the layout.
 *
 * Polygons are patches, which must all turn the same way, as the faces of a closed surface do;
 * their sides are curves. Lines are further curves, a polyline a chain of them. With lines alone,
 * the order of the curves around landmarks is that found on the first surface. Two landmarks have
 * one curve at most.
 *
 * Outputs 0 and 1 have the curves on either surface, as new geometry: polylines in the same order
 * and direction. Points with the same `ArcFraction` correspond.
 *  - Cell data: `LayoutEdge` (numbers of the two landmarks), `Length` (double).
 *  - Point data: `ArcLength`, `ArcFraction` (double, from 0 to 1), `FaceId`, `Barycentric`,
 *    `vtkOriginalPointIds`.
 *
 * Mesh reports are those of the first surface.
 *
 * <b>Guarantee and cost</b>. Curves meet at landmarks only, in the same order around each, and
 * divide both surfaces alike, so that every patch is a disk on both; this is checked in the end.
 * Each is locally shortest where it is not pushed aside by earlier ones or by landmarks, to 0.3 of
 * the edges there; as a whole they are not the shortest possible. Each curve takes about an exact
 * distance field and two copies of its surface.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm, for both surfaces:
 *  - no second surface, landmarks or layout; different numbers of landmarks; an id out of range; a
 *    point that is not finite, or farther from its surface than ProjectionTolerance;
 *  - two landmarks in the same place, or not connected although they are to be joined;
 *  - a cell of the layout that names a missing landmark, or one twice in a row; a line that occurs
 *    twice; a side of more than two patches, or of two in the same direction;
 *  - an edge with more than two triangles; a surface that cannot be oriented;
 *  - a layout that cannot be drawn, as around handles with few landmarks: the message names the
 *    surface and the curve or patch.
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
 * <b>Source</b>. E. Praun, W. Sweldens, P. Schroeder, "Consistent mesh parameterizations", SIGGRAPH
 * 2001: curves are drawn one by one, short ones first, those of a spanning tree before all others.
 *
 * @sa vtkExactGeodesicDistance vtkDGGLoop
 */

#ifndef vtkGeodesicPatchBoundaries_h
#define vtkGeodesicPatchBoundaries_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the second surface
#include <vector> // For ids

struct DGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicPatchBoundaries : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicPatchBoundaries* New();
  vtkTypeMacro(vtkGeodesicPatchBoundaries, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Landmarks by point id of the first surface. None by default; an id out of range is an error of
   * the update. A null list removes all; the i-th id is -1 where there is none.
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
   * points of a vtkPolyData. Null removes them.
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
   * How far from the surface a landmark of port 2 or 3 may be, as a fraction of the diagonal of its
   * surface's bounding box; farther is an error. Default 0.01; not negative; 0 accepts points on
   * the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicPatchBoundaries();
  ~vtkGeodesicPatchBoundaries() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicPatchBoundaries(const vtkGeodesicPatchBoundaries&) = delete;
  void operator=(const vtkGeodesicPatchBoundaries&) = delete;

  DGGSourceSet GetLandmarks(int surface, vtkInformationVector** inputVector) const;
  dgg::Status PrepareSecondMesh(vtkPolyData* surface);

  std::vector<vtkIdType> FirstLandmarkIds;
  std::vector<vtkIdType> SecondLandmarkIds;
  double ProjectionTolerance;
  std::unique_ptr<DGGMeshAdapter> SecondMesh;
};

#endif
