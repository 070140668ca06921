// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHeatSystem.h"

#include "dggProgressPart.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Temperature below which values have, or will soon have, less than double precision.
constexpr double LeastHeat = 1e-250;
/// Bytes per vertex of the matrix, of a derived matrix, and of arrays.
constexpr double BytesPerVertex = 200.0;
/// Logarithm of the load below which double precision is not attempted.
constexpr double LeastLogarithm = -200.0;

template <typename Number>
Number MakeLoad(const HeatSystem::Load& load);
template <>
double MakeLoad(const HeatSystem::Load& load)
{
  return load.Weight * std::exp(load.Logarithm);
}
template <>
ScaledNumber MakeLoad(const HeatSystem::Load& load)
{
  return ScaledNumber::Exp(load.Logarithm) * load.Weight;
}

bool IsTooSmall(double heat)
{
  return !(std::abs(heat) >= LeastHeat);
}
bool IsTooSmall(const ScaledNumber&)
{
  return false;
}

/// Returns the three values up to an irrelevant common factor.
std::array<double, 3> Compare(double a, double b, double c)
{
  return { { a, b, c } };
}
std::array<double, 3> Compare(const ScaledNumber& a, const ScaledNumber& b, const ScaledNumber& c)
{
  bool isAny = false;
  std::int64_t exponent = 0;
  for (const ScaledNumber* x : { &a, &b, &c })
  {
    if (!x->IsZero())
    {
      exponent = isAny ? std::max(exponent, x->GetExponent()) : x->GetExponent();
      isAny = true;
    }
  }
  return { { a.Relative(exponent), b.Relative(exponent), c.Relative(exponent) } };
}
}

HeatSystem::HeatSystem(const SurfaceMesh& mesh)
  : LaplaceSystem(mesh)
{
}

Status HeatSystem::Analyze(const HeatOptions& options, const ProgressCallback& progress)
{
  DGG_RETURN_IF_ERROR(HeatMethod::Check(options));
  if (this->IsAnalyzed && this->Options.IntrinsicDelaunay == options.IntrinsicDelaunay)
  {
    this->Options = options;
    return Status::Success();
  }
  this->IsAnalyzed = false;
  this->Options = options;
  this->Heat.Clear();
  this->DirichletHeat.Clear();
  this->Distance.Clear();
  DGG_RETURN_IF_ERROR(this->Build(options.IntrinsicDelaunay, Infinity, progress));
  this->MeasureEdges();
  this->TakeFrames();
  this->Triangulation = IntrinsicTriangulation();
  this->IsAnalyzed = true;
  return ReportTo(progress, 1.0);
}

void HeatSystem::MeasureEdges()
{
  const IntrinsicTriangulation& triangulation = this->Triangulation;
  const Id count = this->NumberOfComponents;
  this->MeanEdges.assign(count, 0.0);
  this->Triangles.assign(count, 0);
  std::vector<Offset> edges(count, 0);
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const Id component = this->Components[triangulation.Origin(h)];
    this->Triangles[component] += h % 3 == 0 ? 1 : 0;
    if (triangulation.FirstOfEdge(h) == h)
    {
      this->MeanEdges[component] += triangulation.Length(h);
      ++edges[component];
    }
  }
  for (Id c = 0; c < count; ++c)
  {
    // Isolated vertices have no edge; any length is valid.
    this->MeanEdges[c] = edges[c] > 0 ? this->MeanEdges[c] / static_cast<double>(edges[c]) : 1.0;
  }
}

void HeatSystem::TakeFrames()
{
  const IntrinsicTriangulation& triangulation = this->Triangulation;
  this->Frames.clear();
  this->Frames.reserve(triangulation.GetNumberOfFaces());
  for (Id f = 0; f < triangulation.GetNumberOfFaces(); ++f)
  {
    const Id h = 3 * f;
    const Point2 apex = triangulation.Apex(f);
    this->Frames.push_back(
      { { { triangulation.Origin(h), triangulation.Origin(h + 1), triangulation.Origin(h + 2) } },
        triangulation.Length(h), apex.X, apex.Y });
  }
}

double HeatSystem::GetHeatLength(Id component) const
{
  return std::sqrt(this->Options.TimeStepFactor) * this->MeanEdges[component];
}

/// Returns M + t L, divided by the square of the mean edge length to keep values in the middle of
/// the range.
HeatSystem::Matrix HeatSystem::MakeHeatMatrix() const
{
  Matrix matrix = this->Options.TimeStepFactor * this->Stiffness;
  for (Id v = 0; v < matrix.cols(); ++v)
  {
    const double edge = this->MeanEdges[this->Components[v]];
    const double mass = this->Areas[v] / edge / edge;
    // A vertex without a face is a separate system.
    matrix.coeffRef(v, v) += mass > 0.0 ? mass : 1.0;
  }
  return matrix;
}

