// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIntrinsicDelaunay.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dgg
{
namespace
{
constexpr Offset FlipsPerEdge = 100;
/// Steps between two reports of progress.
constexpr Offset StepsPerReport = Offset(1) << 16;

/// Whether the edge is not Delaunay, by more than rounding: cotangents of slivers are large.
bool WantsFlip(const IntrinsicTriangulation& triangulation, Id h)
{
  const double here = triangulation.Cotangent(SurfaceMesh::Previous(h));
  const double there = triangulation.Cotangent(SurfaceMesh::Previous(triangulation.Twin(h)));
  return here + there < -1e-12 - 1e-14 * (std::abs(here) + std::abs(there));
}
}

Status MakeDelaunay(IntrinsicTriangulation& triangulation, Offset mostFlips,
  const ProgressCallback& progress, DelaunayReport& report)
{
  report = DelaunayReport();
  const Id size = triangulation.GetNumberOfHalfEdges();
  const Offset bound = mostFlips >= 0 ? mostFlips : FlipsPerEdge * (size / 2 + 1);
  // Half-edges stand for their edges. A flip renames some of its neighbours, so all four sides of
  // the two faces are looked at again.
  std::vector<Id> stack;
  std::vector<std::uint8_t> isWaiting(size, 0);
  const auto push = [&](Id h) {
    if (!isWaiting[h])
    {
      isWaiting[h] = 1;
      stack.push_back(h);
    }
  };
  for (Id h = size - 1; h >= 0; --h)
  {
    if (triangulation.IsFlippable(h) && h < triangulation.Twin(h))
    {
      push(h);
    }
  }
  const auto total = static_cast<double>(stack.size() + 1);
  double reached = 0.0;
  Offset steps = 0;
  while (!stack.empty())
  {
    if (progress && steps++ % StepsPerReport == 0)
    {
      reached = std::max(reached, 1.0 - static_cast<double>(stack.size()) / total);
      if (!progress(reached))
      {
        return Status::Abort();
      }
    }
    const Id h = stack.back();
    stack.pop_back();
    isWaiting[h] = 0;
    if (!triangulation.IsFlippable(h) || !WantsFlip(triangulation, h))
    {
      continue;
    }
    if (report.Flips >= bound)
    {
      report.IsComplete = false;
      break;
    }
    if (!triangulation.Flip(h))
    {
      ++report.Refused;
      continue;
    }
    ++report.Flips;
    // The new edge is that after h.
    const Id diagonal = SurfaceMesh::Next(h);
    const Id other = triangulation.Twin(diagonal);
    push(SurfaceMesh::Next(diagonal));
    push(SurfaceMesh::Previous(diagonal));
    push(SurfaceMesh::Next(other));
    push(SurfaceMesh::Previous(other));
  }
  return Status::Success();
}
}
