// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkApolloniusIsolines
 * @brief   isolines of distances that are curved and turn where the distance does
 *
 * Finds the lines on a surface where a distance has some values. vtkContourFilter takes the
 * distance as linear in each triangle, so that its lines are straight there; they miss how circles
 * curve, and cut off the corners where the waves of two sides meet. This filter looks at how the
 * distance runs inside of triangles.
 *
 * Input port 0 takes a surface (vtkPolyData) with a point array of distances along it, as distance
 * filters give it: the one that SetInputArrayToProcess() names, where it has been called, else the
 * one of DistanceArrayName. Another one is never taken in its place. NaN, infinity and the
 * UnreachedValue of a distance filter stand for points that are not reached; lines end at triangles
 * that have one.
 *
 * How good the lines are depends on what the surface has besides the distances:
 *  - field data with windows (vtkExactGeodesicDistance::GenerateWindowsOn()): they are exact,
 *    points of the lines inside of triangles are at their value up to rounding;
 *  - virtual sources (GenerateVirtualSourceOn() of any distance filter): several times better than
 *    straight lines in triangles, see dggDistanceField.h; for CAD models see vtkGeodesicProbe;
 *  - else virtual sources are fitted to the distances, which is better than straight lines as well.
 *
 * Arrays of either kind that do not belong to the distances or to the surface are ignored, with a
 * warning. Windows are compared bit by bit. Virtual sources are ignored when the distances are not
 * those at the sources plus the straight ones from there. That they are those of this surface, and
 * that the values are distances in the units of the points, is the user's word: compute distances
 * again when points have moved, and call SetMethodToLinear() for other fields. Values without
 * virtual sources that change along more than a tenth of the edges by more than 1.1 times their
 * length are taken as linear in each triangle, with a warning.
 *
 * <b>Output 0</b> is new geometry, see vtkGeodesicAlgorithm: polylines, in order of increasing
 * values. Each of their pieces lies in one triangle of the surface. Lines are continuous across
 * edges. They are closed, with the same point at either end, but for those that end on the boundary
 * of the surface, at triangles that are not reached, and on edges with more than two triangles.
 * Lower distances are on the left of a line, as seen with the orientation of the triangle that it
 * starts in, which the filter may have turned over to make the surface consistent. Points that have
 * the very value count as farther away.
 *  - Cell data: `IsoValue` (double).
 *  - Point data: `FaceId`, the cell of the input that the piece after the point lies in (that
 * before it for the last point); `vtkOriginalPointIds`, the point of the input where the line is at
 *    one, else -1; `ArcLength`, the length of the line up to the point.
 *
 * <b>Output 1</b> (GetRidges()) has the ridges, when GenerateRidges is on: polylines with the same
 * point data and, as cell data, `RidgeAngle`. <b>Output 2</b> (GetBands()) has the bands between
 * the lines, when GenerateBands is on.
 *
 * Values without a line, as those out of the range of the distances, are no error. A surface
 * without triangles gives an empty output.
 *
 * <b>Errors</b> besides those of vtkGeodesicAlgorithm: no array of the name of the distances, or
 * one that does not have one number per point; a distance of minus infinity; a value that is not
 * finite; a ChordTolerance below 1e-6; SteinerPoints outside of 0 to 50; a MinimumRidgeAngle
 * outside of 0 to 180.
 *
 * @code
 * vtkNew<vtkExactGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->GenerateWindowsOn();
 * vtkNew<vtkApolloniusIsolines> isolines;
 * isolines->SetInputConnection(distance->GetOutputPort());
 * isolines->GenerateValues(20, 0.0, 5.0);
 * @endcode
 *
 * Exact distances inside of triangles: J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The
 * discrete geodesic problem", SIAM J. Comput. 16, 1987, section 3. Method Apollonius is that of
 * Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, section
 * 5.3, with two rules repaired: on an edge that crosses a ridge, the cubic, which would smooth the
 * ridge, is replaced by the smaller one of the distances that its ends give; points of the diagram
 * inside a triangle have the distance of the field there, as that of the diagram is too large.
 *
 * Not for subclassing outside of its module, see vtkGeodesicAlgorithm.
 *
 * @sa vtkGeodesicProbe vtkExactGeodesicDistance vtkDGGDistance vtkContourFilter
 */

#ifndef vtkApolloniusIsolines_h
#define vtkApolloniusIsolines_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include "vtkNew.h" // For the values

#include <string> // For array names
#include <vector> // For the values

class vtkContourValues;
class vtkDGGFieldInput;
class vtkDataArray;
namespace dgg
{
struct DistanceField;
}

class VTKDGGFILTERSGEODESIC_EXPORT vtkApolloniusIsolines : public vtkGeodesicAlgorithm
{
public:
  static vtkApolloniusIsolines* New();
  vtkTypeMacro(vtkApolloniusIsolines, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The values of the isolines, as in vtkContourFilter. One by default, 0. GenerateValues() makes
   * evenly spaced ones, the ends of the range among them.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  double* GetValues() VTK_SIZEHINT(GetNumberOfContours());
  void GetValues(double* contourValues);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double range[2]);
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  ///@}

  /**
   * Values count as properties of the filter.
   */
  vtkMTimeType GetMTime() override;

  /**
   * How the distance runs inside of triangles.
   */
  enum MethodType
  {
    LocalSources = 0, ///< by windows or virtual sources, see above
    Apollonius = 1,   ///< by Apollonius diagrams of points on edges, repaired; for comparison
    Linear = 2        ///< it is linear in each triangle, whatever else is known; for comparison
  };

