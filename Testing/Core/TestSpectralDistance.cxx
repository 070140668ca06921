// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Eigenfunctions, biharmonic, commute-time and diffusion distances.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"
#include "dggSpectralDistance.h"

namespace dggtest
{
namespace
{
/// Returns the eigenpairs of each component.
std::vector<dgg::Eigenpairs> FindAllPairs(const dgg::PoissonSolver& solver, Id count)
{
  std::vector<dgg::Eigenpairs> pairs;
  EXPECT_TRUE(Ok(dgg::FindEigenpairs(solver, count, nullptr, pairs)));
  return pairs;
}

dgg::Eigenpairs FindPairs(const dgg::PoissonSolver& solver, Id count)
{
  return FindAllPairs(solver, count).front();
}

/// Expects L v = lambda M v and orthonormal vectors.
void ExpectEigenpairs(
  const dgg::PoissonSolver& solver, const dgg::Eigenpairs& pairs, const std::string& what)
{
  const auto n = static_cast<std::size_t>(solver.GetMesh().GetNumberOfVertices());
  const std::vector<double>& areas = solver.GetAreas();
  const auto functionOf = [&](Id k) {
    std::vector<double> function(n, 0.0);
    for (std::size_t v = 0; v < pairs.Vertices.size(); ++v)
    {
      function[pairs.Vertices[v]] = pairs.Functions[k * pairs.Vertices.size() + v];
    }
    return function;
  };
  for (Id i = 0; i < pairs.GetCount(); ++i)
  {
    const std::vector<double> function = functionOf(i);
    if (i > 0)
    {
      EXPECT_LE(pairs.Values[i - 1], pairs.Values[i] * (1.0 + 1e-12)) << what;
    }
    const std::vector<double> product = solver.GetSystem().Multiply(function);
    double residual = 0.0;
    for (std::size_t v = 0; v < n; ++v)
    {
      if (areas[v] > 0.0 && !solver.IsFixed(static_cast<Id>(v)))
      {
        const double r = product[v] - pairs.Values[i] * areas[v] * function[v];
        residual += r * r / areas[v];
      }
    }
    EXPECT_LT(std::sqrt(residual), 1e-4 * pairs.Values[i]) << what << " " << i;
    for (Id j = 0; j <= i; ++j)
    {
      const std::vector<double> other = functionOf(j);
      double sum = 0.0;
      for (std::size_t v = 0; v < n; ++v)
      {
        sum += areas[v] * function[v] * other[v];
      }
      EXPECT_NEAR(sum, i == j ? 1.0 : 0.0, 1e-8) << what << " " << i << " " << j;
    }
  }
}

dgg::SpectralOptions Options(dgg::SpectralKind kind, dgg::SpectralMethod method, Id count = 150)
{
  dgg::SpectralOptions options;
  options.Kind = kind;
  options.Method = method;
  options.NumberOfEigenvalues = count;
  return options;
}
}

TEST(Eigenpairs, SphereHasItsMultiplicities)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  const auto solver = Ready(mesh);
  const dgg::Eigenpairs pairs = FindPairs(*solver, 35);
  ASSERT_EQ(pairs.GetCount(), 35);
  EXPECT_TRUE(pairs.IsComplete);
  ExpectEigenpairs(*solver, pairs, "sphere");
  Id k = 0;
  for (int l = 1; l <= 5; ++l)
  {
    for (int m = 0; m < 2 * l + 1; ++m, ++k)
    {
      EXPECT_NEAR(pairs.Values[k], l * (l + 1.0), 0.02 * l * (l + 1.0)) << k;
    }
  }
}

TEST(Eigenpairs, FlatTorusConverges)
{
  Convergence errors(1.9);
  for (const Id n : { 12, 24, 48 })
  {
    const dgg::SurfaceMesh mesh = Build(FlatTorus(1.0, 0.0, 1.0, n, n, false));
    const auto solver = Ready(mesh);
    const dgg::Eigenpairs pairs = FindPairs(*solver, 8);
    double error = 0.0;
    for (Id k = 0; k < 8; ++k)
    {
      const double expected = 4.0 * dgg::Pi * dgg::Pi * (k < 4 ? 1.0 : 2.0);
      error = std::max(error, std::abs(pairs.Values[k] / expected - 1.0));
    }
    errors.Add(error);
  }
}

