// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceEarthMoversDistance
 * @brief   least cost of moving one distribution to another within a surface
 *
 * The cost is mass times the length of its path: the Wasserstein distance W1. Between two unit
 * masses it is their geodesic distance.
 *
 * <b>Input and output</b>. Port 0 takes the surface. Each distribution is the sum of a point array
 * (SetFromArrayName(), SetToArrayName()) with densities, mass per area, or masses (ArrayMeaning),
 * and of masses at the points of port 1 (SetFromData()) or 2 (SetToData()), which are projected to
 * the surface and shared by the corners of their face; the point array MassArrayName has these,
 * else each is 1. With Normalize both are scaled to the mass 1, and the distance is a length in
 * units of the coordinates; else both need the same mass, and it is mass times length. In either
 * case both need the same mass in each component, to 1e-6 of the whole. At merged points masses add
 * up, and the first density counts. The output is the input plus
 *  - `EarthMoversDistance` and `EarthMoversLowerBound`, field arrays of one number;
 *  - `EarthMoversPotential` (double), a point array and the active scalars: a length with slope at
 *    most 1 that proves the lower bound; 0 at points that no polygon uses;
 *  - `EarthMoversFlow` (double, 3 components), a cell array and the active vectors: mass per
 *    length, constant in each triangle, means in larger polygons. Not with IntrinsicDelaunay.
 *
 * <b>Guarantee and cost</b>. Both bounds are those of flows that are constant in each triangle;
 * they differ by Tolerance of the cost at most, or a warning reports that MaximumNumberOfIterations
 * was reached. Between two points of the surface the optimum is never above the geodesic distance;
 * how far it is below depends on the mesh, see the page of the module. An interior point method
 * takes 7 to 50 iterations on most meshes, each with a factorization as large as that of a Poisson
 * equation; an update can be stopped between them.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - a distribution of which nothing is given; a named array that is missing, or not of one number
 *    per point; a density or mass that is negative or not finite;
 *  - different masses of the whole without Normalize, or within a component; no mass to normalize;
 *  - a point of port 1 or 2 that is not finite, or farther from the surface than
 *    ProjectionTolerance; a ProjectionTolerance or Tolerance that is negative or NaN;
 *  - a factorization and results that take more than MemoryLimit; 2 KiB per point are usual.
 *
 * @code
 * vtkNew<vtkSurfaceEarthMoversDistance> movers;
 * movers->SetInputConnection(reader->GetOutputPort());
 * movers->SetFromArrayName("before");
 * movers->SetToArrayName("after");
 * movers->Update();
 * std::cout << "moved by " << movers->GetDistance() << " on average\n";
 * @endcode
 *
 * <b>Source</b>. J. Solomon, R. Rustamov, L. Guibas, A. Butscher, "Earth mover's distances on
 * discrete surfaces", ACM Trans. Graph. 33(4), 2014, section 4; there the part of the flow without
 * divergence is spanned by few eigenfunctions, here it is any.
 *
 * @sa vtkBiharmonicDistance vtkGeodesicDistanceMatrix
 */

#ifndef vtkSurfaceEarthMoversDistance_h
#define vtkSurfaceEarthMoversDistance_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <string> // For array names

namespace dgg
{
struct EarthMoversResult;
}
class DGGPoissonCache;
struct DGGMassOrigin;

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSurfaceEarthMoversDistance : public vtkGeodesicAlgorithm
{
public:
  static vtkSurfaceEarthMoversDistance* New();
  vtkTypeMacro(vtkSurfaceEarthMoversDistance, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Point arrays of the surface with the distributions. Default none; null and "" are none.
   */
  vtkDGGStringMacro(FromArrayName);
  vtkDGGStringMacro(ToArrayName);
  ///@}

  /**
   * What the numbers in the arrays of the surface are.
   */
  enum ArrayMeaningType
  {
    Density = 0, ///< mass per area
    Mass = 1     ///< mass of each point
  };

  ///@{
  /**
   * What the numbers in the arrays of the surface are. Default Density.
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
   * Point array of ports 1 and 2 with the masses. Default none: each is 1.
   */
  vtkDGGStringMacro(MassArrayName);
  ///@}

  ///@{
  /**
   * Whether to scale both distributions to the mass 1. Default on.
   */
  vtkSetMacro(Normalize, bool);
  vtkGetMacro(Normalize, bool);
  vtkBooleanMacro(Normalize, bool);
  ///@}

  ///@{
  /**
   * Most iterations, at least 0. Default 200. With 0 the flow is a gradient, whose cost is a quick
   * upper bound, without a warning.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Largest difference of cost and lower bound, relative to the cost. Default 0.01; not negative;
   * below 1e-8 it is as 1e-8.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How far from the surface a point of port 1 or 2 may be, as a fraction of the diagonal of the
   * surface's bounding box; farther is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
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
   * Results of the last update, as in the field data; NaN without.
   */
  vtkGetMacro(Distance, double);
  vtkGetMacro(LowerBound, double);
  ///@}

  /**
   * (Distance - LowerBound) / Distance: how far Distance may be above the optimum; 0 for nothing to
   * move, NaN without a result.
   */
  vtkGetMacro(Gap, double);

  /**
   * Iterations of the last update.
   */
  vtkGetMacro(NumberOfIterations, int);

  /**
   * Factorizations so far of the Poisson equation: one for a new mesh or IntrinsicDelaunay, none
   * for other distributions.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Bytes kept between updates, about; zero before the first one.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkSurfaceEarthMoversDistance();
  ~vtkSurfaceEarthMoversDistance() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkSurfaceEarthMoversDistance(const vtkSurfaceEarthMoversDistance&) = delete;
  void operator=(const vtkSurfaceEarthMoversDistance&) = delete;

  DGGMassOrigin GetOrigin(int which, vtkInformationVector** inputVector) const;
  void ForgetResults();
  void SetResults(const DGGContext& context, vtkPolyData* output, double total,
    const dgg::EarthMoversResult& result);

  std::string FromArrayName;
  std::string ToArrayName;
  std::string MassArrayName;
  int ArrayMeaning;
  bool Normalize;
  int MaximumNumberOfIterations;
  double Tolerance;
  double ProjectionTolerance;
  bool IntrinsicDelaunay;
  double Distance;
  double LowerBound;
  double Gap;
  int NumberOfIterations;
  std::unique_ptr<DGGPoissonCache> Cache;
};

#endif
