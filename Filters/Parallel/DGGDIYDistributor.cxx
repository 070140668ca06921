// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages over MPI by DIY, memory that MPI shares, and the registration of both.
#include "DGGDistributor.h"
#include "vtkDGGFiltersParallelModule.h"

#include "vtkDIYUtilities.h"
#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"

// clang-format off
#include "vtk_diy2.h" // defines the macro
#include VTK_DIY2(diy/master.hpp)
#include VTK_DIY2(diy/mpi.hpp)
// clang-format on

#include <algorithm>
#include <cstddef>
#include <memory>

namespace
{
using Messages = std::vector<dgg::Message>;
using diy::detail::VectorWindow;

constexpr int Tag = 5813; // differs from the tags of other messages of the controller
/// Bytes of the longest message of MPI, which counts them with an int.
constexpr std::size_t LongestMessage = std::size_t{ 1 } << 30;

/// Returns the part of a message that begins at a byte.
VectorWindow<char> GetWindow(dgg::Message& message, std::size_t begin)
{
  const std::size_t first = std::min(begin, message.size());
  return { message.data() + first, std::min(LongestMessage, message.size() - first) };
}

/// Returns a size in bytes, rounded up to cache lines.
std::size_t Align(std::size_t size)
{
  constexpr std::size_t line = 64;
  return (size + line - 1) / line * line;
}

/// Memory of a machine. It is released when all processes that share it have released it.
struct MachineMemory
{
  MachineMemory() = default;
  ~MachineMemory()
  {
    if (this->Window != MPI_WIN_NULL)
    {
      MPI_Win_free(&this->Window);
    }
  }
  MachineMemory(const MachineMemory&) = delete;
  void operator=(const MachineMemory&) = delete;

  MPI_Win Window = MPI_WIN_NULL;
  char* Data = nullptr;
};

class DIYDistributor : public DGGDistributor
{
public:
  bool Supports(vtkMultiProcessController* controller) const override
  {
    return vtkMPIController::SafeDownCast(controller) != nullptr;
  }

  void Transfer(
    vtkMultiProcessController* controller, Messages& sent, Messages& received) const override
  {
    // DIY's Master would store copies of all messages, and duplicate the communicator.
    const diy::mpi::communicator communicator = vtkDIYUtilities::GetCommunicator(controller);
    const int count = communicator.size();
    for (int step = 0; step < count; ++step)
    {
      const int to = (communicator.rank() + step) % count;
      const int from = (communicator.rank() + count - step) % count;
      dgg::Message& out = sent[to];
      dgg::Message& in = received[from];
      for (std::size_t begin = 0; begin < std::max(out.size(), in.size()); begin += LongestMessage)
      {
        VectorWindow<char> taken = GetWindow(out, begin);
        VectorWindow<char> filled = GetWindow(in, begin);
        diy::mpi::request request;
        if (taken.count > 0)
        {
          request = communicator.isend(to, Tag, taken);
        }
        if (filled.count > 0)
        {
          communicator.recv(from, Tag, filled);
        }
        if (taken.count > 0)
        {
          request.wait();
        }
      }
    }
  }

  std::shared_ptr<const void> ShareMemory(
    vtkMultiProcessController* controller, std::vector<dgg::SharedBlock>& blocks) const override
  {
    std::size_t size = 0;
    for (const dgg::SharedBlock& block : blocks)
    {
      size += Align(block.Size);
    }
    const auto memory = std::make_shared<MachineMemory>();
    const MPI_Comm all =
      *vtkMPICommunicator::SafeDownCast(controller->GetCommunicator())->GetMPIComm()->GetHandle();
    const int here = controller->GetLocalProcessId();
    const bool isFirst = here == 0; // reads the original arrays
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(
      all, isFirst ? MPI_UNDEFINED : MPI_COMM_TYPE_SHARED, here, MPI_INFO_NULL, &machine);
    int rank = 0; // on the machine
    int isShared = 1;
    if (!isFirst)
    {
      MPI_Comm_rank(machine, &rank);
      MPI_Comm_set_errhandler(machine, MPI_ERRORS_RETURN);
      auto bytes = static_cast<MPI_Aint>(rank == 0 ? size : 0);
      int unit = 1;
      if (MPI_Win_allocate_shared(
            bytes, unit, MPI_INFO_NULL, machine, &memory->Data, &memory->Window) != MPI_SUCCESS)
      {
        memory->Window = MPI_WIN_NULL;
        isShared = 0;
      }
      else
      {
        MPI_Win_shared_query(memory->Window, 0, &bytes, &unit, &memory->Data);
      }
      MPI_Comm_free(&machine);
    }
    MPI_Allreduce(MPI_IN_PLACE, &isShared, 1, MPI_INT, MPI_MIN, all);
    if (isShared == 0)
    {
      return nullptr;
    }
    MPI_Comm receivers = MPI_COMM_NULL; // one per machine, and the first process
    MPI_Comm_split(all, rank == 0 ? 0 : MPI_UNDEFINED, here, &receivers);
    char* next = memory->Data;
    for (dgg::SharedBlock& block : blocks)
    {
      char* const data = isFirst ? static_cast<char*>(const_cast<void*>(block.Data)) : next;
      for (std::size_t begin = 0; begin < block.Size && rank == 0; begin += LongestMessage)
      {
        const std::size_t count = std::min(LongestMessage, block.Size - begin);
        MPI_Bcast(data + begin, static_cast<int>(count), MPI_BYTE, 0, receivers);
      }
      block.Data = data;
      next += isFirst ? 0 : Align(block.Size);
    }
    if (rank == 0)
    {
      MPI_Comm_free(&receivers);
    }
    if (!isFirst)
    {
      MPI_Win_fence(
        MPI_MODE_NOSUCCEED, memory->Window); // makes the copies visible to all processes
    }
    return memory;
  }
};
}

/// Registers the distributor. Called by vtk_module_autoinit().
VTKDGGFILTERSPARALLEL_EXPORT void vtkDGGFiltersParallel_AutoInit_Construct();
void vtkDGGFiltersParallel_AutoInit_Construct()
{
  if (!DGGDistributor::Get())
  {
    DGGDistributor::Register(std::make_unique<const DIYDistributor>());
  }
}
