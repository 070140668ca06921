// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeatGeodesicDistance
 * @brief   approximate distances along a surface by the heat method
 *
 * Heat flows from the sources for a short time. The distance is the function whose gradient points
 * away from the heat everywhere. It is smoother than the exact distance.
 *
 * <b>Input and output</b>. Same as for vtkGeodesicDistanceAlgorithm. The heat of a source with
 * initial distance o is proportional to exp(-o / sqrt(t)), where t is the time of the flow.
 * MaximumDistance saves no time.
 *
 * <b>Guarantee and cost</b>. Errors have no bound: on fine meshes 0.5 to 2.2 % on average, next to
 * a source 20 to 70 %, more on long triangles (QualityWarning); see Filters/Geodesic/Distances.md.
 * Two sparse systems are factorized and kept until mesh or properties change; a query takes two
 * solves. A factorization cannot be aborted.
 *
 * <b>Errors</b>. All errors of vtkGeodesicDistanceAlgorithm; factorizations beyond MemoryLimit,
 * usually 1 to 2 KiB per point; with Boundary Dirichlet, a source on the boundary.
 * @code
 * vtkNew<vtkHeatGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->Update(); // factorizes
 * distance->SetSourceIds({ 10 });
 * distance->Update(); // two solves
 * @endcode
 * <b>Source</b>. K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat: a new approach to
 * computing distance based on heat flow", ACM Trans. Graph. 32(5), 2013.
 *
 * @sa vtkDGGFastMarchingDistance vtkDGGDistance vtkExactGeodesicDistance
 */

#ifndef vtkHeatGeodesicDistance_h
#define vtkHeatGeodesicDistance_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicDistanceAlgorithm.h"

class VTKDGGFILTERSGEODESIC_EXPORT vtkHeatGeodesicDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static vtkHeatGeodesicDistance* New();
  vtkTypeMacro(vtkHeatGeodesicDistance, vtkGeodesicDistanceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Conditions for heat at the boundary of the surface.
   */
  enum BoundaryType
  {
    Neumann = 0,   ///< no heat leaves
    Dirichlet = 1, ///< the boundary has no heat
    Average = 2    ///< the mean of both flows
  };

  ///@{
  /**
   * Time of the flow, in squares of the mean edge length of each component after edge flips. Larger
   * values smooth the distances. Default 1; useful from 0.5 to 10. Outside [0.1, 100] there is a
   * warning, outside [1e-6, 1e6] an error.
   */
  vtkSetMacro(TimeStepFactor, double);
  vtkGetMacro(TimeStepFactor, double);
  ///@}

  ///@{
  /**
   * If on, edges are first flipped until they are Delaunay, which improves results on long or
   * obtuse triangles. The surface does not change. Default on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Condition for heat at the boundary. Default Neumann. Average takes a third factorization.
   */
  vtkSetClampMacro(Boundary, int, Neumann, Average);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToNeumann() { this->SetBoundary(Neumann); }
  void SetBoundaryToDirichlet() { this->SetBoundary(Dirichlet); }
  void SetBoundaryToAverage() { this->SetBoundary(Average); }
  const char* GetBoundaryAsString() const;
  ///@}

  /**
   * Returns the approximate number of bytes of the factorizations; 0 before the first update.
   */
  vtkTypeUInt64 GetMemorySize() const;

  /**
   * Returns the number of factorizations so far: two for a new mesh, one for another
   * TimeStepFactor, none for other sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * True if distances of the last update may be far off: GetMeanAnisotropy() is above 2, a source
   * is on a component of fewer than 50 triangles, or TimeStepFactor is outside [0.1, 100]. A
   * warning is reported once for each mesh and reason.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkHeatGeodesicDistance();
  ~vtkHeatGeodesicDistance() override = default;

private:
  vtkHeatGeodesicDistance(const vtkHeatGeodesicDistance&) = delete;
  void operator=(const vtkHeatGeodesicDistance&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  double TimeStepFactor = 1.0;
  bool IntrinsicDelaunay = true;
  int Boundary = Neumann;
  bool QualityWarning = false;
};

#endif
