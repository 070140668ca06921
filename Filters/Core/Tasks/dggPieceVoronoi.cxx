// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceVoronoi.h"

#include "dggDistanceOutput.h"
#include "dggPieceDistances.h"
#include "dggPieceSurface.h"
#include "dggSourceCollection.h"
#include "dggVoronoiTask.h"

#include <cstddef>
#include <vector>

namespace dgg
{
Status FindPieceLabels(const TaskContext& context, ProcessGroup& group, const PieceSurface& surface,
  PieceSearch& search, PieceLinks* links, const SourceCollection& collection,
  const PieceDistanceOptions& options, const VoronoiOptions& voronoi, DistanceOutput& labels,
  Output& sites, bool& isDone)
{
  DistanceRequest request;
  request.UnreachedValue = voronoi.UnreachedValue;
  request.WantNearestSource = true;
  request.Names = { voronoi.DistanceName, voronoi.SourceName, "" };
  DGG_RETURN_IF_ERROR(FindPieceDistances(
    context, group, search, links, nullptr, collection, options, request, labels, isDone));
  if (!isDone)
  {
    return Status::Success();
  }
  labels.PointScalars = voronoi.SourceName;
  PiecePoints here; // sites of this process
  if (collection.GetNumberOfPositions() > 0)
  {
    DGG_RETURN_IF_ERROR(surface.Locate(group, collection, options.Tolerance, here));
  }
  const std::size_t ids = collection.Ids.size();
  for (std::size_t& site : here.Indices)
  {
    site += ids;
  }
  for (std::size_t i = 0; i < ids; ++i)
  {
    surface.AddVertex(collection.Ids[i], i, group.Here, here);
  }
  DGG_RETURN_IF_ERROR(surface.WritePoints(context, group, here, sites));
  AddSiteIds(sites);
  return Status::Success();
}
}
