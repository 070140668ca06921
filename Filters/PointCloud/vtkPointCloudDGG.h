// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointCloudDGG
 * @brief   builds a graph of a point cloud in which shortest paths approximate geodesics
 *
 * Points within reach are connected if the straight line between them stays in a band around the
 * cloud. vtkDGGDistance, vtkDGGPath, vtkGeodesicSampler, vtkGeodesicVoronoi and
 * vtkGeodesicDistanceMatrix search the graph. Defaults follow from the sampling.
 *
 * <b>Input and output</b>. Port 0 takes the points of a vtkPolyData and, with UseInputNormals,
 * their normals; cells are not used. The output is the input plus the point array `Component` (int;
 * 0 is the largest component, -1 for points that are not finite), `Normals` (EstimateNormals), and
 * the graph in the field data, with n points and m directed edges, each edge in both directions:
 *  - `DGG.Offsets` (int64, n + 1): edges of point i are [Offsets[i], Offsets[i + 1]);
 *  - `DGG.Targets` (int32, m): point at the end of each edge, ascending within each row;
 *  - `DGG.Lengths` (float32, m): length in units of the coordinates; float64 for 0 < Accuracy <
 *    1e-5 and for extents beyond the range of floats;
 *  - `DGG.Radii` (float64, n): radius of the ball around each point, units of the coordinates; 0 at
 *    outliers and at points that are not finite;
 *  - `DGG.Info` (int64, 12): parameters, signature of the points, checksum.
 *
 * <b>Guarantee and cost</b>. Distances have no error bound; errors depend on the sampling. The
 * graph is bitwise identical for any number of threads, and kept until points, normals in use or
 * parameters change; any motion of the points invalidates it. Points that are not finite and
 * outliers are kept with a warning; copies of a point are joined by edges of near-zero length.
 * If all threads together would exceed MemoryLimit, fewer threads build the graph.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm and of the module page,
 * Filters/PointCloud/README.md, such as a graph and band beyond MemoryLimit.
 *
 * <b>Source</b>. Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University,
 * 2019, chapter 5, for the band and schemes A and B; see the page for the differences.
 * @sa vtkDGGDistance vtkDGGPath vtkDiscreteGeodesicGraph
 */

#ifndef vtkPointCloudDGG_h
#define vtkPointCloudDGG_h

#include "vtkDGGFiltersPointCloudModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <string> // For array names

