// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest point samples of a surface or a cloud as an output. Internal.
#ifndef dggSampleSearch_h
#define dggSampleSearch_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggSurfaceSampler.h" // for SamplerOptions

namespace dgg
{
class GraphSession;
class PreparedSurface;
struct Output;
struct TaskContext;

/// Fails unless `point` is -1 or the id of a point of the input.
DGG_CORE_EXPORT Status CheckFirstSample(Offset point, Offset numberOfPoints);

/// Sets the first sample: a point of the input, or -1 for an automatic one. Fails if there is no
/// such point.
DGG_CORE_EXPORT Status SetFirstSample(
  const PreparedSurface& surface, Offset point, SamplerOptions& options);

/// Fails if an option is out of range.
DGG_CORE_EXPORT Status CheckSamplerOptions(const SamplerOptions& options);

/// Samples the surface. `graph` must be up to date. The progress of `options` is set here. Samples
/// of a cloud are points of the cloud: InFaces is ignored, and given points are moved to their
/// vertices.
DGG_CORE_EXPORT Status FindSamples(const TaskContext& context, GraphSession& graph,
  SamplerOptions options, std::vector<SurfaceSample>& samples);

/// Adds the point array `CoveringRadius` and the warnings of WriteSamples().
DGG_CORE_EXPORT void DescribeSamples(const SamplerOptions& options,
  const std::vector<SurfaceSample>& samples, bool isCloud, Output& output);

/// Writes the samples with the point array `CoveringRadius`. Warns if there are fewer than
/// requested, or fewer than components.
DGG_CORE_EXPORT void WriteSamples(const TaskContext& context, const SamplerOptions& options,
  const std::vector<SurfaceSample>& samples, Output& output);
}

#endif
