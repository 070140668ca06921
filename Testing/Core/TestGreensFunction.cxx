// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions: identities, closed forms on spheres, tori, squares, disks and cones.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggGreensFunction.h"
#include "dggGreensInterpolation.h"

#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <thread>

namespace dggtest
{
namespace
{
constexpr dgg::GreensMethod Methods[] = { dgg::GreensMethod::SingularitySubtraction,
  dgg::GreensMethod::Localized, dgg::GreensMethod::Interpolated, dgg::GreensMethod::Vertex };

/// A solver that is ready, and its Green's functions.
class Greens
{
public:
  explicit Greens(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
    : Solver(mesh)
    , Function(Solver)
  {
    const dgg::Status status = this->Solver.Prepare(options, nullptr);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  }

  dgg::GreensResult Run(const dgg::SurfacePoint& pole, const dgg::GreensQuery& query = {}) const
  {
    dgg::GreensResult result;
    const dgg::Status status = this->Function.Run(pole, query, result);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
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

dgg::PoissonOptions With(dgg::PoissonBoundary boundary, bool delaunay = false)
{
  dgg::PoissonOptions options;
  options.Boundary = boundary;
  options.IntrinsicDelaunay = delaunay;
  return options;
}

dgg::SurfacePoint InsideFace(const dgg::SurfaceMesh& mesh, Random& random)
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

std::array<double, 3> PositionOf(
  const TestMesh& points, const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& p)
{
  std::array<double, 3> x{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      x[k] += dgg::IsVertex(p) ? (c == 0 ? points.Point(p.Vertex)[k] : 0.0)
                               : p.Barycentric[c] * points.Point(mesh.Origin(3 * p.Face + c))[k];
    }
  }
  return x;
}

double SphereGreens(double cosine)
{
  return -(std::log(1.0 - cosine) + 1.0 - std::log(2.0)) / (4.0 * dgg::Pi);
}

/// Of the flat torus with sides 1 at x + i y, mean zero, by the first theta function.
double TorusGreens(double x, double y)
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
double SquareGreens(const std::array<double, 3>& x, const double* y)
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
double DiskGreens(std::complex<double> x, std::complex<double> y)
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
      this->Largest = std::max(this->Largest, std::abs(value - expected));
    }
  }
  double Relative() const { return std::sqrt(this->Difference / this->Size); }

  double Difference = 0.0;
  double Size = 0.0;
  double Largest = 0.0;
};
}

TEST(GreensFunction, DiscreteIdentities)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const Id n = mesh.GetNumberOfVertices();
    for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
    {
      dgg::PoissonOptions options;
      options.Weights = weights;
      const Greens greens(mesh, options);
      Id count = 0;
      const std::vector<Id> components = mesh.ComputeComponents(count);
      Random random(4);
      std::vector<double> f(n);
      for (double& value : f)
      {
        value = random.Uniform(-1.0, 1.0);
      }
      std::vector<double> laplacian;
      ASSERT_TRUE(greens.Solver.Multiply(f, laplacian).IsOk());
      const std::vector<Id> poles = SomeVertices(mesh, 6, 3);
      std::vector<std::vector<double>> columns;
      for (const Id j : poles)
      {
        const auto g = greens.Run(dgg::SurfacePoint::AtVertex(j), dgg::GreensMethod::Vertex).Values;
        std::vector<double> product;
        ASSERT_TRUE(greens.Solver.Multiply(g, product).IsOk());
        double mean = 0.0;
        double meanOfF = 0.0;
        double sum = 0.0;
        for (Id v = 0; v < n; ++v)
        {
          const double weight = components[v] == components[j] ? greens.Solver.GetWeight(v) : 0.0;
          ASSERT_NEAR(product[v], (v == j ? 1.0 : 0.0) - weight, 1e-9) << named.Name;
          mean += weight * g[v];
          meanOfF += weight * f[v];
          sum += g[v] * laplacian[v];
          if (components[v] != components[j])
          {
            ASSERT_EQ(g[v], 0.0);
          }
        }
        EXPECT_NEAR(mean, 0.0, 1e-12) << named.Name;
        EXPECT_NEAR(meanOfF + sum, f[j], 1e-9) << named.Name;
        columns.push_back(g);
      }
      for (std::size_t a = 0; a < poles.size(); ++a)
      {
        for (std::size_t b = 0; b < a; ++b)
        {
          EXPECT_NEAR(columns[a][poles[b]], columns[b][poles[a]], 1e-10) << named.Name;
        }
      }
    }
  }
}

