// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredGraph.h"

#include <cmath>

MeasuredGraph::MeasuredGraph(const dgg::SurfaceMesh& surface, const dgg::GraphOptions& options)
  : Surface(surface)
  , Options(options)
{
}

void MeasuredGraph::Build(const dgg::ParallelFor& parallel)
{
  dgg::GraphOptions options = this->Options;
  options.Parallel = parallel;
  const dgg::GraphBuilder builder(this->Surface);
  this->Error = builder.Build(options, this->Graph, &this->Statistics).GetMessage();
}

void MeasuredGraph::NeedGraph()
{
  if (this->Graph.Offsets.IsEmpty() && this->Error.empty())
  {
    this->Build({});
  }
}

void MeasuredGraph::Clear()
{
  this->Search.reset();
  this->Builder.reset();
  this->Graph = dgg::GeodesicGraph();
  this->Statistics = dgg::GraphStatistics();
  this->Error.clear();
}

void MeasuredGraph::PrepareSearch()
{
  this->Search = std::make_unique<dgg::GraphSearch>(this->Graph.View(), &this->Surface);
}

const dgg::GraphSearch& MeasuredGraph::GetSearch()
{
  if (!this->Search)
  {
    this->PrepareSearch();
  }
  return *this->Search;
}

void MeasuredGraph::NeedLandmarks()
{
  if (!this->GetSearch().HasLandmarks())
  {
    this->Search->PrepareLandmarks({}, {});
  }
}

const dgg::GraphBuilder& MeasuredGraph::GetBuilder()
{
  if (!this->Builder)
  {
    this->Builder = std::make_unique<dgg::GraphBuilder>(this->Surface);
  }
  return *this->Builder;
}

void MeasuredGraph::GetDegree(double& mean, double& deviation) const
{
  const double n = this->Graph.GetNumberOfVertices();
  double sum = 0.0;
  double sumOfSquares = 0.0;
  for (dgg::Id v = 0; v < this->Graph.GetNumberOfVertices(); ++v)
  {
    const auto degree = static_cast<double>(this->Graph.Offsets[v + 1] - this->Graph.Offsets[v]);
    sum += degree;
    sumOfSquares += degree * degree;
  }
  mean = sum / n;
  deviation = std::sqrt(std::max(0.0, sumOfSquares / n - mean * mean));
}
