// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMatrixRows.h"

#include "dggGraphFans.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <atomic>
#include <type_traits>

namespace dgg
{
namespace
{
/// Number of exchanges of rows, and minimum number of groups of sources that each thread searches
/// between two exchanges. An exchange waits for the slowest process.
constexpr std::size_t NumberOfRounds = 8;
constexpr std::size_t FewestGroups = 4;
/// Maximum bytes of the rows of a process between two exchanges, and bytes per entry of a row,
/// which is copied to a message.
constexpr double LargestRound = 32.0 * 1024.0 * 1024.0;
constexpr double BytesPerEntry = 2.0 * sizeof(RowEntry);

/// Arrays from which a process finds rows. Processes other than the first have copies.
struct RowTask
{
  MatrixRowOptions Options; ///< without sources, there is no task
  GraphView Graph;
  Offset NumberOfEdges = 0;
  double MeanEdgeLength = 0.0;
  const VertexAngle* Angles = nullptr; ///< per vertex; null without a mesh
  const GraphSeed* Seeds = nullptr;
  std::size_t NumberOfSeeds = 0;
  const TargetLink* Links = nullptr;
  std::size_t NumberOfLinks = 0;
  const std::size_t* Sources = nullptr;   ///< ManyPlan::Groups, one after the other
  const std::size_t* GroupEnds = nullptr; ///< in Sources
  std::size_t NumberOfGroups = 0;
  std::size_t Reach = 0;        ///< ManyPlan::Reach
  std::size_t FewestGroups = 0; ///< per process and round, unless memory is short

  /// Calls `visit(array, size)` for each array. Arrays that do not exist are null.
  template <typename Visit>
  void ForEachArray(const Visit& visit)
  {
    const auto n = static_cast<std::size_t>(this->Graph.NumberOfVertices);
    const auto edges = static_cast<std::size_t>(this->NumberOfEdges);
    visit(this->Graph.Offsets, n + 1);
    visit(this->Graph.Targets, edges);
    visit(this->Graph.Lengths, edges);
    visit(this->Graph.WideLengths, edges);
    visit(this->Graph.Angles, edges);
    visit(this->Graph.ArrivalAngles, edges);
    visit(this->Angles, n);
    visit(this->Seeds, this->NumberOfSeeds);
    visit(this->Links, this->NumberOfLinks);
    visit(this->Sources, this->Options.NumberOfSources);
    visit(this->GroupEnds, this->NumberOfGroups);
  }
  /// Returns the sources of every `step`-th group of [begin, end).
  std::vector<std::vector<std::size_t>> GetGroups(
    std::size_t begin, std::size_t end, std::size_t step) const
  {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t g = begin; g < end; g += step)
    {
      groups.emplace_back(
        this->Sources + (g > 0 ? this->GroupEnds[g - 1] : 0), this->Sources + this->GroupEnds[g]);
    }
    return groups;
  }
  /// Calls `call(source)` for the sources of these groups.
  template <typename Call>
  void ForEachSource(std::size_t begin, std::size_t end, std::size_t step, const Call& call) const
  {
    for (const std::vector<std::size_t>& group : this->GetGroups(begin, end, step))
    {
      std::for_each(group.begin(), group.end(), call);
    }
  }
};

/// Searches rows of a task.
class RowSearch
{
public:
  /// `search` searches the graph of the task.
  RowSearch(const TaskContext& context, const RowTask& task, const GraphSearch& search);

  Status Plan(ManyPlan& plan) const { return this->Search.PlanMany(this->Seeds, this->Many, plan); }
  /// Searches the groups of a plan on this process.
  Status Run(
    const ManyPlan& plan, const ProgressCallback& progress, const RowConsumer& consume) const;
  /// Searches the groups of the task on all processes. The first process consumes all rows. `inUse`
  /// is the number of bytes in use already.
  Status RunTogether(
    double inUse, const ProgressCallback& progress, const RowConsumer& consume) const;

private:
  /// Finds the number of groups that each process searches in a round.
  Status FindRound(double inUse, std::size_t& numberOfGroups) const;
  void Fill(std::size_t source, const double* field, const std::vector<Id>& reached,
    DistanceRow& row) const;

