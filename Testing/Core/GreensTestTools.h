// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of Green's functions share: solvers that are ready, points, closed forms.
#ifndef GreensTestTools_h
#define GreensTestTools_h

#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggGreensFunction.h"
#include "dggSurfacePath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace dggtest
{
inline constexpr dgg::GreensMethod Methods[] = { dgg::GreensMethod::SingularitySubtraction,
  dgg::GreensMethod::Localized, dgg::GreensMethod::Interpolated, dgg::GreensMethod::Vertex };

/// A solver that is ready, and its Green's functions.
class Greens
{
public:
  explicit Greens(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
    : Solver(mesh)
    , Function(Solver)
  {
    EXPECT_TRUE(Ok(this->Solver.Prepare(options, nullptr)));
  }

  dgg::GreensResult Run(const dgg::SurfacePoint& pole, const dgg::GreensQuery& query = {}) const
  {
    dgg::GreensResult result;
    EXPECT_TRUE(Ok(this->Function.Run(pole, query, result)));
    return result;
  }
  dgg::GreensResult Run(const dgg::SurfacePoint& pole, dgg::GreensMethod method) const
  {
    dgg::GreensQuery query;
    query.Method = method;
    return this->Run(pole, query);
  }

  dgg::PoissonSolver Solver;
  dgg::GreensFunction Function;
};

inline dgg::PoissonOptions With(dgg::PoissonBoundary boundary, bool delaunay = false)
{
  dgg::PoissonOptions options;
  options.Boundary = boundary;
  options.IntrinsicDelaunay = delaunay;
  return options;
}

inline constexpr dgg::PoissonBoundary Boundaries[] = { dgg::PoissonBoundary::Neumann,
  dgg::PoissonBoundary::Dirichlet };
/// Both kinds of boundaries, without and with flips.
inline std::vector<dgg::PoissonOptions> AllPoissonOptions()
{
  return { With(Boundaries[0], false), With(Boundaries[0], true), With(Boundaries[1], false),
    With(Boundaries[1], true) };
}

inline std::unique_ptr<dgg::PoissonSolver> Ready(
  const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
{
  auto solver = std::make_unique<dgg::PoissonSolver>(mesh);
  EXPECT_TRUE(Ok(solver->Prepare(options, nullptr)));
  return solver;
}

inline dgg::SurfacePoint InsideFace(const dgg::SurfaceMesh& mesh, Random& random)
{
  double a = random.Uniform(0.05, 0.95);
  double b = random.Uniform(0.05, 0.95);
  if (a + b > 1.0)
  {
    a = 1.0 - a;
    b = 1.0 - b;
  }
  return dgg::SurfacePoint::InFace(
    mesh, random.Index(mesh.GetNumberOfFaces()), { { 1.0 - a - b, a, b } });
}

inline double SphereGreens(double cosine)
{
  return -(std::log(1.0 - cosine) + 1.0 - std::log(2.0)) / (4.0 * dgg::Pi);
}

/// Of the flat torus with sides 1 at x + i y, mean zero, by the first theta function.
inline double TorusGreens(double x, double y)
{
  const std::complex<double> z(x, y - std::round(y));
  std::complex<double> theta(0.0, 0.0);
  for (int n = 0; n < 6; ++n)
  {
    theta += (n % 2 ? -2.0 : 2.0) * std::exp(-dgg::Pi * (n + 0.5) * (n + 0.5)) *
      std::sin((2.0 * n + 1.0) * dgg::Pi * z);
  }
  const double eta = std::tgamma(0.25) / (2.0 * std::pow(dgg::Pi, 0.75)); // Dedekind's, at i
  return -std::log(std::abs(theta) / eta) / (2.0 * dgg::Pi) + 0.5 * z.imag() * z.imag();
}

/// Of the unit square with nothing flowing out, by the images on a torus with sides 2.
inline double SquareGreens(const std::array<double, 3>& x, const double* y)
{
  double sum = 0.0;
  for (const double sx : { -1.0, 1.0 })
  {
    for (const double sy : { -1.0, 1.0 })
    {
      sum += TorusGreens(0.5 * (y[0] - sx * x[0]), 0.5 * (y[1] - sy * x[1]));
    }
  }
  return sum;
}

/// Of the unit disk, 0 on its rim.
inline double DiskGreens(std::complex<double> x, std::complex<double> y)
{
  return std::log(std::abs(1.0 - std::conj(x) * y) / std::abs(y - x)) / (2.0 * dgg::Pi);
}

/// Relative L2 error over vertices; those where the truth is infinite are left out.
class Comparison
{
public:
  void Add(double area, double value, double expected)
  {
    if (std::isfinite(expected))
    {
      this->Difference += area * (value - expected) * (value - expected);
      this->Size += area * expected * expected;
    }
  }
  double Relative() const { return std::sqrt(this->Difference / this->Size); }

  double Difference = 0.0;
  double Size = 0.0;
};

/// Relative errors of a Green's function on the unit sphere: within a distance of the pole, and of
/// all.
struct SphereErrors
{
  double Near;
  double All;
};

inline SphereErrors CompareOnSphere(const TestMesh& sphere, const Greens& greens,
  const dgg::SurfacePoint& pole, const std::vector<double>& values, double reach)
{
  const std::array<double, 3> x =
    dgg::PositionOf(greens.Solver.GetMesh(), pole, sphere.Points.data());
  const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  Comparison near;
  Comparison all;
  for (Id v = 0; v < sphere.GetNumberOfVertices(); ++v)
  {
    const double* y = sphere.Point(v);
    const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norm;
    if (cosine > 1.0 - 1e-12) // the pole
    {
      continue;
    }
    const double area = greens.Solver.GetAreas()[v];
    all.Add(area, values[v], SphereGreens(cosine));
    if (std::acos(cosine) < reach)
    {
      near.Add(area, values[v], SphereGreens(cosine));
    }
  }
  return { near.Relative(), all.Relative() };
}

/// Whether its triangles are too thin. Fails where something else is wrong.
inline bool IsTooThin(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
{
  dgg::PoissonSolver solver(mesh);
  const dgg::Status status = solver.Prepare(options, nullptr);
  EXPECT_EQ(status.IsOk(), solver.IsReady());
  if (!status.IsOk())
  {
    EXPECT_TRUE(Says(status, "too thin"));
  }
  return !status.IsOk();
}

/// The same, for meshes of all kinds: of those with names only soups may be.
inline bool IsThinSoup(
  const dgg::SurfaceMesh& mesh, const std::string& name, const dgg::PoissonOptions& options)
{
  const bool isThin = IsTooThin(mesh, options);
  EXPECT_TRUE(!isThin || name.compare(0, 4, "soup") == 0) << name;
  return isThin;
}
}

#endif
