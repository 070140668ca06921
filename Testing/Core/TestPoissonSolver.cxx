// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Poisson equations on surfaces: closed forms, boundary conditions, any triangles; sparse
// factorizations.
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggSparseFactor.h"
#include "dggSplineCells.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

namespace dggtest
{
namespace
{
/// A prepared solver.
class Poisson
{
public:
  explicit Poisson(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
    : Solver(mesh)
  {
    EXPECT_TRUE(Ok(this->Solver.Prepare(options, nullptr)));
  }

  std::vector<double> Solve(std::vector<double> values) const
  {
    EXPECT_TRUE(Ok(this->Solver.Solve(values)));
    return values;
  }
  std::vector<double> Multiply(const std::vector<double>& f) const
  {
    return this->Solver.GetSystem().Multiply(f);
  }

  dgg::PoissonSolver Solver;
};

/// Returns the weighted means of a function, one per component.
std::vector<double> Means(const dgg::PoissonSolver& solver, const std::vector<double>& f)
{
  Id count = 0;
  const std::vector<Id> components = solver.GetMesh().ComputeComponents(count);
  std::vector<double> means(count, 0.0);
  for (std::size_t v = 0; v < f.size(); ++v)
  {
    means[components[v]] += solver.GetWeight(static_cast<Id>(v)) * f[v];
  }
  return means;
}

/// Expects the solver to reproduce f from its sources, up to the mean in components without
/// prescribed values.
void ExpectInverse(const Poisson& poisson, double tolerance, const std::string& what)
{
  const dgg::SurfaceMesh& mesh = poisson.Solver.GetMesh();
  const std::vector<double> f = RandomValues(mesh.GetNumberOfVertices(), 3);
  std::vector<double> sources = poisson.Multiply(f);
  std::vector<double> means = Means(poisson.Solver, f);
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (poisson.Solver.IsFixed(v))
    {
      sources[v] = f[v];
      means[components[v]] = 0.0;
    }
  }
  const std::vector<double> solution = poisson.Solve(sources);
  for (std::size_t v = 0; v < f.size(); ++v)
  {
    ASSERT_NEAR(solution[v], f[v] - means[components[v]], tolerance) << what << ", vertex " << v;
  }
}

/// Returns the root mean square of a difference over the area.
double Error(const dgg::PoissonSolver& solver, const std::vector<double>& u,
  const std::function<double(Id)>& expected)
{
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t v = 0; v < u.size(); ++v)
  {
    const double difference = u[v] - expected(static_cast<Id>(v));
    sum += solver.GetAreas()[v] * difference * difference;
    area += solver.GetAreas()[v];
  }
  return std::sqrt(sum / area);
}
}

TEST(PoissonSolver, UnbalancedSourcesAreBalanced)
{
  // A unit source at one vertex of the sphere; no sources on the torus and the plane beside it.
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
  {
    dgg::PoissonOptions options;
    options.Weights = weights;
    const Poisson poisson(mesh, options);
    std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
    sources[5] = 1.0;
    const std::vector<double> solution = poisson.Solve(sources);
    const std::vector<double> product = poisson.Multiply(solution);
    Id count = 0;
    const std::vector<Id> components = mesh.ComputeComponents(count);
    ASSERT_EQ(count, 3);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (components[v] != components[5])
      {
        EXPECT_EQ(solution[v], 0.0);
        continue;
      }
      EXPECT_NEAR(product[v], (v == 5 ? 1.0 : 0.0) - poisson.Solver.GetWeight(v), 1e-12);
    }
    for (const double mean : Means(poisson.Solver, solution))
    {
      EXPECT_NEAR(mean, 0.0, 1e-14);
    }
  }
}

TEST(PoissonSolver, InvertsTheLaplacian)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const dgg::PoissonOptions& options : AllPoissonOptions())
    {
      ExpectInverse(Poisson(mesh, options), 1e-9, named.Name);
    }
  }
}

/// Returns the largest residual of a solution for a unit source at a vertex of a connected mesh
/// without prescribed values.
double ResidualOf(const Poisson& poisson, Id vertex, const std::vector<double>& solution)
{
  const std::vector<double> product = poisson.Multiply(solution);
  double largest = 0.0;
  for (std::size_t v = 0; v < product.size(); ++v)
  {
    const Id id = static_cast<Id>(v);
    const double source = (id == vertex ? 1.0 : 0.0) - poisson.Solver.GetWeight(id);
    largest = std::max(largest, std::abs(product[v] - source));
  }
  return largest;
}