TEST(Eigenpairs, OfAnySize)
{
  std::vector<double> expected;
  for (const double size : { 1.0, 1e-7, 1e7 })
  {
    const dgg::SurfaceMesh mesh = Build(Scaled(NoisySphere(3, 0.1, 4), size));
    const auto solver = Ready(mesh);
    const dgg::Eigenpairs pairs = FindPairs(*solver, 20);
    EXPECT_TRUE(pairs.IsComplete);
    ASSERT_EQ(pairs.GetCount(), 20);
    expected = expected.empty() ? pairs.Values : expected;
    for (Id k = 0; k < 20; ++k)
    {
      EXPECT_NEAR(pairs.Values[k] * size * size, expected[k], 1e-9 * expected[k]) << size;
    }
  }
}

TEST(Eigenpairs, ComponentsAreIndependent)
{
  TestMesh spheres;
  for (const double radius : { 1.0, 0.1, 10.0 })
  {
    Append(spheres, Translated(Scaled(NoisySphere(3, 0.1, 4), radius), 3.0 * radius, 0.0, 0.0));
  }
  const dgg::SurfaceMesh mesh = Build(spheres);
  const auto solver = Ready(mesh);
  const dgg::SurfaceMesh alone = Build(NoisySphere(3, 0.1, 4));
  const dgg::Eigenpairs expected = FindPairs(*Ready(alone), 20);
  const std::vector<dgg::Eigenpairs> parts = FindAllPairs(*solver, 20);
  ASSERT_EQ(parts.size(), 3u);
  for (const dgg::Eigenpairs& pairs : parts)
  {
    ASSERT_EQ(pairs.GetCount(), 20);
    EXPECT_TRUE(pairs.IsComplete);
    const double unit = expected.Values[0] / pairs.Values[0];
    for (Id k = 0; k < 20; ++k)
    {
      EXPECT_NEAR(unit * pairs.Values[k], expected.Values[k], 1e-7 * expected.Values[k]);
    }
    ExpectEigenpairs(*solver, pairs, "spheres");
  }
}

TEST(Eigenpairs, GivenBoundaryAndAnyTriangles)
{
  dgg::PoissonOptions options;
  options.Boundary = dgg::PoissonBoundary::Dirichlet;
  const dgg::SurfaceMesh square = Build(Scaled(Plane(40, 40, 0.2), 1.0 / 40));
  const auto solver = Ready(square, options);
  const dgg::Eigenpairs pairs = FindPairs(*solver, 6);
  ExpectEigenpairs(*solver, pairs, "square");
  const double expected[6] = { 2, 5, 5, 8, 10, 10 };
  for (Id k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(pairs.Values[k] / (dgg::Pi * dgg::Pi) / expected[k], 1.0, 0.02) << k;
  }
  for (const NamedMesh& named : DefectMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto any = Ready(mesh);
    for (const dgg::Eigenpairs& found : FindAllPairs(*any, 12))
    {
      for (const double value : found.Values)
      {
        EXPECT_TRUE(std::isfinite(value) && value > 0.0) << named.Name << " " << value;
      }
      for (const double value : found.Functions)
      {
        ASSERT_TRUE(std::isfinite(value)) << named.Name;
      }
    }
  }
}

TEST(SpectralDistance, EachKindHasItsFilter)
{
  // Distance of antipodes on the sphere with the first 48 eigenvalues: only odd degrees contribute.
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const auto solver = Ready(mesh);
  const double* p = sphere.Point(0);
  const std::vector<dgg::SurfacePoint> poles{ dgg::SurfacePoint::AtVertex(0),
    dgg::SurfacePoint::AtVertex(VertexAt(sphere, -p[0], -p[1], -p[2])) };
  constexpr double time = 0.05;
  const std::map<dgg::SpectralKind, std::function<double(double)>> filters{
    { dgg::SpectralKind::Biharmonic, [](double lambda) { return 1.0 / (lambda * lambda); } },
    { dgg::SpectralKind::CommuteTime, [](double lambda) { return 1.0 / lambda; } },
    { dgg::SpectralKind::Diffusion, [](double lambda) { return std::exp(-2.0 * time * lambda); } }
  };
  for (const auto& [kind, filter] : filters)
  {
    double square = 0.0;
    for (int l = 1; l <= 6; l += 2)
    {
      square += (2 * l + 1) / dgg::Pi * filter(l * (l + 1.0));
    }
    dgg::SpectralOptions options = Options(kind, dgg::SpectralMethod::Spectrum, 48);
    options.Time = time;
    dgg::SpectralDistance distance(*solver);
    ASSERT_TRUE(Ok(distance.Prepare(options, nullptr, nullptr)));
    std::vector<double> d;
    ASSERT_TRUE(Ok(distance.Between(poles, poles, nullptr, nullptr, d)));
    EXPECT_NEAR(d[1], std::sqrt(square), 0.01 * std::sqrt(square));
  }
}

