// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicProbe
 * @brief   a distance that is known at the points of a surface, at any other point of it
 *
 * Input port 0 takes a surface (vtkPolyData) with a point array of distances along it, as distance
 * filters give it: the one that SetInputArrayToProcess() names, where it has been called, else the
 * one of DistanceArrayName. Input port 1 takes a vtkPolyData whose points are the places that are
 * asked for, anywhere on the surface: each is projected to the closest point of it. The output is
 * the input of port 1, unchanged, plus a point array with the distances, of the name that they have
 * on the surface. NaN where the surface is not reached, be the distance NaN, infinity or the
 * UnreachedValue of the distance filter: in all triangles that have a corner that is not reached.
 *
 * How good the distances are depends on what the surface has besides them:
 *  - field data with windows (vtkExactGeodesicDistance::GenerateWindowsOn()): exact;
 *  - virtual sources (GenerateVirtualSourceOn() of any distance filter): several times better than
 *    linear interpolation, see dggDistanceField.h and below;
 *  - else virtual sources are fitted to the distances, which is a little worse. That the values
 *    are distances, in the units of the points, is the user's word: only those that are far too
 *    steep are linear in each triangle, with a warning, see vtkApolloniusIsolines.
 *
 * <b>Virtual sources on CAD models.</b> Long triangles may be reached from many sides, of which
 * their three corners know little: there errors are several times smaller than those of linear
 * interpolation in the mean, but may reach 18 % of the largest distance. Where that is not enough,
 * take windows.
 *
 * Arrays of either kind that do not belong to the distances or to the surface are ignored, with a
 * warning; for what is noticed of virtual sources, see vtkApolloniusIsolines.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm: no points on port 1; a point that is not
 * finite, or farther from the surface than ProjectionTolerance; no array of distances, or one that
 * does not have one number per point.
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
 * Exact distances inside of triangles: J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The
 * discrete geodesic problem", SIAM J. Comput. 16, 1987, section 3.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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
   * The places: points of a vtkPolyData on input port 1 (its cells are not used).
   */
  void SetProbeConnection(vtkAlgorithmOutput* output);
  void SetProbeData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Name of the point array with the distances, unless SetInputArrayToProcess() says another one.
   * Default "GeodesicDistance"; when empty, the active point scalars. Distances whose array has no
   * name are called "GeodesicDistance" in the output.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the virtual sources. Default "GeodesicVirtualSource". It need not
   * be there.
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * The number that stands for points that are not reached, besides NaN and infinity. Default NaN:
   * the points that the distance filter left unreached, whatever its UnreachedValue. To be set
   * where distances come from elsewhere.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * How far from the surface a point may be, as a fraction of the diagonal of the surface's
   * bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

protected:
  vtkGeodesicProbe();
  ~vtkGeodesicProbe() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;

private:
  vtkGeodesicProbe(const vtkGeodesicProbe&) = delete;
  void operator=(const vtkGeodesicProbe&) = delete;

  std::string DistanceArrayName;
  std::string VirtualSourceArrayName;
  double UnreachedValue;
  double ProjectionTolerance;
};

#endif
