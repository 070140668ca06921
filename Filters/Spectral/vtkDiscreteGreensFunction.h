// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDiscreteGreensFunction
 * @brief   what a unit source anywhere on a surface does everywhere else
 *
 * The Green's function g of a source x solves -Laplace g = delta(x) - 1 / area: heat, or charge,
 * flows in at the source and goes away evenly. Next to x it grows like -log(d) / (2 pi), d the
 * distance from x. With it, solutions of Poisson equations are sums: u(x) = mean(u) + the integral
 * of g f, for -Laplace u = f. It has no unit, and does not change with the size of the surface.
 *
 * Inputs, sources, outputs, the factorization and errors are those of vtkSpectralAlgorithm; the
 * result array is `GreensFunction`, one component per source.
 *
 * <b>Which function.</b> On a closed surface, and with Neumann conditions, the function is that of
 * the component of its source: the area is that of the component, the mean over it is 0, and in
 * other components, and at points that no polygon uses, the function is 0. With Dirichlet
 * conditions nothing goes away but through the boundary, where the function is 0. A source on the
 * boundary, or in a component that has none, is an error then.
 *
 * <b>Methods.</b>
 *  - SingularitySubtraction subtracts the logarithm of the geodesic distance, up to a radius, and
 *    solves for the rest, which is smooth. Errors fall like the square of the edge length, for
 *    sources inside of faces and on edges as at points, as long as the radius stays the same; on
 *    meshes with more than about 30 000 points, where it is 48 mean edges, see Radius, more slowly;
 *    like the edge length within a few edges of a boundary that the source is not on, and where
 *    shortest ways meet from different sides close to the source, as behind a spike.
 *  - Localized corrects Interpolated around the source by exact distances, as in the thesis named
 *    below. It is no better than Interpolated: for comparison.
 *  - Interpolated weights the functions of the corners of the face with barycentric coordinates:
 *    the finite element solution. Errors next to the source fall like the edge length.
 *  - Vertex takes that of the corner with the largest barycentric coordinate that is not on a
 *    Dirichlet boundary.
 *
 * On the unit sphere with 10 242 points, the relative L2 error within 0.2 of the source was 5e-5
 * (7e-6 with 163 842 points), 1e-2 for Interpolated, and 5e-2 for Vertex (the mean over sources in
 * faces). Where a method cannot be used around a source, Interpolated takes its place, with a
 * warning: see GetUsedMethod().
 *
 * <b>Symmetry.</b> With Interpolated, and with Vertex between points of the surface, g(x, y) is
 * g(y, x) up to rounding. SingularitySubtraction is symmetric up to its errors, which grow with the
 * triangles: differences were 0.03 to 0.8 % of the largest value on scans and parts of machines.
 * Where the longest sides of triangles, in the mean over the area, are more than half of the usual
 * radius, as on plates without points inside, Interpolated takes its place for all sources of that
 * component, with the warning: there neither method is accurate, differences were 6 to 12 %, errors
 * 15 to 22 %, and with Interpolated 28 to 70 %. Who needs the smaller errors more than the symmetry
 * sets Radius; better is a finer mesh.
 *
 * <b>Many sources.</b> Eight functions are solved for at a time, in several threads. With
 * InterpolateRegularPart, SingularitySubtraction solves for points of the surface only, and keeps
 * these columns; the smooth part of a source inside of a face is interpolated. Errors are several
 * times as large, a tenth of those of Interpolated or less, and later sources in the same faces
 * cost one distance each.
 *
 * At the source itself the function is infinite: see PoleValue. Between points of the surface it is
 * linear but for the logarithm, which evaluation points (input port 2) see exactly: values on
 * output port 1 are as good as those at points of the surface, close to the source as well.
 *
 * <b>Errors</b> besides those of vtkSpectralAlgorithm: Dirichlet conditions and a source that lies
 * on the boundary, or in a component without one; a Radius that is negative or not finite.
 *
 * @code
 * vtkNew<vtkDiscreteGreensFunction> greens;
 * greens->SetInputConnection(reader->GetOutputPort());
 * greens->SetSourceIds({ 0, 1000 });
 * greens->SetSourceData(points); // anywhere on the surface
 * greens->Update();
 * vtkDataArray* g = greens->GetOutput()->GetPointData()->GetArray("GreensFunction");
 * double atPoint7OfSource1 = g->GetComponent(7, 1);
 * @endcode
 *
 * Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
 * 2010, section 3 (Vertex); Z. Fang, "Discrete Geodesic Graphs", PhD thesis, Nanyang Technological
 * University, 2019, chapter 4 (Localized).
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkSpectralAlgorithm
 */

#ifndef vtkDiscreteGreensFunction_h
#define vtkDiscreteGreensFunction_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkSpectralAlgorithm.h"

#include <memory> // For the internals

