// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicSampler
 * @brief   samples of a surface that are spread evenly along it
 *
 * Farthest point sampling: each point is as far as possible along the surface from all earlier
 * ones.
 *
 * <b>Input and output</b>. Initial samples may be given on the optional input port 1
 * (SetStartConnection()); they are projected to the surface, come first and are all kept. The graph
 * is that on the input or built by this filter, see vtkGeodesicAlgorithm. The output is new
 * geometry: samples with verts, in the order of selection. Point data: `vtkOriginalPointIds` (for
 * merged points the smallest id), `FaceId` (a cell that contains the sample; -1 at points that no
 * polygon uses and on clouds), `Barycentric`, and `CoveringRadius` (double): the largest distance
 * of a point of the input from the samples so far. It never increases, and is infinite until every
 * component has a sample; components are sampled first.
 *
 * On a cloud, samples are points of the cloud; initial samples move to the closest points. Points
 * that no polygon uses, or that are connected to no other point, are skipped.
 *
 * <b>Guarantee and cost</b>. Every point of the input is within the last CoveringRadius of a
 * sample. Samples other than initial ones are at least CoveringRadius / (1 + accuracy) from all
 * others, if the rule of the graph has a guarantee. A thousand samples take about as long as twenty
 * distance fields.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; a FirstSample out of range; a point of port 1
 * that is not finite or beyond ProjectionTolerance; a graph beyond MemoryLimit. More samples than
 * exist, or fewer than components, cause warnings. The module page is Filters/Geodesic/Curves.md.
 *
 * <b>Source</b>. G. Peyre, L. D. Cohen, "Geodesic remeshing using front propagation", Int. J.
 * Comput. Vis. 69(1), 2006, with distances in the graph of vtkDiscreteGeodesicGraph.
 * @sa vtkGeodesicVoronoi vtkDiscreteGeodesicGraph
 */

#ifndef vtkGeodesicSampler_h
#define vtkGeodesicSampler_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicSampler : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicSampler* New();
  vtkTypeMacro(vtkGeodesicSampler, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of samples, including those on port 1. Default 100; at least 1.
   */
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * Id of the first sample if port 1 has no points. Default -1: the point farthest from the first
   * point of the surface.
   */
  vtkSetMacro(FirstSample, vtkIdType);
  vtkGetMacro(FirstSample, vtkIdType);
  ///@}

  ///@{
  /**
   * Stop when every point of the input is within this distance of a sample, in units of the
   * coordinates. Default 0: never; negative values and NaN are errors.
   */
  vtkSetMacro(CoveringRadius, double);
  vtkGetMacro(CoveringRadius, double);
  ///@}

  ///@{
  /**
   * If on, samples may lie inside faces and on edges, close to the farthest point of the input,
   * which spreads them more evenly on coarse meshes. If the input has fewer than two points per
   * sample (up to 1000), positions inside faces count as points of the input: up to 64 per sample
   * and 10000 in all. There may then be more samples than points. Not used on clouds. Default off.
   */
  vtkSetMacro(InFaces, bool);
  vtkGetMacro(InFaces, bool);
  vtkBooleanMacro(InFaces, bool);
  ///@}

  ///@{
  /**
   * Initial samples: the points of a vtkPolyData on input port 1. Null removes them.
   */
  void SetStartConnection(vtkAlgorithmOutput* output);
  void SetStartData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Largest distance of a point of port 1 from the surface, as a fraction of the diagonal of the
   * surface's bounding box; a farther point is an error. Default 0.01; not negative. 0 accepts
   * points on the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of a graph that is built (default 0.01;
   * outside [1e-6, 0.5] an error), AcceptCoarserGraph (default off), and values of the graph of the
   * last update.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicSampler();
  ~vtkGeodesicSampler() override = default;

private:
  vtkGeodesicSampler(const vtkGeodesicSampler&) = delete;
  void operator=(const vtkGeodesicSampler&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  vtkIdType NumberOfSamples = 100;
  vtkIdType FirstSample = -1;
  double CoveringRadius = 0.0;
  bool InFaces = false;
  double ProjectionTolerance = 0.01;
};

#endif
