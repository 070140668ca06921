// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of Green's functions: prepared solvers, points, closed forms.
#ifndef GreensTestTools_h
#define GreensTestTools_h

#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggGreensFunction.h"
#include "dggSurfacePath.h"

#include <complex>

namespace dggtest
{
inline constexpr dgg::GreensMethod Methods[] = { dgg::GreensMethod::SingularitySubtraction,
  dgg::GreensMethod::Localized, dgg::GreensMethod::Interpolated, dgg::GreensMethod::Vertex };

/// A prepared solver and its Green's functions.
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
/// Returns the options for both boundary conditions, without and with flips.
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

/// Returns the Green's function of the flat torus with sides 1 at x + i y, with mean zero, by the
/// first theta function.
inline double TorusGreens(double x, double y)
{
  const std::complex<double> z(x, y - std::round(y));
  std::complex<double> theta(0.0, 0.0);
  for (int n = 0; n < 6; ++n)
  {
    theta += (n % 2 ? -2.0 : 2.0) * std::exp(-dgg::Pi * (n + 0.5) * (n + 0.5)) *
      std::sin((2.0 * n + 1.0) * dgg::Pi * z);
  }
  // Dedekind eta function at i.
  const double eta = std::tgamma(0.25) / (2.0 * std::pow(dgg::Pi, 0.75));
  return -std::log(std::abs(theta) / eta) / (2.0 * dgg::Pi) + 0.5 * z.imag() * z.imag();
}

/// Returns the Neumann Green's function of the unit square, by images on a torus with sides 2.
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

/// Returns the Dirichlet Green's function of the unit disk.
inline double DiskGreens(std::complex<double> x, std::complex<double> y)
{
  return std::log(std::abs(1.0 - std::conj(x) * y) / std::abs(y - x)) / (2.0 * dgg::Pi);
}

/// Relative L2 error over vertices; vertices with an infinite true value are skipped.
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

/// Relative errors of a Green's function on the unit sphere: within a distance of the pole, and
/// over all vertices.
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

/// Returns true if the solver refuses the mesh because of thin triangles. Other errors fail the
/// test.
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

/// Returns IsTooThin() of a mesh; among the named meshes only soups may be too thin.
inline bool IsThinSoup(
  const dgg::SurfaceMesh& mesh, const std::string& name, const dgg::PoissonOptions& options)
{
  const bool isThin = IsTooThin(mesh, options);
  EXPECT_TRUE(!isThin || name.compare(0, 4, "soup") == 0) << name;
  return isThin;
}
}

#endif
