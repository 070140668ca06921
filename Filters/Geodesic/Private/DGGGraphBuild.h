// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How all filters build a graph. Internal.
#ifndef DGGGraphBuild_h
#define DGGGraphBuild_h

#include "dggGraphBuilder.h" // for GraphBuilder

#include <cstddef> // for std::size_t

namespace dgg
{
class PreparedSurface;
}
struct DGGContext;

/// Have a graph built, or its memory estimated, with the threads of VTK.
void DGGUseThreads(const DGGContext& context, dgg::GraphOptions& options);

/// Build a graph of the surface, which `builder` is of, unless it would take more memory than the
/// limit. `estimate` is what it was predicted to take.
dgg::Status DGGBuildGraph(const DGGContext& context, const dgg::GraphBuilder& builder,
  dgg::GraphOptions options, dgg::GeodesicGraph& graph, dgg::GraphEstimate& estimate);

/// Bytes that a builder of the mesh takes, about.
std::size_t DGGEstimateBuilder(const dgg::PreparedSurface& mesh);

#endif
