// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of distance filters. Internal.
#ifndef DGGDistanceInternals_h
#define DGGDistanceInternals_h

#include "DGGFilterInternals.h" // for the base

#include "dggDistanceOutput.h" // for DistanceResults
#include "dggGeodesicSource.h" // for GeodesicSource

#include <vector> // for the results

struct DGGSourceSet;
class vtkGeodesicDistanceAlgorithm;

/// Arguments, all checked, and results of DGGDistanceInternals::ComputeDistances(). `Arrays` come
/// from DGGDistanceInternals::DeclareArrays(), and their components are to be filled. Vertices
/// farther than MaximumDistance may be left unreached.
struct DGGDistanceTask : public dgg::DistanceResults
{
  const DGGContext& Context;
  const std::vector<dgg::GeodesicSource>& Sources; ///< at least one
  bool WantNearestSource = false;                  ///< true if NearestSource is requested
  bool WantVirtualSource = false;                  ///< true if VirtualSource is requested
  bool MayBeSparse = false;                        ///< true if IsSparse is allowed
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
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or a {MaximumDistance}";
  }

  /// Fills the results of the task. Called with a mesh and at least one source, both checked.
  /// Returns an error, which is reported, or the status of an abort by the progress of the
  /// context. May throw.
  virtual dgg::Status ComputeDistances(DGGDistanceTask& task) = 0;

  /// Returns the point arrays that ComputeDistances() fills besides distances and nearest sources.
  /// Default none.
  virtual std::vector<dgg::VertexArray> DeclareArrays() const { return {}; }

private:
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  void AddResults(
    const DGGDistanceTask& task, const std::vector<bool>& isReached, vtkPolyData* output) const;

  vtkGeodesicDistanceAlgorithm* Filter;
};

#endif
