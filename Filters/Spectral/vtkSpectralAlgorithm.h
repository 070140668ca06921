// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpectralAlgorithm
 * @brief   what filters have in common that solve Poisson equations for sources on a surface
 *
 * <b>Input and output</b>. Port 0 takes the surface. Sources are point ids (SetSourceIds()) and the
 * points of the optional port 1 (SetSourceConnection()), each projected to the closest point of the
 * surface; they are numbered from 0, ids first. Output 0 is the input, in the same order, plus a
 * point array (double) with one component per source, which becomes the active scalars. Output 1
 * (GetEvaluation()) has the points of the optional port 2 (SetEvaluationConnection()) with the same
 * array: the values at the closest points of the surface.
 *
 * <b>Guarantee and cost</b>. Linear finite elements (cotangents) give a sparse matrix, which is
 * factorized once and kept until the mesh, Boundary or IntrinsicDelaunay changes; each source takes
 * a substitution or two. Any triangles are allowed; edges with more than two conduct between all of
 * them. Components, connected through edges or shared points, are independent of each other. An
 * update can be stopped between the parts of the work; the factorization is one of them.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - no source, but for filters that choose sources; a source id out of range, or of a point that
 *    no polygon uses; a source or evaluation point that is not finite, or farther from the surface
 *    than ProjectionTolerance;
 *  - a ProjectionTolerance that is negative or NaN; an empty ResultArrayName;
 *  - triangles that are nearly everywhere too thin for double precision, about a million times as
 *    long as high; where only components of near-zero area are so, only sources, sites and masses
 *    there;
 *  - a factorization and results that take more than MemoryLimit: 1 to 2 KiB per point, and 8 bytes
 *    per point and source, are usual.
 *
 * @sa vtkDiscreteGreensFunction vtkBiharmonicDistance vtkHarmonicBSpline
 */

#ifndef vtkSpectralAlgorithm_h
#define vtkSpectralAlgorithm_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <functional> // For progress
#include <memory>     // For the internals
#include <string>     // For array names
#include <vector>     // For source ids

namespace dgg
{
struct PoissonOptions;
class PoissonSolver;
struct SurfacePoint;
}
class DGGPoissonCache;
struct DGGSourceSet;
struct DGGSpectralTask;

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSpectralAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSpectralAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input. None by default; ids may repeat, one out of range is an error
   * of the update. Python takes any sequence of integers. A null list removes all; the i-th id is
   * -1 where there is none.
   */
  vtkDGGIdsMacro(Source);
  ///@}

  /**
   * Remove the source ids and disconnect input port 1.
   */
  void RemoveAllSources();

  ///@{
  /**
   * Sources anywhere on the surface: the points of a vtkPolyData on input port 1. Null removes
   * them.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Further points of the surface at which values are evaluated: those of a vtkPolyData on input
   * port 2. Null removes them.
   */
  void SetEvaluationConnection(vtkAlgorithmOutput* output);
  void SetEvaluationData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Output 1, with the points of input port 2; empty without.
   */
  vtkPolyData* GetEvaluation();
  vtkAlgorithmOutput* GetEvaluationPort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 or 2 may be, as a fraction of the diagonal of the
   * surface's bounding box; farther is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  /**
   * What holds at the boundary of the surface.
   */
  enum BoundaryType
  {
    Neumann = 0,  ///< nothing flows through it
    Dirichlet = 1 ///< functions are 0 there
  };

  ///@{
  /**
   * Condition at the boundary. Default Neumann. Components without a boundary have no Green's
   * function with Dirichlet conditions.
   */
  vtkSetClampMacro(Boundary, int, Neumann, Dirichlet);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToNeumann() { this->SetBoundary(Neumann); }
  void SetBoundaryToDirichlet() { this->SetBoundary(Dirichlet); }
  const char* GetBoundaryAsString() const;
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay first, which improves results on long or obtuse
   * triangles. The surface does not change. Default off.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the results; it replaces one of the input.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * Factorizations so far: one for a new mesh, Boundary or IntrinsicDelaunay, none for other
   * sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Bytes kept between updates, about; zero before the first one.
   */
  virtual vtkTypeUInt64 GetMemorySize() const;

protected:
  /**
   * With the default name of the result array.
   */
  explicit vtkSpectralAlgorithm(const std::string& resultArrayName);
  ~vtkSpectralAlgorithm() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

  /**
   * What is to be factorized.
   */
  virtual dgg::PoissonOptions GetPoissonOptions() const;

  ///@{
  /**
   * For filters that can choose sources themselves, or need them elsewhere than they are given:
   * whether there may be none, how many there will be on a surface that is ready to be factorized,
   * and which (the callback takes the progress and returns whether to go on). By default sources
   * are needed, and used as they are.
   */
  virtual bool CanChooseSources() const { return false; }
  virtual std::size_t CountSources(const dgg::PoissonSolver& solver, std::size_t given) const;
  virtual dgg::Status ChooseSources(const dgg::PoissonSolver& solver,
    const std::function<bool(double)>& progress, std::vector<dgg::SurfacePoint>& sources) const;
  ///@}

  /**
   * Components of the result array; 0 where it is not wanted. One for each source by default.
   */
  virtual std::size_t CountResults(std::size_t numberOfSources) const;

  /**
   * The sources as they are given.
   */
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;

  /**
   * Bytes that ComputeValues() takes at one time, besides its results.
   */
  virtual double EstimateWorkingMemory(const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const = 0;

  /**
   * Set the outputs of the task, for each source. Returns an error, which is shown to the user, or
   * that the task's Progress asked to stop. May throw.
   */
  virtual dgg::Status ComputeValues(DGGSpectralTask& task) = 0;

private:
  vtkSpectralAlgorithm(const vtkSpectralAlgorithm&) = delete;
  void operator=(const vtkSpectralAlgorithm&) = delete;

  static DGGSourceSet GetTargets(vtkInformationVector** inputVector);

  std::vector<vtkIdType> SourceIds;
  double ProjectionTolerance;
  int Boundary;
  bool IntrinsicDelaunay;
  std::string ResultArrayName;
  std::unique_ptr<DGGPoissonCache> Cache;
};

#endif
