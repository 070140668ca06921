// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDGGDistance
 * @brief   distances along a surface within a guaranteed error, in milliseconds
 *
 * Computes, for every point, the distance on the surface from the nearest source by a search in a
 * discrete geodesic graph. The graph is taken from the input, where vtkDiscreteGeodesicGraph has
 * put it. When there is none, or one that is not of this surface (then with a warning), this filter
 * builds one with its Accuracy, and keeps it until the mesh or Accuracy changes: only the first
 * update takes long.
 *
 * <b>What is promised.</b> With Correction, which is the default, for every point
 *
 *   |result - exact distance| <= accuracy * (exact distance - o),
 *
 * up to rounding (1e-6) and the length added to triangles without area (GetMollification()), where
 * accuracy is that of the graph and o the least InitialDistance of a source (0 without). The mean
 * error is far smaller, about accuracy / 100. Without Correction the results are lengths of real
 * paths, never shorter than the exact distance; they are a metric, but their mean error is 5 to 20
 * times larger.
 *
 * A graph on the input that has been built by a rule without a guarantee (OneRelay,
 * SaddleVertexGraph) promises nothing, and the corrected results are not bounded from below. A
 * graph on the input is used whatever its accuracy; when Accuracy has been set and the graph
 * promises less, a warning says so once, unless AcceptCoarserGraph is on.
 *
 * Sources anywhere on the surface are linked to the graph as its vertices are, and have the same
 * promise. That is done on all threads of vtkSMPTools; the links are kept as long as the graph and
 * the places are the same.
 *
 * <b>Point clouds.</b> On a cloud with the graph of vtkPointCloudDGG, distances are those in that
 * graph, see there for what they mean. Correction, Accuracy and AcceptCoarserGraph do nothing, and
 * GeodesicUpperBound is the distance; GenerateVirtualSource is an error.
 *
 * Inputs, sources, results and errors are those of vtkGeodesicDistanceAlgorithm; besides these, an
 * Accuracy outside [1e-6, 0.5] is an error, and a graph that would take more memory than
 * MemoryLimit. The arrays of a graph on the input may be changed between updates, marked by
 * Modified().
 *
 * @code
 * vtkNew<vtkPLYReader> reader;
 * reader->SetFileName("mesh.ply");
 * vtkNew<vtkDGGDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->SetAccuracy(0.02);
 * distance->AddSourceId(0);
 * distance->Update(); // builds a graph
 * distance->SetSourceIds({ 10, 20 });
 * distance->Update(); // milliseconds
 * @endcode
 *
 * See vtkDiscreteGeodesicGraph for where these graphs come from. The search corrects labels, in
 * buckets of increasing distance, over those edges only that lead straight ahead (the fans of X.
 * Wang et al. 2017); a pass over all edges then certifies the result.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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
   * Whether to report the best estimate within the promised interval rather than the length of the
   * path in the graph, which is an upper bound. Default on.
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
   * - Accuracy: largest relative error of the graph that is built when the input has none, in
   *   [1e-6, 0.5]. Default 0.01. Another value is an error of the update even when the graph on the
   *   input is used.
   * - AcceptCoarserGraph: whether a graph on the input that promises less than an Accuracy that was
   *   set is used without a warning. Default off.
   * - MemoryLimit: most bytes that building a graph may take, or preparing to link points that are
   *   not vertices (some 250 bytes per triangle). Default 0, which stands for 70 % of the memory
   *   that is free at that time.
   * - Of the graph of the last update, zero when there is none: whether it is that on the input,
   *   its accuracy (0 for a SaddleVertexGraph), number of directed edges, and about the bytes with
   *   what searches and links need; they stay what they were when its arrays are changed later.
   *   Whether it keeps to its accuracy, and when this filter built one last.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkDGGDistance();
  ~vtkDGGDistance() override;

  dgg::Status CheckProperties() const override;
  dgg::Status ComputeDistances(vtkDGGDistanceTask& task) override;
  std::vector<vtkDGGPointArray> DeclareArrays() const override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkDGGDistance(const vtkDGGDistance&) = delete;
  void operator=(const vtkDGGDistance&) = delete;

  bool Correction;
  int Search;
  bool GenerateUpperBound;
  std::string UpperBoundArrayName;
  std::unique_ptr<vtkDGGGraphUser> GraphUser;
};

#endif
