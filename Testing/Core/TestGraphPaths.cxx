// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths between two points in a graph, and the heuristics that guide the search.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggBucketSearch.h"
#include "dggFaceEnvelope.h"
#include "dggGraphBuilder.h"
#include "dggGraphFans.h"
#include "dggGraphSearch.h"
#include "dggLandmarks.h"
#include "dggSourceFinding.h"
#include "dggTurnLimits.h"

namespace dggtest
{
namespace
{
using dgg::GraphPath;
using dgg::GraphSeed;
using dgg::Offset;
using Seeds = std::vector<GraphSeed>;

/// Returns the positions of the points; null for meshes given by lengths alone and for mollified
/// meshes.
const double* PositionsOf(const SearchCase& c)
{
  const bool isEmbedded = c.GetMesh().GetMollification() == 0.0 && !c.GetPoints().Points.empty();
  return isEmbedded ? c.GetPoints().Points.data() : nullptr;
}

double ExpectedLength(const SearchCase& c, const Seeds& from, const Seeds& to)
{
  const std::vector<double> distances = ReferenceDistances(c.GetGraph(), from);
  double length = dgg::Infinity;
  for (const GraphSeed& seed : to)
  {
    length = std::min(length, distances[seed.Vertex] + seed.Distance);
  }
  return length;
}

/// Expects a path to connect the two sets of seeds and to have the reported length.
void ExpectPath(
  const dgg::GraphView& graph, const Seeds& from, const Seeds& to, const GraphPath& path)
{
  if (path.Length == dgg::Infinity)
  {
    EXPECT_TRUE(path.Vertices.empty());
    EXPECT_TRUE(path.Edges.empty());
    EXPECT_EQ(path.FromSeed, dgg::NoId);
    EXPECT_EQ(path.ToSeed, dgg::NoId);
    return;
  }
  ASSERT_EQ(path.Vertices.size(), path.Edges.size() + 1);
  ASSERT_GE(path.FromSeed, 0);
  ASSERT_LT(path.FromSeed, static_cast<Id>(from.size()));
  ASSERT_GE(path.ToSeed, 0);
  ASSERT_LT(path.ToSeed, static_cast<Id>(to.size()));
  EXPECT_EQ(path.Vertices.front(), from[path.FromSeed].Vertex);
  EXPECT_EQ(path.Vertices.back(), to[path.ToSeed].Vertex);
  double length = from[path.FromSeed].Distance;
  double largest = std::abs(length);
  for (std::size_t i = 0; i < path.Edges.size(); ++i)
  {
    const Offset e = path.Edges[i];
    ASSERT_GE(e, graph.Offsets[path.Vertices[i]]);
    ASSERT_LT(e, graph.Offsets[path.Vertices[i] + 1]);
    ASSERT_EQ(graph.Targets[e], path.Vertices[i + 1]);
    length += graph.Length(e);
    largest = std::max(largest, std::abs(length));
  }
  length += to[path.ToSeed].Distance;
  EXPECT_NEAR(length, path.Length, 1e-12 * std::max(largest, std::abs(length)));
}

void ExpectShortest(
  const SearchCase& c, const Seeds& from, const Seeds& to, double expected, const double* positions)
{
  GraphPath path;
  ASSERT_TRUE(c.GetSearch().Between(from, to, positions, path).IsOk());
  ExpectPath(c.GetGraph(), from, to, path);
  if (expected == dgg::Infinity)
  {
    EXPECT_EQ(path.Length, dgg::Infinity);
    return;
  }
  // Offsets that cancel leave the rounding error of the offsets.
  EXPECT_NEAR(path.Length, expected, 1e-12 * (1.0 + std::abs(expected)));
}

/// Runs the search with and without all heuristics.
void ExpectShortest(SearchCase& c, const std::vector<std::pair<Seeds, Seeds>>& pairs)
{
  std::vector<double> expected;
  expected.reserve(pairs.size());
  for (const auto& pair : pairs)
  {
    expected.push_back(ExpectedLength(c, pair.first, pair.second));
  }
  for (const bool withLandmarks : { false, true })
  {
    ASSERT_TRUE(!withLandmarks || c.GetSearch().PrepareLandmarks(nullptr, nullptr).IsOk());
    EXPECT_EQ(c.GetSearch().HasLandmarks(), withLandmarks);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      SCOPED_TRACE(c.GetName() + ", pair " + std::to_string(i));
      ExpectShortest(c, pairs[i].first, pairs[i].second, expected[i], nullptr);
      ExpectShortest(c, pairs[i].first, pairs[i].second, expected[i], PositionsOf(c));
      // Graphs are symmetric: the reverse path has the same length.
      ExpectShortest(c, pairs[i].second, pairs[i].first, expected[i], PositionsOf(c));
    }
  }
}

/// Returns the vertices of the path in the search tree that ends, of equally near seeds, at the
/// smallest vertex.
std::vector<Id> FindTreePath(const dgg::GraphView& graph, const Seeds& from, const Seeds& to)
{
  const std::vector<double> distances = ReferenceDistances(graph, from);
  const std::vector<Id> tails = FindSmallestTails(graph, distances);
  const auto order = [&](const GraphSeed& seed) {
    return std::make_pair(distances[seed.Vertex] + seed.Distance, seed.Vertex);
  };
  std::vector<Id> path{ std::min_element(
    to.begin(), to.end(), [&](const GraphSeed& a, const GraphSeed& b) {
      return order(a) < order(b);
    })->Vertex };
  const auto isStart = [&](const GraphSeed& seed) {
    return seed.Vertex == path.back() && seed.Distance == distances[seed.Vertex];
  };
  while (std::none_of(from.begin(), from.end(), isStart))
  {
    path.push_back(tails[path.back()]);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

dgg::Landmarks LandmarksOf(const SearchCase& c)
{
  const dgg::GraphView graph = c.GetGraph();
  dgg::Landmarks marks;
  EXPECT_TRUE(marks.Choose(graph, &c.GetMesh(), nullptr).IsOk());
  for (std::size_t k = 0; k < marks.GetVertices().size(); ++k)
  {
    marks.SetDistances(k, ReferenceDistances(graph, { SeedAt(marks.GetVertices()[k]) }).data());
  }
  return marks;
}
}

TEST(GraphPaths, AgreeWithDijkstra)
{
  for (const auto& c : SearchCases())
  {
    const Id n = c->GetNumberOfVertices();
    Random random(3);
    std::vector<std::pair<Seeds, Seeds>> pairs{ { { SeedAt(n / 2) }, { SeedAt(n / 2) } } };
    for (std::uint64_t trial = 0; trial < 6; ++trial)
    {
      pairs.push_back({ { SeedAt(random.Index(n)) }, { SeedAt(random.Index(n)) } });
      pairs.emplace_back(
        RandomSeeds(n, 1 + trial % 4, 2 * trial + 1), RandomSeeds(n, 1 + trial % 3, 2 * trial + 2));
    }
    ExpectShortest(*c, pairs);
  }
}

TEST(GraphPaths, PointsInFacesAgreeWithDijkstra)
{
  for (const double accuracy : { 0.1, 0.01 })
  {
    SearchCase c("rough", NoisySphere(4, 0.25, 4), accuracy);
    const dgg::GraphBuilder builder(c.GetMesh());
    std::vector<Seeds> points;
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(c.GetMesh(), 20, 7))
    {
      points.push_back(SeedsOf(builder, point, accuracy));
    }
    std::vector<std::pair<Seeds, Seeds>> pairs;
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    {
      pairs.emplace_back(points[i], points[i + 1]);
    }
    ExpectShortest(c, pairs);
  }
}

/// Of equally short paths, of which a grid has many, the path of the search tree is found with and
/// without each of the guides.
TEST(GraphPaths, OfEqualLengthAreThoseOfTheTree)
{
  SearchCase c("grid", Plane(16, 12), 0.3);
  const Id n = c.GetNumberOfVertices();
  Random random(11);
  std::vector<std::pair<Seeds, Seeds>> pairs{ { { SeedAt(n / 2) },
    { SeedAt(n - 1), SeedAt(16), SeedAt(n - 17), SeedAt(0) } } };
  for (int i = 0; i < 100; ++i)
  {
    pairs.push_back({ { SeedAt(random.Index(n)) }, { SeedAt(random.Index(n)) } });
    pairs.push_back({ { SeedAt(random.Index(n)), SeedAt(random.Index(n), 1.0) },
      { SeedAt(random.Index(n), 1.0), SeedAt(random.Index(n)) } });
  }
  for (const bool withLandmarks : { false, true })
  {
    ASSERT_TRUE(!withLandmarks || c.GetSearch().PrepareLandmarks(nullptr, nullptr).IsOk());
    for (const double* positions : { PositionsOf(c), static_cast<const double*>(nullptr) })
    {
      for (const auto& [from, to] : pairs)
      {
        GraphPath path;
        ASSERT_TRUE(c.GetSearch().Between(from, to, positions, path).IsOk());
        ExpectPath(c.GetGraph(), from, to, path);
        EXPECT_EQ(path.Vertices, FindTreePath(c.GetGraph(), from, to))
          << (withLandmarks ? "with landmarks" : "") << (positions ? ", with positions" : "");
      }
    }
  }
}

/// Without reverse edges, any of several shortest paths is found.
TEST(GraphPaths, InADirectedGraph)
{
  const dgg::Offset offsets[] = { 0, 2, 2, 2 };
  const Id targets[] = { 2, 1 };
  const float lengths[] = { 1.0F, 1.0F };
  dgg::GraphView graph;
  graph.NumberOfVertices = 3;
  graph.Offsets = offsets;
  graph.Targets = targets;
  graph.Lengths = lengths;
  const Seeds from{ SeedAt(0) };
  const Seeds to{ SeedAt(1), SeedAt(2) };
  GraphPath path;
  ASSERT_TRUE(dgg::GraphSearch(graph, nullptr).Between(from, to, nullptr, path).IsOk());
  ExpectPath(graph, from, to, path);
}

TEST(GraphPaths, BetweenComponentsThereAreNone)
{
  SearchCase c("components", SeveralComponents(), 0.05);
  const Id n = c.GetNumberOfVertices();
  const std::vector<double> reached = ReferenceDistances(c.GetGraph(), { SeedAt(0) });
  const auto other =
    static_cast<Id>(std::find(reached.begin(), reached.end(), dgg::Infinity) - reached.begin());
  ASSERT_LT(other, n);
  // The nearest end may be in any component.
  ExpectShortest(c,
    { { { SeedAt(0) }, { SeedAt(other) } }, { { SeedAt(other), SeedAt(0, 9.0) }, { SeedAt(1) } },
      { { SeedAt(2) }, { SeedAt(other, -100.0), SeedAt(3) } },
      { { SeedAt(2), SeedAt(other) }, { SeedAt(other + 1, 5.0), SeedAt(3) } } });
}

TEST(GraphPaths, InCloudsAgreeWithDijkstra)
{
  const SearchCase c("sphere", NoisySphere(3, 0.2, 2), 0.05);
  const dgg::GraphView cloud = AsCloud(c.GetGraph());
  dgg::GraphSearch search(cloud, nullptr);
  const std::vector<double> expected = ReferenceDistances(cloud, { SeedAt(5) });
  for (const bool withLandmarks : { false, true })
  {
    ASSERT_TRUE(!withLandmarks || search.PrepareLandmarks(nullptr, nullptr).IsOk());
    for (Id v = 0; v < cloud.NumberOfVertices; v += 7)
    {
      for (const double* positions : { PositionsOf(c), static_cast<const double*>(nullptr) })
      {
        GraphPath path;
        ASSERT_TRUE(search.Between({ SeedAt(5) }, { SeedAt(v) }, positions, path).IsOk());
        ExpectPath(cloud, { SeedAt(5) }, { SeedAt(v) }, path);
        EXPECT_NEAR(path.Length, expected[v], 1e-12);
      }
    }
  }
}

TEST(GraphPaths, OverTheShorterOfTwoEdges)
{
  // Duplicate edges between the same vertices: no builder creates such rows, but arrays of other
  // origin may contain them.
  for (const bool isShorterFirst : { false, true })
  {
    const float first = isShorterFirst ? 1.0f : 2.0f;
    const Offset offsets[] = { 0, 2, 5, 6 };
    const Id targets[] = { 1, 1, 0, 0, 2, 1 };
    const float lengths[] = { first, 3.0f - first, first, 3.0f - first, 1.0f, 1.0f };
    dgg::GraphView graph;
    graph.NumberOfVertices = 3;
    graph.Offsets = offsets;
    graph.Targets = targets;
    graph.Lengths = lengths;
    const dgg::GraphSearch search(graph, nullptr);
    GraphPath path;
    ASSERT_TRUE(search.Between({ SeedAt(0) }, { SeedAt(2) }, nullptr, path).IsOk());
    EXPECT_EQ(path.Length, 2.0);
    EXPECT_EQ(path.Edges, (std::vector<Offset>{ isShorterFirst ? 0 : 1, 4 }));
  }
}

TEST(GraphPaths, LargeOffsetsAndScales)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    SearchCase c("scaled", Scaled(Terrain(12, 0.4, 2), scale), 0.02);
    const Id n = c.GetNumberOfVertices();
    const Seeds from{ SeedAt(0, 1e3 * scale), SeedAt(n / 2, 1e3 * scale) };
    const Seeds to{ SeedAt(n - 1, -1e3 * scale), SeedAt(n / 3, -1e3 * scale) };
    const double expected = ExpectedLength(c, from, to);
    for (const bool withLandmarks : { false, true })
    {
      ASSERT_TRUE(!withLandmarks || c.GetSearch().PrepareLandmarks(nullptr, nullptr).IsOk());
      GraphPath path;
      ASSERT_TRUE(c.GetSearch().Between(from, to, PositionsOf(c), path).IsOk());
      ExpectPath(c.GetGraph(), from, to, path);
      EXPECT_NEAR(path.Length, expected, 1e-11 * 1e3 * scale);
    }
    GraphPath path;
    const Seeds huge{ SeedAt(1, 1e300) };
    ASSERT_TRUE(c.GetSearch().Between(huge, to, PositionsOf(c), path).IsOk());
    EXPECT_EQ(path.Length, 1e300);
    ExpectPath(c.GetGraph(), huge, to, path);
    ASSERT_TRUE(c.GetSearch().Between(from, huge, PositionsOf(c), path).IsOk());
    EXPECT_EQ(path.Length, 1e300);
  }
}

