// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudCases.h"

#include "BenchmarkTools.h"
#include "dggBandMarching.h"

#include <cmath>

namespace
{
/// How far the size of voxels may be from what a case asks for: random points do not quite reach
/// the sides of what they sample.
constexpr double VoxelTolerance = 0.01;

/// The cloud of a recipe; an error when it cannot be used.
MeasuredCloud& OpenCloud(const CloudRecipe& recipe)
{
  MeasuredCloud& cloud = GetMeasuredCloud(recipe);
  Require(cloud.GetError());
  return cloud;
}

/// The same, with its graph.
MeasuredCloud& OpenCloudWithGraph(const CloudGraphRecipe& recipe)
{
  MeasuredCloud& cloud = OpenCloud(recipe.Cloud);
  cloud.NeedGraph(recipe);
  Require(cloud.GetGraphError());
  return cloud;
}

void ReportCloudErrors(benchmark::State& state, MeasuredCloud& cloud, dgg::Id source,
  const std::vector<double>& distances)
{
  const std::vector<double>& truth = cloud.GetTruth(source);
  Require(cloud.GetError());
  ReportErrors(state, ErrorStatistics::Of(distances, truth));
}

void ReportCloudGraph(benchmark::State& state, const MeasuredCloud& cloud)
{
  const dgg::CloudGraph& graph = cloud.GetGraph();
  const dgg::CloudGraphStatistics& used = cloud.GetStatistics();
  const auto edges = static_cast<double>(graph.Graph.Targets.Size());
  state.counters["points"] = cloud.GetSize();
  state.counters["degree"] = edges / cloud.GetSize();
  state.counters["graph_bytes"] = static_cast<double>(graph.Graph.GetMemorySize());
  state.counters["false_edges"] = static_cast<double>(cloud.CountFalseEdges(graph.Graph.View()));
  state.counters["components"] = static_cast<double>(graph.ComponentSizes.size());
  state.counters["dropped_faces"] = static_cast<double>(cloud.CountDroppedFaces());
  state.counters["spacing"] = used.Spacing;
  state.counters["noise"] = used.Noise;
  state.counters["offset_in_voxels"] = used.OffsetInVoxels;
  state.counters["resolution"] = used.Resolution;
  state.counters["alpha"] = used.Alpha;
  state.counters["reach"] = used.Reach;
}

std::vector<dgg::Point3> PlacesOf(const MeasuredCloud& cloud)
{
  const std::vector<double>& points = cloud.GetPoints();
  std::vector<dgg::Point3> places;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    places.push_back({ points[i], points[i + 1], points[i + 2] });
  }
  return places;
}
}

void MeasureCloudBuild(benchmark::State& state, const CloudGraphRecipe& recipe)
{
  MeasuredCloud& cloud = OpenCloud(recipe.Cloud);
  double seconds = 0.0;
  std::size_t peak = 0;
  Measure(
    state, [&] { cloud.Clear(); },
    [&] {
      const MemoryProbe probe;
      const double start = CPUSeconds();
      cloud.Build(recipe);
      seconds += CPUSeconds() - start;
      peak = probe.GetResidentPeak();
    },
    WallSeconds);
  Require(cloud.GetGraphError());
  const double size = recipe.VoxelSize;
  Require(size <= 0.0 || std::abs(cloud.GetStatistics().VoxelSize - size) <= VoxelTolerance * size,
    "the voxels are not of the size that the case is about");
  state.counters["threads"] = recipe.Threads;
  state.counters["accuracy"] = recipe.Options.Accuracy;
  state.counters["cpu_seconds"] = benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
  state.counters["resident_bytes"] = static_cast<double>(peak);
  ReportCloudGraph(state, cloud);
}

void MeasureCloudEstimate(benchmark::State& state, const CloudGraphRecipe& recipe)
{
  MeasuredCloud& cloud = OpenCloud(recipe.Cloud);
  dgg::CloudGraphOptions options = recipe.Options;
  options.Parallel = ThreadedLoop(recipe.Threads);
  dgg::CloudGraphEstimate estimate;
  dgg::Status status;
  Measure(
    state, [] {}, [&] { status = cloud.GetBuilder().Estimate(options, estimate); }, WallSeconds);
  Require(status);
  state.counters["estimated_graph_bytes"] = estimate.Memory;
  state.counters["estimated_peak_bytes"] = estimate.Peak;
}

void MeasureCloudQuery(
  benchmark::State& state, const CloudGraphRecipe& recipe, int k, int numberOfSources)
{
  MeasuredCloud& cloud = OpenCloudWithGraph(recipe);
  dgg::GraphSeed seed;
  seed.Vertex = cloud.GetSource(k, numberOfSources);
  const dgg::GraphSearch& search = cloud.GetSearch();
  dgg::SearchResult result;
  dgg::Status status = search.Run({ seed }, {}, result); // not the first query
  Measure(
    state, [] {}, [&] { status = search.Run({ seed }, {}, result); });
  Require(status);
  ReportCloudErrors(state, cloud, seed.Vertex, result.Distances);
}

void MeasureBandMarching(
  benchmark::State& state, const CloudGraphRecipe& recipe, int k, int numberOfSources)
{
  MeasuredCloud& cloud = OpenCloudWithGraph(recipe);
  const dgg::CloudGraph& graph = cloud.GetGraph();
  const std::vector<dgg::Point3> places = PlacesOf(cloud);
  const dgg::Id source = cloud.GetSource(k, numberOfSources);
  dgg::VoxelBand band;
  dgg::Status status =
    band.Build(places, graph.Radii, graph.VoxelSize, 0, ThreadedLoop(recipe.Threads));
  Require(status);
  const dgg::BandMarching marching(band);
  dgg::BandMarchingResult result;
  Measure(
    state, [] {},
    [&] {
      status = marching.Run({ { places[source], 0.0 } }, places, {}, result);
    });
  Require(status);
  state.counters["voxels"] = static_cast<double>(band.GetNumberOfVoxels());
  state.counters["resolution"] = band.GetResolution();
  ReportCloudErrors(state, cloud, source, result.Distances);
}
