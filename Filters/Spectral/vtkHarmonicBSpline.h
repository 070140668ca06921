// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHarmonicBSpline
 * @brief   smooth basis functions of sites on a surface, made of Green's functions, and Poisson
 *          equations solved with them
 *
 * The points of the surface are parted into the geodesic Voronoi cells of some sites. The basis
 * function of site j is
 *
 * psi_j(x) = A_j / A + sum over cells i of c_ij (g_j(x) - g_i(x)),
 *
 * with areas A_j of cells and A of the component, g_j the mean of the Green's function (see
 * vtkDiscreteGreensFunction) over cell j, and c_ij = length of the border between two cells /
 * distance of their sites. Its Laplacian is constant in each cell. The functions sum to 1 at every
 * point, each has the mean A_j / A, and vanishes within a few cells. When every point is a site,
 * each is 1 at its site and 0 at other points; with fewer sites and round cells it is about 0.6 at
 * its site. Where triangles are sheared or obtuse, cells conduct unevenly, and values may be far
 * below 0 or above 1; sums and solutions remain right. IntrinsicDelaunay mends that. They have no
 * unit and do not change with the size of the surface.
 *
 * <b>Sites.</b> Inputs, outputs, the factorization and errors are those of vtkSpectralAlgorithm,
 * whose sources are the sites; they must be points of the surface, so those of input port 1 that
 * lie elsewhere move to the nearest corner of their triangle. Without any, NumberOfSites of them
 * are chosen, each as far as possible from those before along the edges. Every component needs a
 * site; where they are chosen, it gets one. When no component has more than one, all functions are
 * constant, and a warning says so.
 *
 * <b>Outputs</b> besides `HarmonicBSpline`, which has one component per site (8 bytes per point and
 * site; use few sites, or smaller meshes, for thousands of them):
 *  - `Cell` (vtkIdType, see CellArrayName), the site of each point; -1 at points without a polygon,
 *    or with a given value; of an evaluation point, that of the nearest corner of its triangle;
 *  - `PoissonSolution` (see SolutionArrayName), when RightHandSideArrayName is set: the function
 *    u = sum_j lambda_j psi_j with -Laplace u = f, f averaged over cells. lambda solves the
 *    equations of the cells (finite volumes). Errors fall like the square of the size of cells;
 *    when all points are sites, u is the solution of finite elements. Mean 0 in each component
 *    where nothing is given.
 *
 * At points that no polygon uses, functions and solutions are 0. Output port 1 (GetEvaluation())
 * has the same arrays, by default linear in triangles, see SmoothEvaluation.
 *
 * <b>Boundaries.</b> With Neumann conditions nothing flows through the boundary, and sources whose
 * sum in a component is not 0 are balanced in proportion to area. There is a warning where the sum
 * is more than 1e-6 of the sum of their sizes, for densities 1e-2. With Dirichlet conditions all
 * functions and solutions are 0 on the boundary, points there are in no cell and are no sites, the
 * term A_j / A is left out, and the functions sum to about 1 only away from the boundary.
 * Components without a boundary do not care.
 *
 * Among triangles of near-zero area sums are 1 only as far as the linear system can be solved (1e-5
 * on a plane with triangles of relative height 1e-6). IntrinsicDelaunay helps, and makes no c_ij
 * negative.
 *
 * <b>Errors</b> besides those of vtkSpectralAlgorithm: two sites at the same point; a component
 * without a site; Dirichlet conditions and a site on the boundary; a right-hand side that is
 * missing, has more than one component, or is not finite; array names that are empty or the same;
 * equations of cells that cannot be solved to 1e-8 (some c_ij may be negative among obtuse
 * triangles); Dirichlet conditions, SmoothEvaluation and an evaluation point in a component without
 * a boundary.
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
 * @endcode
 *
 * P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines", ACM Trans. Graph. 31(4),
 * 2012; Z. Fang, "Discrete Geodesic Graphs", PhD thesis, Nanyang Technological University, 2019,
 * chapter 4. There coefficients have the sign of a Green's function that is negative at its pole.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
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

  ///@{
  /**
   * How many sites are chosen when none is given. Default 20, at least 1. There are as many as
   * components at least, and as points with a polygon, and without a given value, at most.
   */
  vtkSetClampMacro(NumberOfSites, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSites, int);
  ///@}

  ///@{
  /**
   * The point array of the surface with the right-hand side f of -Laplace u = f. Default none; null
   * and "" stand for none.
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
   * What the numbers of the right-hand side are. Default Density. With MergeCoincidentPoints,
   * integrated sources of coincident points are added up, and the density is that of the first one.
   */
  vtkSetClampMacro(RightHandSideMeaning, int, Density, Integrated);
  vtkGetMacro(RightHandSideMeaning, int);
  void SetRightHandSideMeaningToDensity() { this->SetRightHandSideMeaning(Density); }
  void SetRightHandSideMeaningToIntegrated() { this->SetRightHandSideMeaning(Integrated); }
  const char* GetRightHandSideMeaningAsString() const;
  ///@}

  ///@{
  /**
   * Names of the point arrays with the site of each point, default "Cell", and with the solution,
   * default "PoissonSolution". They must differ from each other and from ResultArrayName.
   */
  vtkDGGStringMacro(CellArrayName);
  vtkDGGStringMacro(SolutionArrayName);
  ///@}

  ///@{
  /**
   * Whether values at evaluation points are made of their own Green's functions, with the logarithm
   * integrated over cells, instead of linear in triangles: without kinks at edges, at the cost of a
   * Green's function for each point. Errors are of the same size. Where cells are single points it
   * makes a difference: functions then do not interpolate. Default off.
   */
  vtkSetMacro(SmoothEvaluation, bool);
  vtkGetMacro(SmoothEvaluation, bool);
  vtkBooleanMacro(SmoothEvaluation, bool);
  ///@}

  ///@{
  /**
   * The sites of the last update, as ids of points of the surface; -1 when there is no such site.
   * None after an error or an abort.
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
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  bool CanChooseSources() const override { return true; }
  std::size_t CountSources(const dgg::PoissonSolver& solver, std::size_t given) const override;
  dgg::Status ChooseSources(const dgg::PoissonSolver& solver,
    const std::function<bool(double)>& progress,
    std::vector<dgg::SurfacePoint>& sources) const override;
  double EstimateWorkingMemory(const dgg::PoissonSolver& solver, std::size_t numberOfSources,
    std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(vtkDGGSpectralTask& task) override;

private:
  vtkHarmonicBSpline(const vtkHarmonicBSpline&) = delete;
  void operator=(const vtkHarmonicBSpline&) = delete;

  int NumberOfSites;
  std::string RightHandSideArrayName;
  int RightHandSideMeaning;
  std::string CellArrayName;
  std::string SolutionArrayName;
  bool SmoothEvaluation;
  std::vector<vtkIdType> UsedSites;
};

#endif