TEST(GreensFunction, SphereConverges)
{
  // Relative L2 error within 0.2 of the pole and everywhere, mean over random points in faces.
  double first = 0.0;
  double last = 0.0;
  double firstGlobal = 0.0;
  double lastGlobal = 0.0;
  for (const int level : { 3, 4, 5, 6 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    const int poles = 10;
    double local = 0.0;
    double global = 0.0;
    Random random(7);
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      std::array<double, 3> x = PositionOf(sphere, mesh, pole);
      const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      const dgg::GreensResult result = greens.Run(pole);
      EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      EXPECT_GT(result.Radius, 0.85);
      Comparison near;
      Comparison all;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double* y = sphere.Point(v);
        const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norm;
        const double area = greens.Solver.GetAreas()[v];
        all.Add(area, result.Values[v], SphereGreens(cosine));
        if (std::acos(cosine) < 0.2)
        {
          near.Add(area, result.Values[v], SphereGreens(cosine));
        }
      }
      local += near.Relative() / poles;
      global += all.Relative() / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(local));
    if (level == 3)
    {
      first = local;
      firstGlobal = global;
    }
    if (level == 5)
    {
      EXPECT_LT(local, 1e-4);
    }
    last = local;
    lastGlobal = global;
  }
  EXPECT_GT(std::log2(first / last) / 3.0, 1.8);
  EXPECT_GT(std::log2(firstGlobal / lastGlobal) / 3.0, 1.9);
}

TEST(GreensFunction, MethodsInTheirOrder)
{
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  double errors[4] = { 0.0, 0.0, 0.0, 0.0 };
  Random random(11);
  const int poles = 10;
  for (int k = 0; k < poles; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    const std::array<double, 3> x = PositionOf(sphere, mesh, pole);
    const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int m = 0; m < 4; ++m)
    {
      const dgg::GreensResult result = greens.Run(pole, Methods[m]);
      EXPECT_EQ(result.Method, Methods[m]);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      Comparison near;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double* y = sphere.Point(v);
        const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norm;
        if (std::acos(cosine) < 0.3)
        {
          near.Add(1.0, result.Values[v], SphereGreens(cosine));
        }
      }
      errors[m] += near.Relative() / poles;
    }
  }
  for (int m = 0; m < 4; ++m)
  {
    RecordProperty("method" + std::to_string(m), std::to_string(errors[m]));
  }
  EXPECT_LT(20.0 * errors[0], errors[2]);
  EXPECT_LT(errors[1], 1.5 * errors[2]);
  EXPECT_LT(errors[2], 0.5 * errors[3]);
}

TEST(GreensFunction, LocalizedReproducesDistances)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.1, 2));
  const Greens greens(mesh);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 77, { { 0.3, 0.25, 0.45 } });
  // The vertices around the pole: whole rings, 60 or more.
  std::vector<Id> near;
  std::vector<bool> isNear(mesh.GetNumberOfVertices(), false);
  for (int k = 0; k < 3; ++k)
  {
    near.push_back(mesh.Origin(3 * 77 + k));
    isNear[near.back()] = true;
  }
  while (near.size() < 60)
  {
    const std::vector<Id> before = near;
    for (const Id v : before)
    {
      for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
      {
        if (!isNear[mesh.Destination(*h)])
        {
          isNear[mesh.Destination(*h)] = true;
          near.push_back(mesh.Destination(*h));
        }
      }
    }
  }
  double misfits[2] = { 0.0, 0.0 };
  std::vector<double> values[2];
  for (const bool isLocalized : { false, true })
  {
    const auto method =
      isLocalized ? dgg::GreensMethod::Localized : dgg::GreensMethod::Interpolated;
    values[isLocalized] = greens.Run(pole, method).Values;
    std::vector<double> product;
    ASSERT_TRUE(greens.Solver.Multiply(values[isLocalized], product).IsOk());
    for (const Id s : near)
    {
      const auto d = DistancesFrom(mesh, dgg::ExactEngine::Triangle, s);
      const double expected =
        DistancesTo(mesh, dgg::ExactEngine::Triangle, dgg::SurfacePoint::AtVertex(s), { pole })[0];
      double sum = 0.0;
      for (const Id i : near)
      {
        sum += d[i] * (greens.Solver.GetWeight(i) + product[i]);
      }
      misfits[isLocalized] += (sum - expected) * (sum - expected);
    }
  }
  EXPECT_LT(std::sqrt(misfits[1]), 0.1 * std::sqrt(misfits[0]));
  // Nothing far away has changed but for the mean.
  const auto distances = DistancesTo(mesh, dgg::ExactEngine::Triangle, pole, [&] {
    std::vector<dgg::SurfacePoint> all;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      all.push_back(dgg::SurfacePoint::AtVertex(v));
    }
    return all;
  }());
  double shift = dgg::Infinity;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (distances[v] > 1.5)
    {
      const double change = values[1][v] - values[0][v];
      shift = shift < dgg::Infinity ? shift : change;
      EXPECT_NEAR(change, shift, 1e-12);
    }
  }
  EXPECT_LT(std::abs(shift), 1e-3);
  // At a vertex there is nothing to correct.
  EXPECT_EQ(greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Localized).Values,
    greens.Run(dgg::SurfacePoint::AtVertex(9), dgg::GreensMethod::Interpolated).Values);
}

