// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Propagation of virtual sources: exact cases, accuracy, any triangles, any number of threads.
#include "EdgeGraph.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggSourcePropagation.h"
#include "dggSurfacePath.h"

namespace dggtest
{
namespace
{
using Quality = dgg::PropagationQuality;
using Sources = std::vector<dgg::GeodesicSource>;
using Change = std::function<void(dgg::PropagationOptions&)>;

/// Runs each test once per quality.
class SourcePropagation : public testing::TestWithParam<Quality>
{
protected:
  dgg::PropagationResult Run(
    const dgg::SurfaceMesh& mesh, const Sources& sources, const Change& change = nullptr) const
  {
    dgg::PropagationOptions options;
    options.Quality = this->GetParam();
    options.WantNearestSource = true;
    options.WantVirtualSource = true;
    if (change)
    {
      change(options);
    }
    dgg::PropagationResult result;
    EXPECT_TRUE(Ok(dgg::SourcePropagation(mesh).Run(sources, options, result)));
    return result;
  }
  std::vector<double> From(const dgg::SurfaceMesh& mesh, Id source) const
  {
    return this->Run(mesh, { VertexSource(source) }).Distances;
  }
};

INSTANTIATE_TEST_SUITE_P(Qualities, SourcePropagation,
  testing::Values(Quality::Fast, Quality::High),
  [](const auto& info) { return info.param == Quality::Fast ? "Fast" : "High"; });

std::vector<double> Exact(const dgg::SurfaceMesh& mesh, const Sources& sources)
{
  return Solve(mesh, dgg::ExactEngine::Triangle, sources).Distances;
}

/// Expects bounds on the mean absolute error and on the largest errors below and above, relative to
/// the distance.
void ExpectNear(const std::vector<double>& actual, const std::vector<double>& exact, double mean,
  double below, double above)
{
  const Errors errors = Compare(actual, exact);
  EXPECT_LT(errors.Mean, mean);
  for (std::size_t v = 0; v < exact.size(); ++v)
  {
    if (exact[v] > 0.0 && exact[v] < dgg::Infinity)
    {
      ASSERT_GT(actual[v] / exact[v] - 1.0, -below) << v;
      ASSERT_LT(actual[v] / exact[v] - 1.0, above) << v;
    }
  }
}

void ExpectSameBits(const dgg::PropagationResult& a, const dgg::PropagationResult& b)
{
  EXPECT_EQ(a.Distances, b.Distances);
  EXPECT_EQ(a.NearestSource, b.NearestSource);
  EXPECT_EQ(a.Virtual, b.Virtual);
}
}

TEST_P(SourcePropagation, ExactInThePlane)
{
  TestMesh flattened = Plane(24, 24, 0.25, 4);
  for (std::size_t i = 1; i < flattened.Points.size(); i += 3)
  {
    flattened.Points[i] *= 0.05;
  }
  for (const NamedMesh& named :
    { NamedMesh{ "irregular", Plane(30, 20, 0.25, 3) }, NamedMesh{ "grid", Plane(30, 20) },
      NamedMesh{ "large grid", Plane(100, 100) }, NamedMesh{ "flattened", flattened },
      NamedMesh{ "refined", RandomlyRefined(Plane(8, 8, 0.2, 5), 300, 6, 1e-3) },
      NamedMesh{ "slivers", SliverPlane(16, 0.01) }, NamedMesh{ "needles", NeedlePlane(16, 0.01) },
      NamedMesh{ "caps", CapPlane(16, 0.1) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id source : SomeVertices(mesh, 8, 3))
    {
      const Errors errors =
        Compare(this->From(mesh, source), EuclideanDistances(named.Mesh, source));
      // Along the rim of thin triangles, the propagation may not see the source.
      const bool isThin = named.Name == "caps" || named.Name == "slivers";
      EXPECT_LT(errors.Largest, isThin ? 0.005 : 1e-5) << source;
      EXPECT_LT(errors.Mean, isThin ? 1e-4 : 1e-6) << source;
    }
  }
}

TEST_P(SourcePropagation, CloseToExact)
{
  struct Case
  {
    std::string Name;
    TestMesh Mesh;
    double Mean;
    double Above;
    double Below = 0.05;
  };
  // An ear has two edges on the rim, and the only neighbors of its tip are the ends of the third
  // edge.
  TestMesh ears = Plane(3, 3);
  ears.AddTriangle(1, ears.AddPoint(1.5, -2.0, 0.0), 2);
  std::vector<bool> isLower;
  std::vector<Id> sheetOf;
  Id unused = 0;
  const auto isInHole = [](Id i, Id j) { return std::abs(i - 12) <= 4 && std::abs(j - 12) <= 4; };
  const Case cases[] = { { "notch",
                           Plate(
                             20, 20, [](Id i, Id j) { return i < 10 || j < 10; }, 0.2, 3),
                           0.005, 0.05 },
    { "hole",
      Plate(
        24, 24, [&](Id i, Id j) { return !isInHole(i, j); }, 0.2),
      0.005, 0.05 },
    { "slit", SlitPlane(12, isLower, 0.2), 0.005, 0.05 }, { "ears", ears, 0.01, 0.02 },
    { "sphere", Icosphere(4), 0.005, 0.1 }, { "noisy sphere", NoisySphere(4, 0.1, 3), 0.005, 0.1 },
    { "torus", Torus(80, 40), 0.005, 0.1 }, { "terrain", Terrain(40, 0.3, 5), 0.005, 0.1 },
    { "long", Ellipsoid(4, 5.0), 0.005, 0.1 }, { "shaft", Shaft(100), 0.02, 0.05, 0.1 },
    { "two holes", Subdivided(TwoHoledBlock(), 4), 0.005, 0.1 },
    { "Moebius", MoebiusStrip(24, 8), 0.005, 0.05 }, { "pinched", PinchedPlates(4), 0.01, 0.1 },
    { "spheres", TouchingSpheres(3), 0.01, 0.1 }, { "book", Book(4, 8, sheetOf, 0.2), 0.01, 0.1 },
    { "wide book", Book(20, 6, sheetOf, 0.2), 0.01, 0.1 },
    { "fin", PlaneWithFin(8, unused, 0.2, 4), 0.01, 0.1 },
    { "duplicates", DuplicateFaceCube(6), 0.01, 0.1 },
    { "misoriented", MisorientedSphere(3, 8), 0.01, 0.1 },
    { "components", SeveralComponents(), 0.01, 0.1 } };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.Name);
    const dgg::SurfaceMesh mesh = Build(c.Mesh);
    Sources sources;
    for (const Id v : SomeVertices(mesh, 6, 3))
    {
      sources.push_back(VertexSource(v));
    }
    if (c.Name.find("sphere") != std::string::npos || c.Name == "torus" || c.Name == "terrain")
    {
      for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 4, 8))
      {
        sources.push_back({ point, 0.25 });
      }
    }
    for (const dgg::GeodesicSource& source : sources)
    {
      ExpectNear(
        this->Run(mesh, { source }).Distances, Exact(mesh, { source }), c.Mean, c.Below, c.Above);
    }
  }
}

