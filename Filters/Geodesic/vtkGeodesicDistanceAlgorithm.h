// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceAlgorithm
 * @brief   what all filters that compute a distance along a surface have in common
 *
 * Input port 0 takes the surface (vtkPolyData). The output is the input, its points, cells and
 * arrays unchanged and in the same order, plus the point array `GeodesicDistance` (double, in the
 * units of the coordinates), which becomes the active scalars.
 *
 * <b>Sources.</b> The distance is that from the nearest source. Sources are points of the surface
 * given by id (AddSourceId(), SetSourceIds()) and the points of a vtkPolyData on the optional input
 * port 1 (SetSourceConnection(), SetSourceData()), which may lie anywhere on the surface, also
 * inside faces and on edges: each is projected to the closest point of the surface. A point array
 * `InitialDistance` on port 1 says with which distance a source starts (any finite number, also a
 * negative one; 0 where there is no such array, and for ids). Sources are numbered from 0: ids
 * first, then the points of port 1. A source on a point that no polygon uses reaches that point
 * only, and is a warning.
 *
 * <b>Cells.</b> Triangles are used as they are; quads, polygons and triangle strips are
 * triangulated inside. For planar polygons it makes no difference how; a quad that is not planar
 * is cut along the shorter one of its diagonals, and larger polygons ear by ear; those that cross
 * or touch themselves become fans, with a warning. Verts and lines
 * are passed through and not used. Polygons with fewer than three distinct points are left out.
 * Triangles without area are used; their edges are lengthened a little (GetMollification()). Edges
 * with more than two triangles and points where sheets touch conduct: distances are those of the
 * triangles as they are glued by point ids. All of these are counted in warnings, once for each
 * mesh, and in the report (GetMeshReport()). Orientation does not matter.
 *
 * <b>Unreached points.</b> Points in a component without a source, points that no polygon uses
 * and points beyond MaximumDistance get UnreachedValue, and -1 as nearest source.
 *
 * <b>Errors.</b> Wrong input is reported through vtkErrorMacro, which names what is wrong and the
 * remedy. Then the output is empty, GetErrorCode() is not zero, and the input is untouched; a later
 * correct call works. As long as nothing is changed, every update of this filter tells the error
 * again. These are errors:
 *  - no input; no source; a source id out of range; a source point that is not finite, or farther
 * from the surface than ProjectionTolerance; an InitialDistance that is not one finite number per
 * point;
 *  - points but no polygons; polygons that all have fewer than three distinct points; a cell that
 *    names a point that does not exist, or that is not finite; an extent outside [1e-70, 1e70];
 *    more than 2^31 - 1 points or 3 * triangles;
 *  - a MaximumDistance or ProjectionTolerance that is negative or not a number; a missing or
 *    repeated array name;
 *  - an update of one piece of several, as in a parallel pipeline: a part of the surface would
 *    give wrong distances. Gather the surface on one process first.
 *
 * An input with neither points nor cells is a warning only: the output is empty as well. An input
 * that is not vtkPolyData is refused by the pipeline.
 *
 * <b>Progress and abort.</b> ProgressEvent is invoked now and then; AbortExecute set by an observer
 * stops the computation: the output is empty, GetErrorCode() is zero, and the next update of this
 * filter starts anew. Call Modified() to have filters downstream follow.
 *
 * The mesh is prepared once and kept until points, polygons or strips change; a change of sources
 * or of another property does not prepare it again. Changes in place must be marked by Modified()
 * of the array, the points or the vtkPolyData, as everywhere in VTK.
 *
 * Subclasses in this module implement ComputeDistances(); what it takes is internal to the module.
 *
 * @sa vtkExactGeodesicDistance
 */

#ifndef vtkGeodesicDistanceAlgorithm_h
#define vtkGeodesicDistanceAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <initializer_list> // For source ids
#include <memory>           // For the internals
#include <string>           // For array names
#include <vector>           // For source ids

namespace dgg
{
class Status;
}
struct vtkDGGDistanceTask;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicDistanceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input. Ids are copied; none by default. The same id may occur more
   * than once. An id outside [0, number of points - 1] is an error of the update. From Python, any
   * sequence of integers will do, a numpy array included. A null list removes all ids.
   */
  void AddSourceId(vtkIdType id);
  void SetSourceIds(vtkIdList* ids);
  void SetSourceIds(const std::vector<vtkIdType>& ids);
