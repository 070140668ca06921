// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeatGeodesicDistance
 * @brief   approximate distances along a surface by the heat method
 *
 * Heat flows from the sources for a short time; distances are what has the direction of its
 * gradient everywhere. Two sparse linear systems are factorized first, and kept until the mesh or
 * a property that matters to them changes; a query then is two substitutions. The distances are
 * smoother than the true ones, with rounded ridges.
 *
 * Nothing bounds the error, which is as large as edges are long beside the features of the surface.
 * Mean relative errors against vtkExactGeodesicDistance on scans and parts of machines were 0.5 to
 * 2.2 % with 10 000 points and more, 2 to 5 % with 1000, 5 to 9 % with 150, the largest ones 20 to
 * 70 %, close to the source. On coarse meshes vtkDGGFastMarchingDistance is several times
 * better, and vtkExactGeodesicDistance takes milliseconds. For distances within a known error, with
 * queries of about the same time, see vtkDGGDistance.
 *
 * <b>Not for long triangles</b>, where no flip mends them; a larger TimeStepFactor helps. Errors
 * relative to exact distances, of all points from 10 of them, in percent; tau is the median
 * anisotropy (GetMedianAnisotropy()):
 *
 * | surface                            | points | tau  | mean | 99.9 % | largest |
 * |------------------------------------|-------:|-----:|-----:|-------:|--------:|
 * | scan (bunny)                       | 34 835 | 1.42 |  1.1 |    8.3 |      25 |
 * | scan (gargoyle)                    | 24 992 | 1.51 |  2.2 |    7.1 |      38 |
 * | part, even triangles (fandisk)     |   6475 | 1.39 |  1.1 |    9.2 |      31 |
 * | part, long triangles (TR12J_cad)   | 13 441 | 1.91 |  2.4 |     13 |      53 |
 * | fine long triangles (blade_aniso)  |   8231 | 6.10 |  1.1 |     13 |      20 |
 * | part, none inside (psu_cover)      |   1351 | 4.65 |  7.5 |     39 |      85 |
 * | part, none inside (z_bar_clamp)    |    338 | 6.19 |  8.2 |     76 |      89 |
 *
 * Above a tau of 3 there is a QualityWarning: no scan has that, and below it only surfaces of 300
 * points had means above 6 %. A mesh with enough points may be good all the same.
 *
 * Inputs, sources, results and errors are those of vtkGeodesicDistanceAlgorithm; an error besides
 * these is a TimeStepFactor outside of 1e-6 to 1e6, factorizations that would take more memory than
 * MemoryLimit, and a source on the boundary when Boundary is Dirichlet. MaximumDistance saves no
 * time here. Sources inside faces and edges, and sources with different initial distances, are
 * allowed: the heat of a source falls with its initial distance o like exp(-o / sqrt(t)), t the
 * time of the flow. The nearest source is found by going down the distances.
 *
 * The surface may be any set of triangles. An update can be stopped between the parts of the work
 * only, since a factorization cannot be interrupted.
 *
 * K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat: a new approach to computing distance
 * based on heat flow", ACM Trans. Graph. 32(5), 2013.
 *
 * @sa vtkGeodesicDistanceAlgorithm vtkDGGFastMarchingDistance vtkDGGDistance
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
   * The time of the flow, in units of the square of the mean edge length (of each component of the
   * surface, after flips). A larger one smooths the distances. Default 1; in [1e-6, 1e6], of which
   * 0.5 to 10 is of use: on meshes with a mean error of 1.6 % at 1, it is 9 to 12 % at 0.01 and at
   * 100, and 15 to 24 % at the ends.
   */
  vtkSetMacro(TimeStepFactor, double);
  vtkGetMacro(TimeStepFactor, double);
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay first, without a change of the surface, its
   * points or its distances. It makes the results better on meshes with long or obtuse triangles;
   * without it, those on sheets of obtuse triangles 20 times as long as wide mean nothing. Default
   * on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * What heat does at the boundary. Default Neumann, as in other implementations. Average costs a
   * third factorization. Surfaces without a boundary do not care.
   */
  vtkSetClampMacro(Boundary, int, Neumann, Average);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToNeumann() { this->SetBoundary(Neumann); }
  void SetBoundaryToDirichlet() { this->SetBoundary(Dirichlet); }
  void SetBoundaryToAverage() { this->SetBoundary(Average); }
  const char* GetBoundaryAsString() const;
  ///@}

  ///@{
  /**
   * Most bytes that the factorizations may take. Default 0, which stands for 70 % of the memory
   * that is free at that time, for those that are not there yet. Looked at only when there is
   * something to allocate. Some 1 to 2 KiB per point is usual.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  /**
   * About how many bytes are held by the factorizations and what they are made from. Zero before
   * there are any, but after an update that was stopped in the middle of them.
   */
  vtkTypeUInt64 GetMemorySize() const;

  /**
   * How many factorizations this filter has done. Two for a new mesh, one for another
   * TimeStepFactor, none for other sources.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Whether most triangles of the last update's mesh are long, with a median of the anisotropy (see
   * GetMedianAnisotropy()) above 3: then distances may be far off, see above. A warning says so
   * once for each mesh.
   */
  vtkGetMacro(QualityWarning, bool);

protected:
  vtkHeatGeodesicDistance();
  ~vtkHeatGeodesicDistance() override;

  dgg::Status CheckProperties() const override;
  dgg::Status ComputeDistances(vtkDGGDistanceTask& task) override;
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