TEST(PoissonSolver, SolutionsAmongNeedlesAreRefined)
{
  // A single substitution leaves residuals up to 5e-9, and so do substitutions of several systems
  // together.
  const dgg::SurfaceMesh mesh = Build(NeedlePlane(12, 1e-6));
  const Poisson poisson(mesh);
  const Id n = mesh.GetNumberOfVertices();
  constexpr Id Lanes = dgg::SparseLanes::SizeAtCompileTime;
  double single = 0.0;
  double together = 0.0;
  for (Id first = 0; first + Lanes <= n; first += Lanes)
  {
    std::vector<std::vector<double>> columns;
    for (Id k = 0; k < Lanes; ++k)
    {
      std::vector<double> load(n, 0.0);
      load[first + k] = 1.0;
      columns.push_back(load);
      single = std::max(single, ResidualOf(poisson, first + k, poisson.Solve(load)));
    }
    ASSERT_TRUE(poisson.Solver.Solve(columns).IsOk());
    for (Id k = 0; k < Lanes; ++k)
    {
      together = std::max(together, ResidualOf(poisson, first + k, columns[k]));
    }
  }
  EXPECT_LT(single, 2e-9);
  EXPECT_LT(together, 2e-9);
}

TEST(PoissonSolver, NeumannSquareConverges)
{
  Convergence errors(1.8);
  for (const Id n : { 8, 16, 32, 64 })
  {
    const TestMesh plane = Scaled(Plane(n, n, 0.2), 1.0 / n);
    const dgg::SurfaceMesh mesh = Build(plane);
    const Poisson poisson(mesh);
    const auto mode = [&](Id v) {
      return std::cos(dgg::Pi * plane.Point(v)[0]) * std::cos(dgg::Pi * plane.Point(v)[1]);
    };
    std::vector<double> sources(mesh.GetNumberOfVertices());
    for (std::size_t v = 0; v < sources.size(); ++v)
    {
      sources[v] =
        2.0 * dgg::Pi * dgg::Pi * mode(static_cast<Id>(v)) * poisson.Solver.GetAreas()[v];
    }
    errors.Add(Error(poisson.Solver, poisson.Solve(sources), mode));
  }
  EXPECT_LT(errors.Last, 1e-3);
}

TEST(PoissonSolver, GivenValuesOfLinearFunctionsAreContinuedLinearly)
{
  // Prescribe values on the whole boundary; then only on the sides x = 0 and x = 7, in any order
  // and with duplicates. The other sides have zero flux.
  const TestMesh plane = Plane(7, 5, 0.25);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id n = mesh.GetNumberOfVertices();
  std::vector<Id> sides;
  for (Id v = n - 1; v >= 0; --v)
  {
    const double x = plane.Point(v)[0];
    if (x == 0.0 || x == 7.0)
    {
      sides.push_back(v);
    }
  }
  sides.push_back(sides.front());
  for (dgg::PoissonOptions options : AllPoissonOptions())
  {
    const bool isWholeBoundary = options.Boundary == dgg::PoissonBoundary::Dirichlet;
    options.DirichletVertices = isWholeBoundary ? std::vector<Id>() : sides;
    const Poisson poisson(mesh, options);
    const auto linear = [&](Id v) {
      return 3.0 - 2.0 * plane.Point(v)[0] + (isWholeBoundary ? plane.Point(v)[1] : 0.0);
    };
    std::vector<double> values(n, 0.0);
    Id fixed = 0;
    for (Id v = 0; v < n; ++v)
    {
      values[v] = poisson.Solver.IsFixed(v) ? linear(v) : 0.0;
      fixed += poisson.Solver.IsFixed(v) ? 1 : 0;
    }
    EXPECT_EQ(fixed, isWholeBoundary ? 2 * (7 + 5) : 2 * 6);
    const std::vector<double> solution = poisson.Solve(values);
    for (Id v = 0; v < n; ++v)
    {
      EXPECT_NEAR(solution[v], linear(v), 1e-10) << v;
    }
    ExpectInverse(poisson, 1e-10, "plane");
  }
}

