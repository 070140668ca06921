// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkApolloniusIsolines
 * @brief   isolines of distances that are curved and turn where the distance does
 *
 * vtkContourFilter treats a distance as linear in each triangle. This filter draws circles as such,
 * and the corners where waves from two sides meet.
 *
 * <b>Input and output</b>. Port 0 takes a surface with a point array of distances along it, the one
 * of SetInputArrayToProcess(), else of DistanceArrayName. NaN, infinity and the UnreachedValue of
 * distance filters are unreached points. Windows and virtual sources that do not belong to the
 * distances or the surface are ignored, with a warning; that they are of this surface, and that the
 * values are distances in units of the points, is the user's word. Values without virtual sources
 * that change along more than a tenth of the edges by more than 1.1 times their length are linear
 * in each triangle, with a warning; SetMethodToLinear() is for other fields. Outputs are new
 * geometry, see vtkGeodesicAlgorithm.
 *  - Output 0: isolines in order of increasing values, with lower distances on the left, closed but
 *    for those that end at the boundary, unreached triangles or edges with more than two triangles.
 *    Cell data: `IsoValue` (double). Point data: `FaceId`, `Barycentric`, `vtkOriginalPointIds`,
 *    `ArcLength`.
 *  - Output 1 (GetRidges()): ridges, with GenerateRidges; the same point data, and the cell array
 *    `RidgeAngle` (double, degrees), the mean angle between the two directions.
 *  - Output 2 (GetBands()): the reached triangles cut along the isolines, with GenerateBands. Cell
 *    data: `Band` (int), 0 below the smallest value; `BandMinimum`, `BandMaximum` (double), the
 *    values around it, outermost the smallest and largest distance; `FaceId`. Point data: the
 *    distances, `vtkOriginalPointIds`.
 *
 * A value out of the range of the distances has no line. When there are no lines, and neither
 * ridges nor bands are wanted, a warning names the range, once until there are lines again.
 *
 * <b>Guarantee and cost</b>. With windows (vtkExactGeodesicDistance::GenerateWindowsOn()) points of
 * lines are at their value up to rounding, and ridges exact. With virtual sources
 * (GenerateVirtualSourceOn() of any distance filter), or those fitted to the distances without,
 * lines are better than linear ones but without a bound, and some ridges are spurious: inside long
 * triangles, as of CAD models, they may be off by more than half of the largest distance. A warning
 * recommends windows if GetMeanAnisotropy() is above 2. Pieces of lines are within ChordTolerance
 * of the curve; the number of points grows like one over its square root.
 *
 * <b>Errors</b>. Besides those of vtkGeodesicAlgorithm: no array of distances, or one without one
 * number per point; a distance of minus infinity; a value that is not finite; a ChordTolerance
 * below 1e-6; SteinerPoints outside [0, 50]; a MinimumRidgeAngle outside [0, 180].
 *
 * @code
 * vtkNew<vtkExactGeodesicDistance> distance;
 * distance->SetInputConnection(reader->GetOutputPort());
 * distance->AddSourceId(0);
 * distance->GenerateWindowsOn();
 * vtkNew<vtkApolloniusIsolines> isolines;
 * isolines->SetInputConnection(distance->GetOutputPort());
 * isolines->GenerateValues(20, 0.0, 5.0);
 * isolines->Update();
 * @endcode
 *
 * <b>Source</b>. Inside of triangles: J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The
 * discrete geodesic problem", SIAM J. Comput. 16, 1987, section 3. Method Apollonius: Z. Fang,
 * "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, section 5.3, with
 * two rules repaired. On an edge that crosses a ridge, the cubic, which would smooth it, is
 * replaced by the smaller one of the distances that its ends give; points of the diagram inside a
 * triangle have the distance of the field, as that of the diagram is too large.
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
class DGGFieldInput;
class vtkDataArray;
namespace dgg
{
struct DistanceField;
struct Isolines;
}

