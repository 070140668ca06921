// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeatGeodesicDistance
 * @brief   approximate distances along a surface by the heat method
 *
 * Heat flows from the sources for a short time; distances are the function whose gradient has its
 * direction everywhere. They are smoother than the true ones.
 *
 * <b>Input and output</b>. Those of vtkGeodesicDistanceAlgorithm. MaximumDistance saves no time.
 * The heat of a source falls with its initial distance o like exp(-o / sqrt(t)), t the time of the
 * flow.
 *
 * <b>Guarantee and cost</b>. Nothing bounds the error, which grows with the edges beside the
 * features of the surface, and is large on long triangles (QualityWarning); the page of the module
 * has figures. Two sparse systems are factorized, and kept until mesh or properties change; a query
 * is two substitutions. A factorization cannot be interrupted.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicDistanceAlgorithm: a TimeStepFactor outside [1e-6,
 * 1e6]; factorizations that take more than MemoryLimit, of 1 to 2 KiB per point usually; a source
 * on the boundary when Boundary is Dirichlet.
 *
 * @code
 * vtkNew<vtkHeatGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update(); // factorizes
 * distance->SetSourceIds({ 10 });
 * distance->Update(); // two substitutions
 * @endcode
 *
 * <b>Source</b>. K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat: a new approach to
 * computing distance based on heat flow", ACM Trans. Graph. 32(5), 2013.
 *
 * @sa vtkDGGFastMarchingDistance vtkDGGDistance vtkExactGeodesicDistance
 */

#ifndef vtkHeatGeodesicDistance_h
#define vtkHeatGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

#include <memory> // For the factorizations
#include <string> // For advice

class VTKDGGFILTERSGEODESIC_EXPORT vtkHeatGeodesicDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkHeatGeodesicDistance* New();
  vtkTypeMacro(vtkHeatGeodesicDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What heat does at the boundary of the surface.
   */
  enum BoundaryType
  {
    Neumann = 0,   ///< it stays inside
    Dirichlet = 1, ///< it is cooled away
    Average = 2    ///< the mean of both flows
  };

  ///@{
  /**
   * The time of the flow, in squares of the mean edge length of each component, after flips. Larger
   * ones smooth the distances. Default 1; in [1e-6, 1e6], of which 0.5 to 10 is of use. There is a
   * warning outside of [0.1, 100].
   */
  vtkSetMacro(TimeStepFactor, double);
  vtkGetMacro(TimeStepFactor, double);
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay first, which improves results on long or obtuse
   * triangles. The surface does not change. Default on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * What heat does at the boundary. Default Neumann. Average costs a third factorization.
   */
  vtkSetClampMacro(Boundary, int, Neumann, Average);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToNeumann() { this->SetBoundary(Neumann); }
  void SetBoundaryToDirichlet() { this->SetBoundary(Dirichlet); }
  void SetBoundaryToAverage() { this->SetBoundary(Average); }
  const char* GetBoundaryAsString() const;
  ///@}

  /**
   * Bytes kept for the factorizations, about; zero before there are any.
   */
  vtkTypeUInt64 GetMemorySize() const;

  /**
   * Factorizations so far: two for a new mesh, one for another TimeStepFactor, none for other
   * sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * True if distances of the last update may be far off: GetMeanAnisotropy() is above 2, a source
   * is on a component of fewer than 50 triangles, or TimeStepFactor is outside of [0.1, 100].
   * A warning is reported once for each mesh and reason.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkHeatGeodesicDistance();
  ~vtkHeatGeodesicDistance() override;

  dgg::Status CheckProperties() const override;
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkHeatGeodesicDistance(const vtkHeatGeodesicDistance&) = delete;
  void operator=(const vtkHeatGeodesicDistance&) = delete;

  struct Preparation;

  double TimeStepFactor;
  bool IntrinsicDelaunay;
  int Boundary;
  bool QualityWarning;
  int NumberOfFactorizations; // for meshes before the last one
  std::unique_ptr<Preparation> Prepared;
};

#endif
