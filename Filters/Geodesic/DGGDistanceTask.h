// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a distance filter computes from, and where it puts the answer. Internal.
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
  std::string Property;                        ///< whose setter names the array, for messages
  std::vector<std::vector<double>> Components; ///< each per vertex of the mesh
};

/// One call of vtkGeodesicDistanceAlgorithm::ComputeDistances(). Everything in it has been checked.
struct DGGDistanceTask
{
  const DGGContext& Context;
  const std::vector<dgg::GeodesicSource>& Sources; ///< at least one
  /// Vertices farther than this may be left unreached; dgg::Infinity when there is no limit.
  double MaximumDistance;
  bool WantNearestSource; ///< whether NearestSource has to be filled
  bool WantVirtualSource; ///< whether VirtualSource has to be filled

  std::vector<double> Distances;      ///< per vertex of the mesh; dgg::Infinity where unreached
  std::vector<dgg::Id> NearestSource; ///< per vertex, index into Sources; dgg::NoId if unreached
  dgg::VirtualSources VirtualSource;
  dgg::EdgeWindows Windows; ///< may stay empty
  /// As vtkGeodesicDistanceAlgorithm::DeclareArrays() wants them; their components are to be
  /// filled.
  std::vector<DGGPointArray> Arrays;

  /// True if results may be sparse, which requires that points and vertices coincide.
  bool MayBeSparse = false;
  /// True if the arrays above have one value per entry of Vertices instead of one per vertex.
  bool IsSparse = false;
  std::vector<dgg::Id> Vertices{}; ///< vertices that may be reached, each once; all others are not
};

#endif
