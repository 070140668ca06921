// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SearchChecks.h"

#include "TestMeshes.h"

namespace dggtest
{
using dgg::GraphConstruction;

const std::vector<dgg::SearchMethod> AllMethods{ dgg::SearchMethod::Dijkstra,
  dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Certified };

SearchCase::SearchCase(
  const std::string& name, const TestMesh& mesh, double accuracy, GraphConstruction construction)
  : Name(
      name + " " + std::to_string(accuracy) + " " + std::to_string(static_cast<int>(construction)))
  , Points(mesh)
  , Mesh(Build(mesh))
  , Graph(BuildGraph(this->Mesh, accuracy, construction))
  , Search(std::make_unique<dgg::GraphSearch>(this->Graph.View(), &this->Mesh))
{
}

dgg::SearchResult SearchCase::Run(const std::vector<dgg::GraphSeed>& seeds,
  const std::function<void(dgg::SearchOptions&)>& change) const
{
  dgg::SearchOptions options;
  if (change)
  {
    change(options);
  }
  dgg::SearchResult result;
  const dgg::Status status = this->Search->Run(seeds, options, result);
  EXPECT_TRUE(status.IsOk()) << this->Name << ": " << status.GetMessage();
  return result;
}

std::vector<std::unique_ptr<SearchCase>> SearchCases()
{
  std::vector<std::unique_ptr<SearchCase>> cases;
  for (const NamedMesh& named : SoundMeshes())
  {
    for (double accuracy : { 0.1, 0.01 })
    {
      cases.push_back(std::make_unique<SearchCase>(named.Name, named.Mesh, accuracy));
    }
  }
  for (const NamedMesh& named : DefectMeshes())
  {
    cases.push_back(std::make_unique<SearchCase>(named.Name, named.Mesh, 0.02));
  }
  const TestMesh rough = NoisySphere(3, 0.3, 5);
  cases.push_back(std::make_unique<SearchCase>("wide lengths", rough, 1e-6));
  for (GraphConstruction construction : { GraphConstruction::OneRelay, GraphConstruction::Indirect,
         GraphConstruction::SaddleVertexGraph })
  {
    cases.push_back(std::make_unique<SearchCase>("rough", rough, 0.01, construction));
  }
  return cases;
}

dgg::GraphSeed SeedAt(Id vertex, double distance, Id source)
{
  return { vertex, distance, 0.0, source, -1.0 };
}

std::vector<dgg::GraphSeed> RandomSeeds(Id numberOfVertices, Id count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<dgg::GraphSeed> seeds;
  for (Id i = 0; i < count; ++i)
  {
    seeds.push_back(SeedAt(random.Index(numberOfVertices), random.Uniform(-0.4, 0.2), i));
  }
  seeds.push_back(seeds.front());
  seeds.back().Distance -= 0.05;
  return seeds;
}

std::vector<dgg::GraphSeed> SeedsOf(
  const dgg::GraphBuilder& builder, const dgg::SurfacePoint& point, double accuracy, double offset)
{
  std::vector<dgg::GraphLink> links;
  std::vector<double> direct;
  EXPECT_TRUE(Ok(builder.Link(point, accuracy, {}, links, direct)));
  std::vector<dgg::GraphSeed> seeds;
  for (const dgg::GraphLink& link : links)
  {
    seeds.push_back({ link.Vertex, offset + link.Length, offset, 0, link.ArrivalAngle });
  }
  return seeds;
}

dgg::GraphView AsCloud(dgg::GraphView graph)
{
  graph.Info.Kind = dgg::GraphKind::Cloud;
  graph.Angles = nullptr;
  graph.ArrivalAngles = nullptr;
  return graph;
}

std::vector<double> ReferenceDistances(
  const dgg::GraphView& graph, const std::vector<dgg::GraphSeed>& seeds)
{
  std::vector<std::pair<Id, double>> sources;
  for (const dgg::GraphSeed& seed : seeds)
  {
    sources.emplace_back(seed.Vertex, seed.Distance);
  }
  return GraphDistances(graph, sources);
}

std::vector<Id> FindSmallestTails(const dgg::GraphView& graph, const std::vector<double>& distances)
{
  std::vector<Id> tails(distances.size(), dgg::NoId);
  for (Id u = 0; u < graph.NumberOfVertices; ++u)
  {
    for (dgg::Offset e = graph.Offsets[u]; e < graph.Offsets[u + 1]; ++e)
    {
      const Id v = graph.Targets[e];
      const bool isShortest = distances[v] < dgg::Infinity && distances[u] < distances[v] &&
        distances[u] + graph.Length(e) == distances[v];
      tails[v] = isShortest && tails[v] == dgg::NoId ? u : tails[v];
    }
  }
  return tails;
}

void ExpectSameDistances(
  const std::vector<double>& expected, const std::vector<double>& actual, const std::string& what)
{
  ASSERT_EQ(expected.size(), actual.size()) << what;
  for (std::size_t v = 0; v < expected.size(); ++v)
  {
    ASSERT_EQ(expected[v], actual[v]) << what << ": vertex " << v;
  }
}

void ExpectConsistentTree(const dgg::GraphView& graph, const std::vector<dgg::GraphSeed>& seeds,
  const dgg::SearchResult& result, const std::string& what)
{
  const auto n = static_cast<std::size_t>(graph.NumberOfVertices);
  ASSERT_EQ(result.Distances.size(), n) << what;
  ASSERT_EQ(result.Seeds.size(), n) << what;
  ASSERT_EQ(result.Edges.size(), n) << what;
  ASSERT_EQ(result.Tails.size(), n) << what;
  const std::vector<Id> tails = FindSmallestTails(graph, result.Distances);
  for (std::size_t v = 0; v < n; ++v)
  {
    const Id seed = result.Seeds[v];
    const dgg::Offset edge = result.Edges[v];
    if (result.Distances[v] == dgg::Infinity)
    {
      ASSERT_EQ(seed, dgg::NoId) << what;
      ASSERT_EQ(edge, -1) << what;
      ASSERT_EQ(result.Tails[v], dgg::NoId) << what;
      continue;
    }
    ASSERT_GE(seed, 0) << what;
    ASSERT_LT(seed, static_cast<Id>(seeds.size())) << what;
    if (edge < 0)
    {
      ASSERT_EQ(result.Tails[v], dgg::NoId) << what;
      ASSERT_EQ(seeds[seed].Vertex, static_cast<Id>(v)) << what;
      ASSERT_EQ(seeds[seed].Distance, result.Distances[v]) << what;
      continue;
    }
    const Id tail = result.Tails[v];
    ASSERT_EQ(tail, tails[v]) << what << ": vertex " << v;
    ASSERT_GE(edge, graph.Offsets[tail]) << what;
    ASSERT_LT(edge, graph.Offsets[tail + 1]) << what;
    ASSERT_EQ(graph.Targets[edge], static_cast<Id>(v)) << what;
    ASSERT_EQ(result.Seeds[tail], seed) << what;
    // The tail is strictly closer than the vertex, so the tree has no cycles.
    ASSERT_LT(result.Distances[tail], result.Distances[v]) << what;
    ASSERT_EQ(result.Distances[tail] + graph.Length(edge), result.Distances[v]) << what;
  }
}

std::string MethodName(dgg::SearchMethod method)
{
  switch (method)
  {
    case dgg::SearchMethod::Dijkstra:
      return "Dijkstra";
    case dgg::SearchMethod::LabelCorrecting:
      return "LabelCorrecting";
    case dgg::SearchMethod::Certified:
      break;
  }
  return "Certified";
}
}
