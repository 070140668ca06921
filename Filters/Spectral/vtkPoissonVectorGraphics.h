// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPoissonVectorGraphics
 * @brief   smooth colours on a surface from few curves and regions
 *
 * <b>Input and output</b>. Port 0 takes the surface, the optional port 1 curves: each line of a
 * vtkPolyData, whose points are projected to the surface and joined by exact geodesics. One that
 * ends with the id of its first point is closed. Left is seen from the side from which triangles
 * are counter-clockwise. Numbers are in arrays of port 1, of points (linear in between) or else of
 * cells, with one component per channel: 3 for colours, any number for others; unsigned char 0 to
 * 255 is 0 to 1. `CurveType` of cells:
 *  - 0, Diffusion (default): the colours `LeftColor` and `RightColor` on the two sides; in between
 *    curves colours are harmonic. Ends, and points where curves meet, have the mean.
 *  - 1, Poisson: adds `Strength` on the left of the curve and subtracts it on the right, or adds
 *    `RightStrength` there, fading to 0 at the geodesic distance `Width`: a highlight and a shadow.
 *    Colours farther away do not change, and bands do not reach through other curves of types 0 and
 *    1.
 *  - 2, Region: a closed curve; its left gets brighter by `Strength` in the middle, fading to the
 *    rim: a source of density 4 pi Strength / area, and a sink along the curve.
 *  - 3, Source: `Strength` flows in per length of the curve.
 *
 * Strengths may have one component for all channels; `Width`, one, may be missing (property Width).
 *
 * Cells of the surface with the same number, not 0, in the array RegionArrayName are a region as
 * well, with its strength in `RegionStrength`, at the first of them.
 *
 * Output 0 is the surface as triangles, refined and cut open along diffusion and Poisson curves,
 * whose points exist once for each side. Point arrays: `Colors` (double, one component per
 * channel); for 3 channels or more `RGB` (unsigned char, clamped), the active scalars; `Component`
 * (vtkIdType), a tuple of NetSource; those of the input, interpolated, but for ids. Cell arrays are
 * those of the input. Verts and lines are left out; points that no polygon uses have
 * BackgroundColor. Field array `NetSource` (double): for each component, cut along diffusion
 * curves, the sum of the sources that no diffusion curve takes in and that was subtracted evenly.
 * Output 1 has fragments, if GenerateFragments is on: FragmentDivision^2 points in each triangle,
 * or in those that RefinementRegion chooses, with verts, the point arrays of output 0 but
 * `Component`, and `FaceId`.
 *
 * <b>Guarantee and cost</b>. Linear finite elements on the refined mesh, with nothing through its
 * boundary. Errors are of second order in the edge length; of first order as soon as a diffusion
 * curve has an open end with two colours. A round flat region changes nothing outside, others a
 * little. One factorization, kept for other colours; the memory is about 2 KiB per point of the
 * output. An update can be stopped between the parts of the work.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm:
 *  - neither a line nor a region; a line with fewer than two different points, or a point that is
 *    not finite, farther from the surface than ProjectionTolerance, or not connected with the next
 *    one;
 *  - a curve where there are no sides: an edge with more than two triangles, or two that are
 *    oriented differently;
 *  - a region's curve that is open, or does not separate its left from its right;
 *  - an array that is missing, not finite, or of another number of components or tuples; an unknown
 *    type; a width that is not positive; a cell array of regions, or of the RefinementRegion Cells,
 *    that is missing or has NaN;
 *  - a ResultArrayName that is empty, or `RGB` or `Component`; a ProjectionTolerance or Width that
 *    is negative or NaN; a result beyond 1.8e308;
 *  - a mesh, factorization, colours or fragments that take more than MemoryLimit.
 *
 * @code
 * vtkNew<vtkPoissonVectorGraphics> graphics;
 * graphics->SetInputConnection(reader->GetOutputPort());
 * graphics->SetCurveData(curves); // with the arrays LeftColor and RightColor
 * graphics->SetRefinementLevel(2);
 * vtkNew<vtkPolyDataMapper> mapper;
 * mapper->SetInputConnection(graphics->GetOutputPort()); // shows RGB as it is
 * @endcode
 *
 * <b>Source</b>. F. Hou, Q. Sun, Z. Fang, Y.-J. Liu, S.-M. Hu, H. Qin, A. Hao, Y. He, "Poisson
 * vector graphics (PVG)", IEEE Trans. Vis. Comput. Graph. 26(2), 2020; A. Orzan et al., "Diffusion
 * curves", ACM Trans. Graph. 27(3), 2008. Refinement replaces the evaluation of the former by
 * Green's identity.
 *
 * @sa vtkDiscreteGreensFunction vtkDGGPath vtkDGGLoop
 */

#ifndef vtkPoissonVectorGraphics_h
#define vtkPoissonVectorGraphics_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <string> // For array names

struct DGGGraphicsNames;

