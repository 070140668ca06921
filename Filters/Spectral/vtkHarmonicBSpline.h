// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHarmonicBSpline
 * @brief   smooth basis functions of sites on a surface; interpolation; Poisson equations
 *
 * <b>Input and output</b>. Same as for vtkSpectralAlgorithm, whose sources are the sites. Without
 * any, NumberOfSites sites are selected. Point arrays:
 *  - `HarmonicBSpline` (double, one component per site, without a unit), with GenerateBasis;
 *  - `Cell` (vtkIdType), with Order Harmonic: the site of each point, or of the corner closest to
 *    an evaluation point; -1 without a polygon, or on a Dirichlet boundary;
 *  - `PoissonSolution` (double), with RightHandSideArrayName;
 *  - `Interpolation` (double, components as in the array of values), with SiteValuesArrayName.
 *
 * With Dirichlet conditions functions, solutions and, with Order Biharmonic, their Laplacians are 0
 * on the boundary, whose points are in no cell.
 *
 * <b>Guarantee and cost</b>. See Order and the properties of the arrays. A basis or interpolation
 * takes one solve per site, two with Order Biharmonic. Interpolating the values takes up to four
 * times as many again, per component of the interpolation and, with Order Biharmonic, per site of
 * the basis, and a dense matrix of the sites: suitable for some thousand sites. Memory is 8 bytes
 * per point and site for a basis, and 32 bytes per pair of sites for the matrix.
 *
 * <b>Errors</b>. All errors of vtkSpectralAlgorithm and of the module page,
 * Filters/Spectral/README.md; two sites at the same point; a component without a site; with Order
 * Biharmonic, more sites than corners of the triangles that contain them; array names that are
 * empty or equal; a site on a Dirichlet boundary; equations of cells that cannot be solved to 1e-8,
 * values of sites that cannot be met to 1e-9 of their differences.
 *
 * <b>Source</b>. P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines", ACM Trans.
 * Graph. 31(4), 2012, whose biharmonic functions span the same space; Z. Fang, "Discrete geodesic
 * graphs", PhD thesis, Nanyang Technological University, 2019, chapter 4 (coefficients of opposite
 * sign) and 6.2.1; interpolation: G. Wahba, "Spline interpolation and smoothing on the sphere",
 * SIAM J. Sci. Stat. Comput. 2(1), 1981.
 * @sa vtkDiscreteGreensFunction vtkGeodesicVoronoi vtkGeodesicSampler
 */

#ifndef vtkHarmonicBSpline_h
#define vtkHarmonicBSpline_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkSpectralAlgorithm.h"

#include <string> // For array names

