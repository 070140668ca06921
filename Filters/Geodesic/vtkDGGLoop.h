// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGLoop
 * @brief   closed geodesics on a surface, as closed polylines
 *
 * Finds loops by Mode: ThroughPoint, for each point the shortest loop from there back to it that
 * was found; AroundHandles, independent loops that cannot be contracted, two for each handle, one
 * for each boundary but the last and for each cross-cap, short but not always shortest; Rope, one
 * loop through all points, in their order. Loops through points may have kinks there. With Taut
 * they are released and pulled tight: they become closed geodesics, or contract to a point.
 *
 * <b>Input and output</b>. Points are ids and the points of the optional input port 1
 * (SetPointConnection()), projected to the surface; ids come first. The graph is that on the input,
 * or built here, see vtkGeodesicAlgorithm; AroundHandles needs neither points nor graph. Outputs
 * are new geometry. Output 0 has a polyline for each loop, which ends with the point that it begins
 * with:
 *  - Cell data: `Length` (double); `LoopId`, the number of the point or of the loop; `Angle`
 *    (double, radians), the smallest one of the loop at its points, pi for a closed geodesic;
 *    `Kinked` (int), whether that is below pi by more than 1e-5.
 *  - Point data: `FaceId`, `Barycentric`, `vtkOriginalPointIds`, `ArcLength`.
 *  - Field data: `LoopStatus` (int), for each loop asked for: 0 found; 1 none, as it contracts to a
 *    point, or for AroundHandles as it has to pass a point in which sheets touch; 2 points of the
 *    rope that are not connected. Loops that are not found are left out, with a warning that counts
 *    them.
 *
 * Output 1 has offset curves, if TapeWidth is positive: at half of it on either side of a loop,
 * where there is room, more of them where a loop crosses itself. They are closed or end at the
 * boundary, and have the arrays `Length`, `LoopId` and the point data of output 0.
 *
 * <b>Guarantee and cost</b>. No curve next to a loop is shorter; next to a kinked one, none through
 * the same points. Where there are several loops, the shortest is found of those that the graph
 * distinguishes, in a limited number of tries. Points of offset curves are exact to 1e-5 of the
 * width, their lengths to about 1e-3; ones shorter than the width may be missed. A loop through a
 * point takes a search over the surface, AroundHandles up to 17 along edges for each component,
 * offset curves about a second for each hundred widths of loop.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - no point, or fewer than three of a rope; an id out of range; a point that is not finite, or
 *    farther from the surface than ProjectionTolerance;
 *  - edges with more than two triangles, with AroundHandles;
 *  - a ProjectionTolerance or TapeWidth that is negative or NaN, an infinite TapeWidth; an Accuracy
 *    outside [1e-6, 0.5]; a graph that takes more than MemoryLimit.
 *
 * @code
 * vtkNew<vtkDGGLoop> loop;
 * loop->SetInputConnection(reader->GetOutputPort());
 * loop->SetModeToAroundHandles();
 * loop->SetTapeWidth(0.1);
 * loop->Update();
 * std::cout << loop->GetOutput()->GetNumberOfLines() << " loops\n"; // two for each handle
 * vtkPolyData* curves = loop->GetTape();
 * @endcode
 *
 * <b>Source</b>. Paths in the graph that meet are straightened as in vtkDGGPath; loops around
 * handles come from shortest loops of edges (J. Erickson, K. Whittlesey, "Greedy optimal homotopy
 * and homology generators", SODA 2005).
 *
 * @sa vtkDGGPath vtkDiscreteGeodesicGraph vtkGeodesicPatchBoundaries
 */

#ifndef vtkDGGLoop_h
#define vtkDGGLoop_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <vector> // For ids

struct DGGLoopSet;
struct DGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGLoop : public vtkGeodesicAlgorithm
{
public:
  static vtkDGGLoop* New();
  vtkTypeMacro(vtkDGGLoop, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Loops that can be asked for.
   */
  enum ModeType
  {
    ThroughPoint = 0,  ///< one through each point
    AroundHandles = 1, ///< all that cannot be contracted
    Rope = 2           ///< one through all points
  };

  ///@{
  /**
   * Which loops to find. Default ThroughPoint.
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
   * A null list removes all; the i-th id is -1 where there is none.
   */
  vtkDGGIdsMacro(Point);
  ///@}

  /**
   * Remove the ids and disconnect input port 1.
   */
  void RemoveAllPoints();

  ///@{
  /**
   * Points anywhere on the surface: those of a vtkPolyData on input port 1. Null removes them.
   */
  void SetPointConnection(vtkAlgorithmOutput* output);
  void SetPointData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Whether to release loops at their points and pull them tight. Default off.
   */
  vtkSetMacro(Taut, bool);
  vtkGetMacro(Taut, bool);
  vtkBooleanMacro(Taut, bool);
  ///@}

  ///@{
  /**
   * Distance between the two offset curves of a loop, in units of the coordinates. Default 0: none;
   * finite, not negative. Loops more than 450 times as long have none, with a warning that names
   * the width that is enough.
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
   * And numbers of the graph of the last update that needed one.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGLoop();
  ~vtkDGGLoop() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGLoop(const vtkDGGLoop&) = delete;
  void operator=(const vtkDGGLoop&) = delete;

  DGGSourceSet GetPointSet(vtkInformationVector** inputVector) const;
  void WarnAboutMissingLoops(const DGGLoopSet& set);
  void WarnAboutMissingTapes(const DGGLoopSet& set);

  int Mode;
  std::vector<vtkIdType> PointIds;
  bool Taut;
  double TapeWidth;
  double ProjectionTolerance;
  std::unique_ptr<DGGGraphUser> GraphUser;
};

#endif
