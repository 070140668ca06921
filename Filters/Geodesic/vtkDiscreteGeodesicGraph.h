// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// clang-format off
/**
 * @class   vtkDiscreteGeodesicGraph
 * @brief   builds a sparse graph in which shortest paths are geodesics up to a known error
 *
 * The vertices of the graph are the points of the surface; an edge is a geodesic between two of
 * them that bends nowhere, with its length. The graph is built once, for an Accuracy that is chosen
 * once; then distances are shortest paths in the graph, found in milliseconds by vtkDGGDistance and
 * vtkGeodesicDistanceMatrix, which take the graph from their input.
 *
 * <b>What is promised.</b> With the default construction, for all pairs of points of one component
 * of any mesh, with boundary, saddles and needles,
 *
 *   exact distance <= distance in the graph <= (1 + Accuracy) * exact distance,
 *
 * up to rounding (1e-6) and the length added to triangles without area (GetMollification()). Where a
 * distance consists of that length only, as between coincident points, its relative error means
 * nothing. Accuracy is a bound of the maximum, not of the mean: the mean error is about
 * Accuracy / 12, and much less again after the correction that vtkDGGDistance makes.
 *
 * <b>Output port 0</b> is the input, unchanged and in the same order, plus arrays in the field
 * data. n is the number of points, m the number of directed edges; each edge is there in both
 * directions, with the same length.
 *
 * | array | type, values | meaning |
 * |-------|--------------|---------|
 * | `DGG.Offsets` | int64, n + 1 | edges that leave point i: [Offsets[i], Offsets[i + 1]) |
 * | `DGG.Targets` | int32, m | point at the end of each edge |
 * | `DGG.Lengths` | float32, m | length, rounded up; float64 when Accuracy is below 1e-5 |
 * | `DGG.Angles` | float32, m | direction of departure, sorted within each row |
 * | `DGG.ArrivalAngles` | float32, m | direction of arrival, pointing back |
 * | `DGG.Info` | int64, 12 | see below |
 *
 * Lengths are in units of the coordinates (and float64 also where extents are beyond the range of
 * float).
 *
 * Directions are polar angles in radians on the surface, at the point where the edge begins, or
 * ends, in [0, sum of the angles of the triangles there). They grow counter-clockwise as the
 * triangles are oriented, those turned over that do not agree with most of their component. Zero
 * is, for a point with triangles all around, the edge from it to the corner that follows it in the
 * first triangle, in the order of the cells, that uses it; for a point on the boundary the boundary
 * edge from which the triangles lie counter-clockwise. Differences of two directions at one point
 * are angles between geodesics there. Where several sheets touch, on edges with more than two
 * triangles, and where no orientation is consistent, only this module knows what they mean.
 *
 * The first three are a compressed sparse row matrix, `scipy.sparse.csr_matrix((lengths, targets,
 * offsets))`. All together take 16 bytes per directed edge. Points that no polygon uses have empty
 * rows.
 * `DGG.Info` holds: the version of this format (1); the kind (0: mesh); the construction; the bits
 * of the double Accuracy (0 for a SaddleVertexGraph); NumberOfNeighbors (0 for others); whether
 * coincident points were merged; a signature of the surface (2 values); 0; the bits of the double
 * MergeTolerance; 0; a checksum of all arrays.
 *
 * The arrays go through other filters, and into files and back: by vtkXMLPolyDataWriter and reader
 * in any of its modes, and by vtkPolyDataWriter and reader in binary. A legacy file in ASCII, which
 * is the default of vtkPolyDataWriter, rounds numbers; its graph is found to be damaged.
 * Whoever takes a graph from its input makes sure first that it is undamaged and that of this very
 * surface: any change of points or polygons, a rigid motion included, makes it useless.
 *
 * When the input has a graph with the same parameters already, it is passed on; one that is damaged
 * or out of date is replaced, with a warning. The graph is kept between updates as well: it is
 * built anew only when the mesh or a parameter of the graph changes (GetGraphBuildTime()). An empty
 * input has no graph; arrays of these names are removed from it.
 *
 * <b>Output port 1</b> are the edges of the graph as lines, for looking at (GenerateGraphLines).
 *
 * <b>Memory</b> is predicted before anything is built, and refused above MemoryLimit. The number of
 * edges grows as 1 / sqrt(Accuracy): about 16 per point at 0.1, 55 at 0.01, 185 at 0.001.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - an Accuracy outside [1e-6, 0.5]; a NumberOfNeighbors less than 1;
 *  - a graph that would take more memory than MemoryLimit.
 *
 * The work is spread over the threads of vtkSMPTools; the graph is the same, bit by bit, for any
 * number of them.
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("mesh.ply");
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
 * Discrete geodesic graphs are due to X. Wang, Z. Fang, J. Wu, S.-Q. Xin, Y. He, "Discrete geodesic
 * graph (DGG) for computing geodesic distances on polyhedral surfaces", Computer Aided Geometric
 * Design 52-53, 2017, and Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
 * University, 2019, whose rules are OneRelay and Indirect. The default rule replaces them by one
 * that makes progress towards every target, as in Yao graphs, and so bounds the error of whole
 * paths. OneRelay and Indirect are repaired where the thesis is silent or does not work as printed:
 * the search of OneRelay ends behind edges of which every point is covered. With Indirect a window
 * inherits the bound of its parent and is compared by its nearest point, and an edge st is pruned
 * when |sr| / (1 + Accuracy) + |rt| <= |st| for another edge sr, where the printed procedure would
 * remove every edge and let errors add up; there are no pseudo-vertices. SaddleVertexGraph is due
 * to X. Ying, X. Wang, Y. He, "Saddle vertex graph (SVG): a novel solution to the discrete geodesic
 * problem", ACM Trans. Graph. 32(6), 2013.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkDGGDistance vtkGeodesicDistanceMatrix
 */
