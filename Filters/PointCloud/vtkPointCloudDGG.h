// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointCloudDGG
 * @brief   builds a graph of a point cloud in which shortest paths are geodesics of what it samples
 *
 * Two points are connected when the straight line between them stays in a band around the cloud,
 * and they are within the reach of either of them. vtkDGGDistance, vtkDGGPath, vtkGeodesicSampler,
 * vtkGeodesicVoronoi and vtkGeodesicDistanceMatrix search the graph. All parameters have automatic
 * defaults that follow from the sampling; GetUsedOffsetInVoxels() and others report what was used.
 *
 * <b>Input and output</b>. Port 0 takes the cloud (vtkPolyData): its points and, with
 * UseInputNormals, their normals; cells are not used. The output is the input plus the point array
 * `Component` (int): the connected part of each point, from the largest on, -1 where a point is not
 * finite; with EstimateNormals the point array `Normals` (double); and the graph in the field data.
 * n is the number of points, m that of directed edges; each edge is there both ways, with one
 * length.
 *
 *  - `DGG.Offsets` (int64, n + 1): edges of point i: [Offsets[i], Offsets[i + 1]);
 *  - `DGG.Targets` (int32, m): point at the end of each edge, sorted within each row;
 *  - `DGG.Lengths` (float32, m): length; float64 for 0 < Accuracy < 1e-5;
 *  - `DGG.Radii` (float64, n): radius of the ball around each point, 0 if not finite or an outlier;
 *  - `DGG.Info` (int64, 12): see below.
 *
 * Lengths are in units of the coordinates, and float64 too for extents out of the range of floats.
 * `DGG.Info` is as in vtkDiscreteGeodesicGraph: the format version (1); the kind (1: cloud); 4 +
 * Scheme; the bits of Accuracy; 0; 0; a signature of the points (2 values); the bits of the size of
 * voxels; 0; 0; a checksum. Any change of points, a rigid motion included, invalidates the graph.
 *
 * Points that are not finite, and outliers, are kept with a warning that counts
 * them. Outliers, each more than 1000 times as far from the cloud's middle as any other point and
 * in fewer than 17 places, are components of their own that do not change the graph of the others.
 * Copies of a point are joined by edges of near-zero length.
 *
 * <b>Guarantee and cost</b>. Nothing is promised: errors depend on the sampling. The page of the
 * module says what happens at noise, close sheets, gaps and uneven density. The graph is the same
 * for any number of threads, and kept until points, normals that are used or parameters change.
 * Warnings come when it is built; getters report their cause after every update.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - an OffsetInVoxels not in [0.5, 1000], an Alpha not in [1e-3, 1e6] or an Accuracy not in [1e-6,
 *    0.5], unless 0; a Resolution not in [0, 524288]; a NumberOfNeighbors below 3; an empty array
 *    name;
 *  - normals of another number of components or tuples;
 *  - parts farther apart than 2^23 automatic voxels, or 2^30 spacings, reach;
 *  - a graph and its band that take more than MemoryLimit on a single thread: fewer threads build
 *    where all of them would. The process grows by somewhat more, as the allocator rounds up.
 *
 * @code
 * vtkNew<vtkPointCloudDGG> graph;
 * graph->SetInputConnection(reader->GetOutputPort());
 * vtkNew<vtkDGGDistance> distance;
 * distance->SetInputConnection(graph->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update(); // builds the graph
 * distance->SetSourceIds({ 100 });
 * distance->Update(); // milliseconds
 * @endcode
 *
 * <b>Source</b>. Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University,
 * 2019, chapter 5, for the band and schemes A and B. Their defaults are our own, so that errors are
 * not those printed there: automatic Alpha is 1 for A, with at least six direct neighbours, where
 * the thesis uses 2.5 to 4.2; for B it makes a reach of six spacings; balls follow the spacing, not
 * a fixed number of voxels; lengths are those of arcs (ArcLengthWeights); edges are pruned
 * (Accuracy).
 *
 * @sa vtkDGGDistance vtkDGGPath vtkDiscreteGeodesicGraph
 */

#ifndef vtkPointCloudDGG_h
#define vtkPointCloudDGG_h

#include "vtkDGGFiltersPointCloudModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <string> // For array names
#include <vector> // For normals

namespace dgg
{
struct CloudGraphOptions;
}

class VTKDGGFILTERSPOINTCLOUD_EXPORT vtkPointCloudDGG : public vtkGeodesicAlgorithm
{
public:
  static vtkPointCloudDGG* New();
  vtkTypeMacro(vtkPointCloudDGG, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Reach of the edges of a point. The spacing is the root of the area that a point has.
   */
  enum SchemeType
  {
    A = 0, ///< less far where the surface bends
    B = 1, ///< equally far everywhere
    C = 2  ///< by the spacing of the points
  };

  ///@{
  /**
   * The scheme. Default C.
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
   * Radius of the balls that make the band, in voxels, in [0.5, 1000]. Default 0, automatic: it
   * follows the spacing around each point.
   */
  vtkSetMacro(OffsetInVoxels, double);
  vtkGetMacro(OffsetInVoxels, double);
  ///@}

  ///@{
  /**
   * Voxels along the longest side of the bounding box of the points, outliers left out; at most
   * 524288. Default 0, automatic. Voxels larger than the median spacing are a warning.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Parameter of the reach, by Scheme, in [1e-3, 1e6]. A: the mean length of direct pairs is
   * divided by it; B: voxels added to OffsetInVoxels; C: spacings. Default 0, automatic.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * How much longer distances may become by pruning edges, relatively, in [1e-6, 0.5]; 0 keeps all
   * edges. Default 0.001.
   */
  vtkSetMacro(Accuracy, double);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * Whether lengths are those of arcs that fit the normals, not of straight lines, which are too
   * short. Default on.
   */
  vtkSetMacro(ArcLengthWeights, bool);
  vtkGetMacro(ArcLengthWeights, bool);
  vtkBooleanMacro(ArcLengthWeights, bool);
  ///@}

  ///@{
  /**
   * Whether point normals of the input are used. Without, and where they are 0 or not finite, they
   * are found from the points. Turn it off for coarse normals, as of flat facets. Default on.
   */
  vtkSetMacro(UseInputNormals, bool);
  vtkGetMacro(UseInputNormals, bool);
  vtkBooleanMacro(UseInputNormals, bool);
  ///@}

  ///@{
  /**
   * Whether normals of the input all point to the same side: then points whose normals differ by
   * more than 100 degrees are not connected, which keeps sheets back to back apart. Without such
   * normals it has no effect, with a warning. Default off.
   */
  vtkSetMacro(OrientedNormals, bool);
  vtkGetMacro(OrientedNormals, bool);
  vtkBooleanMacro(OrientedNormals, bool);
  ///@}

  ///@{
  /**
   * Whether to add point normals `Normals` (length 1, or 0 where there is no plane; of arbitrary
   * side) when the input has none that are used, by planes through NumberOfNeighbors points, and to
   * build with these. Default off: surfaces of second order give normals.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Points that a plane is fitted to, with the point itself. Default 16; at least 3.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Whether an output of points without cells gets one vertex cell of all of them, which makes them
   * visible and takes 8 bytes per point, as that of vtkPointCloudFilter. Default off: the cells are
   * those of the input.
   */
  vtkSetMacro(GenerateVertices, bool);
  vtkGetMacro(GenerateVertices, bool);
  vtkBooleanMacro(GenerateVertices, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the connected parts. Default "Component".
   */
  vtkDGGStringMacro(ComponentArrayName);
  ///@}

  /**
   * Predict the memory of the graph from the edges of some points, with the input brought up to
   * date. Returns GetEstimatedMemory(); 0 after an error, an abort or, with a warning, for an empty
   * input. GetErrorCode() changes by an error only. On several processes the graph is that of the
   * piece that is here; all must call it.
   */
  vtkTypeUInt64 EstimateMemory();

  ///@{
  /**
   * Bytes predicted last: for the graph, and at most at one time while it is built. 0 before.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Release the graph that is kept between updates, see vtkDiscreteGeodesicGraph.
   */
  void ReleaseGraph();

  ///@{
  /**
   * The graph of the last update, zero without: number of directed edges, edges per point, bytes of
   * the arrays.
   */
  vtkIdType GetNumberOfGraphEdges() const;
  double GetMeanDegree() const;
  vtkTypeUInt64 GetMemorySize() const;
  ///@}

  ///@{
  /**
   * Connected parts of the graph of the last update, from the largest on, and their numbers of
   * points.
   */
  vtkIdType GetNumberOfComponents() const;
  vtkIdType GetComponentSize(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOfComponents());
  ///@}

  ///@{
  /**
   * Points of the last update that are not finite, that are outliers, and that are in the place of
   * another one.
   */
  vtkIdType GetNumberOfUnusedPoints() const;
  vtkIdType GetNumberOfOutliers() const;
  vtkIdType GetNumberOfCoincidentPoints() const;
  ///@}

  ///@{
  /**
   * Values of the last update, given or automatic; 0 without a graph. The offset is the median
   * radius of the balls, in voxels and in units of the coordinates.
   */
  double GetUsedOffsetInVoxels() const;
  double GetUsedOffset() const;
  int GetUsedResolution() const;
  double GetUsedAlpha() const;
  ///@}

  /**
   * Size of the voxels in the last update, in units of the coordinates.
   */
  double GetVoxelSize() const;

  ///@{
  /**
   * What the last update found, in units of the coordinates: medians of the spacing, of the
   * distance of points from a surface through their neighbours, and of the reach of edges.
   */
  double GetSpacing() const;
  double GetNoise() const;
  double GetReach() const;
  ///@}

  /**
   * Share of the points, in [0, 1], whose neighbours lie on no surface, even after noise was looked
   * for: a fit misses them by more than a quarter of their radius. Above 0.1 there is a warning.
   */
  double GetOffSurfaceShare() const;

  /**
   * GetNoise() that was taken off, by the median radius of curvature; 0 without. Distances on a
   * sphere are too short by about twice its square. Above 0.07 there is a warning.
   */
  double GetNoiseByRadius() const;

  /**
   * How far points scatter about a surface, in spacings, if GetOffSurfaceShare() is above 0.1; else
   * 0.
   */
  double GetScatter() const;

  /**
   * Time stamp of the last time that a graph was built.
   */
  vtkMTimeType GetGraphBuildTime() const;

protected:
  vtkPointCloudDGG();
  ~vtkPointCloudDGG() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* cloud, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkPointCloudDGG(const vtkPointCloudDGG&) = delete;
  void operator=(const vtkPointCloudDGG&) = delete;

  vtkDataArray* GetInputNormals(vtkPolyData* cloud) const;
  using Normals = std::shared_ptr<const std::vector<double>>;
  /// Where normals come from.
  struct NormalsSource
  {
    vtkDataArray* Given = nullptr; ///< of the input
    bool ByPlanes = false;
    int NumberOfNeighbors = 0; ///< for planes
  };
  NormalsSource MakeNormalsSource(vtkPolyData* cloud) const;
  dgg::CloudGraphOptions MakeOptions(vtkPolyData* cloud) const;
  dgg::Status FindNormals(
    const DGGContext& context, const NormalsSource& source, Normals& normals, double& done);
  dgg::Status Build(const DGGContext& context, dgg::CloudGraphOptions options, double done);
  dgg::Status Estimate();
  void WarnAboutPoints();
  void WarnAboutVoxels(const dgg::CloudGraphOptions& options);

  int Scheme;
  double OffsetInVoxels;
  int Resolution;
  double Alpha;
  double Accuracy;
  bool ArcLengthWeights;
  bool UseInputNormals;
  bool OrientedNormals;
  bool EstimateNormals;
  bool GenerateVertices;
  int NumberOfNeighbors;
  std::string ComponentArrayName;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
