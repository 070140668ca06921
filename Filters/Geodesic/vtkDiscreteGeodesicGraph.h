// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDiscreteGeodesicGraph
 * @brief   builds a sparse graph in which shortest paths are geodesics up to a bounded error
 *
 * <b>Input and output</b>. Output 0 is the input plus a graph in the field data, which
 * vtkDGGDistance and others search. Vertices are the n points of the surface; the m directed edges
 * are straight geodesics, each stored in both directions with one length.
 *  - `DGG.Offsets` (int64, n + 1): edges of point i are [Offsets[i], Offsets[i + 1]);
 *  - `DGG.Targets` (int32, m): point at the end of each edge;
 *  - `DGG.Lengths` (float32, m): length in units of the coordinates, rounded up; float64 below an
 *    Accuracy of 1e-5 and for extents beyond the range of floats;
 *  - `DGG.Angles`, `DGG.ArrivalAngles` (float32, m): directions of departure, sorted in each row,
 *    and of arrival, pointing back; radians, counter-clockwise as the triangles are oriented;
 *  - `DGG.Info` (int64, 12): parameters, signature of points and polygons, checksum.
 *
 * A valid graph on the input with the same parameters is passed on. Output 1: GenerateGraphLines.
 *
 * <b>Guarantee and cost</b>. With the default construction, for all pairs of points of a component,
 *
 *     exact distance <= distance in the graph <= (1 + Accuracy) * exact distance,
 *
 * up to rounding (1e-6) and Mollification in GetMeshReportTable(). A directed edge takes 16 bytes;
 * m is proportional to 1 / sqrt(Accuracy). All threads of vtkSMPTools build the graph.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; a graph predicted to exceed MemoryLimit. The
 * page Filters/Geodesic/Distances.md has code, details of the arrays, rules and lifetime.
 *
 * <b>Source</b>. X. Wang et al., "Discrete geodesic graph (DGG) for computing geodesic distances on
 * polyhedral surfaces", CAGD 52-53, 2017; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang
 * Technological University, 2019.
 * @sa vtkDGGDistance vtkGeodesicDistanceMatrix vtkPointCloudDGG
 */

#ifndef vtkDiscreteGeodesicGraph_h
#define vtkDiscreteGeodesicGraph_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

class VTKDGGFILTERSGEODESIC_EXPORT vtkDiscreteGeodesicGraph : public vtkGeodesicAlgorithm
{
public:
  static vtkDiscreteGeodesicGraph* New();
  vtkTypeMacro(vtkDiscreteGeodesicGraph, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Rules that choose the edges. Guaranteed makes progress toward every target, as in Yao graphs,
   * which bounds the errors of whole paths. OneRelay and Indirect are the rules of Fang's thesis,
   * chapter 3, with corrections (see the page). With Indirect a window inherits the bound of its
   * parent and is compared by its nearest point; an edge st is pruned if |sr| / (1 + Accuracy) +
   * |rt| <= |st| for another edge sr; there are no pseudo-vertices. SaddleVertexGraph: X. Ying et
   * al., "Saddle vertex graph (SVG)", ACM Trans. Graph. 32(6), 2013.
   */
  enum ConstructionType
  {
    Guaranteed = 0,       ///< every distance within Accuracy; proven
    OneRelay = 1,         ///< direct rule of the thesis; does not bound the largest error
    Indirect = 2,         ///< two steps of the thesis, pruned; no violation known, no proof; slow
    SaddleVertexGraph = 3 ///< visible points among the nearest neighbors; error not bounded
  };

  ///@{
  /**
   * Largest relative error of a distance in the graph. Default 0.01; values outside [1e-6, 0.5] are
   * errors. Not used by SaddleVertexGraph.
   */
  vtkSetMacro(Accuracy, double);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * Rule that chooses the edges. Default Guaranteed; the others are for comparison.
   */
  vtkSetClampMacro(Construction, int, Guaranteed, SaddleVertexGraph);
  vtkGetMacro(Construction, int);
  void SetConstructionToGuaranteed() { this->SetConstruction(Guaranteed); }
  void SetConstructionToOneRelay() { this->SetConstruction(OneRelay); }
  void SetConstructionToIndirect() { this->SetConstruction(Indirect); }
  void SetConstructionToSaddleVertexGraph() { this->SetConstruction(SaddleVertexGraph); }
  const char* GetConstructionAsString() const;
  ///@}

  ///@{
  /**
   * Number of nearest points that each point of a SaddleVertexGraph may connect to. Default 30; at
   * least 1. Time and memory grow with it.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * If on, output 1 contains the edges as straight lines, each once, with the cell array `Length`
   * (double). A line takes about 32 bytes; more than MemoryLimit is an error. Default off.
   */
  vtkSetMacro(GenerateGraphLines, bool);
  vtkGetMacro(GenerateGraphLines, bool);
  vtkBooleanMacro(GenerateGraphLines, bool);
  ///@}

  /**
   * Returns output 1.
   */
  vtkPolyData* GetGraphLines();

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
   * without a prediction, and if the graph of the input was passed on.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Releases the graph that is kept between updates, so that only the output refers to it. The next
   * update that executes builds the graph again.
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

  /**
   * Returns the defect of the graph on the input that the last update replaced with a warning;
   * otherwise empty. The value is set before WarningEvent.
   */
  std::string GetInputGraphDamage() const;

  /**
   * Returns the time stamp of the last build of a graph.
   */
  vtkMTimeType GetGraphBuildTime() const;

protected:
  vtkDiscreteGeodesicGraph();
  ~vtkDiscreteGeodesicGraph() override = default;

private:
  vtkDiscreteGeodesicGraph(const vtkDiscreteGeodesicGraph&) = delete;
  void operator=(const vtkDiscreteGeodesicGraph&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  double Accuracy = 0.01;
  int Construction = Guaranteed;
  int NumberOfNeighbors = 30;
  bool GenerateGraphLines = false;
};

#endif
