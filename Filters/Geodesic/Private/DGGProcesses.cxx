// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGProcesses.h"

#include "DGGDistributor.h"

#include "dggProcessGroup.h"
#include "dggStatus.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <string>

namespace
{
constexpr int First = 0;
constexpr int PartTag = 5811;
constexpr int ArrayTag = 5812;

void SendArrays(vtkMultiProcessController* controller, const DGGChangedArrays& arrays, int to)
{
  vtkMultiProcessStream stream;
  stream << static_cast<int>(arrays.Removed.size()) << static_cast<int>(arrays.Added.size());
  for (const std::string& name : arrays.Removed)
  {
    stream << name;
  }
  for (const std::string& name : arrays.Active)
  {
    stream << name;
  }
  for (vtkAbstractArray* array : arrays.Added)
  {
    // VTK's messages of arrays do not include these properties.
    const char* arrayName = array->GetName();
    stream << array->GetDataType() << std::string(arrayName ? arrayName : "")
           << array->GetNumberOfComponents();
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      const char* name = array->GetComponentName(k);
      stream << std::string(name ? name : "");
    }
    if (auto* words = vtkStringArray::SafeDownCast(array)) // VTK has no messages for string arrays
    {
      stream << static_cast<vtkTypeInt64>(words->GetNumberOfValues());
      for (vtkIdType i = 0; i < words->GetNumberOfValues(); ++i)
      {
        stream << std::string(words->GetValue(i));
      }
    }
  }
  controller->Send(stream, to, ArrayTag);
  for (vtkAbstractArray* array : arrays.Added)
  {
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      controller->Send(numbers, to, ArrayTag);
    }
  }
}

DGGChangedArrays ReceiveArrays(vtkMultiProcessController* controller, int from)
{
  DGGChangedArrays arrays;
  vtkMultiProcessStream stream;
  controller->Receive(stream, from, ArrayTag);
  int removed = 0;
  int added = 0;
  stream >> removed >> added;
  arrays.Removed.resize(static_cast<std::size_t>(removed));
  for (std::string& name : arrays.Removed)
  {
    stream >> name;
  }
  for (std::string& name : arrays.Active)
  {
    stream >> name;
  }
  for (int i = 0; i < added; ++i)
  {
    int type = 0;
    int components = 0;
    std::string name;
    stream >> type >> name >> components;
    const auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      controller->Receive(numbers, from, ArrayTag);
    }
    array->SetName(name.empty() ? nullptr : name.c_str());
    array->SetNumberOfComponents(components);
    for (int k = 0; k < components; ++k)
    {
      stream >> name;
      if (!name.empty())
      {
        array->SetComponentName(k, name.c_str());
      }
    }
    if (auto* words = vtkStringArray::SafeDownCast(array))
    {
      vtkTypeInt64 size = 0;
      stream >> size;
      for (vtkTypeInt64 j = 0; j < size; ++j)
      {
        stream >> name;
        words->InsertNextValue(name);
      }
    }
    arrays.Added.push_back(array);
  }
  return arrays;
}

/// Moves arrays of ids out of data. VTK's messages of data sets truncate ids to 32 bits, so these
/// arrays are sent separately.
DGGChangedArrays TakeIds(vtkDataSetAttributes* data)
{
  DGGChangedArrays ids;
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = data->GetAbstractAttribute(type);
    ids.Active[type] = active && active->GetName() ? active->GetName() : "";
  }
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetDataType() == VTK_ID_TYPE)
    {
      ids.Added.emplace_back(array);
      data->RemoveArray(i);
    }
  }
  return ids;
}

void SendPart(vtkMultiProcessController* controller, vtkPolyData* part)
{
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(part);
  bare->GetFieldData()->Initialize();
  const DGGPartResult ids{ TakeIds(bare->GetPointData()), TakeIds(bare->GetCellData()) };
  controller->Send(bare, First, PartTag);
  SendArrays(controller, ids.Points, First);
  SendArrays(controller, ids.Cells, First);
}

void ReceivePart(vtkMultiProcessController* controller, vtkPolyData* part, int from)
{
  controller->Receive(part, from, PartTag);
  DGGPartResult ids;
  ids.Points = ReceiveArrays(controller, from);
  ids.Cells = ReceiveArrays(controller, from);
  DGGJoinedParts::AddResult(ids, part);
}
}

//------------------------------------------------------------------------------
bool DGGProcesses::IsFirst() const
{
  return !this->Controller || this->Controller->GetLocalProcessId() == First;
}

//------------------------------------------------------------------------------
dgg::Status DGGProcesses::Agree(const dgg::Status& status) const
{
  if (!this->Controller)
  {
    return status;
  }
  const int count = this->Controller->GetNumberOfProcesses();
  const int mine = status.IsOk() ? count : this->Controller->GetLocalProcessId();
  int failed = count;
  this->Controller->AllReduce(&mine, &failed, 1, vtkCommunicator::MIN_OP);
  if (failed == count)
  {
    return dgg::Status::Success();
  }
  int code = static_cast<int>(status.GetCode());
  std::string problem = status.GetProblem();
  std::string action = status.GetAction();
  std::string parameter = status.GetParameter();
  auto index = static_cast<vtkTypeInt64>(status.GetIndex());
  vtkMultiProcessStream stream;
  stream << code << problem << action << parameter << index;
  this->Controller->Broadcast(stream, failed);
  stream >> code >> problem >> action >> parameter >> index;
  return dgg::Status(static_cast<dgg::Status::Code>(code), problem)
    .Fix(action)
    .At(parameter, index);
}

