// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages over MPI by DIY, and their registration.
#include "DGGDistributor.h"
#include "vtkDGGFiltersParallelModule.h"

#include "vtkDIYUtilities.h"
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
