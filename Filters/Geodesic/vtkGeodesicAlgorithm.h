// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   what all filters on the surface of a mesh have in common
 *
 * Input port 0 takes the surface (vtkPolyData).
 *
 * <b>Cells.</b> Triangles are used as they are; quads, polygons and triangle strips are
 * triangulated inside. For planar polygons it makes no difference how; a quad that is not planar
 * is cut along the shorter one of its diagonals, and larger polygons ear by ear; those that cross
 * or touch themselves become fans, with a warning. Verts and lines
 * are passed through and not used. Polygons with fewer than three distinct points are left out.
 * Of triangles on the same three points, either way round, the first one counts. Triangles without
 * area whose apex lies on the opposite edge are left out, and the other triangles on that edge are
 * split there, so that lengths and areas are those of the points; `FaceId` names the cell that was
 * split. Edges of other triangles without area are lengthened a little (GetMollification()). Edges
 * with more than two triangles and points where sheets touch conduct: distances are those of the
 * triangles as they are glued by point ids. Where the work on them, or on long triangles of little
 * area, grows far beyond that on a clean mesh of the same size, the filter fails with what to
 * remove. All of these are
 * counted in warnings, once for each mesh, and in the report (GetMeshReport()). Orientation does
 * not matter.
 *
 * <b>Point clouds.</b> An input with the graph of a point cloud, which vtkPointCloudDGG makes, is
 * taken for one by the filters that search a graph: vtkDGGDistance, vtkDGGPath, vtkGeodesicSampler,
 * vtkGeodesicVoronoi and vtkGeodesicDistanceMatrix. Only its points are looked at, also where it
 * has polygons. Points to start from, or to go to, may be anywhere close to the cloud: as far as
 * ProjectionTolerance says, or as far as the nearest six points around the closest one are from it.
 * They are connected to the closest point and to those that this is connected to. A graph that
 * is missing, damaged or out of date is an error there, as only vtkPointCloudDGG can build one; the
 * mesh report is empty, and properties that concern cells or the accuracy of a graph do nothing.
 * All other filters need a surface.
 *
 * <b>New geometry.</b> Some outputs have the points of the input, with arrays added. Others have
 * new points that lie on the surface: paths, loops and tapes, samples, the cells of sites and their
 * borders, the boundaries of patches. These are the same for all of them:
 *  - They carry the field data of the input, but for what is that of other points: the graph (the
 *    arrays `DGG.*`, see vtkDiscreteGeodesicGraph) and the windows of exact distances (see
 *    vtkExactGeodesicDistance). Where there are two surfaces, the field data are those of the one
 *    that the output lies on.
 *  - Their points are doubles, as floats would lie beside the surface; OutputPointsPrecision makes
 *    them floats. Arrays of lengths, distances and areas are of type double, and are those of the
 *    points before they are rounded to float.
 *  - `FaceId` numbers cells of that surface, `vtkOriginalPointIds` its points (-1 where there is
 *    none), `Length` and `ArcLength` are in units of the coordinates.
 *
 * <b>Errors.</b> Wrong input is reported through vtkErrorMacro, which names what is wrong and the
 * remedy. Then the output is empty, GetErrorCode() is not zero, and the input is untouched; a later
 * correct call works. As long as nothing is changed, every update of this filter reports the error
 * again. These are errors of all filters:
 *  - no input;
 *  - points but no polygons, unless it is a cloud with its graph; polygons that all have fewer than
 * three distinct points; a cell that names a point that does not exist, or that is not finite; an
 * extent outside [1e-70, 1e70]; more than 2^31 - 1 points or 3 * triangles;
 *  - an update of one piece of several, as in a parallel pipeline: a part of the surface would
 *    give wrong distances. Gather the surface on one process first.
 *
 * An input with neither points nor cells is a warning only: the output is empty as well. An input
 * that is not vtkPolyData is refused by the pipeline.
 *
 * <b>Progress and abort.</b> ProgressEvent is invoked now and then; AbortExecute set by an observer
 * stops the computation: the output is empty, GetErrorCode() is zero, and the next update of this
 * filter starts anew. Call Modified() to have filters downstream follow. Inputs, their arrays and
 * properties must not change during an update, as everywhere in VTK: observers do nothing else.
 *
 * The mesh is prepared once and kept until points, polygons or strips change; a change of another
 * property does not prepare it again, nor does an update upstream that leaves them as they are, bit
 * by bit. Filters with the same surface, as in a chain, share it. Changes in place must be marked
 * by Modified() of the array, the points or the vtkPolyData, as everywhere in VTK.
 *
 * This class is not for subclassing outside of vtkDGG: its virtual functions take types that are
 * installed, but what the surface of a context is stays internal.
 *
 * @sa vtkGeodesicDistanceAlgorithm vtkDiscreteGeodesicGraph vtkGeodesicDistanceMatrix
 */