TEST(Landmarks, BoundsAreBelowAndNear)
{
  for (const TestMesh& mesh : { NoisySphere(3, 0.2, 3), Terrain(20, 0.4, 2), Torus(40, 12),
         TwoHoledBlock(), SeveralComponents() })
  {
    const SearchCase c("bounds", mesh, 0.05);
    const Id n = c.GetNumberOfVertices();
    const dgg::Landmarks marks = LandmarksOf(c);
    EXPECT_EQ(marks.GetVertices().size(), 32u);
    double sumOfBounds = 0.0;
    double sum = 0.0;
    for (std::uint64_t trial = 0; trial < 20; ++trial)
    {
      const bool isSingle = trial < 10;
      const Seeds seeds =
        isSingle ? Seeds{ SeedAt(static_cast<Id>(trial * (n / 10))) } : RandomSeeds(n, 3, trial);
      const std::vector<double> distances = ReferenceDistances(c.GetGraph(), seeds);
      dgg::Landmarks::Goal goal;
      marks.Aim(seeds, goal);
      for (Id v = 0; v < n; ++v)
      {
        const double bound = marks.Bound(v, goal);
        ASSERT_LE(bound, distances[v] + 1e-12) << "trial " << trial;
        if (isSingle && distances[v] < dgg::Infinity)
        {
          sumOfBounds += std::max(0.0, bound);
          sum += distances[v];
        }
      }
    }
    EXPECT_GT(sumOfBounds, 0.8 * sum);
  }
}

