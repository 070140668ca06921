// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What building and searching graphs takes, and what is said of it before.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "GraphChecks.h"
#include "MemoryChecks.h"

#include "dggGraphSearch.h"

namespace dggtest
{
using dgg::GraphConstruction;

namespace
{
/// What does not depend on the mesh.
constexpr double SmallAllocations = 20000.0;
}

TEST(GraphMemory, EstimateIsWithinAFactorOfTwo)
{
  std::vector<Id> unused;
  for (const NamedMesh& named :
    { NamedMesh{ "Plane", Plane(60, 50, 0.25, 1) }, NamedMesh{ "Sphere", NoisySphere(5, 0.2, 2) },
      NamedMesh{ "Rough", Terrain(40, 2.0, 3) }, NamedMesh{ "Book", Book(4, 28, unused, 0.2, 4) } })
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto construction : { GraphConstruction::Guaranteed, GraphConstruction::OneRelay,
           GraphConstruction::Indirect, GraphConstruction::SaddleVertexGraph })
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
}
