// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCloud.h"

#include "BenchmarkTools.h"
#include "dggExactGeodesics.h"
#include "dggSurfacePath.h"

#include <utility>

namespace
{
constexpr unsigned int SampleSeed = 20190524u;

GeneratedCloud Generate(const CloudRecipe& recipe)
{
  switch (recipe.Shape)
  {
    case CloudShape::Square:
      return RandomSquare(recipe.Points);
    case CloudShape::Cylinder:
      return RandomCylinder(recipe.Points);
    case CloudShape::Sphere:
      return RandomSphere(recipe.Points, recipe.Noise, recipe.Density);
    case CloudShape::Sheets:
      return RandomSheets(recipe.Points, recipe.Gap);
    case CloudShape::Vertices:
    case CloudShape::Samples:
      break;
  }
  return {};
}

bool IsOfMesh(CloudShape shape)
{
  return shape == CloudShape::Vertices || shape == CloudShape::Samples;
}
}

MeasuredCloud::MeasuredCloud(const CloudRecipe& recipe)
{
  if (IsOfMesh(recipe.Shape))
  {
    this->TakeMesh(recipe);
    return;
  }
  GeneratedCloud generated = Generate(recipe);
  this->Points = std::move(generated.Points);
  this->Distance = std::move(generated.Distance);
}

void MeasuredCloud::TakeMesh(const CloudRecipe& recipe)
{
  this->Mesh = recipe.Mesh;
  const BenchmarkMesh& mesh = GetBenchmarkMesh(this->Mesh);
  this->Error = mesh.GetError();
  if (!this->Error.empty())
  {
    return;
  }
  const std::vector<double>& vertices = mesh.GetArrays().Points;
  if (recipe.Shape == CloudShape::Vertices)
  {
    this->Points = vertices;
    return;
  }
  this->Places = RandomPoints(mesh.GetSurface(), recipe.Points, false, SampleSeed);
  for (const dgg::SurfacePoint& place : this->Places)
  {
    const auto p = dgg::PositionOf(mesh.GetSurface(), place, vertices.data());
    this->Points.insert(this->Points.end(), p.begin(), p.end());
  }
}

dgg::Id MeasuredCloud::GetSource(int k, int numberOfSources) const
{
  if (this->Distance || !this->Places.empty())
  {
    return static_cast<dgg::Id>(static_cast<dgg::Offset>(this->GetSize()) * k / numberOfSources);
  }
  return GetBenchmarkMesh(this->Mesh).GetSource(k, numberOfSources);
}

const std::vector<double>& MeasuredCloud::GetTruth(dgg::Id source)
{
  const auto inserted = this->Truth.insert({ source, {} });
  std::vector<double>& truth = inserted.first->second;
  if (!inserted.second)
  {
    return truth;
  }
  if (this->Distance)
  {
    for (dgg::Id i = 0; i < this->GetSize(); ++i)
    {
      truth.push_back(this->Distance(source, i));
    }
    return truth;
  }
  dgg::ExactGeodesics solver(GetBenchmarkMesh(this->Mesh).GetSurface());
  dgg::ExactOptions options;
  options.Targets = this->Places;
  dgg::ExactResult result;
  const dgg::Status status = solver.Run(
    { { this->Places.empty() ? dgg::SurfacePoint::AtVertex(source) : this->Places[source], 0.0 } },
    options, result);
  this->Error = status.GetMessage();
  if (!status.IsOk())
  {
    return truth;
  }
  truth = std::move(this->Places.empty() ? result.Distances : result.TargetDistances);
  return truth;
}

std::size_t MeasuredCloud::CountDroppedFaces() const
{
  return this->Mesh.LongestEdge > 0.0 ? GetBenchmarkMesh(this->Mesh).GetNumberOfDroppedFaces() : 0;
}

std::size_t MeasuredCloud::CountFalseEdges(const dgg::GraphView& graph) const
{
  std::size_t count = 0;
  for (dgg::Id v = 0; this->Distance && v < graph.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      count += this->Distance(v, graph.Targets[e]) < dgg::Infinity ? 0 : 1;
    }
  }
  return count;
}

void MeasuredCloud::Build(const CloudGraphRecipe& recipe)
{
  dgg::CloudGraphOptions options = recipe.Options;
  if (recipe.Threads > 1)
  {
    options.Parallel = ThreadedLoop(recipe.Threads);
  }
  this->GraphError = this->GetBuilder().Build(options, this->Graph, &this->Statistics).GetMessage();
  this->GraphName = recipe.Name;
}

void MeasuredCloud::NeedGraph(const CloudGraphRecipe& recipe)
{
  if (this->GraphName != recipe.Name)
  {
    this->Clear();
    this->Build(recipe);
  }
}

void MeasuredCloud::Clear()
{
  this->Search.reset();
  this->Graph = dgg::CloudGraph();
  this->Statistics = dgg::CloudGraphStatistics();
  this->GraphError.clear();
  this->GraphName.clear();
}

const dgg::GraphSearch& MeasuredCloud::GetSearch()
{
  if (!this->Search)
  {
    this->Search = std::make_unique<dgg::GraphSearch>(this->Graph.Graph.View(), nullptr);
  }
  return *this->Search;
}

MeasuredCloud& GetMeasuredCloud(const CloudRecipe& recipe)
{
  static std::unique_ptr<MeasuredCloud> kept;
  static std::string name;
  if (!kept || name != recipe.Name)
  {
    kept.reset(); // before the next one needs the memory
    kept = std::make_unique<MeasuredCloud>(recipe);
    name = recipe.Name;
  }
  return *kept;
}
