// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   what all filters on the surface of a mesh have in common
 *
 * <b>Input and output</b>. Input port 0 takes the surface (vtkPolyData). Outputs are the input with
 * arrays added, or new geometry. Lengths are in units of the coordinates.
 *  - Triangles are used as they are; quads, polygons and strips are triangulated inside: quads
 *    along the shorter diagonal, larger polygons ear by ear, those that cross or touch themselves
 *    as fans, with a warning. Verts and lines are passed on and not used. Orientation does not
 *    matter.
 *  - Left out are polygons with fewer than three distinct points, triangles on the three points of
 *    an earlier one, and triangles of near-zero area with the apex on the opposite edge; the other
 *    triangles on that edge are split there. Edges of other triangles of near-zero area are
 *    lengthened a little (GetMollification()).
 *  - Edges with more than two triangles, and points where sheets touch, conduct: distances are
 *    those of the triangles as glued by point ids.
 *  - Each mesh gets one warning for each kind of defect; GetMeshReport() counts them all.
 *
 * <b>New geometry</b> (paths, loops, isolines, samples, cells, curves) has double points on the
 * surface (OutputPointsPrecision) and the field data of the input without graph and windows.
 * `FaceId` numbers cells of the surface, `vtkOriginalPointIds` its points (-1 elsewhere). Where it
 * counts the pieces of a polyline, `FaceId` is the cell of the piece after the point, at the last
 * point of the one before it; `ArcLength` is the length up to the point. Each piece lies in one
 * triangle. If all polygons are triangles, `Barycentric` (3 components) are the coordinates of the
 * point with respect to the corners of `FaceId`, 0 where that is -1.
 *
 * <b>Points of further inputs</b> (sources, sites, ends of paths) are moved to the closest point of
 * the surface, within ProjectionTolerance, unless point arrays identify them, which is necessary
 * where parts of the surface coincide, as at a slit:
 *  - `FaceId` and `Barycentric` together, wherever the point is. Cells other than triangles, and
 *    coordinates that are negative, not finite or do not sum to 1 (within 1e-6), are errors;
 *  - `vtkOriginalPointIds`, if the point lies at that point of the surface.
 * With all three, as in new geometry, which may be that of another surface, `FaceId` and
 * `Barycentric` count only if the point lies there, and are never an error.
 *
 * <b>Graphs</b>. vtkDGGDistance, vtkDGGPath, vtkDGGLoop, vtkGeodesicSampler, vtkGeodesicVoronoi and
 * vtkGeodesicDistanceMatrix search a graph: that on the input, see vtkDiscreteGeodesicGraph, else
 * one that they build with their Accuracy, and keep until mesh or Accuracy changes. One that is
 * damaged or of another surface is replaced, with a warning.
 *
 * <b>Point clouds</b>. Of these filters all but vtkDGGLoop take a cloud with the graph of
 * vtkPointCloudDGG. Its cells are not used; a missing, damaged or outdated graph is an error,
 * Accuracy and AcceptCoarserGraph do nothing, and the mesh report is empty. Points asked for may
 * lie beside the cloud, within ProjectionTolerance or as far as the closest point is from its six
 * neighbours; they are connected to it and to those that it is connected to.
 * vtkDGGFastMarchingDistance takes any cloud, without a graph. All other filters need a surface.
 *
 * <b>Several processes, blocks, partitions</b>. Input in parts is joined to one surface, on which
 * the first process computes for all; all must update together.
 *  - Pieces of processes and partitions of a vtkPartitionedDataSet, but for ghost cells, are joined
 *    where points have the same global id; without these, where points on the rims of different
 *    parts are in the same place. What several processes have counts once.
 *  - Blocks, leaves of a vtkMultiBlockDataSet or members of a vtkPartitionedDataSetCollection, are
 *    not connected, but by MergeCoincidentPoints. Each source belongs to the nearest.
 *  - Ids of points and cells are those of the joined surface: block by block, in each by global ids
 *    or else part by part.
 *  - An output that is the input with arrays added has the parts and the type of the input; for
 *    blocks, GetOutput() is null, and GetOutputDataObject(0) has them. Ghost cells are missing
 *    there. Field data of the whole, such as a graph, are those of the data object itself on the
 *    first process. New geometry is one vtkPolyData there, and getters report there only. What is
 *    joined is kept until a part changes.
 *
 * <b>Guarantee and cost</b>. Results do not depend on the number of threads. The mesh is prepared
 * once, kept until points, polygons or strips change, and shared by the filters of a chain. Changes
 * in place need Modified(): of the array or the vtkPoints of coordinates, of the vtkCellArray (not
 * of its arrays), or of the vtkPolyData. Inputs and properties must not change during an update.
 *
 * <b>Errors</b>. vtkErrorMacro names what is wrong and the remedy. The output is empty,
 * GetErrorCode() is not zero, the input is untouched, and a later correct call works. Until
 * something changes, further updates fail as well, but do not report the same error again. Filters
 * downstream of one that has failed or was aborted have empty outputs and report nothing. Errors of
 * all filters:
 *  - no input; an image or a grid (vtkDataSetSurfaceFilter makes a surface of it); points but no
 * polygon with three distinct points; a cell that names a missing point, or one that is not finite;
 *  - an extent outside [1e-70, 1e70]; more than 2^31 - 1 points or 3 * triangles; so many defects,
 *    or triangles so long, that the work would grow out of proportion;
 *  - one piece of several without a Controller that has as many processes; pieces with more points
 *    than GatherLimit, or that take more than MemoryLimit while they are gathered. Memory that is
 *    exhausted amid a message all the same leaves the other processes waiting.
 *
 * An input without points and cells is a warning, with an empty output. AbortExecute, set by an
 * observer of ProgressEvent, empties the output with error code zero; the next update starts anew.
 *
 * Not for subclassing outside of this project: what virtual functions are given is internal.
 *
 * @sa vtkGeodesicDistanceAlgorithm vtkDiscreteGeodesicGraph
 */

