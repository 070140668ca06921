// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkApolloniusIsolines
 * @brief   isolines, ridges and bands of distances, curved inside triangles
 *
 * <b>Input and output</b>. Port 0 takes a surface with a point array of distances along it, set by
 * SetInputArrayToProcess() or otherwise DistanceArrayName. NaN, infinity and UnreachedValue mark
 * unreached points. Windows and virtual sources that do not belong to the distances or the surface
 * are ignored, with a warning. Values that are not distances in units of the points are not always
 * recognized. Outputs are new geometry, see vtkGeodesicAlgorithm.
 *  - Output 0: isolines in order of increasing values, lower distances on the left; closed unless
 *    they end at the boundary, unreached triangles or edges with more than two triangles. Cell
 *    data: `IsoValue` (double). Point data: `FaceId`, `Barycentric`, `vtkOriginalPointIds`,
 *    `ArcLength`.
 *  - Output 1 (GetRidges()), see GenerateRidges; output 2 (GetBands()), see GenerateBands.
 *
 * <b>Guarantee and cost</b>. With windows (vtkExactGeodesicDistance::GenerateWindowsOn(), and
 * vtkDGGDistance on large triangles), points of lines have their value up to rounding, and ridges
 * are exact. Virtual sources (GenerateVirtualSourceOn() of any distance filter), or those fitted to
 * the distances, have no bound: errors in long triangles, as in CAD models, may exceed half of the
 * largest distance, and some ridges are spurious. A warning recommends windows if
 * GetMeanAnisotropy() is above 2.
 *
 * <b>Errors</b>. All errors of vtkGeodesicAlgorithm; no array of distances with one number per
 * point; a distance of minus infinity; a value that is not finite. If there is no line, and neither
 * ridges nor bands are requested, a warning states the range of the distances. The module page,
 * Filters/Geodesic/Curves.md, has the accuracy by input and the treatment of other values.
 *
 * <b>Source</b>. J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic
 * problem", SIAM J. Comput. 16, 1987, section 3; Z. Fang, "Discrete geodesic graphs", PhD thesis,
 * Nanyang Technological University, 2019, section 5.3.
 * @sa vtkGeodesicProbe vtkExactGeodesicDistance vtkDGGDistance vtkContourFilter
 */

#ifndef vtkApolloniusIsolines_h
#define vtkApolloniusIsolines_h

#include "vtkDGGFiltersGeodesicModule.h" // For export macro
#include "vtkGeodesicAlgorithm.h"

#include "vtkNew.h" // For the values

#include <limits> // For UnreachedValue
#include <string> // For array names

class vtkContourValues;

class VTKDGGFILTERSGEODESIC_EXPORT vtkApolloniusIsolines : public vtkGeodesicAlgorithm
{
public:
  static vtkApolloniusIsolines* New();
  vtkTypeMacro(vtkApolloniusIsolines, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Values of the isolines, as in vtkContourFilter. Default: one value, 0. GenerateValues() makes
   * evenly spaced values, including both ends of the range.
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
   * Returns the modification time, including the modification time of the values.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Interpolation of the distance in triangles. Apollonius is the construction of Fang's thesis,
   * section 5.3, with two rules corrected: on an edge that crosses a ridge, the cubic, which would
   * smooth the ridge, is replaced by the smaller of the distances from both ends; points of a
   * diagram inside a triangle have the distance of the field, since the distance of the diagram is
   * too large.
   */
  enum MethodType
  {
    LocalSources = 0, ///< windows or virtual sources of the input, or fitted ones
    Apollonius = 1,   ///< Apollonius diagrams of points on edges; for comparison
    Linear = 2        ///< linear in each triangle, for other fields and for comparison
  };

  ///@{
  /**
   * Interpolation of the distance in triangles. Default LocalSources.
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
   * Largest distance of segments from the curve that they approximate, as a fraction of the mean
   * edge length. Default 0.001; a value below 1e-6 is an error. The number of points is
   * proportional to one over the square root. For LocalSources and ridges.
   */
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * Number of points of the diagrams of Method Apollonius on each edge, ends excluded. Default 2;
   * values outside [0, 50] are errors. More points improve little and take far longer.
   */
  vtkSetMacro(SteinerPoints, int);
  vtkGetMacro(SteinerPoints, int);
  ///@}

  ///@{
  /**
   * If on, output 1 contains ridges (the cut locus: points with two or more shortest paths) with
   * the point data of isolines and the cell array `RidgeAngle` (double, degrees), the mean angle
   * between the two directions. Not reliable without windows and virtual sources; no ridges where
   * distances are linear. Both cause warnings. Default off.
   */
  vtkSetMacro(GenerateRidges, bool);
  vtkGetMacro(GenerateRidges, bool);
  vtkBooleanMacro(GenerateRidges, bool);
  ///@}

  ///@{
  /**
   * Smallest angle between the directions of two shortest paths on a ridge, degrees; outside [0,
   * 180] an error. Default 20, since ridges of small angles start at every convex point. Without
   * windows at least 10.
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
   * If on, output 2 contains the reached triangles cut along the isolines. Cell data: `Band` (int),
   * 0 below the smallest value; `BandMinimum`, `BandMaximum` (double), the adjacent values, or the
   * smallest and the largest distance; `FaceId`. Point data: distances, `vtkOriginalPointIds`.
   * Default off.
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
   * Name of the point array with the distances, unless SetInputArrayToProcess() names another.
   * Default "GeodesicDistance"; empty: the active point scalars. No other array is used instead. An
   * array without a name is "GeodesicDistance" in the outputs.
   */
  vtkDGGStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Name of the point array with virtual sources, which is optional. Default
   * "GeodesicVirtualSource".
   */
  vtkDGGStringMacro(VirtualSourceArrayName);
  ///@}

  ///@{
  /**
   * Value of unreached points in addition to NaN and infinity, for distances of other origin;
   * values of the distance filters are recognized. Default NaN.
   */
  vtkDGGSetNumberMacro(UnreachedValue);
  vtkGetMacro(UnreachedValue, double);
  ///@}

  ///@{
  /**
   * UsedWindows: true if the last update used windows. UsedVirtualSources: true if it used virtual
   * sources, of the input or fitted.
   */
  vtkGetMacro(UsedWindows, bool);
  vtkGetMacro(UsedVirtualSources, bool);
  ///@}

  /**
   * Number of segments of the last update that may be farther from the curve than ChordTolerance,
   * because the distance is not continuous, as with virtual sources of approximate distances.
   */
  vtkGetMacro(NumberOfFallbacks, vtkIdType);

protected:
  vtkApolloniusIsolines();
  ~vtkApolloniusIsolines() override;

private:
  vtkApolloniusIsolines(const vtkApolloniusIsolines&) = delete;
  void operator=(const vtkApolloniusIsolines&) = delete;

  class vtkInternals;

  vtkNew<vtkContourValues> ContourValues;
  int Method = LocalSources;
  double ChordTolerance = 1e-3;
  bool GenerateRidges = false;
  bool GenerateBands = false;
  double MinimumRidgeAngle = 20.0;
  int SteinerPoints = 2;
  std::string DistanceArrayName = "GeodesicDistance";
  std::string VirtualSourceArrayName = "GeodesicVirtualSource";
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  bool UsedWindows = false;
  bool UsedVirtualSources = false;
  vtkIdType NumberOfFallbacks = 0;
};

#endif
