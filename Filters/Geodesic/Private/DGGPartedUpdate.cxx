// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPartedUpdate.h"

#include "dggFreeMemory.h"
#include "dggPieceGraph.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggStatus.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <list>
#include <new>
#include <numeric>

namespace
{
vtkDataObject* GetData(vtkInformationVector* vector)
{
  return vtkDataObject::GetData(vector, 0);
}

/// Runs a step and converts exhausted memory to an error, because other processes wait for the
/// status of this one.
dgg::Status Guard(const std::function<dgg::Status()>& step)
{
  try
  {
    return step();
  }
  catch (const std::bad_alloc&)
  {
    return dgg::Status(dgg::Status::Code::OutOfMemory,
      "Memory is exhausted while the pieces of the input are joined")
      .Fix("Use a smaller surface");
  }
}

void Add(vtkInformationVector* vector, vtkDataObject* data)
{
  vtkNew<vtkInformation> info;
  info->Set(vtkDataObject::DATA_OBJECT(), data);
  vector->Append(info);
}
}

//------------------------------------------------------------------------------
bool DGGPartedUpdate::IsPlain(vtkInformationVector** inputs, int numberOfInputs)
{
  for (int port = 0; port < numberOfInputs; ++port)
  {
    if (vtkCompositeDataSet::SafeDownCast(GetData(inputs[port])))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
dgg::Status DGGPartedUpdate::Join(vtkDataObject* input, vtkSmartPointer<vtkPolyData>& whole)
{
  vtkIdType others = 0;
  std::vector<DGGSurfacePart> parts = DGGFindParts(input, others);
  for (DGGSurfacePart& part : parts)
  {
    DGG_RETURN_IF_ERROR(DGGRemoveGhosts(part.Data));
  }
  DGGJoinedParts joined;
  DGG_RETURN_IF_ERROR(joined.Join(parts));
  whole = joined.GetWhole();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGPartedUpdate::Run(const DGGProcesses& processes, dgg::ProcessGroup& group,
  vtkIdType limit, vtkTypeUInt64 memory, vtkInformationVector** inputs, int numberOfInputs,
  vtkInformationVector* outputs, bool passesSurface, const Step& step)
{
  if (!(processes == this->Processes))
  {
    this->Ports.clear();
    this->Processes = processes;
  }
  this->Ports.resize(static_cast<std::size_t>(numberOfInputs));
  const dgg::Status gathered = this->FindParts(processes, limit, memory, inputs);
  if (!gathered.IsOk())
  {
    this->Ports.clear(); // forces a search for the parts in the next update
    return gathered;
  }
  const dgg::Status computed = group.Agree(processes.IsFirst()
      ? Guard([&] { return this->Compute(inputs, outputs, passesSurface, step); })
      : step(nullptr, nullptr));
  if (!computed.IsOk())
  {
    this->Outputs.clear();
    this->Results.clear();
    return computed;
  }
  for (int port = passesSurface ? 1 : 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    output->Initialize();
    if (processes.IsFirst())
    {
      output->ShallowCopy(this->Outputs[port]);
    }
  }
  if (passesSurface)
  {
    processes.Scatter(this->Ports[0].Counts, this->Results);
    // If the first process has the graph of the entire surface, the others have none.
    bool hasGraph = true;
    if (processes.IsFirst())
    {
      vtkFieldData* data = this->Outputs[0]->GetFieldData();
      hasGraph = DGGGraphArrays::AreOfEntireSurface(data) && !this->Graph.IsIn(data);
    }
    hasGraph = processes.AndAll({ hasGraph ? 1 : 0 })[0] != 0;
    this->Deliver(
      GetData(inputs[0]), vtkDataObject::GetData(outputs, 0), hasGraph && !processes.IsFirst());
  }
  this->Outputs.clear();
  this->Results.clear();
  return gathered;
}

//------------------------------------------------------------------------------
/// Finds the parts on this process. Gathers parts of ports that have changed on any process.
dgg::Status DGGPartedUpdate::FindParts(const DGGProcesses& processes, vtkIdType limit,
  vtkTypeUInt64 memory, vtkInformationVector** inputs)
{
  std::vector<int> isSame;
  vtkIdType numberOfPoints = 0;
  this->Others = 0;
  const dgg::Status here = Guard([&] {
    for (std::size_t p = 0; p < this->Ports.size(); ++p)
    {
      Port& port = this->Ports[p];
      vtkIdType others = 0;
      std::vector<DGGSurfacePart> parts = DGGFindParts(GetData(inputs[p]), others);
      this->Others += others;
      std::vector<PartKey> key;
      for (const DGGSurfacePart& part : parts)
      {
        key.emplace_back(part.Data, part.Data->GetMTime(), part.Block);
        numberOfPoints += part.Data->GetNumberOfPoints();
      }
      isSame.push_back(port.Joined.GetWhole() && key == port.Key ? 1 : 0);
      if (!isSame.back())
      {
        port.Key.clear();
        for (DGGSurfacePart& part : parts)
        {
          DGG_RETURN_IF_ERROR(DGGRemoveGhosts(part.Data));
        }
        port.Parts = parts;
        port.Key = key;
      }
    }
    return dgg::Status::Success();
  });
  DGG_RETURN_IF_ERROR(processes.Agree(here));
  const vtkIdType sum = processes.Sum(numberOfPoints);
  // The limits of processes may differ.
  DGG_RETURN_IF_ERROR(processes.Agree(processes.IsFirst() && sum > limit
      ? dgg::InvalidInput("The pieces of all processes have ", sum,
          " points together, more than the {GatherLimit} of ", limit)
          .At("GatherLimit")
          .Fix("Raise {GatherLimit} if the first process has the memory, or use a smaller surface")
      : dgg::Status::Success()));
  isSame = processes.AndAll(isSame);
  DGG_RETURN_IF_ERROR(this->CheckMemory(processes, memory, isSame));
  dgg::Status joined;
  for (std::size_t p = 0; p < this->Ports.size(); ++p)
  {
    Port& port = this->Ports[p];
    if (isSame[p])
    {
      continue;
    }
    std::vector<DGGSurfacePart> all = port.Parts;
    const dgg::Status gathered = processes.Gather(all, port.Counts);
    joined = joined.IsOk() ? gathered : joined;
    if (joined.IsOk() && processes.IsFirst())
    {
      joined = Guard([&] { return port.Joined.Join(all); });
    }
    else
    {
      port.Joined.Join({}); // creates the joined surface, even if it is not used
    }
    if (p == 0)
    {
      DGG_RETURN_IF_ERROR(processes.Agree(joined));
      joined = this->JoinGraphs(processes, all);
    }
  }
  return processes.Agree(joined);
}

//------------------------------------------------------------------------------
/// Joins the graphs of pieces, if all parts have one, on the first process.
dgg::Status DGGPartedUpdate::JoinGraphs(
  const DGGProcesses& processes, const std::vector<DGGSurfacePart>& all)
{
  this->JoinedGraph = dgg::GeodesicGraph();
  this->Graph.Clear();
  const std::vector<DGGSurfacePart>& here = this->Ports[0].Parts;
  const bool isPiece = here.size() == 1 && DGGGraphArrays::AreOfPiece(here[0].Data->GetFieldData());
  if (processes.AndAll({ isPiece ? 1 : 0 })[0] == 0)
  {
    return dgg::Status::Success();
  }
  DGGArrayList arrays;
  vtkNew<vtkFieldData> graph;
  DGGGraphArrays::Pass(here[0].Data->GetFieldData(), graph);
  for (int i = 0; i < graph->GetNumberOfArrays(); ++i)
  {
    arrays.emplace_back(graph->GetAbstractArray(i));
  }
  const std::vector<DGGArrayList> gathered = processes.GatherArrays(arrays);
  return processes.IsFirst() ? Guard([&] { return this->JoinGraphsHere(gathered, all); })
                             : dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Joins the graphs of pieces, unless one is damaged or belongs to another surface.
dgg::Status DGGPartedUpdate::JoinGraphsHere(
  const std::vector<DGGArrayList>& arrays, const std::vector<DGGSurfacePart>& all)
{
  std::vector<dgg::Signature> signatures;
  std::vector<dgg::StoredPiece> pieces;
  std::list<DGGGraphArrays> graphs;
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    DGGSurfaceArrays copies(all[p].Data, true, false);
    signatures.push_back(dgg::ComputeSignature(DGGConvertPart(all[p], copies)));
    vtkNew<vtkFieldData> data;
    for (const vtkSmartPointer<vtkAbstractArray>& array : arrays[p])
    {
      data->AddArray(array);
    }
    std::string complaint;
    DGGGraphArrays& graph = graphs.emplace_back();
    if (!graph.FindPiece(data, all[p].Data->GetNumberOfPoints(), {}, complaint) ||
      !graph.GetGraph().IsOf(signatures.back()))
    {
      return dgg::Status::Success(); // the step complains
    }
    pieces.push_back(
      { graph.GetView(), graph.GetGraph().GetGhosts(), &this->Ports[0].Joined.GetPointIds(p) });
  }
  const dgg::Signature signature = dgg::SumSignatures(signatures);
  const dgg::GraphInfo& first = pieces.front().Rows.Info;
  const bool fits = std::all_of(pieces.begin(), pieces.end(), [&](const dgg::StoredPiece& piece) {
    const dgg::GraphInfo& info = piece.Rows.Info;
    return info.Surface == signature && info.Construction == first.Construction &&
      info.Accuracy == first.Accuracy && info.NumberOfNeighbors == first.NumberOfNeighbors;
  });
  if (!fits)
  {
    return dgg::Status::Success();
  }
  vtkPolyData* whole = this->Ports[0].Joined.GetWhole();
  DGGSurfaceArrays copies;
  return dgg::JoinPieceGraphs(pieces, copies.ConvertIds(whole->GetPointData()->GetGlobalIds()),
    whole->GetNumberOfPoints(), this->JoinedGraph);
}

//------------------------------------------------------------------------------
void DGGPartedUpdate::AddGraph(const DGGContext& context)
{
  bool isSame = !this->JoinedGraph.Offsets.IsEmpty(); // no points of the surface are merged
  for (vtkIdType point = 0; point < context.Input->GetNumberOfPoints() && isSame; ++point)
  {
    isSame = context.Surface.GetVertex(point) == point;
  }
  if (isSame)
  {
    this->JoinedGraph.Info.Surface = context.Surface.GetSignature();
    this->Graph.Adopt(this->JoinedGraph, context);
  }
  this->JoinedGraph = dgg::GeodesicGraph();
  if (this->Graph.IsValid())
  {
    this->Graph.AddTo(context.Input->GetFieldData());
  }
}

//------------------------------------------------------------------------------
/// Checks memory before messages are sent, since a failure during a message cannot be handled.
/// Parts take twice their size on both sides: in the message, and when they are serialized or read.
dgg::Status DGGPartedUpdate::CheckMemory(
  const DGGProcesses& processes, vtkTypeUInt64 limit, const std::vector<int>& isSame) const
{
  vtkIdType here = 0; // KiB
  for (std::size_t p = 0; p < this->Ports.size(); ++p)
  {
    for (const DGGSurfacePart& part : this->Ports[p].Parts)
    {
      here += isSame[p] ? 0 : static_cast<vtkIdType>(part.Data->GetActualMemorySize());
    }
  }
  const vtkIdType others = processes.Sum(here) - here;
  const double bytes = 2.0 * 1024.0 * static_cast<double>(processes.IsFirst() ? others : here);
  return processes.Agree(bytes > 0.0
      ? dgg::MakeBudget(limit).Check("Gathering the pieces of all processes", bytes,
          "Use a smaller surface or a machine with more memory")
      : dgg::Status::Success());
}

//------------------------------------------------------------------------------
/// Runs the step and computes the results of all parts. Only called on the first process.
dgg::Status DGGPartedUpdate::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
  bool passesSurface, const Step& step)
{
  std::vector<vtkSmartPointer<vtkInformationVector>> wholes;
  std::vector<vtkInformationVector*> pointers;
  for (std::size_t p = 0; p < this->Ports.size(); ++p)
  {
    const Port& port = this->Ports[p];
    vtkDataObject* input = GetData(inputs[p]);
    wholes.push_back(vtkSmartPointer<vtkInformationVector>::New());
    pointers.push_back(wholes.back());
    if (input || std::accumulate(port.Counts.begin(), port.Counts.end(), std::size_t(0)) > 0)
    {
      vtkPolyData* whole = port.Joined.GetWhole();
      whole->GetFieldData()->Initialize();
      if (input)
      {
        whole->GetFieldData()->PassData(input->GetFieldData());
      }
      Add(wholes.back(), whole);
    }
  }
  vtkNew<vtkInformationVector> results;
  this->Outputs.clear();
  this->Results.clear();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    this->Outputs.push_back(passesSurface && port == 0
        ? vtkSmartPointer<vtkDataObject>(vtkSmartPointer<vtkPolyData>::New())
        : vtkSmartPointer<vtkDataObject>::Take(
            vtkDataObject::GetData(outputs, port)->NewInstance()));
    Add(results, this->Outputs.back());
  }
  DGG_RETURN_IF_ERROR(step(pointers.data(), results));
  if (passesSurface)
  {
    const Port& surface = this->Ports[0];
    const std::size_t count =
      std::accumulate(surface.Counts.begin(), surface.Counts.end(), std::size_t(0));
    for (std::size_t part = 0; part < count; ++part)
    {
      this->Results.push_back(
        surface.Joined.MakeResult(vtkPolyData::SafeDownCast(this->Outputs[0]), part));
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Copies the input of this process to the output and adds the results of its parts.
void DGGPartedUpdate::Deliver(vtkDataObject* input, vtkDataObject* output, bool removesGraph)
{
  output->Initialize();
  if (!input)
  {
    return;
  }
  const std::vector<DGGSurfacePart>& parts = this->Ports[0].Parts;
  const auto fill = [&](vtkDataObject* leaf, std::size_t part) {
    leaf->ShallowCopy(parts[part].Data);
    DGGJoinedParts::AddResult(this->Results[part], vtkPolyData::SafeDownCast(leaf));
  };
  auto* tree = vtkCompositeDataSet::SafeDownCast(input);
  if (tree)
  {
    auto* copy = vtkCompositeDataSet::SafeDownCast(output);
    copy->CopyStructure(tree);
    const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
    std::size_t part = 0;
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      vtkDataObject* data = leaf->GetCurrentDataObject();
      const auto filled = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
      if (vtkPolyData::SafeDownCast(data))
      {
        fill(filled, part++);
      }
      else
      {
        filled->ShallowCopy(data);
      }
      copy->SetDataSet(leaf, filled);
    }
  }
  else
  {
    fill(output, 0);
  }
  // Field data belong to the entire surface, for example a graph.
  vtkDataObject* whole = this->Outputs.empty() ? input : this->Outputs[0].Get();
  output->GetFieldData()->Initialize();
  output->GetFieldData()->PassData(whole->GetFieldData());
  if (this->Graph.IsIn(output->GetFieldData()))
  {
    DGGGraphArrays::Pass(input->GetFieldData(), output->GetFieldData()); // that of the piece
  }
  else if (removesGraph)
  {
    DGGGraphArrays::RemoveFrom(output->GetFieldData());
  }
}
