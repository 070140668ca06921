// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCotanLaplacian.h"

#include <vector>

namespace dgg
{
CotanLaplacian MakeCotanLaplacian(const IntrinsicTriangulation& triangulation)
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
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const Id i = triangulation.Origin(h);
    const Id j = triangulation.Destination(h);
    laplacian.Mass[i] += triangulation.Area(SurfaceMesh::Face(h)) / 3.0;
    if (i == j)
    {
      continue; // the difference of a value and itself
    }
    const double weight = 0.5 * triangulation.Cotangent(SurfaceMesh::Previous(h));
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
