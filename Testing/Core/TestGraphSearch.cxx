// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths in graphs: comparison of all methods with an independent Dijkstra.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggBucketSearch.h"

#include <map>
#include <random>

namespace dggtest
{
namespace
{
using dgg::GraphSeed;
using dgg::SearchMethod;
using dgg::SearchOptions;
using dgg::SearchResult;

SearchResult RunMethod(const SearchCase& c, const std::vector<GraphSeed>& seeds,
  SearchMethod method, double radius = dgg::Infinity)
{
  return c.Run(seeds, [=](SearchOptions& options) {
    options.Method = method;
    options.MaximumDistance = radius;
  });
}

/// A graph with random edges, angles and small integral lengths.
class RandomGraph
{
public:
  RandomGraph(Id n, Id degree, unsigned int seed)
  {
    std::mt19937 random(seed);
    const auto draw = [&](unsigned int count) { return random() % count; };
    struct Edge
    {
      float Angle;
      Id Target;
      float Length;
      float Arrival;
    };
    std::vector<std::map<Id, Edge>> rows(n);
    for (Id k = 0; k < n * degree / 2; ++k)
    {
      const auto u = static_cast<Id>(draw(n));
      const auto v = static_cast<Id>(draw(n));
      const auto length = static_cast<float>(1 + draw(6));
      const float departure = 1e-3f * static_cast<float>(draw(6283));
      const float arrival = 1e-3f * static_cast<float>(draw(6283));
      if (u != v && rows[u].count(v) == 0)
      {
        rows[u][v] = { departure, v, length, arrival };
        rows[v][u] = { arrival, u, length, departure };
      }
    }
    for (const std::map<Id, Edge>& row : rows)
    {
      std::vector<Edge> edges;
      for (const auto& [target, edge] : row)
      {
        edges.push_back(edge);
      }
      std::sort(
        edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Angle < b.Angle; });
      for (const Edge& edge : edges)
      {
        this->Targets.push_back(edge.Target);
        this->Lengths.push_back(edge.Length);
        this->Angles.push_back(edge.Angle);
        this->ArrivalAngles.push_back(edge.Arrival);
      }
      this->Offsets.push_back(static_cast<dgg::Offset>(this->Targets.size()));
    }
  }

  dgg::GraphView View() const
  {
    dgg::GraphView view;
    view.NumberOfVertices = static_cast<Id>(this->Offsets.size()) - 1;
    view.Offsets = this->Offsets.data();
    view.Targets = this->Targets.data();
    view.Lengths = this->Lengths.data();
    view.Angles = this->Angles.data();
    view.ArrivalAngles = this->ArrivalAngles.data();
    return view;
  }

private:
  std::vector<dgg::Offset> Offsets{ 0 };
  std::vector<Id> Targets;
  std::vector<float> Lengths;
  std::vector<float> Angles;
  std::vector<float> ArrivalAngles;
};

/// Returns distances of a search over fans, which are used here for rows of any length.
std::vector<double> DistancesOverFans(const SearchCase& c, const std::vector<GraphSeed>& seeds,
  double radius, dgg::SearchEffort& effort, const std::vector<Id>* targets = nullptr)
{
  const dgg::GraphView graph = c.GetGraph();
  const dgg::GraphFans fans(graph, c.GetMesh());
  std::vector<double> distances;
  std::vector<dgg::LabelOrigin> origins;
  std::vector<Id> touched;
  dgg::SearchLabels labels(distances, origins, touched, radius);
  labels.Targets = targets;
  labels.Start(graph.NumberOfVertices, seeds);
  dgg::BucketQueue queue;
  EXPECT_TRUE(dgg::RunBucketSearch(
    graph, &fans, seeds, dgg::ChooseBucketWidth(graph), nullptr, queue, labels, effort));
  return distances;
}
}

