// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of distance filters. Internal.
#ifndef DGGDistanceInternals_h
#define DGGDistanceInternals_h

#include "DGGFilterInternals.h" // for the base

#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggVirtualSources.h" // for VirtualSources

#include <string> // for the names
#include <vector> // for the results

struct DGGSourceSet;
class vtkGeodesicDistanceAlgorithm;

/// A point array of doubles besides the distances.
struct DGGPointArray
{
  std::string Name;
  std::string Property; ///< property with the name of the array, for messages
  std::vector<std::vector<double>> Components; ///< each per vertex of the mesh
};

/// Arguments, all checked, and results of DGGDistanceInternals::ComputeDistances().
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
  /// Arrays of DGGDistanceInternals::DeclareArrays(), whose components are to be filled.
  std::vector<DGGPointArray> Arrays;

  /// True if results may be sparse, which requires that points and vertices coincide.
  bool MayBeSparse = false;
  /// True if the arrays above have one value per entry of Vertices instead of one per vertex.
  bool IsSparse = false;
  std::vector<dgg::Id> Vertices{}; ///< each once; all other vertices are unreached
};

/// The steps of an update of a vtkGeodesicDistanceAlgorithm, except the computation of distances.
class VTKDGGFILTERSGEODESIC_EXPORT DGGDistanceInternals : public DGGFilterInternals
{
public:
  explicit DGGDistanceInternals(vtkGeodesicDistanceAlgorithm* filter);

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override { return "use a smaller mesh or MaximumDistance"; }

  /// Fills the results of the task. Called with a mesh and at least one source, both checked.
  /// Returns an error, which is reported, or the status of an abort by the progress of the
  /// context. May throw.
  virtual dgg::Status ComputeDistances(DGGDistanceTask& task) = 0;

  /// Returns the point arrays that ComputeDistances() fills besides distances and nearest sources.
  /// Default none.
  virtual std::vector<DGGPointArray> DeclareArrays() const { return {}; }

private:
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  void AddResults(
    const DGGDistanceTask& task, const std::vector<bool>& isReached, vtkPolyData* output);

  vtkGeodesicDistanceAlgorithm* Filter;
};

#endif
