// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHarmonicBSpline
 * @brief   smooth functions of sites on a surface: bases, interpolation, equations solved
 *
 * <b>Order Harmonic</b>. The points are partitioned into the geodesic Voronoi cells of sites. The
 * function of site j is
 *
 *     psi_j(x) = A_j / A + sum over cells i of c_ij (g_j(x) - g_i(x)),
 *
 * with A_j, A the areas of cell and component, g_j the mean of the Green's function over cell j,
 * and c_ij the length of the border between two cells by the distance of their sites.
 *
 * <b>Order Biharmonic</b>. Smoother ones, for values that are known at some places: with the
 * Green's functions q_j of the bi-Laplacian at the sites, sums c + sum_j w_j q_j with sum_j w_j =
 * 0. Of all functions with the same values at the sites they have the least integral of (Laplace
 * u)^2. That of site j is 1 there and 0 at the other sites.
 *
 * <b>Input and output</b>. Those of vtkSpectralAlgorithm, whose sources are the sites. Sites of
 * port 1 move to the nearest corner of their triangle, but not of order Biharmonic. Without any,
 * NumberOfSites are chosen, each as far as possible from those before along the edges; every
 * component gets one. Point arrays:
 *  - `HarmonicBSpline` (double, one component per site, without a unit), with GenerateBasis;
 *  - `Cell` (vtkIdType), of order Harmonic: the site of each point, or of the corner next to an
 *    evaluation point; -1 without a polygon, or with a given value;
 *  - `PoissonSolution` (double), with RightHandSideArrayName: u = sum_j lambda_j psi_j with
 *    -Laplace u = f, f averaged over cells. Of order Biharmonic, u with Laplace^2 u = f, whatever
 *    the sites. Mean 0 in components where nothing is given;
 *  - `Interpolation` (double, as many components as the array with the values), with
 *    SiteValuesArrayName: the sum of functions that has these values at the sites.
 *
 * With Neumann conditions sources whose sum in a component is not 0 are balanced evenly, with a
 * warning where that is more than 1e-6 of the sum of their sizes, for densities 1e-2. With
 * Dirichlet conditions functions and solutions are 0 on the boundary, its points are in no cell,
 * and A_j / A and c are left out. Of order Biharmonic the same holds for Laplace u.
 *
 * <b>Guarantee and cost</b>. Harmonic functions sum to 1 (with Dirichlet conditions only away from
 * the boundary), have the mean A_j / A, and vanish within a few cells; with all points as sites
 * they interpolate. Errors of solutions fall like the square of the size of cells. On sheared or
 * obtuse triangles values may leave [0, 1] by far, which IntrinsicDelaunay mends; sums and
 * solutions remain right. Biharmonic functions sum to 1 as well.
 *
 * Interpolation has the values of sites to 1e-9 of their differences, or there is an error;
 * constants are constants. Of order Biharmonic errors fall like the fourth power of the distance of
 * sites where functions are smooth, and values may go beyond those of sites. Through a Neumann
 * boundary nothing flows, so that slopes flatten close to it. Of order Harmonic errors fall like
 * the square, and there are bumps at sites.
 *
 * With GenerateBasis or SiteValuesArrayName a substitution per site, of order Biharmonic two. To
 * meet values takes as many again for each function and step of refinement, of which there are four
 * at most: for each component of the interpolation, and of order Biharmonic for each site with
 * GenerateBasis. For these a dense matrix of sites is factorized: some thousand sites will do.
 * Memory is 8 bytes per point and site with GenerateBasis, and where there is such a matrix 32
 * bytes per pair of sites.
 *
 * <b>Errors</b>. Besides those of vtkSpectralAlgorithm: two sites at the same point; of order
 * Biharmonic more sites than corners of the triangles that hold them, as more than three in a
 * triangle or two on an edge, where functions or an interpolation are asked for; a component
 * without a site; Dirichlet conditions and a site on the boundary; a right-hand side that is
 * missing, has several components or is not finite; values of sites that are missing, have other
 * numbers of components on the surface than on port 1, are not finite, or are so large that values
 * between them would not be; array names that are empty or the same; equations of cells that cannot
 * be solved to 1e-8, or values of sites that cannot be met; SmoothEvaluation with Dirichlet
 * conditions and an evaluation point in a component without a boundary.
 *
 * @code
 * vtkNew<vtkHarmonicBSpline> spline;
 * spline->SetInputConnection(reader->GetOutputPort());
 * spline->SetNumberOfSites(100);
 * spline->SetRightHandSideArrayName("heating"); // per area
 * spline->Update();
 * vtkPointData* data = spline->GetOutput()->GetPointData();
 * double u = data->GetArray("PoissonSolution")->GetComponent(7, 0);
 * double psi3 = data->GetArray("HarmonicBSpline")->GetComponent(7, 3);
 *
 * spline->SetOrderToBiharmonic();
 * spline->SetSourceData(stations); // places where something was measured
 * spline->SetSiteValuesArrayName("temperature");
 * spline->GenerateBasisOff();
 * spline->Update();
 * double t = spline->GetOutput()->GetPointData()->GetArray("Interpolation")->GetComponent(7, 0);
 * @endcode
 *
 * <b>Source</b>. P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines", ACM Trans.
 * Graph. 31(4), 2012, whose biharmonic functions span the same space; Z. Fang, "Discrete Geodesic
 * Graphs", PhD thesis, Nanyang Technological University, 2019, chapter 4, where coefficients have
 * the opposite sign, and 6.2.1. Interpolation: G. Wahba, "Spline interpolation and smoothing on the
 * sphere", SIAM J. Sci. Stat. Comput. 2(1), 1981.
 *
 * @sa vtkDiscreteGreensFunction vtkGeodesicVoronoi vtkGeodesicSampler
 */