TEST(TurnLimits, NoShortestPathTurnsMore)
{
  Offset ruledOut = 0;
  for (const NamedMesh& named : AllMeshes())
  {
    for (const double accuracy : { 0.1, 0.01 })
    {
      const SearchCase c(named.Name, named.Mesh, accuracy);
      const dgg::GraphView graph = c.GetGraph();
      const dgg::GraphFans fans(graph, c.GetMesh());
      const dgg::TurnLimits limits(graph, c.GetMesh());
      // Each path of two edges that the limits exclude is longer than the distance between its
      // ends.
      Random random(5);
      for (int trial = 0; trial < 25; ++trial)
      {
        const Id p = random.Index(graph.NumberOfVertices);
        const std::vector<double> distances = ReferenceDistances(graph, { SeedAt(p) });
        for (Offset in = graph.Offsets[p]; in < graph.Offsets[p + 1]; ++in)
        {
          const Id u = graph.Targets[in];
          std::vector<char> isAllowed(graph.Offsets[u + 1] - graph.Offsets[u], 0);
          fans.ForEachBeyond(u, graph.ArrivalAngles[in],
            limits.SmallestAngle(u, static_cast<float>(graph.Length(in))),
            [&](Offset e) { isAllowed[e - graph.Offsets[u]] = 1; });
          for (Offset e = graph.Offsets[u]; e < graph.Offsets[u + 1]; ++e)
          {
            const double length = graph.Length(in) + graph.Length(e);
            if (!isAllowed[e - graph.Offsets[u]])
            {
              ++ruledOut;
              ASSERT_LT(distances[graph.Targets[e]], length * (1.0 - 1e-7))
                << c.GetName() << ": " << p << " to " << u << " to " << graph.Targets[e];
            }
          }
        }
      }
    }
  }
  EXPECT_GT(ruledOut, 100000);
}

}

