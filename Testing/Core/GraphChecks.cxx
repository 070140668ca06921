// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GraphChecks.h"

#include "GeodesicChecks.h"

#include <atomic>
#include <cstring>
#include <exception>
#include <queue>
#include <stdexcept>
#include <thread>

namespace dggtest
{
namespace
{
using dgg::Offset;

template <typename T>
void ExpectSameBytes(
  const dgg::Buffer<T>& expected, const dgg::Buffer<T>& actual, const std::string& name)
{
  ASSERT_EQ(expected.Size(), actual.Size()) << name;
  if (!expected.IsEmpty())
  {
    EXPECT_EQ(std::memcmp(expected.Data(), actual.Data(), expected.Size() * sizeof(T)), 0) << name;
  }
}
}

dgg::GeodesicGraph BuildGraph(const dgg::SurfaceMesh& mesh, double accuracy,
  const std::function<void(dgg::GraphOptions&)>& change, dgg::GraphStatistics* statistics)
{
  dgg::GraphOptions options;
  options.Accuracy = accuracy;
  if (change)
  {
    change(options);
  }
  dgg::GeodesicGraph graph;
  const dgg::Status status = dgg::GraphBuilder(mesh).Build(options, graph, statistics);
  if (!status.IsOk() || graph.GetNumberOfVertices() != mesh.GetNumberOfVertices())
  {
    throw std::runtime_error("no graph: " + status.GetMessage());
  }
  ExpectWellFormed(mesh, graph.View());
  return graph;
}

dgg::GeodesicGraph BuildGraph(
  const dgg::SurfaceMesh& mesh, double accuracy, dgg::GraphConstruction construction)
{
  return BuildGraph(
    mesh, accuracy, [&](dgg::GraphOptions& options) { options.Construction = construction; });
}

std::vector<dgg::GraphConstruction> AllConstructions()
{
  return { dgg::GraphConstruction::Guaranteed, dgg::GraphConstruction::OneRelay,
    dgg::GraphConstruction::Indirect, dgg::GraphConstruction::SaddleVertexGraph };
}

double SlackOf(const dgg::SurfaceMesh& mesh)
{
  return 10.0 * mesh.GetNumberOfMollifiedFaces() * mesh.GetMollification();
}

dgg::ParallelFor WithThreads(int count, Offset size)
{
  using Body = std::function<void(Offset, Offset)>;
  return [count, size](Offset total, Offset grain, const Body& body) {
    const Offset step = size > 0 ? size : grain;
    std::atomic<Offset> next{ step };
    const auto run = [&](Offset begin) {
      for (; begin < total; begin = next.fetch_add(step))
      {
        body(begin, std::min(begin + step, total));
      }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < count; ++i)
    {
      others.emplace_back([&] { run(next.fetch_add(step)); });
    }
    std::exception_ptr thrown;
    try
    {
      run(0);
    }
    catch (...)
    {
      thrown = std::current_exception();
    }
    for (std::thread& other : others)
    {
      other.join();
    }
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

std::vector<double> GraphDistances(
  const dgg::GraphView& graph, const std::vector<std::pair<Id, double>>& sources)
{
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distances(graph.NumberOfVertices, dgg::Infinity);
  const auto reach = [&](Id v, double distance) {
    if (distance < distances[v])
    {
      distances[v] = distance;
      queue.emplace(distance, v);
    }
  };
  for (const auto& source : sources)
  {
    reach(source.first, source.second);
  }
  while (!queue.empty())
  {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.first == distances[entry.second])
    {
      for (Offset e = graph.Offsets[entry.second]; e < graph.Offsets[entry.second + 1]; ++e)
      {
        reach(graph.Targets[e], entry.first + graph.Length(e));
      }
    }
  }
  return distances;
}

std::vector<double> GraphDistances(const dgg::GraphView& graph, Id source)
{
  return GraphDistances(graph, { { source, 0.0 } });
}

void DistanceTable::SetRow(Id a, const std::vector<double>& row)
{
  ASSERT_EQ(static_cast<Id>(row.size()), this->Size);
  std::copy(
    row.begin(), row.end(), this->Values.begin() + static_cast<std::ptrdiff_t>(a) * this->Size);
}

DistanceTable ExactTable(const dgg::SurfaceMesh& mesh)
{
  DistanceTable table(mesh.GetNumberOfVertices());
  dgg::ExactGeodesics solver(mesh);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    dgg::ExactResult result;
    EXPECT_TRUE(Ok(solver.Run({ VertexSource(v) }, dgg::ExactOptions(), result)));
    table.SetRow(v, result.Distances);
  }
  return table;
}

DistanceTable GraphTable(const dgg::GraphView& graph)
{
  DistanceTable table(graph.NumberOfVertices);
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    table.SetRow(v, GraphDistances(graph, v));
  }
  return table;
}

