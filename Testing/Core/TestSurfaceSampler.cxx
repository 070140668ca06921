// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Surface samples: guarantees on their distances, compared with exact distances.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggExactGeodesics.h"
#include "dggSurfacePath.h"
#include "dggSurfaceSampler.h"

namespace dggtest
{
namespace
{
using dgg::SamplerOptions;
using dgg::SurfacePoint;
using dgg::SurfaceSample;

constexpr double Accuracy = 0.02;

std::vector<SurfaceSample> SamplesOf(const SearchCase& c, const SamplerOptions& options)
{
  const dgg::GraphBuilder builder(c.GetMesh());
  std::vector<SurfaceSample> samples;
  const dgg::Status status =
    dgg::SampleSurface(c.GetGraph(), &c.GetMesh(), &builder, Accuracy, options, samples);
  EXPECT_TRUE(status.IsOk()) << c.GetName() << ": " << status.GetMessage();
  return samples;
}

int CountInner(const std::vector<SurfaceSample>& samples)
{
  return static_cast<int>(std::count_if(samples.begin(), samples.end(),
    [](const SurfaceSample& sample) { return sample.Point.On != SurfacePoint::Support::Vertex; }));
}

/// Expects covering radii that never increase and equal the exact ones within the accuracy, and
/// samples that are separated from each other.
void ExpectSpread(const SearchCase& c, const std::vector<SurfaceSample>& samples)
{
  dgg::ExactGeodesics exact(c.GetMesh());
  std::vector<dgg::GeodesicSource> sources;
  double before = dgg::Infinity;
  for (const SurfaceSample& sample : samples)
  {
    EXPECT_LE(sample.CoveringRadius, before) << c.GetName();
    before = sample.CoveringRadius;
    sources.push_back({ sample.Point, 0.0 });
    dgg::ExactResult result;
    ASSERT_TRUE(exact.Run(sources, {}, result).IsOk());
    double radius = 0.0;
    for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
    {
      const bool isIsolated = c.GetMesh().Kind(v) == dgg::VertexKind::Isolated;
      radius = isIsolated ? radius : std::max(radius, result.Distances[v]);
    }
    EXPECT_GE(sample.CoveringRadius, radius * (1.0 - 1e-9)) << c.GetName();
    EXPECT_LE(sample.CoveringRadius, radius * (1.0 + Accuracy) * (1.0 + 1e-6)) << c.GetName();
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    dgg::ExactOptions options;
    for (std::size_t j = 0; j < i; ++j)
    {
      options.Targets.push_back(samples[j].Point);
    }
    dgg::ExactResult result;
    ASSERT_TRUE(exact.Run({ { samples[i].Point, 0.0 } }, options, result).IsOk());
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GE(
        result.TargetDistances[j] * (1.0 + Accuracy) * (1.0 + 1e-6), samples.back().CoveringRadius)
        << c.GetName();
    }
  }
}
}

TEST(SurfaceSampler, SamplesAreSpread)
{
  for (bool inFaces : { false, true })
  {
    int inner = 0;
    for (const NamedMesh& named : SoundMeshes())
    {
      const SearchCase c(named.Name, named.Mesh, Accuracy);
      SamplerOptions options;
      options.NumberOfSamples = 15;
      options.InFaces = inFaces;
      const std::vector<SurfaceSample> samples = SamplesOf(c, options);
      EXPECT_EQ(samples.size(), std::min<std::size_t>(15, c.GetNumberOfVertices()));
      ExpectSpread(c, samples);
      inner += CountInner(samples);
    }
    EXPECT_EQ(inner > 0, inFaces);
  }
}

TEST(SurfaceSampler, ComponentsComeFirst)
{
  const SearchCase c("several components", SeveralComponents(), Accuracy);
  SamplerOptions options;
  options.NumberOfSamples = 2;
  options.InFaces = true;
  const std::vector<SurfaceSample> samples = SamplesOf(c, options);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].CoveringRadius, dgg::Infinity);
  Id count = 0;
  const std::vector<Id> component = c.GetMesh().ComputeComponents(count);
  EXPECT_NE(component[samples[0].Point.Vertex], component[samples[1].Point.Vertex]);
}

