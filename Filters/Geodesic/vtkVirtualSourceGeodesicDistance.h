// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualSourceGeodesicDistance
 * @brief   approximate distances along a surface, without preparation
 *
 * Sources are unfolded from triangle to triangle; each triangle keeps one virtual source, each edge
 * with Quality High. For interaction, previews and large meshes.
 *
 * <b>Input and output</b>. Same as for vtkGeodesicDistanceAlgorithm.
 *
 * <b>Guarantee and cost</b>. Up to rounding, no distance is longer than the shortest path along
 * mesh edges, for any number of sources. With at most eight sources none is shorter than the
 * straight line in space. Errors have no other bound. Measured with 10 sources on
 * each of 27 real meshes and 68 generated machine parts: on scans, 0.1 to 0.4 % on average, single
 * distances up to 4 % too short and 15 % too long; on CAD models, up to 5 % on average, single
 * distances up to 13 % too short and 130 % too long (QualityWarning). If distances do not
 * converge, the filter warns and keeps the shortest distances found. Five million points take about
 * a second on one thread. Results have single precision: six digits of the largest distance,
 * including initial distances; along strips of ten thousand triangles, rounding errors add up to
 * 1e-4 of it.
 *
 * <b>Errors</b>. All errors of vtkGeodesicDistanceAlgorithm; initial distances that differ by more
 * than 1e30 mean edge lengths. The module page is Filters/Geodesic/Distances.md.
 * @code
 * vtkNew<vtkVirtualSourceGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update();
 * vtkDataArray* d = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 * <b>Source</b>. P. Trettner, D. Bommes, L. Kobbelt, "Geodesic distance computation via virtual
 * source propagation", Computer Graphics Forum 40(5), 2021; rounds, ties and shadows differ.
 *
 * @sa vtkDGGDistance vtkExactGeodesicDistance vtkDGGFastMarchingDistance
 */

#ifndef vtkVirtualSourceGeodesicDistance_h
#define vtkVirtualSourceGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

class VTKDGGFILTERSGEODESIC_EXPORT vtkVirtualSourceGeodesicDistance
  : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkVirtualSourceGeodesicDistance* New();
  vtkTypeMacro(vtkVirtualSourceGeodesicDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Elements with a virtual source of their own.
   */
  enum QualityType
  {
    Automatic = 0, ///< High if GetMeanAnisotropy() is above 2, else Fast
    Fast = 1,      ///< each triangle
    High = 2       ///< each edge: more accurate, takes about 1.6 times as long
  };

  ///@{
  /**
   * Quality of the distances. Default Automatic.
   */
  vtkSetClampMacro(Quality, int, Automatic, High);
  vtkGetMacro(Quality, int);
  void SetQualityToAutomatic() { this->SetQuality(Automatic); }
  void SetQualityToFast() { this->SetQuality(Fast); }
  void SetQualityToHigh() { this->SetQuality(High); }
  const char* GetQualityAsString() const;
  ///@}

  /**
   * True if distances of the last update may be far off: GetMeanAnisotropy() is above 2, or
   * distances did not converge. Also true on flat grids of long cells, where distances are
   * accurate. A warning is reported once for each mesh and reason.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkVirtualSourceGeodesicDistance();
  ~vtkVirtualSourceGeodesicDistance() override = default;

private:
  vtkVirtualSourceGeodesicDistance(const vtkVirtualSourceGeodesicDistance&) = delete;
  void operator=(const vtkVirtualSourceGeodesicDistance&) = delete;

  class vtkInternals;

  int Quality = Automatic;
  bool QualityWarning = false;
};

#endif
