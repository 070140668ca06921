// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGProcesses.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"

#include <string>

namespace
{
constexpr int First = 0;
constexpr int PartTag = 5811;
constexpr int ResultTag = 5812;

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
  for (vtkDataArray* array : arrays.Added)
  {
    // What VTK's messages of arrays leave out.
    stream << array->GetDataType() << std::string(array->GetName())
           << array->GetNumberOfComponents();
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      const char* name = array->GetComponentName(k);
      stream << std::string(name ? name : "");
    }
  }
  controller->Send(stream, to, ResultTag);
  for (vtkDataArray* array : arrays.Added)
  {
    controller->Send(array, to, ResultTag);
  }
}

DGGChangedArrays ReceiveArrays(vtkMultiProcessController* controller)
{
  DGGChangedArrays arrays;
  vtkMultiProcessStream stream;
  controller->Receive(stream, First, ResultTag);
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
    const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    controller->Receive(array, First, ResultTag);
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    for (int k = 0; k < components; ++k)
    {
      stream >> name;
      if (!name.empty())
      {
        array->SetComponentName(k, name.c_str());
      }
    }
    arrays.Added.push_back(array);
  }
  return arrays;
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
  int isAborted = status.IsAborted() ? 1 : 0;
  std::string message = status.GetMessage();
  vtkMultiProcessStream stream;
  stream << isAborted << message;
  this->Controller->Broadcast(stream, failed);
  stream >> isAborted >> message;
  return isAborted ? dgg::Status::Abort() : dgg::Status::Invalid(message);
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
std::vector<std::size_t> DGGProcesses::Gather(std::vector<DGGSurfacePart>& parts) const
{
  std::vector<std::size_t> counts(1, parts.size());
  if (!this->IsFirst())
  {
    vtkMultiProcessStream stream;
    stream << static_cast<int>(parts.size());
    for (const DGGSurfacePart& part : parts)
    {
      stream << part.Block << (DGGIsEmpty(part.Data) ? 1 : 0);
    }
    this->Controller->Send(stream, First, PartTag);
    for (const DGGSurfacePart& part : parts)
    {
      if (!DGGIsEmpty(part.Data))
      {
        vtkNew<vtkPolyData> bare;
        bare->ShallowCopy(part.Data);
        bare->GetFieldData()->Initialize();
        this->Controller->Send(bare, First, PartTag);
      }
    }
    return counts;
  }
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
      int isEmpty = 0;
      stream >> part.Block >> isEmpty;
      if (!isEmpty)
      {
        this->Controller->Receive(part.Data, process, PartTag);
      }
      parts.push_back(part);
    }
    counts.push_back(static_cast<std::size_t>(count));
  }
  return counts;
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
      result.Points = ReceiveArrays(this->Controller);
      result.Cells = ReceiveArrays(this->Controller);
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