TEST(GreensFunction, FlatTorus)
{
  double previous = 0.0;
  for (const Id n : { 32, 64, 128 })
  {
    const dgg::SurfaceMesh mesh = Build(FlatTorus(1.0, 0.0, 1.0, n, n, false));
    const Greens greens(mesh);
    const dgg::GreensResult result = greens.Run(dgg::SurfacePoint::AtVertex(0));
    EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
    Comparison all;
    for (Id v = 1; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double x = static_cast<double>(v % n) / n;
      const double y = static_cast<double>(v / n) / n;
      all.Add(greens.Solver.GetAreas()[v], result.Values[v], TorusGreens(x, y));
    }
    if (n > 32)
    {
      EXPECT_GT(std::log2(previous / all.Largest), 1.7) << n;
    }
    previous = all.Largest;
  }
  EXPECT_LT(previous, 1e-4);
}

TEST(GreensFunction, SquareWithNothingFlowingOut)
{
  // Second order with poles inside, at a corner and on the rim; first order within an edge of it.
  for (const bool delaunay : { false, true })
  {
    double previous[2] = { 0.0, 0.0 };
    for (const Id n : { 20, 40, 80 })
    {
      const TestMesh square = Scaled(Plane(n, n, 0.2), 1.0 / n);
      const dgg::SurfaceMesh mesh = Build(square);
      const Greens greens(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
      std::vector<dgg::SurfacePoint> poles[2];
      Random random(3);
      while (poles[0].size() < 6)
      {
        const dgg::SurfacePoint pole = InsideFace(mesh, random);
        const std::array<double, 3> x = PositionOf(square, mesh, pole);
        if (std::abs(x[0] - 0.5) < 0.3 && std::abs(x[1] - 0.5) < 0.3)
        {
          poles[0].push_back(pole);
        }
      }
      poles[0].push_back(dgg::SurfacePoint::AtVertex(0));
      poles[0].push_back(dgg::SurfacePoint::AtVertex(n / 2));
      poles[0].push_back(dgg::SurfacePoint::OnEdge(mesh, 3 * (n * n + n / 2) + 1, 0.4));
      poles[1].push_back(dgg::SurfacePoint::OnEdge(mesh, 0, 0.3));
      poles[1].push_back(dgg::SurfacePoint::InFace(mesh, n, { { 0.4, 0.3, 0.3 } }));
      for (int kind = 0; kind < 2; ++kind)
      {
        Comparison all;
        Comparison plain;
        for (const dgg::SurfacePoint& pole : poles[kind])
        {
          const std::array<double, 3> x = PositionOf(square, mesh, pole);
          dgg::GreensQuery query;
          query.Radius = 0.28; // the same on all meshes
          const dgg::GreensResult result = greens.Run(pole, query);
          EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
          const auto interpolated = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
          for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
          {
            const double area = greens.Solver.GetAreas()[v];
            const double expected = SquareGreens(x, square.Point(v));
            all.Add(area, result.Values[v], expected);
            plain.Add(area, interpolated[v], expected);
          }
        }
        if (n > 20)
        {
          EXPECT_GT(std::log2(previous[kind] / all.Relative()), kind == 0 ? 1.7 : 0.7)
            << n << " " << delaunay;
        }
        previous[kind] = all.Relative();
        EXPECT_LT(all.Relative(), (kind == 0 ? 0.15 : 1.5) * plain.Relative());
      }
    }
    EXPECT_LT(previous[0], 2e-4);
  }
}

TEST(GreensFunction, DiskWithZeroOnItsRim)
{
  double previous = 0.0;
  for (const Id n : { 12, 24, 48 })
  {
    std::vector<ConePoint> points;
    const dgg::SurfaceMesh mesh = Build(Cone(2.0 * dgg::Pi, 3 * n, n, points, 0.2));
    const auto placeOf = [&](Id v) { return std::polar(points[v].Radius, points[v].Angle); };
    const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
    Random random(5);
    Comparison all;
    for (int k = 0; k < 8; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      std::complex<double> x = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        x += pole.Barycentric[c] * placeOf(mesh.Origin(3 * pole.Face + c));
      }
      if (std::abs(x) > 0.8)
      {
        continue;
      }
      dgg::GreensQuery query;
      query.Radius = 0.5; // the same on all meshes
      const dgg::GreensResult result = greens.Run(pole, query);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (greens.Solver.IsFixed(v))
        {
          EXPECT_NEAR(result.Values[v], 0.0, 1e-12);
          continue;
        }
        all.Add(greens.Solver.GetAreas()[v], result.Values[v], DiskGreens(x, placeOf(v)));
      }
    }
    ASSERT_GT(all.Size, 0.0);
    if (n > 12)
    {
      EXPECT_GT(std::log2(previous / all.Relative()), 1.6) << n;
    }
    previous = all.Relative();
  }
  EXPECT_LT(previous, 3e-3);
}