//
// Virtual sources behind the vertices of rims: distances inside long faces.

using namespace dgg;
using namespace dggtest;

namespace
{
constexpr Id HalfRim = 12;

/// Returns a plate with two round holes of radius 3, 30 apart. The only points are those of the
/// rims, so the faces between the holes are long and thin.
TestMesh PlateWithTwoHoles()
{
  const double radius = 3.0;
  const double margin = 1.0;
  const double width = 30.0 + 4.0 * radius + 2.0 * margin;
  const double height = 2.0 * (radius + margin);
  TestMesh mesh;
  const Id corners[] = { mesh.AddPoint(0.0, 0.0, 0.0), mesh.AddPoint(width, 0.0, 0.0),
    mesh.AddPoint(width, height, 0.0), mesh.AddPoint(0.0, height, 0.0) };
  // Start at the lowest point of a rim, counter-clockwise on the left, clockwise on the right: the
  // first halves face each other.
  Id left[2 * HalfRim + 1];
  Id right[2 * HalfRim + 1];
  for (Id k = 0; k < 2 * HalfRim; ++k)
  {
    const double angle = Pi * k / HalfRim;
    const double x = radius * std::sin(angle);
    const double y = 0.5 * height - radius * std::cos(angle);
    left[k] = mesh.AddPoint(margin + radius + x, y, 0.0);
    right[k] = mesh.AddPoint(width - margin - radius - x, y, 0.0);
  }
  left[2 * HalfRim] = left[0];
  right[2 * HalfRim] = right[0];
  for (Id k = 0; k < HalfRim; ++k)
  {
    mesh.AddQuad(left[k], right[k], right[k + 1], left[k + 1]);
  }
  mesh.AddQuad(corners[0], corners[1], right[0], left[0]);
  mesh.AddQuad(corners[2], corners[3], left[HalfRim], right[HalfRim]);
  const Id side = HalfRim + HalfRim / 2;
  for (Id k = HalfRim; k < 2 * HalfRim; ++k)
  {
    const bool isUpper = k < side;
    mesh.AddTriangle(corners[isUpper ? 3 : 0], left[k + 1], left[k]);
    mesh.AddTriangle(corners[isUpper ? 2 : 1], right[k], right[k + 1]);
  }
  mesh.AddTriangle(corners[3], corners[0], left[side]);
  mesh.AddTriangle(corners[1], corners[2], right[side]);
  return mesh;
}

/// Errors inside faces, relative to the largest distance.
struct FieldErrors
{
  double Sum = 0.0;
  double Largest = 0.0;

