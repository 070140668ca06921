// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Criteria for meshes on which approximate distances are far off. Internal.
#ifndef dggMeshQuality_h
#define dggMeshQuality_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggPreparedSurface.h" // for the mesh

#include "dggStatus.h"

#include <initializer_list> // for reasons
#include <string>           // for reasons
#include <vector>           // for distances

namespace dgg
{
/// Largest mean anisotropy, weighted by areas, without a warning. Measured on 16 scans and
/// mechanical parts and on 120 generated CAD models. Scans and parts are below 1.9, except one with
/// fine long triangles. Of the models whose distances are off by 10 % of the largest distance, all
/// but two are above 2.
constexpr double LargestAnisotropy = 2.0;

inline bool HasLongTriangles(const PreparedSurface& surface)
{
  return surface.GetMeanAnisotropy() > LargestAnisotropy;
}

/// Bound of the relative rounding error of a sum over all triangles. Sums over pieces are rounded
/// differently; where this may decide, pieces are gathered.
constexpr double SumMargin = 1e-6;

/// Returns true unless HasLongTriangles() is false for certain, given a sum over pieces.
inline bool MayHaveLongTriangles(const MeanAnisotropy& sum)
{
  return !(sum.Get() < (1.0 - SumMargin) * LargestAnisotropy);
}

/// Errors inside triangles that virtual sources are expected not to exceed, in mean edges: of
/// distances, and of borders between cells. Measured at ε = 0.1, 0.01 and 0.001 on 68 generated
/// machine parts and 9 scans.
/// @{
constexpr double ErrorInsideTriangles = 1.0;
constexpr double ErrorAtBorders = 0.25;
/// @}

/// Sizes of the reached triangles of a surface, or of a piece of one.
struct DGG_CORE_EXPORT ReachedTriangles
{
  double Nearest = Infinity;      ///< smallest distance of a corner
  double Farthest = 0.0;          ///< largest distance of a corner
  double Area = 0.0;              ///< twice the area
  double WeightedPerimeter = 0.0; ///< sum of perimeter times twice the area

  /// Adds a face if it is reached. `distances` are per vertex.
  void Add(const SurfaceMesh& mesh, Id f, const std::vector<double>& distances);
  void Add(const ReachedTriangles& piece);
  /// Returns true if accuracy times the largest distance is less than `error` mean edges. The mean
  /// is weighted by area. Because of initial distances, the smallest distance is subtracted from
  /// the largest one.
  bool AreCoarse(double accuracy, double error) const
  {
    return this->Area > 0.0 &&
      accuracy * (this->Farthest - this->Nearest) * this->Area <
      error * this->WeightedPerimeter / 3.0;
  }
};

/// Returns true if errors inside triangles may exceed the accuracy: on long triangles, or on coarse
/// ones.
DGG_CORE_EXPORT bool HasCoarseTriangles(const PreparedSurface& surface, double accuracy,
  const std::vector<double>& distances, double error);

/// Returns a warning with the consequence and the remedy if much of the surface is covered by long
/// triangles, otherwise an empty text.
inline std::string DescribeLongTriangles(
  const PreparedSurface& surface, const std::string& consequence)
{
  return HasLongTriangles(surface)
    ? JoinText("Much of the surface is covered by long triangles (mean anisotropy ",
        surface.GetMeanAnisotropy(), ", more than ", LargestAnisotropy, "): ", consequence)
    : std::string();
}

/// Consequences, with their remedies.
/// @{
constexpr const char* LongTrianglesMislead =
  "distances may be far off. Use exact distances or a graph, or remesh the surface";
constexpr const char* LongTrianglesHideSources =
  "inside them, distances from virtual sources may be off by more than half of the largest "
  "distance. Use exact distances with windows, or remesh the surface";
/// @}

/// Returns the warning if exact distances fail on coarse triangles, so that the graph is used.
/// A triangle is named if `error` times its mean edge exceeds the accuracy times the largest
/// distance of a corner. Without distances, all triangles count.
DGG_CORE_EXPORT std::string DescribeMissingWindows(const PreparedSurface& surface, double accuracy,
  const std::vector<double>& distances, double error, const Status& status);

/// Warning for results that did not converge (PropagationResult::IsSettled).
constexpr const char* UnsettledDistances =
  "Virtual sources did not settle on triangles this irregular: distances are the shortest ones "
  "found so far, and may be too long. Use exact distances or a graph, or remesh the surface";

/// Returns all reasons as one text; empty reasons are skipped.
inline std::string JoinReasons(std::initializer_list<std::string> reasons)
{
  std::string text;
  for (const std::string& reason : reasons)
  {
    text += (text.empty() || reason.empty() ? "" : ". ") + reason;
  }
  return text;
}
}

#endif
