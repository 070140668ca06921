// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGLoopSearch.h"

#include "vtkDGGGraphProvider.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"

#include "dggHandleLoops.h"
#include "dggLoopFinder.h"
#include "dggTape.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace
{
/// Loops at least between two looks at the progress from outside of them.

/// What loops through points need besides the graph: null when all of them are vertices.
dgg::Status PrepareLinks(vtkDGGGraphProvider& graph, const vtkDGGMeshAdapter& mesh,
  const vtkDGGLoopSearch::Points& points, const dgg::GraphBuilder*& builder)
{
  builder = nullptr;
  if (std::all_of(points.begin(), points.end(), dgg::IsVertex))
  {
    graph.ReleaseBuilder();
    return dgg::Status::Success();
  }
  const dgg::Status status = graph.PrepareBuilder(mesh);
  builder = status.IsOk() ? &graph.GetBuilder() : nullptr;
  return status;
}

/// An error with what it is about before it.
dgg::Status Explain(const dgg::Status& status, const std::string& subject)
{
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid(subject + ": " + status.GetMessage());
}

vtkDGGLoopStatus GetStatus(const dgg::FoundLoop& loop)
{
  return loop.Loop.IsEmpty() ? vtkDGGLoopStatus::NotFound : vtkDGGLoopStatus::Found;
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoopSearch::RunThroughPoints(vtkDGGGraphProvider& graph, const double* positions,
  const Points& points, bool taut, const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const
{
  const dgg::GraphBuilder* builder = nullptr;
  dgg::Status status = PrepareLinks(graph, this->Mesh, points, builder);
  if (!status.IsOk())
  {
    return status;
  }
  const dgg::LoopFinder finder(
    this->Mesh.GetMesh(), graph.GetSearch(), builder, positions, graph.GetLinkAccuracy());
  set.Loops.assign(points.size(), dgg::FoundLoop());
  const auto step = [&](std::size_t i, const dgg::ProgressCallback& within) {
    return Explain(
      finder.ThroughPoint(points[i], taut, set.Loops[i], within), "point " + std::to_string(i));
  };
  status = vtkDGGForEach(points.size(), 1, progress, step);
  for (const dgg::FoundLoop& loop : set.Loops)
  {
    set.Status.push_back(GetStatus(loop));
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoopSearch::RunRope(vtkDGGGraphProvider& graph, const double* positions,
  const Points& points, bool taut, const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const
{
  const dgg::GraphBuilder* builder = nullptr;
  dgg::Status status = PrepareLinks(graph, this->Mesh, points, builder);
  if (!status.IsOk())
  {
    return status;
  }
  const dgg::LoopFinder finder(
    this->Mesh.GetMesh(), graph.GetSearch(), builder, positions, graph.GetLinkAccuracy());
  set.Loops.resize(1);
  bool isConnected = true;
  status = Explain(finder.Rope(points, taut, set.Loops[0], isConnected, progress), "rope");
  set.Status = { isConnected ? GetStatus(set.Loops[0]) : vtkDGGLoopStatus::NotConnected };
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoopSearch::RunAroundHandles(
  const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const
{
  const dgg::Status status = dgg::FindHandleLoops(this->Mesh.GetMesh(), progress, set.Loops);
  for (const dgg::FoundLoop& loop : set.Loops)
  {
    set.Status.push_back(GetStatus(loop));
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoopSearch::AddTapes(
  double width, const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const
{
  const std::size_t count = set.Loops.size();
  set.Rims.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (set.Loops[i].Loop.IsEmpty())
    {
      continue;
    }
    const double smallest = dgg::GetSmallestTapeWidth(set.Loops[i].Loop);
    set.SmallestTapeWidth = std::max(set.SmallestTapeWidth, smallest);
    if (width < smallest)
    {
      ++set.LoopsTooLong;
      continue;
    }
    const auto part = [&](double fraction) {
      return progress((static_cast<double>(i) + fraction) / static_cast<double>(count));
    };
    const dgg::Status status =
      dgg::MakeTape(this->Mesh.GetMesh(), set.Loops[i].Loop, width, part, set.Rims[i]);
    if (!status.IsOk())
    {
      return Explain(status, "tape of loop " + std::to_string(i));
    }
    if (!part(1.0))
    {
      return dgg::Status::Abort();
    }
  }
  return dgg::Status::Success();
}
