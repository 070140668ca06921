// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEarthMovers.h"

#include "dggGeodesicSource.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggSparseFactor.h"
#include "dggStatus.h"
#include "dggThinTriangles.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dgg
{
namespace
{
/// Target gap of a step as a fraction of the present gap: smaller after long steps, larger after
/// short ones, which were limited by slopes close to 1.
constexpr double FirstAim = 0.4;
constexpr double LeastAim = 0.1;
constexpr double LongStep = 0.7;
constexpr double ShortStep = 0.5;
/// Fraction of the step to a slope of 1 that is taken.
constexpr double StepMargin = 0.8;
/// Triangles with a larger cotangent are nearly degenerate. Triangles that PoissonSystem uses
/// unchanged have smaller cotangents: enlarging these triangles would increase the cost of flow
/// through them.
constexpr double MostCotangent = 1e7;
/// Slope of the first potential.
constexpr double FirstSlope = 0.9;

/// A flow as a linear function of the change of the slope: Flow + (XX, XY; XY, YY) * change.
struct LinearFlow
{
  Point2 Flow;
  double XX;
  double XY;
  double YY;

  Point2 At(const Point2& change) const
  {
    return { this->Flow.X + this->XX * change.X + this->XY * change.Y,
      this->Flow.Y + this->XY * change.X + this->YY * change.Y };
  }
};

/// Returns Newton's linear model of the flow on the central path, made symmetric (Andersen,
/// Christiansen, Conn and Overton, "An efficient primal-dual interior-point method for minimizing a
/// sum of Euclidean norms", 2000). On this path the flow is the slope times e + sqrt(e^2 +
/// |flow|^2), with a small e: it has the direction of the slope, which is below 1, and close to 1
/// where there is flow.
LinearFlow Linearize(const Point2& flow, const Point2& slope, double e)
{
  const double size = Norm(flow.X, flow.Y);
  const double root = Norm(size, e);
  const double factor = e + root;
  // root - flow . slope, without cancellation.
  const double rest = e * e / (root + size) + std::max(0.0, size - Dot(flow, slope));
  const Point2 miss{ factor * slope.X - flow.X, factor * slope.Y - flow.Y };
  const double along = factor + Dot(flow, miss) / rest;
  const double half = 0.5 * factor / rest;
  return { { along * slope.X, along * slope.Y }, factor + 2.0 * half * flow.X * slope.X,
    half * (flow.X * slope.Y + flow.Y * slope.X), factor + 2.0 * half * flow.Y * slope.Y };
}

/// Piecewise constant vectors per triangle, in frames with the first side as x axis.
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
      face.Apex = triangulation.Apex(f);
      // If the element was softened, so is the flow, for consistency. A triangle of near-zero area
      // is enlarged, which preserves its conductance: slopes across it would be noise.
      const std::array<double, 3> allowed = system.GetCotangents(f);
      double softness = 1.0;
      double largest = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double cotangent = std::abs(triangulation.Cotangent(h + k));
        largest = std::max(largest, cotangent);
        softness =
          cotangent > 1.0 ? std::min(softness, std::abs(allowed[k]) / cotangent) : softness;
      }
      face.Scale = std::sqrt(std::max(1.0, largest / MostCotangent));
      face.Length *= face.Scale;
      face.Apex = { face.Scale * face.Apex.X, face.Scale * face.Apex.Y };
      face.Area = softness * face.Scale * face.Scale * triangulation.Area(f);
      this->Faces.push_back(face);
    }
  }

  std::size_t GetSize() const { return this->Faces.size(); }
  double GetArea(std::size_t f) const { return this->Faces[f].Area; }
  double GetScale(std::size_t f) const { return this->Faces[f].Scale; }

  Point2 GradientOf(std::size_t f, const std::vector<double>& values) const
  {
    const Face& face = this->Faces[f];
    const double x = (values[face.Corners[1]] - values[face.Corners[0]]) / face.Length;
    const double rise = values[face.Corners[2]] - values[face.Corners[0]];
    return { x, (rise - x * face.Apex.X) / face.Apex.Y };
  }

  /// Adds, per vertex, the integral of the flow against the gradient of the hat function.
  void AddDivergence(std::size_t f, const Point2& flow, std::vector<double>& values) const
  {
    const Face& face = this->Faces[f];
    const double third = face.Area * flow.Y / face.Apex.Y;
    const double second = (face.Area * flow.X - third * face.Apex.X) / face.Length;
    values[face.Corners[0]] -= second + third;
    values[face.Corners[1]] += second;
    values[face.Corners[2]] += third;
  }

  /// Calls `visit(v, w, entry)` for all pairs of corners, with the integral of grad phi_v . A grad
  /// phi_w of their hat functions, for symmetric A.
  template <typename Visitor>
  void ForEachEntry(std::size_t f, const LinearFlow& a, Visitor&& visit) const
  {
    const Face& face = this->Faces[f];
    const Point2 second{ 1.0 / face.Length, -face.Apex.X / (face.Length * face.Apex.Y) };
    const Point2 third{ 0.0, 1.0 / face.Apex.Y };
    const Point2 gradients[] = { { -second.X - third.X, -second.Y - third.Y }, second, third };
    for (int i = 0; i < 3; ++i)
    {
      const Point2& g = gradients[i];
      const Point2 image{ a.XX * g.X + a.XY * g.Y, a.XY * g.X + a.YY * g.Y };
      for (int j = 0; j < 3; ++j)
      {
        visit(face.Corners[i], face.Corners[j], face.Area * Dot(image, gradients[j]));
      }
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
    double Scale = 1.0; // scale of the triangle as laid out
  };

  std::vector<Face> Faces;
};

