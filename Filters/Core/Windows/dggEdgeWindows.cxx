// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEdgeWindows.h"

#include "dggStatus.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Tolerance of the ends of intervals, relative to the edge length.
constexpr double EndTolerance = 1e-9;

bool IsValid(const EdgeWindow& w, double length)
{
  // Comparisons with NaN are false.
  return w.Begin >= -EndTolerance * length && w.Begin <= w.End &&
    w.End <= length * (1.0 + EndTolerance) && w.Image.Y <= 0.0 && std::isfinite(w.Image.X) &&
    std::isfinite(w.Image.Y) && std::isfinite(w.Offset);
}

bool IsValid(const FaceSource& s, const SurfaceMesh& mesh)
{
  if (s.Face < 0 || s.Face >= mesh.GetNumberOfFaces() || mesh.IsDropped(s.Face) ||
    !std::isfinite(s.Offset))
  {
    return false;
  }
  double sum = 0.0;
  bool valid = true;
  for (double b : s.Barycentric)
  {
    valid = valid && b >= 0.0 && b <= 1.0;
    sum += b;
  }
  return valid && std::abs(sum - 1.0) < EndTolerance;
}
}

Status EdgeWindows::Check(const SurfaceMesh& mesh) const
{
  const auto halfEdges = static_cast<std::size_t>(mesh.GetNumberOfHalfEdges());
  if (this->Offsets.size() != halfEdges + 1 || this->Offsets.front() != 0 ||
    this->Offsets.back() != static_cast<Offset>(this->Windows.size()))
  {
    return InvalidInput(this->Offsets.size(), " offsets and ", this->Windows.size(),
      " windows do not fit a mesh of ", halfEdges, " half-edges");
  }
  for (std::size_t h = 0; h < halfEdges; ++h)
  {
    if (this->Offsets[h] > this->Offsets[h + 1])
    {
      return InvalidInput("The offsets of half-edge ", h, " decrease");
    }
  }
  for (std::size_t h = 0; h < halfEdges; ++h)
  {
    const Id id = static_cast<Id>(h);
    double last = -Infinity;
    for (const EdgeWindow* w = this->Begin(id); w != this->End(id); ++w)
    {
      if (!IsValid(*w, mesh.Length(id)) || w->Begin < last)
      {
        return InvalidInput("Window ", w - this->Windows.data(), " does not lie on half-edge ", h);
      }
      last = w->Begin;
    }
  }
  Id face = 0;
  for (std::size_t s = 0; s < this->Sources.size(); ++s)
  {
    if (!IsValid(this->Sources[s], mesh) || this->Sources[s].Face < face)
    {
      return InvalidInput("Source ", s, " does not lie in a face of the mesh");
    }
    face = this->Sources[s].Face;
  }
  return Status::Success();
}
}