TEST(GraphSearch, MethodsAgree)
{
  for (const auto& c : SearchCases())
  {
    const Id n = c->GetNumberOfVertices();
    for (const std::vector<GraphSeed>& seeds :
      { std::vector<GraphSeed>{ SeedAt(n / 2) }, RandomSeeds(n, 5, 7) })
    {
      const std::vector<double> expected = ReferenceDistances(c->GetGraph(), seeds);
      for (SearchMethod method : AllMethods)
      {
        const std::string what = c->GetName() + ", " + MethodName(method);
        const SearchResult result = RunMethod(*c, seeds, method);
        ExpectSameDistances(expected, result.Distances, what);
        ExpectConsistentTree(c->GetGraph(), seeds, result, what);
        EXPECT_GT(result.NumberOfPops, 0u) << what;
        EXPECT_TRUE(result.Corrected.empty()) << what;
      }
      dgg::SearchEffort effort;
      ExpectSameDistances(expected, DistancesOverFans(*c, seeds, dgg::Infinity, effort),
        c->GetName() + ", over fans");
    }
  }
}

/// Fans leave many labels too large in graphs with random lengths and angles, which have many paths
/// of equal length. The certification repairs all of them, also after new seeds.
TEST(GraphSearch, CertifiesRandomGraphs)
{
  constexpr Id n = 60;
  for (unsigned int trial = 0; trial < 400; ++trial)
  {
    const RandomGraph random(n, 12, trial);
    const dgg::GraphView graph = random.View();
    const dgg::GraphFans fans(graph, std::vector<dgg::VertexAngle>(n, { 6.2831853f, 0.0f }), 0.8);
    const std::vector<GraphSeed> seeds{ SeedAt(static_cast<Id>(trial % n), 2.0) };
    const std::vector<GraphSeed> more{ SeedAt(static_cast<Id>(7 * trial % n)) };
    std::vector<GraphSeed> all = seeds;
    all.push_back(more.front());
    SearchResult result;
    std::vector<dgg::LabelOrigin> origins;
    dgg::SearchLabels labels(result.Distances, origins, result.Reached, dgg::Infinity);
    labels.Start(n, seeds);
    dgg::BucketQueue queue;
    dgg::SearchEffort effort;
    EXPECT_TRUE(dgg::RunBucketSearch(graph, &fans, seeds, 3.0, nullptr, queue, labels, effort));
    ASSERT_EQ(result.Distances, ReferenceDistances(graph, seeds)) << trial;
    std::vector<Id> touched;
    EXPECT_TRUE(dgg::LowerLabels(graph, &fans, more, 3.0, nullptr, queue, labels, touched));
    ASSERT_EQ(result.Distances, ReferenceDistances(graph, all)) << trial;
    for (Id v = 0; v < n; ++v)
    {
      const dgg::LabelOrigin& origin = origins[v];
      ASSERT_TRUE(origin.IsSeed() ||
        result.Distances[origin.Tail] + graph.Length(origin.Edge) == result.Distances[v])
        << trial;
    }
  }
}

TEST(GraphSearch, RadiusCutsOff)
{
  for (const auto& c : SearchCases())
  {
    const std::vector<GraphSeed> seeds{ SeedAt(0), SeedAt(c->GetNumberOfVertices() / 2, 0.1) };
    const std::vector<double> all = ReferenceDistances(c->GetGraph(), seeds);
    double largest = 0.0;
    for (double d : all)
    {
      largest = std::max(largest, d == dgg::Infinity ? 0.0 : d);
    }
    for (double radius : { 0.0, 0.1, 0.45 * largest, largest, -1.0 })
    {
      std::vector<double> expected = all;
      for (double& d : expected)
      {
        d = d <= radius ? d : dgg::Infinity;
      }
      for (SearchMethod method : AllMethods)
      {
        const std::string what =
          c->GetName() + ", " + MethodName(method) + ", radius " + std::to_string(radius);
        const SearchResult result = RunMethod(*c, seeds, method, radius);
        // Vertices exactly at the radius may be included or excluded by rounding.
        for (std::size_t v = 0; v < expected.size(); ++v)
        {
          if (std::abs(all[v] - radius) < 1e-12 * largest)
          {
            expected[v] = result.Distances[v];
          }
        }
        ExpectSameDistances(expected, result.Distances, what);
        ExpectConsistentTree(c->GetGraph(), seeds, result, what);
      }
      dgg::SearchEffort effort;
      if (radius == 0.45 * largest)
      {
        ExpectSameDistances(expected, DistancesOverFans(*c, seeds, radius, effort), c->GetName());
      }
    }
  }
}

