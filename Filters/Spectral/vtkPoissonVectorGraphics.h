// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPoissonVectorGraphics
 * @brief   smooth colours on a surface from few curves and regions
 *
 * Input port 0 takes the surface (vtkPolyData), the optional port 1 curves: each line or polyline
 * of a vtkPolyData is one. Its points are projected to the closest points of the surface and joined
 * by exact geodesics. A polyline that ends with the id of its first point is closed. Other cells
 * are not used.
 *
 * <b>Curves.</b> Left and right are those of someone who walks along the curve on the side of the
 * surface from which triangles are seen counter-clockwise. Numbers are in arrays of port 1, of
 * points (linear along the curve in between, by length) or of cells (used where there is no point
 * array of that name). All have one component per channel: 3 for colours, but any number will do,
 * such as 1 for a displacement. Unsigned char stands for 0 to 255 as 0 to 1. The cell array
 * `CurveType` holds the type of a curve:
 *  - 0, Diffusion (the default): the colour is `LeftColor` on the left of the curve and
 * `RightColor` on the right, and in between curves it is as smooth as it can be (harmonic). At the
 * ends of an open curve, and where curves meet, a point has the mean of the colours given for it.
 *  - 1, Poisson: adds `Strength` right at the curve on its left and subtracts it on its right,
 *    fading to nothing at the geodesic distance `Width` (one component; that of the first point
 *    where the array is of points; default: the property Width): a highlight beside a shadow. An
 *    array `RightStrength` is added on the right instead: 0 for a highlight alone, the same as
 *    Strength for a glow. At the ends of an open curve the mean of both sides is added; colours go
 *    over to that within about `Width`. `Strength` and `RightStrength` may have a single component
 *    for all channels. Where they change along the curve, they are harmonic beside it; on triangles
 *    too thin for that, those of the nearest place. Colours farther away do not change, unless a
 *    diffusion curve runs through the band: its colours stay as they are given. Bands do not reach
 *    through diffusion and other Poisson curves.
 *  - 2, Region: a closed curve; what is on its left gets brighter by `Strength` (that of the first
 *    point) in its middle, if it is flat and round, fading towards the rim: a source of constant
 *    density, 4 pi Strength / area, with a sink along the curve that takes in as much.
 *  - 3, Source: `Strength` flows in per length of the curve; the slope changes by that across it.
 *
 * <b>Regions of cells.</b> The cells of the surface that have the same number, not 0, in the cell
 * array that RegionArrayName names are a region as well; each of its patches gets brighter by its
 * strength, with a sink on its own rim. The strength is in the cell array `RegionStrength`, at the
 * first cell of the region.
 *
 * <b>How far regions reach.</b> A round region on a plane changes nothing outside; others change
 * what is around them a little, a quarter as much at twice the distance. Relative to the height of
 * the highlight, the largest change beyond twice, and three times, the longer half axis of an
 * ellipse was 2.7 % and 1.2 % at 2 : 1, 4.2 % and 1.9 % at 5 : 1 on a square; 2.3 % and 0.8 %, 3.5
 * % and 1.2 % on a sphere. The highlight is 0.9 times as high as Strength at 2 : 1, and 0.65 times
 * at 5 : 1. A component without a diffusion curve keeps its mean, so that all else there gets
 * darker by that of the highlight: half of Strength times the region's part of the area, for
 * ellipses up to a third more.
 *
 * <b>Output 0.</b> The surface as triangles, refined and cut open so that curves are edges: points
 * on diffusion and Poisson curves exist once for each side. Point arrays:
 *  - `Colors` (double, one component per channel), see SetResultArrayName();
 *  - `RGB` (unsigned char), for 3 channels or more, the first three, from 0 to 1, as 0 to 255,
 *    clamped: the active scalars, which a mapper shows as they are. For other numbers of channels,
 *    `Colors` is active;
 *  - `Component` (vtkIdType), the number of the component that a point is in: a tuple of NetSource;
 *  - those of the input, interpolated linearly, but for ids (vtkIdType), which VTK leaves out.
 *
 * Cell arrays are those of the input, of the polygon that a triangle is a part of. Verts and lines
 * of the input are left out; points that no polygon uses stay, with BackgroundColor. The field data
 * has `NetSource`: one tuple per component of the surface, cut open along diffusion curves, with
 * the sum of its sources where no diffusion curve takes it in; it was subtracted evenly. Points
 * without a cell are components of their own, with 0. Regions of all of a component have no rim and
 * do nothing but show there. Such a component has the mean BackgroundColor, before Poisson curves
 * are added.
 *
 * <b>Output 1</b> (GetFragments()) has fragments, when GenerateFragments is on: coloured points
 * spread over the surface, a texture that needs no parametrization. Each triangle of output 0 has
 * FragmentDivision^2 of them, in the middles of as many parts of one size, so that none is on a
 * curve; unless RefinementRegion is Everywhere, only parts of triangles that were chosen have some.
 * One vertex cell each. Point arrays are those of output 0 at that place, but for `Component`, and
 * `FaceId` (vtkIdType), the cell of the input that it lies in.
 *
 * <b>Method.</b> -Laplace u = f for each channel, nothing flows through the boundary of the
 * surface; linear finite elements on the refined mesh, one factorization, which is kept for other
 * colours, see dgg::VectorGraphics. Triangles are split in four RefinementLevel times, everywhere
 * or around curves, before the equation is solved: errors are of second order where curves are
 * closed or end at the boundary, and of first order everywhere as soon as a diffusion curve has an
 * open end with two colours, where the solution is like the root of the distance. Refinement takes
 * the place of evaluations by Green's identity, which are no better than linear interpolation, see
 * dgg::GraphicsRefinement.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm:
 *  - neither a line nor a region; a line with fewer than two different points;
 *  - a point of a line that is not finite, or farther from the surface than ProjectionTolerance, or
 *    not connected with the next one;
 *  - curves where edges have more than two triangles, or two that are oriented differently, as on a
 *    one-sided surface: there are no sides. Curves elsewhere on such a surface are fine;
 *  - a ResultArrayName that is empty, or `RGB` or `Component`;
 *  - an array that is needed but missing, or has the wrong number of components or tuples; a number
 *    that is not finite; an unknown type; a width that is not positive;
 *  - no such cell array although RefinementRegion is Cells, or one with NaN; a cell array of
 *    regions with NaN;
 *  - a region's curve that is open, or does not separate its left from its right;
 *  - a ProjectionTolerance or Width that is negative or not a number;
 *  - a colour or net source of the result beyond the largest number, 1.8e308. Numbers of the input
 *    may be of any size otherwise;
 *  - a mesh, factorization and colours, or fragments, that would take more memory than
 *    MemoryLimit.
 *
 * An update can be stopped between the parts of the work; the factorization is one of them.
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
 * F. Hou, Q. Sun, Z. Fang, Y.-J. Liu, S.-M. Hu, H. Qin, A. Hao, Y. He, "Poisson vector graphics
 * (PVG)", IEEE Trans. Vis. Comput. Graph. 26(2), 2020; A. Orzan et al., "Diffusion curves", ACM
 * Trans. Graph. 27(3), 2008.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkDiscreteGreensFunction vtkDGGPath
 */

