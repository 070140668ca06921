// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// clang-format off
/**
 * @class   vtkPointCloudDGG
 * @brief   builds a graph of a point cloud in which shortest paths are geodesics of what it samples
 *
 * Points without any connectivity, as a scanner gives them, become a graph: two of them are
 * connected directly when the straight line between them stays close to the cloud, and they are not
 * farther apart than a reach that depends on the Scheme. Distances along the sampled surface are
 * then shortest paths in the graph. vtkDGGDistance, vtkDGGPath, vtkGeodesicSampler,
 * vtkGeodesicVoronoi and vtkGeodesicDistanceMatrix search it, as they do those of meshes.
 *
 * All parameters have automatic defaults that follow from how densely the cloud is sampled, and
 * where; GetUsedOffsetInVoxels() and others report what was used.
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("scan.ply");
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
 * Input port 0 takes the cloud (vtkPolyData). Only its points are looked at: where it has polygons
 * these go through, and do not matter. Its point normals are used (see UseInputNormals).
 *
 * <b>The output</b> is the input, unchanged and in the same order, plus the point array `Component`
 * (int): the number of the connected part that a point belongs to, numbered from the largest on;
 * -1 for points that are not finite. With EstimateNormals, the point array `Normals` (double).
 * Points that are not finite are kept, with a warning that counts them; they are connected to
 * nothing. Points in the same place are connected by edges that have next to no length.
 *
 * Outliers, as readings gone wrong or numbers that stand for none, are kept as well, with a
 * warning that counts them. Each place of them is a component of its own, of the points that are in
 * it, and nothing else changes by it: the graph of the other points is, bit by bit, the one without
 * them. The rule: points are stray when each of them is more than 1000 times as far from the middle
 * of the cloud (its median along each axis) as any other point, when they are in fewer than 17
 * places, and the others in 17 places at least. Places count, not points: copies in one place are
 * one. Outliers may be as far from each other as from the cloud; the nearest such gap that leaves
 * enough places counts.
 *
 * Points that are nearer than that are a part of the cloud, however few, and so are larger parts at
 * any distance. They may be as far from each other as 8388608 voxels reach when Resolution is 0, and
 * 2^30 (1e9) spacings in any case, as coordinates have no more digits; beyond that is an error that
 * names a point.
 *
 * <b>The graph</b> is in the field data. n is the number of points, m the number of directed edges;
 * each edge is there in both directions, with the same length. It takes the place of any graph that
 * the input has.
 *
 * | array | type, values | meaning |
 * |-------|--------------|---------|
 * | `DGG.Offsets` | int64, n + 1 | edges that leave point i: [Offsets[i], Offsets[i + 1]) |
 * | `DGG.Targets` | int32, m | point at the end of each edge, sorted within each row |
 * | `DGG.Lengths` | float32, m | length; float64 when Accuracy is below 1e-5 and above 0, and for extreme extents |
 * | `DGG.Radii` | float64, n | radius of the ball around each point, 0 where it is not finite, or stray |
 * | `DGG.Info` | int64, 12 | see below |
 *
 * `DGG.Info` is as in vtkDiscreteGeodesicGraph: the version of the format (1); the kind (1: cloud);
 * the construction (4 + Scheme); the bits of the double Accuracy; 0; 0; a signature of the points
 * (2 values); the bits of the double size of voxels; 0; 0; a checksum of all arrays. There are no
 * directions. Files and other filters pass the arrays on as described there. Any change of points,
 * a rigid motion included, makes the graph useless, which is an error of the filters that search it.
 *
 * <b>What it means.</b> The band is the space within a radius of each point, made of cubic voxels: a
 * voxel belongs to it when its centre does. The radius is OffsetInVoxels * GetVoxelSize(), or
 * follows the local spacing. A pair of points is direct when all voxels that its segment goes
 * through belong to the band. The reach of a point, by Scheme (Fang, "Discrete geodesic graphs",
 * PhD thesis, Nanyang Technological University, 2019, chapter 5, for A and B):
 *  - A: the mean length of its direct pairs, divided by Alpha: short where the surface bends;
 *  - B: OffsetInVoxels + Alpha voxels for all points;
 *  - C: Alpha times the spacing of the points around it.
 *
 * A and B differ from the thesis in their defaults, so that their errors are not those printed
 * there. Automatic Alpha is 1 for A, where the thesis uses 2.5 to 4.2, and a point of A reaches six
 * direct neighbours at least; for B it makes a reach of six spacings. The radius of the balls
 * follows the spacing, not a fixed number of voxels. Lengths are those of arcs (ArcLengthWeights),
 * and pairs are pruned (Accuracy).
 *
 * The spacing is the root of the area that a point has. A pair is kept when it is within the reach
 * of either point. Its length is that of the straight line, or with ArcLengthWeights that of an arc
 * that fits the surface. Then pairs are left out that shorter ones stand in for: distances become
 * longer by Accuracy at most, relatively.
 *
 * Gaps narrower than about twice the radius are bridged, as the holes of a scan. What else could be
 * bridged is guarded against:
 *  - sheets close to each other: two points are not connected when the line between them makes more
 *    than 60 degrees with the tangent planes at both ends, or passes points that are not where the
 *    surface should be, along their normals. So sheets stay apart that are about 3.2 spacings apart
 *    or more (points at random that leave gaps need a little more); closer ones do with
 *    OrientedNormals, or with balls of a third of the gap, given by OffsetInVoxels and Resolution;
 *  - noise: where points scatter about the surface by more than 3 % of their spacing (GetNoise()),
 *    they are moved to the surface before lengths are measured. This is decided for the whole
 *    cloud: clean detail beside much noise is smoothed as well, single points above a noisy surface
 *    are moved to it, noisy sheets less than about six spacings apart may be joined, and sheets less
 *    than 1.5 of the spacings of a single one apart may be taken for one noisy surface. Noise of a
 *    spacing or more, as a standard deviation, looks like a volume to the nearest points. It is
 *    looked for with up to 512 of them, and no more than an eighth of the cloud, and taken off up to
 *    2 spacings where the surface is smooth at that scale; finer detail goes with it. When more than
 *    a tenth of the points lie on no surface with their neighbours (GetOffSurfaceShare()), as for
 *    more noise than that, and in volumes, there is a warning that says how far they scatter: then
 *    thin the cloud out until that is less than the spacing, which grows with the root of the
 *    thinning. Where noise is large beside the shape, what is left when it has been taken off is
 *    not quite the surface: there is a warning when it is more than 0.07 of the radius at which the
 *    surface typically bends (GetNoiseByRadius()), as then distances on a sphere are about 1 % too
 *    short;
 *  - uneven density: balls and, in scheme C, reaches follow the local spacing; points on their own
 *    far off the surface do not get larger balls. Where few points are very much sparser than the
 *    rest, automatic voxels become larger than the balls of the dense ones, so that balls have 4000
 *    voxels at most on average. Balls with a radius below half a voxel are looked at one by one
 *    rather than by voxels: distances are as good, and building takes a few times longer. There is a
 *    warning when voxels, given or automatic, are larger than the median spacing, as paths that
 *    vtkDGGPath straightens still go by voxels, and as an OffsetInVoxels that is given makes the
 *    balls as large;
 *  - holes that are wider are gone around; points in the same place count once.
 *
 * <b>Nothing is promised</b> of the difference between distances in the graph and on the surface
 * that was sampled: it depends on the sampling. Mean relative errors that were measured, by
 * BenchmarkCloud, are in Testing/Benchmark/README.md: with all parameters automatic about 1e-4 on
 * smooth surfaces, and 2e-3 on scans.
 *
 * On noisy clouds a distance may be shorter than the straight line between two points, by as much
 * as the noise: it is that of points that have been moved to the surface.
 *
 * The graph is kept between updates: it is built anew only when points, normals that are used or a
 * parameter change (GetGraphBuildTime()). Warnings about its points, noise and voxels come when it is
 * built, and not again while it is kept: GetNumberOfUnusedPoints(), GetNumberOfOutliers(),
 * GetScatter(), GetNoiseByRadius(), and GetVoxelSize() beside GetSpacing(), report what they were about
 * after every update. The work is spread over the threads of vtkSMPTools; the graph is the same, bit
 * by bit, for any number of them.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm, of which all that concern cells do not occur
 * here:
 *  - an OffsetInVoxels that is neither 0 nor in [0.5, 1000], an Alpha that is neither 0 nor in
 *    [1e-3, 1e6], an Accuracy that is neither 0 nor in [1e-6, 0.5]; a Resolution that is negative or
 *    above 524288; a NumberOfNeighbors below 3; an empty name of an array;
 *  - normals of another number of components or tuples than there should be;
 *  - parts of the cloud that are too far apart, see above;
 *  - a graph, or a band, that would take more memory than MemoryLimit: the message names the limit,
 *    about what is needed, and for a band the Resolution that it has.
 *
 * The mesh report is empty, and MergeCoincidentPoints and OutputPointsPrecision are not used.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkDGGDistance vtkDGGPath vtkDiscreteGeodesicGraph
 */
