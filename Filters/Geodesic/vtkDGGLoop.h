// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGLoop
 * @brief   closed geodesics on a surface, as closed polylines
 *
 * Finds loops on the surface: through given points, around the handles, or along a rope that is
 * pulled tight; and lays tapes along them. The discrete geodesic graph that it searches is taken
 * from the input, or built and kept, as in vtkDGGDistance.
 *
 * Input port 0 takes the surface. Points are ids of points of the surface (AddPointId(),
 * SetPointIds()) and the points of a vtkPolyData on the optional input port 1
 * (SetPointConnection(), SetPointData()), which may lie anywhere on the surface and are projected
 * to it. They are numbered from 0: ids first, then the points of port 1.
 *
 * <b>Modes.</b>
 *  - ThroughPoint (the default): for each point, the shortest geodesic from there back to itself
 *    that was found. It is straight everywhere but at the point, where it may have a kink. With
 *    Taut, it is let go there and pulled tight: a closed geodesic close by.
 *  - AroundHandles: closed geodesics of each component that cannot be contracted, independent of
 *    each other: two for each handle, one for each boundary but the last, one for each cross-cap.
 *    They are short, but there may be shorter ones. No points and no graph are needed, Taut has no
 *    meaning.
 *  - Rope: one loop through all points, at least three, in their order, and from the last one back
 *    to the first one. Without Taut it keeps to the points: shortest paths join them. With Taut the
 *    rope is let go at the points and pulled tight: what stays is a closed geodesic, as around a
 *    neck, or nothing, when it slips off.
 *
 * A loop that is straight everywhere (not `Kinked`) is taut: Taut returns it as it is. Others
 * become shorter until they are straight. On cylinders and along other flat walls there are many
 * straight loops side by side, all as long; a loop that is pulled tight there ends as one of them.
 *
 * Both outputs are new geometry, see vtkGeodesicAlgorithm.
 *
 * <b>Output 0</b> has a closed polyline for each loop: it ends with the point that it begins with.
 * Each of its pieces lies in one triangle of the surface.
 *  - Cell data: `Length` (double, in units of the coordinates); `LoopId`, the number of the point
 *    that the loop goes through, or of the loop; `Angle` (double, radians), the smaller angle of
 *    the loop at the points that it goes through, the smallest when there are several: pi for a
 *    closed geodesic; `Kinked` (int), whether that is less than pi by more than 1e-5.
 *  - Point data: `FaceId`, the cell of the input that the piece after the point lies in;
 *    `vtkOriginalPointIds`, the point of the input where the loop is at one, else -1 (the first one
 *    of points that have been merged); `ArcLength`, the length of the loop up to the point.
 *    The point that a loop begins and ends with is one, and has 0: for the end take `Length`.
 *  - Field data: `LoopStatus`, one int for each loop asked for: 0 when it is there; 1 when there is
 *    none, as it contracts to a point; 2 when the points of the rope are not connected. Loops that
 *    are not there are left out, and a warning counts them. With AroundHandles, 1 stands for a loop
 *    that has to pass a point in which sheets touch, where it cannot be moved.
 *
 * <b>Output 1</b> (GetTape()) has the rims of the tapes, when TapeWidth is positive: the curves at
 * a distance of half of it from a loop, one on each side where there is room, and more where the
 * loop crosses itself. They are closed, or end at the boundary. The arrays are `Length`, `LoopId`
 * and the point data of output 0.
 *
 * <b>What is promised.</b> No curve next to a loop is shorter, unless it is kinked, and then none
 * through the same points. A closed geodesic need not exist near a point: on a surface without
 * handles, boundaries or limbs, as on a ball, ways around contract to the point, and there is no
 * loop. Where there are several, the shortest one is found among those that the graph
 * distinguishes, and among the shortest ways around: no more of them are tried than take some
 * multiple of what ordinary meshes of that size take. Lengths are those of the triangles; where
 * triangles have no area, those after GetMollification(). Points of rims are as exact as
 * vtkExactGeodesicDistance, to 1e-5 of the width. Between them rims are straight; in large
 * triangles they have more points than where they cross edges, so that their lengths are right to
 * about 1e-3. Rims shorter than the width may be missed.
 *
 * <b>Time.</b> A loop through a point takes a search over the whole surface; points are worked on
 * by all threads of vtkSMPTools. Results do not depend on their number. AroundHandles takes up to
 * 17 searches along edges for each component with such loops. A tape takes some exact
 * propagations as far as it is wide, from points as close to each other as it is narrow: about a
 * second for each hundred times that the loop is as long as the tape is wide, whatever the
 * triangles.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no point, or fewer than three of a rope; an id out of range; a point that is not finite, or
 *    farther from the surface than ProjectionTolerance;
 *  - edges with more than two triangles, with AroundHandles;
 *  - a ProjectionTolerance or TapeWidth that is negative, not a number, or infinite (TapeWidth);
 *    an Accuracy outside [1e-6, 0.5]; a graph that would take more memory than MemoryLimit.
 *
 * A loop that is more than 450 times as long as TapeWidth has no tape, with a warning that names
 * the width that is enough for all loops.
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("mesh.ply");
 * vtkNew<vtkDGGLoop> loop;
 * loop->SetInputConnection(reader->GetOutputPort());
 * loop->SetModeToAroundHandles();
 * loop->Update();
 * std::cout << loop->GetOutput()->GetNumberOfLines() << " loops\n"; // two for each handle
 * @endcode
 *
 * Ways through the graph that meet are straightened, as in vtkDGGPath. Loops around handles come
 * from shortest loops of mesh edges (Erickson and Whittlesey 2005).
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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