#ifndef vtkGeodesicAlgorithm_h
#define vtkGeodesicAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For names
#include "vtkPolyDataAlgorithm.h"

#include <atomic>     // For the progress
#include <functional> // For Attempt()
#include <memory>     // For the mesh
#include <string>     // For the report
#include <thread>     // For the thread of the update
#include <vector>     // For what is reached

namespace dgg
{
class Status;
}
class vtkDGGMeshAdapter;
struct vtkDGGContext;
struct vtkDGGDomain;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether points with the very same coordinates are taken as one, as along the seams of a
   * textured mesh or in a soup of triangles. The output keeps all points; coincident ones get equal
   * distances. Default off: then points of the boundary that coincide with others of the boundary
   * are counted in a warning. Not used on point clouds, where such points are next to each other.
   *
   * For gaps between points that should coincide, there is MergeTolerance. A distance that leaves
   * more than half of the surface unconnected with its sources looks for them: a warning reports
   * the tolerance that closes them when boundaries of different parts are within 1e-6 of the
   * diagonal.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * How far from each other points may be that are taken as one, as a fraction of the diagonal of
   * the bounding box of all points; only used with MergeCoincidentPoints. Default 0: coordinates
   * are the very same. Must not be negative or NaN.
   *
   * Points are taken in the order of their ids: each becomes the closest one of those before it
   * that stay themselves and are within the tolerance, or else stays itself. So triangles move by
   * no more than the tolerance, and of a chain of points, each close to the next, one stays for
   * every length of about the tolerance. Choose a tolerance larger than the gaps, but much smaller
   * than the triangles: those that have two corners merged are left out.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Precision of the points of outputs that are new geometry, one of
   * vtkAlgorithm::DesiredOutputPrecision. Default vtkAlgorithm::DOUBLE_PRECISION, whatever the
   * input has: so points lie on the surface to 1e-9 of their triangles. DEFAULT_PRECISION is float
   * where the points of the input are float, else double. Single precision for coordinates out of
   * the range of floats is an error of the update. Other outputs have the points of the input.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /**
   * Size, defects and quality of the surface in the last update, one per line, for people to read.
   * A single line says so when there is no surface.
   */
  std::string GetMeshReport() const;

  ///@{
  /**
   * The same as numbers; zero before the first update and after an update in which the surface was
   * refused.
   *
   * Triangles are those used, after triangulation. Isolated points are used by no triangle.
   * Components are connected through shared points and have a triangle each. Boundary loops are
   * closed chains of edges with one triangle. A non-manifold edge has more than two triangles; a
   * non-manifold vertex is on no such edge, yet its triangles form several fans. Dropped faces are
   * polygons with fewer than three distinct points. Degenerate faces are triangles without area, up
   * to rounding. Duplicate faces are triangles beyond the first on the same three points.
   * Coincident points have the very coordinates of an earlier point, whether they are merged or
   * not; coincident boundary points are those that the warning counts.
   */
  vtkIdType GetNumberOfTriangles() const;
  vtkIdType GetNumberOfIsolatedPoints() const;
  vtkIdType GetNumberOfComponents() const;
  vtkIdType GetNumberOfBoundaryEdges() const;
  vtkIdType GetNumberOfBoundaryLoops() const;
  vtkIdType GetNumberOfNonManifoldEdges() const;
  vtkIdType GetNumberOfNonManifoldVertices() const;
  vtkIdType GetNumberOfDroppedFaces() const;
  vtkIdType GetNumberOfDegenerateFaces() const;
  vtkIdType GetNumberOfDuplicateFaces() const;
  vtkIdType GetNumberOfCoincidentPoints() const;
  vtkIdType GetNumberOfCoincidentBoundaryPoints() const;
  ///@}

  /**
   * Whether the surface can be oriented consistently.
   */
  bool GetOrientable() const;

  /**
   * Total genus of the components; -1 when there are non-manifold edges or no orientation.
   */
  vtkIdType GetGenus() const;

  ///@{
  /**
   * How far the triangles are from equilateral: mean and median of
   * longest edge * perimeter / (4 sqrt(3) area), 1 when equilateral.
   */
  double GetMeanAnisotropy() const;
  double GetMedianAnisotropy() const;
  ///@}

  /**
   * Length added to the edges of triangles without area that could not be left out, in units of the
   * coordinates; 0 when there are none.
   */
  double GetMollification() const;

  /**
   * Largest height of the triangles without area that were left out, one on the other, in units of
   * the coordinates: the surface has moved by no more; 0 when there are none.
   */
  double GetLargestCapHeight() const;

  /**
   * Time stamp of the mesh that is kept between updates. It changes when another mesh takes its
   * place.
   */
  vtkMTimeType GetMeshBuildTime() const;

