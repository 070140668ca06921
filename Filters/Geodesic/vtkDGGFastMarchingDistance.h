// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGFastMarchingDistance
 * @brief   approximate distances along a surface by fast marching
 *
 * A front moves over the triangles and gives each point its time of arrival; obtuse triangles are
 * split by unfolding the faces beyond. Without triangles it moves through a band of voxels around
 * the points.
 *
 * <b>Input and output</b>. Those of vtkGeodesicDistanceAlgorithm. An input with points, but neither
 * polygons nor strips, is a point cloud; no graph is needed, and one that is there is not used. The
 * band is the union of balls around the points (BandRadius, Resolution). Source points may lie
 * beside the cloud, as in vtkGeodesicAlgorithm; those outside of the band start at the closest
 * point, with the distance to that. Parts that the band does not connect are unreached. So are,
 * but for sources at them, outliers (as in vtkPointCloudDGG) and points that are not finite. Copies
 * of a point have one distance.
 *
 * <b>Guarantee and cost</b>. Nothing bounds the error, which is large on long thin triangles
 * (QualityWarning); the page of the module has figures. Points become final one by one, in the
 * order of their distances; next to nothing is prepared, and memory is small.
 *
 * On clouds the mean error is usually 1 to 3 %, and that of single points up to 10 %, at any
 * density: the band makes short cuts where the surface bends, and differences of first order add
 * to lengths. Beside holes, on thin parts and in sharp folds distances may be far too small.
 * Distances in a graph of vtkPointCloudDGG are 10 to 100 times as accurate. The band is made once,
 * and kept until points, BandRadius or Resolution change; a march takes 17 bytes for each voxel of
 * the blocks of 8 x 8 x 8 that the band touches. Sheets closer than two radii and two voxels, with
 * defaults about six spacings of points, are connected, without a warning; those of different
 * blocks of the input too.
 *
 * <b>Errors</b>. Those of vtkGeodesicDistanceAlgorithm, and on clouds
 *  - a BandRadius not in [0.5, 1000], unless 0; a Resolution not in [0, 524288];
 *  - GenerateVirtualSource: a virtual source is a direction on a surface;
 *  - parts farther apart than 2^23 automatic voxels, or 2^30 spacings, reach;
 *  - a band and a march on it that take more than MemoryLimit; more than 2^31 voxels in the blocks
 *    of the band.
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
 * triangular meshes", WSCG 2002. On clouds: F. Memoli, G. Sapiro, "Fast computation of weighted
 * distance functions and geodesics on implicit hyper-surfaces", J. Comput. Phys. 173, 2001, by
 * first-order upwind differences, with straight distances within two voxels of a source on its
 * sheet.
 *
 * @sa vtkHeatGeodesicDistance vtkDGGDistance vtkExactGeodesicDistance
 */

#ifndef vtkDGGFastMarchingDistance_h
#define vtkDGGFastMarchingDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the unfolded triangles
#include <string> // For messages

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

  ///@{
  /**
   * Of clouds: radius of the balls that make the band, in voxels, in [0.5, 1000]. Default 0,
   * automatic: it follows the spacing around each point.
   */
  vtkSetMacro(BandRadius, double);
  vtkGetMacro(BandRadius, double);
  ///@}

  ///@{
  /**
   * Of clouds: voxels along the longest side of the bounding box of the points, outliers left out;
   * at most 524288. Default 0, automatic: two voxels to the spacing, or somewhat fewer where that
   * varies.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Median radius of the balls, and the resolution, of the last update's cloud; 0 of a mesh.
   */
  double GetUsedBandRadius() const;
  int GetUsedResolution() const;
  ///@}

  /**
   * True if GetMeanAnisotropy() of the mesh of the last update is above 2: distances may be far
   * off. Also true on flat grids of long cells, where distances are good. A warning is reported
   * once for each mesh.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkDGGFastMarchingDistance();
  ~vtkDGGFastMarchingDistance() override;

  dgg::Status CheckProperties() const override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;

private:
  vtkDGGFastMarchingDistance(const vtkDGGFastMarchingDistance&) = delete;
  void operator=(const vtkDGGFastMarchingDistance&) = delete;

  struct Preparation;

  dgg::Status MarchOnMesh(DGGDistanceTask& task);
  dgg::Status MarchOnCloud(DGGDistanceTask& task);

  int FrontShape;
  double BandRadius;
  int Resolution;
  bool QualityWarning;
  std::unique_ptr<Preparation> Prepared;
};

#endif