// clang-format on

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
   * How far the edges of a point reach, see above.
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
   * Radius of the balls that make the band, as a number of voxels, in [0.5, 1000]. Default 0,
   * automatic: it follows from the spacing around each point, so that the radius differs from point
   * to point.
   */
  vtkSetMacro(OffsetInVoxels, double);
  vtkGetMacro(OffsetInVoxels, double);
  ///@}

  ///@{
  /**
   * Number of voxels along the longest side of the bounding box of the points, stray ones left out,
   * without those around it that balls reach into; at most 524288. Default 0, automatic: it follows
   * from the spacing. There is a warning when voxels are larger than the spacing of the points.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * What sets the reach, see above, in [1e-3, 1e6]; it means another thing in each scheme. Default
   * 0, automatic.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * How much longer distances may become, relatively, by leaving out edges: in [1e-6, 0.5], or 0.
   * Default 0.001. With 0 all edges are kept, which takes many times the memory.
   */
  vtkSetMacro(Accuracy, double);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * Whether the length of an edge is that of an arc that fits the normals at its ends, rather than
   * that of the straight line, which is shorter than the surface. Default on.
   */
  vtkSetMacro(ArcLengthWeights, bool);
  vtkGetMacro(ArcLengthWeights, bool);
  vtkBooleanMacro(ArcLengthWeights, bool);
  ///@}

  ///@{
  /**
   * Whether the point normals of the input are used, where it has any. Otherwise, and where they
   * are 0 or not finite, they are found from the points. Turn it off for normals that are coarse,
   * such as those of flat facets. Default on.
   */
  vtkSetMacro(UseInputNormals, bool);
  vtkGetMacro(UseInputNormals, bool);
  vtkBooleanMacro(UseInputNormals, bool);
  ///@}

  ///@{
  /**
   * Whether the normals of the input all point to the same side of the surface, as those of a
   * scanner do. Then sheets that lie back to back, as the two sides of a thin plate, are not
   * connected: no two points are whose normals make an angle of more than 100 degrees. Points
   * without a normal, where it is 0 or not finite, are connected as if this were off. Without
   * normals of the input that are used there is a warning at every update, and no effect. Default
   * off.
   */
  vtkSetMacro(OrientedNormals, bool);
  vtkGetMacro(OrientedNormals, bool);
  vtkBooleanMacro(OrientedNormals, bool);
  ///@}

  ///@{
  /**
   * Whether the output gets point normals `Normals` when the input has none, or none that are used:
   * by planes fitted to NumberOfNeighbors points. They have length 1, or 0 where there is no plane;
   * which side they point to is arbitrary. The graph is built with them then. Default off: the
   * graph is built with normals of surfaces of second order, which follow curved surfaces more
   * closely but noise as well.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * How many points a plane is fitted to, the point itself included. Default 16; at least 3.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Most bytes that building the graph may take, the band included. A graph that would take more is
   * an error, before it is built. Default 0, which stands for 70 % of the memory that is free at
   * that time. Where the threads would take more than that together, fewer of them build the graph:
   * it is an error only when one would, whatever the number of threads. These are bytes of the
   * blocks that are asked for: the process grows by more, as the allocator keeps and rounds up some
   * (by up to 15 % where it was measured).
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * Name of the point array with the connected parts. Default "Component".
   */
  void SetComponentArrayName(const char* name);
  const char* GetComponentArrayName() const;
  ///@}

  /**
   * Predict the memory that the graph will take, from the edges of some points and without building
   * it. Brings the input up to date. Returns GetEstimatedMemory(); 0 after an error and, with a
   * warning, when the input is empty. Reports progress; AbortExecute set by an observer makes it
   * return 0. GetErrorCode() becomes that of an error here; else it stays that of the last update.
   */
  vtkTypeUInt64 EstimateMemory();

  ///@{
  /**
   * What EstimateMemory() predicted last, in bytes: for the graph, and most at one time while it is
   * built, by all threads. 0 before.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Let go of the graph that is kept between updates, see vtkDiscreteGeodesicGraph.
   */
  void ReleaseGraph();

  ///@{
  /**
   * The graph of the last update, zero when there is none: number of directed edges, edges that
   * leave a point on average, bytes of the arrays.
   */
  vtkIdType GetNumberOfGraphEdges() const;
  double GetMeanDegree() const;
  vtkTypeUInt64 GetMemorySize() const;
  ///@}

  ///@{
  /**
   * Connected parts of the graph of the last update, from the largest on, and how many points they
   * have; 0 when there is no such part. Points that are not finite belong to none.
   */
  vtkIdType GetNumberOfComponents() const;
  vtkIdType GetComponentSize(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOfComponents());
  ///@}

  ///@{
  /**
   * Points of the last update that are not finite, stray points, which are far off all others, and
   * points in the very place of another one.
   */
  vtkIdType GetNumberOfUnusedPoints() const;
  vtkIdType GetNumberOfOutliers() const;
  vtkIdType GetNumberOfCoincidentPoints() const;
  ///@}

  ///@{
  /**
   * What the last update used, whether it was given or automatic; 0 when there is no graph. The
   * offset is the median radius of the balls, as a number of voxels and in units of the
   * coordinates.
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
   * What was found of the cloud in the last update, in units of the coordinates: the median spacing
   * (the root of the area of a point), the median distance of points from a surface through their
   * neighbours, the median reach of edges.
   */
  double GetSpacing() const;
  double GetNoise() const;
  double GetReach() const;
  ///@}

  /**
   * Share of the points, in [0, 1], whose neighbours lie on no surface even after noise has been
   * looked for: what is fitted to them misses them by more than a quarter of the radius that they
   * are in. Above 0.1 there is a warning, and distances are not to be relied on.
   */
  double GetOffSurfaceShare() const;

  /**
   * Noise that was taken off, GetNoise(), by the median radius of curvature of the surface; 0 when
   * none was. Distances are mostly too short by it, on a sphere by about twice its square. Above
   * 0.07 there is a warning.
   */
  double GetNoiseByRadius() const;

  /**
   * How far points typically scatter about what surface there may be, in spacings, when
   * GetOffSurfaceShare() is above 0.1: the number of the warning. Otherwise 0.
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
  dgg::Status Execute(vtkPolyData* cloud, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(vtkPolyData* cloud, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkPointCloudDGG(const vtkPointCloudDGG&) = delete;
  void operator=(const vtkPointCloudDGG&) = delete;

  vtkDataArray* GetInputNormals(vtkPolyData* cloud) const;
  using Normals = std::shared_ptr<const std::vector<double>>;
  dgg::CloudGraphOptions MakeOptions(vtkPolyData* cloud) const;
  dgg::Status FindNormals(vtkPolyData* cloud, Normals& normals, double& done);
  dgg::Status Build(dgg::CloudGraphOptions options, double done);
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
  int NumberOfNeighbors;
  vtkTypeUInt64 MemoryLimit;
  std::string ComponentArrayName;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
