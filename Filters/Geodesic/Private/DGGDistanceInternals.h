// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of distance filters. Internal.
#ifndef DGGDistanceInternals_h
#define DGGDistanceInternals_h

#include "DGGFilterInternals.h" // for the base

#include "dggDistanceOutput.h" // for DistanceTask

#include <string> // for warnings
#include <vector> // for arrays

struct DGGSourceSet;
class vtkGeodesicDistanceAlgorithm;

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
  /// `Arrays` of the task come from DeclareArrays(). Returns an error, which is reported, or the
  /// status of an abort by the progress of the context. May throw.
  virtual dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) = 0;

  /// Reports why distances may be far off; an empty text for no reason.
  virtual void ReportQuality(const std::string& warning) { this->WarnAboutQuality(warning); }

  /// Returns the point arrays that ComputeDistances() fills besides distances and nearest sources.
  /// Default none.
  virtual std::vector<dgg::VertexArray> DeclareArrays() const { return {}; }

protected:
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  dgg::DistanceRequest MakeRequest() const;
  void AddResults(dgg::Output& results, vtkPolyData* output) const;

private:
  vtkGeodesicDistanceAlgorithm* Filter;
};

#endif
