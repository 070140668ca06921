// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEarthMovers.h"

#include "dggGeodesicSource.h"
#include "dggPoissonSystem.h"
#include "dggThinTriangles.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dgg
{
namespace
{
/// Over-relaxation (Eckstein and Bertsekas, 1992).
constexpr double Relaxation = 1.6;
/// How different the residuals may be before the penalty is adapted, and by how much it is.
constexpr double Imbalance = 5.0;
constexpr double Adaption = 2.0;
/// Iterations between adaptions and checks of bounds.
constexpr int Interval = 10;

/// Vectors constant per triangle, in frames with the first side as x axis.
class Flows
{
public:
  explicit Flows(const PoissonSystem& system)
  {
    const IntrinsicTriangulation& triangulation = system.GetTriangulation();
    this->Faces.reserve(triangulation.GetNumberOfFaces());
    for (Id f = 0; f < triangulation.GetNumberOfFaces(); ++f)
    {
      const Id h = 3 * f;
      Face face;
      for (int k = 0; k < 3; ++k)
      {
        face.Corners[k] = triangulation.Origin(h + k);
      }
      face.Length = triangulation.Length(h);
      face.Apex = LayOut(face.Length, triangulation.Length(h + 2), triangulation.Length(h + 1));
      // Where the element was made softer, so is the flow, for both to fit together.
      const std::array<double, 3> allowed = system.GetCotangents(f);
      double softness = 1.0;
      for (int k = 0; k < 3; ++k)
      {
        const double cotangent = triangulation.Cotangent(h + k);
        softness = std::abs(cotangent) > 1.0 ? std::min(softness, std::abs(allowed[k] / cotangent))
                                             : softness;
      }
      face.Area = softness * triangulation.Area(f);
      this->Faces.push_back(face);
    }
  }

  static std::size_t GetMemoryPerFace() { return sizeof(Face); }

  std::size_t GetSize() const { return this->Faces.size(); }
  double GetArea(std::size_t f) const { return this->Faces[f].Area; }

  Point2 GradientOf(std::size_t f, const std::vector<double>& values) const
  {
    const Face& face = this->Faces[f];
    const double x = (values[face.Corners[1]] - values[face.Corners[0]]) / face.Length;
    const double rise = values[face.Corners[2]] - values[face.Corners[0]];
    return { x, (rise - x * face.Apex.X) / face.Apex.Y };
  }

  /// Add, per vertex, the integral of the flow against the gradient of the hat function.
  void AddDivergence(const std::vector<Point2>& flow, std::vector<double>& values) const
  {
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      const Face& face = this->Faces[f];
      const double third = face.Area * flow[f].Y / face.Apex.Y;
      const double second = (face.Area * flow[f].X - third * face.Apex.X) / face.Length;
      values[face.Corners[0]] -= second + third;
      values[face.Corners[1]] += second;
      values[face.Corners[2]] += third;
    }
  }

  double CostOf(const std::vector<Point2>& flow) const
  {
    double sum = 0.0;
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      sum += this->Faces[f].Area * Norm(flow[f].X, flow[f].Y);
    }
    return sum;
  }

private:
  struct Face
  {
    Id Corners[3];
    double Length = 0.0;
    Point2 Apex;
    double Area = 0.0;
  };

  std::vector<Face> Faces;
};

double SteepestOf(const Flows& flows, const std::vector<double>& values)
{
  double steepest = 0.0;
  for (std::size_t f = 0; f < flows.GetSize(); ++f)
  {
    const Point2 gradient = flows.GradientOf(f, values);
    steepest = std::max(steepest, Norm(gradient.X, gradient.Y));
  }
  return steepest;
}

/// Per face of the mesh; nothing where the elements are others.
std::vector<Point2> FlowInFaces(const PoissonSystem& system, const std::vector<Point2>& flow)
{
  const SurfaceMesh& mesh = system.GetMesh();
  std::vector<Point2> result;
  if (!system.GetOptions().IntrinsicDelaunay)
  {
    result.resize(mesh.GetNumberOfFaces());
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      const Id t = system.GetTriangleOf(f);
      result[f] = t == NoId ? Point2{ 0.0, 0.0 } : flow[t];
    }
  }
  return result;
}