class VTKDGGFILTERSSPECTRAL_EXPORT vtkHarmonicBSpline : public vtkSpectralAlgorithm
{
public:
  static vtkHarmonicBSpline* New();
  vtkTypeMacro(vtkHarmonicBSpline, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Kinds of functions.
   */
  enum OrderType
  {
    Harmonic = 1,  ///< functions of Voronoi cells
    Biharmonic = 2 ///< smoother, for values that are given at few positions
  };

  ///@{
  /**
   * Kind of functions. Default Harmonic. Functions sum to 1, with Dirichlet conditions only away
   * from the boundary.
   *
   * Harmonic: points belong to the geodesic Voronoi cells of the sites. The function of site j is
   *
   *     psi_j(x) = A_j / A + sum over cells i of c_ij (g_j(x) - g_i(x)),
   *
   * with the areas A_j of cell and A of component, the mean g_j of the Green's function over cell
   * j, and c_ij the length of the border of two cells over the distance of their sites; with
   * Dirichlet conditions without A_j / A. It has the mean A_j / A and vanishes within a few cells.
   * If all points are sites, it interpolates. On sheared or obtuse triangles values may be far
   * outside [0, 1], which IntrinsicDelaunay corrects; sums and solutions remain correct. Sites of
   * port 1 move to the closest corner of their triangle.
   *
   * Biharmonic: sums c + sum_j w_j q_j with sum_j w_j = 0 (with Dirichlet conditions without c),
   * where q_j is the Green's function of the bi-Laplacian at site j. The function of site j is 1
   * there and 0 at the other sites. Sums have the least integral of (Laplace u)^2 of all functions
   * with their values at the sites. Sites do not move.
   */
  vtkSetClampMacro(Order, int, Harmonic, Biharmonic);
  vtkGetMacro(Order, int);
  void SetOrderToHarmonic() { this->SetOrder(Harmonic); }
  void SetOrderToBiharmonic() { this->SetOrder(Biharmonic); }
  const char* GetOrderAsString() const;
  ///@}

  ///@{
  /**
   * Number of sites that are selected if none is given, each as far as possible from earlier ones
   * along edges. Default 20, at least 1. The number is raised to one per component and limited to
   * one per point that has a polygon and is not on a Dirichlet boundary.
   */
  vtkSetClampMacro(NumberOfSites, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSites, int);
  ///@}

  ///@{
  /**
   * Point array of the surface with the right-hand side f: one finite number per point. Default
   * none; null and "" mean none. The array `PoissonSolution` is u = sum_j lambda_j psi_j with
   * -Laplace u = f, f averaged over cells; its error is of second order in the size of cells. With
   * Order Biharmonic it is u with Laplace^2 u = f, independent of sites. The mean is 0 in
   * components without a Dirichlet boundary. With Neumann conditions a sum of f in a component
   * other than 0 is balanced evenly over the component, with a warning above 1e-6 of the sum of
   * absolute values (densities: 1e-2).
   */
  vtkDGGStringMacro(RightHandSideArrayName);
  ///@}

  /**
   * Meaning of the right-hand side.
   */
  enum RightHandSideMeaningType
  {
    Density = 0,   ///< values per area
    Integrated = 1 ///< integrals over the neighborhood of each point
  };

  ///@{
  /**
   * Meaning of the right-hand side. Default Density. At merged points integrated sources are added,
   * and the first density is used.
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
   * that are its points or are selected; of port 1 for sites from there. Other points of the array
   * are ignored. Default none; null and "" mean none. The array `Interpolation` has these values at
   * the sites up to 1e-9 of their differences, and reproduces constants. With Order Biharmonic,
   * errors are of fourth order in the distance of sites for smooth functions, and values may exceed
   * the values at sites; with Order Harmonic errors are of second order, with bumps at sites.
   * Nothing flows through a Neumann boundary, so that slopes flatten close to it.
   */
  vtkDGGStringMacro(SiteValuesArrayName);
  ///@}

  ///@{
  /**
   * Names of the point arrays with sites, solution and interpolation. Defaults "Cell",
   * "PoissonSolution" and "Interpolation"; not empty, different from each other and from
   * ResultArrayName.
   */
  vtkDGGStringMacro(CellArrayName);
  vtkDGGStringMacro(SolutionArrayName);
  vtkDGGStringMacro(InterpolationArrayName);
  ///@}

  ///@{
  /**
   * If on, add the array with the functions of all sites. Turning it off saves the memory of that
   * array for an interpolation or a solution, and with Order Biharmonic half of the time; the last
   * array then becomes the active scalars. Default on.
   */
  vtkSetMacro(GenerateBasis, bool);
  vtkGetMacro(GenerateBasis, bool);
  vtkBooleanMacro(GenerateBasis, bool);
  ///@}

  ///@{
  /**
   * If on, functions and solutions of Order Harmonic at evaluation points come from Green's
   * functions of these points, without kinks at edges, at one solve each; if off, they are linear
   * in triangles. Errors are similar; where cells are single points, functions do not interpolate.
   * An error with Dirichlet conditions and an evaluation point in a component without a boundary.
   * Default off.
   */
  vtkSetMacro(SmoothEvaluation, bool);
  vtkGetMacro(SmoothEvaluation, bool);
  vtkBooleanMacro(SmoothEvaluation, bool);
  ///@}

  ///@{
  /**
   * Sites of the last update, as point ids of the surface; -1 if there is no such site, and for
   * sites between points.
   */
  vtkIdType GetNumberOfUsedSites() const;
  vtkIdType GetUsedSite(vtkIdType site) const;
  ///@}

protected:
  vtkHarmonicBSpline();
  ~vtkHarmonicBSpline() override = default;

private:
  vtkHarmonicBSpline(const vtkHarmonicBSpline&) = delete;
  void operator=(const vtkHarmonicBSpline&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int Order = Harmonic;
  int NumberOfSites = 20;
  std::string RightHandSideArrayName;
  int RightHandSideMeaning = Density;
  std::string CellArrayName = "Cell";
  std::string SolutionArrayName = "PoissonSolution";
  std::string SiteValuesArrayName;
  std::string InterpolationArrayName = "Interpolation";
  bool GenerateBasis = true;
  bool SmoothEvaluation = false;
};

#endif