TEST(GreensFunction, ConesByTheirTotalAngle)
{
  // Apex at the pole, 0 on the rim: -log(r) / Theta, whether the apex is sharp or a saddle.
  for (const double total : { 2.0, 4.5, 2.0 * dgg::Pi, 9.0 })
  {
    std::vector<ConePoint> points;
    const dgg::SurfaceMesh mesh = Build(Cone(total, 24, 24, points));
    const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
    const dgg::GreensResult result = greens.Run(dgg::SurfacePoint::AtVertex(0));
    EXPECT_EQ(result.Remark, dgg::GreensRemark::None) << total;
    for (Id v = 1; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_NEAR(result.Values[v], -std::log(points[v].Radius) / total, 3e-3) << total << " " << v;
    }
    // Interpolated is far off next to the pole.
    const auto plain = greens.Run(dgg::SurfacePoint::AtVertex(0), dgg::GreensMethod::Vertex).Values;
    EXPECT_GT(std::abs(plain[1] + std::log(points[1].Radius) / total), 5e-3) << total;
  }
}

TEST(GreensFunction, AnyPointSeesAnyOther)
{
  // Both arguments anywhere: the truth, and symmetry.
  const TestMesh sphere = Icosphere(5);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  Random random(9);
  std::vector<dgg::SurfacePoint> points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  // Two in the same face, and one on an edge of it.
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.6, 0.2, 0.2 } }));
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.2, 0.2, 0.6 } }));
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 15, 0.3));
  points.push_back(dgg::SurfacePoint::AtVertex(40));
  dgg::GreensQuery query;
  query.Targets = points;
  std::vector<dgg::GreensResult> results;
  ASSERT_TRUE(greens.Function.Run(points, query, nullptr, results).IsOk());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::array<double, 3> x = PositionOf(sphere, mesh, points[i]);
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (i == j)
      {
        EXPECT_TRUE(std::isfinite(results[i].TargetValues[j]));
        EXPECT_GT(results[i].TargetValues[j], 0.5);
        continue;
      }
      const std::array<double, 3> y = PositionOf(sphere, mesh, points[j]);
      double chord = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        chord += (x[k] - y[k]) * (x[k] - y[k]);
      }
      // In terms of the chord, as the points are a little inside of the sphere.
      EXPECT_NEAR(results[i].TargetValues[j], SphereGreens(1.0 - 0.5 * chord), 2e-3)
        << i << " " << j;
      EXPECT_NEAR(results[i].TargetValues[j], results[j].TargetValues[i], 3e-4) << i << " " << j;
    }
  }
  // One at a time it is the same.
  for (const std::size_t i : { std::size_t(0), std::size_t(9) })
  {
    const dgg::GreensResult one = greens.Run(points[i], query);
    ExpectSameField(one.Values, results[i].Values, 1e-12, "block");
    ExpectSameField(one.TargetValues, results[i].TargetValues, 1e-12, "block");
  }
}

