// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicSampler
 * @brief   samples of a surface that are spread evenly along it
 *
 * Takes points of a surface one after the other, each as far as possible along the surface from
 * all those before: farthest point sampling. The distances are those of a discrete geodesic graph,
 * which is taken from the input, or built and kept, as in vtkDGGDistance.
 *
 * Input port 0 takes the surface. Points to start with may be given on the optional input port 1
 * (SetStartConnection(), SetStartData()), anywhere on the surface; they are projected to it, come
 * first in the output and are all kept. Without them the first sample is FirstSample.
 *
 * The output is new geometry, see vtkGeodesicAlgorithm: the samples as points in the order in which
 * they were taken, each with a vert. Any number of them from the first on is a good sampling as
 * well. Their point data are
 *  - `vtkOriginalPointIds`: the id of the point of the input that the sample is, -1 where it lies
 *    inside a face or on an edge. With MergeCoincidentPoints, the smallest of the ids;
 *  - `FaceId`: a cell of the input that the sample lies in, -1 for a point that no polygon uses;
 *  - `CoveringRadius`: how far the point of the input that is farthest from the samples so far,
 *    this one included, is from them. It never grows; infinity while there are components without a
 *    sample. Every component gets one before any gets a second one.
 *
 * <b>What is promised.</b> Distances along the graph are at least the exact ones and at most
 * (1 + accuracy) times those, where accuracy is that of the graph, unless its rule has no
 * guarantee. Every point of the input is within the last CoveringRadius of a sample, and along the
 * graph samples that were not given are at least that far from all other samples, so that the exact
 * distance is at least CoveringRadius / (1 + accuracy). Points that no polygon uses are left out.
 * The result does not depend on the number of threads.
 *
 * <b>Point clouds.</b> On a cloud with the graph of vtkPointCloudDGG, samples are points of the
 * cloud: those given on port 1 become the closest ones, InFaces does nothing, and `FaceId` is -1.
 * Accuracy and AcceptCoarserGraph do nothing. Points that are connected to no other one are left
 * out.
 *
 * A thousand samples take about as long as twenty distance fields; with InFaces on meshes of fewer
 * points than samples, seconds.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - a NumberOfSamples below 1; a CoveringRadius or ProjectionTolerance that is negative or not a
 *    number; a FirstSample out of range; a point on port 1 that is not finite, or farther from the
 *    surface than ProjectionTolerance;
 *  - an Accuracy outside [1e-6, 0.5]; a graph that would take more memory than MemoryLimit.
 *
 * With more samples asked for than there are points, all of them are given, with a warning, unless
 * InFaces is on; and there is a warning when there are more components than samples.
 *
 * @code
 * vtkNew<vtkGeodesicSampler> sampler;
 * sampler->SetInputConnection(reader->GetOutputPort());
 * sampler->SetNumberOfSamples(500);
 * vtkNew<vtkGeodesicVoronoi> voronoi;
 * voronoi->SetInputConnection(reader->GetOutputPort());
 * voronoi->SetSiteConnection(sampler->GetOutputPort());
 * @endcode
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkGeodesicVoronoi vtkDiscreteGeodesicGraph
 */

#ifndef vtkGeodesicSampler_h
#define vtkGeodesicSampler_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkDGGPropertyMacros.h"        // For the properties of the graph
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals

struct vtkDGGSourceSet;
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
   * The id of the first sample. Default -1, which stands for a point far out: the one farthest from
   * the first point of the surface. Not used with points on port 1.
   */
  vtkSetMacro(FirstSample, vtkIdType);
  vtkGetMacro(FirstSample, vtkIdType);
  ///@}

  ///@{
  /**
   * Stop as soon as every point of the input is this close to a sample, in units of the
   * coordinates, even with fewer samples than NumberOfSamples. Default 0: never.
   */
  vtkSetMacro(CoveringRadius, double);
  vtkGetMacro(CoveringRadius, double);
  ///@}

  ///@{
  /**
   * Whether samples may lie inside faces and on edges: instead of the farthest point of the input,
   * the farthest point of the surface close to it is taken, where one is found that is farther
   * along the graph. Then samples are spread more evenly on coarse meshes. Where the input has
   * fewer than two points for each of NumberOfSamples (up to 1000), places inside faces, up to 64
   * for each sample and 10000 in all, count as points of the input do, so that there may be more
   * samples than points, and CoveringRadius is that of the places as well. Default off: samples are
   * points of the input.
   */
  vtkSetMacro(InFaces, bool);
  vtkGetMacro(InFaces, bool);
  vtkBooleanMacro(InFaces, bool);
  ///@}

  ///@{
  /**
   * Points to start with: those of a vtkPolyData on input port 1; its cells are not used. Null
   * removes them.
   */
  void SetStartConnection(vtkAlgorithmOutput* output);
  void SetStartData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; not
   * negative; 0 takes points of the surface alone, up to rounding.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
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
  vtkGeodesicSampler();
  ~vtkGeodesicSampler() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override;

private:
  vtkGeodesicSampler(const vtkGeodesicSampler&) = delete;
  void operator=(const vtkGeodesicSampler&) = delete;

  vtkDGGSourceSet GetStart(vtkInformationVector** inputVector) const;
  dgg::Status MakeOptions(
    const vtkDGGContext& context, vtkInformationVector** inputVector, dgg::SamplerOptions& options);
  void WarnAboutNumber(
    const dgg::SamplerOptions& options, const dgg::SurfaceSample* last, vtkIdType numberOfSamples);

  vtkIdType NumberOfSamples;
  vtkIdType FirstSample;
  double CoveringRadius;
  bool InFaces;
  double ProjectionTolerance;
  std::unique_ptr<vtkDGGGraphUser> GraphUser;
};

#endif
