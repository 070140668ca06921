// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBiharmonicDistance
 * @brief   distances from the spectrum of the Laplacian: biharmonic, commute-time, diffusion
 *
 * With eigenvalues lambda_i and eigenfunctions v_i of the Laplacian, the squared distance of x and
 * y is the sum of (v_i(x) - v_i(y))^2 times a weight, see Kind.
 *
 * <b>Input and output</b>. Same as for vtkSpectralAlgorithm. The result is `BiharmonicDistance` for
 * all kinds, one component per source. Functions are linear in faces. Points of another component
 * than the source get UnreachedValue. With Dirichlet conditions functions are 0 on the boundary.
 *
 * <b>Guarantee and cost</b>. All kinds are metrics, but not lengths of paths. Distances in a
 * component do not depend on other components. See Method for accuracy and cost.
 *
 * <b>Errors</b>. All errors of vtkSpectralAlgorithm; Kind Diffusion with Method Exact. The module
 * page is Filters/Spectral/README.md.
 *
 * @code
 * vtkNew<vtkBiharmonicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->SetSourceIds({ 0 });
 * distance->Update();
 * vtkDataArray* d = distance->GetOutput()->GetPointData()->GetArray("BiharmonicDistance");
 * @endcode
 *
 * <b>Source</b>. Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans.
 * Graph. 29(3), 2010, sections 3 and 4; R. R. Coifman, S. Lafon, "Diffusion maps", Appl. Comput.
 * Harmon. Anal. 21, 2006.
 *
 * @sa vtkSpectralAlgorithm vtkDiscreteGreensFunction vtkDGGDistance
 */

#ifndef vtkBiharmonicDistance_h
#define vtkBiharmonicDistance_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkSpectralAlgorithm.h"

#include <limits> // For UnreachedValue

class VTKDGGFILTERSSPECTRAL_EXPORT vtkBiharmonicDistance : public vtkSpectralAlgorithm
{
public:
  static vtkBiharmonicDistance* New();
  vtkTypeMacro(vtkBiharmonicDistance, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Kinds of distances, by the weight of an eigenvalue lambda.
   */
  enum KindType
  {
    Biharmonic = 0,  ///< 1 / lambda^2: a length in units of the coordinates
    CommuteTime = 1, ///< 1 / lambda: without a unit
    Diffusion = 2    ///< exp(-2 t lambda), see DiffusionTime: one over a length
  };

  ///@{
  /**
   * Kind of the distance. Default Biharmonic. CommuteTime grows without bound as a mesh is refined.
   */
  vtkSetClampMacro(Kind, int, Biharmonic, Diffusion);
  vtkGetMacro(Kind, int);
  void SetKindToBiharmonic() { this->SetKind(Biharmonic); }
  void SetKindToCommuteTime() { this->SetKind(CommuteTime); }
  void SetKindToDiffusion() { this->SetKind(Diffusion); }
  const char* GetKindAsString() const;
  ///@}

  /**
   * Methods that find the distance.
   */
  enum MethodType
  {
    Spectrum = 0, ///< smallest eigenvalues
    Exact = 1     ///< all eigenvalues
  };

  ///@{
  /**
   * Method that finds distances. Default Spectrum: the smallest NumberOfEigenvalues of each
   * component with a source, found once; the missing eigenvalues make distances too small. Exact
   * uses all eigenvalues of the finite elements, exact up to rounding: one solve per point, once,
   * on all threads, then two solves per source. Suitable for up to some ten thousand points.
   */
  vtkSetClampMacro(Method, int, Spectrum, Exact);
  vtkGetMacro(Method, int);
  void SetMethodToSpectrum() { this->SetMethod(Spectrum); }
  void SetMethodToExact() { this->SetMethod(Exact); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * Number of eigenvalues of each component for Spectrum. Default 150; at least 1. Components with
   * fewer eigenvalues use all of them.
   */
  vtkSetMacro(NumberOfEigenvalues, int);
  vtkGetMacro(NumberOfEigenvalues, int);
  ///@}

  ///@{
  /**
   * Time t of Diffusion, a length squared; finite, not negative. Default 0: a tenth of the inverse
   * of the first eigenvalue of the component.
   */
  vtkSetMacro(DiffusionTime, double);
  vtkGetMacro(DiffusionTime, double);
  ///@}

  ///@{
  /**
   * Distance of points that are not connected to the source. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  /**
   * Returns the number of updates so far that searched for eigenvalues.
   */
  int GetNumberOfSpectra() const;

  vtkTypeUInt64 GetMemorySize() const override;

protected:
  vtkBiharmonicDistance();
  ~vtkBiharmonicDistance() override = default;

private:
  vtkBiharmonicDistance(const vtkBiharmonicDistance&) = delete;
  void operator=(const vtkBiharmonicDistance&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  int Kind = Biharmonic;
  int Method = Spectrum;
  int NumberOfEigenvalues = 150;
  double DiffusionTime = 0.0;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
};

#endif
