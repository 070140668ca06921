// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualSourceGeodesicDistance
 * @brief   approximate distances along a surface, without precomputation
 *
 * Sources are unfolded from triangle to triangle, one virtual source for each. For what has to
 * follow the mouse, for previews, and for a first look at large meshes.
 *
 * <b>Input and output</b>. Those of vtkGeodesicDistanceAlgorithm.
 *
 * <b>Guarantee and cost</b>. No distance is longer than the shortest way along mesh edges, up to
 * rounding, for any number of sources. Nothing else bounds the error. Of 10 sources on each of 27
 * real meshes: on scans and fine parts 0.1 to 0.4 % on the mean, single distances up to 4 % too
 * short, where a ridge hides what lies behind, and up to 13 % too long. On coarse or broken CAD
 * models the mean error is 0.6 to 6 %, and single distances are up to 55 % too short or 60 % too
 * long, or several times too long on rough sides (see QualityWarning); there
 * vtkExactGeodesicDistance is fast enough. Triangles may be so irregular that distances do not
 * settle: the search then ends with the shortest ones found so far, and a warning. With a thousand
 * sources the mean error is smaller. With about as many sources as triangles, or on long triangles,
 * single distances may be several times too long and the mean error is 3 %, because a triangle
 * stores one source only. Five million points take a second on one thread, and less on several;
 * several sources take a third longer. Results have single precision: about six digits of the
 * largest distance, initial distances included. Along strips of ten thousand triangles, rounding
 * errors add up to 1e-4 of that distance.
 *
 * <b>Errors</b>. Those of vtkGeodesicDistanceAlgorithm; initial distances that differ by more than
 * 1e30 mean edges.
 *
 * @code
 * vtkNew<vtkVirtualSourceGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update();
 * vtkDataArray* d = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 *
 * <b>Source</b>. P. Trettner, D. Bommes, L. Kobbelt, "Geodesic distance computation via virtual
 * source propagation", Computer Graphics Forum 40(5), 2021. Rounds, ties and shadows are our own:
 * see the page of the module.
 *
 * @sa vtkDGGDistance vtkExactGeodesicDistance vtkDGGFastMarchingDistance
 */

#ifndef vtkVirtualSourceGeodesicDistance_h
#define vtkVirtualSourceGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the prepared triangles

class DGGPropagation;

class VTKDGGFILTERSGEODESIC_EXPORT vtkVirtualSourceGeodesicDistance
  : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkVirtualSourceGeodesicDistance* New();
  vtkTypeMacro(vtkVirtualSourceGeodesicDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What has a virtual source of its own.
   */
  enum QualityType
  {
    Automatic = 0, ///< High if GetMeanAnisotropy() is above 2, else Fast
    Fast = 1,      ///< each triangle
    High = 2       ///< each edge: more accurate, in some 1.6 times the time
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
   * True if distances of the last update may be far off: GetMeanAnisotropy() is above 2, or they
   * did not settle. Also true on flat grids of long cells, where distances are good. A warning is
   * reported once for each mesh and reason.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkVirtualSourceGeodesicDistance();
  ~vtkVirtualSourceGeodesicDistance() override;

  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkVirtualSourceGeodesicDistance(const vtkVirtualSourceGeodesicDistance&) = delete;
  void operator=(const vtkVirtualSourceGeodesicDistance&) = delete;

  int Quality;
  bool QualityWarning;
  std::unique_ptr<DGGPropagation> Propagation;
};

#endif
