// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceAlgorithm
 * @brief   what all filters that compute a distance along a surface have in common
 *
 * <b>Input and output</b>. Each point gets the distance from the nearest source. The output is the
 * input, in the same order, plus the point array `GeodesicDistance` (double, in units of the
 * coordinates), which becomes the active scalars; on request also the nearest and virtual sources.
 *
 * Sources are point ids (SetSourceIds()) and the points of a vtkPolyData on the optional input port
 * 1 (SetSourceConnection()), each moved to the closest point of the surface, or identified by point
 * arrays, see vtkGeodesicAlgorithm. They are numbered from 0, ids first. A source starts with the
 * distance given with its id, or in the point array `InitialDistance` of port 1: any finite number,
 * 0 by default. One on a point that no polygon uses reaches that point only, with a warning.
 *
 * Points that no source reaches, and those beyond MaximumDistance, get UnreachedValue, and -1 as
 * nearest source.
 *
 * <b>Guarantee and cost</b>. See the subclasses and vtkGeodesicAlgorithm.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - no source; a source id out of range; a source point that is not finite, or farther from the
 *    surface than ProjectionTolerance; initial distances that are not finite, or not one per point;
 *  - a MaximumDistance or ProjectionTolerance that is negative or NaN; an array name that is empty
 *    or used twice.
 *
 * @sa vtkDGGDistance vtkExactGeodesicDistance vtkHeatGeodesicDistance
 */

#ifndef vtkGeodesicDistanceAlgorithm_h
#define vtkGeodesicDistanceAlgorithm_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <initializer_list> // For source ids
#include <memory>           // For the search for source points
#include <string>           // For array names
#include <vector>           // For source ids

struct DGGDistanceTask;
struct DGGPointArray;
struct DGGSourceSet;

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicDistanceAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGeodesicDistanceAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input, with the distances that they start with: any finite number, 0
   * by default. None by default; ids may repeat, one out of range is an error of the update. Python
   * takes any sequence of integers. A null list removes all. A list of distances of another length
   * than that of the ids is an error at once, and changes nothing.
   */
  void AddSourceId(vtkIdType id) { this->AddSourceId(id, 0.0); }
  void AddSourceId(vtkIdType id, double initialDistance);
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
   * Sources anywhere on the surface: the points of a vtkPolyData on input port 1. Null removes
   * them.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* points);
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
   * Points farther away, in units of the coordinates, are left unreached, which saves time. Default
   * VTK_DOUBLE_MAX; not negative or NaN; infinity is no limit.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Distance of points that are not reached. Default NaN, which ranges and lookup tables of VTK
   * ignore, but contour filters do not. With a finite number that marks points, the point array
   * `GeodesicDistance.Unreached` (unsigned char) is 1 at these and 0 elsewhere;
   * vtkApolloniusIsolines and vtkGeodesicProbe read it. That of upper bounds is
   * `GeodesicUpperBound.Unreached`.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * Whether to add the point array `GeodesicSource` (int): number of the nearest source, -1 where
   * unreached; of sources at the same distance, any. Default off.
   */
  vtkSetMacro(GenerateNearestSource, bool);
  vtkGetMacro(GenerateNearestSource, bool);
  vtkBooleanMacro(GenerateNearestSource, bool);
  ///@}

  ///@{
  /**
   * Whether each point gets the point arrays of port 1 from its nearest source, such as names and
   * labels. Where that is one of SourceIds, or there is none: NaN, 0 or the empty string. Arrays of
   * the surface and results of the filter stay, where names are the same; arrays of another length
   * than the points are left out. Default off.
   */
  vtkSetMacro(PassSourceArrays, bool);
  vtkGetMacro(PassSourceArrays, bool);
  vtkBooleanMacro(PassSourceArrays, bool);
  ///@}

  ///@{
  /**
   * Whether to add the point array `GeodesicVirtualSource` (double, 3 components): where the
   * distance of a point seems to come from. These are the distance at that virtual source, the
   * straight distance from it, and its direction, the polar angle at the point in radians as in
   * `DGG.Angles`, but not reduced to one turn. For vtkApolloniusIsolines and vtkGeodesicProbe.
   * Default off.
   */
  vtkSetMacro(GenerateVirtualSource, bool);
  vtkGetMacro(GenerateVirtualSource, bool);
  vtkBooleanMacro(GenerateVirtualSource, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances. Default "GeodesicDistance". It replaces an array of
   * this name in the input, and what belongs to that: windows, nearest and virtual sources.
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
   * Name of the point array of port 1 with initial distances. Default "InitialDistance".
   */
  vtkDGGStringMacro(InitialDistanceArrayName);
  ///@}

protected:
  vtkGeodesicDistanceAlgorithm();
  ~vtkGeodesicDistanceAlgorithm() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override
  {
    return true;
  }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

  /**
   * Fill the results of the task. Called with a mesh and at least one source, both checked.
   * Returns an error, which is shown to the user, or that the task's Progress asked to stop. May
   * throw.
   */
  virtual dgg::Status ComputeDistances(DGGDistanceTask& task) = 0;

  /**
   * Point arrays that ComputeDistances() fills besides distances and nearest sources. Default none.
   */
  virtual std::vector<DGGPointArray> DeclareArrays() const;

private:
  vtkGeodesicDistanceAlgorithm(const vtkGeodesicDistanceAlgorithm&) = delete;
  void operator=(const vtkGeodesicDistanceAlgorithm&) = delete;

  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  void AddResults(
    const DGGDistanceTask& task, const std::vector<bool>& isReached, vtkPolyData* output);

  std::vector<vtkIdType> SourceIds;
  std::vector<double> SourceOffsets; // initial distances, one for each id
  double ProjectionTolerance;
  double MaximumDistance;
  double UnreachedValue;
  bool GenerateNearestSource;
  bool PassSourceArrays;
  bool GenerateVirtualSource;
  std::string DistanceArrayName;
  std::string SourceArrayName;
  std::string VirtualSourceArrayName;
  std::string InitialDistanceArrayName;
};

#endif
