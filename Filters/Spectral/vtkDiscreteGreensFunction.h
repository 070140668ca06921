// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDiscreteGreensFunction
 * @brief   Green's functions of points anywhere on a surface
 *
 * The Green's function g of a source x solves -Laplace g = delta(x) - 1 / area: a unit flows in at
 * the source and out evenly. Close to x it grows like -log(d) / (2 pi), where d is the distance
 * from x. The solution of -Laplace u = f is u(x) = mean(u) + the integral of g f.
 *
 * <b>Input and output</b>. Same as for vtkSpectralAlgorithm; the result is `GreensFunction`, one
 * component per source, without a unit and independent of scale (an area with Order BiLaplace). It
 * is the function of the component of its source, with mean 0, and 0 in other components. With
 * Dirichlet conditions there is no term 1 / area, and g is 0 on the boundary (with BiLaplace also
 * Laplace q). Evaluation points have the exact logarithm. At the source see PoleValue.
 *
 * <b>Guarantee and cost</b>. See Method; the module page is Filters/Spectral/README.md. All threads
 * solve for eight functions at a time. SingularitySubtraction also takes a local exact distance
 * field, BiLaplace one more solve.
 *
 * <b>Errors</b>. All errors of vtkSpectralAlgorithm; with Dirichlet conditions, a source on the
 * boundary or in a component without one.
 * @code
 * greens->SetSourceIds({ 0, 1000 });
 * greens->SetSourceData(points); // anywhere on the surface
 * greens->Update();
 * vtkDataArray* g = greens->GetOutput()->GetPointData()->GetArray("GreensFunction");
 * double atPoint7OfSource1 = g->GetComponent(7, 1);
 * @endcode
 * <b>Source</b>. Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans.
 * Graph. 29(3), 2010, section 3 (Vertex); Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang
 * Technological University, 2019, chapter 4 (Localized).
 * @sa vtkSpectralAlgorithm vtkBiharmonicDistance vtkHarmonicBSpline
 */

#ifndef vtkDiscreteGreensFunction_h
#define vtkDiscreteGreensFunction_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkSpectralAlgorithm.h"

