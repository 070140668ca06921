// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceEarthMoversDistance
 * @brief   least cost of moving one distribution to another within a surface
 *
 * The cost is mass times the length of its way on the surface: the Wasserstein distance W1, also
 * called earth mover's distance. Between two unit masses it is their geodesic distance; unlike
 * differences of values point by point, it measures how far apart two distributions are that do not
 * overlap.
 *
 * <b>Distributions.</b> Input port 0 takes the surface (vtkPolyData). Each distribution is the sum
 * of what is given of
 *  - a point array of the surface (SetFromArrayName(), SetToArrayName()): densities, mass per area,
 *    which are integrated over the surface, or masses of points (ArrayMeaning);
 *  - masses at the points of a vtkPolyData on the optional input port 1 (SetFromData()) or 2
 *    (SetToData()), which may lie anywhere on the surface: each is projected to the closest point
 *    of the surface, and shared by the corners of its face. Their masses are in the point array
 *    that MassArrayName names; without a name each is 1.
 *
 * With Normalize, which is the default, both are scaled to the mass 1 first, and the distance is a
 * length: how far mass is moved on average. Otherwise both must have the same mass, to 1e-6 of it,
 * and the distance is mass times length.
 *
 * <b>Outputs.</b> The input, its points, cells and arrays unchanged and in the same order, plus
 *  - `EarthMoversDistance`, a field array with one number, the cost of the best flow found, and
 *    `EarthMoversLowerBound`: no flow that is constant in each triangle costs less;
 *  - `EarthMoversPotential`, a point array that becomes the active scalars: what proves the lower
 *    bound, a length. Its slope is at most 1, mass goes down it; 0 at points without a polygon;
 *  - `EarthMoversFlow`, a cell array that becomes the active vectors: mass per length and its
 *    direction, constant in each triangle; means over the triangles of larger polygons, 0 for other
 *    cells. Not with IntrinsicDelaunay, whose triangles are not those of the surface.
 *
 * <b>Method.</b> The integral of the length of flows is minimized over all that are constant in
 * each triangle and have the right divergence, with nothing through boundaries, by an interior
 * point method: each iteration factorizes a matrix as large as that of a Poisson equation. It ends
 * when cost and lower bound differ by not more than Tolerance of the cost, which takes 7 to 50
 * iterations on most meshes, or after MaximumNumberOfIterations with a warning; GetGap() is what is
 * left. The flow is one of those that cost least, so it may go by one triangle and leave out the
 * next one, as streams do. The matrix of the Poisson equation is that of vtkSpectralAlgorithm:
 * factorized once, kept until the mesh changes. It takes any triangles. Results do not depend on
 * the number of threads.
 *
 * <b>Accuracy.</b> The bounds are those of flows that are constant in each triangle. How far their
 * optimum is from the distance on the surface depends on the mesh, not on iterations. Between two
 * points of the surface it is never above the geodesic distance. Of 30 pairs of points the worst
 * were 0.2 to 0.5 % below on fine parts of machines and scans, 1 to 3 % on coarser meshes, 9 to 15
 * % on parts without points inside their sides, of which IntrinsicDelaunay takes away a part; the
 * means 0.1 to 0.7 %, and 2 to 4 % on these parts. Masses inside of triangles are shared by the
 * corners: nothing closer than that can be distinguished.
 *
 * Components, connected through edges or shared points, must each have the same mass in both, to
 * 1e-6 of the whole. Differences below that, as of sums of floats, are taken off the second one.
 * With MergeCoincidentPoints, masses of coincident points are added up, and the density is that of
 * the first one.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - a distribution of which nothing is given; a named array that is missing, or is not of one
 *    number per point; a density or mass that is negative or not finite;
 *  - different masses of the whole, unless they are normalized, or within a component; a
 *    distribution without mass, which cannot be normalized;
 *  - a point of port 1 or 2 that is not finite, or farther from the surface than
 *    ProjectionTolerance;
 *  - a ProjectionTolerance or Tolerance that is negative or not a number;
 *  - a factorization and results that would take more memory than MemoryLimit.
 *
 * An update can be stopped between iterations and between the parts of the factorization.
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
 * J. Solomon, R. Rustamov, L. Guibas, A. Butscher, "Earth mover's distances on discrete surfaces",
 * ACM Trans. Graph. 33(4), 2014, section 4; there the flow's part without divergence is spanned by
 * few eigenfunctions, here it is any.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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
class vtkDGGPoissonKeeper;
struct vtkDGGMassOrigin;

class VTKDGGFILTERSSPECTRAL_EXPORT vtkSurfaceEarthMoversDistance : public vtkGeodesicAlgorithm
{
public:
  static vtkSurfaceEarthMoversDistance* New();
  vtkTypeMacro(vtkSurfaceEarthMoversDistance, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The point arrays of the surface with the distributions. Default none; null and "" stand for
   * none.
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
   * Masses anywhere on the surface: the points of a vtkPolyData on input port 1 (From) and 2 (To);
   * cells are not used. Null removes them.
   */
  void SetFromConnection(vtkAlgorithmOutput* output);
  void SetFromData(vtkPolyData* points);
  void SetToConnection(vtkAlgorithmOutput* output);
  void SetToData(vtkPolyData* points);
  ///@}

  ///@{
  /**
   * The point array of ports 1 and 2 with the masses. Default none: each point has the mass 1.
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
   * Most iterations. Default 200, a limit that is seldom reached: a warning says when it was before
   * Tolerance. With 0, the flow is the gradient of a function, which is spread out: its cost is a
   * quick upper bound, and there is no warning.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * How close distance and lower bound are in the end, relative to the distance. Default 0.01; must
   * not be negative. Below 1e-8 it is as 1e-8.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
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

  ///@{
  /**
   * Whether to flip edges until they are Delaunay first, without a change of the surface or its
   * points. It makes results better on meshes with long or obtuse triangles; there is no array of
   * the flow then. Default off.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Most bytes that the factorization, the flow and the results may take. Default 0, which stands
   * for 70 % of the memory that is free at that time, for what is not there yet. Some 2 KiB per
   * point are usual.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * What the last update has found, as in the field data; NaN when it has not found anything.
   */
  vtkGetMacro(Distance, double);
  vtkGetMacro(LowerBound, double);
  ///@}

  /**
   * How far Distance may be above the optimum, relative to it: (Distance - LowerBound) / Distance;
   * 0 for nothing to move, NaN when the last update has not found anything.
   */
  vtkGetMacro(Gap, double);

  /**
   * How many iterations the last update has done.
   */
  vtkGetMacro(NumberOfIterations, int);

  /**
   * How many factorizations this filter has done: one for a new mesh or IntrinsicDelaunay, none for
   * other distributions.
   */
  int GetNumberOfFactorizations() const;

  /**
   * About how many bytes are kept between updates; zero before the first one.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkSurfaceEarthMoversDistance();
  ~vtkSurfaceEarthMoversDistance() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkSurfaceEarthMoversDistance(const vtkSurfaceEarthMoversDistance&) = delete;
  void operator=(const vtkSurfaceEarthMoversDistance&) = delete;

  vtkDGGMassOrigin GetOrigin(int which, vtkInformationVector** inputVector) const;
  void ForgetResults();
  void SetResults(const vtkDGGContext& context, vtkPolyData* output, double total,
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
  std::unique_ptr<vtkDGGPoissonKeeper> Keeper;
};

#endif
