// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSplineSites.h"

#include "dggFarthestPoints.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggThinTriangles.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace dgg
{
namespace
{
/// Progress after the distances of all vertices from given values.
constexpr double GivenDone = 0.2;

/// The edges of the triangles, from both ends.
struct EdgeRows
{
  explicit EdgeRows(const IntrinsicTriangulation& triangulation, Id numberOfVertices)
    : Offsets(static_cast<std::size_t>(numberOfVertices) + 1, 0)
  {
    const Id sides = triangulation.GetNumberOfHalfEdges();
    for (Id h = 0; h < sides; ++h)
    {
      ++this->Offsets[triangulation.Origin(h) + 1];
      ++this->Offsets[triangulation.Destination(h) + 1];
    }
    for (Id v = 0; v < numberOfVertices; ++v)
    {
      this->Offsets[v + 1] += this->Offsets[v];
    }
    this->Targets.resize(2 * static_cast<std::size_t>(sides));
    this->Lengths.resize(this->Targets.size());
    std::vector<Offset> next(this->Offsets.begin(), this->Offsets.end() - 1);
    for (Id h = 0; h < sides; ++h)
    {
      const Id ends[] = { triangulation.Origin(h), triangulation.Destination(h) };
      for (int k = 0; k < 2; ++k)
      {
        const Offset place = next[ends[k]]++;
        this->Targets[place] = ends[1 - k];
        this->Lengths[place] = triangulation.Length(h);
      }
    }
  }

  GraphView View() const
  {
    GraphView view;
    view.NumberOfVertices = static_cast<Id>(this->Offsets.size() - 1);
    view.Offsets = this->Offsets.data();
    view.Targets = this->Targets.data();
    view.WideLengths = this->Lengths.data();
    return view;
  }

  std::vector<Offset> Offsets;
  std::vector<Id> Targets;
  std::vector<double> Lengths;
};

bool HasFace(const SurfaceMesh& mesh, Id v)
{
  return mesh.FanBegin(v) != mesh.FanEnd(v);
}

/// Returns the seeds that exclude a chosen site and its neighborhood; in a thin component, which
/// may have only one site, all vertices.
std::vector<GraphSeed> SeedsOf(const PoissonSystem& system, Id site)
{
  const Id component = system.GetComponent(site);
  if (!system.IsThin(component))
  {
    return { { site } };
  }
  std::vector<GraphSeed> seeds;
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (system.GetComponent(v) == component)
    {
      seeds.push_back({ v });
    }
  }
  return seeds;
}

/// Returns, for each component with a free vertex, the farthest free vertex.
std::vector<Id> FindFarthest(const PoissonSystem& system, const std::vector<double>& distances)
{
  std::vector<Id> farthest(system.GetNumberOfComponents(), NoId);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    Id& best = farthest[system.GetComponent(v)];
    const bool isFree = HasFace(system.GetMesh(), v) && !system.IsFixed(v);
    if (isFree && (best == NoId || distances[v] > distances[best]))
    {
      best = v;
    }
  }
  farthest.erase(std::remove(farthest.begin(), farthest.end(), NoId), farthest.end());
  return farthest;
}

/// Returns 1 for each component that has a free vertex, otherwise 0.
std::vector<std::uint8_t> FindSplineComponents(const PoissonSystem& system)
{
  std::vector<std::uint8_t> has(system.GetNumberOfComponents(), 0);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (HasFace(system.GetMesh(), v) && !system.IsFixed(v))
    {
      has[system.GetComponent(v)] = 1;
    }
  }
  return has;
}
}

Id CountSplineComponents(const PoissonSolver& solver)
{
  const std::vector<std::uint8_t> has = FindSplineComponents(solver.GetSystem());
  return static_cast<Id>(std::count(has.begin(), has.end(), std::uint8_t(1)));
}

