// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicProbe
 * @brief   a distance that is known at the points of a surface, at any other point of it
 *
 * <b>Input and output</b>. Port 0 takes a surface with a point array of distances, the one of
 * SetInputArrayToProcess(), else of DistanceArrayName; port 1 a vtkPolyData whose points are the
 * places, projected to the surface. The output is the input of port 1 plus a point array of the
 * name of the distances (double), NaN in triangles with an unreached corner. As in
 * vtkApolloniusIsolines, arrays of windows and virtual sources that do not belong to the distances
 * are ignored, with a warning.
 *
 * <b>Guarantee and cost</b>. With windows (vtkExactGeodesicDistance::GenerateWindowsOn()) exact;
 * with virtual sources (GenerateVirtualSourceOn() of any distance filter), or those fitted to the
 * distances without, better than linear interpolation, but without a bound: inside the long
 * triangles of CAD models, which are reached from many sides, they may be off by half of the
 * largest distance. A warning recommends windows if GetMeanAnisotropy() is above 2. One search in
 * the surface for each place.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm: no points on port 1; a point that is not
 * finite, or farther from the surface than ProjectionTolerance; no array of distances, or one
 * without one number per point.
 *
 * @code
 * vtkNew<vtkExactGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->GenerateWindowsOn();
 * vtkNew<vtkGeodesicProbe> probe;
 * probe->SetInputConnection(distance->GetOutputPort());
 * probe->SetProbeData(points);
 * probe->Update();
 * vtkDataArray* d = probe->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 *
 * <b>Source</b>. J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic
 * problem", SIAM J. Comput. 16, 1987, section 3.
 *
 * @sa vtkExactGeodesicDistance vtkDGGDistance vtkApolloniusIsolines
 */

#ifndef vtkGeodesicProbe_h
#define vtkGeodesicProbe_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the search for points
#include <string> // For array names

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicProbe : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicProbe* New();
  vtkTypeMacro(vtkGeodesicProbe, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The places: the points of a vtkPolyData on input port 1.
   */
  void SetProbeConnection(vtkAlgorithmOutput* output);
  void SetProbeData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances, unless SetInputArrayToProcess() names another one.
   * Default "GeodesicDistance"; empty: the active point scalars. An array without a name is
   * "GeodesicDistance" in the output.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the virtual sources, which may be missing. Default
   * "GeodesicVirtualSource".
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * Number of unreached points besides NaN and infinity, for distances from elsewhere; those of the
   * distance filters are recognised. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * How far from the surface a place may be, as a fraction of the diagonal of the surface's
   * bounding box; farther is an error. Default 0.01; not negative; 0 accepts points on the surface,
   * up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicProbe();
  ~vtkGeodesicProbe() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;

private:
  vtkGeodesicProbe(const vtkGeodesicProbe&) = delete;
  void operator=(const vtkGeodesicProbe&) = delete;

  std::string DistanceArrayName;
  std::string VirtualSourceArrayName;
  double UnreachedValue;
  double ProjectionTolerance;
};

#endif
