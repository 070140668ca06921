// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicSampler
 * @brief   samples of a surface that are spread evenly along it
 *
 * Takes points one after the other, each as far as possible along the surface from all those
 * before: farthest point sampling.
 *
 * <b>Input and output</b>. Points to start with may be given on the optional input port 1
 * (SetStartConnection()); they are projected to the surface, come first and are all kept. Without
 * them the first sample is FirstSample. The graph is that on the input, or built here, see
 * vtkGeodesicAlgorithm. The output is new geometry: samples with verts, in their order. Point data:
 *  - `vtkOriginalPointIds`: the id of the sample in the input, -1 inside faces and on edges; the
 *    smallest one of merged points;
 *  - `FaceId`: a cell that it lies in, -1 at points that no polygon uses, and on clouds;
 *  - `Barycentric`: its coordinates in that cell, if all polygons are triangles;
 *  - `CoveringRadius` (double): the largest distance of a point of the input from the samples so
 *    far. It never grows, and is infinite until every component has a sample, which comes first.
 *
 * On a cloud, samples are points of it, those given become the closest ones, and InFaces does
 * nothing. Points that no polygon uses, or that are connected to no other one, are left out.
 *
 * <b>Guarantee and cost</b>. Every point of the input is within the last CoveringRadius of a
 * sample, and samples that were not given are at least CoveringRadius / (1 + accuracy) from all
 * others, if the rule of the graph has a guarantee. A thousand samples take about as long as twenty
 * distance fields.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - a NumberOfSamples below 1; a CoveringRadius or ProjectionTolerance that is negative or NaN; a
 *    FirstSample out of range; a point of port 1 that is not finite, or farther from the surface
 *    than ProjectionTolerance;
 *  - an Accuracy outside [1e-6, 0.5]; a graph that takes more than MemoryLimit.
 *
 * More samples than can be found, or fewer than there are components, are warnings.
 *
 * @code
 * vtkNew<vtkGeodesicSampler> sampler;
 * sampler->SetInputConnection(reader->GetOutputPort());
 * sampler->SetNumberOfSamples(500);
 * vtkNew<vtkGeodesicVoronoi> voronoi;
 * voronoi->SetInputConnection(reader->GetOutputPort());
 * voronoi->SetSiteConnection(sampler->GetOutputPort());
 * voronoi->Update();
 * @endcode
 *
 * <b>Source</b>. G. Peyre, L. D. Cohen, "Geodesic remeshing using front propagation", Int. J.
 * Comput. Vis. 69(1), 2006, with distances in the graph of vtkDiscreteGeodesicGraph.
 *
 * @sa vtkGeodesicVoronoi vtkDiscreteGeodesicGraph
 */

#ifndef vtkGeodesicSampler_h
#define vtkGeodesicSampler_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals

struct DGGSourceSet;
namespace dgg
{
struct SamplerOptions;
struct SurfaceSample;
}

class VTKDGGFILTERSGEODESIC_EXPORT vtkGeodesicSampler : public vtkGeodesicAlgorithm
{
public:
  static vtkGeodesicSampler* New();
  vtkTypeMacro(vtkGeodesicSampler, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many samples to take, those given on port 1 included. Default 100; at least 1.
   */
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * Id of the first sample, without points on port 1. Default -1: the point farthest from the first
   * point of the surface.
   */
  vtkSetMacro(FirstSample, vtkIdType);
  vtkGetMacro(FirstSample, vtkIdType);
  ///@}

  ///@{
  /**
   * Stop when every point of the input is this close to a sample, in units of the coordinates.
   * Default 0: never.
   */
  vtkSetMacro(CoveringRadius, double);
  vtkGetMacro(CoveringRadius, double);
  ///@}

  ///@{
  /**
   * Whether samples may lie inside faces and on edges, close to the farthest point of the input,
   * which spreads them more evenly on coarse meshes. Where the input has fewer than two points for
   * each of NumberOfSamples (up to 1000), places inside faces, up to 64 for each sample and 10000
   * in all, count as points of the input, so that there may be more samples than points. Default
   * off.
   */
  vtkSetMacro(InFaces, bool);
  vtkGetMacro(InFaces, bool);
  vtkBooleanMacro(InFaces, bool);
  ///@}

  ///@{
  /**
   * Points to start with: those of a vtkPolyData on input port 1. Null removes them.
   */
  void SetStartConnection(vtkAlgorithmOutput* output);
  void SetStartData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 may be, as a fraction of the diagonal of the
   * surface's bounding box; farther is an error. Default 0.01; not negative; 0 accepts points on
   * the surface, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Properties of the graph, see vtkDGGDistance: Accuracy of one that is built, in [1e-6, 0.5],
   * default 0.01; whether a coarser one on the input is accepted without a warning, default off.
   * And numbers of the graph of the last update.
   */
  vtkDGGGraphPropertiesMacro();
  ///@}

protected:
  vtkGeodesicSampler();
  ~vtkGeodesicSampler() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicSampler(const vtkGeodesicSampler&) = delete;
  void operator=(const vtkGeodesicSampler&) = delete;

  DGGSourceSet GetStart(vtkInformationVector** inputVector) const;
  dgg::Status MakeOptions(
    const DGGContext& context, vtkInformationVector** inputVector, dgg::SamplerOptions& options);
  void WarnAboutNumber(
    const dgg::SamplerOptions& options, const dgg::SurfaceSample* last, vtkIdType numberOfSamples);

  vtkIdType NumberOfSamples;
  vtkIdType FirstSample;
  double CoveringRadius;
  bool InFaces;
  double ProjectionTolerance;
  std::unique_ptr<DGGGraphUser> GraphUser;
};

#endif
