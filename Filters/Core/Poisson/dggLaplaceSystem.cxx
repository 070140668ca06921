// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLaplaceSystem.h"

#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Progress after each step.
constexpr double FlipsDone = 0.4;
constexpr double MatrixDone = 0.5;
constexpr double OrderDone = 0.9;
}

std::array<double, 3> GetCotangents(
  const IntrinsicTriangulation& triangulation, Id face, double largestCotangent)
{
  std::array<double, 3> cotangents;
  double largest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    cotangents[k] = triangulation.Cotangent(3 * face + k);
    largest = std::max(largest, std::abs(cotangents[k]));
  }
  if (largest > largestCotangent)
  {
    for (double& cotangent : cotangents)
    {
      // Divided first, so that infinite cotangents of faces without area do not become NaN.
      cotangent = std::isinf(cotangent) ? std::copysign(largestCotangent, cotangent)
                                        : cotangent / largest * largestCotangent;
    }
  }
  return cotangents;
}

CotanLaplacian MakeCotanLaplacian(
  const IntrinsicTriangulation& triangulation, double largestCotangent)
{
  const Id n = triangulation.GetNumberOfVertices();
  CotanLaplacian laplacian;
  laplacian.Mass = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double, Id>> entries;
  entries.reserve(4 * static_cast<std::size_t>(triangulation.GetNumberOfHalfEdges()) + n);
  for (Id v = 0; v < n; ++v)
  {
    entries.emplace_back(v, v, 0.0); // diagonal entry, also for vertices without a face
  }
  std::array<double, 3> cotangents{ { 0.0, 0.0, 0.0 } };
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    if (h % 3 == 0)
    {
      cotangents = GetCotangents(triangulation, SurfaceMesh::Face(h), largestCotangent);
    }
    const Id i = triangulation.Origin(h);
    const Id j = triangulation.Destination(h);
    laplacian.Mass[i] += triangulation.Area(SurfaceMesh::Face(h)) / 3.0;
    if (i == j)
    {
      continue; // an edge from a vertex to itself does not contribute
    }
    const double weight = 0.5 * cotangents[SurfaceMesh::Previous(h) % 3];
    entries.emplace_back(i, j, -weight);
    entries.emplace_back(j, i, -weight);
    entries.emplace_back(i, i, weight);
    entries.emplace_back(j, j, weight);
  }
  laplacian.Stiffness.resize(n, n);
  laplacian.Stiffness.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

Status LaplaceSystem::Build(
  bool isDelaunay, double largestCotangent, const ProgressCallback& progress)
{
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  this->Triangulation = IntrinsicTriangulation(this->Mesh);
  Offset flips = 0;
  DGG_RETURN_IF_ERROR(isDelaunay
      ? MakeDelaunay(this->Triangulation, ProgressPart(progress, 0.0, FlipsDone), flips)
      : Status::Success());
  DGG_RETURN_IF_ERROR(ReportTo(progress, FlipsDone));
  CotanLaplacian laplacian = MakeCotanLaplacian(this->Triangulation, largestCotangent);
  this->Stiffness.swap(laplacian.Stiffness);
  this->Areas.assign(laplacian.Mass.data(), laplacian.Mass.data() + laplacian.Mass.size());
  this->Components = this->Mesh.ComputeComponents(this->NumberOfComponents);
  this->OnBoundary.assign(this->Components.size(), 0);
  for (Id h = 0; h < this->Triangulation.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Triangulation.Twin(h) == NoId)
    {
      this->OnBoundary[this->Triangulation.Origin(h)] = 1;
      this->OnBoundary[this->Triangulation.Destination(h)] = 1;
    }
  }
  DGG_RETURN_IF_ERROR(ReportTo(progress, MatrixDone));
  this->Order = EliminationOrder(this->Stiffness);
  this->Pinned = this->Order.FindLast(this->Components, this->NumberOfComponents);
  return ReportTo(progress, OrderDone);
}
}
