// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest-point samples of a surface, at vertices or anywhere.
#ifndef dggSurfaceSampler_h
#define dggSurfaceSampler_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the samples

namespace dgg
{
class SampleDistances;
struct GraphSeed;

struct SamplerOptions
{
  /// Number of samples, including given ones; fewer if there are not enough vertices.
  Offset NumberOfSamples = 100;
  /// Stop as soon as no vertex is farther from the samples than this distance.
  double CoveringRadius = 0.0;
  /// Initial samples, all of which are part of the result.
  std::vector<SurfacePoint> Given;
  /// The first sample if none is given. NoId means the vertex that is farthest from the first
  /// vertex with edges.
  Id FirstVertex = NoId;
  /// If true, samples may lie inside faces: instead of the farthest vertex, the farthest point
  /// close to it is used, if it is farther along the graph. If there are fewer than two vertices
  /// per sample (and at most 1000 samples), up to 64 points per sample (10000 in total) inside
  /// faces and on edges are treated like vertices: they may be samples, and covering radii include
  /// them.
  bool InFaces = false;
  ProgressCallback Progress; ///< may be empty
};

struct SurfaceSample
{
  SurfacePoint Point;
  /// Graph distance of the farthest vertex (see also InFaces) from the samples so far, including
  /// this one. Infinity while there are components without a sample.
  double CoveringRadius = 0.0;
};

/// Computes farthest-point samples, see FarthestPoints. Covering radii never grow from one sample
/// to the next. Each sample that was not given is at least as far from all others, along the graph,
/// as the last covering radius; this also holds in faces. `builder` links samples that are not at
/// vertices with `accuracy`, and may be null if there are none and InFaces is off; `mesh` may be
/// null for clouds. `samples` is empty on failure.
DGG_CORE_EXPORT Status SampleSurface(const GraphView& graph, const SurfaceMesh* mesh,
  const GraphBuilder* builder, double accuracy, const SamplerOptions& options,
  std::vector<SurfaceSample>& samples);

/// Like SampleSurface() with InFaces off, with the given distances, to which no sample has been
/// added. `given` has the seeds of each given sample. `samples` must be empty.
DGG_CORE_EXPORT Status SampleVertices(SampleDistances& points,
  const std::vector<std::vector<GraphSeed>>& given, const SamplerOptions& options,
  std::vector<SurfaceSample>& samples);
}

#endif
