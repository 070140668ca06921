// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGLoop
 * @brief   closed geodesics on a surface, as closed polylines
 *
 * <b>Input and output</b>. Points are ids and the points of the optional input port 1
 * (SetPointConnection()), projected to the surface; ids come first. AroundHandles needs neither
 * points nor a graph; other modes search the graph on the input or build one, see
 * vtkGeodesicAlgorithm. Outputs are new geometry; output 1 contains the offset curves of TapeWidth.
 * Output 0 has a polyline per loop, which ends with its first point:
 *  - Cell data: `Length` (double); `LoopId`, index of the point or of the loop; `Angle` (double,
 *    radians), smallest angle of the loop at its points, pi for a closed geodesic; `Kinked`
 *    (int), 1 if `Angle` is below pi by more than 1e-5.
 *  - Point data: `FaceId`, `Barycentric`, `vtkOriginalPointIds`, `ArcLength`.
 *  - Field data: `LoopStatus` (int) per loop: 0 found; 1 contracted to a point (AroundHandles:
 *    has to pass a pinched vertex); 2 points of the rope are not connected. Loops that are not
 *    found have no polyline; a warning counts them.
 *
 * <b>Guarantee and cost</b>. No nearby curve (through the points of a kinked loop) is shorter. Of
 * several loops, the result is the shortest that the graph distinguishes within a limited number of
 * attempts. A loop through a point takes a search over the surface, AroundHandles up to 17 searches
 * along edges per component.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; a point cloud; no point, or fewer than three
 * different ones for a rope; an id out of range; a point that is not finite or beyond
 * ProjectionTolerance; edges with more than two triangles with AroundHandles; a graph beyond
 * MemoryLimit. The module page is Filters/Geodesic/Curves.md.
 *
 * <b>Source</b>. Straightening: see vtkDGGPath. Handles: J. Erickson, K. Whittlesey, "Greedy
 * optimal homotopy and homology generators", SODA 2005.
 * @sa vtkDGGPath vtkDiscreteGeodesicGraph vtkGeodesicPatchBoundaries
 */

#ifndef vtkDGGLoop_h
#define vtkDGGLoop_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <vector> // For ids

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGLoop : public vtkGeodesicAlgorithm
{
public:
  static vtkDGGLoop* New();
  vtkTypeMacro(vtkDGGLoop, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Kinds of loops. Loops of AroundHandles are not always the shortest; there are two per handle,
   * one per boundary but the last, and one per cross-cap.
   */
  enum ModeType
  {
    ThroughPoint = 0,  ///< for each point, the shortest loop found through it
    AroundHandles = 1, ///< short independent loops that do not contract to a point
    Rope = 2           ///< one loop through all points, in their order
  };

  ///@{
  /**
   * Kind of loops. Default ThroughPoint.
   */
  vtkSetClampMacro(Mode, int, ThroughPoint, Rope);
  vtkGetMacro(Mode, int);
  void SetModeToThroughPoint() { this->SetMode(ThroughPoint); }
  void SetModeToAroundHandles() { this->SetMode(AroundHandles); }
  void SetModeToRope() { this->SetMode(Rope); }
  const char* GetModeAsString() const;
  ///@}

  ///@{
  /**
   * Points by point id of the input. None by default; an id out of range is an error of the update.
   * A null list removes all; the i-th id is -1 if there is none.
   */
  vtkDGGIdsMacro(Point);
  ///@}

  /**
   * Remove the ids and disconnect input port 1.
   */
  void RemoveAllPoints();

  ///@{
  /**
   * Points anywhere on the surface: the points of a vtkPolyData on input port 1. Null removes them.
   */
  void SetPointConnection(vtkAlgorithmOutput* output);
  void SetPointData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * If on, loops are released at their points and pulled tight: they become closed geodesics or
   * contract to a point. Default off.
   */
  vtkSetMacro(Taut, bool);
  vtkGetMacro(Taut, bool);
  vtkBooleanMacro(Taut, bool);
  ///@}

  ///@{
  /**
   * Distance between two offset curves along a loop, in units of the coordinates. Default 0: no
   * curves; finite, not negative. Curves lie on either side at half of the width, where there is
   * room; a loop that crosses itself has more than two. They are closed or end at the boundary, and
   * have `Length`, `LoopId` and the point data of output 0. Points are accurate to 1e-5 of the
   * width, lengths to about 1e-3; curves shorter than the width may be missing. A loop longer than
   * 450 widths has none, with a warning that states the smallest sufficient width. A hundred widths
   * of loop take about a second.
   */
  vtkSetMacro(TapeWidth, double);
  vtkGetMacro(TapeWidth, double);
  ///@}

  ///@{
  /**
   * Output 1: the offset curves.
   */
  vtkPolyData* GetTape();
  vtkAlgorithmOutput* GetTapePort() { return this->GetOutputPort(1); }
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
   * last update that used one.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGLoop();
  ~vtkDGGLoop() override = default;

private:
  vtkDGGLoop(const vtkDGGLoop&) = delete;
  void operator=(const vtkDGGLoop&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int Mode = ThroughPoint;
  std::vector<vtkIdType> PointIds;
  bool Taut = false;
  double TapeWidth = 0.0;
  double ProjectionTolerance = 0.01;
};

#endif