TEST(SpectralDistance, AllEigenvaluesAreExact)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(2));
  const auto solver = Ready(mesh);
  const dgg::SurfacePoint source = dgg::SurfacePoint::InFace(mesh, 11, { { 0.2, 0.3, 0.5 } });
  for (const auto kind : { dgg::SpectralKind::Biharmonic, dgg::SpectralKind::CommuteTime })
  {
    std::vector<double> fields[3];
    const Id counts[3] = { 161, 161, 30 };
    for (int k = 0; k < 3; ++k)
    {
      dgg::SpectralDistance distance(*solver);
      ASSERT_TRUE(distance
                    .Prepare(Options(kind,
                               k == 0 ? dgg::SpectralMethod::Exact : dgg::SpectralMethod::Spectrum,
                               counts[k]),
                      nullptr, nullptr)
                    .IsOk());
      ASSERT_TRUE(distance.FromPoint(source, fields[k]).IsOk());
      if (k == 0)
      {
        // Pairwise queries give the same distances.
        std::vector<double> pair;
        ASSERT_TRUE(
          distance.Between({ source }, { dgg::SurfacePoint::AtVertex(40) }, nullptr, nullptr, pair)
            .IsOk());
        EXPECT_NEAR(pair[0], fields[0][40], 1e-10);
      }
    }
    for (std::size_t v = 0; v < fields[0].size(); ++v)
    {
      EXPECT_NEAR(fields[1][v], fields[0][v], 1e-7) << v;
      EXPECT_LE(fields[2][v], fields[0][v] + 1e-9) << v; // the truncated sum lacks positive terms
      if (kind == dgg::SpectralKind::Biharmonic)
      {
        EXPECT_NEAR(fields[2][v], fields[0][v], 0.06) << v;
      }
    }
  }
}

TEST(SpectralDistance, MetricAxioms)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.2, 3));
  const auto solver = Ready(mesh);
  const std::vector<dgg::SurfacePoint> points = RandomSurfacePoints(mesh, 14, 5);
  for (const auto method : { dgg::SpectralMethod::Exact, dgg::SpectralMethod::Spectrum })
  {
    for (const auto kind : { dgg::SpectralKind::Biharmonic, dgg::SpectralKind::CommuteTime,
           dgg::SpectralKind::Diffusion })
    {
      dgg::SpectralDistance distance(*solver);
      const dgg::Status status = distance.Prepare(Options(kind, method, 20), nullptr, nullptr);
      if (kind == dgg::SpectralKind::Diffusion && method == dgg::SpectralMethod::Exact)
      {
        EXPECT_TRUE(Says(status, "Spectrum"));
        continue;
      }
      ASSERT_TRUE(status.IsOk()) << status.GetMessage();
      std::vector<double> d;
      ASSERT_TRUE(distance.Between(points, points, nullptr, nullptr, d).IsOk());
      const std::size_t n = points.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        EXPECT_NEAR(d[i * n + i], 0.0, 1e-7);
        for (std::size_t j = 0; j < n; ++j)
        {
          EXPECT_NEAR(d[i * n + j], d[j * n + i], 1e-10);
          EXPECT_TRUE(i == j || d[i * n + j] > 1e-4);
          for (std::size_t k = 0; k < n; ++k)
          {
            EXPECT_LE(d[i * n + k], (d[i * n + j] + d[j * n + k]) * (1.0 + 1e-9) + 1e-12);
          }
        }
      }
    }
  }
}

TEST(SpectralDistance, PartsAreInfinitelyFarApart)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  const auto solver = Ready(mesh);
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  for (const auto method : { dgg::SpectralMethod::Exact, dgg::SpectralMethod::Spectrum })
  {
    dgg::SpectralDistance distance(*solver);
    ASSERT_TRUE(
      distance.Prepare(Options(dgg::SpectralKind::Biharmonic, method, 20), nullptr, nullptr)
        .IsOk());
    std::vector<double> d;
    ASSERT_TRUE(distance.FromPoint(dgg::SurfacePoint::AtVertex(0), d).IsOk());
    EXPECT_EQ(d[0], 0.0);
    for (std::size_t v = 0; v < d.size(); ++v)
    {
      EXPECT_EQ(d[v] < dgg::Infinity, components[v] == components[0]);
    }
  }
}

}