class VTKDGGFILTERSGEODESIC_EXPORT vtkApolloniusIsolines : public vtkGeodesicAlgorithm
{
public:
  static vtkApolloniusIsolines* New();
  vtkTypeMacro(vtkApolloniusIsolines, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The values of the isolines, as in vtkContourFilter. Default one, 0. GenerateValues() makes
   * evenly spaced ones, with the ends of the range.
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
   * How far pieces of lines may be from the curves that they approximate, as a fraction of the mean
   * edge length. Default 0.001; at least 1e-6. For LocalSources and ridges.
   */
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * Points of the diagrams of Method Apollonius on each edge, besides its ends, in [0, 50]. Default
   * 2. More improve little and take far longer.
   */
  vtkSetMacro(SteinerPoints, int);
  vtkGetMacro(SteinerPoints, int);
  ///@}

  ///@{
  /**
   * Whether to find ridges (the cut locus: points with two shortest paths or more). Not reliable
   * without windows and virtual sources, and none where distances are linear; both are warnings.
   * Default off.
   */
  vtkSetMacro(GenerateRidges, bool);
  vtkGetMacro(GenerateRidges, bool);
  vtkBooleanMacro(GenerateRidges, bool);
  ///@}

  ///@{
  /**
   * Smallest angle between the directions of two shortest paths on a ridge, in degrees, in [0,
   * 180]. Default 20: ridges of small angles start at every convex point. Without windows at least
   * 10.
   */
  vtkSetMacro(MinimumRidgeAngle, double);
  vtkGetMacro(MinimumRidgeAngle, double);
  ///@}

  ///@{
  /**
   * Output 1: the ridges.
   */
  vtkPolyData* GetRidges();
  vtkAlgorithmOutput* GetRidgePort() { return this->GetOutputPort(1); }
  ///@}

  ///@{
  /**
   * Whether to cut the surface along the isolines into bands. Default off.
   */
  vtkSetMacro(GenerateBands, bool);
  vtkGetMacro(GenerateBands, bool);
  vtkBooleanMacro(GenerateBands, bool);
  ///@}

  ///@{
  /**
   * Output 2: the bands.
   */
  vtkPolyData* GetBands();
  vtkAlgorithmOutput* GetBandPort() { return this->GetOutputPort(2); }
  ///@}

  ///@{
  /**
   * Name of the point array with the distances, unless SetInputArrayToProcess() names another one.
   * Default "GeodesicDistance"; empty: the active point scalars. Another array is never used in its
   * place. An array without a name is "GeodesicDistance" in the outputs.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with the virtual sources, which may be missing. Default
   * "GeodesicVirtualSource".
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * Number of unreached points besides NaN and infinity, for distances from elsewhere; those of the
   * distance filters are recognised. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * Whether the last update used windows, or virtual sources of the input or fitted ones.
   */
  vtkGetMacro(UsedWindows, bool);
  vtkGetMacro(UsedVirtualSources, bool);
  ///@}

  /**
   * Pieces of lines of the last update that may be farther from the curve than ChordTolerance:
   * where the distance is not continuous, as with virtual sources of approximate distances.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

protected:
  vtkApolloniusIsolines();
  ~vtkApolloniusIsolines() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  dgg::Status CheckProperties() const override;
  dgg::Status CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkApolloniusIsolines(const vtkApolloniusIsolines&) = delete;
  void operator=(const vtkApolloniusIsolines&) = delete;

  struct Curves;

  std::vector<double> CopyValues() const;
  dgg::Status ReadField(const DGGContext& context, vtkDataArray* distances, DGGFieldInput& input);
  void WarnAbout(const DGGFieldInput& input, const DGGContext& context);
  void WarnAboutNoLine(const std::vector<double>& distances, const dgg::Isolines& lines);
  dgg::Status FindCurves(
    const DGGContext& context, const dgg::DistanceField& field, Curves& curves);

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
  bool WasEmpty; ///< no line, and nothing else wanted, in the last update
};

#endif
