// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDiscreteGeodesicGraph
 * @brief   builds a sparse graph in which shortest paths are geodesics up to a known error
 *
 * The vertices of the graph are the points of the surface; an edge is a geodesic between two of
 * them that does not bend, with its length. vtkDGGDistance and others search it, see
 * vtkGeodesicAlgorithm.
 *
 * <b>Input and output</b>. Output 0 is the input plus arrays in the field data. n is the number of
 * points, m that of directed edges; each edge is there both ways, with one length.
 *
 *  - `DGG.Offsets` (int64, n + 1): edges of point i: [Offsets[i], Offsets[i + 1]);
 *  - `DGG.Targets` (int32, m): point at the end of each edge;
 *  - `DGG.Lengths` (float32, m): length, rounded up; float64 below an Accuracy of 1e-5;
 *  - `DGG.Angles` (float32, m): direction of departure, sorted in each row;
 *  - `DGG.ArrivalAngles` (float32, m): direction of arrival, pointing back;
 *  - `DGG.Info` (int64, 12): see below.
 *
 * Lengths are in units of the coordinates, and float64 too for extents out of the range of floats.
 * Directions are polar angles in radians, counter-clockwise as the triangles are oriented. Zero is,
 * at a point with triangles all around, the edge to the corner that follows it in its first
 * triangle; at a boundary point the boundary edge with the triangles counter-clockwise of it.
 *
 * `DGG.Info` holds: the format version (1); the kind (0: mesh); Construction; the bits of Accuracy
 * (0 for a SaddleVertexGraph); NumberOfNeighbors (0 for others); MergeCoincidentPoints; a signature
 * of the surface (2 values); 0; the bits of MergeTolerance; 0; a checksum. Any change of points or
 * polygons, a rigid motion included, invalidates the graph. A valid one on the input with the same
 * parameters is passed on. Output 1 has the edges as lines, if GenerateGraphLines is on.
 *
 * <b>Guarantee and cost</b>. With the default construction, for all pairs of points of a component,
 *
 *     exact distance <= distance in the graph <= (1 + Accuracy) * exact distance,
 *
 * up to rounding (1e-6) and GetMollification(). It takes 16 bytes per directed edge; edges grow as
 * 1 / sqrt(Accuracy). All threads of vtkSMPTools build it; it is kept until mesh or parameters
 * change.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm: an Accuracy outside [1e-6, 0.5]; a
 * NumberOfNeighbors below 1; a graph predicted to take more than MemoryLimit.
 *
 * @code
 * vtkNew<vtkDiscreteGeodesicGraph> graph;
 * graph->SetInputConnection(reader->GetOutputPort());
 * graph->SetAccuracy(0.01);
 * vtkNew<vtkDGGDistance> distance;
 * distance->SetInputConnection(graph->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update(); // builds the graph
 * distance->SetSourceIds({ 100 });
 * distance->Update(); // milliseconds
 * @endcode
 *
 * <b>Source</b>. X. Wang et al., "Discrete geodesic graph (DGG) for computing geodesic distances on
 * polyhedral surfaces", CAGD 52-53, 2017; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang
 * Technological University, 2019. The default rule makes progress towards every target, as in Yao
 * graphs, which bounds errors of whole paths. OneRelay and Indirect (chapter 3) are the rules of
 * the thesis, repaired where it is silent or does not work as printed: the search of OneRelay ends
 * behind edges of which every point is covered; with Indirect a window inherits the bound of its
 * parent and is compared by its nearest point, an edge st is pruned when |sr| / (1 + Accuracy) +
 * |rt| <= |st| for another edge sr, and there are no pseudo-vertices. SaddleVertexGraph: X. Ying et
 * al., "Saddle vertex graph (SVG)", ACM Trans. Graph. 32(6), 2013.
 *
 * @sa vtkDGGDistance vtkGeodesicDistanceMatrix vtkPointCloudDGG
 */

#ifndef vtkDiscreteGeodesicGraph_h
#define vtkDiscreteGeodesicGraph_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals

namespace dgg
{
struct GraphOptions;
}
class DGGGraphArrays;

class VTKDGGFILTERSGEODESIC_EXPORT vtkDiscreteGeodesicGraph : public vtkGeodesicAlgorithm
{
public:
  static vtkDiscreteGeodesicGraph* New();
  vtkTypeMacro(vtkDiscreteGeodesicGraph, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Rules that choose the edges.
   */
  enum ConstructionType
  {
    Guaranteed = 0, ///< every distance within Accuracy
    OneRelay = 1,   ///< the direct rule of the thesis; bounds no maximum
    Indirect = 2,   ///< the two steps of the thesis, pruned; no violation known, no proof; slow
    SaddleVertexGraph = 3 ///< the nearest neighbours, whatever the error
  };

  ///@{
  /**
   * Largest relative error of a distance in the graph, in [1e-6, 0.5]. Default 0.01. Not used by
   * SaddleVertexGraph.
   */
  vtkSetMacro(Accuracy, double);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * The rule. Default Guaranteed; the others are there to compare with.
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
   * Nearest points that each point of a SaddleVertexGraph looks at. Default 30; at least 1. Time
   * and memory grow with it.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Whether output 1 has the edges as straight lines, each once, with the cell array `Length`
   * (double). They take about 32 bytes each; more than MemoryLimit is an error. Default off.
   */
  vtkSetMacro(GenerateGraphLines, bool);
  vtkGetMacro(GenerateGraphLines, bool);
  vtkBooleanMacro(GenerateGraphLines, bool);
  ///@}

  /**
   * The output of port 1.
   */
  vtkPolyData* GetGraphLines();

  /**
   * Predict the memory of the graph from the edges of some points, with the input brought up to
   * date. Returns GetEstimatedMemory(); 0 after an error, an abort or, with a warning, for an empty
   * input. GetErrorCode() changes by an error only. On several processes the graph is that of the
   * piece that is here; all must call it.
   */
  vtkTypeUInt64 EstimateMemory();

  ///@{
  /**
   * Bytes predicted last: for the graph, and at most at one time while it is built. 0 before, and
   * when the graph of the input was passed on.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Release the graph that is kept between updates, so that the output alone has it. The next
   * update that runs builds it anew.
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

  /**
   * What is damaged in the graph on the input, which the last update replaced with a warning; else
   * empty. It is set before WarningEvent.
   */
  std::string GetInputGraphDamage() const;

  /**
   * Time stamp of the last time that a graph was built.
   */
  vtkMTimeType GetGraphBuildTime() const;

protected:
  vtkDiscreteGeodesicGraph();
  ~vtkDiscreteGeodesicGraph() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDiscreteGeodesicGraph(const vtkDiscreteGeodesicGraph&) = delete;
  void operator=(const vtkDiscreteGeodesicGraph&) = delete;

  dgg::GraphOptions MakeOptions() const;
  bool FindOnInput(const DGGContext& context);
  dgg::Status Build(const DGGContext& context);
  dgg::Status Estimate();
  dgg::Status AddLines(const DGGContext& context, const DGGGraphArrays& arrays, vtkPolyData* lines);

  double Accuracy;
  int Construction;
  int NumberOfNeighbors;
  bool GenerateGraphLines;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
