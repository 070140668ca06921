// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSampleSearch.h"

#include "dggCounted.h"
#include "dggGraphSession.h"
#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggPropertyChecks.h"
#include "dggStatus.h"
#include "dggSurfaceOutput.h"

#include <algorithm>

namespace dgg
{
//------------------------------------------------------------------------------
Status CheckFirstSample(Offset point, Offset numberOfPoints)
{
  return point >= -1 && point < numberOfPoints
    ? Status::Success()
    : InvalidInput("{FirstSample} ", point, " is out of range: the input has ",
        Counted(numberOfPoints, "point"))
        .At("FirstSample", point)
        .Fix("Use an id from 0 to ", numberOfPoints - 1, ", or -1");
}

//------------------------------------------------------------------------------
Status SetFirstSample(const PreparedSurface& surface, Offset point, SamplerOptions& options)
{
  DGG_RETURN_IF_ERROR(
    CheckFirstSample(point, surface.GetMeshWithoutAngles().GetNumberOfVertices()));
  options.FirstVertex = point < 0 ? NoId : surface.GetVertex(point);
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CheckSamplerOptions(const SamplerOptions& options)
{
  return options.NumberOfSamples < 1
    ? InvalidValue("NumberOfSamples", options.NumberOfSamples).Fix("Use a number of at least 1")
    : CheckLengths({ { "CoveringRadius", options.CoveringRadius } });
}

//------------------------------------------------------------------------------
Status FindSamples(const TaskContext& context, GraphSession& graph, SamplerOptions options,
  std::vector<SurfaceSample>& samples)
{
  const PreparedSurface& surface = context.Surface;
  options.InFaces = options.InFaces && !surface.IsCloud();
  for (SurfacePoint& point : options.Given)
  {
    point = surface.IsCloud() ? SurfacePoint::AtVertex(point.Vertex) : point;
  }
  const bool needsLinks =
    options.InFaces || !std::all_of(options.Given.begin(), options.Given.end(), IsVertex);
  DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context, needsLinks));
  options.Progress = graph.GetRemainingProgress(context);
  return SampleSurface(graph.GetSearch().GetGraph(),
    surface.IsCloud() ? nullptr : &surface.GetMesh(), needsLinks ? &graph.GetBuilder() : nullptr,
    graph.GetLinkAccuracy(), options, samples);
}

//------------------------------------------------------------------------------
void WriteSamples(const TaskContext& context, const SamplerOptions& options,
  const std::vector<SurfaceSample>& samples, Output& output)
{
  std::vector<SurfacePoint> points;
  for (const SurfaceSample& sample : samples)
  {
    points.push_back(sample.Point);
  }
  WriteSurfacePoints(context, points, output);
  DescribeSamples(options, samples, context.Surface.IsCloud(), output);
}

//------------------------------------------------------------------------------
void DescribeSamples(const SamplerOptions& options, const std::vector<SurfaceSample>& samples,
  bool isCloud, Output& output)
{
  double* const radii = output.PointData.Add<double>("CoveringRadius", samples.size());
  std::transform(samples.begin(), samples.end(), radii,
    [](const SurfaceSample& sample) { return sample.CoveringRadius; });

  const double radius = samples.empty() ? 0.0 : samples.back().CoveringRadius;
  if (static_cast<Offset>(samples.size()) < options.NumberOfSamples && !(radius > 0.0))
  {
    const char* const others = isCloud ? ""
      : options.InFaces                ? ", or subdivide the surface"
                                       : ", turn on {InFaces}, or subdivide the surface";
    output.Warnings.push_back(JoinText("No point of the ", isCloud ? "cloud" : "surface",
      " is left after ", Counted(samples.size(), "sample"), ", but {NumberOfSamples} is ",
      options.NumberOfSamples, ". Reduce {NumberOfSamples}", others));
  }
  if (!(radius < Infinity))
  {
    output.Warnings.push_back(
      JoinText("The surface has more components than there are samples (", samples.size(),
        "). Some components have no sample, and the covering radius is infinite. Use a larger "
        "{NumberOfSamples}"));
  }
}
}