/// The stiffness matrix with a tensor per element, which changes in each step. The system
/// provides the pattern and the elimination order.
class StepMatrix
{
public:
  explicit StepMatrix(const PoissonSystem& system)
    : System(system)
    , Upper(system.GetStiffness().triangularView<Eigen::Upper>())
    , IsPinned(static_cast<std::size_t>(system.GetNumberOfVertices()))
  {
    for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
    {
      this->IsPinned[v] = system.IsPinned(v);
    }
  }

  void Clear() { this->Upper.coeffs().setZero(); }

  void Add(Id v, Id w, double entry)
  {
    if (v <= w)
    {
      this->Upper.coeffRef(v, w) += entry;
    }
  }

  /// Replaces sources by the solution, 0 at pinned vertices.
  Status Solve(std::vector<double>& values, const ProgressCallback& progress)
  {
    DGG_RETURN_IF_ERROR(
      this->Factor.Compute(this->System.GetOrder(), this->Upper, this->IsPinned, progress));
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v] = this->IsPinned[v] ? 0.0 : values[v];
    }
    this->Factor.Solve(values);
    return Status::Success();
  }

private:
  const PoissonSystem& System;
  Eigen::SparseMatrix<double> Upper;
  std::vector<std::uint8_t> IsPinned; // per vertex
  SparseFactor Factor;
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

/// Returns the factor with which the change can be added to a slope until its norm is 1; 0 if it
/// already exceeds 1.
double FindLongestStep(const Point2& slope, const Point2& change)
{
  const double a = Dot(change, change);
  const double b = Dot(slope, change);
  const double c = std::max(0.0, 1.0 - Dot(slope, slope));
  // Form without cancellation: b is positive if the step is short.
  const double root = std::sqrt(b * b + a * c);
  return b + root > 0.0 ? (b > 0.0 ? c / (b + root) : (root - b) / a) : Infinity;
}

/// Returns the flow per face of the mesh; empty if the elements are not the faces.
std::vector<Point2> FlowInFaces(
  const PoissonSystem& system, const Flows& flows, const std::vector<Point2>& flow)
{
  const SurfaceMesh& mesh = system.GetMesh();
  std::vector<Point2> result;
  if (!system.GetOptions().IntrinsicDelaunay)
  {
    result.resize(mesh.GetNumberOfFaces());
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      const Id t = system.GetTriangleOf(f);
      const double scale = t == NoId ? 0.0 : flows.GetScale(t);
      result[f] = t == NoId ? Point2{ 0.0, 0.0 } : Point2{ scale * flow[t].X, scale * flow[t].Y };
    }
  }
  return result;
}

