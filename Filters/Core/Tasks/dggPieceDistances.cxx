// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceDistances.h"

#include "dggDistanceOutput.h"
#include "dggGraphSession.h"
#include "dggPieceLinks.h"
#include "dggPieceSearch.h"
#include "dggPieceVirtualSources.h"
#include "dggPreparedSurface.h"
#include "dggSourceCollection.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dgg
{
Status MakePieceSeeds(ProcessGroup& group, const PieceSearch& search, PieceLinks* links,
  const SourceCollection& sources, const PieceDistanceOptions& options,
  std::vector<PieceSeed>& seeds, std::vector<std::size_t>& isolated)
{
  DGG_RETURN_IF_ERROR(sources.Check(search.GetNumberOfPoints()));
  for (std::size_t i = 0; i < sources.Ids.size(); ++i)
  {
    const double offset = sources.GetInitialDistanceOfId(i);
    seeds.push_back(
      { search.GetFirstId() + sources.Ids[i], { NoId, offset, offset, static_cast<Id>(i), -1.0 } });
  }
  DGG_RETURN_IF_ERROR(search.FindIsolated(group, seeds, isolated));
  return sources.GetNumberOfPositions() > 0
    ? links->Find(group, sources, options.Tolerance, options.Accuracy, seeds)
    : Status::Success();
}

Status WritePieceDistances(ProcessGroup& group, DistanceResults& results,
  const DistanceRequest& request, DistanceOutput& output)
{
  const PreparedSurface none; // every point is a vertex
  output.IsReached = FindReached(none, results);
  bool areAllReached =
    std::find(output.IsReached.begin(), output.IsReached.end(), false) == output.IsReached.end();
  DGG_RETURN_IF_ERROR(group.Require(areAllReached));
  results.AreOthersUnreached = !areAllReached;
  WriteDistances(none, results, output.IsReached, request, output);
  return Status::Success();
}

Status FindPieceDistances(const TaskContext& context, ProcessGroup& group, PieceSearch& search,
  PieceLinks* links, const PieceVirtualSources* virtualSources, const SourceCollection& sources,
  const PieceDistanceOptions& options, const DistanceRequest& request, DistanceOutput& output,
  bool& isDone)
{
  std::vector<PieceSeed> seeds;
  std::vector<std::size_t> isolated;
  DGG_RETURN_IF_ERROR(MakePieceSeeds(group, search, links, sources, options, seeds, isolated));
  double smallestOffset = Infinity;
  for (const PieceSeed& seed : seeds)
  {
    smallestOffset = std::min(smallestOffset, seed.Seed.InitialDistance);
  }
  PieceSearchOptions wanted;
  wanted.MaximumDistance = options.Correct
    ? GraphSession::WidenLimit(request.MaximumDistance, smallestOffset, options.Accuracy)
    : request.MaximumDistance;
  wanted.Correct = options.Correct || request.WantVirtualSource;
  wanted.FindSources = request.WantNearestSource;
  wanted.FindRelays = request.WantVirtualSource;
  wanted.Progress = context.Progress;
  PieceDistances found;
  DGG_RETURN_IF_ERROR(search.Run(group, seeds, wanted, found, isDone));
  if (isDone && options.Correct && request.WantVirtualSource)
  {
    DGG_RETURN_IF_ERROR(
      virtualSources->CheckTriangles(group, found.Labels, options.Accuracy, isDone));
  }
  if (!isDone)
  {
    return Status::Success();
  }
  DistanceResults results;
  const std::vector<double>& distances = options.Correct ? found.Corrected : found.Labels;
  if (request.WantVirtualSource)
  {
    DGG_RETURN_IF_ERROR(virtualSources->Find(
      group, found, distances, context.Parallel, search.GetMemorySize(), results.VirtualSource));
  }
  results.MaximumDistance = request.MaximumDistance;
  results.Arrays = request.Arrays;
  for (VertexArray& array : results.Arrays)
  {
    array.Components = { found.Labels };
  }
  results.Distances = distances;
  results.NearestSource = std::move(found.NearestSource);
  const std::string warning = sources.DescribeIsolated(isolated, false);
  if (group.Here == 0 && !warning.empty())
  {
    output.Warnings.push_back(warning);
  }
  return WritePieceDistances(group, results, request, output);
}
}
