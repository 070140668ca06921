// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPoissonVectorGraphics
 * @brief   smooth colors on a surface from few curves and regions
 *
 * <b>Input and output</b>. Port 0 takes the surface, the optional port 1 curves: each line of a
 * vtkPolyData, whose points are projected to the surface and joined by exact geodesics; a curve is
 * closed if its last id is the first. Left is as seen from the side from which triangles are
 * counter-clockwise. Parameters are arrays of port 1, see CurveTypeType; cells of the surface may
 * be regions, see RegionArrayName.
 *
 * Output 0 is the surface as triangles, refined and cut open along diffusion and Poisson curves,
 * whose points exist once per side. Point arrays: `Colors` (double, one component per channel);
 * with three or more channels `RGB` (unsigned char, clamped), the active scalars; `Component`
 * (vtkIdType), a tuple of NetSource; arrays of the input except ids, interpolated. Cell arrays are
 * passed from the input. Verts and lines are removed. Points that no polygon uses have
 * BackgroundColor. Field array `NetSource` (double): for each component, cut along diffusion
 * curves, the sum of sources that no diffusion curve absorbs, which is subtracted evenly.
 *
 * <b>Guarantee and cost</b>. Linear finite elements on the refined mesh, without flow through its
 * boundary. Errors are of second order in the edge length, of first order around an open end of a
 * diffusion curve with two colors. A round flat region changes nothing outside, others a little.
 * There is one factorization, kept for other colors; memory is about 2 KiB per point of the output.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; neither a line nor a region; a line with fewer
 * than two different points; mesh, factorization, colors or fragments beyond MemoryLimit. The
 * module page, Filters/Spectral/README.md, lists errors of curves and arrays.
 *
 * <b>Source</b>. F. Hou et al., "Poisson vector graphics (PVG)", IEEE Trans. Vis. Comput. Graph.
 * 26(2), 2020 (refinement replaces its evaluation by Green's identity); A. Orzan et al., "Diffusion
 * curves", ACM Trans. Graph. 27(3), 2008.
 * @sa vtkDiscreteGreensFunction vtkDGGPath vtkDGGLoop
 */

#ifndef vtkPoissonVectorGraphics_h
#define vtkPoissonVectorGraphics_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <string> // For array names

class VTKDGGFILTERSSPECTRAL_EXPORT vtkPoissonVectorGraphics : public vtkGeodesicAlgorithm
{
public:
  static vtkPoissonVectorGraphics* New();
  vtkTypeMacro(vtkPoissonVectorGraphics, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Curves on input port 1. Null removes them.
   */
  void SetCurveConnection(vtkAlgorithmOutput* output);
  void SetCurveData(vtkPolyData* curves);
  ///@}

  /**
   * Values of the cell array `CurveType`. Parameters are point arrays (linear in between) or cell
   * arrays of port 1 with one component per channel: 3 for colors, any number for others; unsigned
   * char values 0 to 255 mean 0 to 1. Strengths may have one component for all channels. Unknown
   * types, and arrays that are missing, not finite or of a wrong size, are errors.
   *
   *  - Diffusion: `LeftColor` and `RightColor` on the two sides; colors between curves are
   *    harmonic. Ends, and points where curves meet, have the mean.
   *  - Poisson: adds `Strength` on the left of the curve and subtracts it on the right, or adds
   *    `RightStrength` there, fading to 0 at the geodesic distance `Width`: a highlight and a
   *    shadow. Colors farther away do not change; bands do not reach through other curves of
   *    these two types. Closer than `Width` to an open end, the two sides blend.
   *  - Region: a closed curve; the surface on its left becomes brighter by `Strength` in the
   *    middle, fading to the rim: a source of density 4 pi Strength / area, and a sink along the
   *    curve.
   *  - Source: `Strength` flows in per length of the curve.
   */
  enum CurveTypeType
  {
    Diffusion = 0, ///< colors on both sides; default
    Poisson = 1,   ///< highlight and shadow that fade
    Region = 2,    ///< brightens the surface on the left
    Source = 3     ///< flow per length
  };

  ///@{
  /**
   * Names of arrays of port 1. Defaults `CurveType` (without it, all are diffusion curves),
   * `LeftColor`, `RightColor`, `Strength`, `RightStrength`, `Width`.
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
   * Cell arrays of the surface. Cells with the same number other than 0 in the first array form a
   * region; the second array contains the strength of the region at the region's first cell.
   * Default of the first array: none (null or ""). Default of the second array: `RegionStrength`.
   */
  vtkDGGStringMacro(RegionArrayName);
  vtkDGGStringMacro(RegionStrengthArrayName);
  ///@}

  ///@{
  /**
   * Width of Poisson curves without an array, in units of the coordinates. Default 0: 5 % of the
   * diagonal of the surface's bounding box; not negative. Widths in arrays are positive. An open
   * curve has its full strengths where both ends are at least the width away, which requires a
   * length of at least twice the width. From a width of about its length on, less than half of the
   * difference between its sides remains, with a warning that names the line.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Mean of the first three channels in components without a diffusion curve; the mean of others is
   * 0. Default 0.
   */
  vtkSetVector3Macro(BackgroundColor, double);
  vtkGetVector3Macro(BackgroundColor, double);
  ///@}

  /**
   * Triangles to refine.
   */
  enum RefinementRegionType
  {
    Everywhere = 0, ///< all
    NearCurves = 1, ///< triangles that touch a curve, plus one ring for each further level
    Cells = 2       ///< triangles of the cells that the array RefinementArrayName selects
  };

  ///@{
  /**
   * Number of times that triangles are split into four, in [0, 8], and the triangles to refine.
   * Defaults 1 and Everywhere.
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
   * Cell array of the surface for the RefinementRegion Cells: one number per cell, not 0 where the
   * cell is refined; NaN is an error. Default `Refine`.
   */
  vtkDGGStringMacro(RefinementArrayName);
  ///@}

  ///@{
  /**
   * Largest distance of a point of a curve from the surface, as a fraction of the diagonal of the
   * surface's bounding box; a farther point is an error. Default 0.01; not negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * If on, edges are flipped until they are Delaunay before the equation is solved; triangles of
   * the output do not change. With diffusion curves only, on a surface without a boundary, colors
   * then remain within the range of the given ones; close to a boundary up to a few percent.
   * Default on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * If on, output 1 contains fragments: FragmentDivision^2 points in each triangle of
   * RefinementRegion, with verts, `FaceId` and the point arrays of output 0 except `Component`.
   * Default off.
   */
  vtkSetMacro(GenerateFragments, bool);
  vtkGetMacro(GenerateFragments, bool);
  vtkBooleanMacro(GenerateFragments, bool);
  ///@}

  ///@{
  /**
   * Number of segments of the sides of triangles for fragments, in [1, 256]; each triangle has the
   * square of it. Default 1.
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
   * Name of the point array with the result. Default `Colors`; not empty, `RGB` or `Component`.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * Returns the number of factorizations so far: one for a new surface, other positions or types of
   * curves, other refinement or IntrinsicDelaunay; none for other colors, strengths, widths or
   * regions of cells.
   */
  int GetNumberOfFactorizations() const;

  /**
   * Returns the approximate number of bytes that are kept between updates; 0 before the first
   * update.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkPoissonVectorGraphics();
  ~vtkPoissonVectorGraphics() override = default;

private:
  vtkPoissonVectorGraphics(const vtkPoissonVectorGraphics&) = delete;
  void operator=(const vtkPoissonVectorGraphics&) = delete;

  class vtkInternals;
  vtkInternals& GetInternals() const;

  std::string CurveTypeArrayName = "CurveType";
  std::string LeftColorArrayName = "LeftColor";
  std::string RightColorArrayName = "RightColor";
  std::string StrengthArrayName = "Strength";
  std::string RightStrengthArrayName = "RightStrength";
  std::string WidthArrayName = "Width";
  std::string RegionArrayName;
  std::string RegionStrengthArrayName = "RegionStrength";
  std::string RefinementArrayName = "Refine";
  double Width = 0.0;
  double BackgroundColor[3] = { 0.0, 0.0, 0.0 };
  int RefinementLevel = 1;
  int RefinementRegion = Everywhere;
  double ProjectionTolerance = 0.01;
  bool IntrinsicDelaunay = true;
  bool GenerateFragments = false;
  int FragmentDivision = 1;
  std::string ResultArrayName = "Colors";
};

#endif
