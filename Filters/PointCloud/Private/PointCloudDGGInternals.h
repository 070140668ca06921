// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of vtkPointCloudDGG, with the graph kept between updates. Internal.
#ifndef PointCloudDGGInternals_h
#define PointCloudDGGInternals_h

#include "vtkPointCloudDGG.h"

#include "DGGFilterInternals.h" // for the base
#include "DGGGraphArrays.h"     // for the graph

#include "dggCloudGraphBuilder.h" // for options and statistics

#include "vtkTimeStamp.h" // for the time of the build

#include <memory> // for normals
#include <string> // for the remedy
#include <vector> // for components

class vtkDataArray;

class vtkPointCloudDGG::vtkInternals : public DGGInternalsOf<vtkPointCloudDGG>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Current = Findings(); }
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* vtkNotUsed(input)) const override { return true; }
  std::string GetMemoryRemedy() const override
  {
    return "Use fewer points, a larger {Accuracy}, a smaller {Alpha} or a smaller {Resolution}";
  }

  /// Predicts the memory of the graph without building it.
  dgg::Status Predict();

  /// Values of a graph that getters return.
  struct Findings
  {
    dgg::GraphSummary Graph;
    std::vector<dgg::Id> ComponentSizes;
    dgg::CloudGraphStatistics Statistics;
  };
  using Normals = std::shared_ptr<const std::vector<double>>;

  DGGGraphArrays Built;
  dgg::Signature BuiltBy{};        ///< key of options and normals
  std::vector<dgg::Id> Components; // components of the graph that was built
  Findings BuiltFindings;
  Findings Current; // findings of the last update
  dgg::CloudGraphEstimate Estimate;
  vtkTimeStamp BuildTime;

  // Normals of fitted planes, kept while points are unchanged.
  Normals PlaneNormals;
  vtkMTimeType NormalsMesh = 0;
  int NormalsNeighbors = 0;

private:
  /// Origin of the normals.
  struct NormalsSource
  {
    vtkDataArray* Given = nullptr; ///< normals of the input
    bool ByPlanes = false;
    int NumberOfNeighbors = 0; ///< number of points per plane
  };
  vtkDataArray* GetInputNormals(vtkPolyData* cloud) const;
  dgg::Status CheckInputNormals(vtkPolyData* cloud) const;
  NormalsSource MakeNormalsSource(vtkPolyData* cloud) const;
  dgg::CloudGraphOptions MakeOptions() const;
  dgg::Status FindNormals(
    const DGGContext& context, const NormalsSource& source, Normals& normals, double& done);
  dgg::Status Build(const DGGContext& context, const dgg::CloudGraphOptions& options, double done);
};

#endif
