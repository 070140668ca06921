// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a vtkPointCloudDGG keeps between updates. Internal.
#ifndef PointCloudDGGInternals_h
#define PointCloudDGGInternals_h

#include "vtkPointCloudDGG.h"

#include "DGGGraphArrays.h" // for the graph

#include "dggCloudGraphBuilder.h" // for options and statistics

#include "vtkTimeStamp.h" // for the time of the build

#include <vector> // for components

struct vtkPointCloudDGG::vtkInternals
{
  /// What is reported of a graph.
  struct Findings
  {
    dgg::GraphSummary Graph;
    std::vector<dgg::Id> ComponentSizes;
    dgg::CloudGraphStatistics Statistics;
  };
  DGGGraphArrays Built;
  dgg::Signature BuiltBy{};        ///< options and normals
  std::vector<dgg::Id> Components; // of what was built
  Findings BuiltFindings;
  Findings Current; // of the last update
  dgg::CloudGraphEstimate Estimate;
  vtkTimeStamp BuildTime;

  // By planes, kept while points are the same.
  Normals PlaneNormals;
  vtkMTimeType NormalsMesh = 0;
  int NormalsNeighbors = 0;
};

#endif
