// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBorderRefinement.h"

#include "dggCornerModel.h"
#include "dggRootFinding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Minimum relative difference between predictions at which a border point is measured, and between
/// measured distances at which the border is wrong, in units of the accuracy.
constexpr double SuspiciousDifference = 2.0;
constexpr double WrongDifference = 1.5;
/// Final relative tolerance between the distances from two sites, in units of the accuracy.
constexpr double BalanceTolerance = 0.05;
/// Maximum number of steps for a point on an edge, and inside a face.
constexpr int MostEdgeSteps = 12;
constexpr int MostFaceSteps = 6;
/// Minimum distance of a point on an edge from the ends of its range, as an edge parameter. Closer
/// points would be merged with the ends (SamePlace).
constexpr double Margin = 2e-5;
/// Step of finite differences, in barycentric coordinates.
constexpr double DifferenceStep = 1e-3;

/// Maximum work of links per face: about twenty times the work on a clean mesh.
constexpr std::size_t MostWorkOfFace = 3000;
constexpr std::size_t SmallestMesh = 2500; // minimum number of faces for the limit

/// Maximum step, as a fraction of the distance to a side of the face.
constexpr double LargestPart = 0.9;

/// Returns false for a site outside of a region.
bool IsOnMesh(const SurfacePoint& site)
{
  return site.Vertex != NoId || !IsVertex(site);
}

/// Returns the location after a step in barycentric coordinates, shortened to stay in the face.
std::array<double, 3> Step(
  const std::array<double, 3>& place, const std::array<double, 3>& direction)
{
  double part = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    if (place[k] + direction[k] <= 0.0)
    {
      part = std::min(part, LargestPart * place[k] / -direction[k]);
    }
  }
  return { { place[0] + part * direction[0], place[1] + part * direction[1],
    place[2] + part * direction[2] } };
}
}

BorderRefinement::BorderRefinement(const SurfaceMesh& mesh, const SiteDistances& distances,
  const GraphBuilder& builder, double accuracy, const std::vector<SurfacePoint>& sites)
  : Mesh(mesh)
  , Distances(distances)
  , Builder(builder)
  , Accuracy(accuracy)
  , Sites(sites)
  , NumberOfFaces(mesh.GetNumberOfFaces())
{
}

std::size_t BorderRefinement::GetMostWork() const
{
  return MostWorkOfFace * std::max(SmallestMesh, static_cast<std::size_t>(this->NumberOfFaces));
}

void BorderRefinement::Balance(Id halfEdge, const std::array<Id, 2>& sites, double low, double high,
  double& parameter, double& distance) const
{
  const Coordinates place = CoordinatesOnEdge(halfEdge, parameter);
  const Id face = SurfaceMesh::Face(halfEdge);
  if (!this->IsDoubtful(face, place, sites[0], distance) &&
    !this->IsDoubtful(face, place, sites[1], distance))
  {
    return;
  }
  low += Margin;
  high -= Margin;
  if (!(low < parameter && parameter < high))
  {
    return;
  }
  struct Probe
  {
    double X;
    double Height; // negative if the first site is nearer
    double Distance;
  };
  bool isMeasured = true;
  const auto measure = [&](double t) {
    double found[2] = { 0.0, 0.0 };
    isMeasured = isMeasured &&
      this->Measure(SurfacePoint::OnEdge(this->Mesh, halfEdge, t), sites.data(), 2, found);
    return Probe{ t, found[0] - found[1], 0.5 * (found[0] + found[1]) };
  };
  const Probe start = measure(parameter);
  // Infinite heights lead to bisection until the root is bracketed.
  const bool isBefore = start.Height < 0.0;
  const Probe begin = isBefore ? start : Probe{ low, -Infinity, 0.0 };
  const Probe end = isBefore ? Probe{ high, Infinity, 0.0 } : start;
  const Probe root = FindRoot(
    begin, end, BalanceTolerance * this->Accuracy * start.Distance, MostEdgeSteps, measure);
  if (isMeasured)
  {
    parameter = root.X;
    distance = root.Distance;
  }
}