protected:
  vtkGeodesicAlgorithm();
  ~vtkGeodesicAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * The steps of an update, in this order. Each may return an error, which is shown to the user,
   * or that the user asked to stop; each may throw.
   *
   * CheckProperties() and CheckInputs() report what is wrong without the mesh. Execute() is called
   * with a mesh. MakeEmptyOutput() takes its place when the surface has neither points nor cells.
   * The context is that of the whole update (vtkDGGContext.h).
   */
  virtual dgg::Status CheckProperties() const;
  virtual dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const;
  virtual dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) = 0;
  virtual void MakeEmptyOutput(
    const vtkDGGContext& context, vtkInformationVector* outputVector) = 0;
  ///@}

  /**
   * Whether the input is a cloud for this filter: then its points alone are looked at, and may be
   * anywhere. Default false. Filters that search a graph take an input with the graph of a cloud
   * for one.
   */
  virtual bool IsCloud(vtkPolyData* input) const;

  /**
   * What a user can do when memory is exhausted.
   */
  virtual std::string GetMemoryRemedy() const;

  /**
   * What an update or a prediction works with, for the surface that was prepared last.
   */
  vtkDGGContext MakeContext(vtkPolyData* surface);

  /**
   * Bring the mesh up to date; null is an error. For use outside of updates; Execute() need not.
   */
  dgg::Status PrepareMesh(vtkPolyData* surface);

  /**
   * What a surface is taken for.
   */
  vtkDGGDomain GetDomain(vtkPolyData* surface) const;

  /**
   * After a distance: warn, once for each mesh, when most of the surface is not connected with the
   * vertices that are reached, though its parts all but touch.
   */
  void WarnAboutGaps(vtkPolyData* surface, const std::vector<bool>& isReached);

  /**
   * Do something that may fail or throw, and report the error. Returns whether it went
   * well; not so when it was stopped, either.
   */
  bool Attempt(const std::function<dgg::Status()>& step);

  /**
   * Attempt() outside of updates, as to predict one: with the input brought up to date. The
   * error code stays that of the last update, but for an error.
   */
  bool AttemptOutsideOfUpdate(const std::function<dgg::Status()>& step);

  /**
   * Report the progress of Execute(), in [0, 1]; it never goes back. Returns whether to go on. Any
   * thread may call it: observers are invoked by the thread of the update alone.
   */
  bool Advance(double fraction);

  /**
   * Most bytes that an update may take, 0 for a part of what is free; a property of those filters
   * that take much.
   */
  vtkTypeUInt64 MemoryLimit;

private:
  vtkGeodesicAlgorithm(const vtkGeodesicAlgorithm&) = delete;
  void operator=(const vtkGeodesicAlgorithm&) = delete;

  dgg::Status Follow(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  bool MergeCoincidentPoints;
  double MergeTolerance;
  int OutputPointsPrecision;
  std::atomic<double> Reached; // progress of the update so far
  std::atomic<bool> IsStopped; // whether observers have asked for that
  std::thread::id Caller;      // of the update
  vtkMTimeType GapsBuildTime;  // of the mesh whose gaps have been looked for
  std::unique_ptr<vtkDGGMeshAdapter> Adapter;
};

#endif
