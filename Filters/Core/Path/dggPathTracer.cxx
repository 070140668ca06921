// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathTracer.h"

#include <array>
#include <string>
#include <utility>

namespace dgg
{
Status PathTracer::Append(const Hop& hop, bool isBackwards)
{
  Strip strip;
  strip.Start = SurfacePoint::AtVertex(hop.Tail);
  strip.End = hop.Head;
  if (!this->Tracer.Trace(hop, strip.FirstFace, strip.Crossings))
  {
    ++this->NumberOfFallbacks;
    SurfacePath path;
    if (!this->FindExactly(isBackwards ? strip.End : strip.Start,
          isBackwards ? strip.Start : strip.End, hop.Length, path))
    {
      return Status::Invalid("an edge of the graph, from vertex " + std::to_string(hop.Tail) +
        ", cannot be traced on the surface: the graph is not that of the mesh");
    }
    this->Chain.Append(path);
    return Status::Success();
  }
  if (isBackwards)
  {
    strip.FirstFace = strip.LastFace();
    std::swap(strip.Start, strip.End);
    Reverse(strip.Crossings);
  }
  this->Chain.Append(strip);
  return Status::Success();
}

Status PathTracer::Append(const SurfacePoint& from, const SurfacePoint& to, double length)
{
  SurfacePath path;
  Id shared = NoId;
  ForEachFaceAround(this->Mesh, from, [&](Id f, const std::array<double, 3>& p) {
    std::array<double, 3> q{};
    if (FindInFace(this->Mesh, to, f, q) && DistanceInFace(this->Mesh, f, p, q) <= length)
    {
      shared = f;
    }
  });
  if (shared != NoId)
  {
    path.Points = { from, to };
    path.Faces = { shared };
  }
  else if (!this->FindExactly(from, to, length, path))
  {
    return Status::Invalid("the straight way between two points cannot be traced");
  }
  this->Chain.Append(path);
  return Status::Success();
}

/// The exact way; false when there is none within the length.
bool PathTracer::FindExactly(
  const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path)
{
  if (!this->Exact)
  {
    this->Exact = std::make_unique<ExactPathFinder>(this->Mesh);
  }
  std::vector<SurfacePath> found;
  const Status status = this->Exact->Find(
    from, { to }, ProgressCallback(), found, length + this->Tracer.GetTolerance(length));
  if (!status.IsOk() || found.front().IsEmpty())
  {
    return false;
  }
  path = std::move(found.front());
  return true;
}
}
