// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory predictions of solvers: sufficient, and at most twice the measured peak.
#include "../Benchmark/MemoryProbe.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "GraphicsTestTools.h"
#include "TestMeshes.h"

#include "dggExactPath.h"
#include "dggGraphSearch.h"
#include "dggGreensFunction.h"
#include "dggHeatMethod.h"
#include "dggPoissonSolver.h"

#include <cstddef>
#include <optional>

namespace dggtest
{
namespace
{
/// Returns a plane of cells with the given height. Cotangents are so large that solutions may be
/// refined iteratively, which takes more memory.
TestMesh NarrowPlane(Id nx, Id ny, double height)
{
  TestMesh plane = Plane(nx, ny);
  for (std::size_t i = 1; i < plane.Points.size(); i += 3)
  {
    plane.Points[i] *= height;
  }
  return plane;
}

/// Expects the prediction to be sufficient and not much too large. A peak of 0 was not measurable.
void ExpectPrediction(
  std::size_t peak, std::size_t predicted, double slack, const std::string& context)
{
  EXPECT_LE(peak, predicted) << context;
  if (peak > 0)
  {
    EXPECT_LE(predicted, slack * static_cast<double>(peak)) << context << ": " << peak;
  }
}

/// Size of results and one-time allocations, bytes.
constexpr std::size_t Small = 400000;

std::vector<NamedMesh> Meshes()
{
  return { { "sphere", NoisySphere(5, 0.01, 3) }, { "terrain", Terrain(110, 0.8, 5) },
    { "needles", NarrowPlane(150, 80, 1e-3) } };
}

/// Compares the prediction of a solver with its peak memory. The memory of the analysis, before the
/// prediction, is not counted.
template <typename Solver, typename Options>
void CheckFactorization(
  const dgg::SurfaceMesh& mesh, const Options& options, const std::string& what)
{
  Solver solver(mesh);
  MemoryProbe probe;
  std::size_t held = 0;
  double estimated = 0.0;
  std::optional<MemoryProbe> later;
  const auto check = [&](double bytes, auto...) {
    estimated = bytes;
    held = probe.GetHeapGrowth();
    later.emplace();
    return dgg::Status::Success();
  };
  ASSERT_TRUE(solver.Prepare(options, nullptr, check).IsOk());
  EXPECT_EQ(solver.GetEstimatedMemory(), estimated);
  const std::size_t peak = later->GetHeapPeak();
  ExpectPrediction(peak > 0 ? held + peak : 0, static_cast<std::size_t>(estimated), 2.0, what);
}
}

TEST(SpectralMemory, OfFactorizations)
{
  for (const NamedMesh& named : Meshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    CheckFactorization<dgg::PoissonSolver>(mesh, dgg::PoissonOptions(), "Poisson " + named.Name);
    for (const dgg::HeatBoundary boundary :
      { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Average })
    {
      dgg::HeatOptions options;
      options.Boundary = boundary;
      CheckFactorization<dgg::HeatMethod>(mesh, options, "heat " + named.Name);
    }
  }
}

TEST(SpectralMemory, OfGreensFunctions)
{
  for (const NamedMesh& named : Meshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    dgg::PoissonSolver solver(mesh);
    ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
    const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
    std::vector<dgg::SurfacePoint> poles;
    for (std::size_t k = 0; k < dgg::GreensFunction::PolesInBlock; ++k)
    {
      poles.push_back(dgg::SurfacePoint::AtVertex(static_cast<dgg::Id>(k * (n / 9) + 7)));
    }
    for (const dgg::GreensOrder order : { dgg::GreensOrder::Laplace, dgg::GreensOrder::BiLaplace })
    {
      const dgg::GreensFunction function(solver);
      dgg::GreensQuery query;
      query.Order = order;
      // With a radius of 0, no distances would be found on needles.
      query.Radius = named.Name == "needles" ? 1.2 : 0.0;
      std::vector<dgg::GreensResult> results;
      const MemoryProbe probe;
      ASSERT_TRUE(function.Run(poles, query, results).IsOk());
      const std::size_t peak = probe.GetHeapPeak();
      const double estimated = dgg::GreensFunction::BytesPerVertex * static_cast<double>(n);
      ExpectPrediction(
        peak - std::min(peak, Small), static_cast<std::size_t>(estimated), 2.0, named.Name);
    }
  }
}

// Memory of building and searching graphs, compared with the estimates.

namespace
{
/// Allocations independent of the mesh, bytes.
constexpr double SmallAllocations = 20000.0;
}

TEST(GraphMemory, EstimateIsEnoughAndNotFarTooMuch)
{
  std::vector<Id> unused;
  for (const NamedMesh& named :
    { NamedMesh{ "Plane", Plane(60, 50, 0.25, 1) }, NamedMesh{ "Sphere", NoisySphere(5, 0.2, 2) },
      NamedMesh{ "Rough", Terrain(40, 2.0, 3) }, NamedMesh{ "Book", Book(4, 28, unused, 0.2, 4) } })
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto construction : AllConstructions())
    {
      for (const int threads : { 1, 3 })
      {
        dgg::GraphOptions options;
        options.Construction = construction;
        options.Accuracy = 0.02;
        options.Parallel = WithThreads(threads, 1);
        options.NumberOfThreads = threads;
        dgg::GraphEstimate estimate;
        const MemoryProbe probe;
        const dgg::GraphBuilder builder(mesh);
        ASSERT_TRUE(builder.Estimate(options, estimate).IsOk());
        dgg::GeodesicGraph graph;
        ASSERT_TRUE(builder.Build(options, graph).IsOk());
        ExpectPrediction(probe.GetHeapPeak(), static_cast<std::size_t>(estimate.Peak), 2.0,
          named.Name + ", construction " + std::to_string(static_cast<int>(construction)) + ", " +
            std::to_string(threads) + " threads");
      }
    }
  }
}

