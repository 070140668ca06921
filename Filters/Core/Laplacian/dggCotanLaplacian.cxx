// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCotanLaplacian.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dgg
{
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
      // First divided: what is infinite, where there is no area at all, must not become NaN.
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
    entries.emplace_back(v, v, 0.0); // so that vertices without a face have a diagonal entry too
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
      continue; // the difference of a value and itself
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

CotanLaplacian MakeCotanLaplacian(const SurfaceMesh& mesh)
{
  return MakeCotanLaplacian(IntrinsicTriangulation(mesh));
}
}