Status CheckMasses(
  const PoissonSystem& system, const std::vector<double>& from, const std::vector<double>& to)
{
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  if (from.size() != n || to.size() != n)
  {
    return Status::Invalid("both distributions need one mass for each vertex");
  }
  std::vector<double> differences(system.GetNumberOfComponents(), 0.0);
  std::vector<double> sizes(differences.size(), 0.0);
  std::vector<Id> examples(differences.size(), NoId);
  double all = 0.0;
  for (std::size_t v = 0; v < n; ++v)
  {
    if (!std::isfinite(from[v]) || !std::isfinite(to[v]))
    {
      return Status::Invalid("the mass of vertex " + std::to_string(v) + " is not finite");
    }
    const Id c = system.GetComponent(static_cast<Id>(v));
    differences[c] += from[v] - to[v];
    sizes[c] += std::abs(from[v]) + std::abs(to[v]);
    all += std::abs(from[v]) + std::abs(to[v]);
    examples[c] = static_cast<Id>(v);
  }
  for (std::size_t c = 0; c < differences.size(); ++c)
  {
    if (std::abs(differences[c]) > 1e-9 * all)
    {
      return Status::Invalid("in the part of the surface with vertex " +
        std::to_string(examples[c]) + " one distribution has " + std::to_string(differences[c]) +
        " more mass than the other: nothing can get there, so give both the same");
    }
  }
  return Status::Success();
}
}

Status AddPointMass(
  const SurfaceMesh& mesh, const SurfacePoint& point, double mass, std::vector<double>& masses)
{
  Status status = point.Check(mesh);
  if (!status.IsOk())
  {
    return status;
  }
  if (masses.size() != static_cast<std::size_t>(mesh.GetNumberOfVertices()))
  {
    return Status::Invalid("there must be one mass for each vertex");
  }
  ForEachCornerAround(
    mesh, point, [&](Id v, double weight, double) { masses[v] += mass * weight; });
  return status;
}

std::size_t EarthMovers::GetWorkingMemory() const
{
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  const auto m = static_cast<std::size_t>(system.GetTriangulation().GetNumberOfFaces());
  // The best flow of before is there until the better one is.
  const std::size_t flow = system.GetOptions().IntrinsicDelaunay
    ? 0
    : static_cast<std::size_t>(system.GetMesh().GetNumberOfFaces()) * sizeof(Point2);
  // Sources, potential and the best potential; flows that are exact, cheap, tried, and multipliers.
  return 3 * n * sizeof(double) + m * (Flows::GetMemoryPerFace() + 4 * sizeof(Point2)) + flow +
    std::max(flow, system.GetSolvingMemory());
}