  const TaskContext& Context;
  const RowTask& Task;
  const GraphSearch& Search;
  std::vector<std::vector<GraphSeed>> Seeds; // per source
  ManyOptions Many;
};

RowSearch::RowSearch(const TaskContext& context, const RowTask& task, const GraphSearch& search)
  : Context(context)
  , Task(task)
  , Search(search)
  , Seeds(task.Options.NumberOfSources)
{
  for (std::size_t k = 0; k < task.NumberOfSeeds; ++k)
  {
    this->Seeds[task.Seeds[k].Source].push_back(task.Seeds[k]);
  }
  this->Many.MaximumDistance = task.Options.SearchRadius;
  this->Many.Correct = task.Options.Correct;
  for (std::size_t k = 0; k < task.NumberOfLinks; ++k)
  {
    this->Many.Targets.push_back(task.Links[k].Vertex);
  }
}

void RowSearch::Fill(
  std::size_t source, const double* field, const std::vector<Id>& reached, DistanceRow& row) const
{
  const MatrixRowOptions& options = this->Task.Options;
  if (!options.HasTargets)
  {
    row.reserve(reached.size());
    for (const Id vertex : reached)
    {
      if (field[vertex] <= options.MaximumDistance)
      {
        row.push_back({ vertex, field[vertex] });
      }
    }
    SortRow(row);
    return;
  }
  const TargetLink* const end = this->Task.Links + this->Task.NumberOfLinks;
  const auto first = static_cast<Id>(options.IsSymmetric ? source + 1 : 0);
  const TargetLink* link = std::lower_bound(this->Task.Links, end, first,
    [](const TargetLink& before, Id target) { return before.Target < target; });
  for (; link != end; ++link)
  {
    const double distance = field[link->Vertex] + link->Length;
    if (distance == Infinity)
    {
      continue;
    }
    if (row.empty() || row.back().Column != link->Target)
    {
      row.push_back({ link->Target, distance });
    }
    row.back().Distance = std::min(row.back().Distance, distance);
  }
}

Status RowSearch::Run(
  const ManyPlan& plan, const ProgressCallback& progress, const RowConsumer& consume) const
{
  return this->Search.Many(this->Seeds, this->Many, plan, this->Context.Parallel, progress,
    [&](std::size_t source, const double* field, const std::vector<Id>& reached) {
      DistanceRow row;
      this->Fill(source, field, reached, row);
      consume(source, row);
    });
}

Status RowSearch::FindRound(double inUse, std::size_t& numberOfGroups) const
{
  ProcessGroup& group = *this->Context.Group;
  const RowTask& task = this->Task;
  const auto processes = static_cast<std::size_t>(group.Count);
  const std::size_t columns = 1 + (task.Options.HasTargets ? task.NumberOfLinks : task.Reach);
  const double sourcesPerGroup =
    static_cast<double>(task.Options.NumberOfSources) / static_cast<double>(task.NumberOfGroups);
  // The first process receives the rows of all others.
  const double bytes = std::min(LargestRound, (group.MemoryLimit - inUse) / group.Count);
  const double most = bytes / (BytesPerEntry * sourcesPerGroup * static_cast<double>(columns));
  const std::size_t wanted =
    std::max(task.FewestGroups, task.NumberOfGroups / (NumberOfRounds * processes));
  std::vector<std::size_t> all;
  DGG_RETURN_IF_ERROR(group.Share(
    static_cast<std::size_t>(std::max(1.0, std::min(most, static_cast<double>(wanted)))), all));
  numberOfGroups = *std::min_element(all.begin(), all.end());
  return Status::Success();
}

Status RowSearch::RunTogether(
  double inUse, const ProgressCallback& progress, const RowConsumer& consume) const
{
  ProcessGroup& group = *this->Context.Group;
  const auto processes = static_cast<std::size_t>(group.Count);
  const auto here = static_cast<std::size_t>(group.Here);
  const std::size_t size = this->Task.NumberOfGroups;
  std::size_t round = 0;
  DGG_RETURN_IF_ERROR(this->FindRound(inUse, round));
  const std::size_t step = processes * round;
  std::vector<DistanceRow> rows(here == 0 ? 0 : this->Task.Options.NumberOfSources);
  std::atomic<std::size_t> stored{ 0 }; // entries
  const RowConsumer store = [&](std::size_t source, DistanceRow& row) {
    stored += row.size();
    rows[source].swap(row);
  };
  const auto checkRows = [&] {
    return here == 0
      ? Status::Success()
      : CheckRows(inUse + BytesPerEntry * static_cast<double>(stored), group.MemoryLimit);
  };
  const ProgressCallback shouldContinue = [&](double done) {
    return checkRows().IsOk() && ShouldContinue(progress, done);
  };
  for (std::size_t begin = 0; begin < size; begin += step)
  {
    const std::size_t end = std::min(size, begin + step);
    const auto getPart = [&](std::size_t g) {
      return static_cast<double>(g) / static_cast<double>(size);
    };
    const ManyPlan plan{ this->Task.GetGroups(begin + here, end, processes), this->Task.Reach };
    const Status status = this->Run(plan,
      ProgressPart(shouldContinue, getPart(begin), getPart(end)), here == 0 ? consume : store);
    DGG_RETURN_IF_ERROR(checkRows());
    DGG_RETURN_IF_ERROR(status);
    stored = 0;
    std::vector<Message> messages(processes);
    if (here > 0)
    {
      this->Task.ForEachSource(begin + here, end, processes, [&](std::size_t source) {
        Append(messages[0], rows[source]);
        rows[source] = DistanceRow();
      });
    }
    DGG_RETURN_IF_ERROR(group.Exchange(messages, inUse));
    for (std::size_t process = 1; process < processes && here == 0; ++process)
    {
      MessageReader reader(messages[process]);
      this->Task.ForEachSource(begin + process, end, processes, [&](std::size_t source) {
        DistanceRow row = reader.Take<RowEntry>();
        consume(source, row);
      });
    }
  }
  return Status::Success();
}

/// Copies the arrays of a task from the first process to the others. `isShared` becomes false on
/// all processes if there is no task or memory cannot be shared. `inUse` becomes the number of
/// bytes for the task.
Status ShareTask(
  const TaskContext& context, RowTask& task, SharedCopies& copies, bool& isShared, double& inUse)
{
  ProcessGroup& group = *context.Group;
  isShared = false;
  group.MemoryLimit = context.Memory.GetBytes();
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(task));
  if (task.Options.NumberOfSources == 0)
  {
    return Status::Success();
  }
  std::vector<SharedBlock> blocks;
  inUse = GraphSearch::EstimateMany(task.Graph.NumberOfVertices, context.NumberOfThreads);
  task.ForEachArray([&](const auto* values, std::size_t size) {
    blocks.push_back({ values, values ? size * sizeof(*values) : 0 });
    inUse += static_cast<double>(blocks.back().Size);
  });
  DGG_RETURN_IF_ERROR(
    group.Agree(group.Here == 0 ? Status::Success()
                                : context.Memory.Check("A process that finds rows of the matrix",
                                    inUse, "Use fewer threads or a smaller surface")));
  isShared = group.ShareMemory(blocks, copies);
  std::size_t next = 0;
  task.ForEachArray([&](auto& values, std::size_t) {
    using Pointer = std::remove_reference_t<decltype(values)>;
    const SharedBlock& block = blocks[next++];
    values = block.Size > 0 ? static_cast<Pointer>(block.Data) : nullptr;
  });
  return Status::Success();
}
}

