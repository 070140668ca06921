// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceAlgorithm
 * @brief   what all filters that compute a distance along a surface have in common
 *
 * Input port 0 takes the surface (vtkPolyData). The output is the input, its points, cells and
 * arrays unchanged and in the same order, plus the point array `GeodesicDistance` (double, in the
 * units of the coordinates), which becomes the active scalars. What is done with cells, errors,
 * progress and abort is said in vtkGeodesicAlgorithm.
 *
 * <b>Sources.</b> The distance is that from the nearest source. Sources are points of the surface
 * given by id (AddSourceId(), SetSourceIds()) and the points of a vtkPolyData on the optional input
 * port 1 (SetSourceConnection(), SetSourceData()), which may lie anywhere on the surface, also
 * inside faces and on edges: each is projected to the closest point of the surface. A source may
 * start with a distance other than 0, any finite number, also a negative one: that of an id is
 * given with the id, those of port 1 by a point array `InitialDistance`. Sources are numbered from
 * 0: ids first, then the points of port 1. A source on a point that no polygon uses reaches that
 * point only, and is a warning.
 *
 * <b>Unreached points.</b> Points in a component without a source, points that no polygon uses
 * and points beyond MaximumDistance get UnreachedValue, and -1 as nearest source.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no source; a source id out of range; a source point that is not finite, or farther
 * from the surface than ProjectionTolerance; an initial distance that is not finite, or not one
 * number per point;
 *  - a MaximumDistance or ProjectionTolerance that is negative or not a number; a missing or
 *    repeated array name.
 *
 * This class is not for subclassing outside of its module: its virtual functions take types that
 * are internal to the module and not installed.
 *
 * @sa vtkExactGeodesicDistance vtkDGGDistance
 */

#ifndef vtkGeodesicDistanceAlgorithm_h
#define vtkGeodesicDistanceAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <initializer_list> // For source ids
#include <memory>           // For the search for source points
#include <string>           // For array names
#include <vector>           // For source ids

struct vtkDGGDistanceTask;
struct vtkDGGPointArray;
struct vtkDGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicDistanceAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input. Ids are copied; none by default. The same id may occur more
   * than once. An id outside [0, number of points - 1] is an error of the update. From Python, any
   * sequence of integers will do, a numpy array included. A null list removes all ids.
   *
   * The initial distance is that with which a source starts, any finite number; 0 for those given
   * without. A list of them needs one for each id; another number of them is an error at once, and
   * changes nothing.
   */
  void AddSourceId(vtkIdType id, double initialDistance = 0.0);
  void SetSourceIds(vtkIdList* ids);
  void SetSourceIds(const std::vector<vtkIdType>& ids);
  void SetSourceIds(const std::vector<vtkIdType>& ids, const std::vector<double>& initialDistances);
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

  /**
   * The distance that the i-th source id starts with; 0 when there is none.
   */
  double GetSourceInitialDistance(vtkIdType i) const
    VTK_EXPECTS(0 <= i && i < GetNumberOfSourceIds());

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
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
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
   *
   * vtkApolloniusIsolines and vtkGeodesicProbe know what is not reached, whatever the value: where
   * it is neither NaN nor plus infinity and stands for a point, the point array
   * `GeodesicDistance.Unreached` (unsigned char) is 1 at these points and 0 elsewhere; that of
   * upper bounds is `GeodesicUpperBound.Unreached`.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
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
   * Whether to add the point array `GeodesicVirtualSource` (double, 3 components): where the
   * distance of a point seems to come from, as seen from the point. The components are the distance
   * at that virtual source (in units of the coordinates), the straight distance from it, and its
   * direction, the polar angle at the point in radians, as in `DGG.Angles` but not reduced to one
   * turn. The sum of the first two is the distance, or, for approximate distances, the estimate
   * before it is confined to a promised interval. With it the distance is known inside of faces as
   * well: for isolines (vtkApolloniusIsolines) and probes (vtkGeodesicProbe). Default off.
   */
  vtkSetMacro(GenerateVirtualSource, bool);
  vtkGetMacro(GenerateVirtualSource, bool);
  vtkBooleanMacro(GenerateVirtualSource, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances. Default "GeodesicDistance". An array of this name
   * in the input is replaced in the output, and what belongs to it goes: its windows, and the
   * nearest and virtual sources unless new ones are made.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the nearest sources. Default "GeodesicSource".
   */
  vtkDGGStringMacro(SourceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the virtual sources. Default "GeodesicVirtualSource".
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array of input port 1 with the distances that the sources start with. Default
   * "InitialDistance".
   */
  vtkDGGStringMacro(InitialDistanceArrayName);
  ///@}

protected:
  vtkGeodesicDistanceAlgorithm();
  ~vtkGeodesicDistanceAlgorithm() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

  /**
   * Fill the results of the task. Called with a mesh and at least one source, both checked.
   * Returns an error, which is shown to the user, or that the task's Progress asked to stop. May
   * throw.
   */
  virtual dgg::Status ComputeDistances(vtkDGGDistanceTask& task) = 0;

  /**
   * Point arrays that ComputeDistances() fills besides distances and nearest sources. Default none.
   */
  virtual std::vector<vtkDGGPointArray> DeclareArrays() const;

private:
  vtkGeodesicDistanceAlgorithm(const vtkGeodesicDistanceAlgorithm&) = delete;
  void operator=(const vtkGeodesicDistanceAlgorithm&) = delete;

  vtkDGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  void AddResults(const vtkDGGDistanceTask& task, vtkPolyData* output);

  std::vector<vtkIdType> SourceIds;
  std::vector<double> SourceOffsets; // initial distances, one for each id
  double ProjectionTolerance;
  double MaximumDistance;
  double UnreachedValue;
  bool GenerateNearestSource;
  bool GenerateVirtualSource;
  std::string DistanceArrayName;
  std::string SourceArrayName;
  std::string VirtualSourceArrayName;
  std::string InitialDistanceArrayName;
};

#endif