void ExpectWithin(
  const DistanceTable& exact, const DistanceTable& approximate, double accuracy, double slack)
{
  ASSERT_EQ(exact.GetSize(), approximate.GetSize());
  std::size_t violations = 0;
  for (Id a = 0; a < exact.GetSize(); ++a)
  {
    for (Id b = 0; b < exact.GetSize(); ++b)
    {
      const double d = exact(a, b);
      const double dg = approximate(a, b);
      const bool holds = d == dgg::Infinity
        ? dg == dgg::Infinity
        : dg >= d * (1.0 - 1e-9) - slack && dg <= (1.0 + accuracy) * (d + slack) * (1.0 + 1e-6);
      if (!holds && ++violations == 1)
      {
        ADD_FAILURE() << "accuracy " << accuracy << ", from " << a << " to " << b << ": exact " << d
                      << ", got " << dg << ", relative error " << dg / d - 1.0;
      }
    }
  }
  EXPECT_EQ(violations, 0u) << "accuracy " << accuracy;
}

RelativeError MeasureError(const DistanceTable& exact, const DistanceTable& approximate)
{
  RelativeError error;
  std::size_t count = 0;
  for (Id a = 0; a < exact.GetSize(); ++a)
  {
    for (Id b = 0; b < exact.GetSize(); ++b)
    {
      if (exact(a, b) > 0.0 && exact(a, b) < dgg::Infinity)
      {
        const double relative = approximate(a, b) / exact(a, b) - 1.0;
        error.Largest = std::max(error.Largest, relative);
        error.Mean += relative;
        ++count;
      }
    }
  }
  error.Mean /= static_cast<double>(std::max<std::size_t>(1, count));
  return error;
}

void ExpectWellFormed(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph)
{
  EXPECT_TRUE(Ok(dgg::CheckGraph(graph, graph.GetNumberOfEdges())));
  std::size_t oneWay = 0;
  std::size_t unequal = 0;
  std::size_t repeated = 0;
  std::size_t beyond = 0;
  std::vector<Id> seenFrom(graph.NumberOfVertices, dgg::NoId);
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      const Id target = graph.Targets[e];
      repeated += seenFrom[target] == v ? 1 : 0;
      seenFrom[target] = v;
      beyond += graph.Angles[e] < mesh.TotalAngle(v) ? 0 : 1;
      const Offset back = FindEdge(graph, target, v);
      oneWay += back < 0 ? 1 : 0;
      unequal += back >= 0 &&
          (graph.Length(back) != graph.Length(e) || graph.Angles[back] != graph.ArrivalAngles[e] ||
            graph.ArrivalAngles[back] != graph.Angles[e])
        ? 1
        : 0;
    }
  }
  EXPECT_EQ(oneWay, 0u) << "edges without a way back";
  EXPECT_EQ(unequal, 0u) << "edges unlike their way back";
  EXPECT_EQ(repeated, 0u) << "edges besides another one to the same vertex";
  EXPECT_EQ(beyond, 0u) << "angles not below the total angle";
}

void ExpectSameGraph(const dgg::GeodesicGraph& expected, const dgg::GeodesicGraph& actual)
{
  ExpectSameBytes(expected.Offsets, actual.Offsets, "offsets");
  ExpectSameBytes(expected.Targets, actual.Targets, "targets");
  ExpectSameBytes(expected.Lengths, actual.Lengths, "lengths");
  ExpectSameBytes(expected.WideLengths, actual.WideLengths, "wide lengths");
  ExpectSameBytes(expected.Angles, actual.Angles, "angles");
  ExpectSameBytes(expected.ArrivalAngles, actual.ArrivalAngles, "arrival angles");
  EXPECT_EQ(dgg::ComputeChecksum(expected.View()), dgg::ComputeChecksum(actual.View()));
}

Offset FindEdge(const dgg::GraphView& graph, Id from, Id to)
{
  const Id* begin = graph.Targets + graph.Offsets[from];
  const Id* end = graph.Targets + graph.Offsets[from + 1];
  const Id* found = std::find(begin, end, to);
  return found == end ? -1 : found - graph.Targets;
}
}