TEST(GreensFunction, SolvesPoissonEquations)
{
  // u = mean(u) + sum of integrals of g against f, at vertices with the sparse solve and anywhere
  // with the truth.
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  const Id n = mesh.GetNumberOfVertices();
  const auto harmonic = [](const double* p) { return p[0] * p[1] - 0.5 * p[1] * p[2]; }; // l = 2
  std::vector<double> density(n);
  std::vector<double> u(n);
  for (Id v = 0; v < n; ++v)
  {
    density[v] = 6.0 * harmonic(sphere.Point(v));
    u[v] = density[v] * greens.Solver.GetAreas()[v];
  }
  ASSERT_TRUE(greens.Solver.Solve(u).IsOk());
  dgg::GreensQuery query;
  query.WantIntegrals = true;
  const auto at = [&](const dgg::SurfacePoint& pole, dgg::GreensMethod method) {
    query.Method = method;
    const dgg::GreensResult result = greens.Run(pole, query);
    double sum = 0.0;
    double total = 0.0;
    for (Id v = 0; v < n; ++v)
    {
      sum += result.Integrals[v] * density[v];
      total += result.Integrals[v];
    }
    EXPECT_NEAR(total, 0.0, 1e-12);
    return sum;
  };
  for (const Id v : SomeVertices(mesh, 6, 4))
  {
    EXPECT_NEAR(at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::Vertex), u[v], 1e-9);
    EXPECT_NEAR(
      at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::SingularitySubtraction), u[v], 2e-3);
  }
  Random random(8);
  for (int k = 0; k < 6; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    std::array<double, 3> x = PositionOf(sphere, mesh, pole);
    EXPECT_NEAR(at(pole, dgg::GreensMethod::SingularitySubtraction), harmonic(x.data()), 4e-3);
  }
}

TEST(GreensFunction, SolvesPoissonEquationsWithGivenValues)
{
  // u_j = sum of g b inside - sum of given values times the flux of g there.
  const dgg::SurfaceMesh mesh = Build(Plane(14, 11, 0.25));
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  const Id n = mesh.GetNumberOfVertices();
  Random random(6);
  std::vector<double> values(n);
  for (double& value : values)
  {
    value = random.Uniform(-1.0, 1.0);
  }
  std::vector<double> u = values;
  ASSERT_TRUE(greens.Solver.Solve(u).IsOk());
  for (Id j = 0; j < n; ++j)
  {
    if (greens.Solver.IsFixed(j))
    {
      continue;
    }
    const auto g = greens.Run(dgg::SurfacePoint::AtVertex(j), dgg::GreensMethod::Vertex).Values;
    std::vector<double> flux;
    ASSERT_TRUE(greens.Solver.Multiply(g, flux).IsOk());
    double sum = 0.0;
    for (Id v = 0; v < n; ++v)
    {
      sum += greens.Solver.IsFixed(v) ? -values[v] * flux[v] : values[v] * g[v];
    }
    EXPECT_NEAR(sum, u[j], 1e-10) << j;
  }
}

TEST(GreensFunction, ValueAtThePoleAndSigns)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  const Greens greens(mesh);
  dgg::GreensQuery query;
  query.Targets = { dgg::SurfacePoint::AtVertex(3) };
  const dgg::GreensResult average = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_TRUE(std::isfinite(average.Values[3]));
  EXPECT_EQ(average.TargetValues[0], average.Values[3]);
  // The mean over a disk of a logarithm is that half a unit inside.
  const double radius = std::sqrt(2.0 * greens.Solver.GetAreas()[3] / mesh.TotalAngle(3));
  EXPECT_NEAR(average.Values[3], SphereGreens(std::cos(radius)) + 0.5 / mesh.TotalAngle(3), 0.01);
  query.Sign = dgg::GreensSign::Negative;
  const dgg::GreensResult negative = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  for (std::size_t v = 0; v < negative.Values.size(); ++v)
  {
    EXPECT_EQ(negative.Values[v], -average.Values[v]);
  }
  query.Pole = dgg::GreensPole::Infinite;
  const dgg::GreensResult infinite = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_EQ(infinite.Values[3], -dgg::Infinity);
  EXPECT_EQ(infinite.TargetValues[0], -dgg::Infinity);
  EXPECT_EQ(infinite.Values[4], negative.Values[4]);
}

TEST(GreensFunction, UniformWeights)
{
  // On a mesh that is finer on one side: what is taken off, and the mean, go by vertices.
  TestMesh plane = Plane(30, 30);
  for (std::size_t k = 0; k < plane.Points.size(); k += 3)
  {
    plane.Points[k] = plane.Points[k] * (1.0 + plane.Points[k] / 60.0);
  }
  const dgg::SurfaceMesh mesh = Build(plane);
  dgg::PoissonOptions options;
  options.Weights = dgg::PoissonWeights::Uniform;
  const Greens greens(mesh, options);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 930, { { 0.2, 0.3, 0.5 } });
  std::vector<double> values[2];
  for (const bool isSubtracted : { false, true })
  {
    dgg::GreensQuery query;
    query.Method =
      isSubtracted ? dgg::GreensMethod::SingularitySubtraction : dgg::GreensMethod::Interpolated;
    query.WantIntegrals = true;
    const dgg::GreensResult result = greens.Run(pole, query);
    EXPECT_EQ(result.Method, query.Method);
    double mean = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_DOUBLE_EQ(greens.Solver.GetWeight(v), 1.0 / 961.0);
      mean += result.Integrals[v] / greens.Solver.GetAreas()[v] / 961.0;
    }
    EXPECT_NEAR(mean, 0.0, 1e-12);
    values[isSubtracted] = result.Values;
  }
  // Away from the pole both methods agree.
  const auto distances = DistancesTo(mesh, dgg::ExactEngine::Triangle, pole, [&] {
    std::vector<dgg::SurfacePoint> all;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      all.push_back(dgg::SurfacePoint::AtVertex(v));
    }
    return all;
  }());
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (distances[v] > 8.0)
    {
      EXPECT_NEAR(values[0][v], values[1][v], 3e-3) << v;
    }
  }
}

