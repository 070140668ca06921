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
namespace dgg
{
struct SourceCollection;
}
class vtkGeodesicDistanceAlgorithm;

/// The steps of an update of a vtkGeodesicDistanceAlgorithm, except the computation of distances.
class VTKDGGFILTERSGEODESIC_EXPORT DGGDistanceInternals : public DGGFilterInternals
{
public:
  explicit DGGDistanceInternals(vtkGeodesicDistanceAlgorithm* filter);

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override;
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
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

  /// Adds distances on a piece to the results, together with the other processes; the arguments are
  /// the same on all of them. `isDone` becomes false on all processes if the pieces must be
  /// gathered, which is the default.
  virtual dgg::Status ComputePiece(const DGGContext& context, const DGGPieceUpdate& update,
    const dgg::SourceCollection& sources, const dgg::DistanceRequest& request,
    dgg::DistanceOutput& results, bool& isDone);

  /// Reports why distances may be far off; an empty text for no reason.
  virtual void ReportQuality(const std::string& warning) { this->WarnAboutQuality(warning); }

  /// Returns the point arrays that ComputeDistances() fills besides distances and nearest sources.
  /// Default none.
  virtual std::vector<dgg::VertexArray> DeclareArrays() const { return {}; }

private:
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  dgg::Status CollectFromAll(
    const DGGPieceUpdate& update, dgg::SourceCollection& sources, bool& areUsable) const;
  dgg::DistanceRequest MakeRequest() const;
  void AddResults(dgg::Output& results, vtkPolyData* output) const;

  vtkGeodesicDistanceAlgorithm* Filter;
};

#endif