#ifndef vtkGeodesicAlgorithm_h
#define vtkGeodesicAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For names
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the whole input

#include <atomic>     // For the progress
#include <functional> // For Attempt()
#include <memory>     // For the mesh
#include <set>        // For the warnings
#include <string>     // For the report
#include <thread>     // For the thread of the update
#include <vector>     // For what is reached

namespace dgg
{
class Status;
}
class DGGMeshAdapter;
class DGGPartedUpdate;
struct DGGContext;
namespace dgg
{
struct Domain;
}
class vtkMultiProcessController;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether points with the same coordinates are one, as along texture seams or in triangle soups.
   * The output keeps all points. Default off: coincident boundary points are counted in a warning.
   * Not used on clouds.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Largest distance of points that MergeCoincidentPoints treats as one, as a fraction of the
   * diagonal of the bounding box. Default 0: same coordinates; not negative. Each point becomes the
   * closest earlier one within the tolerance that stays itself. Choose it larger than the gaps and
   * much smaller than the triangles: those with two corners merged are left out.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Precision of the points of new geometry, one of vtkAlgorithm::DesiredOutputPrecision. Default
   * DOUBLE_PRECISION: points lie on the surface to 1e-9 of their triangles. DEFAULT_PRECISION is
   * that of the input. SINGLE_PRECISION for coordinates out of the range of floats is an error.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The processes that have pieces of the surface. Default: the global controller at the time when
   * the filter is made.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Most points of all inputs that the first process gathers from all; more are an error. Default
   * 100 million; each takes some 200 bytes, and its arrays twice.
   */
  vtkSetMacro(GatherLimit, vtkIdType);
  vtkGetMacro(GatherLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Most bytes that an update may take: for graphs, factorizations and whatever else a filter says
   * is large, and for pieces that are gathered. More is an error, before they are taken. Default 0:
   * 70 % of the memory that is free at that time, for what is not there yet. Not negative.
   */
  vtkSetMacro(MemoryLimit, vtkTypeInt64);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  /**
   * Size, defects and quality of the surface of the last update, one per line, for people to read.
   */
  std::string GetMeshReport() const;

  ///@{
  /**
   * The same as numbers; zero without a surface. Triangles are those used. No triangle uses an
   * isolated point. Components are connected through shared points. Boundary loops are closed
   * chains of edges with one triangle. A non-manifold edge has more than two triangles; a
   * non-manifold vertex is on no such edge, but has several fans. Dropped faces have fewer than
   * three distinct points, degenerate ones near-zero area; duplicate faces are on the points of an
   * earlier one. Coincident points have the coordinates of an earlier point; of boundary points,
   * those that the warning counts.
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
   * Mean, weighted with areas, and median of longest edge * perimeter / (4 sqrt(3) area) of
   * triangles: 1 if equilateral. Above a mean of 2 much of the surface is covered by long
   * triangles.
   */
  double GetMeanAnisotropy() const;
  double GetMedianAnisotropy() const;
  ///@}

  /**
   * Length added to edges of triangles of near-zero area, in units of the coordinates; 0 without.
   */
  double GetMollification() const;

  /**
   * Largest height of triangles of near-zero area that were left out, one on the other, in units of
   * the coordinates: the surface has moved by no more; 0 without.
   */
  double GetLargestCapHeight() const;

  /**
   * Time stamp of the mesh that is kept between updates.
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

  ///@{
  /**
   * The steps of an update, in this order. Each may return an error, which is shown to the user,
   * or that the user asked to stop; each may throw.
   *
   * CheckProperties() and CheckInputs() report what is wrong without the mesh. Execute() is called
   * with a mesh. MakeEmptyOutput() takes its place when the surface has neither points nor cells.
   * The context is that of the whole update (DGGContext.h).
   */
  virtual dgg::Status CheckProperties() const;
  virtual dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const;
  virtual dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) = 0;
  virtual void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) = 0;
  ///@}

  /**
   * Whether output 0 is the surface with arrays added, and so has the parts of the input. Default
   * false: it is new geometry, as other outputs are.
   */
  virtual bool PassesSurface() const;

  /**
   * Whether this filter treats the input as a cloud, of which only the points count. Default false;
   * filters that search a graph do so for an input with the graph of a cloud.
   */
  virtual bool IsCloud(vtkPolyData* input) const;

  /**
   * What a user can do when memory is exhausted.
   */
  virtual std::string GetMemoryRemedy() const;

  /**
   * What an update or a prediction works with, for the surface that was prepared last.
   */
  DGGContext MakeContext(vtkPolyData* surface);

  /**
   * Bring the mesh up to date; null is an error. For use outside of updates; Execute() need not.
   */
  dgg::Status PrepareMesh(vtkPolyData* surface);

  /**
   * The input of port 0, its parts joined, for use outside of updates; null when there is none.
   */
  dgg::Status GetWholeInput(vtkSmartPointer<vtkPolyData>& surface);

  /**
   * What a surface is treated as.
   */
  dgg::Domain GetDomain(vtkPolyData* surface) const;

  /**
   * After a distance: warn, once for each mesh, when most of the surface is not connected with the
   * vertices that are reached, though its parts nearly touch.
   */
  void WarnAboutGaps(const std::vector<bool>& isReached);

  /**
   * Reports a reason for inaccurate results once per mesh. Returns true if there is a reason.
   */
  bool WarnAboutQuality(const std::string& reason);

  /**
   * Run a step that may fail or throw, and report the error. Returns whether it succeeded and was
   * not stopped.
   */
  bool Attempt(const std::function<dgg::Status()>& step);

  /**
   * Attempt() outside of updates, with the input brought up to date. Only an error changes the
   * error code.
   */
  bool AttemptOutsideOfUpdate(const std::function<dgg::Status()>& step);

  /**
   * Report the progress of Execute(), in [0, 1]; it never goes back. Returns whether to go on. Any
   * thread may call it: observers are invoked by the thread of the update alone.
   */
  bool Advance(double fraction);

  /**
   * Have the filter warn of an input without what it lacks, unless a filter before has failed.
   */
  void WarnAboutEmptyInput(const char* lack);

  vtkTypeInt64 MemoryLimit; ///< signed, as ParaView passes no other integers of this size