TEST(GreensFunction, RidgesNearThePole)
{
  // Behind the corners of a cube shortest ways meet from two sides. The truth is from a finer mesh.
  const TestMesh cube = Cube(10);
  const TestMesh fineCube = Subdivided(cube, 4);
  const dgg::SurfaceMesh mesh = Build(cube);
  const dgg::SurfaceMesh fine = Build(fineCube);
  const Greens greens(mesh);
  const Greens onFine(fine);
  Random random(3);
  int remarks = 0;
  for (int k = 0; k < 8; ++k)
  {
    const Id face = random.Index(mesh.GetNumberOfFaces());
    const std::array<double, 3> b{ { 0.25, 0.25, 0.5 } };
    const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, face, b);
    const std::array<double, 3> x = PositionOf(cube, mesh, pole);
    dgg::GreensQuery query;
    query.Radius = 0.3;
    const auto truth =
      onFine.Run(dgg::SurfacePoint::AtVertex(VertexAt(fineCube, x[0], x[1], x[2])), query).Values;
    const dgg::GreensResult result = greens.Run(pole);
    remarks += result.Remark == dgg::GreensRemark::NearRidge ? 1 : 0;
    EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
    const auto simple = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
    Comparison good;
    Comparison plain;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      good.Add(greens.Solver.GetAreas()[v], result.Values[v], truth[v]);
      plain.Add(greens.Solver.GetAreas()[v], simple[v], truth[v]);
    }
    EXPECT_LT(good.Relative(), 5e-3) << k;
    EXPECT_LT(good.Relative(), 0.3 * plain.Relative()) << k;
  }
  EXPECT_GT(remarks, 0);
}

TEST(GreensFunction, ThreadsChangeNothing)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.1, 5));
  const Greens greens(mesh);
  const std::vector<dgg::SurfacePoint> poles = RandomSurfacePoints(mesh, 35, 6);
  const dgg::ParallelFor threads = [](dgg::Offset size, dgg::Offset,
                                     const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    std::vector<std::thread> workers;
    for (dgg::Offset k = 0; k < size; ++k)
    {
      workers.emplace_back([&body, k] { body(k, k + 1); });
    }
    for (std::thread& worker : workers)
    {
      worker.join();
    }
  };
  std::vector<dgg::GreensResult> one;
  std::vector<dgg::GreensResult> many;
  ASSERT_TRUE(greens.Function.Run(poles, {}, nullptr, one).IsOk());
  ASSERT_TRUE(greens.Function.Run(poles, {}, threads, many).IsOk());
  for (std::size_t k = 0; k < poles.size(); ++k)
  {
    EXPECT_EQ(one[k].Values, many[k].Values);
  }
}