#ifndef vtkPoissonVectorGraphics_h
#define vtkPoissonVectorGraphics_h

#include "vtkDGGFiltersSpectralModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include <memory> // For the internals
#include <string> // For array names

struct vtkDGGGraphicsNames;

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
   * The cell array of the surface that distinguishes regions, and that with their strengths. Null
   * and
   * "" for no regions, which is the default, and `RegionStrength`.
   */
  vtkDGGStringMacro(RegionArrayName);
  vtkDGGStringMacro(RegionStrengthArrayName);
  ///@}

  ///@{
  /**
   * The width of Poisson curves where there is no array, in units of the surface. Default 0, which
   * stands for 5 % of the diagonal of its bounding box; must not be negative.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Of the first three channels, the mean where no diffusion curve is; that of others is 0. Default
   * 0.
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
   * How often triangles are split in four, from 0 to 8, and which. Default 1, Everywhere.
   * Neighbours are split once as needed for edges to fit.
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
   * The cell array of the surface with one number per cell that is not 0 where triangles are
   * refined, for the RefinementRegion Cells. Default `Refine`.
   */
  vtkDGGStringMacro(RefinementArrayName);
  ///@}

  ///@{
  /**
   * How far from the surface a point of a curve may be, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is an error that names it. Default 0.01; must not
   * be negative.
   */
  vtkSetMacro(ProjectionTolerance, double);
  vtkGetMacro(ProjectionTolerance, double);
  ///@}

  ///@{
  /**
   * Whether to flip edges until they are Delaunay before the equation is solved, without a change
   * of the output's triangles: for meshes with obtuse triangles, as curves make them where they run
   * close to points. Then, with diffusion curves alone on a surface without a boundary, no colour
   * lies outside of those that are given; close to a boundary, whose edges cannot be flipped, some
   * may by a few percent of the range. Default on.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Most bytes that the refined mesh, the factorization and the colours may take. Default 0, which
   * stands for 70 % of the memory that is free at that time, for what is not there yet. Some 2 KiB
   * per point of the output are usual, and 2.7 KiB with Poisson curves. It is checked before curves
   * are drawn, before triangles are split, before the factorization, and in every update.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * Whether the second output has fragments. Default off.
   */
  vtkSetMacro(GenerateFragments, bool);
  vtkGetMacro(GenerateFragments, bool);
  vtkBooleanMacro(GenerateFragments, bool);
  ///@}

  ///@{
  /**
   * Into how many parts sides of triangles are divided for fragments, from 1 to 256: each triangle
   * has the square of it. Colours are linear in a triangle; what RefinementLevel adds is better
   * than that. Default 1.
   */
  vtkSetClampMacro(FragmentDivision, int, 1, 256);
  vtkGetMacro(FragmentDivision, int);
  ///@}

  ///@{
  /**
   * The second output: fragments, see above; empty unless GenerateFragments is on.
   */
  vtkPolyData* GetFragments();
  vtkAlgorithmOutput* GetFragmentPort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * The name of the point array with the result. Default `Colors`. Null and "" are an error.
   */
  vtkDGGStringMacro(ResultArrayName);
  ///@}

  /**
   * How many factorizations this filter has done: one for a new surface, new places or types of
   * curves, other refinement or IntrinsicDelaunay; none for other colours, strengths, widths or
   * regions of cells.
   */
  int GetNumberOfFactorizations() const;

  /**
   * About how many bytes are kept between updates; zero before the first one.
   */
  vtkTypeUInt64 GetMemorySize() const;

protected:
  vtkPoissonVectorGraphics();
  ~vtkPoissonVectorGraphics() override;

  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkPoissonVectorGraphics(const vtkPoissonVectorGraphics&) = delete;
  void operator=(const vtkPoissonVectorGraphics&) = delete;

  struct vtkInternals;

  vtkDGGGraphicsNames GetNames() const;

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