TEST(PoissonSolver, OneGivenValueTakesInWhatFlows)
{
  // On a closed surface, sources that do not sum to 0 flow out at the vertex with a prescribed
  // value. The other component has no prescribed value and is balanced.
  TestMesh two = Icosphere(2);
  const Id n = two.GetNumberOfVertices();
  Append(two, Translated(Icosphere(1), 5.0, 0.0, 0.0));
  const dgg::SurfaceMesh mesh = Build(two);
  dgg::PoissonOptions options;
  options.DirichletVertices = { 5 };
  const Poisson poisson(mesh, options);
  ExpectInverse(poisson, 1e-10, "two spheres");
  std::vector<double> values(mesh.GetNumberOfVertices(), 0.25);
  values[5] = 7.0;
  const std::vector<double> flow = poisson.Multiply(poisson.Solve(values));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double expected = v == 5 ? -0.25 * (n - 1) : v < n ? 0.25 : flow[v];
    EXPECT_NEAR(flow[v], expected, 1e-10) << v;
  }
  EXPECT_EQ(poisson.Solve(values)[5], 7.0);
}

TEST(PoissonSolver, ChannelsAreSolvedForAsSingleOnesAre)
{
  const dgg::SurfaceMesh mesh = Build(Plane(6, 5, 0.2));
  dgg::PoissonOptions options;
  options.DirichletVertices = { 3, 8 };
  const Poisson poisson(mesh, options);
  for (const std::size_t count : { 0, 1, 3, 8, 13 })
  {
    std::vector<std::vector<double>> columns;
    for (std::size_t k = 0; k < count; ++k)
    {
      columns.push_back(RandomValues(mesh.GetNumberOfVertices(), 20 + k));
    }
    const std::vector<std::vector<double>> sources = columns;
    ASSERT_TRUE(poisson.Solver.Solve(columns).IsOk());
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::vector<double> expected = poisson.Solve(sources[k]);
      for (std::size_t v = 0; v < expected.size(); ++v)
      {
        ASSERT_NEAR(columns[k][v], expected[v], 1e-12) << count << ", column " << k;
      }
    }
  }
  std::vector<std::vector<double>> wrong(2, RandomValues(mesh.GetNumberOfVertices(), 3));
  wrong[1][2] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> untouched = wrong[0];
  EXPECT_FALSE(poisson.Solver.Solve(wrong).IsOk());
  EXPECT_EQ(wrong[0], untouched);
}

TEST(PoissonSolver, AnyTrianglesGiveNumbers)
{
  int thin = 0;
  for (const NamedMesh& named : DefectMeshesAndSoups(100))
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const dgg::PoissonOptions& options : AllPoissonOptions())
    {
      const std::string what = named.Name + (options.IntrinsicDelaunay ? ", flipped" : "");
      if (IsThinSoup(mesh, named.Name, options))
      {
        ++thin;
        continue;
      }
      const Poisson poisson(mesh, options);
      // Nearly degenerate faces are stiff in one direction and soft in the other one: condition
      // numbers reach 1e12.
      ExpectInverse(poisson, 1e-3, what);
      // Sources are reproduced as well.
      const auto withoutFixed = [&](std::vector<double> values) {
        for (std::size_t v = 0; v < values.size(); ++v)
        {
          values[v] = poisson.Solver.IsFixed(static_cast<Id>(v)) ? 0.0 : values[v];
        }
        return values;
      };
      const std::vector<double> solution =
        poisson.Solve(withoutFixed(RandomValues(mesh.GetNumberOfVertices(), 9)));
      const std::vector<double> again = poisson.Solve(withoutFixed(poisson.Multiply(solution)));
      double largest = 0.0;
      for (const double value : solution)
      {
        ASSERT_TRUE(std::isfinite(value)) << what;
        largest = std::max(largest, std::abs(value));
      }
      for (std::size_t v = 0; v < solution.size(); ++v)
      {
        ASSERT_NEAR(again[v], solution[v], 1e-3 * std::max(1.0, largest)) << what << " " << v;
      }
    }
  }
  EXPECT_LT(thin, 40); // of 400 cases
}