TEST(GraphSearch, LocalSearchesGiveTheSameBits)
{
  for (const auto& c : SearchCases())
  {
    const std::vector<GraphSeed> seeds = { SeedAt(c->GetNumberOfVertices() / 3) };
    const std::vector<double> all = RunMethod(*c, seeds, SearchMethod::Certified).Distances;
    dgg::SearchEffort effort;
    const std::vector<double> overFans = DistancesOverFans(*c, seeds, dgg::Infinity, effort);
    std::vector<Id> near;
    for (Id v = 0; v < c->GetNumberOfVertices(); v += 7)
    {
      if (overFans[v] < dgg::Infinity)
      {
        near.push_back(v);
      }
    }
    const auto isNearer = [&](Id a, Id b) { return overFans[a] < overFans[b]; };
    std::sort(near.begin(), near.end(), isNearer);
    near.resize(near.size() / 4 + 1);
    // A radius between two distances, because rounding decides at a distance itself.
    const double radius = (1.0 + 1e-11) * overFans[near.back()];
    const std::vector<double> bounded =
      RunMethod(*c, seeds, SearchMethod::Certified, radius).Distances;
    const std::vector<double> boundedOverFans = DistancesOverFans(*c, seeds, radius, effort);
    const std::vector<double> forTargets =
      DistancesOverFans(*c, seeds, dgg::Infinity, effort, &near);
    for (std::size_t v = 0; v < all.size(); ++v)
    {
      EXPECT_EQ(bounded[v], all[v] <= radius ? all[v] : dgg::Infinity) << c->GetName();
      if (overFans[v] <= radius)
      {
        EXPECT_EQ(boundedOverFans[v], overFans[v]) << c->GetName();
        EXPECT_EQ(forTargets[v], overFans[v]) << c->GetName();
      }
    }
  }
}

