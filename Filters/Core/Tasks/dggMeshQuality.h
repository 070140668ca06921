// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Criteria for meshes on which approximate distances are far off. Internal.
#ifndef dggMeshQuality_h
#define dggMeshQuality_h

#include "dggPreparedSurface.h" // for the mesh

#include "dggStatus.h"

#include <initializer_list> // for reasons
#include <string>           // for reasons

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
