// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Input and results of the computation of a distance filter. Internal.
#ifndef DGGDistanceTask_h
#define DGGDistanceTask_h

#include "DGGContext.h"         // for the update
#include "dggPreparedSurface.h" // for the surface

#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggVirtualSources.h" // for VirtualSources

#include <string> // for the names
#include <vector> // for the results

/// A point array of doubles besides the distances.
struct DGGPointArray
{
  std::string Name;
  std::string Property; ///< property with the name of the array, for messages
  std::vector<std::vector<double>> Components; ///< each per vertex of the mesh
};

/// Arguments, all checked, and results of vtkGeodesicDistanceAlgorithm::ComputeDistances().
struct DGGDistanceTask
{
  const DGGContext& Context;
  const std::vector<dgg::GeodesicSource>& Sources; ///< at least one
  /// Vertices farther than this may be left unreached; dgg::Infinity without a limit.
  double MaximumDistance;
  bool WantNearestSource; ///< true if NearestSource is requested
  bool WantVirtualSource; ///< true if VirtualSource is requested

  std::vector<double> Distances;      ///< per vertex of the mesh; dgg::Infinity where unreached
  std::vector<dgg::Id> NearestSource; ///< per vertex, index into Sources; dgg::NoId if unreached
  dgg::VirtualSources VirtualSource;
  dgg::EdgeWindows Windows; ///< may stay empty
  /// Arrays of vtkGeodesicDistanceAlgorithm::DeclareArrays(), whose components are to be filled.
  std::vector<DGGPointArray> Arrays;

  /// True if results may be sparse, which requires that points and vertices coincide.
  bool MayBeSparse = false;
  /// True if the arrays above have one value per entry of Vertices instead of one per vertex.
  bool IsSparse = false;
  std::vector<dgg::Id> Vertices{}; ///< each once; all other vertices are unreached
};

#endif