struct vtkDGGLoopSet;
struct vtkDGGSourceSet;

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
   * Points by id of the input. Ids are copied; none by default. An id outside
   * [0, number of points - 1] is an error of the update. A null list removes all ids. The
   * i-th id is -1 when there is none.
   */
  vtkDGGIdsMacro(Point);
  ///@}

  /**
   * Remove the ids and disconnect input port 1.
   */
  void RemoveAllPoints();

  ///@{
  /**
   * Points anywhere on the surface: those of a vtkPolyData on input port 1; its cells are not used.
   * Null removes them.
   */
  void SetPointConnection(vtkAlgorithmOutput* output);
  void SetPointData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Whether to let loops go at their points and pull them tight, to closed geodesics. Default off:
   * loops and ropes keep to the points, and may have kinks there.
   */
  vtkSetMacro(Taut, bool);
  vtkGetMacro(Taut, bool);
  vtkBooleanMacro(Taut, bool);
  ///@}

  ///@{
  /**
   * Width of the tape along each loop, in units of the coordinates. Default 0: no tape; must not be
   * negative, and must be finite. Loops more than 450 times as long as this have no tape.
   */
  vtkSetMacro(TapeWidth, double);
  vtkGetMacro(TapeWidth, double);
  ///@}

  ///@{
  /**
   * Output 1: the rims of the tapes.
   */
  vtkPolyData* GetTape();
  vtkAlgorithmOutput* GetTapePort() { return this->GetOutputPort(1); }
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
   * - Of the graph of the last update that needed one, zero when there is none: whether it is that
   *   on the input, its accuracy (0 for a SaddleVertexGraph), number of directed edges, and about
   *   the bytes with what searches and links need; they stay what they were when its arrays are
   *   changed later. Whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGLoop();
  ~vtkDGGLoop() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGLoop(const vtkDGGLoop&) = delete;
  void operator=(const vtkDGGLoop&) = delete;

  vtkDGGSourceSet GetPointSet(vtkInformationVector** inputVector) const;
  void WarnAboutMissingLoops(const vtkDGGLoopSet& set);
  void WarnAboutMissingTapes(const vtkDGGLoopSet& set);

  int Mode;
  std::vector<vtkIdType> PointIds;
  bool Taut;
  double TapeWidth;
  double ProjectionTolerance;
  std::unique_ptr<vtkDGGGraphUser> GraphUser;
};

#endif