#ifndef __VTK_WRAP__
  void SetSourceIds(std::initializer_list<vtkIdType> ids); // or {0} would be a null list
#endif
  void RemoveAllSourceIds();
  vtkIdType GetNumberOfSourceIds() const;
  ///@}

  /**
   * Remove the source ids and disconnect input port 1.
   */
  void RemoveAllSources();

  /**
   * The i-th source id; -1 when there is none.
   */
  vtkIdType GetSourceId(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOfSourceIds());

  ///@{
  /**
   * Sources anywhere on the surface: the points of a vtkPolyData on input port 1 (its cells are not
   * used). Null removes them.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; must not
   * be negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Whether points with the very same coordinates are taken as one, as along the seams of a
   * textured mesh or in a soup of triangles. The output keeps all points; coincident ones get equal
   * distances. Default off: then points of the boundary that coincide with others of the boundary
   * are counted in a warning.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Points farther away than this, in units of the coordinates, are left unreached, which saves the
   * time to reach them. Default VTK_DOUBLE_MAX, no limit; infinity means the same. Must not be
   * negative or NaN.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Distance given to points that are not reached. Default NaN, which the ranges and lookup tables
   * of VTK ignore. Contour filters do not: in triangles of which a part of the points is unreached,
   * as along the rim of a MaximumDistance, their lines have points that are NaN. Remove such
   * triangles first, with vtkThreshold.
   */
  virtual void SetUnreachedValue(double value);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * Whether to add the point array `GeodesicSource` (int): the number of the nearest source, -1
   * where no source reaches. Of sources at exactly the same distance, any may be named. Default
   * off.
   */
  vtkSetMacro(GenerateNearestSource, bool);
  vtkGetMacro(GenerateNearestSource, bool);
  vtkBooleanMacro(GenerateNearestSource, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances. Default "GeodesicDistance". An array of this name
   * in the input is replaced in the output.
   */
  void SetDistanceArrayName(const char* name);
  const char* GetDistanceArrayName() const;
  ///@}

  ///@{
  /**
   * Name of the point array with the nearest sources. Default "GeodesicSource".
   */
  void SetSourceArrayName(const char* name);
  const char* GetSourceArrayName() const;
  ///@}

  ///@{
  /**
   * Name of the point array of input port 1 with the distances that the sources start with. Default
   * "InitialDistance".
   */
  void SetInitialDistanceArrayName(const char* name);
  const char* GetInitialDistanceArrayName() const;
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
   * Length added to the edges of triangles without area, in units of the coordinates; 0 when there
   * are none.
   */
  double GetMollification() const;

  /**
   * Time stamp of the mesh that is kept between updates. It changes when the mesh is prepared anew.
   */
  vtkMTimeType GetMeshBuildTime() const;

protected:
  vtkGeodesicDistanceAlgorithm();
  ~vtkGeodesicDistanceAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Fill the results of the task. Called with a mesh and at least one source, both checked.
   * Returns an error, which is shown to the user, or that the task's Progress asked to stop. May
   * throw.
   */
  virtual dgg::Status ComputeDistances(vtkDGGDistanceTask& task) = 0;

private:
  vtkGeodesicDistanceAlgorithm(const vtkGeodesicDistanceAlgorithm&) = delete;
  void operator=(const vtkGeodesicDistanceAlgorithm&) = delete;

  dgg::Status Execute(
    vtkPolyData* input, vtkPolyData* sourcePoints, vtkInformation* outInfo, vtkPolyData* output);
  dgg::Status CheckProperties(vtkInformation* outInfo) const;
  dgg::Status PrepareMesh(vtkPolyData* input);
  void WarnAboutIsolatedSources() const;
  void AddResults(vtkPolyData* input, const vtkDGGDistanceTask& task, vtkPolyData* output);
  void AddArrays(vtkPolyData* output, vtkDataArray* distances, vtkDataArray* sources);

  std::vector<vtkIdType> SourceIds;
  double ProjectionTolerance;
  bool MergeCoincidentPoints;
  double MaximumDistance;
  double UnreachedValue;
  bool GenerateNearestSource;
  std::string DistanceArrayName;
  std::string SourceArrayName;
  std::string InitialDistanceArrayName;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
