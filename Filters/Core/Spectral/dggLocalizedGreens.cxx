// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLocalizedGreens.h"

#include "dggGeodesicSource.h"

#include <Eigen/Dense>

#include <algorithm>
#include <map>

namespace dgg
{
namespace
{
/// Singular values below this part of the largest count as 0.
constexpr double Cutoff = 1e-8;
constexpr int LeastRings = 2;

/// Add the neighbours of vertices [begin, end) of the list.
void AddRing(const PoissonSystem& system, std::size_t begin, std::size_t end,
  std::vector<Id>& vertices, std::map<Id, int>& places)
{
  for (std::size_t k = begin; k < end; ++k)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(system.GetStiffness(), vertices[k]);
         entry; ++entry)
    {
      const auto v = static_cast<Id>(entry.row());
      if (places.emplace(v, static_cast<int>(vertices.size())).second)
      {
        vertices.push_back(v);
      }
    }
  }
}
}

bool Localize(const PoissonSystem& system, const SurfacePoint& pole, ExactGeodesics& exact,
  std::vector<double>& values)
{
  // The vertices whose weights are looked at come first, then those next to them.
  std::vector<Id> vertices;
  std::map<Id, int> places;
  ForEachCornerAround(system.GetMesh(), pole, [&](Id v, double, double) {
    if (places.emplace(v, static_cast<int>(vertices.size())).second)
    {
      vertices.push_back(v);
    }
  });
  std::size_t begin = 0;
  for (int ring = 0; ring < LeastRings || vertices.size() < LocalizedVertices; ++ring)
  {
    const std::size_t end = vertices.size();
    AddRing(system, begin, end, vertices, places);
    begin = end;
    if (vertices.size() == end)
    {
      break;
    }
  }
  const std::size_t near = vertices.size();
  AddRing(system, begin, near, vertices, places);
  const std::size_t all = vertices.size();
  for (std::size_t i = 0; i < near; ++i)
  {
    if (system.IsFixed(vertices[i]))
    {
      return false;
    }
  }
  // Distances from all to those near, and to the pole in the last column.
  Eigen::MatrixXd distances(all, near + 1);
  ExactOptions options;
  options.StopAtTargets = true;
  for (const Id v : vertices)
  {
    options.Targets.push_back(SurfacePoint::AtVertex(v));
  }
  ExactResult result;
  for (std::size_t i = 0; i <= near; ++i)
  {
    const SurfacePoint source = i < near ? SurfacePoint::AtVertex(vertices[i]) : pole;
    if (!exact.Run({ { source, 0.0 } }, options, result).IsOk())
    {
      return false;
    }
    for (std::size_t s = 0; s < all; ++s)
    {
      distances(s, i) = result.TargetDistances[s];
    }
  }
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(near, all);
  Eigen::VectorXd psi(near);
  for (std::size_t i = 0; i < near; ++i)
  {
    const Id v = vertices[i];
    psi[i] = system.IsFree(system.GetComponent(v)) ? system.GetWeight(v) : 0.0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(system.GetStiffness(), v); entry; ++entry)
    {
      const auto u = static_cast<Id>(entry.row());
      laplacian(i, places.at(u)) = entry.value();
      psi[i] += entry.value() * values[u];
    }
  }
  const auto near2 = static_cast<Eigen::Index>(near);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(Cutoff);
  decomposition.compute(distances.leftCols(near2) * laplacian);
  const Eigen::VectorXd change =
    decomposition.solve(distances.col(near2) - distances.leftCols(near2) * psi);
  double least = Infinity;
  double largest = -Infinity;
  for (const Id v : vertices)
  {
    least = std::min(least, values[v]);
    largest = std::max(largest, values[v]);
  }
  if (!change.allFinite() || change.cwiseAbs().maxCoeff() > largest - least)
  {
    return false;
  }
  for (std::size_t k = 0; k < all; ++k)
  {
    values[vertices[k]] += change[k];
  }
  system.Center(values);
  return true;
}
}
