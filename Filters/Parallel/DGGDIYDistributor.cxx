// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages over MPI by DIY, shared memory of machines, and the registration of both.
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
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>

#ifndef _WIN32
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

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

/// Name of shared memory. macOS limits its length.
using MemoryName = std::array<char, 32>;

#ifdef _WIN32
void* MapMemory(MemoryName&, std::size_t, bool)
{
  return nullptr;
}
void Unlink(const MemoryName&) {}
void Unmap(void*, std::size_t) {}
#else
/// Creates memory of a machine, which other processes can then map by its name, or maps existing
/// memory for reading. Returns null if this is impossible.
void* MapMemory(MemoryName& name, std::size_t size, bool isCreator)
{
  if (isCreator)
  {
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    std::snprintf(name.data(), name.size(), "/dgg-%x-%llx", static_cast<unsigned int>(getpid()),
      static_cast<unsigned long long>(now));
  }
  const int file = shm_open(name.data(), isCreator ? O_RDWR | O_CREAT | O_EXCL : O_RDONLY, 0600);
  if (file < 0)
  {
    return nullptr;
  }
  const auto end = static_cast<off_t>(size);
  int error = 0;
#ifdef __APPLE__
  error = isCreator ? ftruncate(file, end) : 0;
#else
  do
  {
    error = isCreator ? posix_fallocate(file, 0, end) : 0; // reserves pages: writes cannot fail
  } while (error == EINTR);
#endif
  void* const data = error == 0
    ? mmap(nullptr, size, isCreator ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, file, 0)
    : MAP_FAILED;
  close(file);
  return data != MAP_FAILED ? data : nullptr;
}
void Unlink(const MemoryName& name)
{
  shm_unlink(name.data());
}
void Unmap(void* data, std::size_t size)
{
  munmap(data, size);
}
#endif

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

  bool ShareMemory(vtkMultiProcessController* controller, std::vector<dgg::SharedBlock>& blocks,
    dgg::SharedCopies& copies) const noexcept override
  {
    std::size_t size = 0;
    for (const dgg::SharedBlock& block : blocks)
    {
      size += Align(block.Size);
    }
    const MPI_Comm all =
      *vtkMPICommunicator::SafeDownCast(controller->GetCommunicator())->GetMPIComm()->GetHandle();
    const int here = controller->GetLocalProcessId();
    const bool isFirst = here == 0; // reads the original arrays
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(
      all, isFirst ? MPI_UNDEFINED : MPI_COMM_TYPE_SHARED, here, MPI_INFO_NULL, &machine);
    MemoryName name{};
    int rank = 0; // on the machine
    if (!isFirst)
    {
      MPI_Comm_rank(machine, &rank);
      void* const created = rank == 0 ? MapMemory(name, size, true) : nullptr;
      MPI_Bcast(name.data(), static_cast<int>(name.size()), MPI_CHAR, 0, machine);
      copies = dgg::SharedCopies(
        rank == 0 ? created : MapMemory(name, size, false), dgg::CopyRelease{ size, Unmap });
    }
    int isShared = isFirst || copies ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &isShared, 1, MPI_INT, MPI_MIN, all);
    if (!isFirst && rank == 0)
    {
      Unlink(name); // all processes have mapped the memory, and nothing remains after a crash
    }
    if (isShared == 1)
    {
      this->Copy(all, machine, isFirst || rank == 0, static_cast<char*>(copies.get()), blocks);
    }
    if (!isFirst)
    {
      MPI_Comm_free(&machine);
    }
    return isShared == 1;
  }

private:
  /// Copies blocks from the first process to the memory of each machine. One process of each
  /// machine `receives` them; the first process sends them and has no machine.
  void Copy(MPI_Comm all, MPI_Comm machine, bool receives, char* memory,
    std::vector<dgg::SharedBlock>& blocks) const
  {
    const bool isFirst = machine == MPI_COMM_NULL;
    MPI_Comm receivers = MPI_COMM_NULL; // one per machine, and the first process
    MPI_Comm_split(all, receives ? 0 : MPI_UNDEFINED, isFirst ? 0 : 1, &receivers);
    for (dgg::SharedBlock& block : blocks)
    {
      char* const data = isFirst ? static_cast<char*>(const_cast<void*>(block.Data)) : memory;
      for (std::size_t begin = 0; begin < block.Size && receives; begin += LongestMessage)
      {
        const std::size_t count = std::min(LongestMessage, block.Size - begin);
        MPI_Bcast(data + begin, static_cast<int>(count), MPI_BYTE, 0, receivers);
      }
      block.Data = data;
      memory += isFirst ? 0 : Align(block.Size);
    }
    if (receives)
    {
      MPI_Comm_free(&receivers);
    }
    if (!isFirst)
    {
      MPI_Barrier(machine); // the copies are complete
    }
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