namespace
{
/// Expects the number of labels written by local searches on a plane of side * side points to be
/// proportional to the number of reached vertices.
void ExpectLocalWork(int side)
{
  const SearchCase c("plane", Plane(side, side, 0.2, 7), 0.5);
  const Id n = c.GetNumberOfVertices();
  SearchOptions options;
  options.MaximumDistance = 3.0;
  options.Correct = true;
  SearchResult used;
  std::size_t before = 0;
  for (const Id source : { n / 2, n / 4, n - 1 })
  {
    const std::vector<GraphSeed> seeds = { SeedAt(source) };
    ASSERT_TRUE(c.GetSearch().Run(seeds, options, used).IsOk());
    const auto reached = static_cast<std::size_t>(std::count_if(used.Distances.begin(),
      used.Distances.end(), [](double distance) { return distance < dgg::Infinity; }));
    EXPECT_EQ(used.Reached.size(), reached);
    EXPECT_LT(reached, 50u);
    EXPECT_EQ(used.NumberOfLabels, before + reached + (source == n / 2 ? n : 0));
    before = reached;
    SearchResult fresh;
    ASSERT_TRUE(c.GetSearch().Run(seeds, options, fresh).IsOk());
    EXPECT_EQ(fresh.Distances, used.Distances);
    EXPECT_EQ(fresh.Seeds, used.Seeds);
    EXPECT_EQ(fresh.Corrected, used.Corrected);
    EXPECT_EQ(fresh.Virtual, used.Virtual);
  }
  // Every tenth point requests its row of the matrix of all pairs within a radius.
  std::vector<std::vector<GraphSeed>> sources;
  for (Id v = 0; v < n; v += 10)
  {
    sources.push_back({ SeedAt(v) });
  }
  dgg::ManyOptions many;
  many.MaximumDistance = 3.0;
  std::size_t entries = 0;
  std::size_t labels = 0;
  const auto count = [&](std::size_t, const double*, const std::vector<Id>& reached) {
    entries += reached.size();
  };
  ASSERT_TRUE(c.GetSearch().Many(sources, many, nullptr, nullptr, count, &labels).IsOk());
  EXPECT_LE(labels, static_cast<std::size_t>(n) + 2 * entries);
  // The first source reaches only itself, which must not make tasks larger.
  sources[0][0].Distance = many.MaximumDistance;
  dgg::Offset tasks = 0;
  const dgg::ParallelFor inTasks = [&](dgg::Offset size, dgg::Offset grain, const auto& body) {
    tasks += (size + grain - 1) / grain;
    body(0, size);
  };
  ASSERT_TRUE(c.GetSearch().Many(sources, many, inTasks, nullptr, count).IsOk());
  EXPECT_GE(tasks, 8 * 64); // number of steps times tasks
  sources[0][0].Distance = 0.0;
  // Search from ten points to an adjacent point.
  sources.resize(10);
  many.MaximumDistance = dgg::Infinity;
  many.Targets = { n / 2 };
  for (Id i = 0; i < 10; ++i)
  {
    sources[i][0].Vertex = n / 2 + 1 + i % 3;
  }
  labels = 0;
  ASSERT_TRUE(c.GetSearch().Many(sources, many, nullptr, nullptr, count, &labels).IsOk());
  EXPECT_LE(labels, sources.size() * 250);
}
}

TEST(GraphSearch, LocalWork)
{
  ExpectLocalWork(100);
  ExpectLocalWork(316);
}

TEST(GraphSearch, LocalWorkOnAMillionPoints)
{
  ExpectLocalWork(1000);
}

TEST(GraphSearch, HugeAndTinyScales)
{
  // Labels far from zero, and a queue with single precision keys.
  for (double scale : { 1e-69, 1e-20, 1.0, 1e20, 1e69 })
  {
    const SearchCase c("scaled", Scaled(Terrain(8, 0.4, 5), scale), 0.02);
    for (double offset : { 0.0, 1e9 * scale, -1e9 * scale, 1e300, -1e300 })
    {
      const std::vector<GraphSeed> seeds{ SeedAt(3, offset), SeedAt(40, offset + 2.0 * scale) };
      const std::vector<double> expected = ReferenceDistances(c.GetGraph(), seeds);
      for (SearchMethod method : AllMethods)
      {
        const SearchResult result = RunMethod(c, seeds, method);
        for (std::size_t v = 0; v < expected.size(); ++v)
        {
          EXPECT_NEAR(expected[v], result.Distances[v], 1e-11 * (scale + std::abs(expected[v])));
        }
      }
    }
  }
}

TEST(GraphSearch, SourcesThatStartWithHugeDistances)
{
  // Huge initial distances exclude a source in practice.
  const SearchCase c("components", SeveralComponents(), 0.05);
  const Id n = c.GetNumberOfVertices();
  for (double huge : { 1e39, 1.7e308, std::numeric_limits<double>::max() })
  {
    const std::vector<GraphSeed> seeds{ SeedAt(0), SeedAt(1, huge), SeedAt(n / 2, huge),
      SeedAt(n - 1, huge) };
    const std::vector<double> expected = ReferenceDistances(c.GetGraph(), seeds);
    for (SearchMethod method : AllMethods)
    {
      ExpectSameDistances(expected, RunMethod(c, seeds, method).Distances, MethodName(method));
    }
  }
}

