// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGFastMarchingDistance
 * @brief   approximate distances along a surface or a point cloud by fast marching
 *
 * A front moves over the triangles and gives each point its time of arrival; obtuse triangles are
 * split by unfolding the faces beyond. On points without polygons and strips, a point cloud, the
 * front moves through a band of voxels around the points. No graph is used.
 *
 * <b>Input and output</b>. Same as for vtkGeodesicDistanceAlgorithm. On clouds, source points may
 * be beside the cloud (see Filters/PointCloud/README.md); outside the band they start at the
 * closest point, with the distance to that point. Parts that the band does not connect to a source
 * are unreached, as are outliers (see Filters/PointCloud/README.md) and points that are not finite,
 * unless they are sources. Copies of a point have one distance.
 *
 * <b>Guarantee and cost</b>. Errors have no bound; the module page, Filters/Geodesic/Distances.md,
 * has figures and the behavior on thin parts and close layers. Preparation and memory are small on
 * meshes. On clouds the band is kept until points, BandRadius or Resolution change; a query takes
 * 17 bytes per voxel of the blocks of 8 x 8 x 8 voxels that the band touches.
 *
 * <b>Errors</b>. All errors of vtkGeodesicDistanceAlgorithm. On clouds also GenerateVirtualSource;
 * parts farther apart than 2^23 automatic voxels or 2^30 spacings; a band and a query beyond
 * MemoryLimit, or more than 2^31 voxels in the blocks of the band.
 *
 * <b>Source</b>. R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", Proc. Natl.
 * Acad. Sci. 95, 1998; spherical fronts: M. Novotni, R. Klein, "Computing geodesic distances on
 * triangular meshes", WSCG 2002. Clouds: F. Memoli, G. Sapiro, "Fast computation of weighted
 * distance functions and geodesics on implicit hyper-surfaces", J. Comput. Phys. 173, 2001;
 * first-order upwind differences, straight distances within two voxels of a source on its layer.
 * @sa vtkHeatGeodesicDistance vtkDGGDistance vtkExactGeodesicDistance
 */

#ifndef vtkDGGFastMarchingDistance_h
#define vtkDGGFastMarchingDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

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
   * Shape of the front in the update of a point. Default Spherical; Planar is for comparison.
   */
  vtkSetClampMacro(FrontShape, int, Spherical, Planar);
  vtkGetMacro(FrontShape, int);
  void SetFrontShapeToSpherical() { this->SetFrontShape(Spherical); }
  void SetFrontShapeToPlanar() { this->SetFrontShape(Planar); }
  const char* GetFrontShapeAsString() const;
  ///@}

  ///@{
  /**
   * Radius of the balls around the points of a cloud whose union is the band, in voxels. Default 0:
   * automatic, follows the spacing around each point. Other values outside [0.5, 1000] are errors.
   */
  vtkSetMacro(BandRadius, double);
  vtkGetMacro(BandRadius, double);
  ///@}

  ///@{
  /**
   * Number of voxels along the longest side of the bounding box of a cloud without outliers.
   * Default 0: automatic, two voxels per spacing, fewer where the spacing varies. Values outside
   * [0, 524288] are errors.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Median radius of the balls, in voxels, and resolution of the last update; 0 for meshes.
   */
  double GetUsedBandRadius() const;
  int GetUsedResolution() const;
  ///@}

  /**
   * True if distances of the last update may be far off because GetMeanAnisotropy() is above 2.
   * Also true on flat grids of long cells, where distances are accurate. A warning is reported once
   * for each mesh.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkDGGFastMarchingDistance();
  ~vtkDGGFastMarchingDistance() override = default;

private:
  vtkDGGFastMarchingDistance(const vtkDGGFastMarchingDistance&) = delete;
  void operator=(const vtkDGGFastMarchingDistance&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int FrontShape = Spherical;
  double BandRadius = 0.0;
  int Resolution = 0;
  bool QualityWarning = false;
};

#endif
