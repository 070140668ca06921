// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGPath
 * @brief   shortest paths on a surface, as polylines
 *
 * <b>Input and output</b>. Pairs of points are ids (AddPair()) and the lines of a vtkPolyData on
 * input port 1, each from its first to its last point, projected to the surface; pairs by id come
 * first. The graph is that on the input or built by this filter, see vtkGeodesicAlgorithm. The
 * output is new geometry: a polyline per pair, from start to end; of length 0 with two points if
 * both are at the same position. Pairs that are not connected have none; a warning counts them.
 *  - Cell data: `Length` (double); `GraphLength` (double), the length before straightening, NaN
 *    with Method Exact; `Straightened` (int), 1 if the path was straightened, otherwise 0; `PairId`
 *    (index of the pair, ids first); cell data of the lines of port 1, for pairs by id zeros and
 *    empty strings.
 *  - Point data: `FaceId` (-1 on clouds), `Barycentric`, `vtkOriginalPointIds`, `ArcLength`.
 *  - Field data: `PathStatus` (int) per pair: 0 for a path, 1 if not connected.
 *
 * <b>Guarantee and cost</b>. On surfaces, exact distance <= `Length` <= `GraphLength` <= (1 +
 * accuracy) * exact distance, up to rounding (1e-6), if the rule of the graph has a guarantee. All
 * threads of vtkSMPTools search pairs; from the 256th pair on, distances from 32 landmarks (68
 * bytes per point) accelerate searches.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; no pair; points on port 1 without lines; an id
 * out of range; a point that is not finite or beyond ProjectionTolerance; a graph beyond
 * MemoryLimit; Method Exact on a cloud, or an exact path through faces so narrow that rounding
 * hides them. The module page is Filters/Geodesic/Curves.md.
 *
 * <b>Source</b>. D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence of
 * rectilinear barriers", Networks 14, 1984; S.-Q. Xin, G.-J. Wang, "Efficiently determining a
 * locally exact shortest path on polyhedral surfaces", Computer-Aided Design 39, 2007.
 * @sa vtkDiscreteGeodesicGraph vtkDGGDistance vtkDijkstraGraphGeodesicPath
 */

#ifndef vtkDGGPath_h
#define vtkDGGPath_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <vector> // For ids

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGPath : public vtkGeodesicAlgorithm
{
public:
  static vtkDGGPath* New();
  vtkTypeMacro(vtkDGGPath, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Methods that find a path.
   */
  enum MethodType
  {
    Graph = 0, ///< search in the graph, then straightening
    Exact = 1  ///< exact distances
  };

  ///@{
  /**
   * Method that finds paths. Default Graph. Exact uses neither Straighten, Detour nor the graph; it
   * takes one propagation per starting point, up to the farthest end.
   */
  vtkSetClampMacro(Method, int, Graph, Exact);
  vtkGetMacro(Method, int);
  void SetMethodToGraph() { this->SetMethod(Graph); }
  void SetMethodToExact() { this->SetMethod(Exact); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * Add a pair of points by ids of the input, remove all such pairs, return their number. None by
   * default; pairs may repeat. Lines of port 1 do not count.
   */
  void AddPair(vtkIdType from, vtkIdType to);
  void RemoveAllPairs();
  vtkIdType GetNumberOfPairs() const;
  ///@}

  ///@{
  /**
   * Ends of the i-th pair by id; -1 if there is no such pair.
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
   * Largest distance of an end of a line of port 1 from the surface, as a fraction of the diagonal
   * of the surface's bounding box; a farther end is an error. Default 0.01; not negative. 0 accepts
   * points on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * If on, paths are shortened to locally shortest geodesics: no nearby path is shorter. If off,
   * they are those in the graph, with small bends. Default on. On clouds paths are smoothed along
   * the sampled surface and need not be shortest. A smooth path that is longer than `GraphLength`
   * by more than 1 % is replaced by the path from point to point, unless that is longer, and
   * `Straightened` is 0.
   */
  vtkSetMacro(Straighten, bool);
  vtkGetMacro(Straighten, bool);
  vtkBooleanMacro(Straighten, bool);
  ///@}

  ///@{
  /**
   * Largest relative excess over the first path found up to which other locally shortest paths, as
   * around the other side of a bump, are compared; the shortest is the result. In [0, 0.1]. Default
   * 1e-4; 0 takes the first path.
   */
  vtkSetClampMacro(Detour, double, 0.0, 0.1);
  vtkGetMacro(Detour, double);
  ///@}

  /**
   * Number of edges of the last update whose float direction did not lead to their end, so that
   * their path was searched again. Expected to be 0; paths are correct in any case.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of a graph that is built (default 0.01;
   * outside [1e-6, 0.5] an error), AcceptCoarserGraph (default off), and values of the graph of the
   * last update with Method Graph.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGPath();
  ~vtkDGGPath() override = default;

private:
  vtkDGGPath(const vtkDGGPath&) = delete;
  void operator=(const vtkDGGPath&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  vtkIdType GetPairId(vtkIdType i, int side) const;

  int Method;
  bool Straighten;
  double Detour;
  double ProjectionTolerance;
  vtkIdType NumberOfFallbacks;
  std::vector<vtkIdType> PairIds; // two for each pair
};

#endif