/// Distances are bounded by the edge graph, although faces store one virtual source and have
/// corners nearest to other sources.
TEST_P(SourcePropagation, NoLongerThanAlongEdges)
{
  // The short side of a needle is nearest to another source than the rest of the needle.
  TestMesh needles = Plane(1, 1);
  needles.Points = { 0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 10.0, 0.2, 0.0, 0.0, 0.2, 0.0 };
  TestMesh flattened = Terrain(24, 0.3, 4);
  for (std::size_t i = 1; i < flattened.Points.size(); i += 3)
  {
    flattened.Points[i] *= 0.02;
  }
  for (const NamedMesh& named :
    { NamedMesh{ "two needles", needles }, NamedMesh{ "needles", NeedlePlane(16, 0.01) },
      NamedMesh{ "slivers", SliverPlane(16, 0.01) }, NamedMesh{ "flattened", flattened },
      NamedMesh{ "block", Subdivided(TwoHoledBlock(), 2) }, NamedMesh{ "book", PinchedPlates(4) },
      NamedMesh{ "sphere", NoisySphere(3, 0.3, 3) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id step : { 2, 3, 8, 1000 })
    {
      Sources sources;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); v += step)
      {
        sources.push_back(VertexSource(v, 0.01 * (v % 7)));
      }
      const std::vector<double> bound = EdgeGraphDistances(mesh, sources);
      const std::vector<double> distances = this->Run(mesh, sources).Distances;
      for (std::size_t v = 0; v < bound.size(); ++v)
      {
        ASSERT_LE(distances[v], bound[v] + 1e-5 * LargestFinite(bound)) << step << " " << v;
      }
    }
  }
}

