// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGPath
 * @brief   shortest paths on a surface, as polylines
 *
 * Paths between pairs of points are found in a graph and shortened to geodesics, or exact.
 *
 * <b>Input and output</b>. Pairs are point ids (AddPair()) and the lines of a vtkPolyData on input
 * port 1, each from its first to its last point, which are projected to the surface. Pairs by id
 * come first. The graph is that on the input, or built here, see vtkGeodesicAlgorithm. The output
 * is new geometry: a polyline for each pair, from start to end; points in the same place give one
 * of length 0 with two points. Pairs that are not connected are left out, with a warning that
 * counts them.
 *  - Cell data: `Length` (double), `GraphLength` (double, before it was shortened; NaN with Method
 *    Exact), `Straightened` (int), `PairId`, and the cell data of the lines of port 1; pairs by id
 *    have zeros and empty texts there.
 *  - Point data: `FaceId`, `Barycentric`, `vtkOriginalPointIds`, `ArcLength`.
 *  - Field data: `PathStatus` (int), for each pair: 0 for a path, 1 for points that are not
 *    connected.
 *
 * On a cloud, `GraphLength` is the distance in its graph and `FaceId` is -1. Straighten smooths
 * paths along the sampled surface; they need not be shortest. Points of a smooth path are within
 * one spacing of a point of the cloud. A spacing is `DGG.Radii` divided by 1.5. Between two of them
 * a path crosses no wider gap than edges of the graph do. At rims and holes it stays among the
 * points. Where a smooth path is longer than `GraphLength` by more than 1 %, that from point to
 * point is kept, unless it is longer still, and `Straightened` is 0. Method Exact is an error.
 *
 * <b>Guarantee and cost</b>. On surfaces, exact distance <= `Length` <= `GraphLength`, which is at
 * most (1 + accuracy) * exact distance up to rounding (1e-6), if the rule of the graph has a
 * guarantee. With Straighten no path next to it is shorter. Pairs are searched by all threads of
 * vtkSMPTools; from the 256th pair on, distances from 32 landmarks (68 bytes per point) make
 * searches faster. Method Exact takes one propagation for each starting point, as far as the
 * farthest end.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - no pair; points on port 1 that no line connects; an id out of range; a point that is not
 *    finite, or farther from the surface than ProjectionTolerance;
 *  - a negative ProjectionTolerance; an Accuracy outside [1e-6, 0.5]; a graph that takes more than
 *    MemoryLimit;
 *  - an exact path that cannot be retraced, through faces so narrow that rounding hides them.
 *
 * @code
 * vtkNew<vtkDGGPath> path;
 * path->SetInputConnection(reader->GetOutputPort());
 * path->AddPair(0, 10);
 * path->AddPair(0, 20);
 * path->Update();
 * vtkDataArray* lengths = path->GetOutput()->GetCellData()->GetArray("Length");
 * std::cout << lengths->GetComponent(0, 0) << "\n"; // from 0 to 10
 * @endcode
 *
 * <b>Source</b>. Shortening in strips of faces: D. T. Lee, F. P. Preparata, "Euclidean shortest
 * paths in the presence of rectilinear barriers", Networks 14, 1984; S.-Q. Xin, G.-J. Wang,
 * "Efficiently determining a locally exact shortest path on polyhedral surfaces", Computer-Aided
 * Design 39, 2007. Exact paths: see vtkExactGeodesicDistance.
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
   * How to find paths. Default Graph. Exact uses neither Straighten, Detour nor the graph.
   */
  vtkSetClampMacro(Method, int, Graph, Exact);
  vtkGetMacro(Method, int);
  void SetMethodToGraph() { this->SetMethod(Graph); }
  void SetMethodToExact() { this->SetMethod(Exact); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * Add a pair of points by ids of the input, remove these pairs, count them. None by default; a
   * pair may occur more than once. Lines of port 1 do not count.
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
   * Pairs anywhere on the surface: the lines of a vtkPolyData on input port 1. Null removes them.
   */
  void SetPairConnection(vtkAlgorithmOutput* output);
  void SetPairData(vtkPolyData* lines);
  ///@}

  ///@{
  /**
   * How far from the surface an end of a line of port 1 may be, as a fraction of the diagonal of
   * the surface's bounding box; farther is an error. Default 0.01; not negative; 0 accepts points
   * on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Whether to shorten paths to locally shortest geodesics. Default on; off, paths are those in the
   * graph, with small bends.
   */
  vtkSetMacro(Straighten, bool);
  vtkGetMacro(Straighten, bool);
  vtkBooleanMacro(Straighten, bool);
  ///@}

  ///@{
  /**
   * Behind every bump there are several locally shortest paths. The shortest is taken of those that
   * are longer than the first one by up to this fraction, in [0, 0.1]. Default 1e-4; 0 takes the
   * first one.
   */
  vtkSetClampMacro(Detour, double, 0.0, 0.1);
  vtkGetMacro(Detour, double);
  ///@}

  /**
   * Edges of the last update whose direction, a float, did not lead to their end, and whose path
   * was found anew. None are expected; paths are right all the same.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of one that is built, in [1e-6, 0.5],
   * default 0.01; whether a coarser one on the input is accepted without a warning, default off.
   * And numbers of the graph of the last update with Method Graph.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGPath();
  ~vtkDGGPath() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGPath(const vtkDGGPath&) = delete;
  void operator=(const vtkDGGPath&) = delete;

  vtkIdType GetPairId(vtkIdType i, int side) const;
  void WarnAboutUnconnectedPairs(
    const DGGContext& context, const std::vector<vtkIdType>& pairs, std::size_t count);

  int Method;
  bool Straighten;
  double Detour;
  double ProjectionTolerance;
  vtkIdType NumberOfFallbacks;
  std::vector<vtkIdType> PairIds; // two for each pair
  std::unique_ptr<DGGGraphUser> GraphUser;
};

#endif
