// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of harmonic B-splines.
#ifndef SplineTestTools_h
#define SplineTestTools_h

#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggHarmonicSplines.h"
#include "dggSplineCells.h"
#include "dggSplineSites.h"

namespace dggtest
{
inline std::vector<NamedMesh> SmallMeshes()
{
  return { { "sphere", NoisySphere(2, 0.02, 3) }, { "plane", Scaled(Plane(9, 7, 0.3), 0.1) },
    { "torus", Torus(14, 9) }, { "several", SeveralComponents() } };
}

inline std::vector<Id> AllFreeVertices(const dgg::PoissonSolver& solver)
{
  std::vector<Id> vertices;
  const dgg::SurfaceMesh& mesh = solver.GetMesh();
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!solver.IsFixed(v) && mesh.FanBegin(v) != mesh.FanEnd(v))
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

/// Returns a density integrated over the cells of vertices; 0 at vertices with prescribed values.
inline std::vector<double> Integrated(
  const dgg::PoissonSolver& solver, const std::function<double(Id)>& density)
{
  std::vector<double> sources(solver.GetAreas().size());
  for (std::size_t v = 0; v < sources.size(); ++v)
  {
    const Id id = static_cast<Id>(v);
    sources[v] = solver.IsFixed(id) ? 0.0 : solver.GetAreas()[v] * density(id);
  }
  return sources;
}

/// A solver with prepared splines at sites.
class Splines : public Greens
{
public:
  explicit Splines(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
    : Greens(mesh, options)
    , Functions(Solver)
  {
  }
  void Prepare(const std::vector<Id>& sites, const dgg::ParallelFor& parallel = nullptr)
  {
    this->Sites = sites;
    dgg::Status status = this->Functions.Prepare(sites, parallel, nullptr);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
    status = dgg::FindSplineCells(this->Solver.GetSystem(), sites, parallel, nullptr, this->Cells);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  }
  void PrepareAll() { this->Prepare(AllFreeVertices(this->Solver)); }
  void PrepareSome(Id count)
  {
    std::vector<Id> sites;
    ASSERT_TRUE(dgg::ChooseSplineSites(this->Solver, count, nullptr, sites).IsOk());
    this->Prepare(sites);
  }

  /// Returns the basis functions, one per site.
  std::vector<std::vector<double>> Basis(const dgg::ParallelFor& parallel = nullptr) const
  {
    std::vector<std::vector<double>> all(this->Sites.size());
    EXPECT_TRUE(this->Functions
                  .FindBasis(parallel, nullptr,
                    [&](Id site, const std::vector<double>& values) { all[site] = values; })
                  .IsOk());
    return all;
  }
  std::vector<double> Evaluate(
    const std::vector<dgg::SurfacePoint>& points, dgg::GreensMethod method) const
  {
    std::vector<double> values;
    EXPECT_TRUE(Ok(this->Functions.Evaluate(points, method, nullptr, nullptr, values)));
    return values;
  }
  std::vector<double> SolveSites(const std::vector<double>& sources) const
  {
    std::vector<double> coefficients;
    EXPECT_TRUE(Ok(this->Functions.Solve(sources, {}, coefficients)));
    return coefficients;
  }
  std::vector<double> Combine(
    const std::vector<double>& coefficients, const std::vector<double>& given = {}) const
  {
    std::vector<double> values;
    EXPECT_TRUE(Ok(this->Functions.Combine(coefficients, given, values)));
    return values;
  }

  dgg::HarmonicSplines Functions;
  std::vector<Id> Sites;
  dgg::SplineCells Cells; // cells of the basis functions
};
}

#endif