/// Scales masses to the sum 1, in two steps since their sum may overflow. `total` is the original
/// sum; if 0, nothing is done.
Status ScaleToOne(std::vector<double>& masses, double& total)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < masses.size(); ++v)
  {
    if (!(masses[v] >= 0.0) || !std::isfinite(masses[v]))
    {
      return InvalidInput("The mass of vertex ", v, " is ", masses[v])
        .At("Masses", static_cast<Offset>(v))
        .Fix("Use finite masses of at least 0");
    }
    largest = std::max(largest, masses[v]);
  }
  double sum = 0.0;
  for (double& mass : masses)
  {
    mass = largest > 0.0 ? mass / largest : 0.0;
    sum += mass;
  }
  for (double& mass : masses)
  {
    mass = largest > 0.0 ? mass / sum : 0.0;
  }
  total = largest * sum;
  return std::isfinite(total)
    ? Status::Success()
    : InvalidInput("The sum of the masses is not finite").At("Masses").Fix("Scale the masses");
}

/// Subtracts differences within the tolerance from the second distribution.
Status BalanceComponents(
  const SurfaceMesh& mesh, std::vector<double>& from, std::vector<double>& to)
{
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<double> fromSums(count, 0.0);
  std::vector<double> toSums(count, 0.0);
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    fromSums[components[v]] += from[v];
    toSums[components[v]] += to[v];
  }
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    const double a = fromSums[components[v]];
    const double b = toSums[components[v]];
    if (std::abs(a - b) > MassTolerance)
    {
      return InvalidInput("The component of vertex ", v, " contains a fraction of ", a,
        " of the first distribution and ", b, " of the second one")
        .At("Masses", static_cast<Offset>(v))
        .Fix("Give both distributions the same mass in each component: mass cannot move between "
             "components");
    }
    const double ratio = a / b;
    from[v] = b > 0.0 && std::isfinite(ratio) ? from[v] : 0.0;
    to[v] = b > 0.0 && std::isfinite(ratio) ? to[v] * ratio : 0.0;
  }
  return Status::Success();
}
}

Status AddPointMass(
  const SurfaceMesh& mesh, const SurfacePoint& point, double mass, std::vector<double>& masses)
{
  DGG_RETURN_IF_ERROR(point.Check(mesh));
  if (masses.size() != static_cast<std::size_t>(mesh.GetNumberOfVertices()))
  {
    return InvalidInput(
      "There are ", masses.size(), " masses for ", mesh.GetNumberOfVertices(), " vertices")
      .Fix("Give one mass per vertex");
  }
  ForEachCornerAround(
    mesh, point, [&](Id v, double weight, double) { masses[v] += mass * weight; });
  return Status::Success();
}