TEST(GraphMemory, EstimateIsEnoughOnSmallMeshes)
{
  for (const int level : { 0, 1, 2 })
  {
    const dgg::SurfaceMesh mesh = Build(Icosphere(level));
    dgg::GraphEstimate estimate;
    const MemoryProbe probe;
    const dgg::GraphBuilder builder(mesh);
    ASSERT_TRUE(builder.Estimate({}, estimate).IsOk());
    dgg::GeodesicGraph graph;
    ASSERT_TRUE(builder.Build({}, graph).IsOk());
    EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), estimate.Peak + SmallAllocations) << level;
  }
}

/// The estimate for a large mesh leaves no memory in use that the construction does not reuse.
TEST(GraphMemory, EstimateKeepsNothing)
{
  const dgg::SurfaceMesh mesh = Build(Plane(600, 620));
  const dgg::GraphBuilder builder(mesh);
  dgg::GraphEstimate estimate;
  const MemoryProbe probe;
  ASSERT_TRUE(builder.Estimate({}, estimate).IsOk());
  EXPECT_LE(probe.GetHeapGrowth(), Small);
}

TEST(GraphMemory, SearchesReportWhatTheyHold)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(5, 0.2, 2));
  const dgg::GeodesicGraph graph = BuildGraph(mesh, 0.05);
  const auto expectGrowth = [](const MemoryProbe& probe, const dgg::GraphSearch& search) {
    const auto held = static_cast<double>(probe.GetHeapGrowth());
    EXPECT_GE(2.0 * static_cast<double>(search.GetMemorySize()), held);
    EXPECT_LE(0.5 * static_cast<double>(search.GetMemorySize()), held > 0.0 ? held : 1e9);
  };
  const MemoryProbe probe;
  dgg::GraphSearch search(graph.View(), &mesh);
  {
    dgg::SearchOptions options;
    options.Correct = true;
    dgg::SearchResult result;
    ASSERT_TRUE(search.Run({ dgg::GraphSeed{ 0 } }, options, result).IsOk());
  }
  expectGrowth(probe, search);
  ASSERT_TRUE(search.PrepareLandmarks(nullptr, nullptr).IsOk());
  expectGrowth(probe, search);
}