#ifndef vtkHarmonicBSpline_h
#define vtkHarmonicBSpline_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkSpectralAlgorithm.h"

#include <string> // For array names
#include <vector> // For sites

class VTKDGGFILTERSSPECTRAL_EXPORT vtkHarmonicBSpline : public vtkSpectralAlgorithm
{
public:
  static vtkHarmonicBSpline* New();
  vtkTypeMacro(vtkHarmonicBSpline, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Of which functions, see above.
   */
  enum OrderType
  {
    Harmonic = 1,
    Biharmonic = 2
  };

  ///@{
  /**
   * Of which functions. Default Harmonic.
   */
  vtkSetClampMacro(Order, int, Harmonic, Biharmonic);
  vtkGetMacro(Order, int);
  void SetOrderToHarmonic() { this->SetOrder(Harmonic); }
  void SetOrderToBiharmonic() { this->SetOrder(Biharmonic); }
  const char* GetOrderAsString() const;
  ///@}

  ///@{
  /**
   * Sites that are chosen when none is given. Default 20, at least 1; at least one for each
   * component, at most one for each point with a polygon and without a given value.
   */
  vtkSetClampMacro(NumberOfSites, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSites, int);
  ///@}

  ///@{
  /**
   * Point array of the surface with the right-hand side f of -Laplace u = f, or of Laplace^2 u = f
   * of order Biharmonic. Default none; null and "" are none.
   */
  vtkDGGStringMacro(RightHandSideArrayName);
  ///@}

  /**
   * What the numbers of the right-hand side are.
   */
  enum RightHandSideMeaningType
  {
    Density = 0,   ///< per area
    Integrated = 1 ///< the integral over the surroundings of each point
  };

  ///@{
  /**
   * What the numbers of the right-hand side are. Default Density. At merged points integrated
   * sources add up, and the first density counts.
   */
  vtkSetClampMacro(RightHandSideMeaning, int, Density, Integrated);
  vtkGetMacro(RightHandSideMeaning, int);
  void SetRightHandSideMeaningToDensity() { this->SetRightHandSideMeaning(Density); }
  void SetRightHandSideMeaningToIntegrated() { this->SetRightHandSideMeaning(Integrated); }
  const char* GetRightHandSideMeaningAsString() const;
  ///@}

  ///@{
  /**
   * Point array with the values at the sites, of any number of components: of the surface for sites
   * that are its points, or that are chosen; of port 1 for sites that come from there. What other
   * points of the surface have in it does not matter. Default none; null and "" are none.
   */
  vtkDGGStringMacro(SiteValuesArrayName);
  ///@}

  ///@{
  /**
   * Names of the point arrays with sites, solution and interpolation. Defaults "Cell",
   * "PoissonSolution" and "Interpolation"; different from each other and from ResultArrayName.
   */
  vtkDGGStringMacro(CellArrayName);
  vtkDGGStringMacro(SolutionArrayName);
  vtkDGGStringMacro(InterpolationArrayName);
  ///@}

  ///@{
  /**
   * Whether there is an array with the functions of all sites. Off saves its memory where only an
   * interpolation or a solution is wanted, and of order Biharmonic half of the time; the last array
   * becomes the active scalars then. Default on.
   */
  vtkSetMacro(GenerateBasis, bool);
  vtkGetMacro(GenerateBasis, bool);
  vtkBooleanMacro(GenerateBasis, bool);
  ///@}

  ///@{
  /**
   * Whether evaluation points get functions and solutions of order Harmonic by Green's functions of
   * their own, without kinks at edges, at the cost of one each, instead of linear ones in
   * triangles. Errors are similar; where cells are single points functions do not interpolate.
   * Default off.
   */
  vtkSetMacro(SmoothEvaluation, bool);
  vtkGetMacro(SmoothEvaluation, bool);
  vtkBooleanMacro(SmoothEvaluation, bool);
  ///@}

  ///@{
  /**
   * Sites of the last update, as point ids of the surface; -1 without such a site, and for one
   * between points.
   */
  vtkIdType GetNumberOfUsedSites() const;
  vtkIdType GetUsedSite(vtkIdType site) const;
  ///@}

protected:
  vtkHarmonicBSpline();
  ~vtkHarmonicBSpline() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  bool CanChooseSources() const override { return true; }
  std::size_t CountResults(std::size_t numberOfSources) const override;
  std::size_t CountSources(const dgg::PoissonSolver& solver, std::size_t given) const override;
  dgg::Status ChooseSources(const dgg::PoissonSolver& solver,
    const std::function<bool(double)>& progress,
    std::vector<dgg::SurfacePoint>& sources) const override;
  double EstimateWorkingMemory(const dgg::PoissonSolver& solver, std::size_t numberOfSources,
    std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

private:
  vtkHarmonicBSpline(const vtkHarmonicBSpline&) = delete;
  void operator=(const vtkHarmonicBSpline&) = delete;

  int Order;
  int NumberOfSites;
  std::string RightHandSideArrayName;
  int RightHandSideMeaning;
  std::string CellArrayName;
  std::string SolutionArrayName;
  std::string SiteValuesArrayName;
  std::string InterpolationArrayName;
  bool GenerateBasis;
  bool SmoothEvaluation;
  std::vector<vtkIdType> UsedSites;
  mutable std::size_t SiteValueComponents = 0; // as CheckInputs() has found them
};

#endif