TEST(GreensInterpolation, IsCloseToASolvePerPoint)
{
  double previous = 0.0;
  for (const int level : { 3, 4, 5 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    dgg::GreensInterpolation interpolation(greens.Solver);
    double error = 0.0;
    double plain = 0.0;
    Random random(21);
    const int poles = 8;
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      const std::array<double, 3> x = PositionOf(sphere, mesh, pole);
      const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      dgg::GreensResult result;
      dgg::GreensQuery query;
      query.Targets = { dgg::SurfacePoint::AtVertex(4) };
      ASSERT_TRUE(interpolation.Run(pole, query, result).IsOk());
      EXPECT_EQ(result.TargetValues[0], result.Values[4]);
      const auto simple = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
      Comparison near;
      Comparison nearSimple;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double* y = sphere.Point(v);
        const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norm;
        if (std::acos(cosine) < 0.2)
        {
          near.Add(greens.Solver.GetAreas()[v], result.Values[v], SphereGreens(cosine));
          nearSimple.Add(greens.Solver.GetAreas()[v], simple[v], SphereGreens(cosine));
        }
      }
      error += near.Relative() / poles;
      plain += nearSimple.Relative() / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(error));
    EXPECT_LT(error, plain / 8.0) << level;
    if (level > 3)
    {
      EXPECT_GT(std::log2(previous / error), 1.5) << level;
    }
    previous = error;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST(GreensInterpolation, KeepsColumns)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  const Greens greens(mesh);
  const dgg::SurfacePoint inside = dgg::SurfacePoint::InFace(mesh, 8, { { 0.2, 0.3, 0.5 } });
  const dgg::SurfacePoint beside = dgg::SurfacePoint::InFace(mesh, 8, { { 0.6, 0.3, 0.1 } });
  const dgg::SurfacePoint away = dgg::SurfacePoint::InFace(mesh, 900, { { 0.6, 0.3, 0.1 } });
  dgg::GreensInterpolation interpolation(greens.Solver);
  dgg::GreensResult result;
  const auto columnsAfter = [&](dgg::GreensInterpolation& any, const dgg::SurfacePoint& pole) {
    EXPECT_TRUE(any.Run(pole, {}, result).IsOk());
    return any.GetNumberOfColumns();
  };
  EXPECT_EQ(columnsAfter(interpolation, inside), 3);
  const std::vector<double> first = result.Values;
  EXPECT_EQ(columnsAfter(interpolation, beside), 3);
  EXPECT_EQ(columnsAfter(interpolation, away), 6);
  EXPECT_EQ(columnsAfter(interpolation, inside), 6);
  EXPECT_EQ(result.Values, first);
  EXPECT_EQ(interpolation.GetMemorySize(), 6u * 642u * sizeof(float));
  // At a vertex it is the column itself, to the precision of floats.
  EXPECT_EQ(columnsAfter(interpolation, dgg::SurfacePoint::AtVertex(mesh.Origin(24))), 6);
  dgg::GreensQuery query;
  query.Radius = result.Radius;
  ExpectSameField(greens.Run(dgg::SurfacePoint::AtVertex(mesh.Origin(24)), query).Values,
    result.Values, 1e-6, "vertex");
  // Little memory: columns come and go, results are the same.
  dgg::GreensInterpolation small(greens.Solver, 1);
  EXPECT_EQ(columnsAfter(small, inside), 3);
  EXPECT_EQ(columnsAfter(small, away), 6);
  EXPECT_EQ(columnsAfter(small, inside), 9);
  EXPECT_EQ(result.Values, first);
  EXPECT_LE(small.GetMemorySize(), 3u * 642u * sizeof(float));
  // Where columns will not do, it is the Green's function.
  const dgg::SurfaceMesh coarse = Build(Icosahedron());
  const Greens onCoarse(coarse);
  dgg::GreensInterpolation other(onCoarse.Solver);
  EXPECT_TRUE(
    other.Run(dgg::SurfacePoint::InFace(coarse, 1, { { 0.2, 0.3, 0.5 } }), {}, result).IsOk());
  EXPECT_EQ(result.Remark, dgg::GreensRemark::TooCoarse);
  EXPECT_FALSE(other.Run(dgg::SurfacePoint::AtVertex(99), {}, result).IsOk());
}

TEST(GreensFunction, FlippedMeshes)
{
  // Obtuse triangles: with flips the result is better, and the pole is found among them.
  // The domain is a square, the triangles are five times as wide as high.
  TestMesh fine = Plane(20, 100, 0.28, 6);
  for (std::size_t k = 0; k < fine.Points.size(); k += 3)
  {
    fine.Points[k] /= 20.0;
    fine.Points[k + 1] /= 100.0;
  }
  const dgg::SurfaceMesh mesh = Build(fine);
  double errors[2] = { 0.0, 0.0 };
  for (const bool delaunay : { false, true })
  {
    const Greens greens(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
    Random random(13);
    Comparison all;
    for (int k = 0; k < 30; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      const std::array<double, 3> x = PositionOf(fine, mesh, pole);
      if (std::abs(x[0] - 0.5) > 0.25 || std::abs(x[1] - 0.5) > 0.25)
      {
        continue;
      }
      const dgg::GreensResult result = greens.Run(pole);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        all.Add(greens.Solver.GetAreas()[v], result.Values[v], SquareGreens(x, fine.Point(v)));
      }
    }
    errors[delaunay] = all.Relative();
  }
  RecordProperty("direct", std::to_string(errors[0]));
  RecordProperty("flipped", std::to_string(errors[1]));
  EXPECT_LT(errors[0], 2e-2);
  EXPECT_LT(errors[1], 0.2 * errors[0]);
}

