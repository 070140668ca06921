// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsBlend.h"

#include "dggMeshPart.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"

#include <algorithm>
#include <cstddef>

namespace dgg
{
namespace
{
bool IsSameAllAlong(const std::vector<double>& values, std::size_t channels)
{
  for (std::size_t i = channels; i < values.size(); ++i)
  {
    if (values[i] != values[i - channels])
    {
      return false;
    }
  }
  return true;
}

/// Call `visit(vertex, parameter)` for every end of an edge on both sides.
template <typename Visitor>
void ForEachEnd(const CurveSides& sides, const CurveChain& chain, Visitor&& visit)
{
  for (const std::vector<EdgeSide>* side : { &sides.Left, &sides.Right })
  {
    for (std::size_t i = 0; i < side->size(); ++i)
    {
      const EdgeSide& edge = (*side)[i];
      if (edge.Face != NoId)
      {
        visit(edge.From, chain.Parameters[i]);
        visit(edge.To, chain.Parameters[i + 1]);
      }
    }
  }
}
}

namespace
{
bool IsFaceInBand(const SurfaceMesh& mesh, Id face, const std::vector<char>& isInBand)
{
  const std::array<Id, 3> corners = mesh.GetTriangle(face);
  return !mesh.IsDropped(face) &&
    (isInBand[corners[0]] || isInBand[corners[1]] || isInBand[corners[2]]);
}
}

bool StrengthBlend::IsNeeded(const GraphicsCurve& curve, int channels)
{
  const auto count = static_cast<std::size_t>(channels);
  return !IsSameAllAlong(curve.Left, count) || !IsSameAllAlong(curve.Right, count);
}

Status StrengthBlend::Spread(const SurfaceMesh& mesh, const std::vector<char>& isInBand,
  const CurveSides& sides, const CurveChain& chain, const GraphicsCurve& curve, int channels,
  const ProgressCallback& progress)
{
  MeshPart part;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (IsFaceInBand(mesh, f, isInBand))
    {
      part.Faces.push_back(f);
    }
  }
  Status status = part.Build(mesh);
  if (!status.IsOk())
  {
    return status;
  }
  const SurfaceMesh& band = part.Mesh;
  this->Places.assign(isInBand.size(), NoId);
  for (std::size_t v = 0; v < part.Vertices.size(); ++v)
  {
    this->Places[part.Vertices[v]] = static_cast<Id>(v);
  }
  const auto n = static_cast<std::size_t>(band.GetNumberOfVertices());
  const auto count = static_cast<std::size_t>(channels);
  std::vector<double> given(n, 0.0); // how often
  PoissonOptions options;
  options.IntrinsicDelaunay = true;
  ForEachEnd(sides, chain, [&](Id v, double) {
    options.GivenVertices.push_back(this->Places[v]);
    given[this->Places[v]] += 1.0;
  });
  PoissonSolver solver(band);
  status = solver.Analyze(options, progress);
  if (!status.IsOk())
  {
    return status;
  }
  status = solver.Factorize(nullptr);
  if (!status.IsOk())
  {
    this->Places.clear();
    return solver.GetSystem().HasThin() ? Status::Success() : status;
  }
  this->Columns.assign(2 * count, std::vector<double>(n, 0.0));
  std::vector<double> strength(count);
  for (const std::size_t side : { 0, 1 })
  {
    ForEachEnd(sides, chain, [&](Id v, double parameter) {
      InterpolateOnCurve(
        side == 0 ? curve.Left : curve.Right, channels, curve.IsClosed, parameter, strength.data());
      for (std::size_t c = 0; c < count; ++c)
      {
        this->Columns[side * count + c][this->Places[v]] += strength[c] / given[this->Places[v]];
      }
    });
  }
  status = solver.Solve(this->Columns);
  const PoissonSystem& system = solver.GetSystem();
  for (Id& place : this->Places)
  {
    place = place != NoId && system.IsFree(system.GetComponent(place)) ? NoId : place;
  }
  return status;
}

bool StrengthBlend::Get(Id vertex, std::vector<double>& left, std::vector<double>& right) const
{
  const Id place = this->Places.empty() ? NoId : this->Places[vertex];
  for (std::size_t c = 0; c < left.size() && place != NoId; ++c)
  {
    left[c] = this->Columns[c][place];
    right[c] = this->Columns[left.size() + c][place];
  }
  return place != NoId;
}
}
