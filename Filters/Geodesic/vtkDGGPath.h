// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGPath
 * @brief   shortest paths on a surface, as polylines
 *
 * Finds a path on the surface for each of many pairs of points, by searches in a discrete geodesic
 * graph, and shortens it to a geodesic. The graph is taken from the input, or built and kept, as in
 * vtkDGGDistance. With Method Exact, paths are exactly shortest and there is no graph.
 *
 * Input port 0 takes the surface. Pairs are point ids (AddPair()) and the lines of a vtkPolyData on
 * port 1, each from its first to its last point, which may lie anywhere on the surface and are
 * projected to it; its other points and cells are not used. Pairs by id come first.
 *
 * <b>The output</b> is new geometry, see vtkGeodesicAlgorithm. It has a polyline for each pair, in
 * the order of the pairs, from start to end. Each of its pieces lies in one triangle of the
 * surface. A pair whose points coincide gives a polyline of length 0 that names the same point
 * twice. Points that are not connected have no path: the polyline is left out, and a warning counts
 * them.
 *  - Cell data: `Length` (double, in units of the coordinates), `GraphLength` (that of the path in
 *    the graph, before it was shortened; NaN with Method Exact), `Straightened` (int: whether the
 *    path is a locally shortest one), `PairId` (the number of the pair), and the cell data of the
 *    lines on port 1; pairs by id have zeros and empty texts there.
 *  - Point data: `FaceId`, the cell of the input that the piece after the point lies in (that
 *    before it for the last point; -1 at points that no polygon uses); `vtkOriginalPointIds`, the
 *    point of the input where the path is at one, else -1 (the first one of points that have been
 *    merged); `ArcLength`, the length of the path up to the point.
 *  - Field data: `PathStatus`, one int for each pair: 0 when there is a path, 1 when the points are
 *    not connected.
 *
 * <b>What is promised.</b> The length of a path is at least the exact distance, and never greater
 * than `GraphLength`, which is at most (1 + accuracy) times the exact distance up to rounding
 * (1e-6), where accuracy is that of the graph, unless its rule has no guarantee. With Straighten,
 * which is the default, the path is a geodesic: no path next to it is shorter. Behind every bump
 * there are several geodesics; which of them are compared is up to Detour. Lengths are those of the
 * triangles; where triangles have no area, those after GetMollification().
 *
 * <b>Point clouds.</b> On a cloud with the graph of vtkPointCloudDGG, `GraphLength` is the distance
 * in that graph, and `Length` that of the polyline, which may be shorter, as edges are as long as
 * the surface below them. Without Straighten, polylines go from point to point of the cloud. With
 * it they are smoothed: their points are moved, and more are added, so that they neither zigzag nor
 * leave the surface that the points around tell of, and `Straightened` is 1; they need not be
 * shortest. Where one is longer than `GraphLength` by more than 0.5 %, as on rough clouds, the
 * polyline from point to point is kept, unless it is even longer, and `Straightened` is 0. Smooth
 * ones that are longer by less are taken: the graph is not more exact than that. Smoothing needs
 * the band around the cloud, in MemoryLimit bytes at most. Paths begin and end where they are asked
 * to, also beside the points of the cloud. `FaceId` is -1. Detour, Accuracy and AcceptCoarserGraph
 * do nothing, and Method Exact is an error. A point that is not finite has
 * no path, not to itself either.
 *
 * <b>Time.</b> Pairs are worked on by all threads of vtkSMPTools; results do not depend on their
 * number. With the 256th pair that is looked for in one graph, distances from 32 landmarks are
 * found (68 bytes for each point, which count in GetMemorySize()): from then on searches on large
 * meshes are several times faster. Method Exact needs a propagation over the surface for each
 * starting point, which serves all pairs that start there, and reaches as far as the farthest of
 * them; it takes some hundred bytes for each point of the mesh and thread.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no pair; points on port 1 that no line connects; an id out of range; a point that is not
 *    finite, or farther from the surface than ProjectionTolerance;
 *  - a negative ProjectionTolerance; an Accuracy outside [1e-6, 0.5]; a graph that would take more
 *    memory than MemoryLimit;
 *  - an exact path that cannot be followed back, through faces so narrow that rounding hides them.
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("mesh.ply");
 * vtkNew<vtkDGGPath> path;
 * path->SetInputConnection(reader->GetOutputPort());
 * path->AddPair(0, 10);
 * path->AddPair(0, 20);
 * path->Update();
 * vtkDataArray* lengths = path->GetOutput()->GetCellData()->GetArray("Length");
 * std::cout << lengths->GetComponent(0, 0) << "\n"; // from 0 to 10
 * @endcode
 *
 * Paths in the graph are followed through the faces that its edges cross, and shortened in strips
 * of faces (Lee and Preparata 1984; Xin and Wang 2007). Exact ones are traced back through the
 * windows of Mitchell, Mount and Papadimitriou (1987).
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkDiscreteGeodesicGraph vtkDGGDistance vtkGeodesicDistanceMatrix
 * vtkDijkstraGraphGeodesicPath
 */

