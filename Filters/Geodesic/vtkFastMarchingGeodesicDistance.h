// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFastMarchingGeodesicDistance
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
 * <b>Not for long thin triangles.</b> Where they are obtuse, no unfolding is far enough. On flat
 * sheets of triangles that are 5 to 100 times as long as wide, and lean, mean errors were 2 to 8 %
 * with Spherical updates and 8 to 13 % with Planar ones, and single distances, between points that
 * are close to each other, several times too long. Have such a surface remeshed, or take
 * vtkExactGeodesicDistance or vtkDGGDistance.
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

#ifndef vtkFastMarchingGeodesicDistance_h
#define vtkFastMarchingGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the unfolded triangles

class VTKDGGFILTERSGEODESIC_EXPORT vtkFastMarchingGeodesicDistance
  : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkFastMarchingGeodesicDistance* New();
  vtkTypeMacro(vtkFastMarchingGeodesicDistance, vtkGeodesicDistanceAlgorithm);
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

protected:
  vtkFastMarchingGeodesicDistance();
  ~vtkFastMarchingGeodesicDistance() override;

  dgg::Status ComputeDistances(vtkDGGDistanceTask& task) override;

private:
  vtkFastMarchingGeodesicDistance(const vtkFastMarchingGeodesicDistance&) = delete;
  void operator=(const vtkFastMarchingGeodesicDistance&) = delete;

  struct Preparation;

  int FrontShape;
  std::unique_ptr<Preparation> Prepared;
};

#endif