private:
  vtkGeodesicAlgorithm(const vtkGeodesicAlgorithm&) = delete;
  void operator=(const vtkGeodesicAlgorithm&) = delete;

  dgg::Status Try(const std::function<dgg::Status()>& step, unsigned long& errorCode) const;
  dgg::Status Follow(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  dgg::Status Compute(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void MakeSurfaceOutput(vtkDataObject* input, vtkInformation* outInfo) const;
  static bool FollowsFailure(vtkAlgorithm* filter);
  bool IsNews(const std::string& error);

  bool MergeCoincidentPoints;
  double MergeTolerance;
  int OutputPointsPrecision;
  vtkMultiProcessController* Controller;
  vtkIdType GatherLimit;
  std::atomic<double> Reached;          // progress of the update so far
  std::atomic<bool> IsStopped;          // whether observers have asked for that
  std::thread::id Caller;               // of the update
  std::string Reported;                 // error of the last update, empty without
  vtkMTimeType ReportTime;              // of the pipeline at that time
  vtkMTimeType GapsBuildTime;           // of the mesh whose gaps have been looked for
  vtkMTimeType QualityTime;             // build time of the mesh of QualityReasons
  std::set<std::string> QualityReasons; // reported for this mesh
  std::unique_ptr<DGGMeshAdapter> Adapter;
  std::unique_ptr<DGGPartedUpdate> Parts;
};

#endif
