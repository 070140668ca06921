// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBiharmonicDistance
 * @brief   smooth distances on a surface made of the Laplacian: biharmonic, commute-time, diffusion
 *
 * With eigenvalues lambda_i and functions v_i of the Laplacian, the square of the distance of x and
 * y is the sum of (v_i(x) - v_i(y))^2 times
 *  - 1 / lambda_i^2 for the biharmonic distance, a length (the unit of the coordinates). It is
 *    smooth, close to straight next to the source and aware of the shape farther away, and hardly
 *    depends on the mesh;
 *  - 1 / lambda_i for the commute-time distance, a number. It grows without bound as a mesh is
 *    refined, and says little on fine ones;
 *  - exp(-2 t lambda_i) for the diffusion distance at time t, one over a length.
 *
 * They are distances of vectors, so metrics. They are not lengths of ways on the surface: see
 * vtkExactGeodesicDistance and vtkDGGDistance for these.
 *
 * Inputs, sources, outputs, the factorization and errors are those of vtkSpectralAlgorithm; the
 * result array is `BiharmonicDistance`, one component per source, whatever the Kind. Sources and
 * evaluation points may lie anywhere: functions are linear inside of faces, which suits the
 * biharmonic distance, of which the kernel is bounded at its pole. Points in another component than
 * the source, or without a polygon, get UnreachedValue. With Dirichlet conditions, functions are
 * those that are 0 on the boundary.
 *
 * <b>Methods.</b>
 *  - Spectrum takes the smallest NumberOfEigenvalues of all components together, which are found
 *    once and kept. What is left out makes distances too small, next to the source above all.
 *  - Exact has all of them, by solving for Green's functions: once for every point of the surface,
 *    in several threads, when the surface, Kind or an option of the factorization changes; later
 *    sources take two substitutions. For meshes of up to some ten thousand points. Not for
 *    Diffusion, which needs eigenvalues.
 *
 * <b>Errors</b> besides those of vtkSpectralAlgorithm: Diffusion by the Exact method; a
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
 * Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
 * 2010, sections 3 and 4; R. R. Coifman, S. Lafon, "Diffusion maps", Appl. Comput. Harmon. Anal.
 * 21, 2006.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkSpectralAlgorithm vtkDiscreteGreensFunction
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
   * How many eigenvalues Spectrum takes. Default 150; fewer are taken where there are not as many.
   */
  vtkSetMacro(NumberOfEigenvalues, int);
  vtkGetMacro(NumberOfEigenvalues, int);
  ///@}

  ///@{
  /**
   * The time t of Diffusion, a length squared. Default 0, which stands for a tenth of the first
   * eigenvalue's inverse.
   */
  vtkSetMacro(DiffusionTime, double);
  vtkGetMacro(DiffusionTime, double);
  ///@}

  ///@{
  /**
   * Distance given to points that are not connected to the source. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  /**
   * How often eigenvalues have been found, for the meshes so far.
   */
  int GetNumberOfSpectra() const;

  vtkTypeUInt64 GetMemorySize() const override;

protected:
  vtkBiharmonicDistance();
  ~vtkBiharmonicDistance() override;

  dgg::Status CheckProperties() const override;
  double EstimateWorkingMemory(const dgg::PoissonSolver& solver, std::size_t numberOfSources,
    std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(vtkDGGSpectralTask& task) override;

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
