// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The paths of a PieceSearch.
#include "dggPieceSearch.h"

#include <algorithm>
#include <tuple>

namespace dgg
{
namespace
{
/// A path that continues on another process.
struct OpenRoute
{
  std::size_t Route;
  std::size_t Size; // steps so far
  Offset PointId;   // global, of the next step
  double Label;     // of the point
};

/// A step that a process has found.
struct FoundStep
{
  std::size_t Route;
  std::size_t Index;
  PieceStep Step;
};
}

Status PieceSearch::FollowBack(ProcessGroup& group, const SurfacePiece& piece,
  const std::vector<Offset>& ends, std::vector<PieceRoute>& routes, bool& isUsable) const
{
  std::vector<OpenRoute> open;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const Id v = this->FindVertex(ends[i]);
    if (v != NoId && this->IsHere(v) && this->Distances[v] < Infinity)
    {
      open.push_back({ i, 0, ends[i], this->Distances[v] });
    }
  }
  std::vector<FoundStep> found;
  isUsable = true;
  for (bool isOver = false; !isOver;)
  {
    std::vector<std::vector<OpenRoute>> left(this->Sent.size());
    for (const OpenRoute& route : open)
    {
      Id v = this->FindVertex(route.PointId);
      isUsable = isUsable && v != NoId && this->IsHere(v) && this->Distances[v] == route.Label;
      for (std::size_t size = route.Size; isUsable && this->IsHere(v); ++size)
      {
        const LabelOrigin& origin = this->Origins[v];
        const double* const at = piece.Points + 3 * static_cast<Offset>(v);
        found.push_back({ route.Route, size, { this->Ids[v], { at[0], at[1], at[2] }, 0.0, 0.0 } });
        if (origin.IsSeed())
        {
          break;
        }
        found.back().Step.Angle = this->Graph.Angles[origin.Edge];
        found.back().Step.Length = this->Graph.Length(origin.Edge);
        const Id tail = origin.Tail;
        isUsable = this->Distances[tail] < this->Distances[v]; // tails form no cycle
        if (!this->IsHere(tail))
        {
          left[this->Ghosts.Owners[tail]].push_back(
            { route.Route, size + 1, this->Ids[tail], this->Distances[tail] });
        }
        v = tail;
      }
    }
    std::vector<Message> messages(this->Sent.size());
    for (std::size_t process = 0; process < left.size(); ++process)
    {
      AppendIfAny(messages[process], left[process]);
    }
    DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize(), &isOver));
    open.clear();
    for (const Message& message : messages)
    {
      const auto list = MessageReader(message).Take<OpenRoute>();
      open.insert(open.end(), list.begin(), list.end());
    }
  }
  DGG_RETURN_IF_ERROR(group.Require(isUsable));
  DGG_RETURN_IF_ERROR(group.JoinLists(found));
  std::sort(found.begin(), found.end(), [](const FoundStep& a, const FoundStep& b) {
    return std::tie(a.Route, a.Index) < std::tie(b.Route, b.Index);
  });
  routes.assign(ends.size(), PieceRoute());
  for (const FoundStep& step : found)
  {
    routes[step.Route].Steps.push_back(step.Step);
  }
  for (PieceRoute& route : routes)
  {
    // The sum has the bits of the label: the search has added the edges in this order.
    route.Length = route.Steps.empty() ? Infinity : 0.0;
    for (auto step = route.Steps.rbegin(); step != route.Steps.rend(); ++step)
    {
      route.Length += step->Length;
    }
  }
  return Status::Success();
}
}
