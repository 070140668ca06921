// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact distances and geodesic graphs on every mesh (*.ply and awkward/*.ply) of the folder
/// DGG_EXTRA_DATA: invariants of any mesh, and known defects of known meshes.

#include "EdgeGraph.h"
#include "ExtraMeshes.h"
#include "GraphChecks.h"
#include "MeshFile.h"

#include "dggCapSplitting.h"
#include "dggExactGeodesics.h"
#include "dggFaceEnvelope.h"
#include "dggGraphBuilder.h"
#include "dggGraphSearch.h"
#include "dggMeshReport.h"
#include "dggSourceFinding.h"
#include "dggSourcePropagation.h"
#include "dggSurfaceMesh.h"

#include <vtkPolyData.h>

#include <cstddef>
#include <iostream>

namespace
{
/// Counts that were determined independently of this kernel.
struct KnownCounts
{
  dgg::Offset Vertices;
  dgg::Offset Faces;
  dgg::Offset Components;
  dgg::Offset BoundaryLoops;
  dgg::Offset NonManifoldEdges;
  dgg::Offset NonManifoldVertices;
  dgg::Offset DegenerateFaces;
  dgg::Offset CoincidentPoints;
};

const std::map<std::string, KnownCounts>& GetKnownCounts()
{
  static const std::map<std::string, KnownCounts> known = {
    { "eight", { 315, 634, 1, 0, 0, 0, 0, 0 } },
    { "ellipsoid", { 1556, 3108, 1, 0, 0, 0, 0, 0 } },
    { "fertility", { 4494, 9000, 1, 0, 0, 0, 0, 0 } },
    { "fandisk", { 6475, 12946, 1, 0, 0, 0, 0, 0 } },
    { "blade_aniso", { 8231, 16222, 1, 2, 0, 0, 0, 0 } },
    { "kitten", { 9447, 18894, 1, 0, 0, 0, 0, 0 } },
    { "rocker_arm", { 10044, 20088, 1, 0, 0, 0, 0, 0 } },
    { "aneurysm", { 10204, 20294, 1, 3, 0, 0, 0, 0 } },
    { "TR12J_cad", { 13441, 26966, 1, 0, 0, 0, 0, 0 } },
    { "sphere", { 16070, 32136, 1, 0, 0, 0, 0, 0 } },
    { "gargoyle", { 24992, 49980, 1, 0, 0, 0, 0, 0 } },
    { "face", { 25905, 51712, 1, 1, 0, 0, 0, 0 } },
    { "bunny", { 34835, 69666, 1, 0, 0, 0, 0, 0 } },
    { "armadillo", { 43243, 86482, 1, 0, 0, 0, 0, 0 } },
    { "igea", { 134345, 268686, 1, 0, 0, 0, 0, 0 } },
    { "terrain_andes", { 462400, 922082, 1, 1, 0, 0, 0, 0 } },
    { "camel_cut_seams", { 2032, 3576, 1, 1, 0, 0, 0, 243 } },
    // The boundary consists of 20 chains if fans end at non-manifold edges, and of 14 if fans
    // continue there.
    { "bathtub_shapenet", { 2124, 4375, 6, 20, 266, 1, 19, 6 } },
    { "teapot_seams", { 3644, 6320, 4, 25, 0, 38, 0, 403 } },
    { "capsule_degenerate", { 5252, 10200, 1, 1, 0, 0, 200, 250 } },
    { "pig_pinched", { 8642, 16848, 1, 21, 0, 421, 0, 0 } },
    { "parasaurolophus_scan", { 28291, 54839, 33, 118, 3, 13, 0, 0 } },
    { "beast_nonmanifold", { 32311, 64618, 1, 2, 2, 0, 0, 0 } },
    { "bunny_raw_5holes", { 34834, 69451, 1, 5, 0, 0, 0, 0 } },
    { "terrain_alps_voids", { 66423, 130144, 1, 112, 0, 4, 0, 0 } },
  };
  return known;
}

class ExtraData : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    this->Arrays = ToArrays(ReadPolyData(GetParam()));
    ASSERT_GT(this->Arrays.GetNumberOfFaces(), 0u) << "cannot read " << GetParam();
    const dgg::Status status = dgg::SurfaceMesh::FromPoints(this->Arrays.Points.data(),
      static_cast<dgg::Offset>(this->Arrays.GetNumberOfVertices()), this->Arrays.Triangles.data(),
      static_cast<dgg::Offset>(this->Arrays.GetNumberOfFaces()), this->Surface);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  }

  std::size_t GetNumberOfVertices() const { return this->Arrays.GetNumberOfVertices(); }

  /// Returns two vertices that have a face.
  std::vector<dgg::Id> GetSources() const
  {
    std::vector<dgg::Id> sources;
    const dgg::Id count = this->Surface.GetNumberOfVertices();
    for (dgg::Id source : { count / 3, count / 5 * 4 })
    {
      while (this->Surface.Kind(source) == dgg::VertexKind::Isolated)
      {
        source = (source + 1) % count;
      }
      sources.push_back(source);
    }
    return sources;
  }

  /// Returns ten vertices, or three of a large mesh, spread over the vertex ids.
  std::vector<dgg::Id> GetSpreadSources() const
  {
    const dgg::Offset n = this->Surface.GetNumberOfVertices();
    const dgg::Offset count = n > 100000 ? 3 : 10;
    std::vector<dgg::Id> sources;
    for (dgg::Offset k = 0; k < count; ++k)
    {
      sources.push_back(static_cast<dgg::Id>(n * (2 * k + 1) / (2 * count)));
    }
    return sources;
  }

  /// Returns the error that mollified faces without area may cause; 0 on other meshes, which only
  /// have rounding error.
  double GetSlack() const
  {
    return 10.0 * this->Surface.GetNumberOfMollifiedFaces() * this->Surface.GetMollification();
  }

  std::vector<double> Run(dgg::Id source, dgg::ExactEngine engine) const
  {
    dgg::ExactOptions options;
    options.Engine = engine;
    dgg::ExactResult result;
    const dgg::Status status =
      dgg::ExactGeodesics(this->Surface)
        .Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, options, result);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
    EXPECT_EQ(result.Distances.size(), this->GetNumberOfVertices());
    result.Distances.resize(this->GetNumberOfVertices());
    return result.Distances;
  }

  double GetEuclideanDistance(dgg::Id a, dgg::Id b) const
  {
    const double* p = this->Arrays.Points.data() + 3 * static_cast<std::size_t>(a);
    const double* q = this->Arrays.Points.data() + 3 * static_cast<std::size_t>(b);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
      (p[2] - q[2]) * (p[2] - q[2]));
  }

  MeshArrays Arrays;
  dgg::SurfaceMesh Surface;
};

