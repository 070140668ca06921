// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Interpolation of given values at sites by biharmonic and harmonic splines.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "PathChecks.h"
#include "SplineTestTools.h"
#include "TestMeshes.h"

#include "dggBiharmonicSplines.h"
#include "dggGreensColumn.h"
#include "dggPoissonSystem.h"

namespace dggtest
{
namespace
{
using Columns = std::vector<std::vector<double>>;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A solver and its splines.
class Biharmonic
{
public:
  explicit Biharmonic(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
    : Solver(Ready(mesh, options))
    , Splines(*Solver)
  {
  }
  dgg::Status Prepare(const std::vector<dgg::SurfacePoint>& sites)
  {
    this->Sites = sites;
    return this->Splines.Prepare(sites, nullptr, nullptr);
  }
  void PrepareSome(Id count)
  {
    std::vector<Id> sites;
    ASSERT_TRUE(Ok(dgg::ChooseSplineSites(*this->Solver, count, nullptr, sites)));
    ASSERT_TRUE(Ok(this->Prepare(AtVertices(sites))));
  }
  std::vector<double> Interpolate(const std::vector<double>& values) const
  {
    Columns functions;
    EXPECT_TRUE(Ok(this->Splines.Interpolate({ values }, nullptr, nullptr, functions)));
    return functions.empty() ? std::vector<double>() : functions[0];
  }
  std::vector<double> AtSites(const std::vector<double>& function) const
  {
    std::vector<double> values;
    for (const dgg::SurfacePoint& site : this->Sites)
    {
      values.push_back(dgg::InterpolateAt(this->Solver->GetMesh(), site, function));
    }
    return values;
  }
  /// Returns M^-1 L u; 0 at vertices with prescribed values.
  std::vector<double> Laplacian(const std::vector<double>& function) const
  {
    const dgg::PoissonSystem& system = this->Solver->GetSystem();
    std::vector<double> laplacian = system.Multiply(function);
    for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
    {
      const double area = system.GetArea(v);
      laplacian[v] = area > 0.0 && !system.IsFixed(v) ? laplacian[v] / area : 0.0;
    }
    return laplacian;
  }
  double Energy(const std::vector<double>& function) const
  {
    const std::vector<double> laplacian = this->Laplacian(function);
    double sum = 0.0;
    for (std::size_t v = 0; v < laplacian.size(); ++v)
    {
      sum += this->Solver->GetAreas()[v] * laplacian[v] * laplacian[v];
    }
    return sum;
  }

  std::unique_ptr<dgg::PoissonSolver> Solver;
  dgg::BiharmonicSplines Splines;
  std::vector<dgg::SurfacePoint> Sites;
};

void ExpectValues(const std::vector<double>& expected, const std::vector<double>& actual,
  const std::string& name, double tolerance = 1e-11)
{
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(actual[i], expected[i], tolerance) << name << " " << i;
  }
}
}

TEST(BiharmonicSplines, HaveTheValuesOfSites)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const dgg::PoissonOptions& options : AllPoissonOptions())
    {
      Biharmonic spline(mesh, options);
      spline.PrepareSome(12);
      // Sites may be anywhere: add sites in faces and on edges.
      std::vector<dgg::SurfacePoint> sites = spline.Sites;
      for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 9, 5))
      {
        if (!spline.Solver->GetSystem().IsFixed(point))
        {
          sites.push_back(point);
        }
      }
      ASSERT_TRUE(Ok(spline.Prepare(sites))) << named.Name;
      const std::vector<double> values = RandomValues(sites.size(), 3);
      std::vector<double> large = values;
      for (double& value : large)
      {
        value *= 1e200;
      }
      Columns functions;
      ASSERT_TRUE(Ok(spline.Splines.Interpolate(
        { values, large, std::vector<double>(values.size(), 0.1) }, nullptr, nullptr, functions)));
      ExpectValues(values, spline.AtSites(functions[0]), named.Name);
      for (std::size_t v = 0; v < functions[0].size(); ++v)
      {
        ASSERT_NEAR(functions[1][v] / 1e200, functions[0][v], 1e-9);
        ASSERT_TRUE(!spline.Solver->IsFixed(static_cast<Id>(v)) || functions[0][v] == 0.0);
        const dgg::PoissonSystem& system = spline.Solver->GetSystem();
        ASSERT_TRUE(
          !system.IsFree(system.GetComponent(static_cast<Id>(v))) || functions[2][v] == 0.1);
      }
    }
  }
}

TEST(BiharmonicSplines, HaveTheLeastEnergy)
{
  // The spline has the least energy of all functions with these values: another interpolant has
  // more energy, and the load is zero away from the sites.
  for (const auto boundary : Boundaries)
  {
    const TestMesh plane = Scaled(Plane(20, 17, 0.25), 0.1);
    const dgg::SurfaceMesh mesh = Build(plane);
    Biharmonic spline(mesh, With(boundary));
    spline.PrepareSome(30);
    std::vector<double> smooth(mesh.GetNumberOfVertices(), 0.0);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double* p = plane.Point(v);
      smooth[v] = spline.Solver->IsFixed(v) ? 0.0 : std::sin(3.0 * p[0]) * std::cos(2.0 * p[1]);
    }
    const std::vector<double> function = spline.Interpolate(spline.AtSites(smooth));
    EXPECT_LT(spline.Energy(function), spline.Energy(smooth));
    const std::vector<double> forces =
      spline.Solver->GetSystem().Multiply(spline.Laplacian(function));
    double total = 0.0;
    double largest = 0.0;
    double elsewhere = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const bool isSite = std::any_of(spline.Sites.begin(), spline.Sites.end(),
        [&](const dgg::SurfacePoint& site) { return site.Vertex == v; });
      const double force = spline.Solver->IsFixed(v) ? 0.0 : std::abs(forces[v]);
      (isSite ? largest : elsewhere) = std::max(isSite ? largest : elsewhere, force);
      total += forces[v];
    }
    EXPECT_LT(elsewhere, 1e-8 * largest);
    EXPECT_TRUE(boundary == dgg::PoissonBoundary::Dirichlet || std::abs(total) < 1e-8 * largest);
  }
}