Status ChooseSplineSites(
  const PoissonSolver& solver, Id count, const ProgressCallback& progress, std::vector<Id>& sites)
{
  sites.clear();
  if (!solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  const PoissonSystem& system = solver.GetSystem();
  const EdgeRows rows(system.GetTriangulation(), system.GetNumberOfVertices());
  FarthestPoints points(rows.View(), nullptr);
  std::vector<GraphSeed> given;
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (system.IsFixed(v))
    {
      given.push_back({ v });
    }
  }
  const auto part = [&](double begin, double end) { return ProgressPart(progress, begin, end); };
  DGG_RETURN_IF_ERROR(given.empty() ? Status::Success() : points.Add(given, part(0.0, GivenDone)));
  // Choose one site in each component first; otherwise farther vertices of other components might
  // come before.
  std::vector<Id> found = FindFarthest(system, points.GetDistances());
  const Id wanted = std::max(count, static_cast<Id>(found.size()));
  const std::size_t first = found.size();
  for (std::size_t k = 0; k < static_cast<std::size_t>(wanted); ++k)
  {
    const Id farthest = k < first ? found[k] : points.Find().Vertex;
    if (farthest == NoId)
    {
      break;
    }
    found.resize(std::max(found.size(), k + 1), farthest);
    const double step = (1.0 - GivenDone) / static_cast<double>(wanted);
    const double done = GivenDone + step * static_cast<double>(k + 1);
    DGG_RETURN_IF_ERROR(points.Add(SeedsOf(system, farthest), part(done - step, done)));
    DGG_RETURN_IF_ERROR(ReportTo(progress, std::min(1.0, done)));
  }
  DGG_RETURN_IF_ERROR(ReportTo(progress, 1.0));
  sites.swap(found);
  return Status::Success();
}

Status CheckSplineSites(const PoissonSolver& solver, const std::vector<Id>& sites)
{
  std::vector<SurfacePoint> points;
  for (const Id site : sites)
  {
    points.push_back(SurfacePoint::AtVertex(site));
  }
  return CheckSplinePlaces(solver, points);
}

Status CheckSplinePlaces(const PoissonSolver& solver, const std::vector<SurfacePoint>& sites)
{
  if (!solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  if (sites.empty())
  {
    return InvalidInput("There is no site").Fix("Add at least one site");
  }
  const PoissonSystem& system = solver.GetSystem();
  std::vector<std::uint8_t> needed = FindSplineComponents(system);
  std::vector<Id> numbers(system.GetNumberOfVertices(), NoId);
  for (std::size_t k = 0; k < sites.size(); ++k)
  {
    const SurfacePoint& site = sites[k];
    const std::string what = JoinText("Site ", k, " (", NameOf(site), ")");
    DGG_RETURN_IF_ERROR(solver.CheckPlace(site).Of(JoinText("Site ", k)));
    if (system.IsFixed(site))
    {
      return InvalidInput(what, " lies on the boundary, where values are given")
        .At("Boundary", static_cast<Offset>(k))
        .Fix("Move the point inside, or set {Boundary} to Neumann");
    }
    if (IsVertex(site))
    {
      Id& number = numbers[site.Vertex];
      if (number != NoId)
      {
        return InvalidInput(what, " is the same as site ", number).Fix("Remove one of them");
      }
      number = static_cast<Id>(k);
    }
    // A single site is valid in any component without given values: its function is 1.
    const Id component = system.GetComponent(site);
    DGG_RETURN_IF_ERROR(needed[component] == 0 || !system.IsFree(component)
        ? CheckThinPlace(system, component, what)
        : Status::Success());
    needed[component] = 0;
  }
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (needed[system.GetComponent(v)] != 0 && HasFace(system.GetMesh(), v) && !system.IsFixed(v))
    {
      return InvalidInput("The component of vertex ", v, " has no site")
        .Fix("Add a site to each component");
    }
  }
  return Status::Success();
}

Status CheckPreparedSites(
  const PoissonSystem& system, std::size_t numberOfSites, std::uint64_t revision)
{
  if (numberOfSites == 0)
  {
    return InvalidInput("There are no sites").Fix("Call Prepare() first");
  }
  return revision == system.GetRevision()
    ? Status::Success()
    : InvalidInput("The solver has changed since Prepare()").Fix("Call Prepare() again");
}
}
