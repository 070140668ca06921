// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPieceSearches.h"

#include "DGGFilterInternals.h"
#include "DGGGraphUser.h"
#include "DGGProcesses.h"

#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkPolyData.h"

#include <type_traits>

namespace
{
/// Progress after the preparation of searches.
constexpr double PreparedAt = 0.5;
}

//------------------------------------------------------------------------------
dgg::Status DGGPieceSearches::Prepare(const DGGContext& context, const DGGPieceUpdate& update,
  Needs needs, DGGGraphUser& user, vtkObject* filter, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  bool isPrepared = this->IsKept;
  this->IsKept = false; // unless this update succeeds
  DGGContext building = context;
  building.Progress = dgg::ProgressPart(context.Progress, 0.0, PreparedAt);
  DGG_RETURN_IF_ERROR(user.UpdatePiece(building, group, update.Piece, filter, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const DGGGraphArrays& graph = user.GetPiece();
  const double accuracy = graph.GetView().Info.Accuracy;
  this->Accuracy = accuracy > 0.0 ? accuracy : user.GetAccuracy();
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(this->Accuracy));
  isPrepared = isPrepared && this->Key == graph.GetKey();
  DGG_RETURN_IF_ERROR(group.Require(isPrepared));
  this->Done = isPrepared ? 0.0 : PreparedAt;
  if (!isPrepared)
  {
    this->Search.reset();
    this->Links.reset();
    this->VirtualSources.reset();
    this->Surface.reset();
    this->Key = graph.GetKey();
  }
  const auto prepare = [&](bool isNeeded, auto& part, const auto&... arguments) {
    bool isReady = !isNeeded || part;
    if (isDone)
    {
      DGG_RETURN_IF_ERROR(group.Require(isReady));
      if (!isReady)
      {
        part = std::make_unique<typename std::decay_t<decltype(part)>::element_type>();
        DGG_RETURN_IF_ERROR(part->Prepare(group, update.Piece, arguments..., isDone));
      }
    }
    return dgg::Status::Success();
  };
  DGG_RETURN_IF_ERROR(prepare(true, this->Search, graph.GetView(), graph.GetGraph().GetGhosts()));
  isDone = isDone && this->Search->HasConsecutiveIds();
  DGG_RETURN_IF_ERROR(prepare(needs.Links, this->Links));
  DGG_RETURN_IF_ERROR(prepare(needs.VirtualSources, this->VirtualSources));
  DGG_RETURN_IF_ERROR(prepare(needs.Surface, this->Surface));
  if (!isDone)
  {
    user.RefusePiece();
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGPieceSearches::Keep(DGGGraphUser& user, vtkObject* filter)
{
  user.UsePiece(filter);
  this->IsKept = true;
}

//------------------------------------------------------------------------------
dgg::Status DGGCollectFromAll(const DGGPieceUpdate& update, DGGSourceSet set,
  dgg::SourceCollection& sources, vtkSmartPointer<vtkPolyData>& points, bool& areUsable)
{
  dgg::ProcessGroup& group = update.Group;
  vtkDataObject* here = vtkDataObject::GetData(update.Inputs[set.Port]);
  bool isEmpty = here == nullptr;
  DGG_RETURN_IF_ERROR(group.Require(isEmpty));
  if (!isEmpty)
  {
    DGG_RETURN_IF_ERROR(update.Processes.JoinOnFirst(group, here, points));
  }
  set.Points = points;
  DGG_RETURN_IF_ERROR(DGGCollect(set, sources));
  sources.IsConnected = !isEmpty;
  DGG_RETURN_IF_ERROR(group.TakeListFromFirst(sources.Ids));
  DGG_RETURN_IF_ERROR(group.TakeListFromFirst(sources.InitialDistancesOfIds));
  DGG_RETURN_IF_ERROR(group.TakeListFromFirst(sources.Positions));
  DGG_RETURN_IF_ERROR(group.TakeListFromFirst(sources.InitialDistances));
  areUsable = sources.OriginalIds.empty() && (sources.Cells.empty() || sources.Barycentric.empty());
  return group.Require(areUsable);
}