void BorderRefinement::Balance(
  Id face, const std::array<Id, 3>& sites, std::array<double, 3>& place, double& distance) const
{
  bool isDoubtful = false;
  for (const Id site : sites)
  {
    isDoubtful = isDoubtful || this->IsDoubtful(face, place, site, distance);
  }
  if (!isDoubtful)
  {
    return;
  }
  const auto measure = [&](const Coordinates& at, Coordinates& found) {
    return std::min({ at[0], at[1], at[2] }) >= 0.0 &&
      this->Measure(SurfacePoint::InTriangle(this->Mesh, face, at), sites.data(), 3, found.data());
  };
  // Newton's method with finite differences, as long as it improves.
  double best = Infinity;
  Coordinates next = place;
  for (int step = 0; step < MostFaceSteps; ++step)
  {
    std::array<double, 3> here{};
    std::array<double, 3> along{};
    std::array<double, 3> across{};
    if (!measure(next, here))
    {
      return;
    }
    const double spread =
      *std::max_element(here.begin(), here.end()) - *std::min_element(here.begin(), here.end());
    if (!(spread < best))
    {
      return;
    }
    best = spread;
    place = next;
    distance = (here[0] + here[1] + here[2]) / 3.0;
    const double h = next[0] > 2.0 * DifferenceStep ? DifferenceStep : -DifferenceStep;
    const Coordinates a{ { next[0] - h, next[1] + h, next[2] } };
    const Coordinates b{ { next[0] - h, next[1], next[2] + h } };
    if (best <= BalanceTolerance * this->Accuracy * distance || !measure(a, along) ||
      !measure(b, across))
    {
      return;
    }
    const Point2 value{ here[1] - here[0], here[2] - here[0] };
    const Point2 u{ (along[1] - along[0] - value.X) / h, (along[2] - along[0] - value.Y) / h };
    const Point2 v{ (across[1] - across[0] - value.X) / h, (across[2] - across[0] - value.Y) / h };
    const double determinant = Cross(u, v);
    const double x = -Cross(value, v) / determinant;
    const double y = -Cross(u, value) / determinant;
    if (!std::isfinite(x) || !std::isfinite(y))
    {
      return;
    }
    next = Step(next, { { -x - y, x, y } });
  }
}

bool BorderRefinement::IsWrong(
  Id face, const std::array<Id, 2>& sites, const Coordinates& place, double distance) const
{
  if (!this->IsDoubtful(face, place, sites[0], distance, SuspiciousDifference) &&
    !this->IsDoubtful(face, place, sites[1], distance, SuspiciousDifference))
  {
    return false;
  }
  double found[2] = { 0.0, 0.0 };
  return this->Measure(SurfacePoint::InTriangle(this->Mesh, face, place), sites.data(), 2, found) &&
    std::abs(found[0] - found[1]) > WrongDifference * this->Accuracy * std::max(found[0], found[1]);
}

/// Returns true if a corner of the face that is reached by the site predicts a different distance.
bool BorderRefinement::IsDoubtful(
  Id face, const Coordinates& place, Id site, double distance, double tolerance) const
{
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    const SiteDistances::Entry* entry = this->Distances.Find(this->Mesh.Origin(h), site);
    if (!entry)
    {
      continue;
    }
    const Point2 p = PlaceInFrame(this->Mesh, h, place);
    const CornerModel model(this->Mesh, this->Mesh.Origin(h), entry->Source);
    const bool isKnown = model.IsKnown || !(model.Length > 0.0);
    const double predicted =
      model.At(Norm(p.X, p.Y), this->Mesh.PolarAngle(h) + std::atan2(p.Y, p.X));
    if (!isKnown || !(std::abs(predicted - distance) <= tolerance * this->Accuracy * distance))
    {
      return true;
    }
  }
  return false;
}

/// Computes the distances of a point from sites through links of its own. Returns false if one is
/// unknown.
bool BorderRefinement::Measure(
  const SurfacePoint& point, const Id* sites, std::size_t count, double* distances) const
{
  if (this->Work > this->GetMostWork() || this->MeetsRim)
  {
    return false;
  }
  std::vector<SurfacePoint> targets;
  for (std::size_t i = 0; i < count; ++i)
  {
    const SurfacePoint& site = this->Sites[sites[i]];
    if (IsOnMesh(site))
    {
      targets.push_back(site);
    }
  }
  std::vector<GraphLink> links;
  std::vector<double> direct;
  if (!this->Builder
         .Link(point, this->Accuracy, targets, links, direct, &this->Work, &this->MeetsRim)
         .IsOk() ||
    this->MeetsRim)
  {
    return false;
  }
  auto next = direct.begin();
  for (std::size_t i = 0; i < count; ++i)
  {
    distances[i] = IsOnMesh(this->Sites[sites[i]]) ? *next++ : Infinity;
    for (const GraphLink& link : links)
    {
      const SiteDistances::Entry* entry = this->Distances.Find(link.Vertex, sites[i]);
      const double distance = entry ? entry->Distance + link.Length : Infinity;
      distances[i] = std::min(distances[i], distance);
    }
    if (!(distances[i] < Infinity))
    {
      return false;
    }
  }
  return true;
}
}
