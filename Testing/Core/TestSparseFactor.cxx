// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Factors of sparse matrices, of those without an inverse as well.
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggSparseFactor.h"
#include "dggSplineCells.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <vector>

namespace dggtest
{
namespace
{
using dgg::Id;
using dgg::SurfaceMesh;
using Matrix = Eigen::SparseMatrix<double>;

/// The Laplacian of pairs of vertices. Half of the pivots are 0.
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
  // In at one of a pair, out at the other.
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

/// Laplacian of a square grid, and a multiple of the identity.
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
  for (const int k : { 1, 3, 4, 6 }) // others are in pairs
  {
    const double sigma = 0.3 * solver.eigenvalues()[k - 1] + 0.7 * solver.eigenvalues()[k];
    const auto below = (solver.eigenvalues().array() < sigma).count();
    const Matrix shifted = Grid(Size, -sigma);
    dgg::SparseFactor factor;
    ASSERT_TRUE(factor.Compute(dgg::EliminationOrder(shifted), shifted).IsOk());
    EXPECT_EQ(factor.CountNegative(), below) << k;
  }
}

TEST(SparseFactor, MeshesWithNeedles)
{
  // A triangle that hangs on a vertex of a sphere, and gets ever thinner.
  for (const double width : { 1e-3, 1e-9, 1e-15, 0.0 })
  {
    TestMesh sphere = Icosphere(2);
    const Id n = static_cast<Id>(sphere.Points.size() / 3);
    const double r = 1.5;
    const std::vector<double> tip(sphere.Points.begin(), sphere.Points.begin() + 3);
    for (const double shift : { 0.0, width })
    {
      sphere.Points.insert(
        sphere.Points.end(), { r * tip[0] + shift, r * tip[1] - shift, r * tip[2] });
    }
    sphere.Triangles.insert(sphere.Triangles.end(), { 0, n, n + 1 });
    for (const bool isDelaunay : { false, true })
    {
      SCOPED_TRACE(testing::Message() << width << (isDelaunay ? ", flipped" : ""));
      const SurfaceMesh mesh = Build(sphere);
      dgg::PoissonSolver solver(mesh);
      dgg::PoissonOptions options;
      options.IntrinsicDelaunay = isDelaunay;
      ASSERT_TRUE(solver.Prepare(options, nullptr).IsOk());
      std::vector<double> values(mesh.GetNumberOfVertices(), 0.0);
      values[1] = 1.0;
      values[2] = -1.0;
      ASSERT_TRUE(solver.Solve(values).IsOk());
      const std::vector<double> sources = solver.GetSystem().Multiply(values);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        EXPECT_NEAR(sources[v], v == 1 ? 1.0 : v == 2 ? -1.0 : 0.0, 1e-8) << v;
      }
    }
  }
}
}

// Equations on cells whose coefficients are given, so that they may be bad ones.

namespace
{
struct Link
{
  int From;
  int To;
  double Coefficient; // c_ij
};

/// The first vertices of a mesh are cells that conduct as the links say; others are in no cell.
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
  // With cell 0 held, the equations are next to (0 -1; -1 0), which has no pivots at all.
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
  // Ways from 1 and 2 to the held cell, and one between them that undoes both: singular up to
  // rounding, which leaves a pivot that is not quite 0.
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