#ifndef vtkDGGPath_h
#define vtkDGGPath_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <vector> // For ids

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGPath : public vtkGeodesicAlgorithm
{
public:
  static vtkDGGPath* New();
  vtkTypeMacro(vtkDGGPath, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Ways to find a path.
   */
  enum MethodType
  {
    Graph = 0, ///< in the graph, then shortened
    Exact = 1  ///< by exact distances
  };

  ///@{
  /**
   * How to find paths. Default Graph. Straighten, Detour and the graph have no part in Exact.
   */
  vtkSetClampMacro(Method, int, Graph, Exact);
  vtkGetMacro(Method, int);
  void SetMethodToGraph() { this->SetMethod(Graph); }
  void SetMethodToExact() { this->SetMethod(Exact); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * A pair of points by ids of the input: one more; remove all; how many there are. None by
   * default. The same pair may occur more than once. The lines on port 1 do not count here, and are
   * not removed.
   */
  void AddPair(vtkIdType from, vtkIdType to);
  void RemoveAllPairs();
  vtkIdType GetNumberOfPairs() const;
  ///@}

  ///@{
  /**
   * The ends of the i-th pair by id; -1 when there is no such pair.
   */
  vtkIdType GetPairStart(vtkIdType i) const;
  vtkIdType GetPairEnd(vtkIdType i) const;
  ///@}

  ///@{
  /**
   * Pairs of points anywhere on the surface: the lines of a vtkPolyData on input port 1, each from
   * its first to its last point. Null removes them.
   */
  void SetPairConnection(vtkAlgorithmOutput* output);
  void SetPairData(vtkPolyData* lines);
  ///@}

  ///@{
  /**
   * How far from the surface an end of a line of port 1 may be, as a fraction of the diagonal of
   * the surface's bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Whether to shorten paths to locally shortest geodesics. Default on. When off, they are the
   * paths in the graph, which have small bends at some vertices.
   */
  vtkSetMacro(Straighten, bool);
  vtkGetMacro(Straighten, bool);
  vtkBooleanMacro(Straighten, bool);
  ///@}

  ///@{
  /**
   * Behind every bump there are several locally shortest paths. With Straighten, the shortest path
   * among those is found that have detours from the first one of up to this fraction of its length,
   * in [0, 0.1]. Default 1e-4; 0 leaves it at the first one.
   */
  vtkSetClampMacro(Detour, double, 0.0, 0.1);
  vtkGetMacro(Detour, double);
  ///@}

  /**
   * In the last update, edges of the graph whose direction, stored as a float, did not lead to
   * their head, so that the way had to be found anew. None are expected; the paths are right all
   * the same.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

  ///@{
  /**
   * Properties of the graph, which all filters that search one have, and numbers of it.
   *
   * - Accuracy: largest relative error of the graph that is built when the input has none, in
   *   [1e-6, 0.5]. Default 0.01. Another value is an error of the update even when the graph on the
   *   input is used.
   * - AcceptCoarserGraph: whether a graph on the input that promises less than an Accuracy that was
   *   set is used without a warning. Default off.
   * - MemoryLimit: most bytes that building a graph may take, or preparing to link points that are
   *   not vertices (some 250 bytes per triangle). Default 0, which stands for 70 % of the memory
   *   that is free at that time.
   * - Of the graph of the last update with Method Graph, zero when there is none: whether it is
   *   that on the input, its accuracy (0 for a SaddleVertexGraph), number of directed edges, and
   *   about the bytes with what searches and links need; they stay what they were when its arrays
   *   are changed later. Whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGPath();
  ~vtkDGGPath() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGPath(const vtkDGGPath&) = delete;
  void operator=(const vtkDGGPath&) = delete;

  vtkIdType GetPairId(vtkIdType i, int side) const;
  void WarnAboutUnconnectedPairs(
    const vtkDGGContext& context, const std::vector<vtkIdType>& pairs, std::size_t count);

  int Method;
  bool Straighten;
  double Detour;
  double ProjectionTolerance;
  vtkIdType NumberOfFallbacks;
  std::vector<vtkIdType> PairIds; // two for each pair
  std::unique_ptr<vtkDGGGraphUser> GraphUser;
};

#endif
