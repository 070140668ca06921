// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathCases.h"

#include "BenchmarkTools.h"
#include "SampleStatistics.h"
#include "dggSiteDistances.h"
#include "dggSurfaceSampler.h"
#include "dggVoronoi.h"

#include <vector>

namespace
{
/// Number of rounds in which the compared methods are timed alternately. The smallest times are
/// compared, because other load on the machine affects only some of them.
constexpr int Rounds = 3;
constexpr int NumberOfQueries = 10;

double TimeOf(const std::function<void()>& run)
{
  const double start = CPUSeconds();
  run();
  return CPUSeconds() - start;
}

/// Runs queries from single vertices to all; corrections as in MeasureQuery().
void RunQueries(const OpenedGraph& opened, int count, bool correct, dgg::SearchResult& result)
{
  dgg::SearchOptions options;
  options.Correct = correct;
  for (int k = 0; k < count; ++k)
  {
    dgg::GraphSeed seed;
    seed.Vertex = opened.Mesh->GetSource(k, count);
    opened.Graph->GetSearch().Run({ seed }, options, result);
  }
}

dgg::Status Sample(const OpenedGraph& opened, int count, std::vector<dgg::SurfaceSample>& samples)
{
  dgg::SamplerOptions options;
  options.NumberOfSamples = count;
  options.FirstVertex = opened.Mesh->GetSource(0, 1);
  return dgg::SampleSurface(opened.Graph->GetGraph().View(), &opened.Mesh->GetSurface(), nullptr,
    opened.Graph->GetOptions().Accuracy, options, samples);
}

/// Converts samples to sites, with all input of boundary refinement except the builder.
dgg::VoronoiInput ToSites(const std::vector<dgg::SurfaceSample>& samples, double accuracy)
{
  dgg::VoronoiInput sites;
  sites.Accuracy = accuracy;
  for (const dgg::SurfaceSample& sample : samples)
  {
    dgg::GraphSeed seed;
    seed.Vertex = sample.Point.Vertex;
    seed.Source = static_cast<dgg::Id>(sites.Seeds.size());
    sites.Seeds.push_back(seed);
    sites.Places.push_back(sample.Point);
  }
  return sites;
}
}

void MeasureFarthestPoints(benchmark::State& state, const GraphRecipe& recipe, int samples)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  SampleStatistics queries;
  SampleStatistics sampling;
  std::vector<dgg::SurfaceSample> found;
  dgg::SearchResult result;
  dgg::Status status;
  RunQueries(opened, 1, false, result); // the first query is not measured
  for (auto unused : state)
  {
    (void)unused;
    for (int round = 0; round < Rounds; ++round)
    {
      queries.Add(TimeOf([&] { RunQueries(opened, NumberOfQueries, false, result); }));
      sampling.Add(TimeOf([&] { status = Sample(opened, samples, found); }));
    }
    state.SetIterationTime(sampling.GetMinimum());
  }
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["samples"] = static_cast<double>(found.size());
  state.counters["covering_radius"] = found.back().CoveringRadius;
  state.counters["ten_queries_seconds"] = queries.GetMinimum();
  state.counters["per_ten_queries"] = sampling.GetMinimum() / queries.GetMinimum();
}

void MeasureVoronoi(benchmark::State& state, const GraphRecipe& recipe, int samples)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  std::vector<dgg::SurfaceSample> found;
  dgg::Status status = Sample(opened, samples, found);
  Require(status);
  const dgg::VoronoiInput sites = ToSites(found, opened.Graph->GetOptions().Accuracy);
  dgg::VoronoiInput refined = sites;
  refined.Builder = &opened.Graph->GetBuilder();
  const dgg::GraphSearch& search = opened.Graph->GetSearch();
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  SampleStatistics query;
  SampleStatistics correctedQuery;
  SampleStatistics nearest;
  SampleStatistics labels;
  SampleStatistics diagrams;
  SampleStatistics refinedDiagrams;
  dgg::SearchResult result;
  dgg::VoronoiDiagram diagram;
  RunQueries(opened, 1, true, result); // the first query is not measured
  for (auto unused : state)
  {
    (void)unused;
    for (int round = 0; round < Rounds; ++round)
    {
      const auto one = [&](bool correct) {
        return TimeOf([&] { RunQueries(opened, NumberOfQueries, correct, result); }) /
          NumberOfQueries;
      };
      query.Add(one(false));
      correctedQuery.Add(one(true));
      nearest.Add(TimeOf([&] { status = search.Run(sites.Seeds, {}, result); }));
      labels.Add(TimeOf([&] {
        dgg::SiteDistances distances;
        status = distances.Run(search, surface, sites.Seeds, nullptr);
      }));
      const auto draw = [&](const dgg::VoronoiInput& input) {
        return TimeOf(
          [&] { status = dgg::ComputeVoronoi(search, surface, input, nullptr, diagram); });
      };
      diagrams.Add(draw(sites));
      refinedDiagrams.Add(draw(refined));
    }
    state.SetIterationTime(refinedDiagrams.GetMinimum());
  }
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["samples"] = static_cast<double>(found.size());
  state.counters["polygons"] = static_cast<double>(diagram.GetNumberOfPolygons());
  state.counters["query_seconds"] = query.GetMinimum();
  state.counters["corrected_query_seconds"] = correctedQuery.GetMinimum();
  state.counters["nearest_per_query"] = nearest.GetMinimum() / query.GetMinimum();
  state.counters["labels_seconds"] = labels.GetMinimum();
  state.counters["labels_per_query"] = labels.GetMinimum() / query.GetMinimum();
  state.counters["labels_per_corrected"] = labels.GetMinimum() / correctedQuery.GetMinimum();
  state.counters["diagram_per_query"] = diagrams.GetMinimum() / query.GetMinimum();
  state.counters["refined_per_query"] = refinedDiagrams.GetMinimum() / query.GetMinimum();
}