class VTKDGGFILTERSPOINTCLOUD_EXPORT vtkPointCloudDGG : public vtkGeodesicAlgorithm
{
public:
  static vtkPointCloudDGG* New();
  vtkTypeMacro(vtkPointCloudDGG, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Reach of the edges of a point. The spacing is the square root of the area per point. A and B
   * follow Fang's thesis with other defaults: see the module page.
   */
  enum SchemeType
  {
    A = 0, ///< shorter where the surface bends
    B = 1, ///< the same everywhere
    C = 2  ///< proportional to the local spacing
  };

  ///@{
  /**
   * Scheme of the reach. Default C.
   */
  vtkSetClampMacro(Scheme, int, A, C);
  vtkGetMacro(Scheme, int);
  void SetSchemeToA() { this->SetScheme(A); }
  void SetSchemeToB() { this->SetScheme(B); }
  void SetSchemeToC() { this->SetScheme(C); }
  const char* GetSchemeAsString() const;
  ///@}

  ///@{
  /**
   * Radius of the balls whose union is the band, in voxels. Default 0: automatic, follows the
   * spacing around each point. Other values outside [0.5, 1000] are errors.
   */
  vtkSetMacro(OffsetInVoxels, double);
  vtkGetMacro(OffsetInVoxels, double);
  ///@}

  ///@{
  /**
   * Number of voxels along the longest side of the bounding box of the points without outliers.
   * Default 0: automatic. Values outside [0, 524288] are errors; voxels larger than the median
   * spacing cause a warning.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Parameter of the reach. Scheme A: divisor of the mean length of direct connections; B: voxels
   * added to OffsetInVoxels; C: spacings. Default 0: automatic. Other values outside [1e-3, 1e6]
   * are errors.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * Largest relative increase of distances by pruning edges. Default 0.001; 0 keeps all edges.
   * Other values outside [1e-6, 0.5] are errors.
   */
  vtkSetMacro(Accuracy, double);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * If on, lengths of edges are lengths of arcs that fit the normals; if off, of straight
   * lines, which are too short. Default on.
   */
  vtkSetMacro(ArcLengthWeights, bool);
  vtkGetMacro(ArcLengthWeights, bool);
  vtkBooleanMacro(ArcLengthWeights, bool);
  ///@}

  ///@{
  /**
   * If on, point normals of the input are used. If off, or where normals are 0 or not finite,
   * normals are estimated from the points. Turn off for coarse normals, such as normals of flat
   * facets. Default on.
   */
  vtkSetMacro(UseInputNormals, bool);
  vtkGetMacro(UseInputNormals, bool);
  vtkBooleanMacro(UseInputNormals, bool);
  ///@}

  ///@{
  /**
   * If on, normals of the input all point to the same side: points whose normals differ by more
   * than 100 degrees are not connected, which separates layers back to back. Without such normals
   * it has no effect, with a warning. Default off.
   */
  vtkSetMacro(OrientedNormals, bool);
  vtkGetMacro(OrientedNormals, bool);
  vtkBooleanMacro(OrientedNormals, bool);
  ///@}

  ///@{
  /**
   * If on and no normals of the input are used, add point normals `Normals` (double, length 1,
   * arbitrary side; 0 where points have no plane) from planes through NumberOfNeighbors points, and
   * use them for the graph. Default off: normals come from surfaces of second order.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Number of points that a plane is fitted to, including the point itself. Default 16; at least 3.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * If on, an output without cells gets one vertex cell with all points, which makes them visible
   * and takes 8 bytes per point, as in vtkPointCloudFilter. Default off: cells are passed from the
   * input.
   */
  vtkSetMacro(GenerateVertices, bool);
  vtkGetMacro(GenerateVertices, bool);
  vtkBooleanMacro(GenerateVertices, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the components. Default "Component"; not empty.
   */
  vtkDGGStringMacro(ComponentArrayName);
  ///@}

  /**
   * Predicts the memory of the graph from the edges of some points, after an update of the input.
   * Returns GetEstimatedMemory(); 0 after an error, an abort or, with a warning, for an empty
   * input. Only an error changes GetErrorCode(). With several processes the prediction is for
   * the local piece; all processes must call the function.
   */
  vtkTypeUInt64 EstimateMemory();

  ///@{
  /**
   * Returns the last prediction in bytes: size of the graph, and largest memory during the build. 0
   * without a prediction.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Releases the graph that is kept between updates, see vtkDiscreteGeodesicGraph.
   */
  void ReleaseGraph();

  ///@{
  /**
   * Values of the graph of the last update: number of directed edges, mean number of edges per
   * point, bytes of the arrays; zero without a graph.
   */
  vtkIdType GetNumberOfGraphEdges() const;
  double GetMeanDegree() const;
  vtkTypeUInt64 GetMemorySize() const;
  ///@}

  ///@{
  /**
   * Components of the graph of the last update, in order of decreasing size, and their numbers of
   * points.
   */
  vtkIdType GetNumberOfComponents() const;
  vtkIdType GetComponentSize(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOfComponents());
  ///@}

  ///@{
  /**
   * Numbers of points of the last update that are not finite, that are outliers, and that are at
   * the position of an earlier point.
   */
  vtkIdType GetNumberOfUnusedPoints() const;
  vtkIdType GetNumberOfOutliers() const;
  vtkIdType GetNumberOfCoincidentPoints() const;
  ///@}

  ///@{
  /**
   * Parameters of the last update, given or automatic; 0 without a graph. The offset is the median
   * radius of the balls, in voxels and in units of the coordinates.
   */
  double GetUsedOffsetInVoxels() const;
  double GetUsedOffset() const;
  int GetUsedResolution() const;
  double GetUsedAlpha() const;
  ///@}

  /**
   * Returns the size of the voxels in the last update, in units of the coordinates.
   */
  double GetVoxelSize() const;

  ///@{
  /**
   * Estimates of the last update, in units of the coordinates: medians of the spacing, of the
   * distance of points from a surface through their neighbors, and of the reach of edges.
   */
  double GetSpacing() const;
  double GetNoise() const;
  double GetReach() const;
  ///@}

  /**
   * Returns the share of points, in [0, 1], whose neighbors lie on no surface even if noise is
   * considered: a fit misses them by more than a quarter of their radius. Above 0.1 there is a
   * warning.
   */
  double GetOffSurfaceShare() const;

  /**
   * Returns the removed noise (GetNoise()) divided by the median radius of curvature; 0 without
   * noise. Distances on a sphere are too short by about twice its square. Above 0.07 there is a
   * warning.
   */
  double GetNoiseByRadius() const;

  /**
   * Returns the typical distance of points from a surface, in spacings, if GetOffSurfaceShare() is
   * above 0.1; otherwise 0.
   */
  double GetScatter() const;

  /**
   * Returns the time stamp of the last build of a graph.
   */
  vtkMTimeType GetGraphBuildTime() const;

protected:
  vtkPointCloudDGG();
  ~vtkPointCloudDGG() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPointCloudDGG(const vtkPointCloudDGG&) = delete;
  void operator=(const vtkPointCloudDGG&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int Scheme = C;
  double OffsetInVoxels = 0.0;
  int Resolution = 0;
  double Alpha = 0.0;
  double Accuracy;
  bool ArcLengthWeights = true;
  bool UseInputNormals = true;
  bool OrientedNormals = false;
  bool EstimateNormals = false;
  bool GenerateVertices = false;
  int NumberOfNeighbors = 16;
  std::string ComponentArrayName = "Component";
};

#endif
