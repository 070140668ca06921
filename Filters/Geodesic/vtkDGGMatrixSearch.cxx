// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMatrixSearch.h"

#include "vtkDGGGraphProvider.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"

#include "dggSurfaceOrder.h"

#include <algorithm>
#include <mutex>

namespace
{
/// Shares of the progress.
constexpr double SourcesLinked = 0.05;
constexpr double TargetsLinked = 0.1;

/// Searches at a time: as many as their fields take this much memory, but a few at least.
constexpr std::size_t FieldMemory = std::size_t(256) << 20;
constexpr std::size_t FewestFields = 16;
/// Points between two looks at the progress.
constexpr std::size_t LinkBlock = 256;
constexpr std::size_t SearchBlock = 32;

constexpr dgg::Id PatchSize = 256;

bool IsVertex(const dgg::SurfacePoint& point)
{
  return point.On == dgg::SurfacePoint::Support::Vertex;
}

/// Indices of the points that are vertices, or of those that are not.
std::vector<std::size_t> FindPoints(const vtkDGGMatrixSearch::Points& points, bool vertices)
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (IsVertex(points[i]) == vertices)
    {
      found.push_back(i);
    }
  }
  return found;
}

vtkDGGMatrixSearch::Points Select(
  const vtkDGGMatrixSearch::Points& points, const std::vector<std::size_t>& indices)
{
  vtkDGGMatrixSearch::Points selected(indices.size());
  std::transform(
    indices.begin(), indices.end(), selected.begin(), [&](std::size_t i) { return points[i]; });
  return selected;
}

/// Put what is close together on the surface close together in the list.
void SortBySurface(const dgg::SurfaceMesh& mesh, const vtkDGGMatrixSearch::Points& points,
  std::vector<std::size_t>& indices)
{
  const std::vector<dgg::Id> order = dgg::ComputePatchOrder(mesh, PatchSize);
  std::vector<dgg::Id> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<dgg::Id>(i);
  }
  std::stable_sort(indices.begin(), indices.end(),
    [&](std::size_t a, std::size_t b) { return rank[points[a].Vertex] < rank[points[b].Vertex]; });
}
}

//------------------------------------------------------------------------------
vtkDGGMatrixSearch::vtkDGGMatrixSearch(vtkDGGGraphProvider& graph, const vtkDGGMeshAdapter& mesh,
  const Points& sources, const Points& targets, const vtkDGGMatrixEntries& distances)
  : Graph(graph)
  , Mesh(mesh)
  , Sources(sources)
  , Targets(targets)
  , Distances(distances)
  , Parallel(vtkDGGMakeParallelFor())
{
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMatrixSearch::Run(bool symmetric, const dgg::ProgressCallback& progress)
{
  this->IsSymmetric = symmetric;
  this->Progress = progress;
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    for (std::size_t j = 0; j < this->Targets.size(); ++j)
    {
      this->Distances(i, j) = dgg::Infinity;
    }
  }
  dgg::Status status = this->LinkSources();
  if (status.IsOk())
  {
    status = this->LinkTargets();
  }
  if (status.IsOk())
  {
    status = this->SearchFromVertices();
  }
  if (status.IsOk())
  {
    status = this->SearchFromOthers();
  }
  if (symmetric)
  {
    this->Mirror();
  }
  return status;
}

