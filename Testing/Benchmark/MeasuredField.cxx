// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredField.h"

#include "dggExactGeodesics.h"
#include "dggFastMarching.h"
#include "dggHeatMethod.h"
#include "dggSourceFinding.h"

#include <map>
#include <memory>
#include <utility>

namespace
{
std::vector<dgg::GeodesicSource> SourcesAt(dgg::Id vertex)
{
  return { { dgg::SurfacePoint::AtVertex(vertex), 0.0 } };
}
}

MeasuredField::MeasuredField(BenchmarkMesh& mesh, FieldInput input, double accuracy)
  : Surface(mesh.GetSurface())
{
  const dgg::Id source = SourceOfFields(mesh);
  dgg::Status status;
  switch (input)
  {
    case FieldInput::Exact:
      status = this->RunExact(source);
      break;
    case FieldInput::Graph:
      status = this->RunGraph(mesh, source, accuracy);
      break;
    case FieldInput::Heat:
      status = this->RunHeat(source);
      break;
    case FieldInput::Marching:
      status = this->RunMarching(source);
      break;
  }
  this->Error = status.GetMessage();
}

dgg::Status MeasuredField::RunExact(dgg::Id source)
{
  dgg::ExactOptions options;
  options.KeepWindows = true;
  dgg::ExactResult result;
  const dgg::Status status =
    dgg::ExactGeodesics(this->Surface).Run(SourcesAt(source), options, result);
  if (status.IsOk())
  {
    dgg::FindVirtualSources(this->Surface, SourcesAt(source), result, this->Sources);
    this->Distances = std::move(result.Distances);
    this->Windows = std::move(result.Windows);
  }
  return status;
}

dgg::Status MeasuredField::RunGraph(BenchmarkMesh& mesh, dgg::Id source, double accuracy)
{
  GraphRecipe recipe;
  recipe.Options.Accuracy = accuracy;
  recipe.Name = "graph"; // the only one
  MeasuredGraph& graph = mesh.GetGraph(recipe);
  graph.NeedGraph();
  if (!graph.GetError().empty())
  {
    return dgg::Status::Invalid(graph.GetError());
  }
  dgg::GraphSeed seed;
  seed.Vertex = source;
  dgg::SearchOptions options;
  options.Correct = true;
  dgg::SearchResult result;
  const dgg::Status status = graph.GetSearch().Run({ seed }, options, result);
  if (status.IsOk())
  {
    dgg::FindVirtualSources(this->Surface, result, result.Corrected, this->Sources);
  }
  this->Distances = std::move(result.Corrected);
  return status;
}

dgg::Status MeasuredField::RunHeat(dgg::Id source)
{
  dgg::HeatMethod heat(this->Surface);
  dgg::Status status = heat.Prepare({}, nullptr);
  if (!status.IsOk())
  {
    return status;
  }
  dgg::HeatQuery query;
  query.WantVirtualSource = true;
  dgg::HeatResult result;
  status = heat.Run(SourcesAt(source), query, result);
  this->Distances = std::move(result.Distances);
  this->Sources = std::move(result.Virtual);
  return status;
}

dgg::Status MeasuredField::RunMarching(dgg::Id source)
{
  dgg::MarchingOptions options;
  options.WantVirtualSource = true;
  dgg::MarchingResult result;
  const dgg::Status status =
    dgg::FastMarching(this->Surface).Run(SourcesAt(source), options, result);
  this->Distances = std::move(result.Distances);
  this->Sources = std::move(result.Virtual);
  return status;
}

dgg::DistanceField MeasuredField::Linear() const
{
  dgg::DistanceField field;
  field.Mesh = &this->Surface;
  field.Distances = this->Distances.data();
  return field;
}

dgg::DistanceField MeasuredField::WithSources() const
{
  dgg::DistanceField field = this->Linear();
  field.Sources = &this->Sources;
  return field;
}

dgg::DistanceField MeasuredField::WithWindows() const
{
  dgg::DistanceField field = this->Linear();
  field.Windows = &this->Windows;
  return field;
}

dgg::Id SourceOfFields(const BenchmarkMesh& mesh)
{
  return mesh.GetSource(0, 1);
}

const MeasuredField& GetMeasuredField(
  BenchmarkMesh& mesh, const std::string& name, FieldInput input, double accuracy)
{
  static std::map<FieldInput, std::unique_ptr<MeasuredField>> kept;
  static std::string nameOfKept;
  if (nameOfKept != name)
  {
    kept.clear(); // before the next ones need the memory
    nameOfKept = name;
  }
  std::unique_ptr<MeasuredField>& field = kept[input];
  if (!field)
  {
    field = std::make_unique<MeasuredField>(mesh, input, accuracy);
  }
  return *field;
}
