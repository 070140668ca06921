// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphArrays.h"

#include "DGGArrayView.h"
#include "DGGMakeArray.h"

#include "dggPieceGraph.h"
#include "dggPreparedSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <utility>

using dgg::StoredGraph;

//------------------------------------------------------------------------------
bool DGGGraphArrays::Entry::operator==(const Entry& other) const
{
  return this->Array == other.Array && this->Time == other.Time && this->Data == other.Data &&
    this->Size == other.Size;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Entry DGGGraphArrays::MakeEntry(vtkAbstractArray* array)
{
  Entry entry;
  if (array)
  {
    entry.Array = array;
    entry.Time = array->GetMTime();
    entry.Data = array->HasStandardMemoryLayout() ? array->GetVoidPointer(0) : nullptr;
    entry.Size = array->GetNumberOfValues();
  }
  return entry;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Entries DGGGraphArrays::MakeEntries(vtkFieldData* data)
{
  Entries entries;
  for (int role = 0; data && role < StoredGraph::NumberOfRoles; ++role)
  {
    entries[role] = MakeEntry(data->GetAbstractArray(StoredGraph::GetName(role)));
  }
  return entries;
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Clear()
{
  *this = DGGGraphArrays();
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Adopt(dgg::GeodesicGraph& graph, const dgg::TaskContext& context)
{
  this->Adopt(graph, {}, 0.0, context);
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Adopt(dgg::GeodesicGraph& graph, const std::vector<double>& radii,
  double voxelSize, const dgg::TaskContext& context)
{
  this->Clear();
  dgg::Buffer<double> ownRadii(radii.size());
  std::copy(radii.begin(), radii.end(), ownRadii.begin());
  // The arrays take over the memory that the view refers to.
  this->Graph = StoredGraph(graph.View(), dgg::CloudBand{ voxelSize, ownRadii.Data() });
  dgg::PieceGraph rows;
  rows.Rows = std::move(graph);
  this->AdoptArrays(rows, ownRadii, context);
  graph = dgg::GeodesicGraph();
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Adopt(dgg::PieceGraph& graph, const dgg::TaskContext& context)
{
  this->Clear();
  const dgg::GhostVertices ghosts{ graph.GhostIds.Data(),
    static_cast<dgg::Id>(graph.GhostIds.Size()), graph.Owners.Data() };
  this->Graph = StoredGraph(graph.Rows.View(), ghosts, graph.Piece);
  dgg::Buffer<double> noRadii;
  this->AdoptArrays(graph, noRadii, context);
}

//------------------------------------------------------------------------------
/// Creates arrays from the memory that the stored graph refers to.
void DGGGraphArrays::AdoptArrays(
  dgg::PieceGraph& piece, dgg::Buffer<double>& radii, const dgg::TaskContext& context)
{
  dgg::GeodesicGraph& graph = piece.Rows;
  dgg::Buffer<std::int64_t> info = this->Graph.MakeInfo(context.Surface, context.Parallel);

  const auto name = &StoredGraph::GetName;
  vtkSmartPointer<vtkAbstractArray> lengths =
    DGGAdoptArray<vtkFloatArray>(graph.Lengths, name(StoredGraph::Lengths));
  if (this->GetView().WideLengths)
  {
    lengths = DGGAdoptArray<vtkDoubleArray>(graph.WideLengths, name(StoredGraph::Lengths));
  }
  const std::array<vtkSmartPointer<vtkAbstractArray>, StoredGraph::NumberOfRoles> arrays = { {
    DGGAdoptArray<vtkTypeInt64Array>(graph.Offsets, name(StoredGraph::Offsets)),
    DGGAdoptArray<vtkTypeInt32Array>(graph.Targets, name(StoredGraph::Targets)),
    lengths,
    DGGAdoptArray<vtkFloatArray>(graph.Angles, name(StoredGraph::Angles)),
    DGGAdoptArray<vtkFloatArray>(graph.ArrivalAngles, name(StoredGraph::ArrivalAngles)),
    DGGAdoptArray<vtkDoubleArray>(radii, name(StoredGraph::Radii)),
    DGGAdoptArray<vtkTypeInt64Array>(piece.GhostIds, name(StoredGraph::GhostIds)),
    DGGAdoptArray<vtkTypeInt32Array>(piece.Owners, name(StoredGraph::Owners)),
    DGGAdoptArray<vtkTypeInt64Array>(info, name(StoredGraph::Info)),
  } };
  for (int role = 0; role < StoredGraph::NumberOfRoles; ++role)
  {
    if (this->Graph.HasRole(role))
    {
      this->Arrays[role] = MakeEntry(arrays[role]);
    }
  }
  this->Mesh = context.Surface.GetBuildNumber();
  this->IsGraph = true;
  this->Time.Modified();
}

//------------------------------------------------------------------------------
void DGGGraphArrays::AddTo(vtkFieldData* data) const
{
  RemoveFrom(data); // the graph of a cloud has further arrays
  for (const Entry& entry : this->Arrays)
  {
    if (entry.Array)
    {
      data->AddArray(entry.Array);
    }
  }
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::AreOfCloud(vtkFieldData* data)
{
  return data &&
    StoredGraph::IsOfCloud(
      DGGViewArray(data->GetAbstractArray(StoredGraph::GetName(StoredGraph::Info))));
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::AreOfPiece(vtkFieldData* data)
{
  return data &&
    StoredGraph::IsOfPiece(
      DGGViewArray(data->GetAbstractArray(StoredGraph::GetName(StoredGraph::Info))));
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::AreOfEntireSurface(vtkFieldData* data)
{
  return data && data->HasArray(StoredGraph::GetName(StoredGraph::Info)) && !AreOfPiece(data);
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Pass(vtkFieldData* from, vtkFieldData* to)
{
  RemoveFrom(to);
  for (int role = 0; role < StoredGraph::NumberOfRoles; ++role)
  {
    if (vtkAbstractArray* array = from->GetAbstractArray(StoredGraph::GetName(role)))
    {
      to->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
void DGGGraphArrays::RemoveFrom(vtkFieldData* data)
{
  for (int role = 0; role < StoredGraph::NumberOfRoles; ++role)
  {
    data->RemoveArray(StoredGraph::GetName(role));
  }
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::IsValid() const
{
  bool valid = this->IsGraph;
  for (const Entry& entry : this->Arrays)
  {
    valid = valid && MakeEntry(entry.Array) == entry;
  }
  return valid;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Key DGGGraphArrays::GetKey() const
{
  Key key;
  for (const Entry& entry : this->Arrays)
  {
    key.push_back(reinterpret_cast<std::uintptr_t>(entry.Array.Get()));
    key.push_back(static_cast<std::uintptr_t>(entry.Time));
    key.push_back(reinterpret_cast<std::uintptr_t>(entry.Data));
    key.push_back(static_cast<std::uintptr_t>(entry.Size));
  }
  return key;
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::Find(
  vtkFieldData* data, const dgg::TaskContext& context, std::string& complaint)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  complaint.clear();
  if (this->IsSame(data, mesh))
  {
    return this->IsGraph;
  }
  this->Clear();
  this->Arrays = MakeEntries(data);
  if (this->Arrays != Entries())
  {
    const dgg::Status status = this->Graph.Read(ViewArrays(this->Arrays), mesh, context.Parallel);
    this->IsGraph = status.IsOk();
    this->Time.Modified();
    complaint = status.GetProblem();
  }
  this->Mesh = mesh.GetBuildNumber(); // last, so that an exception leaves the arrays unchecked
  return this->IsGraph;
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::FindPiece(vtkFieldData* data, vtkIdType numberOfPoints,
  const dgg::ParallelFor& parallel, std::string& complaint)
{
  complaint.clear();
  const Entries entries = MakeEntries(data);
  if (entries == this->Arrays)
  {
    return this->IsGraph;
  }
  this->Clear();
  if (entries != Entries())
  {
    const dgg::Status status = this->Graph.ReadPiece(ViewArrays(entries), numberOfPoints, parallel);
    this->IsGraph = status.IsOk();
    this->Time.Modified();
    complaint = status.GetProblem();
  }
  this->Arrays = entries; // last, so that an exception leaves the arrays unchecked
  return this->IsGraph;
}

//------------------------------------------------------------------------------
StoredGraph::Arrays DGGGraphArrays::ViewArrays(const Entries& entries)
{
  StoredGraph::Arrays arrays;
  for (int role = 0; role < StoredGraph::NumberOfRoles; ++role)
  {
    arrays[role] = DGGViewArray(entries[role].Array);
  }
  return arrays;
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::IsSame(vtkFieldData* data, const dgg::PreparedSurface& mesh) const
{
  return this->Mesh == mesh.GetBuildNumber() && this->Arrays == MakeEntries(data);
}