TEST_P(ExtraData, DefectsAreCounted)
{
  const dgg::MeshReport report = dgg::InspectMesh(this->Surface, this->Arrays.Points.data());
  EXPECT_EQ(report.Vertices, static_cast<dgg::Offset>(this->GetNumberOfVertices()));
  EXPECT_EQ(report.Faces, static_cast<dgg::Offset>(this->Arrays.GetNumberOfFaces()));
  EXPECT_GE(report.Components, 1);
  EXPECT_GE(report.MeanAnisotropy, 1.0);
  const auto known = GetKnownCounts().find(StemOf(GetParam()));
  if (known != GetKnownCounts().end())
  {
    const KnownCounts& counts = known->second;
    EXPECT_EQ(report.Vertices, counts.Vertices);
    EXPECT_EQ(report.Faces, counts.Faces);
    EXPECT_EQ(report.Components, counts.Components);
    EXPECT_EQ(report.BoundaryLoops, counts.BoundaryLoops);
    EXPECT_EQ(report.NonManifoldEdges, counts.NonManifoldEdges);
    EXPECT_EQ(report.NonManifoldVertices, counts.NonManifoldVertices);
    EXPECT_EQ(report.DegenerateFaces, counts.DegenerateFaces);
    EXPECT_EQ(report.CoincidentPoints, counts.CoincidentPoints);
  }
}

TEST_P(ExtraData, DistancesKeepTheirBounds)
{
  const dgg::Id source = this->GetSources().front();
  const std::vector<double> distances = this->Run(source, dgg::ExactEngine::Triangle);
  const std::vector<double> upper =
    dggtest::EdgeGraphDistances(this->Surface, { { dgg::SurfacePoint::AtVertex(source), 0.0 } });
  dgg::Id numberOfComponents = 0;
  const std::vector<dgg::Id> components = this->Surface.ComputeComponents(numberOfComponents);

  constexpr double slack = 1e-9;
  std::size_t unequallyReached = 0;
  std::size_t belowEuclid = 0;
  std::size_t aboveEdges = 0;
  for (dgg::Id v = 0; v < this->Surface.GetNumberOfVertices(); ++v)
  {
    const bool isReached = std::isfinite(distances[v]);
    unequallyReached += isReached != (components[v] == components[source]) ? 1 : 0;
    belowEuclid += distances[v] < this->GetEuclideanDistance(source, v) * (1.0 - slack) ? 1 : 0;
    aboveEdges += isReached && !(distances[v] <= upper[v] * (1.0 + slack)) ? 1 : 0;
  }
  EXPECT_EQ(distances[source], 0.0);
  EXPECT_EQ(unequallyReached, 0u) << "vertices not of the source's component, or not reached";
  EXPECT_EQ(belowEuclid, 0u) << "vertices closer than the straight line";
  EXPECT_EQ(aboveEdges, 0u) << "vertices farther than along the edges";

  std::size_t steep = 0;
  for (dgg::Id h = 0; h < this->Surface.GetNumberOfHalfEdges(); ++h)
  {
    if (!this->Surface.IsDropped(dgg::SurfaceMesh::Face(h)))
    {
      const double from = distances[this->Surface.Origin(h)];
      const double to = distances[this->Surface.Destination(h)];
      // Rounding is relative to the distances, not to their difference.
      steep += std::isfinite(from) &&
          !(std::abs(from - to) <= this->Surface.Length(h) * (1.0 + slack) + 1e-12 * from)
        ? 1
        : 0;
    }
  }
  EXPECT_EQ(steep, 0u) << "half-edges along which the distance grows faster than the length";
}

