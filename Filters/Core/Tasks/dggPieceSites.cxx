// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSites.h"

#include "dggPieceSurface.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cstddef>

namespace dgg
{
namespace
{
/// Progress weight of the search for the nearest sites.
constexpr double NearestShare = 0.5;

/// The nearest site of a vertex.
struct NearestSite
{
  Id Site = NoId;
  LabelCorrection::Estimate Estimate{};
};

/// The label or the estimate of a site at the vertex with an index in PieceSearch::GetSent().
template <typename Value>
struct SiteValue
{
  Id Index;
  Id Site;
  Value Content;
};
}

PieceSites::PieceSites(PieceSearch& search, const PieceSurface& surface)
  : Search(search)
  , Surface(surface)
{
  std::vector<Id> vertices;
  for (std::size_t process = 0; process < search.GetSent().size(); ++process)
  {
    const std::vector<Id>& sent = search.GetSent()[process];
    for (std::size_t k = 0; k < sent.size(); ++k)
    {
      this->Readers.push_back({ process, static_cast<Id>(k) });
      vertices.push_back(sent[k]);
    }
  }
  this->ReadersOf =
    MakeGroups(vertices, static_cast<std::size_t>(search.GetGraph().NumberOfVertices));
}

Status PieceSites::Run(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
  const ProgressCallback& progress, Lists& entries, bool& isUsable)
{
  NearestSites nearest;
  DGG_RETURN_IF_ERROR(
    this->FindNearest(group, seeds, ProgressPart(progress, 0.0, NearestShare), nearest, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  const std::vector<GraphSeed> here = this->Search.TakeSeeds(seeds);
  FartherSites farther(this->Search.GetGraph(), &this->Search.GetCorrection(), nearest, here,
    this->FindLimits(nearest), this->Search.GetIds().data());
  DGG_RETURN_IF_ERROR(this->FindLabels(group, farther, ProgressPart(progress, NearestShare, 1.0)));
  DGG_RETURN_IF_ERROR(this->FindEstimates(group, farther, isUsable));
  entries = Lists();
  for (Id v = 0; v < this->Search.GetPointsHere() && isUsable; ++v)
  {
    if (this->Search.IsHere(v))
    {
      SiteDistances::AddList(nearest, farther, v, entries);
    }
    else
    {
      entries.EndList();
    }
  }
  return Status::Success();
}

/// Finds the nearest sites of all vertices.
Status PieceSites::FindNearest(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
  const ProgressCallback& progress, NearestSites& nearest, bool& isUsable) const
{
  PieceSearchOptions options;
  options.Correct = true;
  options.FindSources = true;
  options.FindRelays = true;
  options.Progress = progress;
  PieceDistances found;
  DGG_RETURN_IF_ERROR(this->Search.Run(group, seeds, options, found, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  std::vector<NearestSite> sites(
    static_cast<std::size_t>(this->Search.GetGraph().NumberOfVertices));
  for (std::size_t v = 0; v < found.Labels.size(); ++v)
  {
    sites[v] = { found.NearestSource[v], { found.Virtual[v], found.Corrected[v] } };
  }
  DGG_RETURN_IF_ERROR(this->Search.TakeFromOwners(group, sites));
  nearest.Labels = this->Search.GetLabels();
  for (const NearestSite& site : sites)
  {
    nearest.Sites.push_back(site.Site);
    nearest.Distances.push_back(site.Estimate.Distance);
    nearest.Sources.push_back(site.Estimate.Source);
  }
  return Status::Success();
}

/// Returns the limits of labels. Labels of vertices that belong to other processes are only
/// received.
std::vector<double> PieceSites::FindLimits(const NearestSites& nearest) const
{
  const std::vector<double> reach = this->Surface.ToPiece(
    MeasureReach(this->Surface.Get().GetMeshWithoutAngles()), this->Search.GetPointsHere(), 0.0);
  std::vector<double> limits(nearest.Sites.size(), -1.0);
  for (Id v = 0; v < this->Search.GetPointsHere(); ++v)
  {
    if (this->Search.IsHere(v))
    {
      limits[v] = LimitOfLabel(this->Search.GetGraph().Info, nearest.Labels[v], reach[v]);
    }
  }
  return limits;
}

Status PieceSites::FindLabels(
  ProcessGroup& group, FartherSites& farther, const ProgressCallback& progress)
{
  std::vector<Message> messages;
  for (bool isOver = false; !isOver;)
  {
    DGG_RETURN_IF_ERROR(farther.Run(progress));
    DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
    DGG_RETURN_IF_ERROR(this->Exchange(
      group, farther, farther.GetSettled(),
      [](const FartherSites::Label& label) { return label.Distance; }, messages, isOver));
    for (std::size_t process = 0; process < messages.size(); ++process)
    {
      for (const auto& label : MessageReader(messages[process]).Take<SiteValue<double>>())
      {
        farther.Receive(
          this->Search.GetReceived()[process][label.Index], label.Site, label.Content);
      }
    }
  }
  return Status::Success();
}

Status PieceSites::FindEstimates(ProcessGroup& group, FartherSites& farther, bool& isUsable)
{
  const std::vector<FartherSites::Label>& labels = farther.GetLabels();
  std::vector<Id> left; // labels without estimates
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (this->Search.IsHere(labels[i].Vertex))
    {
      left.push_back(static_cast<Id>(i));
    }
  }
  std::sort(
    left.begin(), left.end(), [&](Id a, Id b) { return labels[a].Distance < labels[b].Distance; });
  std::vector<Message> messages;
  for (bool isOver = false; !isOver;)
  {
    std::vector<Id> found;
    left.erase(std::remove_if(left.begin(), left.end(),
                 [&](Id label) {
                   const bool isKnown = farther.Estimate(label);
                   found.insert(found.end(), isKnown ? 1 : 0, label);
                   return isKnown;
                 }),
      left.end());
    DGG_RETURN_IF_ERROR(this->Exchange(
      group, farther, found, [](const FartherSites::Label& label) { return label.Estimate; },
      messages, isOver));
    for (std::size_t process = 0; process < messages.size(); ++process)
    {
      for (const auto& label :
        MessageReader(messages[process]).Take<SiteValue<LabelCorrection::Estimate>>())
      {
        farther.ReceiveEstimate(
          this->Search.GetReceived()[process][label.Index], label.Site, label.Content);
      }
    }
  }
  isUsable = left.empty(); // unless an edge does not lengthen a path
  return group.Require(isUsable);
}

/// Sends `valueOf(label)` of labels to the processes that have their vertices as ghosts.
template <typename Value>
Status PieceSites::Exchange(ProcessGroup& group, const FartherSites& farther,
  const std::vector<Id>& labels, const Value& valueOf, std::vector<Message>& messages,
  bool& isOver) const
{
  using Sent = SiteValue<decltype(valueOf(farther.GetLabels()[0]))>;
  std::vector<std::vector<Sent>> lists(this->Search.GetSent().size());
  for (const Id i : labels)
  {
    const FartherSites::Label& label = farther.GetLabels()[i];
    for (Offset k = this->ReadersOf.Begins[label.Vertex];
         k < this->ReadersOf.Begins[label.Vertex + 1]; ++k)
    {
      const Reader& reader = this->Readers[this->ReadersOf.Members[k]];
      lists[reader.Process].push_back({ reader.Index, label.Site, valueOf(label) });
    }
  }
  messages.assign(lists.size(), Message());
  for (std::size_t process = 0; process < lists.size(); ++process)
  {
    AppendIfAny(messages[process], lists[process]);
  }
  return group.Exchange(messages,
    this->Search.GetMemorySize() +
      static_cast<double>(farther.GetLabels().size() * sizeof(FartherSites::Label)),
    &isOver);
}
}
