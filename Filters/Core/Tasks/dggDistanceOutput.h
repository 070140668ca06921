// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tasks that compute distances, and their arrays in outputs. Internal.
#ifndef dggDistanceOutput_h
#define dggDistanceOutput_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggOutput.h"         // for Output
#include "dggStatus.h"         // for Status
#include "dggVirtualSources.h" // for VirtualSources

#include <functional> // for methods
#include <limits>     // for NaN
#include <string>     // for names
#include <vector>     // for distances

namespace dgg
{
class PreparedSurface;
struct SourceCollection;
struct TaskContext;

/// An array of vectors with a value per vertex, each component by itself.
struct VertexArray
{
  std::string Name;
  std::string Property; ///< property with the name of the array, for messages
  std::vector<std::vector<double>> Components;
};

/// Distances from sources, and arrays that belong to them, per vertex of the mesh.
struct DistanceResults
{
  /// Farther vertices count as unreached; Infinity without a limit.
  double MaximumDistance = Infinity;
  std::vector<double> Distances; ///< Infinity where unreached
  std::vector<Id> NearestSource; ///< index of the source; NoId if unreached; may be empty
  VirtualSources VirtualSource;  ///< may be empty
  EdgeWindows Windows;           ///< may be empty
  std::vector<VertexArray> Arrays;

  /// True if the arrays above have one value per entry of Vertices instead of one per vertex.
  /// Requires that points and vertices of the surface coincide.
  bool IsSparse = false;
  std::vector<Id> Vertices; ///< each once; all other vertices are unreached

  std::string QualityWarning; ///< reasons why distances may be far off; empty without

  /// True if points of other pieces of the surface are unreached. All pieces then have the same
  /// arrays.
  bool AreOthersUnreached = false;
};

/// Results, their sources and what is requested. Vertices farther than MaximumDistance may be left
/// unreached. The caller declares `Arrays`; the computation fills their components.
struct DistanceTask : public DistanceResults
{
  const std::vector<GeodesicSource>& Sources; ///< at least one
  bool WantNearestSource = false;             ///< true if NearestSource is requested
  bool WantVirtualSource = false;             ///< true if VirtualSource is requested
  bool MayBeSparse = false;                   ///< true if IsSparse is allowed
};

struct DistanceNames
{
  std::string Distance;
  std::string Source; ///< array of nearest sources
  std::string VirtualSource;
};

/// Options of a distance computation.
struct DGG_CORE_EXPORT DistanceRequest
{
  /// Fails if a limit is negative or NaN, or if the name of an array is empty or used twice.
  Status Check() const;

  double MaximumDistance = Infinity;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  bool WantNearestSource = false;
  bool WantVirtualSource = false;
  bool WantSourceOfPoints = false; ///< true if DistanceOutput::SourceOfPoints is requested
  DistanceNames Names;
  std::vector<VertexArray> Arrays; ///< arrays that the method fills besides those above
};

/// Arrays at the points of the surface, with warnings about sources and accuracy.
struct DistanceOutput : public Output
{
  std::vector<bool> IsReached;    ///< per vertex
  std::vector<Id> SourceOfPoints; ///< nearest source per point of the input; NoId if unreached
  std::string QualityWarning;     ///< set even if the computation fails
};

/// Locates the sources, computes distances by `method`, and writes the results. Warnings about
/// sources remain after a failure.
DGG_CORE_EXPORT Status FindDistances(const TaskContext& context, const SourceCollection& sources,
  double tolerance, const DistanceRequest& request,
  const std::function<Status(DistanceTask&)>& method, DistanceOutput& output);

/// Returns true for each vertex that is reached.
DGG_CORE_EXPORT std::vector<bool> FindReached(
  const PreparedSurface& surface, const DistanceResults& results);

/// Returns true if more than half of the vertices are reached.
DGG_CORE_EXPORT bool AreMostReached(const std::vector<bool>& isReached);

/// Adds the results as point arrays of the surface, with the requested value (-1 for nearest
/// sources) at unreached points, and marks of unreached points as AddDistances(). Windows become
/// field data.
DGG_CORE_EXPORT void WriteDistances(const PreparedSurface& surface, const DistanceResults& results,
  const std::vector<bool>& isReached, const DistanceRequest& request, Output& output);

/// Returns the name of the array that marks the unreached points of distances.
DGG_CORE_EXPORT std::string GetUnreachedName(const std::string& distances);

/// Adds an array of distances, with `unreachedValue` in place of Infinity. Since any number except
/// NaN and plus infinity could be a distance, such a value at unreached points adds the array of
/// GetUnreachedName() (std::uint8_t: 1 at unreached points, else 0). The array is also added if
/// `areOthersUnreached`.
DGG_CORE_EXPORT void AddDistances(const std::string& name, const std::vector<double>& distances,
  double unreachedValue, OutputArrays& arrays, bool areOthersUnreached = false);
}

#endif
