// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpectralAlgorithm
 * @brief   base class of filters that solve Poisson equations for sources on a surface
 *
 * <b>Input and output</b>. Port 0 takes the surface. Sources are point ids (SetSourceIds()) and the
 * points of the optional port 1 (SetSourceConnection()), projected to the closest point of the
 * surface and numbered from 0, ids first. Output 0 is the input, in the same order, plus a point
 * array (double) with one component per source, which becomes the active scalars. Output 1
 * (GetEvaluation()) has the points of the optional port 2 (SetEvaluationConnection()) with the same
 * array: the values at the closest points of the surface.
 *
 * <b>Guarantee and cost</b>. Linear finite elements (cotangents) yield a sparse matrix, which is
 * factorized once and kept until the mesh, Boundary or IntrinsicDelaunay changes; each source takes
 * one or two solves. Edges with more than two triangles connect all of them. Components, connected
 * through edges or shared points, are independent of each other. An update can be aborted between
 * the steps of the work; the factorization is one step.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm, and
 *  - no source, unless the filter selects sources; a source id out of range, or of a point that
 *    no polygon uses; a source or evaluation point that is not finite or beyond
 *    ProjectionTolerance;
 *  - an empty ResultArrayName;
 *  - triangles that are nearly all too thin for double precision, about a million times as long
 *    as high; if only components of near-zero area are too thin, a source, site or mass on such a
 *    component;
 *  - a factorization and results beyond MemoryLimit: usually 1 to 2 KiB per point, and 8 bytes
 *    per point and source.
 *
 * The module page is Filters/Spectral/README.md.
 *
 * @sa vtkDiscreteGreensFunction vtkBiharmonicDistance vtkHarmonicBSpline
 */

#ifndef vtkSpectralAlgorithm_h
#define vtkSpectralAlgorithm_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <string> // For array names
#include <vector> // For source ids

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSpectralAlgorithm : public vtkGeodesicAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSpectralAlgorithm, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sources by point id of the input. None by default; ids may repeat, an id out of range is an
   * error of the update. Python takes any sequence of integers. A null list removes all; the i-th
   * id is -1 if there is none.
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
   * Further surface points at which values are evaluated: the points of a vtkPolyData on input
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
   * Largest distance of a point of port 1 or 2 from the surface, as a fraction of the diagonal of
   * the surface's bounding box; a farther point is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  /**
   * Conditions at the boundary of the surface.
   */
  enum BoundaryType
  {
    Neumann = 0,  ///< no flow through the boundary
    Dirichlet = 1 ///< functions are 0 on the boundary
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
   * If on, edges are first flipped until they are Delaunay, which improves results on long or
   * obtuse triangles. The surface does not change. Default off.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Name of the point array with the results, which replaces an array of the input. Not empty.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * Returns the number of factorizations so far: one for a new mesh, Boundary or IntrinsicDelaunay,
   * none for other sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Returns the approximate number of bytes that are kept between updates; 0 before the first
   * update.
   */
  virtual vtkTypeUInt64 GetMemorySize() const;

protected:
  /**
   * Constructs a filter with the default name of its result array.
   */
  explicit vtkSpectralAlgorithm(const std::string& resultArrayName);
  ~vtkSpectralAlgorithm() override = default;

private:
  vtkSpectralAlgorithm(const vtkSpectralAlgorithm&) = delete;
  void operator=(const vtkSpectralAlgorithm&) = delete;

  friend class DGGSpectralInternals;

  std::vector<vtkIdType> SourceIds;
  double ProjectionTolerance = 0.01;
  int Boundary = Neumann;
  bool IntrinsicDelaunay = false;
  std::string ResultArrayName;
};

#endif
