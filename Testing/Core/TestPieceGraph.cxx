// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Memory of graphs and rows that several processes find together. The processes are threads.
#include "../Benchmark/MemoryProbe.h"
#include "GraphChecks.h"
#include "TaskTestTools.h"
#include "TestMeshes.h"

#include "dggMatrixRows.h"
#include "dggPieceGraph.h"
#include "dggPreparedSurface.h"
#include "dggTaskContext.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>
#include <tuple>

namespace
{
/// Number of allocations of this thread up to the one that fails; 0: none fails.
thread_local std::size_t AllocationsLeft = 0;
}

// If these functions were inlined, the compiler would warn about a mismatch between them.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  void* const block =
    AllocationsLeft > 0 && --AllocationsLeft == 0 ? nullptr : std::malloc(size > 0 ? size : 1);
  if (!block)
  {
    throw std::bad_alloc();
  }
  return block;
}

[[gnu::noinline]] void operator delete(void* block) noexcept
{
  std::free(block);
}

[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept
{
  std::free(block);
}

namespace dggtest
{
namespace
{
constexpr int Count = 3;

/// A point at which all threads wait for each other. Throws if one of them does not come.
class MeetingPoint
{
public:
  void Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    const int round = this->Round;
    if (++this->Present == Count)
    {
      this->Present = 0;
      ++this->Round;
      this->Changed.notify_all();
    }
    else if (!this->Changed.wait_for(
               lock, std::chrono::seconds(20), [&] { return this->Round != round; }))
    {
      throw std::runtime_error("a process waits for another one");
    }
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  int Present = 0;
  int Round = 0;
};

/// A piece of a mesh with every third of its faces, in strips.
struct Piece
{
  Piece(const TestMesh& mesh, int here)
  {
    const Id faces = mesh.GetNumberOfFaces();
    std::map<Id, dgg::Offset> added;
    for (Id f = faces * here / Count; f < faces * (here + 1) / Count; ++f)
    {
      this->CellIds.push_back(f);
      for (Id k = 0; k < 3; ++k)
      {
        const Id v = mesh.Triangles[3 * f + k];
        const auto found = added.emplace(v, this->PointIds.size());
        if (found.second)
        {
          this->PointIds.push_back(v);
          this->Points.insert(this->Points.end(), mesh.Point(v), mesh.Point(v) + 3);
        }
        this->Corners.push_back(found.first->second);
      }
    }
    for (std::size_t corner = 0; corner <= this->Corners.size(); corner += 3)
    {
      this->Offsets.push_back(static_cast<dgg::Offset>(corner));
    }
  }

  dgg::SurfacePiece Get() const
  {
    dgg::SurfacePiece piece;
    piece.Points = this->Points.data();
    piece.NumberOfPoints = static_cast<dgg::Offset>(this->PointIds.size());
    piece.Cells[2] = { static_cast<dgg::Offset>(this->CellIds.size()), this->Offsets.data(),
      this->Corners.data(), static_cast<dgg::Offset>(this->Corners.size()) };
    piece.PointIds = this->PointIds.data();
    piece.CellIds = this->CellIds.data();
    return piece;
  }

  std::vector<double> Points;
  std::vector<dgg::Offset> PointIds;
  std::vector<dgg::Offset> CellIds;
  std::vector<dgg::Offset> Corners;
  std::vector<dgg::Offset> Offsets;
};

struct Free
{
  void operator()(void* block) const { std::free(block); }
};

/// Processes that compute together. One of them may have little memory.
class Processes
{
public:
  using Step = std::function<dgg::Status(dgg::ProcessGroup&)>;

  /// Runs a step on all processes. On process `poor`, the allocation with this number fails; 0:
  /// none fails.
  void Run(int poor, std::size_t failing, double limit, const Step& step)
  {
    std::vector<std::thread> threads;
    for (int here = 0; here < Count; ++here)
    {
      threads.emplace_back([&, here] {
        const bool isPoor = here == poor;
        const std::size_t allocations =
          this->RunHere(here, isPoor ? failing : 0, isPoor ? limit : dgg::Infinity, step);
        if (isPoor)
        {
          this->NumberOfAllocations = allocations;
        }
      });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

  /// Expects that all processes have the same error.
  void ExpectError(const std::string& text, const std::string& context) const
  {
    for (const dgg::Status& status : this->Statuses)
    {
      EXPECT_NE(status.GetMessage().find(text), std::string::npos)
        << context << ": " << status.GetMessage();
    }
  }

  /// Expects that all processes have an error if one of them lacks memory for any allocation.
  void ExpectErrors(int poor, const Step& step)
  {
    this->Run(poor, 0, dgg::Infinity, step);
    const std::size_t allocations = this->NumberOfAllocations;
    for (const dgg::Status& status : this->Statuses)
    {
      ASSERT_TRUE(Ok(status));
    }
    for (std::size_t failing = 1; failing < allocations && !testing::Test::HasFailure();
         failing += 1 + allocations / 500)
    {
      this->Run(poor, failing, dgg::Infinity, step);
      this->ExpectError("no memory", "allocation " + std::to_string(failing));
    }
  }

  std::vector<dgg::Status> Statuses = std::vector<dgg::Status>(Count);
  bool ShareMemory = true; ///< if false, sharing fails

private:
  /// Returns the number of allocations.
  std::size_t RunHere(int here, std::size_t failing, double limit, const Step& step)
  {
    dgg::ProcessGroup group;
    group.Here = here;
    group.Count = Count;
    group.MemoryLimit = limit;
    group.Transfer = [&](std::vector<dgg::Message>& sent, std::vector<dgg::Message>& received) {
      this->Sent[here] = &sent;
      this->Meeting.Wait();
      for (int process = 0; process < Count; ++process)
      {
        const dgg::Message& message = (*this->Sent[process])[here];
        EXPECT_EQ(message.size(), received[process].size());
        std::copy(message.begin(), message.end(), received[process].begin());
      }
      this->Meeting.Wait();
    };
    group.FindFailure = [&](const dgg::Status& status) {
      this->Statuses[here] = status;
      this->Meeting.Wait();
      const auto failed = std::find_if(this->Statuses.begin(), this->Statuses.end(),
        [](const dgg::Status& outcome) { return !outcome.IsOk(); });
      const dgg::Status all = failed == this->Statuses.end() ? dgg::Status() : *failed;
      this->Meeting.Wait();
      return all;
    };
    group.ShareMemory = [&](std::vector<dgg::SharedBlock>& blocks, dgg::SharedCopies&) {
      for (std::size_t i = 0; i < blocks.size() && here == 0; ++i)
      {
        this->Copies[i].reset(std::malloc(1 + blocks[i].Size));
        std::copy_n(static_cast<const char*>(blocks[i].Data), blocks[i].Size,
          static_cast<char*>(this->Copies[i].get()));
      }
      this->Meeting.Wait();
      for (std::size_t i = 0; i < blocks.size() && here > 0; ++i)
      {
        blocks[i].Data = this->Copies[i].get();
      }
      return this->ShareMemory;
    };
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    AllocationsLeft = failing > 0 ? failing : all;
    dgg::Status status;
    try
    {
      status = step(group);
    }
    catch (const std::bad_alloc&)
    {
      status = dgg::Status(dgg::Status::Code::OutOfMemory, "no memory");
    }
    const std::size_t allocations = all - AllocationsLeft;
    AllocationsLeft = 0;
    this->Statuses[here] = group.Agree(status);
    return allocations;
  }

  std::size_t NumberOfAllocations = 0; // of the poor process
  std::vector<std::vector<dgg::Message>*> Sent = std::vector<std::vector<dgg::Message>*>(Count);
  std::array<std::unique_ptr<void, Free>, 16> Copies; // of shared blocks
  MeetingPoint Meeting;
};

/// Builds of the graph of a mesh in pieces, one for each process.
struct PieceBuild
{
  PieceBuild(const TestMesh& mesh, double accuracy)
  {
    this->Options.Accuracy = accuracy;
    for (int here = 0; here < Count; ++here)
    {
      this->Pieces.emplace_back(mesh, here);
    }
  }
  dgg::Status operator()(dgg::ProcessGroup& group)
  {
    static const dgg::PreparedSurface none;
    const dgg::TaskContext context{ none, {}, 1, nullptr, nullptr, nullptr };
    dgg::PieceGraph graph;
    std::vector<std::string> warnings;
    bool isUsable = false;
    const dgg::Status status = dgg::BuildPieceGraph(context, group, this->Pieces[group.Here].Get(),
      this->Options, graph, this->Estimates[group.Here], warnings, isUsable);
    EXPECT_TRUE(isUsable || !status.IsOk());
    return status;
  }

  dgg::GraphOptions Options;
  std::vector<Piece> Pieces;
  std::vector<dgg::GraphEstimate> Estimates = std::vector<dgg::GraphEstimate>(Count);
};
/// Returns sources, columns and distances of rows.
std::vector<std::tuple<std::size_t, Id, double>> Flatten(const std::vector<dgg::DistanceRow>& rows)
{
  std::vector<std::tuple<std::size_t, Id, double>> entries;
  for (std::size_t source = 0; source < rows.size(); ++source)
  {
    for (const dgg::RowEntry& entry : rows[source])
    {
      entries.emplace_back(source, entry.Column, entry.Distance);
    }
  }
  return entries;
}

}

/// Each allocation may fail, in a step of one process or between the messages to other processes.
TEST(PieceGraphMemory, OneProcessRunsOutOfMemory)
{
  PieceBuild build(Terrain(12, 0.4, 3), 0.05);
  Processes().ExpectErrors(Count - 1, std::ref(build));
}

/// The same is true while processes find rows, with and without targets, and while the first
/// process finds them alone because memory cannot be shared.
TEST(MatrixRowsMemory, OneProcessRunsOutOfMemory)
{
  const GraphWorld world(Terrain(8, 0.4, 3), 0.05);
  for (const bool hasTargets : { false, true })
  {
    dgg::MatrixRowLinks links;
    for (Id v = 0; v < world.Graph.GetNumberOfVertices(); ++v)
    {
      links.Seeds.push_back({ v, 0.0, 0.0, v, -1.0 });
      links.Targets.resize(hasTargets ? links.Seeds.size() : 0, { v, v, 0.0 });
    }
    dgg::MatrixRowOptions options;
    options.NumberOfSources = links.Seeds.size();
    options.SearchRadius = 1.5; // local: GroupSources() would use std::stable_sort with less memory
    options.HasTargets = hasTargets;
    const dgg::GraphSearch search(world.Graph.View(), &world.Surface->GetMesh());
    using Rows = std::vector<dgg::DistanceRow>;
    const auto find = [&](dgg::ProcessGroup* group, Rows& rows) {
      dgg::TaskContext context{ *world.Surface, {}, 1, nullptr, nullptr, nullptr };
      context.Group = group;
      if (group && group->Here > 0)
      {
        return dgg::HelpFirstProcess(context);
      }
      return dgg::FindMatrixRows(context, search, links, options, nullptr,
        [&](std::size_t source, dgg::DistanceRow& row) { rows[source].swap(row); });
    };
    Rows expected(options.NumberOfSources);
    ASSERT_TRUE(Ok(find(nullptr, expected)));
    for (const int poor : { 0, Count - 1 })
    {
      for (const bool canShare : { true, false })
      {
        Processes processes;
        processes.ShareMemory = canShare;
        Rows rows;
        const auto step = [&](dgg::ProcessGroup& group) {
          if (group.Here == 0)
          {
            rows.assign(options.NumberOfSources, {});
          }
          DGG_RETURN_IF_ERROR(find(&group, rows));
          return group.Here > 0 ? dgg::Status::Success() : dgg::DismissHelpers(group);
        };
        processes.ExpectErrors(poor, step);
        processes.Run(poor, 0, dgg::Infinity, step);
        EXPECT_EQ(Flatten(rows), Flatten(expected));
      }
    }
  }
}

/// A process with little memory sends its rows earlier. The limit also covers these rows.
TEST(MatrixRowsMemory, LimitOfOneProcess)
{
  const GraphWorld world(Terrain(40, 0.4, 3), 0.05);
  const dgg::GraphSearch search(world.Graph.View(), &world.Surface->GetMesh());
  dgg::MatrixRowLinks links;
  for (Id v = 0; v < world.Graph.GetNumberOfVertices(); ++v)
  {
    links.Seeds.push_back({ v, 0.0, 0.0, v, -1.0 });
  }
  dgg::MatrixRowOptions options;
  options.NumberOfSources = links.Seeds.size();
  std::atomic<std::size_t> rows{ 0 };
  Processes processes;
  const auto canRun = [&](double limit) {
    rows = 0;
    processes.Run(-1, 0, dgg::Infinity, [&](dgg::ProcessGroup& group) {
      dgg::TaskContext context{ *world.Surface, {}, 1, nullptr, nullptr, nullptr };
      context.Group = &group;
      if (group.Here > 0)
      {
        context.Memory.Limit = group.Here == 1 ? static_cast<std::uint64_t>(limit) : 0;
        return dgg::HelpFirstProcess(context);
      }
      DGG_RETURN_IF_ERROR(dgg::FindMatrixRows(context, search, links, options, nullptr,
        [&](std::size_t, const dgg::DistanceRow&) { ++rows; }));
      return dgg::DismissHelpers(group);
    });
    return processes.Statuses[0].IsOk();
  };
  double start = 0.0; // bytes before the first row
  std::size_t failures = 0;
  double limit = 5e5;
  for (; limit < 1e8 && !canRun(limit); limit *= 1.03)
  {
    const std::string message = processes.Statuses[0].GetMessage();
    if (message.find("The matrix so far needs") != std::string::npos)
    {
      ++failures;
    }
    else
    {
      EXPECT_NE(message.find("A process that finds rows"), std::string::npos) << message;
      start = limit;
    }
  }
  EXPECT_EQ(rows, links.Seeds.size());
  EXPECT_GT(failures, 0u);
  // Less than all rows that this process finds.
  const double all = static_cast<double>(rows * rows / Count * sizeof(dgg::RowEntry));
  EXPECT_LT(limit - start, 0.1 * all);
}

/// The limit covers the region of each round of growing, which all windows leave here.
TEST(PieceGraphMemory, LimitOfOneProcess)
{
  Processes processes;
  PieceBuild build(Plane(40, 40), 0.01);
  const MemoryProbe probe;
  processes.Run(0, 0, dgg::Infinity, std::ref(build));
  double predicted = 0.0;
  for (const dgg::GraphEstimate& estimate : build.Estimates)
  {
    predicted += estimate.Peak;
  }
  EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), predicted);
  const double needed = build.Estimates.back().Peak;
  for (const double limit : { 0.95 * needed, 0.05 * needed }) // for edges, for messages
  {
    processes.Run(Count - 1, 0, limit, std::ref(build));
    processes.ExpectError("more than the limit", std::to_string(limit));
  }
}

/// A ghost must be a point of the surface.
TEST(PieceGraph, GhostIsMissing)
{
  const std::vector<dgg::Offset> offsets{ 0, 1, 1 };
  const std::vector<Id> targets{ 1 };
  const std::vector<float> values{ 1.0F };
  const std::vector<dgg::Offset> points{ 0 };
  const std::vector<dgg::Offset> globalIds{ 4, 8 };
  const std::vector<Id> owners{ dgg::GhostVertices::Here, 1 };
  for (const dgg::Offset ghost : { 8, 9 })
  {
    dgg::StoredPiece piece;
    piece.Rows.Offsets = offsets.data();
    piece.Rows.Targets = targets.data();
    piece.Rows.Lengths = values.data();
    piece.Rows.Angles = values.data();
    piece.Rows.ArrivalAngles = values.data();
    piece.Ghosts = { &ghost, 1, owners.data() };
    piece.Points = &points;
    dgg::GeodesicGraph graph;
    const dgg::Status status = dgg::JoinPieceGraphs({ piece }, globalIds.data(), 2, graph);
    EXPECT_EQ(
      status.GetCode(), ghost == 8 ? dgg::Status::Code::Ok : dgg::Status::Code::DamagedGraph);
  }
}
}
