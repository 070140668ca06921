// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How all filters build a graph. Internal.
#ifndef vtkDGGGraphBuild_h
#define vtkDGGGraphBuild_h

#include "dggGraphBuilder.h" // for GraphBuilder

#include "vtkType.h" // for vtkTypeUInt64

#include <cstddef> // for std::size_t

class vtkDGGPreparedMesh;

/// Have a graph built, or its memory estimated, with the threads of VTK.
void vtkDGGUseThreads(dgg::GraphOptions& options);

/// Build a graph of the mesh of `builder` with the threads of VTK, unless it would take more memory
/// than the limit (0: the default one). `estimate` is what it was predicted to take.
dgg::Status vtkDGGBuildGraph(const dgg::GraphBuilder& builder, const vtkDGGPreparedMesh& mesh,
  dgg::GraphOptions options, vtkTypeUInt64 memoryLimit, dgg::GeodesicGraph& graph,
  dgg::GraphEstimate& estimate);

/// Bytes that a builder of the mesh takes, about.
std::size_t vtkDGGEstimateBuilder(const vtkDGGPreparedMesh& mesh);

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphBuild.h
