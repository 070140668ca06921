// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLocalizedGreens.h"

#include "dggGeodesicSource.h"
#include "dggProgressPart.h"

#include <Eigen/Dense>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace dgg
{
namespace
{
/// Singular values below this fraction of the largest are treated as 0.
constexpr double Cutoff = 1e-8;
constexpr int LeastRings = 2;

/// A list of vertices with their indices in the list.
class Neighborhood
{
public:
  explicit Neighborhood(const PoissonSystem& system)
    : System(system)
  {
  }

  void Add(Id v)
  {
    if (this->Places.emplace(v, this->Vertices.size()).second)
    {
      this->Vertices.push_back(v);
    }
  }
  /// Adds the neighbors of the listed vertices. Returns false if the number of vertices would be
  /// too large.
  bool AddRing()
  {
    const std::size_t end = this->Vertices.size();
    for (std::size_t k = 0; k < end; ++k)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(
             this->System.GetStiffness(), this->Vertices[k]);
           entry; ++entry)
      {
        this->Add(static_cast<Id>(entry.row()));
      }
      if (this->Vertices.size() > static_cast<std::size_t>(MostLocalizedVertices))
      {
        return false;
      }
    }
    return true;
  }
  const std::vector<Id>& GetVertices() const { return this->Vertices; }
  std::size_t PlaceOf(Id v) const { return this->Places.at(v); }

private:
  const PoissonSystem& System;
  std::vector<Id> Vertices;
  std::map<Id, std::size_t> Places;
};

/// Computes distances from a point to vertices. Returns false if some vertices are not connected.
bool FindDistances(ExactGeodesics& exact, const SurfacePoint& source, const std::vector<Id>& to,
  std::vector<double>& distances)
{
  ExactOptions options;
  options.StopAtTargets = true;
  for (const Id v : to)
  {
    options.Targets.push_back(SurfacePoint::AtVertex(v));
  }
  // Each run reaches a few hundred vertices of the mesh.
  if (!exact.RunKept({ { source, 0.0 } }, options).IsOk())
  {
    return false;
  }
  distances = exact.GetKept().TargetDistances;
  return std::all_of(distances.begin(), distances.end(), [](double d) { return d < Infinity; });
}

/// Finds the vertices nearest to the pole, from complete rings around the pole, and then their
/// neighbors. Returns the number of near vertices; 0 if the number of neighbors is too large.
std::size_t FindNeighbors(const PoissonSystem& system, const SurfacePoint& pole,
  ExactGeodesics& exact, std::unique_ptr<Neighborhood>& all)
{
  Neighborhood rings(system);
  ForEachCornerAround(system.GetMesh(), pole, [&](Id v, double, double) { rings.Add(v); });
  std::size_t before = 0;
  for (int ring = 0; ring < LeastRings || rings.GetVertices().size() < LocalizedVertices; ++ring)
  {
    before = rings.GetVertices().size();
    if (!rings.AddRing())
    {
      return 0;
    }
    if (rings.GetVertices().size() == before)
    {
      break; // the entire component is listed
    }
  }
  std::vector<double> distances;
  if (!FindDistances(exact, pole, rings.GetVertices(), distances))
  {
    return 0;
  }
  std::vector<std::pair<double, Id>> order;
  for (std::size_t k = 0; k < distances.size(); ++k)
  {
    order.emplace_back(distances[k], rings.GetVertices()[k]);
  }
  std::sort(order.begin(), order.end());
  const std::size_t near = std::min<std::size_t>(order.size(), LocalizedVertices);
  all = std::make_unique<Neighborhood>(system);
  for (std::size_t k = 0; k < near; ++k)
  {
    all->Add(order[k].second);
  }
  return all->AddRing() ? near : 0;
}
}

Status Localize(const PoissonSystem& system, const SurfacePoint& pole, ExactGeodesics& exact,
  const ProgressCallback& progress, std::vector<double>& values, bool& isLocalized)
{
  isLocalized = false;
  std::unique_ptr<Neighborhood> neighborhood;
  const auto near = static_cast<Eigen::Index>(FindNeighbors(system, pole, exact, neighborhood));
  if (near == 0)
  {
    return Status::Success();
  }
  const std::vector<Id>& vertices = neighborhood->GetVertices();
  const auto all = static_cast<Eigen::Index>(vertices.size());
  if (std::any_of(
        vertices.begin(), vertices.begin() + near, [&](Id v) { return system.IsFixed(v); }))
  {
    return Status::Success();
  }
  // Columns: distances from all vertices to the near ones; the last column has the distances to the
  // pole.
  Eigen::MatrixXd distances(all, near + 1);
  std::vector<double> column;
  for (Eigen::Index i = 0; i <= near; ++i)
  {
    DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(i) / static_cast<double>(near + 2)));
    const SurfacePoint source = i < near ? SurfacePoint::AtVertex(vertices[i]) : pole;
    if (!FindDistances(exact, source, vertices, column))
    {
      return Status::Success();
    }
    distances.col(i) = Eigen::Map<const Eigen::VectorXd>(column.data(), all);
  }
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(near, all);
  Eigen::VectorXd psi(near);
  for (Eigen::Index i = 0; i < near; ++i)
  {
    const Id v = vertices[i];
    psi[i] = system.IsFree(system.GetComponent(v)) ? system.GetWeight(v) : 0.0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(system.GetStiffness(), v); entry; ++entry)
    {
      const auto u = static_cast<Id>(entry.row());
      laplacian(i, static_cast<Eigen::Index>(neighborhood->PlaceOf(u))) = entry.value();
      psi[i] += entry.value() * values[u];
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(Cutoff);
  decomposition.compute(distances.leftCols(near) * laplacian);
  const Eigen::VectorXd change =
    decomposition.solve(distances.col(near) - distances.leftCols(near) * psi);
  double least = Infinity;
  double largest = -Infinity;
  for (const Id v : vertices)
  {
    least = std::min(least, values[v]);
    largest = std::max(largest, values[v]);
  }
  if (!change.allFinite() || change.cwiseAbs().maxCoeff() > largest - least)
  {
    return Status::Success();
  }
  for (Eigen::Index k = 0; k < all; ++k)
  {
    values[vertices[k]] += change[k];
  }
  system.Center(values);
  isLocalized = true;
  return ReportTo(progress, 1.0);
}
}