// Vector graphics never exceed the requested memory.

TEST(GraphicsMemory, IsAskedForBeforeItIsTaken)
{
  // The requested memory is not exceeded while the surface is refined and cut, while the equation
  // is prepared, and while colors are computed. Includes many regions with nearly everything on
  // their left.
  const TestMesh sphere = Icosphere(4);
  for (const bool hasPoisson : { false, true })
  {
    for (const int regions : { 0, 100 })
    {
      Drawing drawing(sphere);
      const std::vector<double> two = { 0.0, 1.0 };
      drawing
        .Add(hasPoisson ? Poisson : Diffusion,
          { SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(40) }, two, two)
        .Width = 0.5;
      for (int k = 0; k < regions; ++k)
      {
        const std::array<Id, 3> corners = drawing.Mesh.GetTriangle(50 + 31 * k);
        drawing.Add(Region,
          { SurfacePoint::AtVertex(corners[0]), SurfacePoint::AtVertex(corners[2]),
            SurfacePoint::AtVertex(corners[1]) },
          { 0.1, 0.0, 0.0 }, {}, true);
      }
      drawing.Regions = { { { 1, 2, 3 }, { 0.5 } } };
      drawing.Options.IntrinsicDelaunay = hasPoisson;
      double asked = 4.0 * dgg::VectorGraphics::BytesPerFace * drawing.Mesh.GetNumberOfFaces();
      const MemoryProbe probe;
      const auto expectEnough = [&](const char* when) {
        EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), asked)
          << when << " " << hasPoisson << " " << regions;
      };
      int count = 0;
      drawing.Options.CheckMemory = [&](double bytes, double) {
        expectEnough("meanwhile");
        asked = std::max(asked, bytes);
        ++count;
        return dgg::Status::Success();
      };
      ASSERT_TRUE(drawing.Prepare(1).IsOk());
      expectEnough("prepared");
      EXPECT_EQ(count, 1 + regions);
      drawing.Surface = SubMesh(); // no longer needed
      ASSERT_TRUE(drawing.Solve().IsOk());
      expectEnough("solved");
      EXPECT_EQ(count, 2 + regions);
      const auto peak = static_cast<double>(probe.GetHeapPeak()); // 0 if not measured
      EXPECT_TRUE(peak == 0.0 || asked <= 2.0 * peak) << "far too much: " << asked;
    }
  }
}

// Memory of path finders for successive paths.

TEST(PathMemory, TheNextPathTakesNothingForEachVertex)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(6));
  std::vector<dgg::SurfacePath> paths;
  dgg::ExactPathFinder finder(mesh);
  const auto find = [&](Id from, Id to) {
    const dgg::SurfacePoint target = dgg::SurfacePoint::AtVertex(to);
    return finder.Find(dgg::SurfacePoint::AtVertex(from), { target }, nullptr, paths).IsOk();
  };
  ASSERT_TRUE(find(0, 1)); // far apart
  for (const Id v : { 20000, 30000 })
  {
    const MemoryProbe probe;
    ASSERT_TRUE(find(v, mesh.Destination(*mesh.FanBegin(v))));
    EXPECT_LT(probe.GetHeapPeak(), static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  }
}

// Memory of exact solvers that keep their windows.

TEST(WindowMemory, TheResidentSetStaysWithinTheEstimate)
{
  // Enough half-edges for several blocks of window lists, which are freed one by one.
  const dgg::SurfaceMesh mesh = Build(Terrain(160, 0.8, 5));
  dgg::ExactGeodesics solver(mesh);
  dgg::ExactOptions options;
  options.KeepWindows = true;
  dgg::ExactResult result;
  const MemoryProbe probe;
  const bool isReset = probe.GetResidentPeak() < Small;
  ASSERT_TRUE(solver.Run({ VertexSource(17) }, options, result).IsOk());
  if (isReset && probe.GetHeapPeak() > 0) // sanitizers do not return freed memory
  {
    ExpectPrediction(probe.GetResidentPeak(), result.PeakMemory, 2.0, "terrain");
  }
}
}
