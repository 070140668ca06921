// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Memory of graphs that several processes build together. The processes are threads.
#include "../Benchmark/MemoryProbe.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggPieceGraph.h"
#include "dggPreparedSurface.h"
#include "dggTaskContext.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>

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

/// Processes that build the graph of a mesh. The last one may have little memory.
class Processes
{
public:
  Processes(const TestMesh& mesh, double accuracy)
    : Statuses(Count)
    , Estimates(Count)
    , Sent(Count)
  {
    this->Options.Accuracy = accuracy;
    for (int here = 0; here < Count; ++here)
    {
      this->Pieces.emplace_back(mesh, here);
    }
  }

  /// Builds the graph. On the last process the allocation with this number fails; 0: none fails.
  void Build(std::size_t failing, double limit = dgg::Infinity)
  {
    std::vector<std::thread> threads;
    for (int here = 0; here < Count; ++here)
    {
      const bool isLast = here == Count - 1;
      threads.emplace_back(
        [this, here, failing = isLast ? failing : 0, limit = isLast ? limit : dgg::Infinity] {
          this->Statuses[here] = this->BuildPiece(here, failing, limit);
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

  std::vector<dgg::Status> Statuses;
  std::vector<dgg::GraphEstimate> Estimates;
  std::size_t NumberOfAllocations = 0; // of the last process

private:
  dgg::Status BuildPiece(int here, std::size_t failing, double limit)
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
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    AllocationsLeft = failing > 0 ? failing : all;
    dgg::Status status;
    try
    {
      static const dgg::PreparedSurface none;
      const dgg::TaskContext context{ none, {}, 1, nullptr, nullptr, nullptr };
      dgg::PieceGraph graph;
      std::vector<std::string> warnings;
      bool isUsable = false;
      status = dgg::BuildPieceGraph(context, group, this->Pieces[here].Get(), this->Options, graph,
        this->Estimates[here], warnings, isUsable);
      EXPECT_TRUE(isUsable || !status.IsOk());
    }
    catch (const std::bad_alloc&)
    {
      status = dgg::Status(dgg::Status::Code::OutOfMemory, "no memory");
    }
    if (here == Count - 1)
    {
      this->NumberOfAllocations = all - AllocationsLeft;
    }
    AllocationsLeft = 0;
    return group.Agree(status);
  }

  dgg::GraphOptions Options;
  std::vector<Piece> Pieces;
  std::vector<std::vector<dgg::Message>*> Sent;
  MeetingPoint Meeting;
};
}

/// Each allocation may fail, in a step of one process or between the messages to other processes.
TEST(PieceGraphMemory, OneProcessRunsOutOfMemory)
{
  Processes processes(Terrain(12, 0.4, 3), 0.05);
  processes.Build(0);
  const std::size_t allocations = processes.NumberOfAllocations;
  for (const dgg::Status& status : processes.Statuses)
  {
    ASSERT_TRUE(Ok(status));
  }
  for (std::size_t failing = 1; failing < allocations; failing += 1 + allocations / 500)
  {
    processes.Build(failing);
    processes.ExpectError("no memory", "allocation " + std::to_string(failing));
    if (testing::Test::HasFailure())
    {
      break;
    }
  }
}

/// The limit covers the region of each round of growing, which all windows leave here.
TEST(PieceGraphMemory, LimitOfOneProcess)
{
  Processes processes(Plane(40, 40), 0.01);
  const MemoryProbe probe;
  processes.Build(0);
  double predicted = 0.0;
  for (const dgg::GraphEstimate& estimate : processes.Estimates)
  {
    predicted += estimate.Peak;
  }
  EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), predicted);
  const double needed = processes.Estimates.back().Peak;
  for (const double limit : { 0.95 * needed, 0.05 * needed }) // for edges, for messages
  {
    processes.Build(0, limit);
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
