// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHermiteEdge.h"

#include "dggEdges.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Tolerance of the error of a model at the other end, as a fraction of the edge length. A model
/// with a larger error belongs to another path.
constexpr double BranchTolerance = 1e-9;
/// Minimum distance between nodes, relative to the edge length.
constexpr double NodeDistance = 1e-9;
}

void HermiteEdge::Enter(Id h)
{
  const Id representative = FindEdge(*this->Field.Mesh, h);
  if (representative == this->HalfEdge)
  {
    return;
  }
  this->HalfEdge = representative;
  this->SetUpEnds();
  this->PlaceNodes();
}

void HermiteEdge::SetUpEnds()
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const Id h = this->HalfEdge;
  const std::array<Id, 2> vertices{ { mesh.Origin(h), mesh.Destination(h) } };
  // Half-edges at both ends: h itself, and for the destination the previous side of the same face.
  const Id next = SurfaceMesh::Next(h);
  this->PolarAngles = { { mesh.PolarAngle(h), mesh.PolarAngle(next) + mesh.CornerAngle(next) } };
  this->Length = mesh.Length(h);
  this->Ends = { { this->Field.Distances[vertices[0]], this->Field.Distances[vertices[1]] } };
  const double chord = this->Ends[1] - this->Ends[0];
  this->Rises = { { chord, chord } };
  this->Models = {};
  const VirtualSources* sources = this->Field.Sources;
  const bool hasSources = sources && !sources->empty();
  std::array<double, 2> missing{ { 0.0, 0.0 } };
  for (int k = 0; k < 2 && hasSources; ++k)
  {
    CornerModel& model = this->Models[k];
    model = CornerModel(mesh, vertices[k], (*sources)[vertices[k]], this->Ends[k]);
    model.IsKnown = model.IsKnown && std::isfinite(model.Length) && std::isfinite(model.Angle);
    if (!model.IsKnown)
    {
      continue;
    }
    const double angle = model.AngleFrom(this->PolarAngles[k]);
    const double slope =
      model.Length <= 0.0 || std::abs(angle) >= Pi ? 1.0 : -std::cos(angle); // away from the end
    this->Rises[k] = (k == 0 ? slope : -slope) * this->Length;
    missing[k] = model.At(this->Length, this->PolarAngles[k]) - this->Ends[1 - k];
  }
  const double tolerance = BranchTolerance * this->Length;
  this->IsSplit = missing[0] > tolerance && missing[1] > tolerance;
}

double HermiteEdge::At(double x) const
{
  if (x <= 0.0 || x >= this->Length)
  {
    return this->Ends[x > 0.0 ? 1 : 0];
  }
  const double t = x / this->Length;
  const double s = 1.0 - t;
  const double value = this->IsSplit
    ? std::min(this->Models[0].At(x, this->PolarAngles[0]),
        this->Models[1].At(this->Length - x, this->PolarAngles[1]))
    : s * s * ((1.0 + 2.0 * t) * this->Ends[0] + t * this->Rises[0]) +
      t * t * ((1.0 + 2.0 * s) * this->Ends[1] - s * this->Rises[1]);
  // On overflow, fall back to linear interpolation.
  return std::isfinite(value) ? value : s * this->Ends[0] + t * this->Ends[1];
}

void HermiteEdge::PlaceNodes()
{
  this->Nodes.clear();
  const int count = this->NumberOfSteinerPoints + 1;
  for (int i = 0; i <= count; ++i)
  {
    const double x = i == count ? this->Length : this->Length * i / count;
    this->Nodes.push_back({ x, this->At(x), true });
  }
  // Keep sites that are nearest to some point of the edge; other sites are dominated by a site
  // before or behind.
  this->Kept.clear();
  for (const RimNode& node : this->Nodes)
  {
    if (!this->Kept.empty() &&
      node.Value >= this->Kept.back().Value + (node.X - this->Kept.back().X))
    {
      continue;
    }
    while (
      !this->Kept.empty() && this->Kept.back().Value >= node.Value + (node.X - this->Kept.back().X))
    {
      this->Kept.pop_back();
    }
    this->Kept.push_back(node);
  }
  const std::size_t numberOfSites = this->Nodes.size();
  for (std::size_t i = 0; i + 1 < this->Kept.size(); ++i)
  {
    const RimNode& a = this->Kept[i];
    const RimNode& b = this->Kept[i + 1];
    const double x = 0.5 * (a.X + b.X + (b.Value - a.Value));
    const double apart = NodeDistance * this->Length;
    const bool isNew = std::none_of(this->Nodes.begin(), this->Nodes.begin() + numberOfSites,
      [&](const RimNode& node) { return std::abs(node.X - x) <= apart; });
    if (isNew)
    {
      this->Nodes.push_back({ x, this->At(x), false });
    }
  }
  std::sort(this->Nodes.begin(), this->Nodes.end(),
    [](const RimNode& a, const RimNode& b) { return a.X < b.X; });
}
}