TEST(SurfaceSampler, OnAnySurface)
{
  for (bool inFaces : { false, true })
  {
    for (const NamedMesh& named : DefectMeshes())
    {
      const SearchCase c(named.Name, named.Mesh, Accuracy);
      SamplerOptions options;
      options.NumberOfSamples = 20;
      options.InFaces = inFaces;
      double before = dgg::Infinity;
      for (const SurfaceSample& sample : SamplesOf(c, options))
      {
        EXPECT_TRUE(sample.Point.Check(c.GetMesh()).IsOk()) << named.Name;
        EXPECT_LE(sample.CoveringRadius, before) << named.Name;
        before = sample.CoveringRadius;
      }
    }
  }
}

TEST(SurfaceSampler, TheFarthestPointOfAPlaneIsInAFace)
{
  // With four corners of a square given, the center is the farthest point, although it is not a
  // vertex.
  const Id n = 7;
  const TestMesh points = Plane(n, n);
  const SearchCase c("plane", points, Accuracy);
  const Id last = c.GetNumberOfVertices() - 1;
  const double size = points.Point(last)[0];
  SamplerOptions options;
  for (const double x : { 0.0, size })
  {
    for (const double y : { 0.0, size })
    {
      options.Given.push_back(SurfacePoint::AtVertex(VertexAt(points, x, y, 0.0)));
    }
  }
  options.NumberOfSamples = 5;
  options.InFaces = true;
  const std::vector<SurfaceSample> samples = SamplesOf(c, options);
  ASSERT_EQ(samples.size(), 5u);
  const std::array<double, 3> p =
    dgg::PositionOf(c.GetMesh(), samples[4].Point, points.Points.data());
  const bool isVertexInTheMiddle = (points.GetNumberOfVertices() % 2) == 1;
  EXPECT_EQ(CountInner(samples), isVertexInTheMiddle ? 0 : 1);
  EXPECT_NEAR(p[0], 0.5 * size, 0.02 * size);
  EXPECT_NEAR(p[1], 0.5 * size, 0.02 * size);
}

TEST(SurfaceSampler, StartsWhereAsked)
{
  const SearchCase c("sphere", Icosphere(2), Accuracy);
  SamplerOptions options;
  options.NumberOfSamples = 3;
  options.FirstVertex = 17;
  EXPECT_EQ(SamplesOf(c, options)[0].Point.Vertex, 17);
  // By default the first sample is the vertex farthest from vertex 0.
  options.FirstVertex = dgg::NoId;
  const std::vector<double> field = GraphDistances(c.GetGraph(), 0);
  const double farthest = *std::max_element(field.begin(), field.end());
  EXPECT_EQ(field[SamplesOf(c, options)[0].Point.Vertex], farthest);
  // All given samples come first.
  const auto inner = SurfacePoint::InFace(c.GetMesh(), 33, { { 0.2, 0.3, 0.5 } });
  options.Given = { inner, SurfacePoint::AtVertex(5), inner, SurfacePoint::AtVertex(5) };
  const std::vector<SurfaceSample> samples = SamplesOf(c, options);
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(samples[0].Point.Face, 33);
  EXPECT_EQ(samples[3].Point.Vertex, 5);
  EXPECT_EQ(samples[3].CoveringRadius, samples[1].CoveringRadius);
}

TEST(SurfaceSampler, AllVertices)
{
  const SearchCase c("isolated points", SphereWithIsolatedPoints(1), Accuracy);
  SamplerOptions options;
  options.NumberOfSamples = 1000000;
  const std::vector<SurfaceSample> samples = SamplesOf(c, options);
  Id expected = 0;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    expected += c.GetMesh().Kind(v) == dgg::VertexKind::Isolated ? 0 : 1;
  }
  EXPECT_EQ(samples.size(), static_cast<std::size_t>(expected));
  EXPECT_EQ(samples.back().CoveringRadius, 0.0);
  options.NumberOfSamples = 0;
  EXPECT_TRUE(SamplesOf(c, options).empty());
}
}