class VTKDGGFILTERSSPECTRAL_EXPORT vtkDiscreteGreensFunction : public vtkSpectralAlgorithm
{
public:
  static vtkDiscreteGreensFunction* New();
  vtkTypeMacro(vtkDiscreteGreensFunction, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the function of a source is found, see above.
   */
  enum MethodType
  {
    SingularitySubtraction = 0,
    Localized = 1,
    Interpolated = 2,
    Vertex = 3
  };

  ///@{
  /**
   * How the function of a source is found. Default SingularitySubtraction.
   */
  vtkSetClampMacro(Method, int, SingularitySubtraction, Vertex);
  vtkGetMacro(Method, int);
  void SetMethodToSingularitySubtraction() { this->SetMethod(SingularitySubtraction); }
  void SetMethodToLocalized() { this->SetMethod(Localized); }
  void SetMethodToInterpolated() { this->SetMethod(Interpolated); }
  void SetMethodToVertex() { this->SetMethod(Vertex); }
  const char* GetMethodAsString() const;
  ///@}

  /**
   * The sign of the function.
   */
  enum SignConventionType
  {
    PositiveAtSource = 0, ///< -Laplace g = delta - 1 / area, as above
    NegativeAtSource = 1  ///< Laplace g = delta - 1 / area, as in parts of the literature
  };

  ///@{
  /**
   * The sign of the function. Default PositiveAtSource.
   */
  vtkSetClampMacro(SignConvention, int, PositiveAtSource, NegativeAtSource);
  vtkGetMacro(SignConvention, int);
  void SetSignConventionToPositiveAtSource() { this->SetSignConvention(PositiveAtSource); }
  void SetSignConventionToNegativeAtSource() { this->SetSignConvention(NegativeAtSource); }
  const char* GetSignConventionAsString() const;
  ///@}

  /**
   * What SingularitySubtraction gives at the source itself.
   */
  enum PoleValueType
  {
    CellAverage = 0, ///< the mean over a disk as large as a third of the triangles around the point
    InfiniteValue = 1
  };

  ///@{
  /**
   * The value at a source that is a point of the surface, or of evaluation. Default CellAverage,
   * which grows like -log(h) / (2 pi) with the edge length h. The other methods have finite values
   * there anyway.
   */
  vtkSetClampMacro(PoleValue, int, CellAverage, InfiniteValue);
  vtkGetMacro(PoleValue, int);
  void SetPoleValueToCellAverage() { this->SetPoleValue(CellAverage); }
  void SetPoleValueToInfinite() { this->SetPoleValue(InfiniteValue); }
  const char* GetPoleValueAsString() const;
  ///@}

  /**
   * What makes the sum of a function, and goes away of what flows in.
   */
  enum WeightingType
  {
    Area = 0,   ///< in proportion to the area around each point
    Uniform = 1 ///< the same for all points, as in the paper: for cells of equal size
  };

  ///@{
  /**
   * Weights of the points in the mean that is 0, and of what goes away. Default Area.
   */
  vtkSetClampMacro(Weighting, int, Area, Uniform);
  vtkGetMacro(Weighting, int);
  void SetWeightingToArea() { this->SetWeighting(Area); }
  void SetWeightingToUniform() { this->SetWeighting(Uniform); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Up to which distance from the source SingularitySubtraction takes the logarithm out, in units
   * of the coordinates. Default 0: 0.28 times the square root of the component's area (up to 0.35
   * on coarse meshes), or 48 mean edges, less where shortest ways meet from different sides before.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Whether to interpolate the smooth part of SingularitySubtraction between points of the surface,
   * see above. Sources are then looked at one after the other. Columns are kept within MemoryLimit,
   * as floats, 4 bytes per point each. Default off.
   */
  vtkSetMacro(InterpolateRegularPart, bool);
  vtkGetMacro(InterpolateRegularPart, bool);
  vtkBooleanMacro(InterpolateRegularPart, bool);
  ///@}

  ///@{
  /**
   * Of a source of the last update: the method that was used (MethodType; -1 when there is no such
   * source), and the radius of the logarithm, 0 without one.
   */
  int GetUsedMethod(vtkIdType source) const;
  double GetUsedRadius(vtkIdType source) const;
  ///@}

  /**
   * Whether shortest ways meet from different sides close to a source of the last update (within
   * ten mean edges, or Radius), as behind a spike: there errors of SingularitySubtraction fall like
   * the edge length. They are a fraction of those of Interpolated still.
   */
  bool IsNearRidge(vtkIdType source) const;

  /**
   * Columns that InterpolateRegularPart has solved for on this mesh.
   */
  vtkIdType GetNumberOfColumns() const;

  vtkTypeUInt64 GetMemorySize() const override;

protected:
  vtkDiscreteGreensFunction();
  ~vtkDiscreteGreensFunction() override;

  dgg::Status CheckProperties() const override;
  dgg::PoissonOptions GetPoissonOptions() const override;
  double EstimateWorkingMemory(const dgg::PoissonSolver& solver, std::size_t numberOfSources,
    std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(vtkDGGSpectralTask& task) override;

private:
  vtkDiscreteGreensFunction(const vtkDiscreteGreensFunction&) = delete;
  void operator=(const vtkDiscreteGreensFunction&) = delete;

  struct vtkInternals;

  void WarnOfRemarks();

  int Method;
  int SignConvention;
  int PoleValue;
  int Weighting;
  double Radius;
  bool InterpolateRegularPart;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