//------------------------------------------------------------------------------
vtkIdType DGGProcesses::Sum(vtkIdType number) const
{
  vtkIdType sum = number;
  if (this->Controller)
  {
    this->Controller->AllReduce(&number, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<int> DGGProcesses::AndAll(const std::vector<int>& holds) const
{
  std::vector<int> everywhere = holds;
  if (this->Controller)
  {
    this->Controller->AllReduce(holds.data(), everywhere.data(),
      static_cast<vtkIdType>(holds.size()), vtkCommunicator::MIN_OP);
  }
  return everywhere;
}

//------------------------------------------------------------------------------
dgg::Status DGGProcesses::Gather(
  std::vector<DGGSurfacePart>& parts, std::vector<std::size_t>& counts) const
{
  counts.assign(1, parts.size());
  if (!this->IsFirst())
  {
    vtkMultiProcessStream stream;
    stream << static_cast<int>(parts.size());
    for (const DGGSurfacePart& part : parts)
    {
      stream << part.Block << static_cast<vtkTypeInt64>(part.Data->GetNumberOfPoints())
             << static_cast<vtkTypeInt64>(part.Data->GetNumberOfCells());
    }
    this->Controller->Send(stream, First, PartTag);
    for (const DGGSurfacePart& part : parts)
    {
      if (!DGGIsEmpty(part.Data))
      {
        SendPart(this->Controller, part.Data);
      }
    }
    return dgg::Status::Success();
  }
  dgg::Status status;
  const int processes = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
  for (int process = 1; process < processes; ++process)
  {
    vtkMultiProcessStream stream;
    this->Controller->Receive(stream, process, PartTag);
    int count = 0;
    stream >> count;
    for (int i = 0; i < count; ++i)
    {
      DGGSurfacePart part{ vtkSmartPointer<vtkPolyData>::New(), 0 };
      vtkTypeInt64 points = 0;
      vtkTypeInt64 cells = 0;
      stream >> part.Block >> points >> cells;
      if (points > 0 || cells > 0)
      {
        ReceivePart(this->Controller, part.Data, process);
      }
      if (part.Data->GetNumberOfPoints() != points || part.Data->GetNumberOfCells() != cells)
      {
        status = dgg::InvalidInput("Process ", process, " has sent ", points, " points and ", cells,
          " cells, but ", part.Data->GetNumberOfPoints(), " and ", part.Data->GetNumberOfCells(),
          " have arrived")
                   .Fix("Repair the piece, or use a smaller piece");
      }
      parts.push_back(part);
    }
    counts.push_back(static_cast<std::size_t>(count));
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status DGGProcesses::JoinOnFirst(
  dgg::ProcessGroup& group, vtkDataObject* here, vtkSmartPointer<vtkPolyData>& joined) const
{
  vtkIdType others = 0;
  std::vector<DGGSurfacePart> parts = DGGFindParts(here, others);
  for (DGGSurfacePart& part : parts)
  {
    DGG_RETURN_IF_ERROR(DGGRemoveGhosts(part.Data));
  }
  DGG_RETURN_IF_ERROR(group.Agree(dgg::Status::Success()));
  std::vector<std::size_t> counts;
  DGG_RETURN_IF_ERROR(this->Gather(parts, counts));
  if (this->IsFirst())
  {
    DGGJoinedParts whole;
    DGG_RETURN_IF_ERROR(whole.Join(parts));
    joined = whole.GetWhole();
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGProcesses::Scatter(
  const std::vector<std::size_t>& counts, std::vector<DGGPartResult>& results) const
{
  if (!this->IsFirst())
  {
    results.resize(counts[0]);
    for (DGGPartResult& result : results)
    {
      result.Points = ReceiveArrays(this->Controller, First);
      result.Cells = ReceiveArrays(this->Controller, First);
    }
    return;
  }
  std::size_t next = counts[0];
  for (std::size_t process = 1; process < counts.size(); ++process)
  {
    for (std::size_t i = 0; i < counts[process]; ++i, ++next)
    {
      SendArrays(this->Controller, results[next].Points, static_cast<int>(process));
      SendArrays(this->Controller, results[next].Cells, static_cast<int>(process));
    }
  }
  results.resize(counts[0]);
}

//------------------------------------------------------------------------------
bool DGGProcesses::FindGroup(bool canJoin, dgg::ProcessGroup& group) const
{
  group.FindFailure = [*this](const dgg::Status& status) { return this->Agree(status); };
  const DGGDistributor* distributor = DGGDistributor::Get();
  const bool isSupported =
    distributor && this->Controller && distributor->Supports(this->Controller);
  if (this->AndAll({ canJoin && isSupported ? 1 : 0 })[0] == 0 || !isSupported)
  {
    return false;
  }
  group.Here = this->Controller->GetLocalProcessId();
  group.Count = this->Controller->GetNumberOfProcesses();
  group.Transfer = [distributor, controller = this->Controller](
                     std::vector<dgg::Message>& sent, std::vector<dgg::Message>& received) {
    distributor->Transfer(controller, sent, received);
  };
  group.ShareMemory = [distributor, controller = this->Controller](
                        std::vector<dgg::SharedBlock>& blocks, dgg::SharedCopies& copies) {
    return distributor->ShareMemory(controller, blocks, copies);
  };
  return true;
}

//------------------------------------------------------------------------------
std::vector<DGGArrayList> DGGProcesses::GatherArrays(const DGGArrayList& arrays) const
{
  std::vector<DGGArrayList> all{ arrays };
  if (!this->IsFirst())
  {
    DGGChangedArrays sent;
    sent.Added = arrays;
    SendArrays(this->Controller, sent, First);
    return all;
  }
  const int processes = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
  for (int process = 1; process < processes; ++process)
  {
    all.push_back(ReceiveArrays(this->Controller, process).Added);
  }
  return all;
}
