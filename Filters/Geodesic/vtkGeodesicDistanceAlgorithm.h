// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceAlgorithm
 * @brief   base class of filters that compute distances along a surface
 *
 * <b>Input and output</b>. Each point gets the distance from its nearest source. The output is the
 * input, in the same order, plus the point array `GeodesicDistance` (double, in units of the
 * coordinates), which becomes the active scalars. Nearest sources and virtual sources are optional.
 *
 * Sources are point ids (SetSourceIds()) and the points of a vtkPolyData on the optional input port
 * 1 (SetSourceConnection()). Such a point is moved to the closest point of the surface, or
 * identified by the point arrays FaceId and Barycentric, or vtkOriginalPointIds, see
 * Filters/Geodesic/README.md. Sources are numbered from 0, ids first. Each may start with an
 * initial distance. A source at a point that no polygon uses reaches only that point, with a
 * warning.
 *
 * Points that no source reaches and points beyond MaximumDistance get UnreachedValue, and -1 as
 * nearest source.
 *
 * <b>Guarantee and cost</b>. See the subclasses.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm, no source, and
 *  - a source id out of range; a source point that is not finite, or farther from the surface
 *    than ProjectionTolerance; initial distances that are not finite, or not one per point;
 *  - an array name that is empty or used twice.
 *
 * The module page is Filters/Geodesic/Distances.md.
 *
 * @sa vtkDGGDistance vtkExactGeodesicDistance vtkHeatGeodesicDistance
 */

#ifndef vtkGeodesicDistanceAlgorithm_h
#define vtkGeodesicDistanceAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <initializer_list> // For source ids
#include <limits>           // For UnreachedValue
#include <string>           // For array names
#include <vector>           // For source ids

class DGGDistanceInternals;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicDistanceAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input, each with an initial distance: any finite number, default 0.
   * None by default. Ids may repeat; an id out of range is an error of the update. Python takes any
   * sequence of integers. A null list removes all. A list of distances that differs in length from
   * the list of ids is an immediate error and changes nothing.
   */
  void AddSourceId(vtkIdType id) { this->AddSourceId(id, 0.0); }
  void AddSourceId(vtkIdType id, double initialDistance);
  void SetSourceIds(vtkIdList* ids);
  void SetSourceIds(const std::vector<vtkIdType>& ids);
  void SetSourceIds(const std::vector<vtkIdType>& ids, const std::vector<double>& initialDistances);
#ifndef __VTK_WRAP__
  void SetSourceIds(std::initializer_list<vtkIdType> ids); // otherwise {0} is a null list
#endif
  void RemoveAllSourceIds();
  vtkIdType GetNumberOfSourceIds() const;
  ///@}

  /**
   * Remove the source ids and disconnect input port 1.
   */
  void RemoveAllSources();

  /**
   * Returns the i-th source id; -1 if there is none.
   */
  vtkIdType GetSourceId(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOfSourceIds());

  /**
   * Returns the initial distance of the i-th source id; 0 if there is none.
   */
  double GetSourceInitialDistance(vtkIdType i) const
    VTK_EXPECTS(0 <= i && i < GetNumberOfSourceIds());

  ///@{
  /**
   * Sources anywhere on the surface: the points of a vtkPolyData on input port 1. Null removes
   * them.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* points);
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
   * Distance, in units of the coordinates, at which the search stops; farther points remain
   * unreached. Default VTK_DOUBLE_MAX; negative values and NaN are errors; infinity is no limit.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Distance of points that are not reached. Default NaN, which ranges and lookup tables of VTK
   * ignore, but contour filters do not. If a finite value marks points, the point array
   * `GeodesicDistance.Unreached` (unsigned char) is 1 at these points and 0 elsewhere;
   * vtkApolloniusIsolines and vtkGeodesicProbe read it. The array of upper bounds is
   * `GeodesicUpperBound.Unreached`.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * If on, add the point array `GeodesicSource` (int): index of the nearest source, -1 where
   * unreached; any of several sources at the same distance. Default off.
   */
  vtkSetMacro(GenerateNearestSource, bool);
  vtkGetMacro(GenerateNearestSource, bool);
  vtkBooleanMacro(GenerateNearestSource, bool);
  ///@}

  ///@{
  /**
   * If on, each point gets the point arrays of port 1 from its nearest source, such as names and
   * labels. Where that source is one of SourceIds, or there is none, values are NaN, 0 or the empty
   * string. Arrays of the surface and results of the filter take precedence over arrays of the same
   * name; arrays of another length than the points are skipped. Default off.
   */
  vtkSetMacro(PassSourceArrays, bool);
  vtkGetMacro(PassSourceArrays, bool);
  vtkBooleanMacro(PassSourceArrays, bool);
  ///@}

  ///@{
  /**
   * If on, add the point array `GeodesicVirtualSource` (double, 3 components) for
   * vtkApolloniusIsolines and vtkGeodesicProbe: the distance with which the virtual source of the
   * point starts, the straight distance from that source, and its direction, a polar angle at the
   * point in radians as in `DGG.Angles`, but not reduced to one turn. vtkDGGDistance may also store
   * windows as field data and then returns exact distances, see its class documentation. Default
   * off.
   */
  vtkSetMacro(GenerateVirtualSource, bool);
  vtkGetMacro(GenerateVirtualSource, bool);
  vtkBooleanMacro(GenerateVirtualSource, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances. Default "GeodesicDistance". The array replaces an
   * array of this name in the input together with its windows, nearest and virtual sources.
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
   * Name of the point array of port 1 with initial distances: one finite number per point. Default
   * "InitialDistance"; without the array all are 0.
   */
  vtkDGGStringMacro(InitialDistanceArrayName);
  ///@}

protected:
  vtkGeodesicDistanceAlgorithm();
  ~vtkGeodesicDistanceAlgorithm() override = default;

private:
  vtkGeodesicDistanceAlgorithm(const vtkGeodesicDistanceAlgorithm&) = delete;
  void operator=(const vtkGeodesicDistanceAlgorithm&) = delete;

  friend class DGGDistanceInternals;

  std::vector<vtkIdType> SourceIds;
  std::vector<double> SourceOffsets; // initial distances, one for each id
  double ProjectionTolerance = 0.01;
  double MaximumDistance = VTK_DOUBLE_MAX;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  bool GenerateNearestSource = false;
  bool PassSourceArrays = false;
  bool GenerateVirtualSource = false;
  std::string DistanceArrayName = "GeodesicDistance";
  std::string SourceArrayName = "GeodesicSource";
  std::string VirtualSourceArrayName = "GeodesicVirtualSource";
  std::string InitialDistanceArrayName = "InitialDistance";
};

#endif
