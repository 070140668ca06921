// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolineCases.h"

#include "BenchmarkTools.h"
#include "IsolineStatistics.h"
#include "PeerContour.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
/// The smallest of several times counts: a busy machine disturbs some of them only. What takes long
/// is run fewer times.
constexpr int MostRounds = 5;
constexpr double EnoughSeconds = 1.0;

double TimeOf(const std::function<void()>& run)
{
  double smallest = dgg::Infinity;
  double sum = 0.0;
  for (int round = 0; round < MostRounds && sum < EnoughSeconds; ++round)
  {
    const double start = ThreadSeconds();
    run();
    const double seconds = ThreadSeconds() - start;
    smallest = std::min(smallest, seconds);
    sum += seconds;
  }
  return smallest;
}

/// A field, and the exact one of the same mesh.
struct OpenedField
{
  BenchmarkMesh* Mesh = nullptr;
  const MeasuredField* Field = nullptr;
  const MeasuredField* Exact = nullptr;
  std::vector<double> Levels;
};

std::vector<double> SpreadLevels(const std::vector<double>& distances, int count)
{
  double largest = 0.0;
  for (const double distance : distances)
  {
    largest = std::isfinite(distance) ? std::max(largest, distance) : largest;
  }
  std::vector<double> levels;
  for (int k = 1; k <= count; ++k)
  {
    levels.push_back(largest * k / (count + 1));
  }
  return levels;
}

OpenedField OpenField(const IsolineRecipe& recipe)
{
  OpenedField opened;
  opened.Mesh = &OpenMesh(recipe.Mesh);
  const auto get = [&](FieldInput input) {
    return &GetMeasuredField(*opened.Mesh, recipe.Mesh.Name, input, recipe.Accuracy);
  };
  opened.Exact = get(FieldInput::Exact);
  opened.Field = get(recipe.Input);
  Require(opened.Exact->GetError());
  Require(opened.Field->GetError());
  opened.Levels = SpreadLevels(opened.Exact->GetDistances(), recipe.Levels);
  return opened;
}

/// Time `trace`, which must free what it made before, and report the memory that it takes at most.
void TimeTracing(
  benchmark::State& state, const OpenedField& opened, const std::function<void()>& trace)
{
  const MemoryProbe probe;
  for (auto unused : state)
  {
    (void)unused;
    state.SetIterationTime(TimeOf(trace));
  }
  ReportMesh(state, *opened.Mesh);
  ReportMemory(state, *opened.Mesh, probe);
  state.counters["levels"] = static_cast<double>(opened.Levels.size());
}

void ReportErrorsOf(
  benchmark::State& state, const OpenedField& opened, const std::vector<IsolineSegment>& segments)
{
  IsolineStatistics(opened.Exact->WithWindows(), segments).Report(state);
}

/// Time what fills `lines`, and report these.
void MeasureLines(benchmark::State& state, const OpenedField& opened,
  const std::function<dgg::Status(dgg::Isolines&)>& trace)
{
  dgg::Isolines lines;
  dgg::Status status;
  TimeTracing(state, opened, [&] { status = trace(lines); });
  Require(status);
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  state.counters["lines"] = static_cast<double>(lines.Lines.size());
  state.counters["closed"] =
    static_cast<double>(std::count(lines.IsClosed.begin(), lines.IsClosed.end(), true));
  state.counters["fallbacks"] = static_cast<double>(lines.Fallbacks);
  ReportErrorsOf(state, opened, ToSegments(surface, lines, opened.Levels));
}
}

void MeasureInput(benchmark::State& state, const IsolineRecipe& recipe)
{
  const OpenedField opened = OpenField(recipe);
  for (auto unused : state)
  {
    (void)unused;
    state.SetIterationTime(
      TimeOf([&] { const MeasuredField field(*opened.Mesh, recipe.Input, recipe.Accuracy); }));
  }
  ReportMesh(state, *opened.Mesh);
  const dgg::Id source = SourceOfFields(*opened.Mesh);
  opened.Mesh->SetExactDistances(source, opened.Exact->GetDistances());
  ReportErrors(state, *opened.Mesh, source, opened.Field->GetDistances());
}

void MeasureContour(benchmark::State& state, const IsolineRecipe& recipe)
{
  const OpenedField opened = OpenField(recipe);
  PeerContour peer(opened.Mesh->GetArrays(), opened.Field->GetDistances(), opened.Levels);
  TimeTracing(state, opened, [&] { peer.Run(); });
  ReportErrorsOf(state, opened, peer.GetSegments(opened.Mesh->GetSurface()));
}

void MeasureIsolines(
  benchmark::State& state, const IsolineRecipe& recipe, IsolineKind kind, double chord)
{
  const OpenedField opened = OpenField(recipe);
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  dgg::VirtualSources fitted;
  dgg::DistanceField field =
    kind == IsolineKind::Windows ? opened.Field->WithWindows() : opened.Field->WithSources();
  dgg::IsolineOptions options;
  options.ChordTolerance = chord * surface.GetMeanEdgeLength();
  state.counters["chord"] = chord;
  MeasureLines(state, opened, [&](dgg::Isolines& lines) {
    if (kind == IsolineKind::Fitted)
    {
      dgg::FitVirtualSources(surface, field.Distances, nullptr, fitted);
      field.Sources = &fitted;
    }
    return dgg::TraceIsolines(field, opened.Levels, options, nullptr, nullptr, lines);
  });
}

void MeasureApollonius(benchmark::State& state, const IsolineRecipe& recipe, int steinerPoints)
{
  const OpenedField opened = OpenField(recipe);
  const dgg::DistanceField field = opened.Field->WithSources();
  dgg::IsolineOptions options;
  options.Method = dgg::IsolineMethod::Apollonius;
  options.SteinerPoints = steinerPoints;
  state.counters["steiner_points"] = steinerPoints;
  MeasureLines(state, opened, [&](dgg::Isolines& lines) {
    return dgg::TraceIsolines(field, opened.Levels, options, nullptr, nullptr, lines);
  });
}