Status FindMatrixRows(const TaskContext& context, const GraphSearch& search,
  const MatrixRowLinks& links, const MatrixRowOptions& options, const ProgressCallback& progress,
  const RowConsumer& consume)
{
  RowTask task;
  task.Options = options;
  task.Graph = search.GetGraph();
  task.Seeds = links.Seeds.data();
  task.NumberOfSeeds = links.Seeds.size();
  task.Links = links.Targets.data();
  task.NumberOfLinks = links.Targets.size();
  const RowSearch rows(context, task, search);
  ManyPlan plan;
  DGG_RETURN_IF_ERROR(rows.Plan(plan));
  if (!context.Group || options.NumberOfSources == 0)
  {
    return rows.Run(plan, progress, consume);
  }
  std::vector<std::size_t> sources;
  std::vector<std::size_t> ends;
  for (const std::vector<std::size_t>& members : plan.Groups)
  {
    sources.insert(sources.end(), members.begin(), members.end());
    ends.push_back(sources.size());
  }
  std::vector<VertexAngle> angles;
  if (!context.Surface.IsCloud() && task.Graph.Angles && task.Graph.ArrivalAngles)
  {
    angles = MeasureVertexAngles(context.Surface.GetMesh());
    task.MeanEdgeLength = context.Surface.GetMesh().GetMeanEdgeLength();
  }
  task.NumberOfEdges = task.Graph.GetNumberOfEdges();
  task.Angles = angles.data();
  task.Sources = sources.data();
  task.GroupEnds = ends.data();
  task.NumberOfGroups = ends.size();
  task.Reach = plan.Reach;
  task.FewestGroups = FewestGroups * static_cast<std::size_t>(context.NumberOfThreads);
  SharedCopies copies;
  bool isShared = false;
  double inUse = 0.0;
  DGG_RETURN_IF_ERROR(ShareTask(context, task, copies, isShared, inUse));
  return isShared ? rows.RunTogether(inUse, progress, consume) : rows.Run(plan, progress, consume);
}

Status DismissHelpers(ProcessGroup& group)
{
  RowTask none;
  return group.TakeFromFirst(none);
}

Status HelpFirstProcess(const TaskContext& context)
{
  for (;;)
  {
    RowTask task;
    SharedCopies copies;
    bool isShared = false;
    double inUse = 0.0;
    DGG_RETURN_IF_ERROR(ShareTask(context, task, copies, isShared, inUse));
    if (task.Options.NumberOfSources == 0)
    {
      return Status::Success();
    }
    if (isShared)
    {
      const Id n = task.Angles ? task.Graph.NumberOfVertices : 0;
      const GraphSearch search(
        task.Graph, std::vector<VertexAngle>(task.Angles, task.Angles + n), task.MeanEdgeLength);
      DGG_RETURN_IF_ERROR(
        RowSearch(context, task, search).RunTogether(inUse, context.Progress, {}));
    }
  }
}
}
