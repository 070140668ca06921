// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGFastMarchingDistance
 * @brief   approximate distances along a surface by fast marching
 *
 * A front moves over the triangles and gives each point the time at which it arrives; obtuse
 * triangles are split by unfolding the faces beyond. Nothing is prepared and the memory is small,
 * but nothing bounds the error: with Spherical updates 0.1 to 0.6 % on average and some per cent
 * at most is usual on scans of 10 000 points and more, 0.5 to 2 % and up to 30 % on the same
 * surfaces with 1000 points, with Planar updates three to eight times as much. For distances within
 * a known error see vtkDGGDistance, for exact ones vtkExactGeodesicDistance, which often is not
 * much slower.
 *
 * <b>Not for long thin triangles.</b> Where they are obtuse, no unfolding is far enough: single
 * distances, between points that are close to each other, may be several times too long. Have such
 * a surface remeshed, or take vtkExactGeodesicDistance or vtkDGGDistance. Errors relative to exact
 * distances with Spherical updates, of all points from 10 of them, in percent; tau is the median
 * anisotropy (GetMedianAnisotropy()):
 *
 * | surface                            | points | tau  | mean | 99.9 % | largest |
 * |------------------------------------|-------:|-----:|-----:|-------:|--------:|
 * | scan (bunny)                       | 34 835 | 1.42 | 0.26 |    1.6 |     4.8 |
 * | scan (gargoyle)                    | 24 992 | 1.51 | 0.54 |    1.9 |     6.5 |
 * | part, even triangles (fandisk)     |   6475 | 1.39 | 0.19 |    2.1 |     3.3 |
 * | part, long triangles (TR12J_cad)   | 13 441 | 1.91 | 0.72 |    3.1 |      28 |
 * | fine long triangles (blade_aniso)  |   8231 | 6.10 | 0.00 |    0.4 |     3.5 |
 * | part, none inside (psu_cover)      |   1351 | 4.65 |  4.2 |     30 |      42 |
 * | part, none inside (z_bar_clamp)    |    338 | 6.19 |  2.1 |     19 |     107 |
 *
 * Above a tau of 3 there is a QualityWarning; a mesh may be good all the same, as the fifth of
 * these.
 *
 * Inputs, sources, results and errors are those of vtkGeodesicDistanceAlgorithm. Initial distances
 * are honoured.
 *
 * R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", Proc. Natl. Acad. Sci. 95,
 * 1998. Spherical updates are those of M. Novotni, R. Klein, "Computing geodesic distances on
 * triangular meshes", WSCG 2002.
 *
 * @sa vtkGeodesicDistanceAlgorithm vtkHeatGeodesicDistance vtkDGGDistance
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
   * Whether most triangles of the last update's mesh are long, with a median of the anisotropy (see
   * GetMedianAnisotropy()) above 3: then distances may be far off, see above. A warning says so
   * once for each mesh.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkDGGFastMarchingDistance();
  ~vtkDGGFastMarchingDistance() override;

  dgg::Status ComputeDistances(vtkDGGDistanceTask& task) override;

private:
  vtkDGGFastMarchingDistance(const vtkDGGFastMarchingDistance&) = delete;
  void operator=(const vtkDGGFastMarchingDistance&) = delete;

  struct Preparation;

  int FrontShape;
  bool QualityWarning;
  std::unique_ptr<Preparation> Prepared;
};

#endif