TEST_P(ExtraData, EnginesAgree)
{
  // The reference engine takes minutes on larger meshes, where part of the surface must suffice.
  const bool isLarge = this->GetNumberOfVertices() > 50000;
  for (const dgg::Id source : this->GetSources())
  {
    dgg::ExactOptions options;
    const std::vector<double> fast = this->Run(source, dgg::ExactEngine::Triangle);
    double diameter = 0.0;
    for (const double d : fast)
    {
      diameter = std::isfinite(d) ? std::max(diameter, d) : diameter;
    }
    options.Engine = dgg::ExactEngine::Reference;
    options.MaximumDistance = isLarge ? 0.2 * diameter : dgg::Infinity;
    dgg::ExactResult reference;
    const dgg::Status status =
      dgg::ExactGeodesics(this->Surface)
        .Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, options, reference);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();

    std::size_t different = 0;
    double worst = 0.0;
    for (std::size_t v = 0; v < fast.size(); ++v)
    {
      const double slow = reference.Distances[v];
      if (std::isfinite(slow) || (!isLarge && std::isfinite(fast[v])))
      {
        const double difference = std::abs(slow - fast[v]);
        different += !(difference <= 1e-9 * diameter) ? 1 : 0;
        worst = std::max(worst, difference / diameter);
      }
    }
    EXPECT_EQ(different, 0u) << "source " << source << ", worst " << worst << " diameters";
  }
}

TEST_P(ExtraData, GraphKeepsItsPromise)
{
  const bool isLarge = this->GetNumberOfVertices() > 100000;
  std::vector<dgg::Id> sources = this->GetSources();
  sources.resize(isLarge ? 1 : 2);
  std::vector<std::vector<double>> exact;
  double diameter = 0.0;
  for (const dgg::Id source : sources)
  {
    exact.push_back(this->Run(source, dgg::ExactEngine::Triangle));
    for (const double d : exact.back())
    {
      diameter = std::isfinite(d) ? std::max(diameter, d) : diameter;
    }
  }
  const double slack = this->GetSlack();
  const dgg::GraphBuilder builder(this->Surface);
  for (const double accuracy : { 0.1, 0.01, 0.001 })
  {
    if (isLarge && accuracy < 0.01)
    {
      continue;
    }
    SCOPED_TRACE(accuracy);
    dgg::GraphOptions options;
    options.Accuracy = accuracy;
    dgg::GraphEstimate estimate;
    dgg::Status status = builder.Estimate(options, estimate);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
    dgg::GeodesicGraph graph;
    status = builder.Build(options, graph);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
    const dgg::GraphView view = graph.View();
    status = dgg::CheckGraph(view, view.GetNumberOfEdges());
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
    const auto size = static_cast<double>(graph.GetMemorySize());
    EXPECT_GE(estimate.Peak, size);
    EXPECT_NEAR(estimate.Memory / size, 1.0, 0.25);

    std::size_t below = 0;
    std::size_t beyond = 0;
    double worst = 0.0;
    for (std::size_t s = 0; s < sources.size(); ++s)
    {
      const std::vector<double> distances = dggtest::GraphDistances(view, sources[s]);
      for (std::size_t v = 0; v < distances.size(); ++v)
      {
        const double d = exact[s][v];
        ASSERT_EQ(std::isfinite(d), std::isfinite(distances[v])) << v;
        if (std::isfinite(d))
        {
          below += distances[v] < d * (1.0 - 1e-9) - slack ? 1 : 0;
          beyond += distances[v] <= (1.0 + accuracy) * (d + slack) * (1.0 + 1e-6) ? 0 : 1;
          worst = d > 0.0 ? std::max(worst, distances[v] / d - 1.0) : worst;
        }
      }
    }
    EXPECT_EQ(below, 0u) << "vertices closer than the exact distance";
    EXPECT_EQ(beyond, 0u) << "vertices beyond the promise, worst " << worst;
    EXPECT_GT(worst, 0.05 * accuracy) << "the promise is no challenge";
  }
}