class VTKDGGFILTERSSPECTRAL_EXPORT vtkDiscreteGreensFunction : public vtkSpectralAlgorithm
{
public:
  static vtkDiscreteGreensFunction* New();
  vtkTypeMacro(vtkDiscreteGreensFunction, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Operators.
   */
  enum OrderType
  {
    Laplace = 1,
    BiLaplace = 2
  };

  ///@{
  /**
   * Operator. Default Laplace. BiLaplace yields q with Laplace^2 q = delta(x) - 1 / area, the
   * integral of g(x, z) g(z, y) over z. It is finite, positive at x and smooth except for d^2
   * log(d) / (8 pi) close to x. The solution of Laplace^2 u = f is u(x) = mean(u) + the integral of
   * q f. PoleValue and SignConvention have no effect on q.
   */
  vtkSetClampMacro(Order, int, Laplace, BiLaplace);
  vtkGetMacro(Order, int);
  void SetOrderToLaplace() { this->SetOrder(Laplace); }
  void SetOrderToBiLaplace() { this->SetOrder(BiLaplace); }
  const char* GetOrderAsString() const;
  ///@}

  /**
   * Methods that find the function of a source; h is the edge length.
   */
  enum MethodType
  {
    SingularitySubtraction = 0, ///< logarithm of the distance plus smooth remainder; order h^2
    Localized = 1,              ///< Interpolated, corrected by exact distances as in the thesis
    Interpolated = 2, ///< weighted functions of the corners: the finite element solution; order h
    Vertex = 3        ///< function of the closest corner that is not on a Dirichlet boundary
  };

  ///@{
  /**
   * Method that finds the function of a source. Default SingularitySubtraction. Its errors are of
   * order h within a few edges of a boundary, and where shortest paths meet close to the source. If
   * a method cannot be used around a source, as on triangles about as large as Radius, Interpolated
   * replaces it with a warning, see GetUsedMethod(). With BiLaplace all methods but Vertex are of
   * second order, SingularitySubtraction at the source as well.
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
   * Signs of the function.
   */
  enum SignConventionType
  {
    PositiveAtSource = 0, ///< -Laplace g = delta - 1 / area, as above
    NegativeAtSource = 1  ///< Laplace g = delta - 1 / area, as in parts of the literature
  };

  ///@{
  /**
   * Sign of the function. Default PositiveAtSource.
   */
  vtkSetClampMacro(SignConvention, int, PositiveAtSource, NegativeAtSource);
  vtkGetMacro(SignConvention, int);
  void SetSignConventionToPositiveAtSource() { this->SetSignConvention(PositiveAtSource); }
  void SetSignConventionToNegativeAtSource() { this->SetSignConvention(NegativeAtSource); }
  const char* GetSignConventionAsString() const;
  ///@}

  /**
   * Values of SingularitySubtraction at the source.
   */
  enum PoleValueType
  {
    CellAverage = 0,  ///< mean over a disk as large as a third of the triangles around the point
    InfiniteValue = 1 ///< infinity
  };

  ///@{
  /**
   * Value of SingularitySubtraction at the source. Default CellAverage, which grows like -log(h) /
   * (2 pi) with the edge length h. Other methods have finite values there.
   */
  vtkSetClampMacro(PoleValue, int, CellAverage, InfiniteValue);
  vtkGetMacro(PoleValue, int);
  void SetPoleValueToCellAverage() { this->SetPoleValue(CellAverage); }
  void SetPoleValueToInfinite() { this->SetPoleValue(InfiniteValue); }
  const char* GetPoleValueAsString() const;
  ///@}

  /**
   * Weights of points in the mean of a function and in the outflow.
   */
  enum WeightingType
  {
    Area = 0,   ///< in proportion to the area around each point
    Uniform = 1 ///< equal for all points, as in the paper: for cells of equal size
  };

  ///@{
  /**
   * Weights of points in the mean, which is 0, and in the outflow. Default Area.
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
   * of the coordinates; finite, not negative. Default 0: the smaller of 0.28 times the square root
   * of the component's area (up to 0.35 on coarse meshes) and 48 mean edge lengths, less where
   * shortest paths from different sides meet.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * If on, SingularitySubtraction solves for points of the surface only, keeps these columns (4
   * bytes per point each, within MemoryLimit) and interpolates the smooth part in faces. Errors are
   * several times as large; further sources in the same faces take one distance each. Default off.
   */
  vtkSetMacro(InterpolateRegularPart, bool);
  vtkGetMacro(InterpolateRegularPart, bool);
  vtkBooleanMacro(InterpolateRegularPart, bool);
  ///@}

  ///@{
  /**
   * Method (MethodType) of a source of the last update, -1 if there is none, and radius of its
   * logarithm, 0 if there is none.
   */
  int GetUsedMethod(vtkIdType source) const;
  double GetUsedRadius(vtkIdType source) const;
  ///@}

  /**
   * Returns true if shortest paths from different sides meet close to a source of the last update
   * (within ten mean edge lengths, or Radius). Errors of SingularitySubtraction are then of order
   * h.
   */
  bool IsNearRidge(vtkIdType source) const;

  /**
   * Returns the number of columns that InterpolateRegularPart keeps for this mesh.
   */
  vtkIdType GetNumberOfColumns() const;

  vtkTypeUInt64 GetMemorySize() const override;

protected:
  vtkDiscreteGreensFunction();
  ~vtkDiscreteGreensFunction() override = default;

private:
  vtkDiscreteGreensFunction(const vtkDiscreteGreensFunction&) = delete;
  void operator=(const vtkDiscreteGreensFunction&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int Order = Laplace;
  int Method = SingularitySubtraction;
  int SignConvention = PositiveAtSource;
  int PoleValue = CellAverage;
  int Weighting = Area;
  double Radius = 0.0;
  bool InterpolateRegularPart = false;
};

#endif