//------------------------------------------------------------------------------
template <typename StepType>
dgg::Status vtkDGGMatrixSearch::ForAll(
  std::size_t count, std::size_t block, double end, StepType step)
{
  const double start = this->Done;
  dgg::Status failure;
  std::mutex mutex;
  for (std::size_t first = 0; first < count && failure.IsOk(); first += block)
  {
    const std::size_t size = std::min(block, count - first);
    this->Parallel(static_cast<dgg::Offset>(size), 1, [&](dgg::Offset begin, dgg::Offset last) {
      for (dgg::Offset i = begin; i < last; ++i)
      {
        const dgg::Status status = step(first + static_cast<std::size_t>(i));
        if (!status.IsOk())
        {
          const std::lock_guard<std::mutex> lock(mutex);
          failure = status;
        }
      }
    });
    this->Done = start + (end - start) * static_cast<double>(first + size) / count;
    if (failure.IsOk() && !this->Progress(this->Done))
    {
      failure = dgg::Status::Abort();
    }
  }
  this->Done = end;
  return failure;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMatrixSearch::LinkSources()
{
  this->SourceLinks.resize(this->Sources.size());
  const std::vector<std::size_t> others = FindPoints(this->Sources, false);
  const std::vector<std::size_t> aims = FindPoints(this->Targets, false);
  const Points aimPoints = Select(this->Targets, aims);
  if (others.empty())
  {
    return dgg::Status::Success();
  }
  const dgg::GraphBuilder& builder = this->Graph.GetBuilder(this->Mesh);
  return this->ForAll(others.size(), LinkBlock, SourcesLinked, [&](std::size_t k) {
    const std::size_t i = others[k];
    std::vector<double> direct;
    const dgg::Status status = builder.Link(
      this->Sources[i], this->Graph.GetLinkAccuracy(), aimPoints, this->SourceLinks[i], direct);
    for (std::size_t a = 0; a < aims.size() && status.IsOk(); ++a)
    {
      this->Distances(i, aims[a]) = direct[a];
    }
    return status;
  });
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMatrixSearch::LinkTargets()
{
  const std::vector<std::size_t> others = FindPoints(this->Targets, false);
  this->TargetLinks.resize(this->Targets.size());
  for (const std::size_t j : FindPoints(this->Targets, true))
  {
    this->TargetLinks[j] = { { this->Targets[j].Vertex, 0.0, 0.0 } };
  }
  if (this->IsSymmetric)
  {
    for (const std::size_t j : others)
    {
      this->TargetLinks[j] = this->SourceLinks[j];
    }
    return dgg::Status::Success();
  }
  if (others.empty())
  {
    return dgg::Status::Success();
  }
  // Straight ways once more: seen from the other end they need not be among the cones, and the
  // answer should not depend on which end they are seen from.
  const std::vector<std::size_t> aims = FindPoints(this->Sources, false);
  const Points aimPoints = Select(this->Sources, aims);
  const dgg::GraphBuilder& builder = this->Graph.GetBuilder(this->Mesh);
  return this->ForAll(others.size(), LinkBlock, TargetsLinked, [&](std::size_t k) {
    const std::size_t j = others[k];
    std::vector<double> direct;
    const dgg::Status status = builder.Link(
      this->Targets[j], this->Graph.GetLinkAccuracy(), aimPoints, this->TargetLinks[j], direct);
    for (std::size_t a = 0; a < aims.size() && status.IsOk(); ++a)
    {
      double& distance = this->Distances(aims[a], j);
      distance = std::min(distance, direct[a]);
    }
    return status;
  });
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMatrixSearch::SearchFromVertices()
{
  std::vector<std::size_t> vertices = FindPoints(this->Sources, true);
  if (vertices.empty())
  {
    return dgg::Status::Success();
  }
  SortBySurface(this->Mesh.GetMesh(), this->Sources, vertices);

  const auto n = static_cast<std::size_t>(this->Mesh.GetMesh().GetNumberOfVertices());
  const std::size_t block =
    std::min(vertices.size(), std::max(FewestFields, FieldMemory / (n * sizeof(double))));
  std::vector<double> fields(block * n);
  const double start = this->Done;
  const double end = start +
    (1.0 - start) * static_cast<double>(vertices.size()) /
      static_cast<double>(this->Sources.size());
  for (std::size_t first = 0; first < vertices.size(); first += block)
  {
    const std::size_t size = std::min(block, vertices.size() - first);
    std::vector<dgg::Id> ids(size);
    std::transform(vertices.begin() + first, vertices.begin() + first + size, ids.begin(),
      [this](std::size_t i) { return this->Sources[i].Vertex; });
    dgg::Status status =
      this->Graph.GetSearch().Many(ids, dgg::Infinity, this->Parallel, fields.data());
    if (!status.IsOk())
    {
      return status;
    }
    const double reached =
      start + (end - start) * static_cast<double>(first + size) / vertices.size();
    status = this->ForAll(size, size, reached, [&](std::size_t k) {
      this->LookAtTargets(vertices[first + k], fields.data() + k * n);
      return dgg::Status::Success();
    });
    if (!status.IsOk())
    {
      return status;
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMatrixSearch::SearchFromOthers()
{
  const std::vector<std::size_t> others = FindPoints(this->Sources, false);
  return this->ForAll(others.size(), SearchBlock, 1.0, [&](std::size_t k) {
    const std::size_t i = others[k];
    std::vector<dgg::GraphSeed> seeds;
    for (const dgg::GraphLink& link : this->SourceLinks[i])
    {
      seeds.push_back({ link.Vertex, link.Length, 0.0, 0, link.ArrivalAngle });
    }
    dgg::SearchResult result;
    const dgg::Status status = this->Graph.GetSearch().Run(seeds, dgg::SearchOptions(), result);
    if (status.IsOk())
    {
      this->LookAtTargets(i, result.Distances.data());
    }
    return status;
  });
}

//------------------------------------------------------------------------------
void vtkDGGMatrixSearch::LookAtTargets(std::size_t source, const double* field) const
{
  for (std::size_t j = this->IsSymmetric ? source + 1 : 0; j < this->Targets.size(); ++j)
  {
    double& distance = this->Distances(source, j);
    for (const dgg::GraphLink& link : this->TargetLinks[j])
    {
      distance = std::min(distance, field[link.Vertex] + link.Length);
    }
  }
}

//------------------------------------------------------------------------------
void vtkDGGMatrixSearch::Mirror() const
{
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    this->Distances(i, i) = 0.0;
    for (std::size_t j = i + 1; j < this->Sources.size(); ++j)
    {
      const double distance = std::min(this->Distances(i, j), this->Distances(j, i));
      this->Distances(i, j) = distance;
      this->Distances(j, i) = distance;
    }
  }
}
