// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDiscreteGreensFunction
 * @brief   Green's functions of points anywhere on a surface
 *
 * The Green's function g of a source x solves -Laplace g = delta(x) - 1 / area: a unit flows in at
 * the source and leaves evenly. Next to x it grows like -log(d) / (2 pi), d the distance from x.
 * For -Laplace u = f, u(x) is mean(u) + the integral of g f.
 *
 * With Order BiLaplace it is that of the bi-Laplacian, q with Laplace^2 q = delta(x) - 1 / area,
 * the integral of g(x, z) g(z, y) over z. It is finite, smooth but for d^2 log(d) / (8 pi) next to
 * x, and grows like an area; for Laplace^2 u = f, u(x) is mean(u) + the integral of q f. What
 * follows holds for both, but PoleValue and SignConvention do not matter to q, which is positive at
 * x.
 *
 * <b>Input and output</b>. Those of vtkSpectralAlgorithm; the result is `GreensFunction`, one
 * component per source, without a unit and independent of scale (an area with BiLaplace). It is
 * that of the component of its source, with mean 0, and 0 in other components. With Dirichlet
 * conditions 1 / area is left out, and g is 0 on the boundary (with BiLaplace, Laplace q as well).
 * Evaluation points see the logarithm exactly. At the source see PoleValue.
 *
 * <b>Guarantee and cost</b>. By Method; h is the edge length:
 *  - SingularitySubtraction subtracts the logarithm of the geodesic distance up to a radius and
 *    solves for the smooth rest. Errors fall like h^2 with the radius fixed, but like h within a
 *    few edges of a boundary, and where shortest paths meet close to the source; symmetric up to
 *    its errors.
 *  - Interpolated weights the functions of the corners of the face: the finite element solution,
 *    with errors like h next to the source; symmetric.
 *  - Localized is Interpolated corrected around the source by exact distances, as in the thesis;
 *    for comparison, as it is no better.
 *  - Vertex takes the corner with the largest barycentric coordinate that is not on a Dirichlet
 *    boundary.
 *
 * With BiLaplace all but Vertex are second order, SingularitySubtraction at the source as well.
 *
 * Where a method does not work around a source, as on triangles about as large as the radius,
 * Interpolated takes its place with a warning, see GetUsedMethod(). Eight functions are solved for
 * at a time, on all threads; SingularitySubtraction takes a local exact distance field besides.
 * BiLaplace takes one more solution.
 *
 * <b>Errors</b>. Besides those of vtkSpectralAlgorithm: Dirichlet conditions and a source that lies
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
 * <b>Source</b>. Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans.
 * Graph. 29(3), 2010, section 3 (Vertex); Z. Fang, "Discrete Geodesic Graphs", PhD thesis, Nanyang
 * Technological University, 2019, chapter 4 (Localized).
 *
 * @sa vtkSpectralAlgorithm vtkBiharmonicDistance vtkHarmonicBSpline
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
   * Of which operator, see above.
   */
  enum OrderType
  {
    Laplace = 1,
    BiLaplace = 2
  };

  ///@{
  /**
   * Of which operator. Default Laplace.
   */
  vtkSetClampMacro(Order, int, Laplace, BiLaplace);
  vtkGetMacro(Order, int);
  void SetOrderToLaplace() { this->SetOrder(Laplace); }
  void SetOrderToBiLaplace() { this->SetOrder(BiLaplace); }
  const char* GetOrderAsString() const;
  ///@}

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
   * Value of SingularitySubtraction at the source itself. Default CellAverage, which grows like
   * -log(h) / (2 pi) with the edge length h. Other methods have finite values there.
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
   * Weights of the points in the mean that is 0, and in what leaves. Default Area.
   */
  vtkSetClampMacro(Weighting, int, Area, Uniform);
  vtkGetMacro(Weighting, int);
  void SetWeightingToArea() { this->SetWeighting(Area); }
  void SetWeightingToUniform() { this->SetWeighting(Uniform); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Distance from the source up to which SingularitySubtraction subtracts the logarithm, in units
   * of the coordinates. Default 0: 0.28 times the root of the component's area (up to 0.35 on
   * coarse meshes), or 48 mean edges, less where shortest paths meet from different sides.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Whether SingularitySubtraction solves for points of the surface only, keeps these columns (4
   * bytes per point each, within MemoryLimit) and interpolates the smooth part in faces. Errors are
   * several times as large; later sources in the same faces cost one distance each. Default off.
   */
  vtkSetMacro(InterpolateRegularPart, bool);
  vtkGetMacro(InterpolateRegularPart, bool);
  vtkBooleanMacro(InterpolateRegularPart, bool);
  ///@}

  ///@{
  /**
   * Method (MethodType) of a source of the last update, -1 without, and radius of its logarithm, 0
   * without.
   */
  int GetUsedMethod(vtkIdType source) const;
  double GetUsedRadius(vtkIdType source) const;
  ///@}

  /**
   * Whether shortest paths meet from different sides close to a source of the last update (within
   * ten mean edges, or Radius): errors of SingularitySubtraction then fall like the edge length.
   */
  bool IsNearRidge(vtkIdType source) const;

  /**
   * Columns that InterpolateRegularPart keeps for this mesh.
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
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

private:
  vtkDiscreteGreensFunction(const vtkDiscreteGreensFunction&) = delete;
  void operator=(const vtkDiscreteGreensFunction&) = delete;

  struct vtkInternals;

  void WarnOfRemarks();

  int Order;
  int Method;
  int SignConvention;
  int PoleValue;
  int Weighting;
  double Radius;
  bool InterpolateRegularPart;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