Status HeatSystem::Factorize(const ProgressCallback& progress)
{
  const double factor = this->Options.TimeStepFactor;
  struct Part
  {
    bool IsWanted;
    SparseFactor* Factor;
    double* Key; // time step factor; null if not applicable
    bool IsDirichlet;
  };
  const Part parts[] = { { this->NeedsNeumann(), &this->Heat, &this->NeumannFactor, false },
    { this->NeedsDirichlet(), &this->DirichletHeat, &this->DirichletFactor, true },
    { true, &this->Distance, nullptr, false } };
  // One value of each component is fixed at 0.
  std::vector<std::uint8_t> isPinned(this->Components.size(), 0);
  for (const Id v : this->Pinned)
  {
    isPinned[v] = 1;
  }
  double done = 0.0;
  for (const Part& part : parts)
  {
    DGG_RETURN_IF_ERROR(ReportTo(progress, done));
    const ProgressCallback ofPart = ProgressPart(progress, done, done + 1.0 / 3.0);
    done += 1.0 / 3.0;
    if (!part.IsWanted)
    {
      part.Factor->Clear();
      continue;
    }
    if (part.Factor->IsComputed() && (!part.Key || *part.Key == factor))
    {
      continue;
    }
    ++this->NumberOfFactorizations;
    DGG_RETURN_IF_ERROR(part.Key
        ? part.Factor->Compute(this->Order, this->MakeHeatMatrix(),
            part.IsDirichlet ? this->OnBoundary : std::vector<std::uint8_t>(), ofPart)
        : part.Factor->Compute(this->Order, this->Stiffness, isPinned, ofPart));
    if (part.Key)
    {
      *part.Key = factor;
    }
  }
  return ReportTo(progress, 1.0);
}

bool HeatSystem::IsReady() const
{
  const double factor = this->Options.TimeStepFactor;
  return this->HoldsFactors() && (!this->NeedsNeumann() || this->NeumannFactor == factor) &&
    (!this->NeedsDirichlet() || this->DirichletFactor == factor);
}

template <typename Number>
std::vector<Number> HeatSystem::SolveHeat(const std::vector<Load>& loads) const
{
  const auto n = this->Components.size();
  std::vector<Number> heat;
  if (this->NeedsNeumann())
  {
    heat.assign(n, Number());
    for (const Load& load : loads)
    {
      heat[load.Vertex] += MakeLoad<Number>(load);
    }
    this->Heat.Solve(heat);
  }
  if (this->NeedsDirichlet())
  {
    std::vector<Number> dirichlet(n, Number());
    for (const Load& load : loads)
    {
      if (!this->OnBoundary[load.Vertex])
      {
        dirichlet[load.Vertex] += MakeLoad<Number>(load);
      }
    }
    this->DirichletHeat.Solve(dirichlet);
    if (heat.empty())
    {
      return dirichlet;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      heat[i] += dirichlet[i]; // twice the mean suffices: gradients are normalized
    }
  }
  return heat;
}

/// Computes the integrals of the normalized temperature gradients against the gradients of the
/// basis functions. Returns false if the temperature underflows somewhere.
template <typename Number>
bool HeatSystem::FindFlow(const std::vector<Load>& loads, std::vector<double>& flow) const
{
  std::vector<std::uint8_t> isHeated(this->MeanEdges.size(), 0);
  for (const Load& load : loads)
  {
    isHeated[this->Components[load.Vertex]] = 1;
  }
  const std::vector<Number> heat = this->SolveHeat<Number>(loads);
  const bool isCold = !this->NeedsNeumann();
  for (std::size_t i = 0; i < heat.size(); ++i)
  {
    if (isHeated[this->Components[i]] && !(isCold && this->OnBoundary[i]) && IsTooSmall(heat[i]))
    {
      return false;
    }
  }
  flow.assign(heat.size(), 0.0);
  for (const Frame& frame : this->Frames)
  {
    const std::array<Id, 3>& p = frame.Corners;
    const std::array<double, 3> u = Compare(heat[p[0]], heat[p[1]], heat[p[2]]);
    double first = u[1] - u[0];
    double second = u[2] - u[0];
    const double size = std::max(std::abs(first), std::abs(second));
    if (!(size > 0.0))
    {
      continue;
    }
    first /= size;
    second /= size;
    double x = -first * frame.ApexY;
    double y = first * frame.ApexX - second * frame.Length;
    const double norm = Norm(x, y);
    if (!(norm > 0.0))
    {
      continue;
    }
    // Twice the area times the gradients of the basis functions equals the sides, rotated by pi/2.
    x *= 0.5 / norm;
    y *= 0.5 / norm;
    const double atSecond = frame.ApexY * x - frame.ApexX * y;
    const double atThird = frame.Length * y;
    flow[p[0]] -= atSecond + atThird;
    flow[p[1]] += atSecond;
    flow[p[2]] += atThird;
  }
  return true;
}

std::vector<double> HeatSystem::Solve(
  const std::vector<Load>& loads, const ProgressCallback& progress) const
{
  if (!ShouldContinue(progress, 0.0))
  {
    return {};
  }
  std::vector<double> values;
  const bool isWide = std::any_of(
    loads.begin(), loads.end(), [](const Load& load) { return load.Logarithm < LeastLogarithm; });
  if (isWide || !this->FindFlow<double>(loads, values))
  {
    if (!ShouldContinue(progress, 0.2))
    {
      return {};
    }
    this->FindFlow<ScaledNumber>(loads, values);
  }
  if (!ShouldContinue(progress, 0.6))
  {
    return {};
  }
  for (const Id v : this->Pinned)
  {
    values[v] = 0.0;
  }
  this->Distance.Solve(values);
  return values;
}

double HeatSystem::GetEstimatedMemory() const
{
  const double factors =
    1.0 + (this->NeedsNeumann() ? 1.0 : 0.0) + (this->NeedsDirichlet() ? 1.0 : 0.0);
  return static_cast<double>(this->Frames.size()) * sizeof(Frame) +
    static_cast<double>(this->Components.size()) * BytesPerVertex +
    factors * this->Order.EstimateFactorMemory();
}

bool HeatSystem::HoldsFactors() const
{
  return this->IsAnalyzed && this->Distance.IsComputed() &&
    (!this->NeedsNeumann() || this->Heat.IsComputed()) &&
    (!this->NeedsDirichlet() || this->DirichletHeat.IsComputed());
}
}
