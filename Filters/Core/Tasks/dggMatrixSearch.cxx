// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMatrixSearch.h"

#include "dggBlockLoop.h"
#include "dggGraphBuilder.h"
#include "dggGraphSearch.h"
#include "dggGraphSeeds.h"
#include "dggGraphSession.h"
#include "dggMatrixRows.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <string>

namespace dgg
{
namespace
{
/// Progress at the end of the steps.
constexpr double SourcesLinked = 0.05;
constexpr double TargetsLinked = 0.1;

/// Number of points that a thread links between reports of the progress.
constexpr std::size_t LinkBlock = 16;

/// Entries of a matrix that is stored row by row.
struct MatrixEntries
{
  double* Values;
  std::size_t NumberOfColumns;
  bool SourcesAreRows;

  double& operator()(std::size_t source, std::size_t target) const
  {
    return this->SourcesAreRows ? this->Values[source * this->NumberOfColumns + target]
                                : this->Values[target * this->NumberOfColumns + source];
  }
};

/// Finds the distances of all points of one set from all points of another set in a graph.
class MatrixSearch
{
public:
  using Points = std::vector<SurfacePoint>;
  using Links = std::vector<std::vector<GraphLink>>; // per point

  /// `graph` must be up to date, and all entries must be Infinity. distances(i, j) becomes the
  /// distance of sources[i] from targets[j].
  MatrixSearch(const TaskContext& context, GraphSession& graph, const Points& sources,
    const Points& targets, const MatrixEntries& distances);

  /// Finds all distances. With `symmetric`, targets and sources are the same points: one half is
  /// searched and mirrored. Entries without a path or above `radius` become `unreachedValue`.
  Status Run(bool symmetric, double radius, double unreachedValue);

private:
  template <typename EntryType>
  Status LinkPoints(
    const Points& points, const Points& others, double end, Links& links, EntryType entry);
  Status Search(double radius);
  void Mirror() const;

  const TaskContext& Context;
  GraphSession& Graph;
  const Points& Sources;
  const Points& Targets;
  const MatrixEntries& Distances;
  bool IsSymmetric = false;
  Links SourceLinks;
  Links TargetLinks;
  const ProgressCallback Progress;
  double Done = 0.0; // progress so far
};

MatrixSearch::MatrixSearch(const TaskContext& context, GraphSession& graph, const Points& sources,
  const Points& targets, const MatrixEntries& distances)
  : Context(context)
  , Graph(graph)
  , Sources(sources)
  , Targets(targets)
  , Distances(distances)
  , Progress(graph.GetRemainingProgress(context))
{
}

/// Links the points of one set. The lengths of straight paths to points of the other set, where
/// neither point is a vertex, are entered as distances.
template <typename EntryType>
Status MatrixSearch::LinkPoints(
  const Points& points, const Points& others, double end, Links& links, EntryType entry)
{
  std::vector<std::size_t> aims;
  Points aimPoints;
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    if (!IsVertex(others[i]))
    {
      aims.push_back(i);
      aimPoints.push_back(others[i]);
    }
  }
  const Points none;
  links.assign(points.size(), {});
  const double start = this->Done;
  this->Done = end;
  return ForEach(points.size(), LinkBlock, this->Context.Parallel,
    ProgressPart(this->Progress, start, end), [&](std::size_t i, const ProgressCallback&) {
      std::vector<double> direct;
      const Status status =
        this->Graph.Link(points[i], IsVertex(points[i]) ? none : aimPoints, links[i], direct);
      for (std::size_t a = 0; a < direct.size(); ++a)
      {
        double& distance = entry(i, aims[a]);
        distance = std::min(distance, direct[a]);
      }
      return status;
    });
}

Status MatrixSearch::Run(bool symmetric, double radius, double unreachedValue)
{
  this->IsSymmetric = symmetric;
  const bool areVertices = std::all_of(this->Sources.begin(), this->Sources.end(), IsVertex) &&
    std::all_of(this->Targets.begin(), this->Targets.end(), IsVertex);
  DGG_RETURN_IF_ERROR(this->Graph.PrepareBuilder(this->Context, !areVertices));
  DGG_RETURN_IF_ERROR(
    this->LinkPoints(this->Sources, this->Targets, SourcesLinked, this->SourceLinks,
      [this](std::size_t i, std::size_t j) -> double& { return this->Distances(i, j); }));
  if (symmetric)
  {
    this->TargetLinks = this->SourceLinks;
  }
  else
  {
    // Find straight paths from the targets too: the windows from one end may lack a path that the
    // windows from the other end contain, and distances must not depend on the direction.
    DGG_RETURN_IF_ERROR(
      this->LinkPoints(this->Targets, this->Sources, TargetsLinked, this->TargetLinks,
        [this](std::size_t j, std::size_t i) -> double& { return this->Distances(i, j); }));
  }
  DGG_RETURN_IF_ERROR(this->Search(radius));
  if (symmetric)
  {
    this->Mirror();
  }
  std::replace_if(
    this->Distances.Values, this->Distances.Values + this->Sources.size() * this->Targets.size(),
    [radius](double distance) { return distance == Infinity || distance > radius; },
    unreachedValue);
  return Status::Success();
}

Status MatrixSearch::Search(double radius)
{
  MatrixRowLinks links;
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    AppendSeeds(this->SourceLinks[i], links.Seeds, static_cast<Id>(i));
  }
  for (std::size_t j = 0; j < this->Targets.size(); ++j)
  {
    for (const GraphLink& link : this->TargetLinks[j])
    {
      links.Targets.push_back({ static_cast<Id>(j), link.Vertex, link.Length });
    }
  }
  MatrixRowOptions options;
  options.NumberOfSources = this->Sources.size();
  options.SearchRadius = radius;
  options.HasTargets = true;
  options.IsSymmetric = this->IsSymmetric;
  return FindMatrixRows(this->Context, this->Graph.GetSearch(), links, options,
    ProgressPart(this->Progress, this->Done, 1.0),
    [this](std::size_t source, const DistanceRow& row) {
      for (const RowEntry& entry : row)
      {
        double& distance = this->Distances(source, static_cast<std::size_t>(entry.Column));
        distance = std::min(distance, entry.Distance);
      }
    });
}