class VTKDGGFILTERSSPECTRAL_EXPORT vtkPoissonVectorGraphics : public vtkGeodesicAlgorithm
{
public:
  static vtkPoissonVectorGraphics* New();
  vtkTypeMacro(vtkPoissonVectorGraphics, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The curves, on input port 1. Null removes them.
   */
  void SetCurveConnection(vtkAlgorithmOutput* output);
  void SetCurveData(vtkPolyData* curves);
  ///@}

  /**
   * Values of the cell array `CurveType`.
   */
  enum CurveTypeType
  {
    Diffusion = 0, ///< colours on both sides
    Poisson = 1,   ///< highlight and shadow that fade
    Region = 2,    ///< brightens what is on the left
    Source = 3     ///< flow per length
  };

  ///@{
  /**
   * Names of arrays of port 1. Defaults `CurveType`, `LeftColor`, `RightColor`, `Strength`,
   * `RightStrength`, `Width`.
   */
  vtkDGGStringMacro(CurveTypeArrayName);
  vtkDGGStringMacro(LeftColorArrayName);
  vtkDGGStringMacro(RightColorArrayName);
  vtkDGGStringMacro(StrengthArrayName);
  vtkDGGStringMacro(RightStrengthArrayName);
  vtkDGGStringMacro(WidthArrayName);
  ///@}

  ///@{
  /**
   * Cell arrays of the surface with the regions, default none (null or ""), and with their
   * strengths, default `RegionStrength`.
   */
  vtkDGGStringMacro(RegionArrayName);
  vtkDGGStringMacro(RegionStrengthArrayName);
  ///@}

  ///@{
  /**
   * Width of Poisson curves without an array, in units of the coordinates. Default 0: 5 % of the
   * diagonal of the surface's bounding box; not negative.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Mean of the first three channels where no diffusion curve is; that of others is 0. Default 0.
   */
  vtkSetVector3Macro(BackgroundColor, double);
  vtkGetVector3Macro(BackgroundColor, double);
  ///@}

  /**
   * Which triangles are refined.
   */
  enum RefinementRegionType
  {
    Everywhere = 0, ///< all
    NearCurves = 1, ///< those that touch a curve, with a ring around them for each further level
    Cells = 2       ///< those of the cells that the array RefinementArrayName chooses
  };

  ///@{
  /**
   * How often triangles are split in four, in [0, 8], and which. Default 1, Everywhere.
   */
  vtkSetClampMacro(RefinementLevel, int, 0, 8);
  vtkGetMacro(RefinementLevel, int);
  vtkSetClampMacro(RefinementRegion, int, Everywhere, Cells);
  vtkGetMacro(RefinementRegion, int);
  void SetRefinementRegionToEverywhere() { this->SetRefinementRegion(Everywhere); }
  void SetRefinementRegionToNearCurves() { this->SetRefinementRegion(NearCurves); }
  void SetRefinementRegionToCells() { this->SetRefinementRegion(Cells); }
  const char* GetRefinementRegionAsString() const;
  ///@}

  ///@{
  /**
   * Cell array of the surface, of one component, not 0 where the RefinementRegion Cells refines.
   * Default `Refine`.
   */
  vtkDGGStringMacro(RefinementArrayName);
  ///@}

  ///@{
  /**
   * How far from the surface a point of a curve may be, as a fraction of the diagonal of the
   * surface's bounding box; farther is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay before the equation is solved; triangles of the
   * output do not change. Then, with diffusion curves alone on a surface without a boundary, no
   * colour is out of the range of those given; close to a boundary by a few percent. Default on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Whether output 1 has fragments. Default off.
   */
  vtkSetMacro(GenerateFragments, bool);
  vtkGetMacro(GenerateFragments, bool);
  vtkBooleanMacro(GenerateFragments, bool);
  ///@}

  ///@{
  /**
   * Parts of the sides of triangles for fragments, in [1, 256]; each triangle has its square.
   * Default 1.
   */
  vtkSetClampMacro(FragmentDivision, int, 1, 256);
  vtkGetMacro(FragmentDivision, int);
  ///@}

  ///@{
  /**
   * Output 1: the fragments.
   */
  vtkPolyData* GetFragments();
  vtkAlgorithmOutput* GetFragmentPort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * Name of the point array with the result. Default `Colors`; not empty.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * Factorizations so far: one for a new surface, new places or types of curves, other refinement
   * or IntrinsicDelaunay; none for other colours, strengths, widths or regions of cells.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Bytes kept between updates, about; zero before the first one.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkPoissonVectorGraphics();
  ~vtkPoissonVectorGraphics() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkPoissonVectorGraphics(const vtkPoissonVectorGraphics&) = delete;
  void operator=(const vtkPoissonVectorGraphics&) = delete;

  struct vtkInternals;

  DGGGraphicsNames GetNames() const;

  std::string CurveTypeArrayName;
  std::string LeftColorArrayName;
  std::string RightColorArrayName;
  std::string StrengthArrayName;
  std::string RightStrengthArrayName;
  std::string WidthArrayName;
  std::string RegionArrayName;
  std::string RegionStrengthArrayName;
  std::string RefinementArrayName;
  double Width;
  double BackgroundColor[3];
  int RefinementLevel;
  int RefinementRegion;
  double ProjectionTolerance;
  bool IntrinsicDelaunay;
  bool GenerateFragments;
  int FragmentDivision;
  std::string ResultArrayName;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