Status EarthMovers::Run(const std::vector<double>& from, const std::vector<double>& to,
  const EarthMoversOptions& options, EarthMoversResult& result) const
{
  result = EarthMoversResult();
  if (!this->Solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  if (system.GetOptions().Boundary != PoissonBoundary::Neumann ||
    !system.GetOptions().DirichletVertices.empty())
  {
    return InvalidInput("Mass must not leave through boundaries")
      .At("Boundary")
      .Fix("Set {Boundary} to Neumann");
  }
  const std::size_t n = from.size();
  // Required weak divergence of flows; mass flows towards smaller potentials.
  std::vector<double> sources(n);
  for (std::size_t v = 0; v < n; ++v)
  {
    sources[v] = to[v] - from[v];
  }
  DGG_RETURN_IF_ERROR(CheckThinSources(system, sources, "mass"));
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
      result.Flow = FlowInFaces(system, flows, exact);
    }
  };
  keepFlow();
  if (!std::isfinite(result.Distance))
  {
    return InvalidInput("The cost of moving the masses is too large for a floating-point number")
      .At("Masses")
      .Fix("Scale the masses");
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
    return Status::Success();
  }
  // Interior-point method: slopes stay below 1, flows keep their divergence, and e tends to 0.
  const double firstGap = result.Distance - result.LowerBound;
  const double tolerance = std::max(options.Tolerance, LeastEarthMoversGap);
  const double scale = FirstSlope / SteepestOf(flows, potential);
  for (double& value : potential)
  {
    value *= scale;
  }
  StepMatrix matrix(system);
  std::vector<double> step(n);
  std::vector<double> rest(n);
  double aim = FirstAim;
  while (result.Iterations < options.MostIterations &&
    result.Distance - result.LowerBound > tolerance * result.Distance)
  {
    const double gap = result.Distance - result.LowerBound;
    const double done =
      std::max(std::log(firstGap / gap) / std::log(firstGap / (tolerance * result.Distance)),
        static_cast<double>(result.Iterations) / options.MostIterations);
    DGG_RETURN_IF_ERROR(ReportTo(options.Progress, done));
    const double e = aim * gap / area;
    const auto linearFlow = [&](std::size_t f) {
      return Linearize(exact[f], flows.GradientOf(f, potential), e);
    };
    matrix.Clear();
    std::fill(rest.begin(), rest.end(), 0.0);
    for (std::size_t f = 0; f < m; ++f)
    {
      const LinearFlow linear = linearFlow(f);
      flows.AddDivergence(f, linear.Flow, rest);
      flows.ForEachEntry(f, linear, [&](Id v, Id w, double entry) { matrix.Add(v, w, entry); });
    }
    for (std::size_t v = 0; v < n; ++v)
    {
      step[v] = sources[v] - rest[v];
    }
    const Status solved =
      matrix.Solve(step, [&](double) { return ShouldContinue(options.Progress, done); });
    if (solved.IsAborted())
    {
      return solved;
    }
    if (!solved.IsOk())
    {
      break;
    }
    std::fill(rest.begin(), rest.end(), 0.0);
    double longest = Infinity; // step until a slope is 1
    for (std::size_t f = 0; f < m; ++f)
    {
      const LinearFlow linear = linearFlow(f);
      const Point2 slope = flows.GradientOf(f, potential);
      const Point2 change = flows.GradientOf(f, step);
      exact[f] = linear.At(change);
      flows.AddDivergence(f, exact[f], rest);
      longest = std::min(longest, FindLongestStep(slope, change));
    }
    // Residual of the divergence due to rounding.
    for (std::size_t v = 0; v < n; ++v)
    {
      rest[v] = sources[v] - rest[v];
    }
    system.Solve(rest);
    for (std::size_t f = 0; f < m; ++f)
    {
      const Point2 change = flows.GradientOf(f, rest);
      exact[f] = { exact[f].X + change.X, exact[f].Y + change.Y };
    }
    const double length = std::min(1.0, StepMargin * longest);
    for (std::size_t v = 0; v < n; ++v)
    {
      potential[v] += length * step[v];
    }
    aim = length < ShortStep ? std::min(1.0, 2.0 * aim)
                             : (length > LongStep ? std::max(LeastAim, 0.5 * aim) : aim);
    ++result.Iterations;
    keepFlow();
    keepPotential(potential);
  }
  return ReportTo(options.Progress, 1.0);
}

Status BalanceMasses(const SurfaceMesh& mesh, bool normalize, std::vector<double>& from,
  std::vector<double>& to, double& total)
{
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  if (from.size() != n || to.size() != n)
  {
    return InvalidInput(
      "The distributions have ", from.size(), " and ", to.size(), " masses for ", n, " vertices")
      .Fix("Give one mass per vertex");
  }
  double totals[2] = { 0.0, 0.0 };
  DGG_RETURN_IF_ERROR(ScaleToOne(from, totals[0]));
  DGG_RETURN_IF_ERROR(ScaleToOne(to, totals[1]));
  if (normalize && !(std::min(totals[0], totals[1]) > 0.0))
  {
    return InvalidInput("The ", totals[0] > 0.0 ? "second" : "first",
      " distribution has no mass, so it cannot be normalized")
      .At("Masses")
      .Fix("Give it a positive mass");
  }
  if (!normalize &&
    std::abs(totals[0] - totals[1]) > MassTolerance * std::max(totals[0], totals[1]))
  {
    return InvalidInput(
      "The first distribution has the mass ", totals[0], " and the second one ", totals[1])
      .At("Masses")
      .Fix("Give both the same mass, or turn on {Normalize}");
  }
  total = normalize ? 1.0 : totals[0];
  return BalanceComponents(mesh, from, to);
}
}
