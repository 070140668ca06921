// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceEarthMoversDistance
 * @brief   least cost of moving one distribution to another within a surface
 *
 * The cost is the sum of mass times length of path: the Wasserstein distance W1. Between two unit
 * masses it is their geodesic distance.
 *
 * <b>Input and output</b>. Port 0 takes the surface. Each distribution is the sum of a point array
 * (SetFromArrayName(), SetToArrayName()) and of masses at the points of port 1 (SetFromData()) or 2
 * (SetToData()), which are projected to the surface and divided among the corners of their face.
 * Both need the same mass in each component, up to 1e-6 of the total. At merged points masses are
 * added, and the first density is used. The output is the input plus
 *  - `EarthMoversDistance` and `EarthMoversLowerBound`, field arrays of one number: a length in
 *    units of the coordinates, without Normalize mass times length;
 *  - `EarthMoversPotential` (double), a point array and the active scalars: a length with slope
 *    at most 1 that proves the lower bound; 0 at points that no polygon uses;
 *  - `EarthMoversFlow` (double, 3 components), a cell array and the active vectors: mass per
 *    length, constant in each triangle, means in larger polygons. Not with IntrinsicDelaunay.
 *
 * <b>Guarantee and cost</b>. Cost and lower bound refer to flows that are constant in each
 * triangle. They differ by at most Tolerance, or a warning reports that MaximumNumberOfIterations
 * was reached. An interior point method takes 7 to 50 iterations on most meshes, each with a
 * factorization as large as for a Poisson equation; an update can be aborted between iterations.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm and of the module page,
 * Filters/Spectral/README.md; an empty distribution; an array that is missing or has negative or
 * not finite values.
 *
 * <b>Source</b>. J. Solomon, R. Rustamov, L. Guibas, A. Butscher, "Earth mover's distances on
 * discrete surfaces", ACM Trans. Graph. 33(4), 2014, section 4; the divergence-free part of the
 * flow is not limited to few eigenfunctions here.
 * @sa vtkBiharmonicDistance vtkGeodesicDistanceMatrix
 */

#ifndef vtkSurfaceEarthMoversDistance_h
#define vtkSurfaceEarthMoversDistance_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <string> // For array names

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSurfaceEarthMoversDistance : public vtkGeodesicAlgorithm
{
public:
  static vtkSurfaceEarthMoversDistance* New();
  vtkTypeMacro(vtkSurfaceEarthMoversDistance, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Point arrays of the surface with the distributions: one finite number per point, not negative.
   * Default none; null and "" mean none.
   */
  vtkDGGStringMacro(FromArrayName);
  vtkDGGStringMacro(ToArrayName);
  ///@}

  /**
   * Meaning of the arrays of the surface.
   */
  enum ArrayMeaningType
  {
    Density = 0, ///< mass per area
    Mass = 1     ///< mass of each point
  };

  ///@{
  /**
   * Meaning of the arrays of the surface. Default Density.
   */
  vtkSetClampMacro(ArrayMeaning, int, Density, Mass);
  vtkGetMacro(ArrayMeaning, int);
  void SetArrayMeaningToDensity() { this->SetArrayMeaning(Density); }
  void SetArrayMeaningToMass() { this->SetArrayMeaning(Mass); }
  const char* GetArrayMeaningAsString() const;
  ///@}

  ///@{
  /**
   * Masses anywhere on the surface: the points of a vtkPolyData on input port 1 (From) and 2 (To).
   * Null removes them.
   */
  void SetFromConnection(vtkAlgorithmOutput* output);
  void SetFromData(vtkPolyData* points);
  void SetToConnection(vtkAlgorithmOutput* output);
  void SetToData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * Point array of ports 1 and 2 with the masses: finite, not negative. Default none: each is 1.
   */
  vtkDGGStringMacro(MassArrayName);
  ///@}

  ///@{
  /**
   * If on, both distributions are scaled to mass 1; a distribution without mass is an error. If
   * off, both need the same mass. Default on.
   */
  vtkSetMacro(Normalize, bool);
  vtkGetMacro(Normalize, bool);
  vtkBooleanMacro(Normalize, bool);
  ///@}

  ///@{
  /**
   * Largest number of iterations, at least 0. Default 200. With 0 the flow is a gradient, whose
   * cost is a fast upper bound, without a warning.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Largest difference of cost and lower bound, relative to the cost. Default 0.01; not negative;
   * values below 1e-8 are treated as 1e-8.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Largest distance of a point of port 1 or 2 from the surface, as a fraction of the diagonal of
   * the surface's bounding box; a farther point is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
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
   * Results of the last update, as in the field data; NaN if there are none.
   */
  vtkGetMacro(Distance, double);
  vtkGetMacro(LowerBound, double);
  ///@}

  /**
   * Returns (Distance - LowerBound) / Distance, the largest relative excess of Distance over the
   * optimum; 0 if nothing is moved, NaN without a result.
   */
  vtkGetMacro(Gap, double);

  /**
   * Returns the number of iterations of the last update.
   */
  vtkGetMacro(NumberOfIterations, int);

  /**
   * Returns the number of factorizations of the Poisson equation so far: one for a new mesh or
   * IntrinsicDelaunay, none for other distributions.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Returns the approximate number of bytes that are kept between updates; 0 before the first
   * update.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkSurfaceEarthMoversDistance();
  ~vtkSurfaceEarthMoversDistance() override = default;

private:
  vtkSurfaceEarthMoversDistance(const vtkSurfaceEarthMoversDistance&) = delete;
  void operator=(const vtkSurfaceEarthMoversDistance&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  std::string FromArrayName;
  std::string ToArrayName;
  std::string MassArrayName;
  int ArrayMeaning = Density;
  bool Normalize = true;
  int MaximumNumberOfIterations = 200;
  double Tolerance = 1e-2;
  double ProjectionTolerance = 0.01;
  bool IntrinsicDelaunay = false;
  double Distance;
  double LowerBound;
  double Gap;
  int NumberOfIterations;
};

#endif
