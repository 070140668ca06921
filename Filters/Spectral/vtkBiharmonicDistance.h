// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBiharmonicDistance
 * @brief   smooth distances on a surface made of the Laplacian: biharmonic, commute-time, diffusion
 *
 * With eigenvalues lambda_i and functions v_i of the Laplacian, the squared distance of x and y is
 * the sum of (v_i(x) - v_i(y))^2 times 1 / lambda_i^2 for the biharmonic distance, 1 / lambda_i for
 * the commute-time distance, exp(-2 t lambda_i) for the diffusion distance at time t.
 *
 * <b>Input and output</b>. Those of vtkSpectralAlgorithm. The result is `BiharmonicDistance` for
 * all kinds, one component per source: a length in units of the coordinates, a number, or one over
 * a length. Functions are linear in faces. Points of another component than the source get
 * UnreachedValue. With Dirichlet conditions functions are 0 on the boundary.
 *
 * <b>Guarantee and cost</b>. These are metrics, but not lengths of paths. Method Exact has all
 * eigenvalues, up to rounding, of the finite elements: by a solution for each point, once, on all
 * threads; then two substitutions for each source, for some ten thousand points. Spectrum takes the
 * smallest NumberOfEigenvalues of each component with a source, which are found once; those that
 * are left out make distances too small. With either method, distances in a component do not depend
 * on other components. Commute-time distances grow without bound as a mesh is refined.
 *
 * <b>Errors</b>. Besides those of vtkSpectralAlgorithm: Diffusion by the Exact method; a
 * DiffusionTime that is negative or not finite; a NumberOfEigenvalues below 1.
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

#include <memory> // For what is kept

class VTKDGGFILTERSSPECTRAL_EXPORT vtkBiharmonicDistance : public vtkSpectralAlgorithm
{
public:
  static vtkBiharmonicDistance* New();
  vtkTypeMacro(vtkBiharmonicDistance, vtkSpectralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which distance, see above.
   */
  enum KindType
  {
    Biharmonic = 0,
    CommuteTime = 1,
    Diffusion = 2
  };

  ///@{
  /**
   * Which distance. Default Biharmonic.
   */
  vtkSetClampMacro(Kind, int, Biharmonic, Diffusion);
  vtkGetMacro(Kind, int);
  void SetKindToBiharmonic() { this->SetKind(Biharmonic); }
  void SetKindToCommuteTime() { this->SetKind(CommuteTime); }
  void SetKindToDiffusion() { this->SetKind(Diffusion); }
  const char* GetKindAsString() const;
  ///@}

  /**
   * How distances are found, see above.
   */
  enum MethodType
  {
    Spectrum = 0,
    Exact = 1
  };

  ///@{
  /**
   * How distances are found. Default Spectrum.
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
   * The time t of Diffusion, a length squared. Default 0: a tenth of the inverse of the first
   * eigenvalue of the component.
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
   * Number of updates so far that searched for eigenvalues.
   */
  int GetNumberOfSpectra() const;

  vtkTypeUInt64 GetMemorySize() const override;

protected:
  vtkBiharmonicDistance();
  ~vtkBiharmonicDistance() override;

  dgg::Status CheckProperties() const override;
  double EstimateWorkingMemory(const dgg::PoissonSolver& solver, std::size_t numberOfSources,
    std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

private:
  vtkBiharmonicDistance(const vtkBiharmonicDistance&) = delete;
  void operator=(const vtkBiharmonicDistance&) = delete;

  struct Preparation;

  int Kind;
  int Method;
  int NumberOfEigenvalues;
  double DiffusionTime;
  double UnreachedValue;
  int NumberOfSpectra; // for meshes before the last one
  std::unique_ptr<Preparation> Prepared;
};

#endif