/// Many sources, two of them in one face: as accurate as a single source, except in long triangles,
/// each of which is nearest to several sources. The nearest source is nearly always correct.
TEST_P(SourcePropagation, ManySources)
{
  TestMesh stretched = Terrain(30, 0.3, 4);
  for (std::size_t i = 0; i < stretched.Points.size(); i += 3)
  {
    stretched.Points[i] *= 8.0;
  }
  for (const NamedMesh& named : { NamedMesh{ "sphere", NoisySphere(4, 0.1, 3) },
         NamedMesh{ "stretched", stretched }, NamedMesh{ "pinched", PinchedPlates(6) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    Sources sources;
    for (const Id v : SomeVertices(mesh, 20, 5))
    {
      sources.push_back(VertexSource(v));
    }
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 20, 8))
    {
      sources.push_back({ point, 0.0 });
    }
    const Id f = mesh.GetNumberOfFaces() / 2;
    sources.push_back({ dgg::SurfacePoint::InFace(mesh, f, { { 0.2, 0.3, 0.5 } }), 0.0 });
    sources.push_back({ dgg::SurfacePoint::InFace(mesh, f, { { 0.5, 0.4, 0.1 } }), 0.0 });
    const std::vector<double> exact = Exact(mesh, sources);
    const dgg::PropagationResult result = this->Run(mesh, sources);
    const bool isLong = named.Name == "stretched";
    ExpectNear(result.Distances, exact, isLong ? 0.04 : 0.005, 0.05, isLong ? 1.5 : 0.3);
    std::vector<std::vector<double>> single;
    for (const dgg::GeodesicSource& source : sources)
    {
      single.push_back(Exact(mesh, { source }));
    }
    std::size_t wrong = 0;
    for (std::size_t v = 0; v < exact.size(); ++v)
    {
      const double found = single[result.NearestSource[v]][v];
      wrong += found > 1.02 * exact[v] + 1e-9 ? 1 : 0;
      EXPECT_LE(found, (isLong ? 2.5 : 1.3) * exact[v] + 1e-9) << v;
      EXPECT_NEAR(result.Virtual[v].Offset + result.Virtual[v].Length, result.Distances[v], 1e-9);
      EXPECT_GE(result.Virtual[v].Offset, -1e-4) << v;
    }
    EXPECT_LE(wrong, (isLong ? 0.04 : 0.015) * exact.size());
  }
}

/// The distance of a source is its initial distance, or the distance from another source that is
/// nearer.
TEST_P(SourcePropagation, SourcesAreExact)
{
  const dgg::SurfaceMesh mesh = Build(Plane(10, 10));
  Sources sources{ VertexSource(60), VertexSource(5, 0.4000035), VertexSource(5, 0.4) };
  dgg::PropagationResult result = this->Run(mesh, sources);
  EXPECT_EQ(result.Distances[5], 0.4);
  EXPECT_EQ(result.NearestSource[5], 2);
  sources.resize(1);
  for (int i = 300; i > 0; --i)
  {
    sources.push_back(VertexSource(5, 0.4 + 3.5e-6 * i));
  }
  result = this->Run(mesh, sources);
  EXPECT_EQ(result.Distances[5], 0.4 + 3.5e-6);
  EXPECT_EQ(result.NearestSource[5], 300);
}

TEST_P(SourcePropagation, MaximumDistance)
{
  for (const TestMesh& test : { Plane(20, 20, 0.2, 3), NoisySphere(3, 0.3, 4), Torus(40, 20) })
  {
    const dgg::SurfaceMesh mesh = Build(test);
    const Sources sources{ VertexSource(7, 0.5), VertexSource(40) };
    const dgg::PropagationResult whole = this->Run(mesh, sources);
    for (const double part : { 0.0, 0.1, 0.5, 0.9, 1.0 })
    {
      const double limit = part * LargestFinite(whole.Distances);
      const auto within = this->Run(mesh, sources, [&](auto& o) { o.MaximumDistance = limit; });
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const bool isWithin = whole.Distances[v] <= limit;
        ASSERT_EQ(within.Distances[v], isWithin ? whole.Distances[v] : dgg::Infinity) << v;
        ASSERT_EQ(within.NearestSource[v], isWithin ? whole.NearestSource[v] : dgg::NoId) << v;
      }
    }
    // No point is reached before the first source starts.
    const auto none = this->Run(mesh, sources, [&](auto& o) { o.MaximumDistance = -1.0; });
    EXPECT_EQ(LargestFinite(none.Distances), 0.0);
    EXPECT_EQ(none.NearestSource[40], dgg::NoId);
  }
}

TEST_P(SourcePropagation, SameBitsInAnyThreads)
{
  const TestMesh lattice = VoxelSurface(6, 6, 6, [](Id i, Id j, Id k) { return (i + j + k) % 2; });
  for (const TestMesh& test :
    { Plane(150, 150), NoisySphere(5, 0.3, 3), Subdivided(lattice, 4), WeldedPlates(9, 90, 90, 3) })
  {
    const dgg::SurfaceMesh mesh = Build(test);
    Sources sources{ VertexSource(0), VertexSource(100), VertexSource(200, 0.5) };
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 300, 8))
    {
      sources.push_back({ point, 0.0 });
    }
    const auto expected = this->Run(mesh, sources);
    const auto single = this->Run(mesh, { sources[0] });
    for (const int threads : { 1, 2, 3, 8 })
    {
      SCOPED_TRACE(threads);
      const auto parallel = [&](auto& o) { o.Parallel = WithThreads(threads); };
      ExpectSameBits(expected, this->Run(mesh, sources, parallel));
      ExpectSameBits(single, this->Run(mesh, { sources[0] }, parallel));
    }
  }
}

}