  ///@{
  /**
   * How to find isolines. Default LocalSources.
   */
  vtkSetClampMacro(Method, int, LocalSources, Linear);
  vtkGetMacro(Method, int);
  void SetMethodToLocalSources() { this->SetMethod(LocalSources); }
  void SetMethodToApollonius() { this->SetMethod(Apollonius); }
  void SetMethodToLinear() { this->SetMethod(Linear); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * How far the pieces of lines, which are straight, may be from the curves that they stand for, as
   * a part of the mean edge length. Default 0.001; at least 1e-6, where a line has some hundred
   * points in a triangle close to a source: their number grows like one over the square root of the
   * tolerance. Of Method LocalSources and ridges alone.
   */
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * Points on each edge that the diagrams of Method Apollonius are made of, besides the ends: 0 to
   * 50. More of them come a little closer to the field, and take far longer: 50 some 500 times as
   * long as 2. Default 2.
   */
  vtkSetMacro(SteinerPoints, int);
  vtkGetMacro(SteinerPoints, int);
  ///@}

  ///@{
  /**
   * Whether to find the ridges as well (the cut locus: points with two shortest paths or more), as
   * polylines of the second output. They are exact with windows. With virtual sources they come in
   * pieces, some of which are where no ridge is: a few with those of vtkExactGeodesicDistance and
   * vtkDGGDistance, most of them with those of vtkHeatGeodesicDistance and
   * vtkDGGFastMarchingDistance, whose directions are rough. With virtual sources that are
   * fitted to distances alone, ridges are not to be relied on, as a warning says; where distances
   * are linear there are none, with a warning. Default off.
   */
  vtkSetMacro(GenerateRidges, bool);
  vtkGetMacro(GenerateRidges, bool);
  vtkBooleanMacro(GenerateRidges, bool);
  ///@}

  ///@{
  /**
   * Ridges are shown where the directions of two shortest paths differ by more than this angle, in
   * degrees. On a polyhedron a ridge of a small angle starts at every convex point, which hides the
   * others. Without windows angles below 10 count as 10: what is seen there are seams between the
   * virtual sources of neighbouring points. Default 20; in [0, 180].
   */
  vtkSetMacro(MinimumRidgeAngle, double);
  vtkGetMacro(MinimumRidgeAngle, double);
  ///@}

  ///@{
  /**
   * The second output: ridges, with the arrays of the lines and, as cell data, `RidgeAngle`
   * (double, degrees), the mean angle between the two directions. They meet at their ends alone.
   */
  vtkPolyData* GetRidges();
  vtkAlgorithmOutput* GetRidgePort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * Whether to cut the surface along the isolines as well, into bands between two values, as
   * triangles of the third output. Default off.
   */
  vtkSetMacro(GenerateBands, bool);
  vtkGetMacro(GenerateBands, bool);
  vtkBooleanMacro(GenerateBands, bool);
  ///@}

  ///@{
  /**
   * The third output: the triangles of the surface that are reached, cut along the isolines. Cell
   * data: `Band` (int), 0 below the smallest value, i between the values i - 1 and i in increasing
   * order; `BandMinimum` and `BandMaximum` (double), the values that the band lies between, for the
   * outermost ones the smallest and the largest distance of a point; `FaceId`. Point data: the
   * distances, and `vtkOriginalPointIds`.
   */
  vtkPolyData* GetBands();
  vtkAlgorithmOutput* GetBandPort() { return this->GetOutputPort(2); }
  ///@}

  ///@{
  /**
   * Name of the point array with the distances, unless SetInputArrayToProcess() says another one.
   * Default "GeodesicDistance"; when empty, the active point scalars. Unlike vtkContourFilter,
   * which takes these by default, this filter does not take them in place of an array that is
   * missing. Distances whose array has no name are called "GeodesicDistance" in the outputs.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the virtual sources. Default "GeodesicVirtualSource". It need not
   * be there.
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * The number that stands for points that are not reached, besides NaN and infinity. Default NaN:
   * the points that the distance filter left unreached, whatever its UnreachedValue. To be set
   * where distances come from elsewhere.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * What the last update took the distance inside of triangles from; neither when it failed.
   * Virtual sources may be those of the input or fitted ones.
   */
  vtkGetMacro(UsedWindows, bool);
  vtkGetMacro(UsedVirtualSources, bool);
  ///@}

  /**
   * Pieces of lines within one triangle, in the last update, that may be farther from the curve
   * than ChordTolerance: where the distance is not continuous, as virtual sources of approximate
   * distances make it here and there.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

protected:
  vtkApolloniusIsolines();
  ~vtkApolloniusIsolines() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const vtkDGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const vtkDGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkApolloniusIsolines(const vtkApolloniusIsolines&) = delete;
  void operator=(const vtkApolloniusIsolines&) = delete;

  struct Curves;

  std::vector<double> CopyValues() const;
  dgg::Status ReadField(
    const vtkDGGContext& context, vtkDataArray* distances, vtkDGGFieldInput& input);
  void WarnAbout(const vtkDGGFieldInput& input);
  dgg::Status FindCurves(
    const vtkDGGContext& context, const dgg::DistanceField& field, Curves& curves);

  vtkNew<vtkContourValues> ContourValues;
  int Method;
  double ChordTolerance;
  bool GenerateRidges;
  bool GenerateBands;
  double MinimumRidgeAngle;
  int SteinerPoints;
  std::string DistanceArrayName;
  std::string VirtualSourceArrayName;
  double UnreachedValue;
  bool UsedWindows;
  bool UsedVirtualSources;
  vtkIdType NumberOfFallbacks;
};

#endif