// clang-format on

#ifndef vtkDiscreteGeodesicGraph_h
#define vtkDiscreteGeodesicGraph_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals

namespace dgg
{
struct GraphOptions;
}
class vtkDGGGraphArrays;

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
   * Of a SaddleVertexGraph: how many of the nearest points each point looks at. Default 30; at
   * least 1. Time and memory grow with the number of points that are looked at; where it is more
   * than there are points, that is all of them from each: minutes for some thousand points.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Most bytes that building the graph may take, workspaces included. A graph that would take more
   * is an error, before it is built. Default 0, which stands for 70 % of the memory that is free at
   * that time.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * Whether output port 1 has the edges of the graph as straight lines between the points of the
   * surface, each edge once, with the cell array `Length` (double). They take about 32 bytes each,
   * twice as much as the graph; more than MemoryLimit is an error. Default off: then it is empty.
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
   * Predict the memory that the graph will take, from the edges of some points and without building
   * it. Brings the input up to date. Returns GetEstimatedMemory(); 0 after an error and, with a
   * warning, when the input is empty. Reports progress; AbortExecute set by an observer makes it
   * return 0. GetErrorCode() becomes that of an error here; else it stays that of the last update.
   */
  vtkTypeUInt64 EstimateMemory();

  ///@{
  /**
   * What was predicted last, in bytes: for the graph, and most at one time while it is built. 0
   * before, and when the graph of the input was passed on.
   */
  vtkTypeUInt64 GetEstimatedMemory() const;
  vtkTypeUInt64 GetEstimatedPeakMemory() const;
  ///@}

  /**
   * Let go of the graph that is kept between updates, so that the output alone has it: for memory's
   * sake, when this filter will not run again, or together with ReleaseDataFlag, which frees the
   * output only. The next update that runs builds a graph anew.
   */
  void ReleaseGraph();

  ///@{
  /**
   * The graph of the last update, zero when there is none: number of directed edges,
   * edges that leave a point on average, bytes of the arrays. They stay what they were when
   * somebody changes the arrays in the output.
   */
  vtkIdType GetNumberOfGraphEdges() const;
  double GetMeanDegree() const;
  vtkTypeUInt64 GetMemorySize() const;
  ///@}

  /**
   * What is damaged in the graph on the input, which the last update has replaced with a warning;
   * empty when it is sound, of another surface, or missing. It is set when WarningEvent comes.
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
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDiscreteGeodesicGraph(const vtkDiscreteGeodesicGraph&) = delete;
  void operator=(const vtkDiscreteGeodesicGraph&) = delete;

  dgg::GraphOptions MakeOptions() const;
  bool FindOnInput(const vtkDGGContext& context);
  dgg::Status Build(const vtkDGGContext& context);
  dgg::Status Estimate();
  dgg::Status AddLines(
    const vtkDGGContext& context, const vtkDGGGraphArrays& arrays, vtkPolyData* lines);

  double Accuracy;
  int Construction;
  int NumberOfNeighbors;
  bool GenerateGraphLines;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
