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
#include <utility>

namespace dgg
{
Status FindPieceDistances(const ProcessGroup& group, PieceSearch& search, PieceLinks* links,
  const SourceCollection& sources, double tolerance, bool correct, double accuracy,
  const DistanceRequest& request, const ProgressCallback& progress, DistanceOutput& output)
{
  DGG_RETURN_IF_ERROR(group.Agree(sources.Check(search.GetNumberOfPoints())));
  std::vector<PieceSeed> seeds;
  for (std::size_t i = 0; i < sources.Ids.size(); ++i)
  {
    const double offset = sources.GetInitialDistanceOfId(i);
    seeds.push_back({ sources.Ids[i], { NoId, offset, offset, static_cast<Id>(i), -1.0 } });
  }
  if (links)
  {
    DGG_RETURN_IF_ERROR(links->Find(group, sources, tolerance, accuracy, seeds));
  }
  double smallestOffset = Infinity;
  for (const PieceSeed& seed : seeds)
  {
    smallestOffset = std::min(smallestOffset, seed.Seed.InitialDistance);
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
