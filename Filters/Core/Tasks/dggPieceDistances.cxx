// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceDistances.h"

#include "dggDistanceOutput.h"
#include "dggGraphSession.h"
#include "dggPieceLinks.h"
#include "dggPieceSearch.h"
#include "dggPreparedSurface.h"
#include "dggSourceCollection.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dgg
{
Status FindPieceDistances(ProcessGroup& group, PieceSearch& search, PieceLinks* links,
  const SourceCollection& sources, const PieceDistanceOptions& options,
  const DistanceRequest& request, const ProgressCallback& progress, DistanceOutput& output,
  bool& isDone)
{
  DGG_RETURN_IF_ERROR(sources.Check(search.GetNumberOfPoints()));
  std::vector<PieceSeed> seeds;
  for (std::size_t i = 0; i < sources.Ids.size(); ++i)
  {
    const double offset = sources.GetInitialDistanceOfId(i);
    seeds.push_back(
      { search.GetFirstId() + sources.Ids[i], { NoId, offset, offset, static_cast<Id>(i), -1.0 } });
  }
  std::vector<std::size_t> isolated;
  DGG_RETURN_IF_ERROR(search.FindIsolated(group, seeds, isolated));
  if (sources.GetNumberOfPositions() > 0)
  {
    DGG_RETURN_IF_ERROR(links->Find(group, sources, options.Tolerance, options.Accuracy, seeds));
  }
  double smallestOffset = Infinity;
  for (const PieceSeed& seed : seeds)
  {
    smallestOffset = std::min(smallestOffset, seed.Seed.InitialDistance);
  }
  PieceSearchOptions wanted;
  wanted.MaximumDistance = options.Correct
    ? GraphSession::WidenLimit(request.MaximumDistance, smallestOffset, options.Accuracy)
    : request.MaximumDistance;
  wanted.Correct = options.Correct;
  wanted.FindSources = request.WantNearestSource;
  wanted.Progress = progress;
  PieceDistances found;
  DGG_RETURN_IF_ERROR(search.Run(group, seeds, wanted, found, isDone));
  if (!isDone)
  {
    return Status::Success();
  }
  DistanceResults results;
  results.MaximumDistance = request.MaximumDistance;
  results.Arrays = request.Arrays;
  for (VertexArray& array : results.Arrays)
  {
    array.Components = { found.Labels };
  }
  results.Distances = std::move(options.Correct ? found.Corrected : found.Labels);
  results.NearestSource = std::move(found.NearestSource);
  const std::string warning = sources.DescribeIsolated(isolated, false);
  if (group.Here == 0 && !warning.empty())
  {
    output.Warnings.push_back(warning);
  }
  const PreparedSurface none; // every point is a vertex
  output.IsReached = FindReached(none, results);
  WriteDistances(none, results, output.IsReached, request, output);
  return Status::Success();
}
}
