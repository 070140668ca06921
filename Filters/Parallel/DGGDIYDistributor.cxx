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

#include <memory>

namespace
{
using Messages = std::vector<dgg::Message>;

class DIYDistributor : public DGGDistributor
{
public:
  bool Supports(vtkMultiProcessController* controller) const override
  {
    return vtkMPIController::SafeDownCast(controller) != nullptr;
  }

  void Exchange(vtkMultiProcessController* controller, Messages& messages) const override
  {
    // The communicator must not outlive MPI, so it is not kept.
    diy::mpi::communicator communicator = vtkDIYUtilities::GetCommunicator(controller);
    diy::Master master(communicator, 1);
    auto link = std::make_unique<diy::Link>();
    for (int process = 0; process < communicator.size(); ++process)
    {
      link->add_neighbor({ process, process }); // one block per process
    }
    master.add(communicator.rank(), &messages, link.release());
    master.foreach ([](Messages* sent, const diy::Master::ProxyWithLink& proxy) {
      for (int process = 0; process < proxy.link()->size(); ++process)
      {
        proxy.enqueue(proxy.link()->target(process), (*sent)[process]);
      }
    });
    master.exchange();
    master.foreach ([](Messages* received, const diy::Master::ProxyWithLink& proxy) {
      for (int process = 0; process < proxy.link()->size(); ++process)
      {
        proxy.dequeue(process, (*received)[process]);
      }
    });
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
