// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceGraph.h"

#include "dggBitHash.h"
#include "dggDirectionUnion.h"
#include "dggGraphAssembly.h"
#include "dggGraphBuildTask.h"
#include "dggProgressPart.h"
#include "dggRowFinder.h"
#include "dggSurfaceRegion.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace dgg
{
namespace
{
/// Layers of cells around a piece in the first round, and their growth from round to round as long
/// as windows meet the rim. With 16 layers, the windows of some points of every measured scan meet
/// the rim at accuracies of 10 % and 1 %, and with 64 layers few do. A layer costs much less than a
/// round, which makes the mesh and its tables again.
constexpr int FirstLayers = 64;
constexpr int GrowthOfLayers = 4;
/// Progress weight of finding edges.
constexpr double FindingShare = 0.9;

/// Bytes of a vertex of a region: its order, rank and id, and the flag of the rim.
constexpr std::size_t BytesOfVertex = 2 * sizeof(Id) + sizeof(Offset) + 1;

/// An edge to a point of another process, as it is sent there.
struct SentEdge
{
  Offset Source; // global ids
  Offset Target;
  double Length;
  float Departure;
  float Arrival;
};

/// Finds the edges of the points of a piece.
class EdgeFinder
{
public:
  EdgeFinder(
    const TaskContext& context, ProcessGroup& group, const GraphOptions& options, bool isWide)
    : Rows(isWide)
    , Group(group)
    , Options(options)
  {
    UseThreads(context, this->Options);
    this->Options.Progress = ProgressPart(context.Progress, 0.0, FindingShare);
  }

  Status Run(const SurfacePiece& piece, GraphEstimate& estimate, std::vector<std::string>& warnings,
    bool& isUsable)
  {
    DGG_RETURN_IF_ERROR(this->Region.Start(this->Group, piece, isUsable));
    if (!isUsable)
    {
      return Status::Success();
    }
    for (Id point = 0; point < this->Region.GetNumberOfPoints(); ++point)
    {
      if (this->Region.GetOwner(point) == this->Group.Here)
      {
        this->Unfinished.push_back(point);
      }
    }
    GraphRegion region;
    for (int layers = FirstLayers, present = 0;; layers *= GrowthOfLayers)
    {
      const bool isFirst = present == 0;
      const bool isNeeded = !this->Unfinished.empty();
      DGG_RETURN_IF_ERROR(
        this->Region.Grow(this->Group, layers - present, isNeeded, this->GetMemorySize()));
      present = layers;
      RegionMesh mesh;
      if (isFirst || isNeeded)
      {
        this->Region.MakeMesh(mesh);
        isUsable = mesh.IsValid;
      }
      if (isFirst)
      {
        SurfaceFacts facts = this->Region.MeasureFacts(mesh);
        DGG_RETURN_IF_ERROR(facts.Share(this->Group));
        isUsable = facts.IsRegular;
        region.NumberOfFaces = facts.NumberOfFaces;
        region.HasBranches = facts.Defects.NonManifoldEdges > 0;
        warnings = DescribeDefects(facts.Defects);
      }
      region.IsRim.swap(mesh.IsRim);
      this->Order.swap(mesh.Points);
      std::vector<double>().swap(mesh.Positions);
      std::vector<Offset>().swap(mesh.CellIds);
      DGG_RETURN_IF_ERROR(this->Group.Require(isUsable));
      if (!isUsable)
      {
        return Status::Success();
      }
      std::optional<RowFinder> finder;
      // No process traces windows if another one has too little memory.
      DGG_RETURN_IF_ERROR(this->Group.Agree(
        isNeeded ? this->Prepare(mesh.Mesh, region, finder, estimate) : Status::Success()));
      if (finder)
      {
        DGG_RETURN_IF_ERROR(this->FindEdges(*finder));
      }
      std::vector<std::array<std::size_t, 2>> parts;
      DGG_RETURN_IF_ERROR(this->Group.Share(
        std::array<std::size_t, 2>{ this->Unfinished.size(), this->Statistics.Work }, parts));
      std::size_t unfinished = 0;
      std::size_t work = 0;
      for (const auto& part : parts)
      {
        unfinished += part[0];
        work += part[1];
      }
      if (unfinished == 0)
      {
        return RowFinder::CheckWork(this->Options, region, work);
      }
    }
  }

  /// Sends edges to the owners of their targets, and adds the edges from other processes.
  Status ExchangeEdges()
  {
    std::vector<Message> messages(static_cast<std::size_t>(this->Group.Count));
    std::vector<std::vector<SentEdge>> sent(messages.size());
    for (std::size_t row = 0; row < this->Sources.size(); ++row)
    {
      for (Offset i = this->Rows.Begin(row); i < this->Rows.End(row); ++i)
      {
        const RowEdge edge = this->Rows.Get(i);
        const int owner = this->Region.GetOwner(edge.Target);
        if (owner != this->Group.Here)
        {
          sent[owner].push_back({ this->Region.GetPointId(this->Sources[row]),
            this->Region.GetPointId(edge.Target), edge.Length, edge.Departure, edge.Arrival });
        }
      }
    }
    for (std::size_t process = 0; process < sent.size(); ++process)
    {
      Append(messages[process], sent[process]);
      std::vector<SentEdge>().swap(sent[process]);
    }
    DGG_RETURN_IF_ERROR(
      this->Group.Exchange(messages, this->GetMemorySize() + this->Region.GetMemorySize()));
    for (int process = 0; process < this->Group.Count; ++process)
    {
      const std::vector<SentEdge> received = MessageReader(messages[process]).Take<SentEdge>();
      for (auto next = received.begin(); next != received.end();)
      {
        const Offset source = next->Source;
        this->Row.clear();
        for (; next != received.end() && next->Source == source; ++next)
        {
          const Id target = this->Region.AddVertex(next->Target, this->Group.Here);
          this->Row.push_back({ target, next->Length, next->Departure, next->Arrival });
        }
        this->AppendRow(this->Region.AddVertex(source, process));
      }
    }
    return Status::Success();
  }

  /// Returns the size in bytes of the edges found.
  double GetMemorySize() const
  {
    return this->Rows.GetMemorySize() + static_cast<double>(this->Sources.size() * sizeof(Id));
  }

  SurfaceRegion Region;
  RowStore Rows;           // edges to points of the region
  std::vector<Id> Sources; // points of the region, per row

private:
  /// Prepares the search for the edges of points that are not finished. Fails if it would take too
  /// much memory.
  Status Prepare(const SurfaceMesh& mesh, GraphRegion& region, std::optional<RowFinder>& finder,
    GraphEstimate& estimate)
  {
    std::vector<Id> rank(this->Order.size());
    region.PointIds.clear();
    for (std::size_t v = 0; v < this->Order.size(); ++v)
    {
      rank[this->Order[v]] = static_cast<Id>(v);
      region.PointIds.push_back(this->Region.GetPointId(this->Order[v]));
    }
    region.Sources.clear();
    for (const Id point : this->Unfinished)
    {
      region.Sources.push_back(rank[point]);
    }
    finder.emplace(mesh, region);
    GraphEstimate needed;
    DGG_RETURN_IF_ERROR(finder->Estimate(this->Options, needed));
    needed.Peak += this->GetMemorySize() + this->Region.GetMemorySize() +
      static_cast<double>(mesh.GetMemorySize() + rank.size() * BytesOfVertex);
    estimate.Edges = std::max(estimate.Edges, needed.Edges);
    estimate.Memory = std::max(estimate.Memory, needed.Memory);
    estimate.Peak = std::max(estimate.Peak, needed.Peak);
    return CheckGraphMemory(this->Group.MemoryLimit, this->Options, estimate);
  }

  /// Finds the edges of points that are not finished.
  Status FindEdges(const RowFinder& finder)
  {
    this->Unfinished.clear();
    const auto getPoint = [&](Id row) { return this->Order[finder.GetTable().OldVertex(row)]; };
    return finder.Find(
      this->Options, this->Statistics, [&](const std::vector<RowBlock>& blocks, Id first) {
        for (const RowBlock& block : blocks)
        {
          const RowEdge* next = block.Edges.data();
          for (const std::size_t size : block.Sizes)
          {
            const Id source = getPoint(finder.GetRow(first++));
            if (size == RowBlock::RimReached)
            {
              this->Unfinished.push_back(source);
              continue;
            }
            this->Row.assign(next, next + size);
            next += size;
            for (RowEdge& edge : this->Row)
            {
              edge.Target = getPoint(edge.Target);
            }
            this->AppendRow(source);
          }
        }
      });
  }

  void AppendRow(Id source)
  {
    this->Sources.push_back(source);
    this->Rows.AppendRow(this->Row.data(), this->Row.data() + this->Row.size());
  }

  ProcessGroup& Group;
  GraphOptions Options;
  std::vector<Id> Unfinished; // points of the region
  std::vector<Id> Order;      // points of the region in the order of its mesh
  std::vector<RowEdge> Row;   // the next one of Rows
  GraphStatistics Statistics;
};

/// Points of a region that are vertices of the graph of its piece: those of the piece, then ghosts
/// in the order of their ids.
struct PieceVertices
{
  PieceVertices(const EdgeFinder& finder, std::size_t pointsOfPiece)
    : Of(static_cast<std::size_t>(finder.Region.GetNumberOfPoints()), NoId)
    , Points(pointsOfPiece)
    , Ranks(pointsOfPiece)
  {
    std::iota(this->Points.begin(), this->Points.end(), 0);
    std::iota(this->Of.begin(), this->Of.begin() + pointsOfPiece, 0);
    std::vector<std::uint8_t> isEnd(this->Of.size(), 0); // of an edge
    for (std::size_t row = 0; row < finder.Sources.size(); ++row)
    {
      for (Offset i = finder.Rows.Begin(row); i < finder.Rows.End(row); ++i)
      {
        isEnd[finder.Sources[row]] = isEnd[finder.Rows.Target(i)] = 1;
      }
    }
    Id rank = 0;
    for (const Id point : finder.Region.GetOrder())
    {
      if (this->Of[point] != NoId)
      {
        this->Ranks[point] = rank++;
      }
      else if (isEnd[point])
      {
        this->Of[point] = static_cast<Id>(this->Points.size());
        this->Points.push_back(point);
        this->Ranks.push_back(rank++);
      }
    }
  }

  std::vector<Id> Of;     // vertex of each point of the region, or NoId
  std::vector<Id> Points; // of the region, per vertex
  std::vector<Id> Ranks;  // in the order of global ids, per vertex
};

/// Makes a graph of the rows that were found, which are released.
Status Assemble(const TaskContext& context, EdgeFinder& finder, const PieceVertices& vertices,
  bool isWide, GeodesicGraph& graph)
{
  RowStore& rows = finder.Rows;
  std::vector<Id> order; // vertex per row
  std::vector<Id> rowOf(vertices.Points.size(), NoId);
  const auto addRow = [&](Id vertex) {
    rowOf[vertex] = static_cast<Id>(order.size());
    order.push_back(vertex);
  };
  for (const Id source : finder.Sources)
  {
    addRow(vertices.Of[source]);
  }
  for (std::size_t v = 0; v < rowOf.size(); ++v)
  {
    if (rowOf[v] == NoId)
    {
      addRow(static_cast<Id>(v));
      rows.AppendRow(nullptr, nullptr);
    }
  }
  for (Offset i = 0; i < rows.GetNumberOfEdges(); ++i)
  {
    rows.SetTarget(i, rowOf[vertices.Of[rows.Target(i)]]);
  }
  std::vector<Id> ranks;
  std::transform(order.begin(), order.end(), std::back_inserter(ranks),
    [&](Id vertex) { return vertices.Ranks[vertex]; });
  DirectionUnion(ranks).Unite(rows, 0, context.Parallel);
  return AssembleGraph(rows, order, isWide, context.Parallel,
    ProgressPart(context.Progress, FindingShare, 1.0), graph, vertices.Ranks.data());
}
}

Signature ComputeSignature(const SurfacePiece& piece)
{
  if (piece.NumberOfPoints == 0)
  {
    return {};
  }
  BitHash hash;
  const auto size = static_cast<std::size_t>(piece.NumberOfPoints);
  hash.Add(piece.Points, 3 * size);
  hash.Add(piece.PointIds, piece.PointIds ? size : 0);
  hash.Add(piece.CellIds, piece.CellIds ? static_cast<std::size_t>(piece.GetNumberOfCells()) : 0);
  for (const CellArrays& cells : piece.Cells)
  {
    if (cells.NumberOfCells > 0)
    {
      hash.Add(cells.Offsets, static_cast<std::size_t>(cells.NumberOfCells) + 1);
      hash.Add(cells.Ids, static_cast<std::size_t>(cells.NumberOfIds));
    }
  }
  return hash.Finish();
}

Signature SumSignatures(const std::vector<Signature>& pieces)
{
  Signature sum{ { 0, 0 } };
  for (const Signature& part : pieces)
  {
    sum[0] += part[0];
    sum[1] += part[1];
  }
  return sum;
}

Status ShareOptions(ProcessGroup& group, GraphOptions& options)
{
  struct
  {
    GraphConstruction Construction;
    double Accuracy;
    Id NumberOfNeighbors;
  } first{ options.Construction, options.Accuracy, options.NumberOfNeighbors };
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  options.Construction = first.Construction;
  options.Accuracy = first.Accuracy;
  options.NumberOfNeighbors = first.NumberOfNeighbors;
  return Status::Success();
}

Status BuildPieceGraph(const TaskContext& context, ProcessGroup& group, const SurfacePiece& piece,
  GraphOptions options, PieceGraph& graph, GraphEstimate& estimate,
  std::vector<std::string>& warnings, bool& isUsable)
{
  graph = PieceGraph();
  estimate = GraphEstimate();
  const bool isByNumber = options.Construction == GraphConstruction::SaddleVertexGraph;
  const bool isWide = !isByNumber && NeedsWideLengths(options.Accuracy);
  EdgeFinder finder(context, group, options, isWide);
  DGG_RETURN_IF_ERROR(finder.Run(piece, estimate, warnings, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(finder.ExchangeEdges());
  const auto n = static_cast<std::size_t>(piece.NumberOfPoints);
  const PieceVertices vertices(finder, n);
  DGG_RETURN_IF_ERROR(Assemble(context, finder, vertices, isWide, graph.Rows));
  graph.GhostIds = Buffer<Offset>(vertices.Points.size() - n);
  std::transform(vertices.Points.begin() + piece.NumberOfPoints, vertices.Points.end(),
    graph.GhostIds.begin(), [&](Id point) { return finder.Region.GetPointId(point); });
  graph.Owners = Buffer<Id>(vertices.Points.size());
  std::transform(
    vertices.Points.begin(), vertices.Points.end(), graph.Owners.begin(), [&](Id point) {
      const int owner = finder.Region.GetOwner(point);
      return owner == group.Here ? GhostVertices::Here : owner;
    });
  GraphInfo& info = graph.Rows.Info;
  info.Construction = options.Construction;
  info.Accuracy = isByNumber ? 0.0 : options.Accuracy;
  info.NumberOfNeighbors = isByNumber ? options.NumberOfNeighbors : 0;
  graph.Piece = ComputeSignature(piece);
  std::vector<Signature> signatures;
  DGG_RETURN_IF_ERROR(group.Share(graph.Piece, signatures));
  info.Surface = SumSignatures(signatures);
  return Status::Success();
}

Status JoinPieceGraphs(const std::vector<StoredPiece>& pieces, const Offset* globalIds,
  Offset numberOfPoints, GeodesicGraph& graph)
{
  graph = GeodesicGraph();
  graph.Offsets = Buffer<Offset>(static_cast<std::size_t>(numberOfPoints) + 1);
  std::fill(graph.Offsets.begin(), graph.Offsets.end(), 0);
  const auto forEachRow = [&](const auto& visit) {
    for (const StoredPiece& piece : pieces)
    {
      for (std::size_t row = 0; row < piece.Points->size(); ++row)
      {
        if (piece.Ghosts.Owners[row] == GhostVertices::Here)
        {
          visit(piece, (*piece.Points)[row], piece.Rows.Offsets[row], piece.Rows.Offsets[row + 1]);
        }
      }
    }
  };
  forEachRow([&](const StoredPiece&, Offset v, Offset begin, Offset end) {
    graph.Offsets[v + 1] += end - begin;
  });
  std::partial_sum(graph.Offsets.begin(), graph.Offsets.end(), graph.Offsets.begin());
  graph.Info = pieces.front().Rows.Info;
  const auto size = static_cast<std::size_t>(graph.Offsets[numberOfPoints]);
  const bool isWide = std::any_of(pieces.begin(), pieces.end(),
    [](const StoredPiece& piece) { return piece.Rows.WideLengths != nullptr; });
  graph.Targets = Buffer<Id>(size);
  graph.Lengths = Buffer<float>(isWide ? 0 : size);
  graph.WideLengths = Buffer<double>(isWide ? size : 0);
  graph.Angles = Buffer<float>(size);
  graph.ArrivalAngles = Buffer<float>(size);
  bool isComplete = true;
  forEachRow([&](const StoredPiece& piece, Offset v, Offset begin, Offset end) {
    const Offset to = graph.Offsets[v];
    for (Offset e = begin; e < end; ++e)
    {
      const auto target = static_cast<std::size_t>(piece.Rows.Targets[e]);
      const std::size_t points = piece.Points->size();
      const Offset* const last = globalIds + numberOfPoints;
      const Offset* const ghost = target < points
        ? last
        : std::lower_bound(globalIds, last, piece.Ghosts.Ids[target - points]);
      isComplete = isComplete &&
        (target < points || (ghost != last && *ghost == piece.Ghosts.Ids[target - points]));
      graph.Targets[to + e - begin] =
        static_cast<Id>(target < points ? (*piece.Points)[target] : ghost - globalIds);
    }
    const auto copy = [&](const auto* from, auto& values) {
      std::copy(from + begin, from + end, values.Data() + to);
    };
    isWide ? copy(piece.Rows.WideLengths, graph.WideLengths)
           : copy(piece.Rows.Lengths, graph.Lengths);
    copy(piece.Rows.Angles, graph.Angles);
    copy(piece.Rows.ArrivalAngles, graph.ArrivalAngles);
  });
  return isComplete
    ? Status::Success()
    : Status(Status::Code::DamagedGraph, "The pieces of a graph do not belong together");
}
}
