// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpectralAlgorithm
 * @brief   what filters have in common that solve Poisson equations for sources on a surface
 *
 * Input port 0 takes the surface (vtkPolyData). The result is one function on the surface for each
 * source.
 *
 * <b>Sources.</b> Points of the surface given by id (AddSourceId(), SetSourceIds()) and the points
 * of a vtkPolyData on the optional input port 1 (SetSourceConnection(), SetSourceData()), which may
 * lie anywhere on the surface, also inside faces and on edges: each is projected to the closest
 * point of the surface. Sources are numbered from 0: ids first, then the points of port 1.
 *
 * <b>Outputs.</b> Port 0 is the input, its points, cells and arrays unchanged and in the same
 * order, plus a point array (double) with one component per source, in their order; it becomes the
 * active scalars. Port 1 (GetEvaluation()) has the points of the optional input port 2
 * (SetEvaluationConnection(), SetEvaluationData()), unchanged, with the same array: the values at
 * the points of the surface closest to them.
 *
 * <b>The factorization.</b> Linear finite elements (cotangents) give a sparse matrix, which is
 * factorized once and kept until the mesh changes, or Boundary or IntrinsicDelaunay; each source
 * then takes a substitution or two. Any set of triangles will do: edges with more than two
 * triangles conduct between all of them, and orientation plays no part. Components, connected
 * through edges or shared points, do not know of each other. The results do not depend on the
 * number of threads.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - no source, but for filters that choose sources; a source id out of range, or of a point that
 *    no polygon uses; a source or evaluation point that is not finite, or farther from the surface
 *    than ProjectionTolerance;
 *  - a ProjectionTolerance that is negative or not a number; an empty ResultArrayName;
 *  - triangles that are next to everywhere too thin for double precision, about a million times as
 *    long as high. A few do no harm; where only components with next to none of the area are so,
 *    only sources, sites and masses there are errors;
 *  - a factorization and results that would take more memory than MemoryLimit.
 *
 * An update can be stopped between the parts of the work; the factorization is one of them.
 *
 * This class is not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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
class vtkDGGPoissonKeeper;
struct vtkDGGSourceSet;
struct vtkDGGSpectralTask;

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSpectralAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSpectralAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input. Ids are copied; none by default. The same id may occur more
   * than once. An id outside [0, number of points - 1] is an error of the update. From Python, any
   * sequence of integers will do, a numpy array included. A null list removes all ids. The i-th id
   * is -1 when there is none.
   */
  vtkDGGIdsMacro(Source);
  ///@}

  /**
   * Remove the source ids and disconnect input port 1.
   */
  void RemoveAllSources();

  ///@{
  /**
   * Sources anywhere on the surface: the points of a vtkPolyData on input port 1 (its cells are not
   * used). Null removes them.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Points anywhere on the surface that values are wanted at besides those of the surface: the
   * points of a vtkPolyData on input port 2. Null removes them.
   */
  void SetEvaluationConnection(vtkAlgorithmOutput* output);
  void SetEvaluationData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * The output with the points of input port 2; without these it is empty.
   */
  vtkPolyData* GetEvaluation();
  vtkAlgorithmOutput* GetEvaluationPort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 or 2 may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; must not
   * be negative.
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
   * What holds at the boundary. Default Neumann. Components without a boundary do not care, but
   * have no Green's function with Dirichlet conditions, since what flows in must flow out.
   */
  vtkSetClampMacro(Boundary, int, Neumann, Dirichlet);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToNeumann() { this->SetBoundary(Neumann); }
  void SetBoundaryToDirichlet() { this->SetBoundary(Dirichlet); }
  const char* GetBoundaryAsString() const;
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay first, without a change of the surface or its
   * points. It makes results better on meshes with long or obtuse triangles. Default off.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Most bytes that the factorization and the results may take. Default 0, which stands for 70 % of
   * the memory that is free at that time, for what is not there yet. Some 1 to 2 KiB per point for
   * the factorization, and 8 bytes for each source, are usual.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * Name of the point array with the results. An array of this name in the input is replaced in the
   * output.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * How many factorizations this filter has done: one for a new mesh, Boundary or
   * IntrinsicDelaunay, none for other sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * About how many bytes are kept between updates; zero before the first one.
   */
  virtual vtkTypeUInt64 GetMemorySize() const;

protected:
  /**
   * With the default name of the result array.
   */
  explicit vtkSpectralAlgorithm(const std::string& resultArrayName);
  ~vtkSpectralAlgorithm() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

  /**
   * What is to be factorized.
   */
  virtual dgg::PoissonOptions GetPoissonOptions() const;

  ///@{
  /**
   * For filters that can choose sources themselves, or need them elsewhere than they are given:
   * whether there may be none, how many there will be on a surface that is ready to be factorized,
   * and which (the callback reports the progress and says whether to stop). By default sources are
   * needed, and used as they are.
   */
  virtual bool CanChooseSources() const { return false; }
  virtual std::size_t CountSources(const dgg::PoissonSolver& solver, std::size_t given) const;
  virtual dgg::Status ChooseSources(const dgg::PoissonSolver& solver,
    const std::function<bool(double)>& progress, std::vector<dgg::SurfacePoint>& sources) const;
  ///@}

  /**
   * Bytes that ComputeValues() takes at one time, besides its results.
   */
  virtual double EstimateWorkingMemory(const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const = 0;

  /**
   * Set the outputs of the task, for each source. Returns an error, which is shown to the user, or
   * that the task's Progress asked to stop. May throw.
   */
  virtual dgg::Status ComputeValues(vtkDGGSpectralTask& task) = 0;

private:
  vtkSpectralAlgorithm(const vtkSpectralAlgorithm&) = delete;
  void operator=(const vtkSpectralAlgorithm&) = delete;

  vtkDGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  static vtkDGGSourceSet GetTargets(vtkInformationVector** inputVector);

  std::vector<vtkIdType> SourceIds;
  double ProjectionTolerance;
  int Boundary;
  bool IntrinsicDelaunay;
  std::string ResultArrayName;
  std::unique_ptr<vtkDGGPoissonKeeper> Keeper;
};

#endif
