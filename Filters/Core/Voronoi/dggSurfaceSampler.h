// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest point samples of a surface, at vertices or anywhere.
#ifndef dggSurfaceSampler_h
#define dggSurfaceSampler_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the samples

namespace dgg
{
struct SamplerOptions
{
  /// As many samples, given ones included; fewer when there are no more vertices.
  Offset NumberOfSamples = 100;
  /// Stop as soon as no vertex is farther from the samples than this.
  double CoveringRadius = 0.0;
  /// Samples to start with; all of them are kept.
  std::vector<SurfacePoint> Given;
  /// The first sample when none is given. NoId means the vertex that is farthest from the
  /// first vertex that has edges.
  Id FirstVertex = NoId;
  /// Whether samples may lie inside faces: instead of the farthest vertex, the farthest point close
  /// to it is taken, where that is found to be farther along the graph. With fewer than two
  /// vertices for each sample (and no more than 1000 samples), up to 64 places for each sample
  /// (10000 in all) inside faces and on edges count as vertices do: they may be samples, and
  /// covering radii are those of all of them.
  bool InFaces = false;
  ProgressCallback Progress; ///< may be empty
};

struct SurfaceSample
{
  SurfacePoint Point;
  /// The distance from the samples so far, this one included, of the vertex that is farthest from
  /// them, along the graph; see InFaces as well. Infinity while there are components without a
  /// sample.
  double CoveringRadius = 0.0;
};

/// Farthest point samples, see FarthestPoints. Covering radii never grow from one sample to the
/// next, and the samples that have not been given are at least as far from all others, along the
/// graph, as the last covering radius says; in faces as well. `builder` links samples that are not
/// at vertices with `accuracy`, and may be null when there are none and InFaces is off; `mesh` may
/// be null for clouds. `samples` is empty on failure.
DGG_CORE_EXPORT Status SampleSurface(const GraphView& graph, const SurfaceMesh* mesh,
  const GraphBuilder* builder, double accuracy, const SamplerOptions& options,
  std::vector<SurfaceSample>& samples);
}

#endif
