// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicProbe
 * @brief   evaluates distances, given at the points of a surface, at any other surface points
 *
 * <b>Input and output</b>. Port 0 takes a surface with a point array of distances, set by
 * SetInputArrayToProcess() or otherwise DistanceArrayName; port 1 a vtkPolyData whose points are
 * projected to the surface. The output is the input of port 1 plus a point array of the name of the
 * distances (double), NaN in triangles with an unreached corner. Windows and virtual sources that
 * do not belong to the distances are ignored, with a warning.
 *
 * <b>Guarantee and cost</b>. Exact with windows (vtkExactGeodesicDistance::GenerateWindowsOn(), and
 * vtkDGGDistance on large triangles). With virtual sources (GenerateVirtualSourceOn() of any
 * distance filter), or those fitted to the distances, without a bound: more accurate than linear
 * interpolation if sources are many edges apart, and less accurate between sources a few edges
 * apart. In long triangles, as in CAD models, errors may be as large as the largest distance. A
 * warning recommends windows if GetMeanAnisotropy() is above 2. There is one search in the surface
 * per point.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; no points on port 1; a point that is not
 * finite or beyond ProjectionTolerance; no array of distances with one number per point. The module
 * page is Filters/Geodesic/Distances.md.
 * @code
 * distance->GenerateWindowsOn(); // a vtkExactGeodesicDistance
 * vtkNew<vtkGeodesicProbe> probe;
 * probe->SetInputConnection(distance->GetOutputPort());
 * probe->SetProbeData(points);
 * probe->Update();
 * vtkDataArray* d = probe->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 * <b>Source</b>. J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic
 * problem", SIAM J. Comput. 16, 1987, section 3.
 *
 * @sa vtkExactGeodesicDistance vtkDGGDistance vtkApolloniusIsolines
 */

#ifndef vtkGeodesicProbe_h
#define vtkGeodesicProbe_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <limits> // For UnreachedValue
#include <string> // For array names

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicProbe : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicProbe* New();
  vtkTypeMacro(vtkGeodesicProbe, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points to evaluate: the points of a vtkPolyData on input port 1.
   */
  void SetProbeConnection(vtkAlgorithmOutput* output);
  void SetProbeData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances, unless SetInputArrayToProcess() names another.
   * Default "GeodesicDistance"; empty: the active point scalars. An array without a name is
   * "GeodesicDistance" in the output.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with virtual sources, which is optional. Default
   * "GeodesicVirtualSource".
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * Value of unreached points in addition to NaN and infinity, for distances of other origin;
   * values of the distance filters are recognized. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
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

protected:
  vtkGeodesicProbe();
  ~vtkGeodesicProbe() override = default;

private:
  vtkGeodesicProbe(const vtkGeodesicProbe&) = delete;
  void operator=(const vtkGeodesicProbe&) = delete;

  class vtkInternals;

  std::string DistanceArrayName = "GeodesicDistance";
  std::string VirtualSourceArrayName = "GeodesicVirtualSource";
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  double ProjectionTolerance = 0.01;
};

#endif
