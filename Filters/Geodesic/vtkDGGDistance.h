// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGDistance
 * @brief   distances along a surface within a guaranteed error, in milliseconds
 *
 * <b>Input and output</b>. Those of vtkGeodesicDistanceAlgorithm, with `GeodesicUpperBound` on
 * request. The graph is that on the input, or built here, see vtkGeodesicAlgorithm. On a cloud
 * distances are those in its graph: Correction does nothing, GeodesicUpperBound is the distance.
 *
 * <b>Guarantee and cost</b>. With Correction (the default), for every point
 *
 *     |result - exact distance| <= accuracy * (exact distance - o),
 *
 * up to rounding (1e-6) and GetMollification(), where accuracy is that of the graph and o the least
 * initial distance of a source. Without Correction results are lengths of real paths, never below
 * the exact distance, and a metric; their mean error is larger. Sources that are no vertices are
 * linked to the graph, with the same promise. Graphs by a rule without a guarantee (OneRelay,
 * SaddleVertexGraph) promise nothing. Only the first update takes long, if it builds the graph.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicDistanceAlgorithm: an Accuracy outside [1e-6, 0.5]; a
 * graph, or links of points that are no vertices (some 250 bytes per triangle), that take more than
 * MemoryLimit; GenerateVirtualSource on a cloud.
 *
 * @code
 * vtkNew<vtkDGGDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->SetAccuracy(0.02);
 * distance->AddSourceId(0);
 * distance->Update(); // builds a graph
 * distance->SetSourceIds({ 10, 20 });
 * distance->Update(); // milliseconds
 * @endcode
 *
 * <b>Source</b>. Graphs: see vtkDiscreteGeodesicGraph. The search corrects labels, in buckets of
 * increasing distance, over edges that lead straight ahead (the fans of X. Wang et al. 2017); a
 * pass over all edges certifies the result.
 *
 * @sa vtkDiscreteGeodesicGraph vtkGeodesicDistanceMatrix vtkExactGeodesicDistance
 */

#ifndef vtkDGGDistance_h
#define vtkDGGDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the graph
#include <string> // For array names
#include <vector> // For arrays

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkDGGDistance* New();
  vtkTypeMacro(vtkDGGDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Ways to search the graph. All find the same distances in it.
   */
  enum SearchType
  {
    Certified = 0,       ///< the fastest
    LabelCorrecting = 1, ///< the same over all edges
    Dijkstra = 2         ///< the reference
  };

  ///@{
  /**
   * Whether to report the best estimate within the promised interval, rather than the length of the
   * path in the graph. Default on.
   */
  vtkSetMacro(Correction, bool);
  vtkGetMacro(Correction, bool);
  vtkBooleanMacro(Correction, bool);
  ///@}

  ///@{
  /**
   * How to search. Default Certified; the others are there to compare with.
   */
  vtkSetClampMacro(Search, int, Certified, Dijkstra);
  vtkGetMacro(Search, int);
  void SetSearchToCertified() { this->SetSearch(Certified); }
  void SetSearchToLabelCorrecting() { this->SetSearch(LabelCorrecting); }
  void SetSearchToDijkstra() { this->SetSearch(Dijkstra); }
  const char* GetSearchAsString() const;
  ///@}

  ///@{
  /**
   * Whether to add the point array `GeodesicUpperBound` (double): the length of the path in the
   * graph, which the exact distance does not exceed. Default off.
   */
  vtkSetMacro(GenerateUpperBound, bool);
  vtkGetMacro(GenerateUpperBound, bool);
  vtkBooleanMacro(GenerateUpperBound, bool);
  ///@}

  ///@{
  /**
   * Name of this point array. Default "GeodesicUpperBound".
   */
  vtkDGGStringMacro(UpperBoundArrayName);
  ///@}

  ///@{
  /**
   * Properties of the graph, which all filters that search one have, and numbers of it.
   *
   *  - Accuracy: largest relative error of the graph that is built when the input has none, in
   *    [1e-6, 0.5]; another value is an error even if that on the input is used. Default 0.01.
   *  - AcceptCoarserGraph: whether a graph on the input that promises less than an Accuracy that
   *    was set is used without a warning. Default off.
   *  - Of the graph of the last update, zero without: whether it is that on the input, its accuracy
   *    (0 for a SaddleVertexGraph), number of directed edges, bytes with what searches and links
   *    need; whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGDistance();
  ~vtkDGGDistance() override;

  dgg::Status CheckProperties() const override;
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::vector<DGGPointArray> DeclareArrays() const override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGDistance(const vtkDGGDistance&) = delete;
  void operator=(const vtkDGGDistance&) = delete;

  bool Correction;
  int Search;
  bool GenerateUpperBound;
  std::string UpperBoundArrayName;
  std::unique_ptr<DGGGraphUser> GraphUser;
};

#endif