/// A corrected distance is always within the accuracy. On meshes that are fine enough and not too
/// anisotropic, its mean error is much smaller than that of the graph.
TEST_P(ExtraData, CorrectionPays)
{
  const auto n = static_cast<dgg::Id>(this->GetNumberOfVertices());
  const bool isRegular = n > 4000 && dgg::InspectMesh(this->Surface).MedianAnisotropy < 2.0;
  const double slack = this->GetSlack();
  const std::vector<dgg::Id> sources = this->GetSpreadSources();
  std::vector<std::vector<double>> exact;
  for (const dgg::Id source : sources)
  {
    exact.push_back(this->Run(source, dgg::ExactEngine::Triangle));
  }
  const dgg::GraphBuilder builder(this->Surface);
  for (const double accuracy : { 0.05, 0.02, 0.01 })
  {
    SCOPED_TRACE(accuracy);
    dgg::GraphOptions options;
    options.Accuracy = accuracy;
    dgg::GeodesicGraph graph;
    ASSERT_TRUE(builder.Build(options, graph).IsOk());
    const dgg::GraphSearch search(graph.View(), &this->Surface);
    double raw = 0.0;
    double corrected = 0.0;
    std::size_t beyond = 0;
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      dgg::GraphSeed seed;
      seed.Vertex = sources[k];
      dgg::SearchOptions searchOptions;
      searchOptions.Correct = true;
      dgg::SearchResult result;
      ASSERT_TRUE(search.Run({ seed }, searchOptions, result).IsOk());
      for (dgg::Id v = 0; v < n; ++v)
      {
        const double d = exact[k][v];
        if (d > 0.0 && std::isfinite(d))
        {
          const double error = std::abs(result.Corrected[v] - d);
          beyond += error <= accuracy * (d + slack) * (1.0 + 1e-6) + slack ? 0 : 1;
          raw += (result.Distances[v] - d) / d;
          corrected += error / d;
        }
      }
    }
    EXPECT_EQ(beyond, 0u);
    if (isRegular)
    {
      EXPECT_GE(raw / corrected, 5.0);
    }
    std::cout << "accuracy " << accuracy << ": corrected mean error " << raw / corrected
              << " times smaller" << (isRegular ? "" : " (not promised)") << "\n";
  }
}

/// Propagation reaches the same vertices as exact distances. On average the higher quality is at
/// least as accurate.
TEST_P(ExtraData, PropagationQualities)
{
  const dgg::SourcePropagation propagation(this->Surface);
  dgg::PropagationOptions options;
  std::array<std::vector<double>, 2> errors;
  for (const dgg::Id source : this->GetSpreadSources())
  {
    const std::vector<double> exact = this->Run(source, dgg::ExactEngine::Triangle);
    for (const auto quality : { dgg::PropagationQuality::Fast, dgg::PropagationQuality::High })
    {
      options.Quality = quality;
      dgg::PropagationResult result;
      const dgg::Status status =
        propagation.Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, options, result);
      ASSERT_TRUE(status.IsOk()) << status.GetMessage();
      for (std::size_t v = 0; v < exact.size(); ++v)
      {
        const double d = exact[v];
        ASSERT_EQ(std::isfinite(d), std::isfinite(result.Distances[v])) << v;
        if (d > 0.0 && std::isfinite(d))
        {
          errors[quality == dgg::PropagationQuality::High].push_back(result.Distances[v] / d - 1.0);
        }
      }
    }
  }
  std::array<double, 2> means{};
  for (const std::size_t i : { 0, 1 })
  {
    for (const double error : errors[i])
    {
      means[i] += std::abs(error) / static_cast<double>(errors[i].size());
    }
    const auto range = std::minmax_element(errors[i].begin(), errors[i].end());
    std::cout << (i == 0 ? "Fast: " : "High: ") << 100.0 * means[i] << " % on the mean, "
              << 100.0 * *range.first << " to " << 100.0 * *range.second << " %\n";
  }
  EXPECT_LE(means[1], 1.02 * means[0]); // equally accurate on smooth meshes
}

INSTANTIATE_TEST_SUITE_P(Real, ExtraData, testing::ValuesIn(FindExtraMeshes()), NameExtraMesh);

TEST(ExtraDataFolder, HasMeshes)
{
  EXPECT_FALSE(FindExtraMeshes().empty()) << "no *.ply in " << DGG_EXTRA_DATA;
}
}
