// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGDistance
 * @brief   distances along a surface within a guaranteed error, in milliseconds
 *
 * <b>Input and output</b>. Same as for vtkGeodesicDistanceAlgorithm, plus `GeodesicUpperBound` on
 * request. The graph is that on the input; without one the filter builds its own, see
 * vtkGeodesicAlgorithm. On a cloud, distances are those in its graph.
 *
 * <b>Guarantee and cost</b>. With Correction (the default), for every point
 *
 *     |result - exact distance| <= accuracy * (exact distance - o),
 *
 * up to rounding (1e-6) and Mollification in GetMeshReportTable(), where accuracy is that of the
 * graph and o the smallest initial distance of a source. Sources inside triangles have the same
 * bound. Without Correction, results are lengths of paths in the graph. Graphs by a rule without a
 * guarantee (OneRelay, SaddleVertexGraph) have no bound. Only an update that builds a graph takes
 * long.
 *
 * Virtual sources (GenerateVirtualSource) do not determine distances inside large triangles within
 * the accuracy. If GetMeanAnisotropy() is above 2, or if accuracy times the largest distance is
 * less than the mean edge (weighted by area), GenerateVirtualSource with Correction stores exact
 * distances and windows, in the time of vtkExactGeodesicDistance. If windows exceed MemoryLimit,
 * the filter warns and returns distances of the graph.
 *
 * <b>Errors</b>. All errors of vtkGeodesicDistanceAlgorithm; a graph, or links of sources inside
 * triangles (about 250 bytes per triangle), beyond MemoryLimit; GenerateVirtualSource on a cloud.
 * @code
 * vtkNew<vtkDGGDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->SetAccuracy(0.02);
 * distance->AddSourceId(0);
 * distance->Update(); // builds a graph
 * distance->SetSourceIds({ 10, 20 });
 * distance->Update(); // milliseconds
 * @endcode
 * <b>Source</b>. Graphs: see vtkDiscreteGeodesicGraph. The search corrects labels in buckets of
 * increasing distance, along the fans of X. Wang et al. 2017; a pass over all edges certifies the
 * result.
 *
 * @sa vtkDiscreteGeodesicGraph vtkGeodesicDistanceMatrix vtkExactGeodesicDistance
 */

#ifndef vtkDGGDistance_h
#define vtkDGGDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <string> // For array names

class VTKDGGFILTERSGEODESIC_EXPORT vtkDGGDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkDGGDistance* New();
  vtkTypeMacro(vtkDGGDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Algorithms that search the graph. All find the same distances.
   */
  enum SearchType
  {
    Certified = 0,       ///< label correction over edges that lead straight ahead; fastest
    LabelCorrecting = 1, ///< label correction over all edges
    Dijkstra = 2         ///< the reference
  };

  ///@{
  /**
   * If on, results are the best estimates within the certified interval. If off, they are the
   * lengths of paths in the graph: a metric that is never below the exact distance, with larger
   * mean errors. Not used on clouds. Default on.
   */
  vtkSetMacro(Correction, bool);
  vtkGetMacro(Correction, bool);
  vtkBooleanMacro(Correction, bool);
  ///@}

  ///@{
  /**
   * Algorithm of the search. Default Certified; the others are for comparison.
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
   * If on, add the point array `GeodesicUpperBound` (double): the length of the path in the graph,
   * which the exact distance does not exceed. On clouds it equals the distance. Default off.
   */
  vtkSetMacro(GenerateUpperBound, bool);
  vtkGetMacro(GenerateUpperBound, bool);
  vtkBooleanMacro(GenerateUpperBound, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with upper bounds. Default "GeodesicUpperBound".
   */
  vtkDGGStringMacro(UpperBoundArrayName);
  ///@}

  ///@{
  /**
   * Properties that all filters with a graph have, and values of the graph.
   *
   *  - Accuracy: largest relative error of the graph that is built if the input has none. Default
   *    0.01; a value outside [1e-6, 0.5] is an error even if the graph on the input is used.
   *  - AcceptCoarserGraph: if on, a graph on the input that is coarser than an explicitly set
   *    Accuracy is used without a warning. Default off. Neither property is used on clouds.
   *  - Values of the graph of the last update, zero without a graph: true if it comes from the
   *    input, its accuracy (0 for a SaddleVertexGraph), number of directed edges, bytes including
   *    search buffers and links; true if its rule guarantees the accuracy, and the time of the
   *    last build by this filter.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGDistance();
  ~vtkDGGDistance() override = default;

private:
  vtkDGGDistance(const vtkDGGDistance&) = delete;
  void operator=(const vtkDGGDistance&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  bool Correction = true;
  int Search = Certified;
  bool GenerateUpperBound = false;
  std::string UpperBoundArrayName = "GeodesicUpperBound";
};

#endif