TEST(PoissonSolver, DelaunayKeepsTheMaximumPrinciple)
{
  // Obtuse triangles: without flips, a source creates values below the boundary values.
  TestMesh squeezed = Plane(20, 20, 0.29, 4);
  for (std::size_t k = 0; k < squeezed.Points.size(); k += 3)
  {
    squeezed.Points[k] *= 6.0;
  }
  const dgg::SurfaceMesh mesh = Build(squeezed);
  double least[2] = { 0.0, 0.0 };
  for (const bool delaunay : { false, true })
  {
    const Poisson poisson(mesh, With(dgg::PoissonBoundary::Dirichlet, delaunay));
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (poisson.Solver.IsFixed(v))
      {
        continue;
      }
      std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
      sources[v] = 1.0;
      for (const double value : poisson.Solve(sources))
      {
        least[delaunay] = std::min(least[delaunay], value);
      }
    }
  }
  EXPECT_LT(least[0], -1e-6);
  EXPECT_GE(least[1], -1e-12);
}

namespace
{
using dgg::Id;
using dgg::SurfaceMesh;
using Matrix = Eigen::SparseMatrix<double>;

/// Returns the Laplacian of disjoint pairs of vertices. Half of the pivots are 0.
Matrix Pairs(int n)
{
  Matrix laplacian(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; i += 2)
  {
    entries.emplace_back(i, i, 1.0);
    entries.emplace_back(i + 1, i + 1, 1.0);
    entries.emplace_back(i, i + 1, -1.0);
    entries.emplace_back(i + 1, i, -1.0);
  }
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

TEST(SparseFactor, SingularMatricesAreRaised)
{
  constexpr int Size = 32;
  const Matrix pairs = Pairs(Size);
  const dgg::EliminationOrder order(pairs);
  EXPECT_EQ(order.GetNumberOfFactorEntries(), Size / 2);
  dgg::SparseFactor factor;
  ASSERT_TRUE(factor.Compute(order, pairs).IsOk());
  EXPECT_TRUE(factor.IsRaised());
  // Flow into one vertex of a pair and out of the other one.
  std::vector<double> values(Size);
  for (int i = 0; i < Size; ++i)
  {
    values[i] = i % 2 == 0 ? 1.0 : -1.0;
  }
  factor.Solve(values);
  for (int i = 0; i < Size; i += 2)
  {
    EXPECT_NEAR(values[i] - values[i + 1], 1.0, 1e-5) << i;
  }
}

TEST(SparseFactor, KnownValuesStayAndAreOfNoConcernToOthers)
{
  constexpr int Size = 8;
  const Matrix pairs = Pairs(Size);
  std::vector<std::uint8_t> isKnown(Size, 0);
  std::vector<double> values(Size, 3.0);
  std::vector<Id> parts(Size);
  for (int i = 0; i < Size; ++i)
  {
    parts[i] = i / 2;
  }
  const dgg::EliminationOrder order(pairs);
  for (const Id last : order.FindLast(parts, Size / 2))
  {
    isKnown[last] = 1;
    values[last] = 7.0;
  }
  dgg::SparseFactor factor;
  ASSERT_TRUE(factor.Compute(order, pairs, isKnown).IsOk());
  EXPECT_FALSE(factor.IsRaised());
  factor.Solve(values);
  for (int i = 0; i < Size; ++i)
  {
    EXPECT_EQ(values[i], isKnown[i] ? 7.0 : 3.0) << i;
  }
}

/// Returns the Laplacian of a square grid plus a multiple of the identity.
Matrix Grid(int size, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < size * size; ++v)
  {
    entries.emplace_back(v, v, shift);
    for (const int w : { v % size + 1 < size ? v + 1 : v, v + size < size * size ? v + size : v })
    {
      if (w != v)
      {
        entries.insert(
          entries.end(), { { v, v, 1.0 }, { w, w, 1.0 }, { v, w, -1.0 }, { w, v, -1.0 } });
      }
    }
  }
  Matrix laplacian(size * size, size * size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

TEST(SparseFactor, AgreesWithEigen)
{
  constexpr int Size = 40;
  const Matrix grid = Grid(Size, 0.01);
  Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(Size * Size, -1.0, 2.0);
  std::vector<double> values(expected.data(), expected.data() + expected.size());
  const Eigen::SimplicialLDLT<Matrix> peer(grid);
  expected = peer.solve(expected);
  dgg::SparseFactor factor;
  ASSERT_TRUE(factor.Compute(dgg::EliminationOrder(grid), grid).IsOk());
  EXPECT_FALSE(factor.IsRaised());
  EXPECT_EQ(factor.CountNegative(), 0);
  factor.Solve(values);
  for (int v = 0; v < Size * Size; ++v)
  {
    EXPECT_NEAR(values[v], expected[v], 1e-11 * expected.lpNorm<Eigen::Infinity>()) << v;
  }
}

TEST(SparseFactor, CountsEigenvaluesBelowZero)
{
  constexpr int Size = 12;
  const Matrix grid = Grid(Size, 0.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{ Eigen::MatrixXd(grid) };
  for (const int k : { 1, 3, 4, 6 }) // the remaining eigenvalues are pairs
  {
    const double sigma = 0.3 * solver.eigenvalues()[k - 1] + 0.7 * solver.eigenvalues()[k];
    const auto below = (solver.eigenvalues().array() < sigma).count();
    const Matrix shifted = Grid(Size, -sigma);
    dgg::SparseFactor factor;
    ASSERT_TRUE(factor.Compute(dgg::EliminationOrder(shifted), shifted).IsOk());
    EXPECT_EQ(factor.CountNegative(), below) << k;
  }
}
}

// Equations on cells with given coefficients, which may be ill-conditioned.

namespace
{
struct Link
{
  int From;
  int To;
  double Coefficient; // c_ij
};

/// Returns cells with one vertex each for the first vertices of a mesh, with the conductivities of
/// the links. The other vertices are in no cell.
dgg::SplineCells CellsOf(const dgg::SurfaceMesh& mesh, int count, const std::vector<Link>& links)
{
  dgg::SplineCells cells;
  cells.Cells.assign(mesh.GetNumberOfVertices(), dgg::NoId);
  for (Id i = 0; i < count; ++i)
  {
    cells.Cells[i] = i;
  }
  cells.Components.assign(count, 0);
  cells.Weights.assign(count, 1.0 / count);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const Link& link : links)
  {
    entries.emplace_back(link.From, link.From, link.Coefficient);
    entries.emplace_back(link.To, link.To, link.Coefficient);
    entries.emplace_back(link.From, link.To, -link.Coefficient);
    entries.emplace_back(link.To, link.From, -link.Coefficient);
  }
  cells.Stiffness.resize(count, count);
  cells.Stiffness.setFromTriplets(entries.begin(), entries.end());
  return cells;
}
}

TEST(SiteEquations, SmallPivotsAreNoMatter)
{
  // With cell 0 fixed, the matrix is close to (0 -1; -1 0), which has no pivots on the diagonal.
  const dgg::SurfaceMesh mesh = Build(Plane(3, 3));
  const Greens greens(mesh);
  const dgg::PoissonSystem& system = greens.Solver.GetSystem();
  for (const double little : { 1e-12, 1e-20, -1e-14 })
  {
    dgg::SplineCells cells = CellsOf(mesh, 3, { { 0, 1, -1.0 }, { 0, 2, -1.0 }, { 1, 2, 1.0 } });
    cells.Stiffness.coeffRef(1, 1) = little;
    cells.Stiffness.coeffRef(2, 2) = little;
    std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
    sources[1] = 1.0;
    sources[2] = 2.0;
    std::vector<double> values(3, 0.0);
    ASSERT_TRUE(dgg::SolveSiteEquations(system, cells, sources, { 0 }, values)) << little;
    EXPECT_NEAR(values[1], -2.0, 1e-8) << little;
    EXPECT_NEAR(values[2], -1.0, 1e-8) << little;
  }
}

TEST(SiteEquations, SingularOnesAreRefused)
{
  // Links from 1 and 2 to the fixed cell, and a link between 1 and 2 that cancels both: the matrix
  // is singular up to rounding, which leaves a small nonzero pivot.
  const dgg::SurfaceMesh mesh = Build(Plane(3, 3));
  const Greens greens(mesh);
  const dgg::PoissonSystem& system = greens.Solver.GetSystem();
  for (int k = 1; k < 30; ++k)
  {
    const double a = 0.1 * k;
    const double b = 0.3;
    const dgg::SplineCells cells =
      CellsOf(mesh, 3, { { 0, 1, a }, { 0, 2, b }, { 1, 2, -a * b / (a + b) } });
    std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
    sources[1] = 1.0;
    sources[2] = 0.7;
    std::vector<double> values(3, 0.0);
    EXPECT_FALSE(dgg::SolveSiteEquations(system, cells, sources, { 0 }, values)) << k;
  }
}
}