void MatrixSearch::Mirror() const
{
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    this->Distances(i, i) = 0.0;
    for (std::size_t j = i + 1; j < this->Sources.size(); ++j)
    {
      const double distance = std::min(this->Distances(i, j), this->Distances(j, i));
      this->Distances(i, j) = distance;
      this->Distances(j, i) = distance;
    }
  }
}
}

Status AllocateMatrix(const MemoryBudget& memory, std::size_t rows, std::size_t columns,
  bool withTable, bool withCopy, Buffer<double>& matrix)
{
  const double bytes = static_cast<double>(rows) * static_cast<double>(columns) * sizeof(double);
  const std::string what = JoinText("A matrix of ", rows, " rows and ", columns, " columns");
  DGG_RETURN_IF_ERROR(withTable ? memory.Check(what + " with its table", 2.0 * bytes,
                                    "Use fewer points at a time, turn off {GenerateTable}")
                                : memory.Check(what + (withCopy ? " with its copy" : ""),
                                    (withCopy ? 2.0 : 1.0) * bytes, "Use fewer points at a time"));
  matrix = MakeUnreached(rows * columns);
  return Status::Success();
}

Buffer<double> MakeUnreached(std::size_t size)
{
  Buffer<double> entries(size);
  std::fill(entries.begin(), entries.end(), Infinity);
  return entries;
}

Status FindMatrix(const TaskContext& context, GraphSession& graph,
  const std::vector<SurfacePoint>& rows, const std::vector<SurfacePoint>* columns, double radius,
  double unreachedValue, double* matrix)
{
  const std::vector<SurfacePoint>& others = columns ? *columns : rows;
  const bool sourcesAreRows = rows.size() <= others.size(); // searches start from the smaller set
  const MatrixEntries entries{ matrix, others.size(), sourcesAreRows };
  return MatrixSearch(
    context, graph, sourcesAreRows ? rows : others, sourcesAreRows ? others : rows, entries)
    .Run(!columns, radius, unreachedValue);
}

void CopyColumns(const double* matrix, std::size_t numberOfRows,
  const std::vector<double*>& columns, const ParallelFor& parallel)
{
  parallel(static_cast<Offset>(columns.size()), 1, [&](Offset begin, Offset end) {
    for (std::size_t i = 0; i < numberOfRows; ++i)
    {
      for (Offset j = begin; j < end; ++j)
      {
        columns[j][i] = matrix[i * columns.size() + j];
      }
    }
  });
}

Status FindDistanceRows(const TaskContext& context, GraphSession& graph,
  const std::vector<GeodesicSource>& sources, double radius, bool correct, DistanceRows& rows)
{
  MatrixRowLinks links;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, sources, links.Seeds));
  MatrixRowOptions wanted;
  wanted.NumberOfSources = sources.size();
  wanted.Correct = correct && !context.Surface.IsCloud();
  wanted.MaximumDistance = radius;
  wanted.SearchRadius = wanted.Correct ? graph.WidenLimit(radius, sources) : radius;
  const auto search = [&](const ProgressCallback& progress, const RowConsumer& consume) {
    return FindMatrixRows(context, graph.GetSearch(), links, wanted, progress, consume);
  };
  const DistanceRowsOptions options{ context.Memory.GetBytes(), FindNextPoints(context.Surface) };
  return CompressRows(sources.size(), search, options, graph.GetRemainingProgress(context), rows);
}
}