Status EarthMovers::Run(const std::vector<double>& from, const std::vector<double>& to,
  const EarthMoversOptions& options, EarthMoversResult& result) const
{
  result = EarthMoversResult();
  if (!this->Solver.IsReady())
  {
    return Status::Invalid("the solver has not been prepared: call Prepare() first");
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  if (system.GetOptions().Boundary != PoissonBoundary::Neumann ||
    !system.GetOptions().GivenVertices.empty())
  {
    return Status::Invalid("mass must not leave through boundaries: use Neumann conditions");
  }
  Status status = CheckMasses(system, from, to);
  if (!status.IsOk())
  {
    return status;
  }
  const std::size_t n = from.size();
  // The weak divergence that flows must have; mass goes down potentials.
  std::vector<double> sources(n);
  for (std::size_t v = 0; v < n; ++v)
  {
    sources[v] = to[v] - from[v];
  }
  status = CheckThinSources(system, sources, "mass");
  if (!status.IsOk())
  {
    return status;
  }
  const Flows flows(system);
  const std::size_t m = flows.GetSize();
  const auto earned = [&](const std::vector<double>& potential) {
    double sum = 0.0;
    for (std::size_t v = 0; v < n; ++v)
    {
      sum += sources[v] * potential[v];
    }
    const double steepest = SteepestOf(flows, potential);
    return steepest > 0.0 ? sum / steepest : 0.0;
  };
  const auto keepPotential = [&](const std::vector<double>& potential) {
    const double bound = earned(potential);
    if (std::abs(bound) > result.LowerBound)
    {
      result.LowerBound = std::abs(bound);
      result.Potential = potential;
      const double scale =
        (bound < 0.0 ? 1.0 : -1.0) / std::max(SteepestOf(flows, potential), 1e-300);
      for (double& value : result.Potential)
      {
        value *= scale;
      }
    }
  };
  std::vector<double> potential = sources;
  system.Solve(potential);
  std::vector<Point2> exact(m); // has the right divergence
  for (std::size_t f = 0; f < m; ++f)
  {
    exact[f] = flows.GradientOf(f, potential);
  }
  result.Distance = Infinity;
  const auto keepFlow = [&] {
    const double cost = flows.CostOf(exact);
    if (cost < result.Distance)
    {
      result.Distance = cost;
      result.Flow = FlowInFaces(system, exact);
    }
  };
  keepFlow();
  if (!std::isfinite(result.Distance))
  {
    return Status::Invalid("the cost of moving the masses is too large for a number: scale them");
  }
  result.Potential.assign(n, 0.0);
  keepPotential(potential);
  double area = 0.0;
  for (std::size_t f = 0; f < m; ++f)
  {
    area += flows.GetArea(f);
  }
  if (!(result.Distance > 0.0))
  {
    return status;
  }
  // Flows shorter than 1 / penalty are cut off; to begin with, those below the mean.
  double penalty = area / result.Distance;
  std::vector<Point2> cheap(m);
  std::vector<Point2> multiplier(m);
  std::vector<Point2> trial(m);
  for (int k = 0; k < options.MostIterations; ++k)
  {
    if (options.Progress && !options.Progress(static_cast<double>(k) / options.MostIterations))
    {
      return Status::Abort();
    }
    if (result.Distance - result.LowerBound <= options.Tolerance * result.Distance)
    {
      break;
    }
    for (std::size_t f = 0; f < m; ++f)
    {
      const Point2 p{ exact[f].X - multiplier[f].X, exact[f].Y - multiplier[f].Y };
      const double size = Norm(p.X, p.Y);
      const double factor = size * penalty > 1.0 ? 1.0 - 1.0 / (size * penalty) : 0.0;
      cheap[f] = { factor * p.X, factor * p.Y };
      trial[f] = { Relaxation * cheap[f].X + (1.0 - Relaxation) * exact[f].X + multiplier[f].X,
        Relaxation * cheap[f].Y + (1.0 - Relaxation) * exact[f].Y + multiplier[f].Y };
    }
    std::fill(potential.begin(), potential.end(), 0.0);
    flows.AddDivergence(trial, potential);
    for (std::size_t v = 0; v < n; ++v)
    {
      potential[v] = sources[v] - potential[v];
    }
    system.Solve(potential);
    double primal = 0.0;
    double dual = 0.0;
    for (std::size_t f = 0; f < m; ++f)
    {
      const Point2 gradient = flows.GradientOf(f, potential);
      const Point2 next{ trial[f].X + gradient.X, trial[f].Y + gradient.Y };
      const double change = Distance(next, exact[f]);
      const double gap = Distance(next, cheap[f]);
      dual += flows.GetArea(f) * change * change;
      primal += flows.GetArea(f) * gap * gap;
      exact[f] = next;
      multiplier[f] = { -gradient.X, -gradient.Y };
    }
    result.Iterations = k + 1;
    if ((k + 1) % Interval == 0)
    {
      keepFlow();
      keepPotential(potential);
      const double ratio = std::sqrt(primal / std::max(dual, 1e-300));
      const double scale =
        ratio > Imbalance ? Adaption : (ratio < 1.0 / Imbalance ? 1.0 / Adaption : 1.0);
      penalty *= scale;
      for (Point2& u : multiplier)
      {
        u = { u.X / scale, u.Y / scale };
      }
    }
  }
  keepFlow();
  keepPotential(potential);
  return options.Progress && !options.Progress(1.0) ? Status::Abort() : status;
}
}
