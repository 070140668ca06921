// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceDistances.h"

#include "dggDistanceOutput.h"
#include "dggGraphSession.h"
#include "dggPieceSearch.h"
#include "dggPreparedSurface.h"
#include "dggSourceCollection.h"

#include <algorithm>
#include <utility>

namespace dgg
{
Status FindPieceDistances(const ProcessGroup& group, PieceSearch& search,
  const SourceCollection& sources, bool correct, double accuracy, const DistanceRequest& request,
  const ProgressCallback& progress, DistanceOutput& output)
{
  DGG_RETURN_IF_ERROR(group.Agree(sources.Check(search.GetNumberOfPoints())));
  std::vector<PieceSeed> seeds;
  double smallestOffset = Infinity;
  for (std::size_t i = 0; i < sources.Ids.size(); ++i)
  {
    const double offset =
      sources.InitialDistancesOfIds.empty() ? 0.0 : sources.InitialDistancesOfIds[i];
    seeds.push_back({ sources.Ids[i], { NoId, offset, offset, static_cast<Id>(i), -1.0 } });
    smallestOffset = std::min(smallestOffset, offset);
  }
  PieceSearchOptions options;
  options.MaximumDistance = correct
    ? GraphSession::WidenLimit(request.MaximumDistance, smallestOffset, accuracy)
    : request.MaximumDistance;
  options.Correct = correct;
  options.FindSources = request.WantNearestSource;
  options.Progress = progress;
  PieceDistances found;
  DGG_RETURN_IF_ERROR(search.Run(group, seeds, options, found));
  return group.Run([&] {
    DistanceResults results;
    results.MaximumDistance = request.MaximumDistance;
    results.Arrays = request.Arrays;
    for (VertexArray& array : results.Arrays)
    {
      array.Components = { found.Labels };
    }
    results.Distances = std::move(correct ? found.Corrected : found.Labels);
    results.NearestSource = std::move(found.NearestSource);
    const PreparedSurface none; // every point is a vertex
    output.IsReached = FindReached(none, results);
    WriteDistances(none, results, output.IsReached, request, output);
    return Status::Success();
  });
}
}