TEST(GraphSearch, VeryUnequalEdges)
{
  // A chain whose edge lengths grow by a factor of 3: no bucket width suits all of them.
  constexpr Id n = 60;
  std::vector<dgg::Offset> offsets{ 0 };
  std::vector<Id> targets;
  std::vector<double> lengths;
  for (Id v = 0; v < n; ++v)
  {
    for (Id other : { v - 1, v + 1 })
    {
      if (other >= 0 && other < n)
      {
        targets.push_back(other);
        lengths.push_back(1e-6 * std::pow(3.0, std::min(v, other)));
      }
    }
    offsets.push_back(static_cast<dgg::Offset>(targets.size()));
  }
  dgg::GraphView graph;
  graph.Info.Kind = dgg::GraphKind::Cloud;
  graph.NumberOfVertices = n;
  graph.Offsets = offsets.data();
  graph.Targets = targets.data();
  graph.WideLengths = lengths.data();
  const dgg::GraphSearch search(graph, nullptr);
  for (Id source : { 0, 30, n - 1 })
  {
    const std::vector<double> expected = ReferenceDistances(graph, { SeedAt(source) });
    for (SearchMethod method : AllMethods)
    {
      SearchOptions options;
      options.Method = method;
      options.Correct = true; // the graph has no directions
      SearchResult result;
      ASSERT_TRUE(search.Run({ SeedAt(source) }, options, result).IsOk());
      EXPECT_TRUE(result.Corrected.empty());
      for (Id v = 0; v < n; ++v)
      {
        EXPECT_NEAR(expected[v], result.Distances[v], 1e-12 * expected[v]) << MethodName(method);
      }
    }
  }
}

TEST(GraphSearch, EdgesBeyondTheRangeOfIds)
{
  // A small graph whose edges are numbered as behind six billion others, which do not exist.
  constexpr dgg::Offset first = dgg::Offset(3) << 31;
  const SearchCase c("terrain", Terrain(12, 0.5, 1), 0.05);
  dgg::GraphView graph = c.GetGraph();
  std::vector<dgg::Offset> offsets(graph.Offsets, graph.Offsets + graph.NumberOfVertices + 1);
  for (dgg::Offset& offset : offsets)
  {
    offset += first;
  }
  const auto shift = [](const auto*& values) {
    values = reinterpret_cast<std::remove_reference_t<decltype(values)>>(
      reinterpret_cast<std::uintptr_t>(values) - first * sizeof(*values));
  };
  graph.Offsets = offsets.data();
  shift(graph.Targets);
  shift(graph.Lengths);
  shift(graph.Angles);
  shift(graph.ArrivalAngles);
  const dgg::GraphSearch search(graph, &c.GetMesh());
  const std::vector<GraphSeed> seeds{ SeedAt(5) };
  for (SearchMethod method : AllMethods)
  {
    SearchOptions options;
    options.Method = method;
    options.Correct = true;
    SearchResult result;
    ASSERT_TRUE(search.Run(seeds, options, result).IsOk());
    ExpectConsistentTree(graph, seeds, result, MethodName(method));
    const SearchResult expected = c.Run(seeds, [=](SearchOptions& same) { same = options; });
    ExpectSameDistances(expected.Distances, result.Distances, MethodName(method));
    ExpectSameDistances(expected.Corrected, result.Corrected, MethodName(method));
    for (const Id v : result.Reached)
    {
      EXPECT_TRUE(result.Edges[v] == -1 || result.Edges[v] >= first);
    }
  }
  dgg::GraphPath path;
  ASSERT_TRUE(search.Between(seeds, { SeedAt(100) }, nullptr, path).IsOk());
  ASSERT_FALSE(path.Edges.empty());
  EXPECT_EQ(graph.Targets[path.Edges.back()], 100);
}
}