TEST(BiharmonicSplines, OneSite)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.02, 3));
  Biharmonic spline(mesh);
  Random random(3);
  const dgg::SurfacePoint place = InsideFace(mesh, random);
  ASSERT_TRUE(Ok(spline.Prepare({ place })));
  for (const double value : spline.Interpolate({ -4.5 }))
  {
    EXPECT_EQ(value, -4.5);
  }
  // With Dirichlet conditions the spline of a single site is not constant.
  const dgg::SurfaceMesh plane = Build(Plane(8, 8, 0.2));
  Biharmonic held(plane, With(dgg::PoissonBoundary::Dirichlet));
  ASSERT_TRUE(Ok(held.Prepare({ dgg::SurfacePoint::AtVertex(40) })));
  const std::vector<double> hill = held.Interpolate({ 2.0 });
  EXPECT_NEAR(hill[40], 2.0, 1e-12);
  EXPECT_EQ(hill[0], 0.0);
  EXPECT_LT(*std::max_element(hill.begin(), hill.end()), 2.1);
}

TEST(BiharmonicSplines, BasisSumsToOne)
{
  for (const auto boundary : Boundaries)
  {
    const dgg::SurfaceMesh mesh = Build(SeveralComponents());
    Biharmonic spline(mesh, With(boundary));
    spline.PrepareSome(19);
    const dgg::PoissonSystem& system = spline.Solver->GetSystem();
    Columns basis(spline.Sites.size());
    ASSERT_TRUE(Ok(spline.Splines.FindBasis(nullptr, nullptr,
      [&](Id site, const std::vector<double>& values) { basis[site] = values; })));
    const std::vector<double> values = RandomValues(basis.size(), 8);
    std::vector<double> sum(mesh.GetNumberOfVertices(), 0.0);
    std::vector<double> combined = sum;
    for (std::size_t j = 0; j < basis.size(); ++j)
    {
      std::vector<double> unit(basis.size(), 0.0);
      unit[j] = 1.0;
      ExpectValues(unit, spline.AtSites(basis[j]), "basis");
      const Id component = system.GetComponent(spline.Sites[j]);
      for (std::size_t v = 0; v < sum.size(); ++v)
      {
        ASSERT_TRUE(
          system.GetComponent(static_cast<Id>(v)) == component || std::abs(basis[j][v]) < 1e-11);
        sum[v] += basis[j][v];
        combined[v] += values[j] * basis[j][v];
      }
    }
    ExpectSameField(combined, spline.Interpolate(values), 1e-9, "combined");
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_TRUE(!system.IsFree(system.GetComponent(v)) || std::abs(sum[v] - 1.0) < 1e-10);
    }
  }
}

TEST(BiharmonicSplines, SmoothFunctionsAreApproximated)
{
  // Refine the sites on the sphere: errors fall like the fourth power of the site distance until
  // the discretization error dominates.
  const TestMesh sphere = Icosphere(5);
  const dgg::SurfaceMesh mesh = Build(sphere);
  Biharmonic spline(mesh);
  const auto truth = [&](Id v) {
    const double* p = sphere.Point(v);
    return std::exp(p[0]) * p[2] + p[1];
  };
  Convergence errors(3.0);
  for (const Id count : { 25, 100, 400 })
  {
    spline.PrepareSome(count);
    std::vector<double> values;
    for (const dgg::SurfacePoint& site : spline.Sites)
    {
      values.push_back(truth(site.Vertex));
    }
    const std::vector<double> function = spline.Interpolate(values);
    Comparison comparison;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      comparison.Add(spline.Solver->GetAreas()[v], function[v], truth(v));
    }
    RecordProperty("error" + std::to_string(count), std::to_string(comparison.Relative()));
    errors.Add(comparison.Relative());
  }
  EXPECT_LT(errors.Last, 3e-4);
}

TEST(HarmonicSplines, InterpolateValuesAtSites)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto boundary : Boundaries)
    {
      Splines splines(mesh, With(boundary));
      splines.PrepareSome(14);
      std::vector<double> atSites;
      for (const std::vector<double>& function : splines.Basis())
      {
        for (const Id site : splines.Sites)
        {
          atSites.push_back(function[site]);
        }
      }
      const std::vector<double> values = RandomValues(splines.Sites.size(), 3);
      Columns functions;
      const auto interpolate = [&](const Columns& columns) {
        return splines.Functions.Interpolate(atSites, columns, nullptr, nullptr, functions);
      };
      ASSERT_TRUE(Ok(interpolate({ values, std::vector<double>(values.size(), 0.1) })));
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_NEAR(functions[0][splines.Sites[i]], values[i], 1e-11) << named.Name;
      }
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const dgg::PoissonSystem& system = splines.Solver.GetSystem();
        ASSERT_TRUE(!system.IsFree(system.GetComponent(v)) || functions[1][v] == 0.1);
      }
      EXPECT_TRUE(Says(interpolate({ { NaN } }), "1 values"));
      std::fill(atSites.begin(), atSites.end(), 1.0);
      EXPECT_TRUE(Says(interpolate({ values }), "linearly dependent"));
      atSites = { 1.0 };
      EXPECT_TRUE(Says(interpolate({ values }), "1 values"));
    }
  }
}
}