TEST(GreensFunction, CoarseMeshesSaySo)
{
  const dgg::SurfaceMesh mesh = Build(Icosahedron());
  const Greens greens(mesh);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 3, { { 0.2, 0.3, 0.5 } });
  const dgg::GreensResult result = greens.Run(pole);
  EXPECT_EQ(result.Remark, dgg::GreensRemark::TooCoarse);
  EXPECT_EQ(result.Method, dgg::GreensMethod::Interpolated);
  EXPECT_EQ(result.Radius, 0.0);
  EXPECT_EQ(result.Values, greens.Run(pole, dgg::GreensMethod::Interpolated).Values);
  // A boundary with given values too close for the localized scheme.
  const dgg::SurfaceMesh plane = Build(Plane(4, 4));
  const Greens given(plane, With(dgg::PoissonBoundary::Dirichlet));
  EXPECT_EQ(given
              .Run(dgg::SurfacePoint::InFace(plane, 12, { { 0.2, 0.3, 0.5 } }),
                dgg::GreensMethod::Localized)
              .Remark,
    dgg::GreensRemark::NotLocalized);
}

TEST(GreensFunction, AnyTriangles)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    Random random(seed);
    meshes.push_back({ "soup " + std::to_string(seed),
      RandomSoup(3 + random.Index(20), 1 + random.Index(50), seed) });
  }
  for (const NamedMesh& named : meshes)
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      const Greens greens(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
      for (const dgg::SurfacePoint& pole : RandomSurfacePoints(mesh, 3, 2))
      {
        if (!greens.Solver.CheckPole(pole).IsOk())
        {
          continue;
        }
        for (const dgg::GreensMethod method : Methods)
        {
          dgg::GreensQuery query;
          query.Method = method;
          query.Targets = RandomSurfacePoints(mesh, 4, 9);
          query.Targets.push_back(pole);
          query.WantIntegrals = true;
          query.Radius =
            method == dgg::GreensMethod::SingularitySubtraction && delaunay ? 0.0 : 3.0;
          const dgg::GreensResult result = greens.Run(pole, query);
          double largest = 1.0;
          for (const double value : result.Values)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            largest = std::max(largest, std::abs(value));
          }
          for (const double value : result.TargetValues)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
          }
          double sum = 0.0;
          double size = 0.0;
          for (const double value : result.Integrals)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            sum += value;
            size += std::abs(value);
          }
          EXPECT_NEAR(sum, 0.0, 1e-6 * size + 1e-9) << named.Name;
        }
      }
    }
  }
}

TEST(GreensFunction, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(SphereWithIsolatedPoints(2));
  const Greens greens(mesh);
  dgg::GreensResult result;
  const auto message = [&](const Greens& any, const dgg::SurfacePoint& pole,
                         const dgg::GreensQuery& query = {}) {
    const dgg::Status status = any.Function.Run(pole, query, result);
    EXPECT_FALSE(status.IsOk());
    EXPECT_TRUE(result.Values.empty());
    return status.GetMessage();
  };
  EXPECT_NE(message(greens, dgg::SurfacePoint::AtVertex(0)).find("has no face"), std::string::npos);
  EXPECT_FALSE(message(greens, dgg::SurfacePoint::AtVertex(100000)).empty());
  dgg::GreensQuery query;
  query.Radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(message(greens, dgg::SurfacePoint::AtVertex(5), query).empty());
  query = {};
  query.Targets = { dgg::SurfacePoint::AtVertex(-3) };
  EXPECT_NE(
    message(greens, dgg::SurfacePoint::AtVertex(5), query).find("target 0"), std::string::npos);
  const Greens given(mesh, With(dgg::PoissonBoundary::Dirichlet));
  EXPECT_NE(
    message(given, dgg::SurfacePoint::AtVertex(5)).find("without a boundary"), std::string::npos);
  const dgg::SurfaceMesh plane = Build(Plane(6, 6));
  const Greens onPlane(plane, With(dgg::PoissonBoundary::Dirichlet));
  EXPECT_NE(message(onPlane, dgg::SurfacePoint::AtVertex(0)).find("boundary"), std::string::npos);
  dgg::PoissonSolver raw(plane);
  EXPECT_NE(dgg::GreensFunction(raw)
              .Run(dgg::SurfacePoint::AtVertex(0), {}, result)
              .GetMessage()
              .find("Prepare()"),
    std::string::npos);
  std::vector<dgg::GreensResult> results;
  EXPECT_NE(onPlane.Function
              .Run({ dgg::SurfacePoint::AtVertex(10), dgg::SurfacePoint::AtVertex(0) }, {}, nullptr,
                results)
              .GetMessage()
              .find("pole 1"),
    std::string::npos);
  query = {};
  query.Progress = [](double) { return false; };
  EXPECT_TRUE(
    greens.Function.Run({ dgg::SurfacePoint::AtVertex(10) }, query, nullptr, results).IsAborted());
}
}
