// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGFastMarchingDistance
 * @brief   approximate distances along a surface by fast marching
 *
 * A front moves over the triangles and gives each point its time of arrival; obtuse triangles are
 * split by unfolding the faces beyond.
 *
 * <b>Input and output</b>. Those of vtkGeodesicDistanceAlgorithm.
 *
 * <b>Guarantee and cost</b>. Nothing bounds the error, which is large on long thin triangles
 * (QualityWarning); the page of the module has figures. Points become final one by one, in the
 * order of their distances; next to nothing is prepared, and memory is small.
 *
 * <b>Errors</b>. Those of vtkGeodesicDistanceAlgorithm.
 *
 * @code
 * vtkNew<vtkDGGFastMarchingDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update();
 * vtkDataArray* d = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
 * @endcode
 *
 * <b>Source</b>. R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", Proc. Natl.
 * Acad. Sci. 95, 1998; spherical updates: M. Novotni, R. Klein, "Computing geodesic distances on
 * triangular meshes", WSCG 2002.
 *
 * @sa vtkHeatGeodesicDistance vtkDGGDistance vtkExactGeodesicDistance
 */

#ifndef vtkDGGFastMarchingDistance_h
#define vtkDGGFastMarchingDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the unfolded triangles

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGFastMarchingDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkDGGFastMarchingDistance* New();
  vtkTypeMacro(vtkDGGFastMarchingDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Shapes of the front between two points that it has passed.
   */
  enum FrontShapeType
  {
    Spherical = 0, ///< around a point: exact in the plane
    Planar = 1     ///< straight, as in the original method
  };

  ///@{
  /**
   * The shape of the front in the update of a point. Default Spherical; Planar is there to compare
   * with.
   */
  vtkSetClampMacro(FrontShape, int, Spherical, Planar);
  vtkGetMacro(FrontShape, int);
  void SetFrontShapeToSpherical() { this->SetFrontShape(Spherical); }
  void SetFrontShapeToPlanar() { this->SetFrontShape(Planar); }
  const char* GetFrontShapeAsString() const;
  ///@}

  /**
   * Whether the median anisotropy of the last update's mesh (GetMedianAnisotropy()) is above 3:
   * then distances may be far off. A warning says so once for each mesh.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkDGGFastMarchingDistance();
  ~vtkDGGFastMarchingDistance() override;

  dgg::Status ComputeDistances(DGGDistanceTask& task) override;

private:
  vtkDGGFastMarchingDistance(const vtkDGGFastMarchingDistance&) = delete;
  void operator=(const vtkDGGFastMarchingDistance&) = delete;

  struct Preparation;

  int FrontShape;
  bool QualityWarning;
  std::unique_ptr<Preparation> Prepared;
};

#endif