  void Add(const DistanceField& field, const DistanceField& truth)
  {
    const SurfaceMesh& mesh = *truth.Mesh;
    const double farthest =
      *std::max_element(truth.Distances, truth.Distances + mesh.GetNumberOfVertices());
    FaceEnvelope found(field);
    FaceEnvelope exact(truth);
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      found.Enter(f);
      exact.Enter(f);
      for (int i = 0; i < 5; ++i)
      {
        for (int j = 0; i + j < 5; ++j)
        {
          const Point2 p =
            exact.PlaceOf({ { (5 - i - j) / 6.0, (i + 0.5) / 6.0, (j + 0.5) / 6.0 } });
          const double error = std::abs(found.At(p) - exact.At(p)) / farthest;
          this->Sum += error;
          this->Largest = std::max(this->Largest, error);
        }
      }
    }
  }
};
}

/// If each vertex of a rim were the virtual source of the next one, the largest errors would be 13
/// and 24 % of the largest distance.
TEST(Relays, OfRimsDoNotHideTheSource)
{
  const SurfaceMesh mesh = Build(PlateWithTwoHoles());
  const GeodesicGraph graph = BuildGraph(mesh, 0.01);
  const GraphSearch search(graph.View(), &mesh);
  FieldErrors linear;
  FieldErrors ofExact;
  FieldErrors ofGraph;
  for (Id source = 0; source < mesh.GetNumberOfVertices(); ++source)
  {
    const ExactField field(mesh, { VertexSource(source) });
    GraphSeed seed;
    seed.Vertex = source;
    SearchOptions options;
    options.Correct = true;
    SearchResult result;
    ASSERT_TRUE(search.Run({ seed }, options, result).IsOk());
    VirtualSources merged;
    FindVirtualSources(mesh, result, result.Corrected, merged);
    linear.Add(field.Linear, field.Exact);
    ofExact.Add(field.Local, field.Exact);
    ofGraph.Add({ &mesh, result.Corrected.data(), nullptr, &merged }, field.Exact);
  }
  for (const FieldErrors* errors : { &ofExact, &ofGraph })
  {
    SCOPED_TRACE(errors == &ofExact ? "exact" : "graph");
    EXPECT_LT(errors->Sum, 0.25 * linear.Sum);
    EXPECT_LT(errors->Largest, 0.1);
  }
}

/// Vertices reached by straight paths over vertices of the graph have no relay and keep their
/// source.
TEST(Relays, AreNoneOnAConvexPlate)
{
  const SurfaceMesh mesh = Build(Plane(8, 8, 0.2));
  const GeodesicGraph graph = BuildGraph(mesh, 0.05);
  const GraphSearch search(graph.View(), &mesh);
  GraphSeed seed;
  seed.Vertex = 40;
  SearchOptions options;
  options.Correct = true;
  SearchResult result;
  ASSERT_TRUE(search.Run({ seed }, options, result).IsOk());
  VirtualSources found;
  FindVirtualSources(mesh, result, result.Corrected, found);
  EXPECT_EQ(found, result.Virtual);
}
